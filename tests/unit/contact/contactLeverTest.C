/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    A point fixed to a face: its velocity in rigid motions, and the forces of
    the nodes, which are its transpose.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "contactLever.H"
#include "point.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

typedef SolidVector<3> vec;

vec of(const vector& a) { return vec{a.x(), a.y(), a.z()}; }

vector of(const vec& a) { return vector(a[0], a[1], a[2]); }

//- A lever of up to four nodes, for samples of any number
struct lever
{
    contactLever<scalar, 4> four{};
    contactLever<scalar, 2> two{};
    const bool planar;
    scalar turns;

    lever
    (
        const std::vector<point>& x,
        const std::vector<scalar>& weights,
        const vector& n
    )
    :
        planar(x.size() <= 2)
    {
        scalar N[4] = {0, 0, 0, 0}, present[4] = {0, 0, 0, 0};
        vec places[4] = {of(x[0]), of(x[0]), of(x[0]), of(x[0])};
        for (std::size_t j = 0; j < x.size(); ++j)
        {
            N[j] = weights[j];
            present[j] = 1;
            places[j] = of(x[j]);
        }
        turns =
            planar
          ? two.setFace(N, present, places, of(n))
          : four.setFace(N, present, places, of(n));
    }

    scalar setPoint(const vector& offset)
    {
        return
            planar ? two.setPoint(of(offset)) : four.setPoint(of(offset));
    }

    scalar movePoint(const vector& way)
    {
        return planar ? two.movePoint(of(way)) : four.movePoint(of(way));
    }

    vector slope() const { return of(planar ? two.slope() : four.slope()); }

    vector velocityOf(const vec* v) const
    {
        return of(planar ? two.velocityOf(v) : four.velocityOf(v));
    }

    vector shear(const vec* v) const
    {
        return of(planar ? two.shear(v) : four.shear(v));
    }

    void setGrowth(const scalar share, const vector& growth)
    {
        planar
      ? two.setGrowth(share, of(growth))
      : four.setGrowth(share, of(growth));
    }

    scalar weight(const int j) const
    {
        return planar ? two.weight(j) : four.weight(j);
    }

    vector velocity(const int j, const vector& v) const
    {
        return of(planar ? two.velocity(j, of(v)) : four.velocity(j, of(v)));
    }

    vector force(const int j, const vector& f) const
    {
        return of(planar ? two.force(j, of(f)) : four.force(j, of(f)));
    }
};

struct sample
{
    std::vector<point> x;
    std::vector<scalar> weights;
    vector n;
    vector offset;
};

