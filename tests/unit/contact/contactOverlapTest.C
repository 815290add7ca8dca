/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Overlaps of two faces: areas, linear values, and fluxes that give the
    corners of the dual their loads.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "contactOverlap.H"
#include "overlapShape.H"
#include <array>
#include <map>

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

//- A face in the plane z, with the areas and weights of the dual: triangles,
//  or quadrilaterals with the mean of both splits
contactFace faceOf
(
    const std::vector<point>& x,
    const label firstCorner,
    const vector& n
)
{
    contactFace f;
    f.size = x.size();
    f.firstCorner = firstCorner;
    f.n = f.N = n;
    scalar s[4][4] = {};
    const auto triangle = [&](label i, label j, label k, scalar share)
    {
        const scalar area =
            share*0.5*mag((x[j] - x[i]) ^ (x[k] - x[i]));
        for (const label p : {i, j, k})
        {
            for (const label q : {i, j, k})
            {
                s[p][q] += area/3*(p == q ? 6 : 1)/8.0;
            }
        }
    };
    if (f.size == 3)
    {
        triangle(0, 1, 2, 1);
    }
    else
    {
        triangle(0, 1, 2, 0.5);
        triangle(0, 2, 3, 0.5);
        triangle(1, 2, 3, 0.5);
        triangle(1, 3, 0, 0.5);
    }

    // Inverse by Gauss-Jordan, s is diagonally dominant
    const label n4 = f.size;
    scalar inverse[4][4] = {};
    for (label i = 0; i < n4; ++i)
    {
        f.x[i] = f.X[i] = x[i];
        f.depth[i] = 1;
        for (label j = 0; j < n4; ++j) f.area[i] += s[i][j];
        inverse[i][i] = 1;
    }
    for (label i = 0; i < n4; ++i)
    {
        const scalar pivot = s[i][i];
        for (label j = 0; j < n4; ++j)
        {
            s[i][j] /= pivot;
            inverse[i][j] /= pivot;
        }
        for (label k = 0; k < n4; ++k)
        {
            const scalar factor = s[k][i];
            for (label j = 0; j < n4 && k != i; ++j)
            {
                s[k][j] -= factor*s[i][j];
                inverse[k][j] -= factor*inverse[i][j];
            }
        }
    }
    for (label i = 0; i < n4; ++i)
    {
        for (label j = 0; j < n4; ++j)
        {
            f.spread[4*i + j] = f.area[i]*inverse[i][j];
        }
    }
    if (f.size == 4)
    {
        const vector d02(x[2] - x[0]), d13(x[3] - x[1]), both(d02 ^ d13);
        const vector d01(x[1] - x[0]);
        f.crossings[0] = ((d01 ^ d13) & both)/magSqr(both);
        f.crossings[1] = ((d01 ^ d02) & both)/magSqr(both);
    }
    f.width = 1;
    return f;
}

const vector up(0, 0, 1);

DynamicList<contactOverlap> overlapsOf
(
    const contactFace& a,
    const contactFace& b,
    const bool joined = false
)
{
    DynamicList<contactOverlap> overlaps;
    contactOverlaps::append
    (
        a, b, up, overlapNormal(), joined, overlaps
    );
    return overlaps;
}

const std::vector<point> kite
({
    point(0, 0, 0), point(1.2, 0.1, 0), point(0.9, 1.1, 0), point(0.1, 0.8, 0)
});
const std::vector<point> around
({
    point(-3, -3, 0.1), point(-2, 6, 0.1), point(6, -2, 0.1)
});

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Overlaps cover a face inside another one", "[contact]")
{
    const contactFace small(faceOf(kite, 0, up));
    const contactFace large(faceOf(around, 4, -up));

    for (const bool swapped : {false, true})
    {
        const auto overlaps =
            swapped ? overlapsOf(large, small) : overlapsOf(small, large);
        scalar minus = 0, plus = 0, area = 0;
        FixedList<scalar, 4> load(scalar(0));
        for (const contactOverlap& o : overlaps)
        {
            minus += o.minus.area;
            plus += o.plus.area;
            const contactStencil& s = swapped ? o.plus : o.minus;
            for (label j = 0; j < s.size; ++j)
            {
                load[s.corner[j]] += s.flux[j]*s.area;
            }
        }
        for (label i = 0; i < 4; ++i) area += small.area[i];

        REQUIRE(minus == Approx(area).epsilon(1e-12));
        REQUIRE(plus == Approx(area).epsilon(1e-12));

        // Uniform pressure: each corner the load of its area
        for (label i = 0; i < 4; ++i)
        {
            REQUIRE(load[i] == Approx(small.area[i]).epsilon(1e-12));
        }
    }
}


