/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "displacementFilter.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- All points of a patch have the same displacement
bool movesAsOne(const polyPatch& pp, const vectorField& displacement)
{
    scalar most = 0;
    for (const label p : pp.meshPoints())
    {
        most = max
        (
            most, mag(displacement[p] - displacement[pp.meshPoints()[0]])
        );
    }
    return most == 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::displacementFilter::holdSides
(
    tensorField& gradient,
    const vectorField& displacement,
    const polyMesh& mesh
)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp) || !movesAsOne(pp, displacement)) continue;
        forAll(pp.meshPoints(), k)
        {
            tensor& G = gradient[pp.meshPoints()[k]];
            G = G & sqr(pp.pointNormals()[k]);
        }
    }
}


void Foam::displacementFilter::smooth
(
    vectorField& displacement,
    const tensorField& gradient,
    const polyMesh& mesh
)
{
    constexpr label inside = -1, manySides = -2;
    labelList side(mesh.nPoints(), inside);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp)) continue;
        const bool held = movesAsOne(pp, displacement);
        for (const label p : pp.meshPoints())
        {
            side[p] = side[p] == inside && !held ? pp.index() : manySides;
        }
    }

    // Minus twice the deviation of a point, summed over its edges
    vectorField jumps(mesh.nPoints(), Zero);
    labelList n(mesh.nPoints(), Zero);
    const Vector<label>& solved = mesh.solutionD();
    for (const edge& e : mesh.edges())
    {
        vector r(e.vec(mesh.points()));
        const scalar length = mag(r);
        for (direction i = 0; i < 3; ++i) if (solved[i] < 0) r[i] = 0;
        if (mag(r) < 0.5*length) continue;
        const vector jump
        (
            displacement[e.second()] - displacement[e.first()]
          - 0.5*((gradient[e.first()] + gradient[e.second()]) & r)
        );
        for (const label k : {0, 1})
        {
            const label p = e[k], other = e[1 - k];
            if (side[p] != inside && side[p] != side[other]) continue;
            jumps[p] += k == 0 ? jump : -jump;
            ++n[p];
        }
    }
    forAll(displacement, p)
    {
        if (side[p] != manySides && n[p]) displacement[p] += 0.5*jumps[p]/n[p];
    }
}


// ************************************************************************* //
