/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Largest eigenvalues of symmetric tridiagonal matrices.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "lanczos.H"
#include "mathematicalConstants.H"

#include <cfenv>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST_CASE("The largest eigenvalue of a tridiagonal matrix", "[scheme]")
{
    // Of a chain, and of ones whose pivots are none at its bounds
    std::feclearexcept(FE_INVALID | FE_DIVBYZERO);
    const label n = 7;
    CHECK
    (
        lanczos::largestOfTridiagonal
        (
            scalarList(n, scalar(2)), scalarList(n - 1, scalar(1))
        )
     == Approx(2 + 2*std::cos(constant::mathematical::pi/(n + 1)))
    );
    const auto largest = lanczos::largestOfTridiagonal;
    CHECK(largest({1.0, 1.0}, {0.0}) == Approx(1));
    CHECK(largest({1.0, 1.0, 3.0}, {0.0, 0.0}) == Approx(3));
    CHECK(largest({2.0, 0.0}, {1.0}) == Approx(1 + std::sqrt(2.0)));
    CHECK_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO));
}


// ************************************************************************* //
