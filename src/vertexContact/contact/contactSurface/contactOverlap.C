/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactOverlap.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Convex polygon in the plane across n, with room for two clipped quads
struct polygon
{
    label size = 0;
    FixedList<vector2D, 12> p;

    //- By which the edge from there to the next point follows the plus side:
    //  half, but for rims (overlapMotion)
    FixedList<scalar, 12> follows;

    void append(const vector2D& q, const scalar share = 0.5)
    {
        p[size] = q;
        follows[size++] = share;
    }

    void turnAround()
    {
        for (label i = 1; i < size - i; ++i) Swap(p[i], p[size - i]);
        for (label i = 0; i < size - 1 - i; ++i)
        {
            Swap(follows[i], follows[size - 1 - i]);
        }
    }
};

scalar cross(const vector2D& a, const vector2D& b)
{
    return a.x()*b.y() - a.y()*b.x();
}

//- Twice the signed area
scalar doubleArea(const polygon& g)
{
    scalar sum = 0;
    for (label i = 1; i + 1 < g.size; ++i)
    {
        sum += cross(g.p[i] - g.p[0], g.p[i + 1] - g.p[0]);
    }
    return sum;
}

vector2D centroid(const polygon& g)
{
    scalar sum = 0;
    vector2D moment(Zero);
    for (label i = 1; i + 1 < g.size; ++i)
    {
        const scalar a = cross(g.p[i] - g.p[0], g.p[i + 1] - g.p[0]);
        sum += a;
        moment += a/3*(g.p[0] + g.p[i] + g.p[i + 1]);
    }
    return moment/sum;
}

//- Of edges of both sides on one line: a rim counts, a cut does not
scalar together(const scalar a, const scalar b)
{
    return a + b - 0.5;
}

//- Sutherland-Hodgman: the part of a polygon inside a convex one, which turns
//  to the left.
//  \param onLine  what is no further off an edge, by its length, is on it
polygon clipped(polygon subject, const polygon& window, const scalar onLine)
{
    for (label e = 0; e < window.size && subject.size > 2; ++e)
    {
        const vector2D from(window.p[e]);
        const vector2D along(window.p[(e + 1) % window.size] - from);
        const scalar onIt = onLine*magSqr(along);
        const auto side = [&](const vector2D& at)
        {
            const scalar s = cross(along, at - from);
            return mag(s) < onIt ? 0 : s;
        };

        polygon rest;
        for (label i = 0; i < subject.size; ++i)
        {
            const vector2D a(subject.p[i]);
            const vector2D b(subject.p[(i + 1) % subject.size]);
            const scalar sa = side(a), sb = side(b);
            const scalar edge = window.follows[e];
            const scalar share =
                sa == 0 && sb == 0
              ? together(subject.follows[i], edge) : subject.follows[i];
            if (sa >= 0) rest.append(a, sa == 0 && sb < 0 ? edge : share);
            if ((sa > 0 && sb < 0) || (sa < 0 && sb > 0))
            {
                rest.append(a + sa/(sa - sb)*(b - a), sb < 0 ? edge : share);
            }
        }
        subject = rest;
    }
    return subject;
}

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
        const polygon& g,
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
                0.5*(a + b) - origin, vector2D(d.y(), -d.x()), g.follows[i]
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
            // There is one direction only
            m.drift = cu.x()*tensor::I;
            return m;
        }
        // Surfaces that turn have a way across the plane, too: half of it, as
        // either side sees it
        const vector n(u ^ w);
        m.drift =
            u*(cu.x()*u + cu.y()*w) + w*(cw.x()*u + cw.y()*w) + 0.5*n*n;
        return m;
    }
};

//- Part of a corner in the plane across n, turned to the left, and its
//  reference area
struct facePart
{
    polygon shape;
    label corner;
    scalar area;

    //- Twice its area, and its box, in the plane
    scalar doubled;
    vector2D least;
    vector2D most;

    void measure()
    {
        doubled = doubleArea(shape);
        least = most = shape.p[0];
        for (label i = 1; i < shape.size; ++i)
        {
            least = min(least, shape.p[i]);
            most = max(most, shape.p[i]);
        }
    }

    bool misses(const facePart& other) const
    {
        return
            least.x() > other.most.x() || most.x() < other.least.x()
         || least.y() > other.most.y() || most.y() < other.least.y();
    }
};

