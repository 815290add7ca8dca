/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestFace.H"
#include "contactLaw.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "pointGrid.H"
#include "rankExchange.H"
#include "Time.H"
#include "addToRunTimeSelectionTable.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeContactPairing(nearestFace)


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Largest product of the normals of faces that meet: that of edges at right
//  angles whose faces just face the normal across these
constexpr scalar leastOpposed =
    -contactOverlaps::leastFacing*contactOverlaps::leastFacing;

//- The same for faces that meet along the mean of their normals: surfaces at a
//  concave edge do not meet
constexpr scalar leastOfMean = -0.5;

//- For one body, distances of nodes over the face width: up to which they are
//  the same node, and up to which faces that do not face each other are
//  neighbours across an edge of the body (beyond it the next faces begin).
//  Equal cells have distances of just these multiples: round-off must not
//  decide there, so they count as beyond
constexpr scalar sameNode = 1e-6;
constexpr scalar neighbours = 2;
constexpr scalar justBelow = 1 - sameNode;

//- A face is so far behind another one that they cannot meet, as the sides of a
//  plate of two cells. Round-off cases are left to opposed()
bool behind
(
    const contactSurface::outline& a,
    const contactSurface::outline& b
)
{
    vector n;
    contactOverlaps::commonNormal(a.n, b.n, n);
    const scalar depth = 0.5*(a.depth + b.depth);
    return ((b.centre - a.centre) & n) < -(1 + sameNode)*depth;
}

//- The gap of two faces along n is at most their width, and the penetration of
//  their centres at most that of faces that meet
bool close(const contactFace& a, const contactFace& b, const vector& n)
{
    scalar top = -GREAT, bottom = GREAT;
    for (label i = 0; i < a.size; ++i) top = max(top, a.x[i] & n);
    for (label i = 0; i < b.size; ++i) bottom = min(bottom, b.x[i] & n);
    return
        bottom - top <= 0.5*(a.width + b.width)
     && ((b.centre() - a.centre()) & n)
     >= -contactOverlaps::deepestMeeting(a, b);
}

//- An order of the faces of a surface that is the same on any number of ranks:
//  that of their first nodes in the mesh. Faces that share that node never meet
bool before(const contactFace& a, const contactFace& b)
{
    const auto first = [](const contactFace& face)
    {
        return *std::min_element
        (
            face.X.begin(), face.X.begin() + face.size, medianDual::before
        );
    };
    return medianDual::before(first(a), first(b));
}

//- Whether two faces of one body may ever be in contact
bool mayEverMeet(const contactFace& a, const contactFace& b)
{
    const scalar width = 0.5*(a.width + b.width);
    point Ca(Zero), Cb(Zero);
    scalar closest = GREAT, radius = 0, otherRadius = 0;
    for (label i = 0; i < a.size; ++i) Ca += a.X[i]/a.size;
    for (label i = 0; i < b.size; ++i) Cb += b.X[i]/b.size;
    for (label i = 0; i < a.size; ++i)
    {
        radius = max(radius, mag(a.X[i] - Ca));
        for (label j = 0; j < b.size; ++j)
        {
            closest = min(closest, mag(a.X[i] - b.X[j]));
        }
    }
    for (label j = 0; j < b.size; ++j)
    {
        otherRadius = max(otherRadius, mag(b.X[j] - Cb));
    }
    if (closest < sameNode*width) return false;

    const vector between(Cb - Ca);
    const scalar along = between & a.N;
    const bool opposite = (a.N & b.N) < leastOfMean;
    const bool faced = opposite && along > 0;

    // Both sides of the same part of the body, however thick it is
    const scalar beside = mag(between - along*a.N) - radius - otherRadius;
    if (opposite && along < 0) return beside >= justBelow*neighbours*width;
    return closest >= justBelow*neighbours*width || faced;
}

