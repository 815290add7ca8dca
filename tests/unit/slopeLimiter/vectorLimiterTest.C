/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Limiters of vectors in the frame of the waves: bounds, linear fields, and
    independence of the orientation of the axes.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "vectorLimiter.H"
#include "tensors/fullTensor.H"

using namespace Foam;
using slopeLimiter::limitVectors;
using slopeLimiter::keepDissipative;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

constexpr limiterType BJ = limiterType::BarthJespersen;
constexpr limiterType smooth = limiterType::Venkatakrishnan;

typedef SolidVector<3> vector3;

vector3 randomSolidVector(Random& random)
{
    vector3 v;
    for (int i = 0; i < 3; ++i) v[i] = randomScalar(random);
    return v;
}

vector3 randomDirection(Random& random)
{
    const vector3 v(randomSolidVector(random));
    const scalar magV = std::sqrt(dot(v, v));
    vector3 n;
    for (int i = 0; i < 3; ++i) n[i] = v[i]/magV;
    return n;
}

//- Rotation by an angle about an axis (Rodrigues)
vector3 rotated(const vector3& v, const vector3& k, const scalar angle)
{
    const scalar c = std::cos(angle), s = std::sin(angle), kv = dot(k, v);
    const scalar cross[3] =
    {
        k[1]*v[2] - k[2]*v[1], k[2]*v[0] - k[0]*v[2], k[0]*v[1] - k[1]*v[0]
    };
    vector3 r;
    for (int i = 0; i < 3; ++i)
    {
        r[i] = c*v[i] + s*cross[i] + (1 - c)*kv*k[i];
    }
    return r;
}

vector3 across(const vector3& v, const vector3& n)
{
    const scalar along = dot(v, n);
    vector3 t;
    for (int i = 0; i < 3; ++i) t[i] = v[i] - along*n[i];
    return t;
}