//- Nodes of a face in the plane across n: coordinates u, w (2D: u only)
struct projection
{
    const contactFace& face;
    vector2D x[4];
    vector2D centre;
    label size;

    projection(const contactFace& f, const vector& u, const vector& w)
    :
        face(f),
        centre(Zero),
        size(f.size)
    {
        for (label i = 0; i < size; ++i)
        {
            x[i] = vector2D(f.x[i] & u, f.x[i] & w);
            centre += x[i]/size;
        }
    }

    //- All of it in 3D, turned to the left.
    //  \param ofEnds  what edges that end the body are marked with
    polygon whole(const scalar ofEnds = 0.5) const
    {
        polygon all;
        for (label i = 0; i < size; ++i)
        {
            all.append(x[i], face.ends[i] ? ofEnds : scalar(0.5));
        }
        if (doubleArea(all) < 0) all.turnAround();
        return all;
    }

    //- Unit normal into the face of the edge from a node to the next, in 2D of
    //  the node
    vector2D inward(const label i) const
    {
        const vector2D along(x[(i + 1) % size] - x[i]);
        if (size == 2) return along/max(mag(along), VSMALL);
        const scalar side = cross(along, centre - x[i]) < 0 ? -1 : 1;
        return side/max(mag(along), VSMALL)*vector2D(-along.y(), along.x());
    }

    //- How far a point is inside that edge
    scalar within(const label i, const vector2D& at) const
    {
        return (at - x[i]) & inward(i);
    }

    bool contains(const vector2D& at) const
    {
        for (label i = 0; i < size; ++i) if (within(i, at) < 0) return false;
        return true;
    }

    //- How far a point of the face is from the nearest end of the body there
    scalar fromEnd(const vector2D& at) const
    {
        scalar least = GREAT;
        for (label i = 0; i < size; ++i)
        {
            if (face.ends[i]) least = min(least, max(within(i, at), scalar(0)));
        }
        return least;
    }

    //- Of a point of the face, whether the surface ends there in a direction
    bool endsAt(const vector2D& at, const vector2D& direction) const
    {
        bool ends = false;
        for (label i = 0; i < size; ++i)
        {
            const scalar length = mag(x[(i + 1) % size] - x[i]);
            const bool on =
                mag(within(i, at)) < contactOverlaps::alongEdge*length;
            const bool across =
                (inward(i) & direction) < -contactOverlaps::alongEdge;
            if (!on || !across) continue;
            if (!face.ends[i]) return false;
            ends = true;
        }
        return ends;
    }

    //- The point of the face above one of the plane
    Foam::point above(const vector2D& at) const
    {
        const FixedList<scalar, 4> N(weights(at));
        Foam::point sum(Zero);
        for (label i = 0; i < size; ++i) sum += N[i]*face.x[i];
        return sum;
    }

    //- Parts of all corners of a face in 3D; returns their number.
    //  \param follows  share by which its rim follows the plus side
    label parts(FixedList<facePart, 8>& all, const scalar follows) const
    {
        const FixedList<point, 4>& X = face.X;
        label n = 0;
        scalar sum = 0;

        const auto add = [&]
        (
            const label k,
            const label a,
            const label b,
            const vector2D& middle,
            const point& reference
        )
        {
            const auto edgeWith = [&](const label other)
            {
                const label from = other == (k + 1) % size ? k : other;
                return face.rim[from] ? follows : scalar(0.5);
            };
            facePart& p = all[n++];
            p.corner = k;
            p.shape.size = 0;
            p.shape.append(x[k], edgeWith(a));
            p.shape.append(0.5*(x[k] + x[a]));
            p.shape.append(middle);
            vector diagonal(0.5*(X[k] + X[a]) - X[k]);
            if (b >= 0)
            {
                p.shape.append(0.5*(x[k] + x[b]), edgeWith(b));
                diagonal = 0.5*(X[a] - X[b]);
            }
            p.area = 0.5*mag((reference - X[k]) ^ diagonal);
            sum += p.area;
            if (doubleArea(p.shape) < 0) p.shape.turnAround();
        };

        if (size == 3)
        {
            const point c((X[0] + X[1] + X[2])/3);
            for (label k = 0; k < 3; ++k)
            {
                add(k, (k + 1) % 3, (k + 2) % 3, centre, c);
            }
        }
        else
        {
            const scalar s = face.crossing;
            const vector2D middle((1 - s)*x[0] + s*x[2]);
            const point c((1 - s)*X[0] + s*X[2]);
            for (label k = 0; k < 4; ++k)
            {
                add(k, (k + 1) % 4, -1, middle, c);
                add(k, (k + 3) % 4, -1, middle, c);
            }
        }

        // Warped faces: the areas of the dual
        scalar area = 0;
        for (label k = 0; k < size; ++k) area += face.area[k];
        for (label i = 0; i < n; ++i)
        {
            all[i].area *= area/sum;
            all[i].measure();
        }
        return n;
    }

