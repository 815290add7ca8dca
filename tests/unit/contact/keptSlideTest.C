/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    How much of the stored slide is kept in slip: as much as friction can hold.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "contactInterface.H"
#include <cfenv>

using namespace Foam;

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

namespace
{

struct opened
:
    public contactInterface
{
    using contactInterface::kept;
};

//- Share that is kept if the slide has one traction, all the rest another one,
//  and friction holds so much
scalar kept(const scalar ofSlide, const scalar other, const scalar holds)
{
    contactLaw::problem p;
    p.n = vector(0, 1, 0);
    p.tGap = vector(ofSlide, -1, 0);
    for (acousticRiemann::side* side : {&p.minus, &p.plus})
    {
        side->t = p.tGap;
        side->v = vector::zero;
        side->zp = side->zs = 2;
    }
    p.plus.v.x() = other;
    p.result.state = acousticRiemann::status::slip;
    p.result.t = vector(holds, -1, 0);
    return opened::kept(p);
}

} // End anonymous namespace


TEST_CASE("in slip as much of the slide is kept as friction holds", "[contact]")
{
    CHECK(kept(1, 1, 1.5) == Approx(0.5));
    CHECK(kept(2, -1, 0.5) == Approx(0.75));
    CHECK(kept(1, 1, 3) == 1);
    CHECK(kept(1, 2, 1) == 0);
}


TEST_CASE("a slide whose square is not a number any more is kept", "[contact]")
{
    // In long slip it falls by some share in each step
    for (const scalar ofSlide : {1e-140, 1e-155, 1e-161, 1e-163, 1e-300})
    {
        std::feclearexcept(FE_ALL_EXCEPT);
        const scalar share = kept(ofSlide, 1e6, 2e6);
        CHECK(!std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
        CHECK(share == 1);
    }
}


// ************************************************************************* //
