/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactOverlap.H"
#include "vector2D.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Convex polygon in the plane across n, with room for two clipped quads
struct polygon
{
    label size = 0;
    FixedList<vector2D, 12> p;

    void append(const vector2D& q) { p[size++] = q; }
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

//- Sutherland-Hodgman: the part of a polygon inside a convex one, which turns
//  to the left
polygon clipped(polygon subject, const polygon& window)
{
    for (label e = 0; e < window.size && subject.size > 2; ++e)
    {
        const vector2D from(window.p[e]);
        const vector2D along(window.p[(e + 1) % window.size] - from);

        polygon rest;
        for (label i = 0; i < subject.size; ++i)
        {
            const vector2D a(subject.p[i]);
            const vector2D b(subject.p[(i + 1) % subject.size]);
            const scalar sa = cross(along, a - from);
            const scalar sb = cross(along, b - from);
            if (sa >= 0) rest.append(a);
            if ((sa > 0 && sb < 0) || (sa < 0 && sb > 0))
            {
                rest.append(a + sa/(sa - sb)*(b - a));
            }
        }
        subject = rest;
    }
    return subject;
}

//- Nodes of a face in the plane across n: coordinates u, w (2D: u only)
struct projection
{
    vector2D x[4];
    vector2D centre;
    label size;

    projection(const contactFace& f, const vector& u, const vector& w)
    :
        centre(Zero),
        size(f.size)
    {
        for (label i = 0; i < size; ++i)
        {
            x[i] = vector2D(f.x[i] & u, f.x[i] & w);
            centre += x[i]/size;
        }
    }

    //- Part of a corner, turned to the left
    polygon corner(const label k) const
    {
        polygon g;
        g.append(x[k]);
        g.append(0.5*(x[k] + x[(k + 1) % size]));
        g.append(centre);
        g.append(0.5*(x[k] + x[(k + size - 1) % size]));
        if (doubleArea(g) < 0)
        {
            Swap(g.p[1], g.p[3]);
        }
        return g;
    }

    //- Weights of the nodes at a point: the smallest that are exact for linear
    //  fields
    FixedList<scalar, 4> weights(const vector2D& at, const label nDim) const
    {
        FixedList<scalar, 4> N(scalar(0));
        scalar uu = 0, uw = 0, ww = 0;
        for (label i = 0; i < size; ++i)
        {
            const vector2D r(x[i] - centre);
            uu += r.x()*r.x();
            uw += r.x()*r.y();
            ww += r.y()*r.y();
        }

        const vector2D r(at - centre);
        vector2D s(Zero);
        if (nDim == 3)
        {
            const scalar det = uu*ww - uw*uw;
            s =
                vector2D(ww*r.x() - uw*r.y(), uu*r.y() - uw*r.x())
               /max(det, VSMALL);
        }
        else if (nDim == 2)
        {
            s.x() = r.x()/max(uu, VSMALL);
        }

        for (label i = 0; i < size; ++i)
        {
            N[i] = scalar(1)/size + ((x[i] - centre) & s);
        }
        return N;
    }
};

contactStencil stencil
(
    const contactFace& f,
    const projection& p,
    const label corner,
    const vector2D& at,
    const label nDim,
    const scalar share
)
{
    const FixedList<scalar, 4> N(p.weights(at, nDim));

    contactStencil s;
    s.size = f.size;
    for (label j = 0; j < f.size; ++j)
    {
        const label k = (corner + j) % f.size;
        s.corner[j] = f.firstCorner + k;
        s.value[j] = N[k];
        s.flux[j] = (N[k] - f.smoothing)/(1 - f.size*f.smoothing);
    }
    s.share = share;
    s.area = share*f.area[corner];
    return s;
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


void Foam::contactOverlaps::append
(
    const contactFace& minus,
    const contactFace& plus,
    const vector& n,
    const vector& outOfPlane,
    const label nDim,
    DynamicList<contactOverlap>& overlaps
)
{
    // Slivers are left out, by share of the smaller part
    constexpr scalar sliver = 1e-8;

    vector u(Zero), w(Zero);
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
    const projection a(minus, u, w), b(plus, u, w);

    const auto add = [&]
    (
        const label i,
        const label j,
        const vector2D& at,
        const scalar shareMinus,
        const scalar sharePlus
    )
    {
        contactOverlap o;
        o.minus = stencil(minus, a, i, at, nDim, shareMinus);
        o.plus = stencil(plus, b, j, at, nDim, sharePlus);
        o.depth = min(minus.depth[i], plus.depth[j]);
        o.width = 0.5*(minus.width + plus.width);
        overlaps.append(o);
    };

    for (label i = 0; i < minus.size; ++i)
    {
        for (label j = 0; j < plus.size; ++j)
        {
            if (nDim == 1)
            {
                add(i, j, vector2D::zero, 1, 1);
            }
            else if (nDim == 2)
            {
                const scalar a0 = a.x[i].x(), a1 = a.centre.x();
                const scalar b0 = b.x[j].x(), b1 = b.centre.x();
                const scalar from = max(min(a0, a1), min(b0, b1));
                const scalar to = min(max(a0, a1), max(b0, b1));
                const scalar la = mag(a1 - a0), lb = mag(b1 - b0);
                if (to - from > sliver*min(la, lb) && min(la, lb) > 0)
                {
                    add
                    (
                        i, j, vector2D(0.5*(from + to), 0),
                        (to - from)/la, (to - from)/lb
                    );
                }
            }
            else
            {
                const polygon pa(a.corner(i)), pb(b.corner(j));
                const polygon common(clipped(pa, pb));
                const scalar sa = doubleArea(pa), sb = doubleArea(pb);
                const scalar s = common.size > 2 ? doubleArea(common) : 0;
                if (s > sliver*min(sa, sb) && min(sa, sb) > 0)
                {
                    add(i, j, centroid(common), s/sa, s/sb);
                }
            }
        }
    }
}


// ************************************************************************* //