//- Edge in 2D, triangle, twisted quadrilateral; n not across all of them
const std::vector<sample> samples
{
    {
        {{0, 0, 0}, {0.4, 0.1, 0}}, {0.3, 0.7},
        vector(0.1, 1, 0)/mag(vector(0.1, 1, 0)), {0.05, 0.02, 0}
    },
    {
        {{0, 0, 0}, {1, 0.2, 0.1}, {0.3, 0.9, 0}}, {0.2, 0.5, 0.3},
        vector(0.1, -0.2, 1)/mag(vector(0.1, -0.2, 1)), {0.1, 0.2, -0.1}
    },
    {
        {{0, 0, 0}, {1, 0, 0.2}, {1.2, 1, 0}, {0, 0.8, 0.1}},
        {0.4, 0.3, 0.2, 0.1},
        vector(0.3, 0.1, 1)/mag(vector(0.3, 0.1, 1)), {-0.2, 0.1, 0.3}
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST_CASE("A lever moves rigidly, and its forces are the transpose")
{
    for (const sample& c : samples)
    {
        const int size = c.x.size();
        lever lever(c.x, c.weights, c.n);
        const scalar b = lever.setPoint(c.offset);
        point at(c.offset);
        for (int j = 0; j < size; ++j) at += c.weights[j]*c.x[j];
        const bool planar = size == 2;
        const vector spin(planar ? 0 : 0.7, planar ? 0 : -0.4, 1.3);
        const vector shift(2, -3, planar ? 0 : 1);
        const vector f(0.3, -1.1, planar ? 0 : 0.8);

        // The motion of a rigid body at the point, and sum and moment of forces
        vector v(Zero), sum(Zero), moment(Zero);
        point foot(Zero);
        scalar power = 0;
        vector any(Zero);
        for (int j = 0; j < size; ++j)
        {
            v += lever.velocity(j, shift + (spin ^ c.x[j]));
            sum += lever.force(j, f);
            moment += c.x[j] ^ lever.force(j, f);
            foot += lever.weight(j)*c.x[j];
            const vector u(0.3*j - 1, 0.5 - 0.2*j*j, planar ? 0 : 0.1*j);
            any += lever.velocity(j, u);
            power += lever.force(j, f) & u;
        }
        CHECK(mag(sum - f) < 1e-14);
        CHECK(mag(moment - (at ^ f)) < 1e-14);
        CHECK(mag(foot + b*c.n - at) < 1e-14);
        CHECK(mag(power - (any & f)) < 1e-14);
        CHECK(mag(v - (shift + (spin ^ at))) < 1e-14);
    }
}


TEST_CASE("A point that moves along a face is one that was set there")
{
    for (const sample& c : samples)
    {
        const bool planar = c.x.size() == 2;
        vector way(planar ? vector(0.03, 0.01, 0) : vector(0.03, -0.05, 0.01));
        way -= (way & c.n)*c.n;
        lever moved(c.x, c.weights, c.n), there(c.x, c.weights, c.n);
        const scalar height = moved.setPoint(c.offset);
        const scalar change = moved.movePoint(way);
        CHECK(change == Approx(-(way & moved.slope())).margin(1e-14));
        CHECK(there.setPoint(c.offset + way) == Approx(height + change));

        // A rigid motion is one there, too; the velocity along n grows as it
        // turns
        const vector spin(planar ? 0 : 0.7, planar ? 0 : -0.4, 1.3);
        vec v[4];
        for (std::size_t j = 0; j < 4; ++j)
        {
            v[j] = of(spin ^ c.x[j < c.x.size() ? j : 0]);
        }
        CHECK(mag(moved.velocityOf(v) - there.velocityOf(v)) < 1e-14);
        const vector foot(way - change*c.n);
        CHECK
        (
            (moved.shear(v) & way) == Approx((spin ^ foot) & c.n).margin(1e-14)
        );
    }
}


TEST_CASE("Forces on an area that has grown are linear in the way")
{
    for (const sample& c : samples)
    {
        const int size = c.x.size();
        const vector along(c.offset - (c.offset & c.n)*c.n);
        const vector f(0.3, -1.1, size == 2 ? 0 : 0.8);
        point start(Zero);
        for (int j = 0; j < size; ++j) start += c.weights[j]*c.x[j];

        // As the area shrinks to less than nothing
        std::vector<std::vector<vector>> forces;
        for (const scalar d : {0.0, 0.5, 1.0})
        {
            lever lever(c.x, c.weights, c.n);
            lever.setPoint(d*along);
            const scalar share = 1 - 1.3*d;
            lever.setGrowth(share, (1 - share)*d*along);
            forces.emplace_back();
            vector sum(Zero), moment(Zero);
            for (int j = 0; j < size; ++j)
            {
                forces.back().push_back(lever.force(j, f));
                sum += forces.back()[j];
                moment += c.x[j] ^ forces.back()[j];
            }
            CHECK(mag(sum - share*f) < 1e-14);

            // Area and first moment, each linear: the share at the start, and
            // what has come along
            const vector first(share*start + d*along);
            CHECK(mag(moment - (first ^ f)) < 1e-14);
        }
        for (int j = 0; j < size; ++j)
        {
            CHECK
            (
                mag(forces[0][j] - 2*forces[1][j] + forces[2][j]) < 1e-14
            );
        }
    }
}


TEST_CASE("A lever on a single corner keeps its weight")
{
    lever lever({point(1, 2, 3)}, {1}, vector(0, 0, 1));
    CHECK(lever.turns == GREAT);
    CHECK(lever.setPoint(vector(0.1, 0, 0.2)) == 0.2);
    const vector f(1, 2, 3);
    CHECK(lever.velocity(0, f) == f);
    CHECK(lever.force(0, f) == f);
}


TEST_CASE("A lever is not longer than its face, and a fine face turns more")
{
    const auto edge = [](const scalar length)
    {
        return lever
        (
            {point::zero, point(length, 0, 0)}, {0.5, 0.5}, vector(0, 1, 0)
        );
    };
    CHECK(edge(1).turns == 2);
    lever lever(edge(0.1));
    CHECK(lever.turns == Approx(200));

    // Of the edge of length 0.1, a point 7 lengths away
    CHECK(lever.setPoint(vector(0.7, 0.02, 0)) == Approx(0.02));
    CHECK(lever.weight(0) == Approx(-0.5));
    CHECK(lever.weight(1) == Approx(1.5));
    const vector f(1, 2, 0);
    CHECK(mag(lever.force(0, f) + lever.force(1, f) - f) < 1e-14);
}


// ************************************************************************* //
