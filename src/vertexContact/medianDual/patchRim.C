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

//- Mark of an edge that belongs to several faces
constexpr label shared = -1;

//- Combine the processors of the one face of an edge; shared if they differ.
//  Processors may tell each other more than once
struct meet
{
    void operator()(label& a, const label b) const
    {
        if (a != b) a = shared;
    }
};

//- Largest difference of the normals of two faces that is not a rim
constexpr scalar sharp = 1 + ROOTSMALL;

//- Faces of a patch at an edge or a point: the processor of the one face, and
//  the least and largest components of the normals
template<template<class> class MapType>
struct facesAt
{
    MapType<label> face;
    MapType<vector> least;
    MapType<vector> most;

    explicit facesAt(const label size)
    :
        face(size),
        least(size),
        most(size)
    {}

    //- Add a face of this processor
    template<class Key>
    void add(const Key& key, const vector& n)
    {
        if (!face.insert(key, Pstream::myProcNo())) face.set(key, shared);
        if (!least.insert(key, n)) least.set(key, min(least[key], n));
        if (!most.insert(key, n)) most.set(key, max(most[key], n));
    }

    //- At a rim there is one face, or the normals differ too much: for two
    //  faces the difference of their components is that of most and least
    template<class Key>
    bool rim(const Key& key) const
    {
        return face[key] != shared || mag(most[key] - least[key]) > sharp;
    }
};

//- Outward unit normals of the faces of a boundary
vectorField normals(const polyPatch& faces)
{
    const vectorField areas(faces.faceAreas());
    return areas/max(mag(areas), VSMALL);
}

//- Edge of a face from a corner to the next
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
    const dualPatch& patch
)
{
    boolList rim;
    rim.setSize(patch.nCorners(), false);
    if (patch.nDim == 1) return rim;

    const polyPatch& faces = mesh.boundaryMesh()[patch.patchIndex];
    const vectorField n(normals(faces));
    if (patch.nDim == 2)
    {
        facesAt<Map> points(4*patch.nFaces());
        forAll(faces, f)
        {
            for (const label p : faces[f]) points.add(p, n[f]);
        }
        syncTools::syncPointMap(mesh, points.face, meet());
        syncTools::syncPointMap(mesh, points.least, minEqOp<vector>());
        syncTools::syncPointMap(mesh, points.most, maxEqOp<vector>());
        forAll(rim, k) rim[k] = points.rim(patch.cornerPoint[k]);
        return rim;
    }

    // Call a function for each corner, its edge and its face
    const auto forEdges = [&](const auto& f)
    {
        patch.forFaces([&](const dualPatch::face& its)
        {
            for (label j = 0; j < its.size; ++j)
            {
                f(its.start + j, edgeFrom(patch, its, j), its.index);
            }
        });
    };
    facesAt<EdgeMap> edges(4*patch.nFaces());
    forEdges([&](const label, const edge& e, const label f)
    {
        edges.add(e, n[f]);
    });
    syncTools::syncEdgeMap(mesh, edges.face, meet());
    syncTools::syncEdgeMap(mesh, edges.least, minEqOp<vector>());
    syncTools::syncEdgeMap(mesh, edges.most, maxEqOp<vector>());
    forEdges([&](const label k, const edge& e, const label)
    {
        rim[k] = edges.rim(e);
    });
    return rim;
}


Foam::boolList Foam::patchRim::nodes
(
    const polyMesh& mesh,
    const dualPatch& patch,
    const boolList& rim
)
{
    if (patch.nDim < 3) return rim;

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


Foam::boolList Foam::patchRim::ends
(
    const polyMesh& mesh,
    const dualPatch& patch,
    const boolList& rim,
    const labelUList& mirrors
)
{
    boolList ends(rim);
    for (const label patchi : mirrors)
    {
        // An edge whose two points are in a plane is in that plane
        labelList in(mesh.nPoints(), label(0));
        for (const label p : mesh.boundaryMesh()[patchi].meshPoints())
        {
            in[p] = 1;
        }
        syncTools::syncPointList(mesh, in, maxEqOp<label>(), label(0));
        const auto isIn = [&](const dualPatch::face& f, const label j)
        {
            if (patch.nDim < 3) return in[patch.cornerPoint[f.start + j]] > 0;
            const edge e(edgeFrom(patch, f, j));
            return in[e.start()] > 0 && in[e.end()] > 0;
        };
        patch.forFaces([&](const dualPatch::face& f)
        {
            for (label j = 0; j < f.size; ++j)
            {
                if (isIn(f, j)) ends[f.start + j] = false;
            }
        });
    }
    return ends;
}


// ************************************************************************* //