    //- Add barycentric coordinates in the triangle of nodes i, j, k
    void addTriangle
    (
        const label i,
        const label j,
        const label k,
        const vector2D& at,
        const scalar factor,
        FixedList<scalar, 4>& N
    ) const
    {
        const scalar area = cross(x[j] - x[i], x[k] - x[i]);
        const scalar perArea = factor/(mag(area) > VSMALL ? area : VSMALL);
        N[i] += perArea*cross(x[j] - at, x[k] - at);
        N[j] += perArea*cross(x[k] - at, x[i] - at);
        N[k] += perArea*cross(x[i] - at, x[j] - at);
    }

    //- Add those in the triangle of the split along i, k that has the point
    void addSplit
    (
        const label i,
        const label j,
        const label k,
        const label l,
        const vector2D& at,
        const scalar factor,
        FixedList<scalar, 4>& N
    ) const
    {
        const vector2D along(x[k] - x[i]);
        if (cross(along, x[l] - x[i])*cross(along, at - x[i]) > 0)
        {
            addTriangle(i, k, l, at, factor, N);
        }
        else
        {
            addTriangle(i, j, k, at, factor, N);
        }
    }

    //- Weights of the nodes at a point
    FixedList<scalar, 4> weights(const vector2D& at) const
    {
        FixedList<scalar, 4> N(scalar(0));
        switch (size)
        {
            case 4:
                addSplit(0, 1, 2, 3, at, face.split, N);
                addSplit(1, 2, 3, 0, at, 1 - face.split, N);
                break;
            case 3:
                addTriangle(0, 1, 2, at, 1, N);
                break;
            case 2:
                N[1] = (at.x() - x[0].x())/(x[1].x() - x[0].x());
                N[0] = 1 - N[1];
                break;
            default:
                N[0] = 1;
        }
        return N;
    }
};

