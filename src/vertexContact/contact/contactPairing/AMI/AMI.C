/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "AMI.H"
#include "contactSurface.H"
#include "scalarRecord.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "AMIPatchToPatchInterpolation.H"
#include "faceAreaIntersect.H"
#include "pointTree.H"
#include "HashSet.H"
#include "addToRunTimeSelectionTable.H"
#include <cstring>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeContactPairing(AMI)


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The faces of a side that face a direction, as a surface for AMI
struct surface
{
    //- Index of each face in the list of contact faces
    labelList index;

    faceList faces;
    pointField points;

    surface
    (
        const contactSide& side,
        const contactFaceList& all,
        const vector& direction,
        const scalar facesGap
    )
    {
        const polyPatch& pp = side.body->mesh().boundaryMesh()[side.patchi];

        DynamicList<label> facing(all.size());
        forAll(all, f)
        {
            if ((all[f].n & direction) > facesGap) facing.append(f);
        }
        index.transfer(facing);

        points = pp.localPoints();
        faces.setSize(index.size());
        forAll(index, f)
        {
            faces[f] = pp.localFaces()[index[f]];
        }
    }
};

//- Give both sides the same extent in the directions that are left out
void levelThickness(surface& s, const medianDual& dual, const scalar extent)
{
    const vector out(vector::one - dual.projected(vector::one));
    for (direction i = 0; i < 3; ++i)
    {
        if (out[i] > 0)
        {
            scalar least = GREAT, largest = -GREAT;
            for (const point& p : s.points)
            {
                least = min(least, p[i]);
                largest = max(largest, p[i]);
            }
            reduce(least, minOp<scalar>());
            reduce(largest, maxOp<scalar>());

            const scalar middle = 0.5*(least + largest);
            for (point& p : s.points)
            {
                p[i] = p[i] > middle ? 0.5*extent : -0.5*extent;
            }
        }
    }
}

//- The points of the faces
pointField usedPoints(const surface& s)
{
    labelHashSet used;
    for (const face& f : s.faces) used.insert(f);
    return pointField(s.points, used.sortedToc());
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::contactPairings::AMI::leastGap
(
    const pointField& source,
    const pointField& allTarget,
    const vector& direction
)
{
    scalar gap = GREAT;
    if (source.size() && allTarget.size())
    {
        pointField across(allTarget);
        for (point& p : across) p -= (p & direction)*direction;
        const autoPtr<pointTree> tree(newPointTree(across, 0));
        for (const point& x : source)
        {
            const pointIndexHit hit
            (
                tree->findNearest(x - (x & direction)*direction, sqr(GREAT))
            );
            gap = min(gap, (allTarget[hit.index()] - x) & direction);
        }
    }
    return returnReduce(gap, minOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactPairings::AMI::AMI
(
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
:
    contactPairing(minus, plus)
{
    dictionaryCheck::onlyKeywords(dict, commonKeywords() + keywords());
    const vector direction(gapDirection(dict));

    const medianDual& dual = minus.body->dual();
    const contactFaceList minusFaces
    (
        contactSurface::faces(minus, minusCorners_)
    );
    contactFaceList plusFaces(contactSurface::faces(plus, plusCorners_));
    surface source(minus, minusFaces, direction, facesGap);
    surface target(plus, plusFaces, -direction, facesGap);

    // Close the gap
    const scalar gap = leastGap
    (
        usedPoints(source), gathered(usedPoints(target)), direction
    );
    target.points -= gap*direction;
    for (contactFace& f : plusFaces)
    {
        for (label j = 0; j < f.size; ++j) f.x[j] -= gap*direction;
    }

    scalar extent = 0;
    for (const contactFace& f : minusFaces) extent = max(extent, f.width);
    reduce(extent, maxOp<scalar>());
    levelThickness(source, dual, extent);
    levelThickness(target, plus.body->dual(), extent);

    const primitivePatch sourcePatch
    (
        SubList<face>(source.faces, source.faces.size()), source.points
    );
    const primitivePatch targetPatch
    (
        SubList<face>(target.faces, target.faces.size()), target.points
    );

    const auto ami = compat::faceAreaAMI<AMIPatchToPatchInterpolation>
    (
        sourcePatch, targetPatch, faceAreaIntersect::tmMesh
    );

    // Send faces of the plus side to the ranks of the minus side
    typedef FixedList<scalar, scalarRecord::size<contactFace>()> faceBytes;
    List<faceBytes> bytes(target.index.size());
    forAll(bytes, f)
    {
        const contactFace& face = plusFaces[target.index[f]];
        std::memcpy(bytes[f].data(), &face, sizeof(face));
    }
    compat::toSource(*ami, bytes);
    contactFaceList opposite(bytes.size());
    forAll(bytes, f)
    {
        void* face = &opposite[f];
        std::memcpy(face, bytes[f].cdata(), sizeof(contactFace));
    }

    DynamicList<contactOverlap> overlaps(4*source.index.size());
    scalar covered = 0, area = 0;
    const labelListList& address = ami->srcAddress();
    forAll(source.index, f)
    {
        const contactFace& a = minusFaces[source.index[f]];
        const label before = overlaps.size();
        for (const label slot : address[f])
        {
            const contactFace& b = opposite[slot];
            vector n;
            if (contactOverlaps::commonNormal(a.n, b.n, n))
            {
                contactOverlaps::append
                (
                    a, b, n, overlapNormal(), minus.body->variational(),
                    overlaps
                );
            }
        }
        for (label o = before; o < overlaps.size(); ++o)
        {
            // Paired once: what has slid on is bounded by others
            overlaps[o].motion = overlapMotion();
            covered += overlaps[o].minus.area;
        }
        for (label j = 0; j < a.size; ++j) area += a.area[j];
    }
    reduce(covered, sumOp<scalar>());
    reduce(area, sumOp<scalar>());

    setOverlaps(overlaps);

    Info<< "    AMI: "
        << returnReduce(contactPairing::overlaps().size(), sumOp<label>())
        << " overlaps cover " << 100*covered/max(area, VSMALL)
        << " % of the first side, gap " << gap << " m along " << direction
        << endl;

    if (!active())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'pairing': no face of " << minus.body->name() << ' '
            << minus.patchName << " overlaps a face of "
            << plus.body->name() << ' ' << plus.patchName
            << " when the gap between them is closed along " << direction
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
