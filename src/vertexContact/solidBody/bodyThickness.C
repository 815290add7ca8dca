/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyThickness.H"
#include "boundBox.H"
#include "DynamicList.H"
#include "emptyPolyPatch.H"
#include "indexedOctree.H"
#include "polyMesh.H"
#include "primitivePatch.H"
#include "processorPolyPatch.H"
#include "rankExchange.H"
#include "rankRows.H"
#include "treeDataPrimitivePatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A face of the surface, to be sent to other processors
struct polygon
{
    label size = 0;
    FixedList<point, 4> x = FixedList<point, 4>(point::zero);

    boundBox box() const
    {
        boundBox its(boundBox::invertedBox);
        for (label j = 0; j < size; ++j) its.add(x[j]);
        return its;
    }
};

typedef treeDataPrimitivePatch<primitivePatch> surfaceData;

//- The faces of this processor where the body ends.
//  \param start  of each patch among them; -1 without
DynamicList<polygon> endsOf
(
    const polyMesh& mesh,
    const labelUList& mirrors,
    labelList& start
)
{
    DynamicList<polygon> all;
    start.setSize(mesh.boundaryMesh().size(), -1);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if
        (
            isA<emptyPolyPatch>(pp) || isA<processorPolyPatch>(pp)
         || mirrors.found(pp.index())
        )
        {
            continue;
        }
        start[pp.index()] = all.size();
        for (const face& f : pp)
        {
            polygon its;
            its.size = f.size();
            forAll(f, j) its.x[j] = mesh.points()[f[j]];
            all.append(its);
        }
    }
    return all;
}

//- Append the faces of other processors that meet the box of this one
void appendOthers(DynamicList<polygon>& faces, const boundBox& near)
{
    if (!Pstream::parRun()) return;

    const label n = Pstream::nProcs(), me = Pstream::myProcNo();
    List<boundBox> asked(n, boundBox(boundBox::invertedBox)), has(asked);
    asked[me] = near;
    for (const polygon& f : faces) has[me].add(f.box());
    const auto join = [](boundBox& a, const boundBox& b) { a.add(b); };
    combineOnAll(asked, join);
    combineOnAll(has, join);

    DynamicList<label> to, from;
    for (label rank = 0; rank < n; ++rank)
    {
        if (rank == me) continue;
        if (has[me].overlaps(asked[rank])) to.append(rank);
        if (has[rank].overlaps(near)) from.append(rank);
    }
    List<List<polygon>> sent(to.size()), received;
    forAll(to, i)
    {
        DynamicList<polygon> some;
        for (const polygon& f : faces)
        {
            if (asked[to[i]].overlaps(f.box())) some.append(f);
        }
        sent[i].transfer(some);
    }
    rankExchange::lists(to, sent, from, received);
    for (const List<polygon>& some : received) faces.append(some);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::List<Foam::scalarField> Foam::bodyThickness::behind
(
    const polyMesh& mesh,
    const labelUList& patches,
    const labelUList& mirrors,
    const scalar within
)
{
    labelList start;
    DynamicList<polygon> all(endsOf(mesh, mirrors, start));
    boundBox near(boundBox::invertedBox);
    for (const label patchi : patches)
    {
        near.add(mesh.boundaryMesh()[patchi].localPoints());
    }
    near.min() -= within*vector::one;
    near.max() += within*vector::one;
    appendOthers(all, near);

    // A surface of separate faces
    pointField points(4*all.size());
    faceList faces(all.size());
    label nPoints = 0;
    forAll(all, i)
    {
        faces[i].setSize(all[i].size);
        for (label& p : faces[i])
        {
            p = nPoints;
            ++nPoints;
        }
        forAll(faces[i], j) points[faces[i][j]] = all[i].x[j];
    }
    points.setSize(nPoints);

    List<scalarField> thickness(patches.size());
    forAll(patches, i)
    {
        thickness[i].setSize(mesh.boundaryMesh()[patches[i]].size(), GREAT);
    }
    if (!nPoints) return thickness;

    const primitivePatch surface(SubList<face>(faces, faces.size()), points);
    treeBoundBox box(points);
    const vector margin((within + SMALL)*vector::one);
    box.min() -= margin;
    box.max() += margin;
    const indexedOctree<surfaceData> tree
    (
        surfaceData(true, surface, indexedOctree<surfaceData>::perturbTol()),
        box, 12, 10, 3.0
    );
    const auto normal = [&](const label i)
    {
        const vector area(faces[i].areaNormal(points));
        return area/max(mag(area), VSMALL);
    };
    DynamicList<label> self(1);
    forAll(patches, i)
    {
        forAll(thickness[i], facei)
        {
            const label own = start[patches[i]] + facei;
            const vector n(normal(own));
            const point centre(faces[own].centre(points));
            self.clear();
            self.append(own);
            const pointIndexHit hit
            (
                tree.findLine
                (
                    centre, centre - within*n,
                    surfaceData::findAllIntersectOp(tree, self)
                )
            );
            if (hit.hit() && (normal(hit.index()) & n) <= mostOfOtherSide)
            {
                thickness[i][facei] = mag(hit.hitPoint() - centre);
            }
        }
    }
    return thickness;
}


// ************************************************************************* //