//- What a face has in an overlap at a point of a corner's part.
//  \param share  of the part
//  \param area   reference area of the part
contactStencil stencil
(
    const projection& p,
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

//- The body ends at some of a face's edges
bool ends(const contactFace& f)
{
    for (const bool is : f.ends) if (is) return true;
    return false;
}

//- Directions of the plane across n, in 2D one, in 1D none
void alongPlane
(
    const vector& n,
    const vector& outOfPlane,
    const label nDim,
    vector& u,
    vector& w
)
{
    u = w = Zero;
    if (nDim == 3)
    {
        const direction least =
            mag(n.x()) < mag(n.y())
          ? (mag(n.x()) < mag(n.z()) ? 0 : 2)
          : (mag(n.y()) < mag(n.z()) ? 1 : 2);
        vector e(Zero);
        e[least] = 1;
        u = e ^ n;
        u /= mag(u);
        w = n ^ u;
    }
    else if (nDim == 2)
    {
        u = outOfPlane ^ n;
        u /= max(mag(u), VSMALL);
    }
}

//- Add what a side has in another piece of an overlap
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


Foam::overlapNormal Foam::contactOverlaps::normalOf
(
    const contactFace& minus,
    const contactFace& plus,
    const vector& outOfPlane,
    const label nDim,
    vector& n
)
{
    overlapNormal which;
    if (nDim == 1 || !(ends(minus) || ends(plus))) return which;

    vector u, w;
    alongPlane(n, outOfPlane, nDim, u, w);
    const projection a(minus, u, w), b(plus, u, w);

    // Which ends bound what both have in common, and how far they are from
    // those of the other
    const scalar half = 0.5*min(minus.width, plus.width);
    scalar minusOn = 0, plusOn = 0, minusOff = GREAT, plusOff = GREAT;
    const auto bounds = [&](const bool ofMinus, const vector2D& at)
    {
        scalar& off = ofMinus ? minusOff : plusOff;
        off = min(off, (ofMinus ? b : a).fromEnd(at));
        (ofMinus ? minusOn : plusOn) = min(scalar(1), sqr(off/half));
    };
    if (nDim == 2)
    {
        for (label i = 0; i < 2; ++i)
        {
            if (minus.ends[i] && b.contains(a.x[i])) bounds(true, a.x[i]);
            if (plus.ends[i] && a.contains(b.x[i])) bounds(false, b.x[i]);
        }
    }
    else
    {
        const polygon common(clipped(a.whole(0), b.whole(1), alongEdge));
        for (label i = 0; i < common.size; ++i)
        {
            if (common.follows[i] == 0.5) continue;
            const bool ofMinus = common.follows[i] == 0;
            bounds(ofMinus, common.p[i]);
            bounds(ofMinus, common.p[(i + 1) % common.size]);
        }
    }
    which.minus = 1 - minusOn*(1 - plusOn);
    which.plus = 1 - plusOn*(1 - minusOn);
    n = which.minus*minus.n - which.plus*plus.n;
    n /= mag(n);
    if (nDim < 3 || !(ends(minus) && ends(plus))) return which;

    // The edges that are the nearest to each other, as far as others are not
    scalar second = 0;
    const auto edge = [](const contactFace& f, const label i)
    {
        return f.x[(i + 1) % f.size] - f.x[i];
    };
    const auto share = [](const scalar s)
    {
        return min(max(s, scalar(0)), scalar(1));
    };
    for (label i = 0; i < minus.size; ++i)
    {
        const vector d(edge(minus, i));
        for (label j = 0; minus.ends[i] && j < plus.size; ++j)
        {
            // Shares of both edges where they are the nearest to each other
            const vector e(edge(plus, j));
            const scalar sine = magSqr(d ^ e)/(magSqr(d)*magSqr(e));
            if (!plus.ends[j] || sine < SMALL) continue;
            const vector r(plus.x[j] - minus.x[i]);
            const scalar perArea = 1/magSqr(d ^ e);
            const scalar s = share
            (
                perArea*((e & e)*(d & r) - (d & e)*(e & r))
            );
            const scalar t = share
            (
                perArea*((d & e)*(d & r) - (d & d)*(e & r))
            );
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
    if (which.crossing > 0)
    {
        const vector d(edge(minus, which.minusEdge));
        const vector e(edge(plus, which.plusEdge));
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
    const vector& n,
    const vector& outOfPlane,
    const label nDim
)
{
    if (nDim == 1) return false;
    if (!ends(minus) || !ends(plus)) return false;

    vector u, w;
    alongPlane(n, outOfPlane, nDim, u, w);
    const projection a(minus, u, w), b(plus, u, w);

    // What the faces have in common
    polygon common;
    if (nDim == 2)
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
    if (inside <= 0) return false;

    // The least way of one of them out over a rim of the other
    scalar least = GREAT;
    const auto leave = [&](const projection& over, const projection& other)
    {
        for (label i = 0; i < over.size; ++i)
        {
            if (!over.face.ends[i]) continue;
            scalar furthest = 0;
            label which = -1;
            for (label k = 0; k < common.size; ++k)
            {
                const scalar way = over.within(i, common.p[k]);
                if (way > furthest)
                {
                    furthest = way;
                    which = k;
                }
            }
            if
            (
                which >= 0
             && other.endsAt(common.p[which], over.inward(i))
            )
            {
                least = min(least, furthest);
            }
        }
    };
    leave(a, b);
    leave(b, a);
    return inside > least;
}


void Foam::contactOverlaps::append
(
    const contactFace& minus,
    const contactFace& plus,
    const vector& n,
    const overlapNormal& normal,
    const vector& outOfPlane,
    const label nDim,
    const bool joined,
    DynamicList<contactOverlap>& overlaps
)
{
    const scalar onLine = joined ? alongEdge : 0;

    vector u, w;
    alongPlane(n, outOfPlane, nDim, u, w);
    const projection a(minus, u, w), b(plus, u, w);

    const label first = overlaps.size();
    FixedList<movingArea, 16> moving;

    // Returns which of the overlaps of these faces it is part of
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
            // As seen along the normal
            overlaps[k].minus.area *= minus.n & n;
            overlaps[k].plus.area *= -(plus.n & n);
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
                const polygon common(clipped(pa.shape, pb.shape, onLine));
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
                // Of the ends of both parts, which is that of the overlap
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
