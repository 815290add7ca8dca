/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What fluxes may feed back of the energy that they have dissipated.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "dissipationReserve.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Test Cases  * * * * * * * * * * * * * * * //

TEST_CASE("no reserve without dissipation", "[solidBody][serial]")
{
    dissipationReserve reserve;
    CHECK(reserve.share() == 0);
    reserve.add(-1);
    CHECK(reserve.share() == 0);
    reserve.add(0.999);
    CHECK(reserve.share() == 0);
}


TEST_CASE("dissipation fills the reserve to its limit", "[solidBody][serial]")
{
    const scalar part = dissipationReserve::part;
    dissipationReserve reserve;
    reserve.add(2);
    CHECK(reserve.share() == 1);
    CHECK(reserve.values()[3] == Approx(2*part));

    // Half of it is fed
    reserve.add(-part);
    CHECK(reserve.share() == Approx(0.5));
    CHECK(reserve.values()[2] == 2);

    // More than all: it has to be made good for
    reserve.add(-3*part);
    CHECK(reserve.share() == 0);
    reserve.add(2*part);
    CHECK(reserve.share() == Approx(0).margin(1e-12));
    reserve.add(part);
    CHECK(reserve.share() == Approx(0.5));
}


TEST_CASE("round-off fills no reserve", "[solidBody][serial]")
{
    dissipationReserve reserve(1e4);
    reserve.add(9e-7);
    CHECK(reserve.share() == 0);
    reserve.add(1);
    CHECK(reserve.share() == 1);
    CHECK(dissipationReserve(reserve.values()).share() == 1);
}


TEST_CASE("a reserve goes on as it was written", "[solidBody][serial]")
{
    dissipationReserve a;
    for (const scalar d : {3.0, -0.011, 0.004}) a.add(d);
    dissipationReserve b(a.values());
    CHECK(b.share() == a.share());
    a.add(-0.001);
    b.add(-0.001);
    CHECK(b.values() == a.values());
}


// ************************************************************************* //
