/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Steps of their own: how many of each region are in a common one.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "dictionary.H"
#include "stepRatios.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("No region takes longer steps than it bears", "[runControl][serial]")
{
    const stepRatios of(dictionary(), scalarField({100, 100, 100}));
    const scalarField stable({1, 5, 0.3});
    const stepRatios::ratios r(of.of(2.4, stable));
    forAll(stable, i)
    {
        CHECK(2.4/r.steps[i] <= stable[i]);
        CHECK(r.most % r.steps[i] == 0);
    }
    CHECK(r.steps[1] == 1);
    CHECK(r.evaluations == 100*(r.steps[0] + r.steps[1] + r.steps[2]));
}


TEST_CASE("What is rigid takes the shortest steps", "[runControl][serial]")
{
    // It has no nodes to evaluate. Though it would bear a longer one
    const stepRatios of(dictionary(), scalarField({100, 100, 0}));
    const stepRatios::ratios r(of.of(1.05, scalarField({1, 5, 1.09})));
    CHECK(r.most == 2);
    CHECK(r.steps == labelList({2, 1, 2}));
    CHECK(r.evaluations == 300);
}


// ************************************************************************* //
