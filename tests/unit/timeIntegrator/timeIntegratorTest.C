/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Coefficients of the time integrators, against the Taylor series of the
    exponential function.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "timeIntegrator.H"
#include "preset.H"
#include "IStringStream.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * //

namespace
{

//- Factor of a step of u' = z u/dt
scalar factor(const timeIntegrator& integrator, const scalar z)
{
    scalar u = 1;
    for (int stage = 0; stage < integrator.nStages(); ++stage)
    {
        const scalar w = integrator.oldWeight(stage);
        u = w + (1 - w)*(u + z*u);
    }
    return u;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Test Cases  * * * * * * * * * * * * * * * //

TEST_CASE("order of the time integrators", "[timeIntegrator][serial]")
{
    const scalar z = 0.01;
    scalar term = 1, series = 1;
    const integratorType ofOrder[] =
    {
        integratorType::symplecticEuler,
        integratorType::TVDRK2,
        integratorType::TVDRK3
    };
    for (label order = 1; order <= 3; ++order)
    {
        term *= z/order;
        series += term;
        const timeIntegrator integrator(ofOrder[order - 1]);
        CHECK(mag(factor(integrator, z) - series) <= 4e-16);
    }
}


TEST_CASE("weights and instants of stages", "[timeIntegrator][serial]")
{
    for (const word& name : timeIntegrator::names.toc())
    {
        INFO(name);
        const timeIntegrator integrator(timeIntegrator::names[name]);
        scalar weights = 0, instants = 0;

        // A stage adds to the position of the one before
        scalar position = 0;
        for (int stage = 0; stage < integrator.nStages(); ++stage)
        {
            CHECK(mag(integrator.instant(stage) - position) <= 1e-15);
            const scalar w = integrator.oldWeight(stage);
            position = (1 - w)*(position + 1);
            weights += integrator.weight(stage);
            instants += integrator.weight(stage)*integrator.instant(stage);
        }
        CHECK(mag(position - 1) <= 1e-15);
        CHECK(mag(weights - 1) <= 1e-15);
        if (!integrator.split() && !integrator.leapfrog())
        {
            CHECK(mag(instants - 0.5) <= 1e-15);
        }
    }
}


TEST_CASE
(
    "options of fvSchemes come before those of a preset",
    "[timeIntegrator][serial]"
)
{
    const preset paper(preset::kind::paper);
    IStringStream is("vertexCentred { kinematics F; }");
    const schemeOptions given(dictionary(is), paper.scheme);
    CHECK(given.kinematics == kinematicSet::F);
    CHECK(given.reconstruction == paper.scheme.reconstruction);
    CHECK(given.limiter == paper.scheme.limiter);

    const preset fast(preset::kind::fast);
    IStringStream is2("vertexCentred { volume smoothed; }");
    const schemeOptions given2(dictionary(is2), fast.scheme);
    CHECK(given2.volume == volumeTreatment::smoothed);
    CHECK(given2.correction == fast.scheme.correction);
    CHECK(given2.dissipation == fast.scheme.dissipation);

    // Balanced is the default
    const preset none{dictionary()};
    CHECK(none.name == preset::kind::balanced);
}


// ************************************************************************* //
