/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Body forces made from dictionaries as constant/<region>/bodyForces would:
    accelerations in the directions of the scene, sums, and errors.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "IStringStream.H"
#include "meshFactory.H"
#include "materials/materialPoint.H"
#include "bodyForce.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

//- A block whose middle direction is left out
struct scene
{
    meshFactory::result made;
    medianDual dual;
    autoPtr<materialModel> material;

    scene()
    :
        made(meshFactory::make(testTime(), flat())),
        dual(*made.mesh, medianDual::cellTreatment::simplicial),
        material(materialFrom("type neoHookean; rho 3; E 1; nu 0.3;"))
    {}

    static meshFactory::block flat()
    {
        meshFactory::block block;
        block.n = {{3, 1, 2}};
        block.isEmpty = {{false, true, false}};
        return block;
    }

    PtrList<bodyForce> read(const std::string& text) const
    {
        IStringStream is(text);
        return bodyForce::readAll(dictionary(is), dual, *material);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("uniform body forces add up", "[bodyForce][serial]")
{
    const scene s;
    const PtrList<bodyForce> forces
    (
        s.read
        (
            "shaking"
            "{"
            "    type uniform;"
            "    acceleration table ((0 (0 0 0)) (2 (2 4 8)));"
            "}"
            "weight { type uniform; acceleration (1 0 -10); }"
        )
    );
    REQUIRE(forces.size() == 2);
    CHECK(forces[0].name() == "shaking");
    CHECK(forces[0].type() == "uniform");
    CHECK(forces[1].name() == "weight");

    const label n = s.dual.nNodes();
    REQUIRE(n == 12);
    REQUIRE(s.dual.nDim() == 2);
    for (const scalar time : {0.0, 0.5, 2.0})
    {
        // What is there already remains
        scalarField acceleration(2*n, scalar(100));
        for (const bodyForce& force : forces)
        {
            force.add(time, acceleration);
        }
        for (label a = 0; a < n; ++a)
        {
            CHECK(acceleration[2*a] == Approx(101 + time).epsilon(1e-14));
            CHECK(acceleration[2*a + 1] == Approx(90 + 4*time).epsilon(1e-14));
        }
    }

    CHECK(s.read("FoamFile { object bodyForces; }").empty());
}


TEST_CASE("wrong input of body forces", "[bodyForce][serial]")
{
    const scene s;
    const struct { const char* text; const char* word; } wrong[] =
    {
        {"a { type unifrom; acceleration (1 0 0); }", "Did you mean 'uniform'"},
        {"a { type uniform; aceleration (1 0 0); }", "'acceleration'"},
        {"a { type uniform; }", "acceleration"},
        {"a { type uniform; acceleration 1; }", "acceleration"},
        {"a { type uniform; acceleration sometime; }", "sometime"},
        {"a { acceleration (1 0 0); }", "type"},
        {"a (1 0 0);", "'a' is not a dictionary"}
    };
    for (const auto& w : wrong)
    {
        const string message(errorMessage([&]{ s.read(w.text); }));
        INFO(w.text << " -> " << message);
        CHECK(message.find(w.word) != std::string::npos);
    }
}


// ************************************************************************* //
