/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Mass, centre and inertia of a rigid region by its mesh.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "meshFactory.H"
#include "rigidMass.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Test Cases  * * * * * * * * * * * * * * * //

TEST_CASE("inertia of a brick, and of a flat mesh that is thick", "[serial]")
{
    for (const bool flat : {false, true})
    {
        // In two dimensions a tenth of a micrometre wide, a metre thick
        const scalar size = flat ? 1e-7 : 1;
        const vector lengths(size, 2*size, flat ? 1 : 3);
        meshFactory::block block;
        block.n = {3, 2, flat ? 1 : 2};
        block.isEmpty = {false, false, flat};
        block.lower = point(size, 0, 3);
        block.upper = block.lower + lengths;
        const auto made = meshFactory::make(testTime(), block);
        const medianDual dual
        (
            *made.mesh, medianDual::cellTreatment::simplicial
        );
        dictionary dict;
        dict.add("mass", 12.0);
        const rigidMass its(dict, dual);

        CHECK(its.mass == 12);
        CHECK(its.centre.x() == Approx(1.5*size));
        CHECK(its.centre.y() == Approx(size));
        CHECK
        (
            its.inertia.zz()
         == Approx(sqr(lengths.x()) + sqr(lengths.y())).epsilon(1e-10)
        );
        CHECK(mag(its.inertia.xy()) < 1e-12*its.inertia.zz());
        if (flat) continue;
        CHECK(its.centre.z() == Approx(4.5));
        CHECK(its.inertia.xx() == Approx(13));
        CHECK(its.inertia.yy() == Approx(10));
    }
}


// ************************************************************************* //
