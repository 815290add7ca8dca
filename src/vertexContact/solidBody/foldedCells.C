/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foldedCells.H"
#include "DynamicList.H"
#include "FixedList.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The points to which three edges of a cell lead from a corner of one of its
//  faces; false if there are more edges
bool neighbours
(
    const polyMesh& mesh,
    const cell& c,
    const face& f,
    const label corner,
    FixedList<label, 3>& to
)
{
    const label p = f[corner];
    to = FixedList<label, 3>{f.prevLabel(corner), f.nextLabel(corner), -1};
    for (const label facei : c)
    {
        const face& other = mesh.faces()[facei];
        const label at = other.find(p);
        if (at < 0) continue;
        for (const label q : {other.prevLabel(at), other.nextLabel(at)})
        {
            if (q == to[0] || q == to[1] || q == to[2]) continue;
            if (to[2] >= 0) return false;
            to[2] = q;
        }
    }
    return to[2] >= 0;
}

scalar volume
(
    const pointField& x,
    const label p,
    const FixedList<label, 3>& to
)
{
    return ((x[to[0]] - x[p]) ^ (x[to[1]] - x[p])) & (x[to[2]] - x[p]);
}

//- A point of a cell where it is folded, or -1
label foldOf(const polyMesh& mesh, const cell& c, const pointField& x)
{
    FixedList<label, 3> to;
    for (const label facei : c)
    {
        const face& f = mesh.faces()[facei];
        forAll(f, j)
        {
            if
            (
                neighbours(mesh, c, f, j, to)
             && volume(x, f[j], to)*volume(mesh.points(), f[j], to) < 0
            )
            {
                return f[j];
            }
        }
    }
    return -1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::labelList Foam::foldedCells(const polyMesh& mesh, const pointField& x)
{
    DynamicList<label> folds;
    for (const cell& c : mesh.cells())
    {
        const label p = foldOf(mesh, c, x);
        if (p >= 0) folds.append(p);
    }
    return labelList(folds);
}


// ************************************************************************* //
