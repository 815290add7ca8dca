/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "overlapNormal.H"
#include "faceProjection.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The body ends at some of a face's edges
bool ends(const contactFace& f)
{
    for (const bool is : f.ends) if (is) return true;
    return false;
}

//- Half of the width of the finer face
scalar halfWidth(const contactFace& minus, const contactFace& plus)
{
    return 0.5*min(minus.width, plus.width);
}

//- r of overlapNormal: how far the ends of one face that bound its intersection
//  with another lie on that one. 1 if their distance from the other's ends
//  exceeds their depth inside by half of a width. They are projected along the
//  other face's normal, which is that of contact if they lie on it: along any
//  other one, an end that is inside is not above the face that it is behind.
//  Ends beside the face count where its body continues, so that the normal does
//  not change as they slide from one face to the next in a plane
scalar endsOn(const contactFace& its, const contactFace& other)
{
    vector u, w;
    alongPlane(other.n, other, u, w);
    const faceProjection a(its, u, w), b(other, u, w);
    const scalar half = halfWidth(its, other);
    bool any = false;
    scalar off = GREAT;
    const auto bounds = [&](const vector2D& at)
    {
        any = true;
        const scalar inside = (b.above(at) - a.above(at)) & other.n;
        off = min(off, max(b.fromEnd(at) - max(inside, scalar(0)), scalar(0)));
    };
    if (its.nDim() == 2)
    {
        for (label i = 0; i < 2; ++i)
        {
            if (its.ends[i] && b.goesOnTo(a.x[i], half)) bounds(a.x[i]);
        }
    }
    else
    {
        constexpr scalar ofIts = 0, ofOther = 1;
        const convexPolygon common
        (
            clipped
            (
                a.whole(ofIts), b.goingOn(half, ofOther),
                contactOverlaps::alongEdge
            )
        );
        for (label i = 0; i < common.size; ++i)
        {
            if (common.mark[i] != ofIts) continue;
            bounds(common.p[i]);
            bounds(common.p[(i + 1) % common.size]);
        }
    }
    return any ? min(scalar(1), sqr(off/half)) : 0;
}

//- Set the weights of the normals of both sides
void setShares
(
    const contactFace& minus,
    const contactFace& plus,
    overlapNormal& which
)
{
    const scalar minusOn = endsOn(minus, plus);
    const scalar plusOn = endsOn(plus, minus);
    which.minus = 1 - minusOn*(1 - plusOn);
    which.plus = 1 - plusOn*(1 - minusOn);
}

//- Find the crossing edges: the nearest pair, with its weight less that of the
//  second nearest
void setCrossing
(
    const contactFace& minus,
    const contactFace& plus,
    overlapNormal& which
)
{
    const scalar half = halfWidth(minus, plus);
    const auto share = [](const scalar s)
    {
        return min(max(s, scalar(0)), scalar(1));
    };
    scalar second = 0;
    for (label i = 0; i < minus.size; ++i)
    {
        const vector d(minus.edge(i));
        for (label j = 0; minus.ends[i] && j < plus.size; ++j)
        {
            const vector e(plus.edge(j));
            const scalar sqrArea = magSqr(d ^ e);
            const bool along = sqrArea <= SMALL*magSqr(d)*magSqr(e);
            if (!plus.ends[j] || along) continue;

            // Places on both edges, 0 to 1, of their nearest points
            const vector r(plus.x[j] - minus.x[i]);
            const scalar de = d & e, dr = d & r, er = e & r;
            const scalar s = share((magSqr(e)*dr - de*er)/sqrArea);
            const scalar t = share((de*dr - magSqr(d)*er)/sqrArea);
            const scalar w = 1 - magSqr(r + t*e - s*d)/sqr(half);
            if (w > which.crossing)
            {
                second = which.crossing;
                which.crossing = w;
                which.minusEdge = i;
                which.plusEdge = j;
            }
            else second = max(second, w);
        }
    }
    which.crossing -= second;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

bool Foam::contactOverlaps::commonNormal
(
    const vector& nMinus,
    const vector& nPlus,
    vector& n
)
{
    n = nMinus - nPlus;
    const scalar magN = mag(n);
    const bool opposed = magN > 1;
    n = opposed ? n/magN : nMinus/mag(nMinus);
    return opposed;
}


Foam::overlapNormal Foam::contactOverlaps::normalOf
(
    const contactFace& minus,
    const contactFace& plus,
    vector& n
)
{
    overlapNormal which;
    if (minus.nDim() == 1 || !(ends(minus) || ends(plus))) return which;

    setShares(minus, plus, which);
    n = which.minus*minus.n - which.plus*plus.n;
    n /= mag(n);
    if (minus.nDim() == 3) setCrossing(minus, plus, which);
    if (which.crossing > 0)
    {
        const vector d(minus.edge(which.minusEdge));
        const vector e(plus.edge(which.plusEdge));
        const vector c((d ^ e)/(mag(d)*mag(e)));
        n = (1 - which.crossing*mag(c))*n
          + ((c & n) < 0 ? -1 : 1)*which.crossing*c;
        n /= mag(n);
    }
    return which;
}


bool Foam::contactOverlaps::beside
(
    const contactFace& minus,
    const contactFace& plus,
    const vector& n
)
{
    if (minus.nDim() == 1) return false;
    if (!ends(minus) && !ends(plus)) return false;

    vector u, w;
    alongPlane(n, minus, u, w);
    const faceProjection a(minus, u, w), b(plus, u, w);

    // Intersection of the faces
    convexPolygon common;
    if (minus.nDim() == 2)
    {
        const scalar from = max
        (
            min(a.x[0].x(), a.x[1].x()), min(b.x[0].x(), b.x[1].x())
        );
        const scalar to = min
        (
            max(a.x[0].x(), a.x[1].x()), max(b.x[0].x(), b.x[1].x())
        );
        if (from >= to) return false;
        common.append(vector2D(from, 0));
        common.append(vector2D(to, 0));
    }
    else
    {
        common = clipped(a.whole(), b.whole(), 0);
        if (common.size < 3 || doubleArea(common) <= 0) return false;
    }
    vector2D at(Zero);
    for (label i = 0; i < common.size; ++i) at += common.p[i]/common.size;
    const scalar inside = (a.above(at) - b.above(at)) & n;
    scalar deepest = 0;
    for (label i = 0; i < common.size; ++i)
    {
        const vector2D& x = common.p[i];
        deepest = max(deepest, (a.above(x) - b.above(x)) & n);
    }
    if (deepest > deepestMeeting(minus, plus)) return true;
    if (inside <= 0) return false;
    if (!ends(minus) || !ends(plus)) return false;

    // Along the normal of an end, over an end of the other face that looks
    // against it
    scalar least = GREAT;
    const auto leave = [&]
    (
        const faceProjection& over,
        const faceProjection& other
    )
    {
        for (label i = 0; i < over.size; ++i)
        {
            for (label j = 0; over.face.ends[i] && j < other.size; ++j)
            {
                const scalar against = -(over.inward(i) & other.inward(j));
                if (!other.face.ends[j] || against <= 0) continue;
                least = min
                (
                    least, over.within(i, at) + other.within(j, at)/against
                );
            }
        }
    };
    leave(a, b);
    leave(b, a);
    return inside > least;
}


// ************************************************************************* //