TEST_CASE("What is pressed does not depend on how it is divided", "[contact]")
{
    // Corners of a unit square, all in one corner of a large face; turned
    const scalar angle = GENERATE(0.0, 0.4);
    const scalar c = std::cos(angle), s = std::sin(angle);
    const tensor R(c, -s, 0, s, c, 0, 0, 0, 1);
    const auto turned = [&](std::vector<point> x)
    {
        for (point& p : x) p = R & p;
        return x;
    };
    const contactFace square
    (
        faceOf(turned({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 0, up)
    );
    const contactFace large
    (
        faceOf
        (
            turned
            ({
                {-1, -1, 0.1}, {-1, 10, 0.1}, {10, 10, 0.1}, {10, -1, 0.1}
            }),
            4, -up
        )
    );
    const auto quarters = overlapsOf(square, large, true);
    REQUIRE(quarters.size() == 4);

    // Negative in a triangle at the first corner, or in all but one at the last
    const scalar zero = GENERATE(0.3, 0.5, 0.9, 1.2, 1.7);
    const vector grows(R & vector(1, 1, 0));
    const scalar rest = 2 - zero;
    const scalar area = zero < 1 ? 0.5*sqr(zero) : 1 - 0.5*sqr(rest);
    const scalar middle =
        zero < 1 ? zero/3 : (0.5 - 0.5*sqr(rest)*(1 - rest/3))/area;

    scalar sum = 0;
    vector moment(Zero);
    for (const contactOverlap& o : quarters)
    {
        vector centroid(Zero);
        for (label k = 0; k < o.minus.size; ++k)
        {
            centroid += o.minus.value[k]*square.x[o.minus.corner[k]];
        }
        typedef overlapFunction::vectorType vectorType;
        const auto all = [](const vector& a)
        {
            return vectorType
            {
                uniform<lanes>(a.x()), uniform<lanes>(a.y()),
                uniform<lanes>(a.z())
            };
        };
        overlapPolygon shape;
        for (int l = 0; l < nLanes; ++l) shape.set(l, o, o.edges.cdata());
        vectorType way;
        const lanes share = shape.negative
        (
            overlapFunction
            {
                uniform<lanes>((grows & centroid) - zero), all(grows),
                all(vector::zero), uniform<lanes>(1), uniform<lanes>(1)
            },
            way
        );
        // All of it, whatever the sign, where it does not change
        const bool any =
            share[0] < 1 || (grows & centroid) < zero;
        if (!any) continue;
        sum += 0.25*share[0];
        moment +=
            0.25*share[0]
           *(centroid + vector(way[0][0], way[1][0], way[2][0]));
    }
    REQUIRE(sum == Approx(area).epsilon(1e-12));
    moment = R.T() & moment;
    REQUIRE(moment.x() == Approx(area*middle).epsilon(1e-12));
    REQUIRE(moment.y() == Approx(area*middle).epsilon(1e-12));
}


TEST_CASE("Faces that got inside each other past their rims", "[contact]")
{
    // The minus side is above the plus side by 0.3, and over it by a strip
    const scalar strip = GENERATE(0.1, 0.29, 0.31, 0.8);
    const scalar high = GENERATE(0.3, -0.3);
    const auto squareAt = [](const scalar x, const scalar z, const vector& n)
    {
        contactFace f
        (
            faceOf
            (
                {{x, 0, z}, {x + 1, 0, z}, {x + 1, 1, z}, {x, 1, z}}, 0, n
            )
        );
        f.ends = FixedList<bool, 4>(true);
        return f;
    };
    contactFace minus(squareAt(0, high, up));
    const contactFace plus(squareAt(1 - strip, 0, -up));
    const auto beside = [&](const contactFace& a, const contactFace& b)
    {
        return contactOverlaps::beside(a, b, up);
    };
    REQUIRE(beside(minus, plus) == (high > 0 && strip < 0.3));

    // Which goes on beyond the strip
    minus.ends[1] = false;
    REQUIRE_FALSE(beside(minus, plus));

    // In 2D, of lines
    const auto lineAt = [](const scalar x, const scalar y, const vector& n)
    {
        contactFace f;
        f.size = 2;
        f.n = f.N = n;
        f.out = vector(0, 0, 1);
        f.x[0] = f.X[0] = point(x, y, 0);
        f.x[1] = f.X[1] = point(x + 1, y, 0);
        f.depth = 1;
        f.ends[0] = f.ends[1] = true;
        return f;
    };
    const vector upwards(0, 1, 0);
    REQUIRE
    (
        contactOverlaps::beside
        (
            lineAt(0, high, upwards), lineAt(1 - strip, 0, -upwards), upwards
        ) == (high > 0 && strip < 0.3)
    );
}


TEST_CASE("Values at overlaps are exact for linear fields", "[contact]")
{
    const contactFace a(faceOf(kite, 0, up)), b(faceOf(around, 0, -up));

    for (const contactOverlap& o : overlapsOf(a, b))
    {
        point xa(Zero), xb(Zero);
        scalar sumA = 0, sumB = 0, fluxA = 0, fluxB = 0;
        for (label j = 0; j < o.minus.size; ++j)
        {
            xa += o.minus.value[j]*a.x[o.minus.corner[j]];
            sumA += o.minus.value[j];
            fluxA += o.minus.flux[j];
        }
        for (label j = 0; j < o.plus.size; ++j)
        {
            xb += o.plus.value[j]*b.x[o.plus.corner[j]];
            sumB += o.plus.value[j];
            fluxB += o.plus.flux[j];
        }
        REQUIRE(sumA == Approx(1).epsilon(1e-13));
        REQUIRE(sumB == Approx(1).epsilon(1e-13));

        // Both sides see the same point, apart by the gap
        REQUIRE(mag(xb - xa - 0.1*up) < 1e-12);

        // No force is lost
        REQUIRE(fluxA == Approx(1).epsilon(1e-12));
        REQUIRE(fluxB == Approx(1).epsilon(1e-12));
    }
}


TEST_CASE("Faces apart have no overlap", "[contact]")
{
    std::vector<point> aside(around);
    for (point& p : aside) p += vector(20, 0, 0);

    REQUIRE
    (
        overlapsOf(faceOf(kite, 0, up), faceOf(aside, 4, -up)).empty()
    );
}


TEST_CASE("Joined, two corners have one overlap with the sums of its pieces")
{
    std::vector<point> moved(kite.rbegin(), kite.rend());
    for (point& x : moved) x += vector(0.15, -0.1, 0.1);
    const contactFace a(faceOf(kite, 0, up)), b(faceOf(moved, 4, -up));

    // By the corners of either side: areas, and those times the weights
    std::map<std::pair<label, label>, std::array<scalar, 18>> sums[2];
    for (const bool joined : {false, true})
    {
        const DynamicList<contactOverlap> overlaps(overlapsOf(a, b, joined));
        for (const contactOverlap& o : overlaps)
        {
            auto& sum =
                sums[joined][{o.minus.corner[0], o.plus.corner[0]}];
            scalar* s = sum.data();
            for (const contactStencil* side : {&o.minus, &o.plus})
            {
                *s++ += side->area;
                for (label j = 0; j < 4; ++j)
                {
                    *s++ += side->area*side->value[j];
                    *s++ += side->area*side->flux[j];
                }
            }
        }
        if (joined) CHECK(overlaps.size() == label(sums[1].size()));
        else CHECK(overlaps.size() > 2*label(sums[0].size()));
    }
    REQUIRE(sums[0].size() == sums[1].size());
    for (const auto& pair : sums[0])
    {
        for (int i = 0; i < 18; ++i)
        {
            CHECK
            (
                pair.second[i] == Approx(sums[1][pair.first][i]).margin(1e-14)
            );
        }
    }
}


TEST_CASE("Overlaps move with the rims that bound them")
{
    std::vector<point> other(kite.rbegin(), kite.rend());
    for (point& x : other) x += vector(0.15, -0.1, 0.1);
    const std::vector<point> triangle
    ({
        point(-0.2, 0.3, 0.1), point(0.7, 1.3, 0.1), point(0.8, 0.2, 0.1)
    });

    // What all overlaps of two faces have in common has no other edges
    for (const std::vector<point>& plus : {other, triangle, around})
    {
        const auto at = [&](const vector& way)
        {
            std::vector<point> moved(plus);
            for (point& x : moved) x += way;
            contactFace a(faceOf(kite, 0, up)), b(faceOf(moved, 4, -up));
            a.rim = true;
            b.rim = true;
            return overlapsOf(a, b, true);
        };
        const auto area = [](const contactOverlap& o, const label)
        {
            return o.minus.area;
        };
        const auto moment = [](const contactOverlap& o, const label i)
        {
            scalar c = 0;
            for (label j = 0; j < 4; ++j)
            {
                c += o.minus.value[j]*kite[o.minus.corner[j]][i];
            }
            return o.minus.area*c;
        };
        const auto start = at(vector::zero);
        REQUIRE(start.size() > 2);
        for (const vector& way : {vector(1e-6, 0, 0), vector(-3e-7, 8e-7, 0)})
        {
            const auto moved = at(way);
            const auto sum = [&](const auto& all, const auto& f, const label i)
            {
                scalar s = 0;
                for (const contactOverlap& o : all) s += f(o, i);
                return s;
            };
            scalar areaGrows = 0;
            vector momentGrows(Zero);
            for (const contactOverlap& o : start)
            {
                const scalar grows = o.minus.area*(o.motion.growth & way);
                areaGrows += grows;
                for (label i = 0; i < 2; ++i)
                {
                    momentGrows[i] +=
                        o.minus.area*(o.motion.drift & way)[i]
                      + grows/o.minus.area*moment(o, i);
                }
            }
            CHECK
            (
                sum(moved, area, 0) - sum(start, area, 0)
             == Approx(areaGrows).epsilon(1e-4).margin(1e-12)
            );
            for (label i = 0; i < 2; ++i)
            {
                CHECK
                (
                    sum(moved, moment, i) - sum(start, moment, i)
                 == Approx(momentGrows[i]).epsilon(1e-4).margin(1e-12)
                );
            }
        }
    }
}


TEST_CASE("Overlaps without a rim move by half, as those whose rims coincide")
{
    std::vector<point> other(kite.rbegin(), kite.rend());
    for (const bool rims : {false, true})
    {
        if (!rims) for (point& x : other) x += vector(0.15, -0.1, 0.1);
        contactFace a(faceOf(kite, 0, up)), b(faceOf(other, 4, -up));
        a.rim = rims;
        b.rim = rims;
        const auto overlaps = overlapsOf(a, b, true);
        REQUIRE(overlaps.size() >= 4);
        for (const contactOverlap& o : overlaps)
        {
            CHECK(mag(o.motion.growth) < 1e-9);
            CHECK(o.motion.drift.xx() == Approx(0.5));
            CHECK(o.motion.drift.yy() == Approx(0.5));
            CHECK(mag(o.motion.drift.xy()) < 1e-9);
            CHECK(mag(o.motion.drift.yx()) < 1e-9);
        }
        if (!rims) for (point& x : other) x -= vector(0.15, -0.1, 0.1);
    }
}


// ************************************************************************* //


// * * * * * * * * * * * * * * * Common normals * * * * * * * * * * * * * * * //

namespace
{

//- Unit square between its corner and those along u and w, all of whose edges
//  or the one from the corner along u end the body
contactFace square
(
    const point& from,
    const vector& u,
    const vector& w,
    const bool all = false
)
{
    const std::vector<point> x{from, from + u, from + u + w, from + w};
    contactFace f(faceOf(x, 0, (u ^ w)/mag(u ^ w)));
    for (label i = 0; i < 4; ++i) f.ends[i] = all || i == 0;
    return f;
}

vector normalOf
(
    const contactFace& minus,
    const contactFace& plus,
    overlapNormal& which
)
{
    vector n;
    REQUIRE(contactOverlaps::commonNormal(minus.n, plus.n, n));
    which = contactOverlaps::normalOf(minus, plus, n);
    CHECK(mag(n) == Approx(1));

    // The other side sees the same
    vector opposite;
    contactOverlaps::commonNormal(plus.n, minus.n, opposite);
    const overlapNormal its
    (
        contactOverlaps::normalOf(plus, minus, opposite)
    );
    CHECK(mag(n + opposite) < 1e-12);
    CHECK(its.minus == which.plus);
    CHECK(its.crossing == Approx(which.crossing).margin(1e-12));
    CHECK(its.minusEdge == which.plusEdge);
    return n;
}

} // End anonymous namespace


TEST_CASE("An edge that lies on a face has the normal of the face")
{
    // A roof, whose ridge is rolled: the face below sees it from there only
    const scalar slope = GENERATE(0.2, 1.0, 2.5);
    const contactFace above
    (
        square(point(0.3, 0.4, 0), vector(0, 1, 0), vector(1, 0, slope))
    );
    contactFace below
    (
        square(point(0, 0, 0), vector(1, 0, 0), vector(0, 1, 0))
    );
    below.ends = false;
    overlapNormal which;
    CHECK(mag(normalOf(below, above, which) - up) < 1e-12);
    CHECK(which.minus);
    CHECK_FALSE(which.plus);
    CHECK(which.crossing == 0);

    // Of two that do not end there, the mean
    contactFace inside(above);
    inside.ends = false;
    CHECK
    (
        mag
        (
            normalOf(below, inside, which)
          - (below.n - inside.n)/mag(below.n - inside.n)
        ) < 1e-12
    );
    CHECK((which.minus && which.plus));
}


TEST_CASE("An edge that is inside is on the face that it is behind")
{
    // A steep side that comes down at an end, on a floor whose faces meet at
    // x = 0, and goes on inside it
    const scalar x = GENERATE(-0.4, -0.02, 0.02, 0.4);
    const scalar inside = GENERATE(0.0, 0.1);
    const contactFace side
    (
        square(point(x, 0.2, -inside), vector(0, 1, 0), vector(0.3, 0, 1))
    );
    contactFace left
    (
        square(point(-1, 0, 0), vector(1, 0, 0), vector(0, 1, 0))
    );
    contactFace right
    (
        square(point(0, 0, 0), vector(1, 0, 0), vector(0, 1, 0))
    );
    left.ends = false;
    right.ends = false;
    REQUIRE((left.n & side.n) < 0);

    overlapNormal which;
    CHECK(mag(normalOf(left, side, which) - left.n) < 1e-12);
    CHECK(mag(normalOf(right, side, which) - right.n) < 1e-12);

    // But not if the floor ends before
    right.ends[3] = true;
    if (x < 0) CHECK(mag(normalOf(right, side, which) - right.n) > 0.1);
}


TEST_CASE("Where edges cross the normal is across both of them")
{
    // Ridges along x and along y, of any slopes, this far from each other
    const scalar slope = GENERATE(0.3, 1.0, 3.0);
    const scalar other = GENERATE(0.3, 2.0);
    const scalar apart = GENERATE(0.0, 0.05, -0.1, 0.49, 0.51);
    const contactFace below
    (
        square(point(0, 0, 0), vector(1, 0, 0), vector(0, 1, -slope))
    );
    const contactFace above
    (
        square(point(0.4, -0.3, apart), vector(0, 1, 0), vector(1, 0, other))
    );
    REQUIRE((below.n & above.n) < 0);
    overlapNormal which;
    const vector n(normalOf(below, above, which));
    const scalar w = max(scalar(0), 1 - sqr(2*apart));
    CHECK(which.crossing == Approx(w).margin(1e-12));
    const vector mean((below.n - above.n)/mag(below.n - above.n));
    const vector expected((1 - w)*mean + w*up);
    CHECK(mag(n - expected/mag(expected)) < 1e-12);
    if (w > 0)
    {
        CHECK(which.minusEdge == 0);
        CHECK(which.plusEdge == 0);
    }
}


TEST_CASE("Edges along each other have no normal, and those that end no next")
{
    overlapNormal which;
    SECTION("along each other")
    {
        const contactFace below
        (
            square(point(0, 0, 0), vector(1, 0, 0), vector(0, 1, -1))
        );
        const contactFace above
        (
            square(point(0.2, 0.1, 0), vector(1, 0, 0), vector(0, -1, 2))
        );
        // Both are on the other one, by almost the same: each is seen along
        // the normal of the other
        const vector mean((below.n - above.n)/mag(below.n - above.n));
        CHECK(mag(normalOf(below, above, which) - mean) < 2e-3);
        CHECK(which.crossing == 0);
    }
    SECTION("crosses in the next face")
    {
        // The ridge along y begins a little after that along x
        const bool vertex = GENERATE(false, true);
        const contactFace below
        (
            square(point(0, 0, 0), vector(1, 0, 0), vector(0, 1, -1))
        );
        contactFace above
        (
            square(point(0.4, 0.1, 0), vector(0, 1, 0), vector(1, 0, 1))
        );
        above.ends[3] = vertex;
        normalOf(below, above, which);
        CHECK(which.crossing == Approx(vertex ? 0 : 1 - 0.04));
    }
}


TEST_CASE("The area of an overlap at an edge is what its normal sees of it")
{
    const scalar slope = GENERATE(0.0, 0.5, 1.5);
    const bool edge = GENERATE(false, true);
    const contactFace below
    (
        square(point(0, 0, 0), vector(1, 0, 0), vector(0, 1, 0))
    );
    const contactFace above
    (
        square(point(0, 0, 0), vector(0, 1, 0), vector(1, 0, slope))
    );
    overlapNormal normal;
    if (edge) normal.plus = 0;
    DynamicList<contactOverlap> overlaps;
    contactOverlaps::append
    (
        below, above, up, normal, true, overlaps
    );
    scalar minus = 0, plus = 0;
    for (const contactOverlap& o : overlaps)
    {
        minus += o.minus.area;
        plus += o.plus.area;
    }
    CHECK(minus == Approx(1));
    CHECK(plus == Approx(edge ? 1 : std::sqrt(1 + sqr(slope))));
}
