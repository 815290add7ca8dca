/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Slope limiters: bounds, smooth fields, and arithmetic at the extremes.
    Floating point exceptions are trapped, so a division by zero is a failure.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "slopeLimiter.H"
#include "tensors/fullTensor.H"

#include <limits>

using namespace Foam;
using slopeLimiter::BarthJespersen;
using slopeLimiter::Venkatakrishnan;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

typedef scalar limiter(const scalar&, const scalar&);
limiter* const limiters[] = {&BarthJespersen, &Venkatakrishnan};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("No new extremum along an edge", "[slopeLimiter][serial]")
{
    Random random(1);
    label nLimited = 0, nOpposed = 0;
    for (label sample = 0; sample < 10000; ++sample)
    {
        const scalar scale = Foam::pow(scalar(10), randomScalar(random, 9));
        const scalar D = scale*randomScalar(random);
        const scalar delta = 2*scale*randomScalar(random);

        for (limiter* limited : limiters)
        {
            const scalar change = limited(delta, D);

            // Between the values of the two nodes, and never beyond delta
            CHECK(change*D >= 0);
            CHECK(mag(change) <= mag(D)*(1 + 1e-14));
            CHECK(mag(change) <= mag(delta)*(1 + 1e-14));
            if (delta*D < 0) CHECK(change == 0);
        }

        // Barth and Jespersen limit no more than necessary
        if (delta*D > 0 && mag(delta) <= mag(D))
        {
            CHECK(BarthJespersen(delta, D) == delta);
        }
        else if (delta*D > 0)
        {
            CHECK(BarthJespersen(delta, D) == D);
            ++nLimited;
        }
        else
        {
            ++nOpposed;
        }
    }
    CHECK(nLimited > 1000);
    CHECK(nOpposed > 1000);
}


TEST_CASE("Constant and linear fields are untouched", "[slopeLimiter][serial]")
{
    for (limiter* limited : limiters)
    {
        CHECK(limited(0, 0) == 0);
        for (const scalar D : {1.0, -1.0, 1e-200, -3e100, 7e-12})
        {
            // delta to mid-edge is half the difference of a linear field
            CHECK(limited(0.5*D, D) == 0.5*D);
        }
    }
}


TEST_CASE("Continuous in slope and difference", "[slopeLimiter][serial]")
{
    // No step larger than a few times the change of the arguments
    const scalar h = 1e-6;
    for (limiter* limited : limiters)
    {
        for (scalar delta = -2; delta < 2; delta += 0.0137)
        {
            for (scalar D = -2; D < 2; D += 0.0171)
            {
                const scalar f = limited(delta, D);
                CHECK(mag(limited(delta + h, D) - f) < 3*h);
                CHECK(mag(limited(delta, D + h) - f) < 3*h);
            }
        }
        for (scalar delta = -2; delta < 2; delta += 0.0137)
        {
            CHECK(mag(limited(delta, h) - limited(delta, -h)) < 6*h);
            CHECK(mag(limited(h, delta) - limited(-h, delta)) < 6*h);
        }
    }
}


TEST_CASE("Symmetric under mirror and change of sign", "[slopeLimiter][serial]")
{
    Random random(2);
    for (label sample = 0; sample < 1000; ++sample)
    {
        const scalar D = randomScalar(random), delta = randomScalar(random);
        for (limiter* limited : limiters)
        {
            CHECK(limited(-delta, -D) == -limited(delta, D));
            CHECK
            (
                limited(16*delta, 16*D)
             == Approx(16*limited(delta, D)).epsilon(1e-14)
            );
        }
    }
}


TEST_CASE("Venkatakrishnan is the smooth form", "[slopeLimiter][serial]")
{
    for (scalar y = 0.01; y < 2; y += 0.01)
    {
        CHECK
        (
            Venkatakrishnan(1.0, y)
         == Approx((y*y + 2*y)/(y*y + y + 2)).epsilon(1e-14)
        );
        CHECK(Venkatakrishnan(1.0, y) <= BarthJespersen(1.0, y)*(1 + 1e-14));
    }
    CHECK(Venkatakrishnan(1.0, 5.0) == 1);
}


TEST_CASE("No arithmetic error at the extremes", "[slopeLimiter][serial]")
{
    typedef std::numeric_limits<scalar> limits;
    const scalar values[] =
    {
        0.0, limits::denorm_min(), limits::min(), 1e-170, 1e-20, 1, 1e20,
        1e170, 0.25*limits::max()
    };
    for (limiter* limited : limiters)
    {
        for (const scalar a : values)
        {
            for (const scalar b : values)
            {
                for (const scalar sign : {1.0, -1.0})
                {
                    const scalar change = limited(a, sign*b);
                    CHECK(std::isfinite(change));
                    CHECK(mag(change) <= max(a, b));
                }
            }
        }
    }
}


TEST_CASE("limited() chooses the limiter", "[slopeLimiter][serial]")
{
    CHECK(slopeLimiter::limited<limiterType::none>(3.0, 1.0) == 3);
    CHECK(slopeLimiter::limited<limiterType::BarthJespersen>(3.0, 1.0) == 1);
    CHECK
    (
        slopeLimiter::limited<limiterType::Venkatakrishnan>(3.0, 1.0)
     == Venkatakrishnan(3.0, 1.0)
    );
}


// ************************************************************************* //
