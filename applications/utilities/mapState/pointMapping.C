/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointMapping.H"
#include "meshSearch.H"
#include "tetIndices.H"
#include "treeDataFace.H"
#include "indexedOctree.H"
#include "fileError.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Weights of points, as equal as possible, such that their sum is 1 and the
//  weighted mean of the points is the given place
scalarList linearWeights
(
    const pointField& points,
    const labelList& of,
    const point& place
)
{
    vector mean(Zero);
    for (const label p : of) mean += points[p]/of.size();
    symmTensor spread(Zero);
    for (const label p : of) spread += sqr(points[p] - mean);
    const vector slope(inv(spread) & (place - mean));

    scalarList weights(of.size());
    forAll(of, k)
    {
        weights[k] = scalar(1)/of.size() + (slope & (points[of[k]] - mean));
    }
    return weights;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointMapping::pointMapping
(
    const pointField& target,
    const polyMesh& source,
    const fileName& sourceFile
)
:
    points_(target.size()),
    weights_(target.size()),
    outside_(target.size(), false)
{
    const meshSearch search(source);
    const pointField& points = source.points();

    forAll(target, i)
    {
        // Outside, take the cell behind the nearest face of the surface: the
        // cell with the nearest centre may belong to another part of the body
        const label inside = search.findCell(target[i], -1, true);
        pointIndexHit surface;
        if (inside < 0)
        {
            surface =
                search.boundaryTree().findNearest(target[i], sqr(GREAT));
        }
        const label celli =
            inside >= 0
          ? inside
          : source.faceOwner()
            [
                search.boundaryTree().shapes().faceLabels()[surface.index()]
            ];
        const labelList& cell = source.cellPoints()[celli];
        points_[i] = cell;

        if (inside >= 0)
        {
            // Barycentric weights of the cell centre and three points of a face
            label facei, pointi;
            source.findTetFacePt(celli, target[i], facei, pointi);
            if (facei < 0)
            {
                // Between the tetrahedra, due to round-off
                weights_[i] = linearWeights(points, cell, target[i]);
                continue;
            }
            const tetIndices tet(celli, facei, pointi);
            barycentric in;
            tet.tet(source).pointToBarycentric(target[i], in);
            weights_[i] =
                linearWeights(points, cell, source.cellCentres()[celli]);
            for (scalar& w : weights_[i]) w *= in.a();
            const triFace corners(tet.faceTriIs(source));
            forAll(corners, k)
            {
                weights_[i][cell.find(corners[k])] += in[k + 1];
            }
            continue;
        }

        const scalar length = boundBox(pointField(points, cell), false).mag();
        const scalar off = mag(surface.hitPoint() - target[i]);
        if (off > length)
        {
            FatalFileErrorInFunction(sourceFile)
                << "Point " << target[i] << " of the case is " << off
                << " m from this mesh, more than the length of the nearest "
                << "cell: both meshes must be of the same body, in the same "
                << "place"
                << exit(FatalIOError);
        }
        // Apart from round-off
        outside_[i] = off > 1e-9*length;
        furthest_ = max(furthest_, off);
        weights_[i] = linearWeights(points, cell, target[i]);
    }
}


// ************************************************************************* //
