/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodySurface.H"
#include "medianDual.H"
#include "HashSet.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodySurface::findNodes(const dualPatch& patch)
{
    nodes = labelHashSet(patch.cornerNode).sortedToc();
    place.setSize(patch.nCorners());
    forAll(place, k) place[k] = findSortedIndex(nodes, patch.cornerNode[k]);
}


void Foam::bodySurface::findSizes
(
    const medianDual& dual,
    const dualPatch& patch
)
{
    patch.forFaces([&](const dualPatch::face& f)
    {
        const label start = f.start, size = f.size;
        FixedList<point, 4> X(point::zero);
        point centre(Zero);
        for (label j = 0; j < size; ++j)
        {
            X[j] = dual.position(patch.cornerNode[start + j]);
            centre += X[j];
        }
        centre /= size;
        const scalar width = size > 1 ? meanEdge(X, size) : depth[start];
        leastWidth = min(leastWidth, size > 2 ? across(X, size) : width);
        reach = max(reach, width);
        for (label j = 0; j < size; ++j) reach = max(reach, mag(X[j] - centre));
    });
    reduce(leastWidth, minOp<scalar>());
    reduce(reach, maxOp<scalar>());
}


Foam::scalar Foam::bodySurface::across
(
    const FixedList<point, 4>& x,
    const label size
)
{
    scalar longest = 0;
    for (label i = 0; i < size; ++i)
    {
        longest = max(longest, mag(x[(i + 1) % size] - x[i]));
    }
    const scalar twiceArea =
        size > 3
      ? mag((x[2] - x[0]) ^ (x[3] - x[1]))
      : mag((x[1] - x[0]) ^ (x[2] - x[0]));
    return (size > 3 ? 0.5 : 1)*twiceArea/max(longest, VSMALL);
}


Foam::scalar Foam::bodySurface::meanEdge
(
    const FixedList<point, 4>& x,
    const label size
)
{
    scalar around = 0;
    for (label i = 0; i < size; ++i) around += mag(x[(i + 1) % size] - x[i]);
    return around/size;
}


// ************************************************************************* //
