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
        for (label facei = 0; facei < patch.nFaces(); ++facei)
        {
            const label start = patch.faceStart[facei];
            const label n = patch.faceStart[facei + 1] - start;
            for (label j = 0; j < n; ++j)
            {
                f
                (
                    start + j,
                    edge
                    (
                        patch.cornerPoint[start + j],
                        patch.cornerPoint[start + (j + 1) % n]
                    )
                );
            }
        }
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
    for (label facei = 0; facei < patch.nFaces(); ++facei)
    {
        const label start = patch.faceStart[facei];
        const label n = patch.faceStart[facei + 1] - start;
        for (label j = 0; j < n; ++j)
        {
            if (!rim[start + j]) continue;
            points.set(patch.cornerPoint[start + j], 1);
            points.set(patch.cornerPoint[start + (j + 1) % n], 1);
        }
    }
    syncTools::syncPointMap(mesh, points, maxEqOp<label>());

    boolList nodes;
    nodes.setSize(patch.nCorners(), false);
    forAll(nodes, k) nodes[k] = points.found(patch.cornerPoint[k]);
    return nodes;
}


// ************************************************************************* //
