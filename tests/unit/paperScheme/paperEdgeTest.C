/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The fluxes of an edge of the paper's scheme: the Riemann problem, what is
    reconstructed, and the sign of what is dissipated.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "acousticRiemann.H"
#include "paperEdge.H"
#include "Random.H"
#include <cstring>

using namespace Foam;

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

namespace
{

constexpr scalar zp = 3, zs = 1.4, perZp = 0.5/zp;

typedef reconstructionType type;

Random& numbers()
{
    static Random random(11);
    return random;
}

scalar any() { return 2*numbers().sample01<scalar>() - 1; }

template<type R, class Number = scalar>
using edge3 = paperEdge<3, 1, R, true, Number>;

//- An edge between two nodes in any state, with the changes that it sees
template<type R, class Number = scalar>
struct anyEdge
:
    public edge3<R, Number>
{
    Number a[edge3<R>::nChanges];
    Number b[edge3<R>::nChanges];

    anyEdge()
    {
        this->twiceA = a;
        this->twiceB = b;
        const auto fill = [](Number& of)
        {
            scalar each[sizeof(Number)/sizeof(scalar)];
            for (scalar& x : each) x = any();
            std::memcpy(&of, each, sizeof(of));
        };
        for
        (
            auto* v :
            {
                &this->area, &this->c, &this->difference, &this->t,
                &this->vAvg, &this->tDifference
            }
        )
        {
            for (int i = 0; i < 3; ++i) fill((*v)[i]);
        }
        fill(this->differenceSJ);
        for (Number& x : a) fill(x);
        for (Number& x : b) fill(x);
    }

    anyEdge(const anyEdge&) = delete;
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("the traction of an edge is that of stick (34a)", "[paper][serial]")
{
    for (int k = 0; k < 100; ++k)
    {
        anyEdge<type::none> e;
        e.c = e.area;
        e.solve<limiterType::none, false>(0.5*zp, 0.5*zs, perZp);

        // Both sides per area
        const vector C(e.area[0], e.area[1], e.area[2]);
        const vector t(e.t[0], e.t[1], e.t[2]);
        const vector jump(e.difference[0], e.difference[1], e.difference[2]);
        const vector half(any(), any(), any());
        const acousticRiemann::side a{vector::zero, t/mag(C) - half, zp, zs};
        const acousticRiemann::side b{jump, t/mag(C) + half, zp, zs};
        const vector expected
        (
            mag(C)*acousticRiemann::stickTraction(a, b, C/mag(C))
        );
        for (int i = 0; i < 3; ++i)
        {
            CHECK(e.traction[i] == Approx(expected[i]).epsilon(1e-12));
        }
        CHECK(e.wave == Approx(mag(C)).epsilon(1e-14));
    }
}


TEST_CASE("what is linear dissipates nothing", "[paper][serial]")
{
    for (int k = 0; k < 100; ++k)
    {
        // Twice the changes are the differences, and P is one whose
        // differences times C are tDifference
        anyEdge<type::full> e;
        scalar CC = 0;
        for (int i = 0; i < 3; ++i) CC += sqr(e.area[i]);
        for (int i = 0; i < 3; ++i)
        {
            e.a[i] = e.difference[i];
            for (int j = 0; j < 3; ++j)
            {
                e.a[e.atP(i, j)] = e.tDifference[i]*e.area[j]/CC;
            }
        }
        e.a[3] = e.differenceSJ;
        for (int c = 0; c < e.nChanges; ++c) e.b[c] = e.a[c];

        e.solve<limiterType::BarthJespersen, true>(0.5*zp, 0.5*zs, perZp);
        for (int i = 0; i < 3; ++i)
        {
            CHECK(mag(e.traction[i] - e.t[i]) < 1e-13);
            CHECK(mag(e.velocity[i] - e.vAvg[i]) < 1e-13);
        }
        CHECK(mag(e.fluxJ) < 1e-14);
        CHECK(mag(e.power) < 1e-12);
    }
}


TEST_CASE("limited jumps take energy", "[paper][serial]")
{
    for (int k = 0; k < 1000; ++k)
    {
        anyEdge<type::linear> e;
        e.solve<limiterType::BarthJespersen, true>(0.5*zp, 0.5*zs, perZp);
        CHECK(e.power > -1e-13);

        anyEdge<type::none> first;
        first.solve<limiterType::none, true>(0.5*zp, 0.5*zs, perZp);
        CHECK(first.power > 0);
    }
}


TEST_CASE("edges in lanes are edges", "[paper][lanes][serial]")
{
    typedef anyEdge<type::full> oneType;
    oneType edges[nLanes];
    anyEdge<type::full, lanes> many;
    many.isFaster = true;
    for (int l = 0; l < nLanes; ++l)
    {
        oneType& e = edges[l];
        e.isFaster = true;
        e.faster = many.faster[l] = 1.5 + any();
        for (int i = 0; i < 3; ++i)
        {
            many.area[i][l] = e.area[i];
            many.c[i][l] = e.c[i];
            many.difference[i][l] = e.difference[i];
            many.t[i][l] = e.t[i];
            many.vAvg[i][l] = e.vAvg[i];
            many.tDifference[i][l] = e.tDifference[i];
        }
        many.differenceSJ[l] = e.differenceSJ;
        for (int k = 0; k < e.nChanges; ++k)
        {
            many.a[k][l] = e.a[k];
            many.b[k][l] = e.b[k];
        }
        e.solve<limiterType::Venkatakrishnan, true>(0.5*zp, 0.5*zs, perZp);
    }
    many.solve<limiterType::Venkatakrishnan, true>(0.5*zp, 0.5*zs, perZp);
    for (int l = 0; l < nLanes; ++l)
    {
        const oneType& e = edges[l];
        for (int i = 0; i < 3; ++i)
        {
            CHECK(many.traction[i][l] == Approx(e.traction[i]).epsilon(1e-10));
            CHECK(many.velocity[i][l] == Approx(e.velocity[i]).epsilon(1e-10));
        }
        CHECK(many.fluxJ[l] == Approx(e.fluxJ).epsilon(1e-10).margin(1e-15));
        CHECK(many.wave[l] == Approx(e.wave).epsilon(1e-10));
        CHECK(many.power[l] == Approx(e.power).epsilon(1e-9).margin(1e-13));
    }
}


// ************************************************************************* //