//- Faces that may never meet since they are neighbours, judged by their
//  outlines: the least node distance is at most the root mean square one
bool areNeighbours
(
    const contactSurface::outline& a,
    const contactSurface::outline& b
)
{
    return
        (a.N & b.N) >= leastOfMean
     && magSqr(b.C - a.C) + sqr(a.R) + sqr(b.R)
      < sqr(0.5*justBelow*neighbours*(a.width + b.width));
}

pointField centresOf(const UList<contactSurface::outline>& outlines)
{
    pointField centres(outlines.size());
    forAll(outlines, i) centres[i] = outlines[i].centre;
    return centres;
}

scalar largestRadius(const UList<contactSurface::outline>& outlines)
{
    scalar radius = 0;
    for (const contactSurface::outline& o : outlines)
    {
        radius = max(radius, o.radius);
    }
    return radius;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::contactFaceList Foam::contactPairings::nearestFace::oppositeFaces
(
    const contactSurface::snapshot& plus,
    const boundBox& minusBox,
    const boundBox& near
) const
{
    // The minus side sends its box, the plus side returns its faces in it
    labelList minusRanks, plusRanks;
    if (holds(plusRanks_)) minusRanks = minusRanks_;
    if (holds(minusRanks_)) plusRanks = plusRanks_;

    List<List<boundBox>> asked(plusRanks.size(), List<boundBox>(1, minusBox));
    List<List<boundBox>> boxes(minusRanks.size(), List<boundBox>(1));
    rankExchange::sized(plusRanks, asked, minusRanks, boxes);

    DynamicList<contactSurface::outline> mine;
    if (minusRanks.size()) mine = plus.in(near);
    List<List<contactFace>> sent(minusRanks.size()), received;
    forAll(boxes, i)
    {
        const boundBox& box = boxes[i][0];
        if (box.min().x() > box.max().x()) continue;

        DynamicList<contactFace> some;
        for (const contactSurface::outline& o : mine)
        {
            if (box.overlaps(o.box))
            {
                some.append(plusFace(o));
            }
        }
        sent[i].transfer(some);
    }
    rankExchange::lists(minusRanks, sent, plusRanks, received);

    return ListListOps::combine<contactFaceList>
    (
        received, accessOp<contactFaceList>()
    );
}


Foam::scalar Foam::contactPairings::nearestFace::clearance
(
    const UList<contactSurface::outline>& mine,
    const UList<contactSurface::outline>& others,
    const contactFaceList& received
) const
{
    scalar least = 2*surfaceMotion::largestDistance*leastWidth_;
    if (!mine.size() || !others.size()) return least;

    const scalar radius = largestRadius(others);
    const pointGrid grid(centresOf(others), 2*(radius + least));
    for (const contactSurface::outline& a : mine)
    {
        const boundBox near(contactSurface::grown(a.box, radius + least));
        grid.forEach(near, [&](const label i)
        {
            const contactSurface::outline& b = others[i];
            const scalar apart = surfaceMotion::distance(a.box, b.box);
            if (apart >= least) return;
            if
            (
                oneBody_
             && (
                    areNeighbours(a, b)
                 || !mayEverMeet
                    (
                        minusFace(a),
                        received.size() ? received[b.face] : plusFace(b)
                    )
                )
            )
            {
                return;
            }
            least = apart;
        });
    }
    return least;
}


bool Foam::contactPairings::nearestFace::opposed
(
    const contactFace& a,
    const contactFace& b,
    vector& n
) const
{
    if ((a.n & b.n) > leastOpposed)
    {
        return false;
    }
    contactOverlaps::commonNormal(a.n, b.n, n);

    const scalar width = 0.5*(a.width + b.width);
    const point ca(a.centre()), cb(b.centre());
    const scalar reach = a.radius() + b.radius();
    if (magSqr(cb - ca) > sqr(reach + width))
    {
        return false;
    }

    if (!close(a, b, n)) return false;

    // In one body edges on faces are not distinguished; for a surface with
    // itself the other order would be the same pair
    return
        !oneBody_
     || (
            (a.n & b.n) <= leastOfMean
         && (!(minus_ == plus_) || before(a, b))
         && mayEverMeet(a, b)
        );
}


void Foam::contactPairings::nearestFace::pairFaces
(
    const UList<contactSurface::outline>& mine,
    const UList<contactSurface::outline>& others,
    const contactFaceList& received,
    DynamicList<contactOverlap>& overlaps
) const
{
    if (!mine.size() || !others.size()) return;

    const scalar radius = largestRadius(others);
    const pointGrid grid(centresOf(others), 2*(radius + reach_));

    // Faces of others on this rank, set up when they are needed
    DynamicList<contactFace> faces;
    labelList where(received.size() ? 0 : others.size(), -1);

    DynamicList<label> found;
    for (const contactSurface::outline& a : mine)
    {
        const boundBox near
        (
            contactSurface::grown(a.box, radius + 0.5*(a.width + reach_))
        );
        found.clear();
        grid.forEach(near, [&](const label i)
        {
            if
            (
                (a.n & others[i].n) <= leastOpposed
             && near.contains(others[i].centre)
             && !behind(a, others[i])
            )
            {
                found.append(i);
            }
        });
        if (found.empty()) continue;

        // The order of sums must not depend on the grid
        Foam::sort(found);
        const contactFace face(minusFace(a));
        for (const label i : found)
        {
            if (where.size() && where[i] < 0)
            {
                where[i] = faces.size();
                faces.append(plusFace(others[i]));
            }
            const contactFace& b =
                where.size() ? faces[where[i]] : received[others[i].face];
            vector n;
            if (!opposed(face, b, n)) continue;

            overlapNormal normal;
            if (!bonded_ && minus_.body->variational())
            {
                normal = contactOverlaps::normalOf(face, b, n);
            }
            if
            (
                bonded_
             || (
                    close(face, b, n)
                 && contactOverlaps::face(face.n, n)
                 && contactOverlaps::face(-b.n, n)
                 && (face.n & b.n) < leastOfMean*normal.mean()
                 && !contactOverlaps::beside(face, b, n)
                )
            )
            {
                contactOverlaps::append
                (
                    face, b, n, normal, minus_.body->variational(), overlaps
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactPairings::nearestFace::nearestFace
(
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
:
    contactPairing(minus, plus),
    oneBody_(minus.body == plus.body),
    bonded_(contactLaw::ofInterface(dict)->bonded()),
    minusMotion_(minus),
    plusMotion_(plus)
{
    dictionaryCheck::onlyKeywords(dict, commonKeywords() + keywords());
    updateDistance_ = dictionaryCheck::readOptional
    (
        dict, keywords(), "updateDistance", dimless
    );
    dictionaryCheck::require
    (
        updateDistance_ > 0
     && updateDistance_ <= surfaceMotion::largestDistance,
        dict, "updateDistance", updateDistance_, ("positive and at most "
      + Foam::name(surfaceMotion::largestDistance)).c_str()
    );

    const bodySurface& a = minus_.body->surface(minus_.patchi);
    const bodySurface& b = plus_.body->surface(plus_.patchi);
    leastWidth_ = min(a.leastWidth, b.leastWidth);
    reach_ = max(a.reach, b.reach);

    const PtrList<contactSurface::snapshot> now
    (
        contactSurface::snapshots
        (
            List<contactSide>({minus, plus}), !bonded_
        )
    );
    update(minus.body->mesh().time().value(), now[0], now[1]);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::contactPairings::nearestFace::keywords()
{
    return
    {
        {
            "updateDistance", "-",
            Foam::name(surfaceMotion::usualDistance),
            "distance, in face widths, that a node may move along its surface "
            "before faces are paired again; at most "
          + Foam::name(surfaceMotion::largestDistance)
        }
    };
}


bool Foam::contactPairings::nearestFace::outdated(const scalar time)
{
    // Both have to be called in each step
    const bool minus = minusMotion_.exceeded(time);
    return plusMotion_.exceeded(time) || minus;
}


void Foam::contactPairings::nearestFace::look(const scalar time)
{
    minusMotion_.look(time);
    plusMotion_.look(time);
}


Foam::label Foam::contactPairings::nearestFace::moved
(
    const scalar time,
    const scalar share,
    const contactSurface::bodyMotion& bodies
)
{
    return
        minusMotion_.moved(time, share, bodies)
      | plusMotion_.moved(time, share, bodies);
}


void Foam::contactPairings::nearestFace::setFrame
(
    const scalar time,
    const contactSurface::bodyMotion& bodies
)
{
    minusMotion_.setFrame(time, bodies);
    plusMotion_.setFrame(time, bodies);
}


Foam::scalar Foam::contactPairings::nearestFace::left() const
{
    return min(minusMotion_.left(), plusMotion_.left());
}


Foam::scalar Foam::contactPairings::nearestFace::apart
(
    const contactSurface::snapshot& minus,
    const contactSurface::snapshot& plus
) const
{
    return oneBody_ ? 0 : surfaceMotion::distance(minus.box, plus.box);
}


void Foam::contactPairings::nearestFace::find
(
    const contactSurface::snapshot& minus,
    const contactSurface::snapshot& plus
)
{
    const scalar search = searched();
    DynamicList<contactOverlap> overlaps(contactPairing::overlaps().size());
    clearance_ = GREAT;
    if (apart(minus, plus) <= search)
    {
        // Only faces near the other side
        const DynamicList<contactSurface::outline> mine
        (
            minus.in(contactSurface::grown(plus.box, search))
        );
        DynamicList<contactSurface::outline> others;
        contactFaceList received;
        const bool far = joint();
        if (far)
        {
            boundBox box(boundBox::invertedBox);
            for (const contactSurface::outline& o : mine) box.add(o.box);
            received = oppositeFaces
            (
                plus,
                mine.size() ? contactSurface::grown(box, search) : box,
                contactSurface::grown(minus.box, search)
            );
            others.reserve(received.size());
            forAll(received, f)
            {
                others.append(contactSurface::outline(f, received[f]));
            }
        }
        else if (!(minus_ == plus_))
        {
            others = plus.in(contactSurface::grown(minus.box, search));
        }
        const UList<contactSurface::outline>& all =
            minus_ == plus_ && !far ? mine : others;
        if (minus.mayOppose(plus, std::acos(leastOpposed)))
        {
            pairFaces(mine, all, received, overlaps);
        }
        if (overlaps.empty()) clearance_ = clearance(mine, all, received);
    }
    takeOverlaps(overlaps);
}


void Foam::contactPairings::nearestFace::follow
(
    const scalar time,
    const contactSurface::snapshot& minus,
    const contactSurface::snapshot& plus
)
{
    const scalar search = searched(), apart = this->apart(minus, plus);

    // All pairs within the least width have been found
    const scalar most = surfaceMotion::largestDistance*leastWidth_;
    // In the paper's scheme any motion changes the couple across the gap; and
    // where no faces are opposite yet, any motion may bring edges past each
    // other once they are near
    const bool near = apart <= search;
    const scalar close = updateDistance_*leastWidth_;
    const scalar any =
        !near ? 0.5*(apart - search) + most
      : active() ? (minus_.body->variational() ? most : close)
      : max(close, min(most, 0.5*nearestOfAll()));
    const scalar along = near && active() ? close : any;

    // Common motion of both sides does not change the pairing
    const auto bodies =
        contactSurface::bodyMotion::common(minus.motion, plus.motion);
    minusMotion_.start(time, along, any, bodies);
    plusMotion_.start(time, along, any, bodies);
    if (near && !oneBody_)
    {
        // Paired faces have no nodes further away than this
        const scalar furthest = search + reach_;
        minusMotion_.setFree(plus.box, furthest);
        plusMotion_.setFree(minus.box, furthest);
    }
}


// ************************************************************************* //
