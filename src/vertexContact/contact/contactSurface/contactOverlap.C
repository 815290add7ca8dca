/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactOverlap.H"
#include "faceProjection.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sums over the pieces of an overlap, of which overlapMotion follows: area and
//  its first moment, and how fast both grow with the way of the plus side
struct movingArea
{
    scalar area = 0;
    vector2D moment = vector2D::zero;
    vector2D growth = vector2D::zero;
    FixedList<vector2D, 2> momentGrowth =
        FixedList<vector2D, 2>(vector2D::zero);
    vector2D sweep = vector2D::zero;
    vector2D bend = vector2D::zero;

    //- In 3D its edges, from the origin
    DynamicList<vector2D> edges;

    //- contactOverlap::edges
    List<vector2D> outline() const
    {
        List<vector2D> all(edges);
        for (vector2D& x : all) x -= moment/area;
        return all;
    }

    //- An edge, by its middle, and length times outer normal
    void addEdge
    (
        const vector2D& middle,
        const vector2D& normal,
        const scalar follows
    )
    {
        const vector2D moves(follows*normal);
        growth += moves;
        momentGrowth[0] += middle.x()*moves;
        momentGrowth[1] += middle.y()*moves;
        sweep += max(follows - 0.5, scalar(0))*normal;
        bend += 0.5*sqr(follows)*normal;
    }

    //- \param twice   its area
    //  \param at      its centroid
    //  \param origin  of the moments
    void addPiece
    (
        const convexPolygon& g,
        const scalar twice,
        const vector2D& at,
        const vector2D& origin
    )
    {
        area += 0.5*twice;
        moment += 0.5*twice*(at - origin);
        for (label i = 0; i < g.size; ++i)
        {
            const vector2D& a = g.p[i];
            const vector2D& b = g.p[(i + 1) % g.size];
            const vector2D d(b - a);
            edges.append(a - origin);
            edges.append(b - origin);
            addEdge
            (
                0.5*(a + b) - origin, vector2D(d.y(), -d.x()), g.mark[i]
            );
        }
    }

    overlapMotion motion(const vector& u, const vector& w) const
    {
        const vector2D c(moment/area);
        const vector2D g(growth/area);
        const vector2D cu(momentGrowth[0]/area - c.x()*g);
        const vector2D cw(momentGrowth[1]/area - c.y()*g);
        overlapMotion m;
        m.growth = g.x()*u + g.y()*w;
        m.sweep = (sweep.x()*u + sweep.y()*w)/area;
        m.bend = (bend.x()*u + bend.y()*w)/area;
        if (w == vector::zero)
        {
            // In 2D there is only one direction
            m.drift = cu.x()*tensor::I;
            return m;
        }
        // Surfaces that turn also move across the plane; the centroid follows
        // by half, for either side
        const vector n(u ^ w);
        m.drift =
            u*(cu.x()*u + cu.y()*w) + w*(cw.x()*u + cw.y()*w) + 0.5*n*n;
        return m;
    }
};

//- Stencil of a face for an overlap, at a point of a corner's part.
//  \param share  of the part
//  \param area   reference area of the part
contactStencil stencil
(
    const faceProjection& p,
    const label corner,
    const vector2D& at,
    const scalar share,
    const scalar area
)
{
    const contactFace& f = p.face;
    const FixedList<scalar, 4> N(p.weights(at)), c(f.fluxes(N));

    contactStencil s;
    s.size = f.size;
    for (label j = 0; j < f.size; ++j)
    {
        const label k = (corner + j) % f.size;
        s.corner[j] = f.firstCorner + k;
        s.value[j] = N[k];
        s.flux[j] = c[k];
    }
    s.area = share*area;
    s.share = s.area/f.area[corner];
    return s;
}

