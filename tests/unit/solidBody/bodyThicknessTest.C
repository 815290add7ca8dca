/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Thickness of a body behind its faces: plates, wedges, mirrors, on any number
    of ranks.

\*---------------------------------------------------------------------------*/

#include "bodyThickness.H"
#include "meshFactory.H"
#include "PstreamReduceOps.H"
#include "testEnvironment.H"

#include <catch2/catch.hpp>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Patches of meshFactory
constexpr label xMin = 0, yMin = 2, yMax = 3;

//- Halves of a block on different ranks, so that both sides of a plate that is
//  thin along y are, too
meshFactory::block plate()
{
    meshFactory::block b;
    b.n = {4, 2, 3};
    b.upper = point(2, 0.3, 1.5);
    b.rankOf = [](label, const label j, label)
    {
        return j % Pstream::nProcs();
    };
    return b;
}

scalarField behind
(
    const meshFactory::result& made,
    const label patchi,
    const scalar within,
    const labelList& mirrors = labelList()
)
{
    return bodyThickness::behind
    (
        *made.mesh, labelList(1, patchi), mirrors, within
    )[0];
}

scalar least(const scalarField& t) { return gMin(t); }
scalar most(const scalarField& t) { return gMax(t); }

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("A plate is as thick as its other side is far", "[bodyThickness]")
{
    for (const auto kind : {meshFactory::hexes, meshFactory::tets})
    {
        meshFactory::block b(plate());
        b.cells = kind;
        const auto made = meshFactory::make(testTime(), b);
        for (const label patchi : {yMin, yMax})
        {
            const scalarField t(behind(made, patchi, 10));
            CHECK(least(t) == Approx(0.3).epsilon(1e-12));
            CHECK(most(t) == Approx(0.3).epsilon(1e-12));
        }
        // Its rim looks along the plate
        CHECK(least(behind(made, xMin, 10)) == Approx(2).epsilon(1e-12));
    }
}


TEST_CASE("A side that is further away does not matter", "[bodyThickness]")
{
    const auto made = meshFactory::make(testTime(), plate());
    CHECK(least(behind(made, yMin, 0.29)) == GREAT);
    CHECK(most(behind(made, yMin, 0.31)) == Approx(0.3).epsilon(1e-12));
}


TEST_CASE("A body goes on beyond a mirror", "[bodyThickness]")
{
    const auto made = meshFactory::make(testTime(), plate());
    CHECK(least(behind(made, yMin, 10, labelList(1, yMax))) == GREAT);
}


TEST_CASE("A plane body is measured in its plane", "[bodyThickness]")
{
    meshFactory::block b(plate());
    b.n[2] = 1;
    b.isEmpty[2] = true;
    const auto made = meshFactory::make(testTime(), b);
    CHECK(most(behind(made, yMax, 10)) == Approx(0.3).epsilon(1e-12));
}


TEST_CASE("The flanks of a blunt wedge are not two sides", "[bodyThickness]")
{
    // Roofs: y from -h (1 - x) to h (1 - x)
    for (const scalar h : {1.0, 0.3})
    {
        meshFactory::block b(plate());
        b.lower = point(0, -1, 0);
        b.upper = point(0.8, 1, 1);
        b.map = [h](const point& p)
        {
            return point(p.x(), h*(1 - p.x())*p.y(), p.z());
        };
        const auto made = meshFactory::make(testTime(), b);
        if (h == 1)
        {
            CHECK(least(behind(made, yMin, 0.1)) == GREAT);
            continue;
        }
        // Over the other flank, along the normal, from the middle of the last
        // of four faces
        const scalar angle = std::atan(h);
        CHECK
        (
            least(behind(made, yMin, 0.5))
         == Approx(2*h*(1 - 0.7)*std::cos(angle)/std::cos(2*angle))
        );
    }
}


// ************************************************************************* //
