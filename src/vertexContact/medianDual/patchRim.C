/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchRim.H"
#include "EdgeMap.H"
#include "Map.H"
#include "polyMesh.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of an edge that several faces have
constexpr label shared = -1;

//- The one face of an edge, by its processor, or shared. Processors may tell
//  each other more than once
struct meet
{
    void operator()(label& a, const label b) const
    {
        if (a != b) a = shared;
    }
};

//- One more face of this processor
template<class MapType, class Key>
void count(MapType& faces, const Key& key)
{
    if (!faces.insert(key, Pstream::myProcNo())) faces.set(key, shared);
}

//- Of a face, from a corner to the next
edge edgeFrom(const dualPatch& patch, const dualPatch::face& f, const label j)
{
    return edge
    (
        patch.cornerPoint[f.start + j],
        patch.cornerPoint[f.start + (j + 1) % f.size]
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::boolList Foam::patchRim::corners
(
    const polyMesh& mesh,
    const dualPatch& patch,
    const label nDim
)
{
    boolList rim;
    rim.setSize(patch.nCorners(), false);
    if (nDim == 1) return rim;

    if (nDim == 2)
    {
        const polyPatch& faces = mesh.boundaryMesh()[patch.patchIndex];
        Map<label> points(4*patch.nFaces());
        for (const label f : patch.facePatchFace)
        {
            for (const label p : faces[f]) count(points, p);
        }
        syncTools::syncPointMap(mesh, points, meet());
        forAll(rim, k) rim[k] = points[patch.cornerPoint[k]] != shared;
        return rim;
    }

    // Call a function for each corner and its edge
    const auto forEdges = [&](const auto& f)
    {
        patch.forFaces([&](const dualPatch::face& its)
        {
            for (label j = 0; j < its.size; ++j)
            {
                f(its.start + j, edgeFrom(patch, its, j));
            }
        });
    };
    EdgeMap<label> edges(4*patch.nFaces());
    forEdges([&](const label, const edge& e) { count(edges, e); });
    syncTools::syncEdgeMap(mesh, edges, meet());
    forEdges
    (
        [&](const label k, const edge& e) { rim[k] = edges[e] != shared; }
    );
    return rim;
}


Foam::boolList Foam::patchRim::nodes
(
    const polyMesh& mesh,
    const dualPatch& patch,
    const label nDim,
    const boolList& rim
)
{
    if (nDim < 3) return rim;

    Map<label> points;
    patch.forFaces([&](const dualPatch::face& f)
    {
        for (label j = 0; j < f.size; ++j)
        {
            if (!rim[f.start + j]) continue;
            const edge e(edgeFrom(patch, f, j));
            points.set(e.start(), 1);
            points.set(e.end(), 1);
        }
    });
    syncTools::syncPointMap(mesh, points, maxEqOp<label>());

    boolList nodes;
    nodes.setSize(patch.nCorners(), false);
    forAll(nodes, k) nodes[k] = points.found(patch.cornerPoint[k]);
    return nodes;
}


// ************************************************************************* //
