/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The low-pass filter against the closed forms of its equations.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "lowPass.H"
#include "mathematicalConstants.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * //

namespace
{

constexpr scalar frequency = 40;
const scalar omega = constant::mathematical::twoPi*frequency;

//- What comes out at a time, for an input that is a function of time
template<class Input>
scalar filtered
(
    const label nPoles,
    const Input& input,
    const scalar end,
    const label nSteps
)
{
    const lowPass filter(frequency, nPoles);
    lowPass::state s;
    s.input = vector(input(0), 0, 0);
    for (label i = 1; i <= nSteps; ++i)
    {
        filter.advance(s, vector(input(i*end/nSteps), 0, 0), end/nSteps);
    }
    return s.value.x();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Test Cases  * * * * * * * * * * * * * * * //

TEST_CASE("A low-pass filter answers a step as its equation does")
{
    const auto one = [](const scalar) { return scalar(1); };
    for (const scalar t : {0.001, 0.004, 0.02})
    {
        const scalar x = omega*t, b = x/std::sqrt(scalar(2));
        REQUIRE(filtered(1, one, t, 7) == Approx(1 - std::exp(-x)));
        REQUIRE
        (
            filtered(2, one, t, 7)
         == Approx(1 - std::exp(-b)*(std::cos(b) + std::sin(b)))
        );
    }
}


TEST_CASE("A low-pass filter does not depend on the length of the steps")
{
    const auto ramp = [](const scalar t) { return 3 + 200*t; };
    for (const label nPoles : {1, 2})
    {
        REQUIRE
        (
            filtered(nPoles, ramp, 0.01, 1)
         == Approx(filtered(nPoles, ramp, 0.01, 1000)).epsilon(1e-9)
        );
    }
}


TEST_CASE("A low-pass filter halves the power at its frequency")
{
    const label nSteps = 100000;
    const scalar end = 10.125/frequency;
    for (const label nPoles : {1, 2})
    {
        // Late by an eighth of a period with one pole, by a quarter with two
        const scalar late = 0.125*nPoles;
        const scalar top = filtered
        (
            nPoles,
            [&](const scalar t)
            {
                return std::cos(omega*(t - end) + omega*late/frequency);
            },
            end,
            nSteps
        );
        REQUIRE(top == Approx(std::sqrt(scalar(0.5))).epsilon(1e-5));
    }
}


// ************************************************************************* //