//- Add the stencil of a side for another piece of an overlap
void join(contactStencil& a, const contactStencil& b)
{
    const scalar share = b.area/(a.area + b.area);
    for (label j = 0; j < a.size; ++j)
    {
        a.value[j] += share*(b.value[j] - a.value[j]);
        a.flux[j] += share*(b.flux[j] - a.flux[j]);
    }
    a.area += b.area;
    a.share += b.share;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::contactStencil Foam::contactOverlaps::whole
(
    const label corner,
    const scalar area
)
{
    contactStencil s;
    s.size = 1;
    s.corner[0] = corner;
    s.value[0] = s.flux[0] = s.share = 1;
    s.area = area;
    return s;
}


Foam::labelList Foam::contactOverlaps::usedCorners
(
    const UList<contactOverlap>& overlaps,
    contactStencil contactOverlap::* side,
    labelList& place
)
{
    place = -1;
    for (const contactOverlap& o : overlaps)
    {
        const contactStencil& its = o.*side;
        for (label j = 0; j < its.size; ++j) place[its.corner[j]] = 0;
    }
    DynamicList<label> corners(place.size());
    forAll(place, k)
    {
        if (place[k] < 0) continue;
        place[k] = corners.size();
        corners.append(k);
    }
    return labelList(corners);
}


void Foam::contactOverlaps::append
(
    const contactFace& minus,
    const contactFace& plus,
    const vector& n,
    const overlapNormal& normal,
    const bool joined,
    DynamicList<contactOverlap>& overlaps
)
{
    const label nDim = minus.nDim();
    const scalar onLine = joined ? alongEdge : 0;

    vector u, w;
    alongPlane(n, minus, u, w);
    const faceProjection a(minus, u, w), b(plus, u, w);

    const label first = overlaps.size();
    FixedList<movingArea, 16> moving;

    // Returns the index of the overlap, of these faces, that has the piece
    const auto add = [&]
    (
        const label i,
        const label j,
        const contactStencil& sideMinus,
        const contactStencil& sidePlus
    )
    {
        for (label k = first; joined && k < overlaps.size(); ++k)
        {
            contactOverlap& o = overlaps[k];
            if
            (
                o.minus.corner[0] == sideMinus.corner[0]
             && o.plus.corner[0] == sidePlus.corner[0]
            )
            {
                join(o.minus, sideMinus);
                join(o.plus, sidePlus);
                return k - first;
            }
        }
        contactOverlap o;
        o.minus = sideMinus;
        o.plus = sidePlus;
        o.depth = min(minus.depth[i], plus.depth[j]);
        o.width = 0.5*(minus.width + plus.width);
        o.normal = normal;
        if (normal.crossing > 0)
        {
            o.normal.minusEdge =
                (normal.minusEdge + minus.size - i) % minus.size;
            o.normal.plusEdge = (normal.plusEdge + plus.size - j) % plus.size;
        }
        overlaps.append(o);
        return overlaps.size() - 1 - first;
    };

    const auto finish = [&]
    {
        for (label k = first; joined && k < overlaps.size(); ++k)
        {
            // At edges areas are projected on the normal
            const scalar share = 1 - normal.mean();
            overlaps[k].minus.area *= 1 - share*(1 - (minus.n & n));
            overlaps[k].plus.area *= 1 - share*(1 + (plus.n & n));
            overlaps[k].motion = moving[k - first].motion(u, w);
            if (nDim < 3) continue;
            overlaps[k].edges = moving[k - first].outline();
            overlaps[k].u = u;
            overlaps[k].w = w;
        }
    };

    if (nDim == 3)
    {
        FixedList<facePart, 8> partsA, partsB;
        const label nA = a.parts(partsA, 0), nB = b.parts(partsB, 1);
        for (label i = 0; i < nA; ++i)
        {
            const facePart& pa = partsA[i];
            const scalar sa = pa.doubled;
            for (label j = 0; j < nB; ++j)
            {
                const facePart& pb = partsB[j];
                if (pa.misses(pb)) continue;
                const scalar sb = pb.doubled;
                const convexPolygon common(clipped(pa.shape, pb.shape, onLine));
                const scalar s = common.size > 2 ? doubleArea(common) : 0;
                if (s > sliver*min(sa, sb) && min(sa, sb) > 0)
                {
                    const vector2D at(centroid(common));
                    const label k = add
                    (
                        pa.corner, pb.corner,
                        stencil(a, pa.corner, at, s/sa, pa.area),
                        stencil(b, pb.corner, at, s/sb, pb.area)
                    );
                    if (joined) moving[k].addPiece(common, s, at, a.centre);
                }
            }
        }
        finish();
        return;
    }

    for (label i = 0; i < minus.size; ++i)
    {
        for (label j = 0; j < plus.size; ++j)
        {
            // Ends of the parts, the same point in 1D
            const scalar a0 = a.x[i].x(), a1 = a.centre.x();
            const scalar b0 = b.x[j].x(), b1 = b.centre.x();
            const scalar from = max(min(a0, a1), min(b0, b1));
            const scalar to = min(max(a0, a1), max(b0, b1));
            const scalar la = mag(a1 - a0), lb = mag(b1 - b0);
            const vector2D at(0.5*(from + to), 0);
            if (nDim == 1)
            {
                add
                (
                    i, j, stencil(a, i, at, 1, minus.area[i]),
                    stencil(b, j, at, 1, plus.area[j])
                );
            }
            else if (to - from > sliver*min(la, lb) && min(la, lb) > 0)
            {
                const scalar sa = (to - from)/la, sb = (to - from)/lb;
                const label k = add
                (
                    i, j, stencil(a, i, at, sa, minus.area[i]),
                    stencil(b, j, at, sb, plus.area[j])
                );
                // Share by which an end of the overlap follows the plus side
                const auto follows = [&](const bool upper)
                {
                    const bool nodeA = (a0 > a1) == upper;
                    const bool nodeB = (b0 > b1) == upper;
                    const scalar ofA = nodeA && minus.rim[i] ? 0 : 0.5;
                    const scalar ofB = nodeB && plus.rim[j] ? 1 : 0.5;
                    const scalar ahead =
                        (upper ? 1 : -1)
                       *((nodeA ? a0 : a1) - (nodeB ? b0 : b1));
                    return
                        mag(ahead) < onLine*min(la, lb) ? together(ofA, ofB)
                      : ahead > 0 ? ofB : ofA;
                };
                const scalar half = 0.5*(to - from);
                movingArea& m = moving[k];
                m.area = to - from;
                overlaps[first + k].half = half*u;
                m.addEdge(vector2D(half, 0), vector2D(1, 0), follows(true));
                m.addEdge(vector2D(-half, 0), vector2D(-1, 0), follows(false));
            }
        }
    }
    if (nDim == 2) finish();
}


// ************************************************************************* //
