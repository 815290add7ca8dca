/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Limiters of many edges at once are those of each edge by itself.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "vectorLimiter.H"
#include "tensors/fullTensor.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

//- What the limiters make of an edge
template<class T>
struct limitedEdge
{
    SolidVector<3, T> da, db, jump;
    T change;
};

template<limiterType L, class T>
limitedEdge<T> limitEdge
(
    const SolidVector<3, T>& n,
    const SolidVector<3, T>& D,
    const SolidVector<3, T>& da,
    const SolidVector<3, T>& db
)
{
    limitedEdge<T> r;
    r.da = da;
    r.db = db;
    slopeLimiter::limitVectors<L>(n, D, r.da, r.db);
    slopeLimiter::keepDissipative(n, D, r.da, r.db);
    r.jump = slopeLimiter::dissipativeJump<L>(n, D, da, db);
    r.change = slopeLimiter::limited<L, T>(da[0], D[0]);
    return r;
}

template<limiterType L>
void compare()
{
    Random random(7);
    for (int trial = 0; trial < 200; ++trial)
    {
        SolidVector<3, lanes> in[4];
        for (auto& v : in)
        {
            for (int i = 0; i < 3; ++i)
            {
                for (int l = 0; l < nLanes; ++l)
                {
                    // Zeros among them
                    const scalar x = randomScalar(random);
                    v[i][l] = mag(x) < 0.1 ? 0 : x;
                }
            }
        }
        for (int l = 0; l < nLanes; ++l) in[0][2][l] = 2;

        lanes size = squareRoot(dot(in[0], in[0]));
        for (int i = 0; i < 3; ++i) in[0][i] /= size;

        const auto all = limitEdge<L, lanes>(in[0], in[1], in[2], in[3]);
        for (int l = 0; l < nLanes; ++l)
        {
            SolidVector<3> one[4];
            for (int k = 0; k < 4; ++k)
            {
                for (int i = 0; i < 3; ++i) one[k][i] = in[k][i][l];
            }
            const auto r = limitEdge<L, scalar>(one[0], one[1], one[2], one[3]);
            CHECK(mag(all.change[l] - r.change) <= 1e-14);
            for (int i = 0; i < 3; ++i)
            {
                CHECK(mag(all.da[i][l] - r.da[i]) <= 1e-14);
                CHECK(mag(all.db[i][l] - r.db[i]) <= 1e-14);
                CHECK(mag(all.jump[i][l] - r.jump[i]) <= 1e-14);
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("Lanes are limited as scalars are", "[slopeLimiter][serial]")
{
    compare<limiterType::none>();
    compare<limiterType::BarthJespersen>();
    compare<limiterType::Venkatakrishnan>();
}


TEST_CASE("Arithmetic of lanes", "[slopeLimiter][serial]")
{
    lanes a, b;
    for (int l = 0; l < nLanes; ++l)
    {
        a[l] = l - 1;
        b[l] = 1 - l*l;
    }
    const lanes least = min(a, b), most = max(a, b), root = squareRoot(a*a);
    const lanes chosen = select(a > b, a, b);
    for (int l = 0; l < nLanes; ++l)
    {
        CHECK(least[l] == min(a[l], b[l]));
        CHECK(most[l] == max(a[l], b[l]));
        CHECK(chosen[l] == most[l]);
        CHECK(root[l] == mag(a[l]));
    }
}


// ************************************************************************* //