scalar distance(const vector3& a, const vector3& b)
{
    scalar sum = 0;
    for (int i = 0; i < 3; ++i) sum += sqr(a[i] - b[i]);
    return std::sqrt(sum);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("Vector limiter: linear fields are untouched", "[slopeLimiter]")
{
    Random random(11);
    for (label sample = 0; sample < 1000; ++sample)
    {
        const vector3 n(randomDirection(random)), D(randomSolidVector(random));
        vector3 da, db;
        for (int i = 0; i < 3; ++i) da[i] = db[i] = 0.5*D[i];

        limitVectors<BJ>(n, D, da, db);
        for (int i = 0; i < 3; ++i)
        {
            CHECK(mag(da[i] - 0.5*D[i]) < 1e-14);
            CHECK(mag(db[i] - 0.5*D[i]) < 1e-14);
        }
    }
}


TEST_CASE("Vector limiter: no new extremum along n and across",
    "[slopeLimiter]")
{
    Random random(12);
    for (label sample = 0; sample < 1000; ++sample)
    {
        const vector3 n(randomDirection(random)), D(randomSolidVector(random));
        vector3 da(randomSolidVector(random)), db(randomSolidVector(random));
        limitVectors<BJ>(n, D, da, db);

        for (const vector3& d : {da, db})
        {
            const scalar share = dot(d, n)/dot(D, n);
            CHECK((share > -1e-12 && share < 1 + 1e-12));

            // Across n: a share of the difference, and nothing beside it
            const vector3 t(across(d, n)), DT(across(D, n));
            const scalar shareT = dot(t, DT)/dot(DT, DT);
            CHECK((shareT > -1e-12 && shareT < 1 + 1e-12));
            for (int i = 0; i < 3; ++i)
            {
                CHECK(mag(t[i] - shareT*DT[i]) < 1e-13);
            }
        }
    }
}


TEST_CASE("Vector limiters do not depend on the axes", "[slopeLimiter]")
{
    Random random(13);
    for (label sample = 0; sample < 1000; ++sample)
    {
        const vector3 k(randomDirection(random));
        const scalar angle = 3*randomScalar(random);
        const auto turn = [&](const vector3& v)
        {
            return rotated(v, k, angle);
        };

        const vector3 n(randomDirection(random)), D(randomSolidVector(random));
        const vector3 da(randomSolidVector(random));
        const vector3 db(randomSolidVector(random));

        vector3 a(da), b(db), aTurned(turn(da)), bTurned(turn(db));
        limitVectors<BJ>(n, D, a, b);
        limitVectors<BJ>(turn(n), turn(D), aTurned, bTurned);
        CHECK(distance(turn(a), aTurned) < 1e-12);
        CHECK(distance(turn(b), bTurned) < 1e-12);
    }
}


TEST_CASE("The jump that remains dissipates along n and across",
    "[slopeLimiter]")
{
    Random random(15);
    label nChanged = 0;
    for (label sample = 0; sample < 1000; ++sample)
    {
        const vector3 n(randomDirection(random)), D(randomSolidVector(random));
        vector3 da(randomSolidVector(random)), db(randomSolidVector(random));
        limitVectors<BJ>(n, D, da, db);
        const vector3 a(da), b(db);
        keepDissipative(n, D, da, db);

        vector3 jump;
        for (int i = 0; i < 3; ++i) jump[i] = D[i] - da[i] - db[i];
        CHECK(dot(jump, n)*dot(D, n) >= -1e-14);
        CHECK(dot(across(jump, n), across(D, n)) >= -1e-14);

        // The average of the two sides remains
        for (int i = 0; i < 3; ++i)
        {
            CHECK(mag((da[i] - db[i]) - (a[i] - b[i])) < 1e-14);
        }
        if (distance(a, da) > 1e-12) ++nChanged;
    }
    CHECK(nChanged > 100);
}


template<limiterType L>
void compareJumps()
{
    Random random(17);
    for (label sample = 0; sample < 1000; ++sample)
    {
        const vector3 n(randomDirection(random)), D(randomSolidVector(random));
        vector3 da(randomSolidVector(random)), db(randomSolidVector(random));
        const vector3 jump = slopeLimiter::dissipativeJump<L>(n, D, da, db);
        limitVectors<L>(n, D, da, db);
        keepDissipative(n, D, da, db);
        for (int i = 0; i < 3; ++i)
        {
            CHECK(mag(jump[i] - (D[i] - da[i] - db[i])) < 1e-13);
        }
    }
}

TEST_CASE("The jump in one go is that of the limiters one after the other",
    "[slopeLimiter]")
{
    compareJumps<limiterType::none>();
    compareJumps<BJ>();
    compareJumps<smooth>();
}


TEST_CASE("No arithmetic error of vector limiters at the extremes",
    "[slopeLimiter]")
{
    for (const scalar scale : {0.0, 1e-310, 1e-160, 1e-20, 1e20, 1e120})
    {
        Random random(16);
        for (label sample = 0; sample < 100; ++sample)
        {
            const vector3 n(randomDirection(random));
            vector3 D(randomSolidVector(random));
            vector3 da(randomSolidVector(random));
            vector3 db(randomSolidVector(random));
            for (int i = 0; i < 3; ++i)
            {
                D[i] *= scale;
                da[i] *= scale;
                db[i] *= sample % 2 ? scale : 1;
            }
            vector3 sa(da), sb(db);
            limitVectors<smooth>(n, D, sa, sb);
            const vector3 jump(slopeLimiter::dissipativeJump<BJ>(n, D, da, db));
            limitVectors<BJ>(n, D, da, db);
            keepDissipative(n, D, da, db);
            for (int i = 0; i < 3; ++i)
            {
                CHECK(std::isfinite(jump[i]));
                CHECK(std::isfinite(sa[i] + sb[i]));
                CHECK(std::isfinite(da[i] + db[i]));
            }
        }
    }
}


// ************************************************************************* //
