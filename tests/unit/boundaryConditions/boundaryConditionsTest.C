/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Boundary conditions of pointU, made from dictionaries as a case would:
    their fluxes, (39) and (44) of the paper, their errors, and that they are
    the same after writing and reading, copying and mapping.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "meshFactory.H"
#include "pointFields.H"
#include "pointPatchFieldMapper.H"
#include "solidBoundaryCondition.H"
#include "tensors/fullTensor.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

typedef pointPatchField<vector> patchField;
typedef DimensionedField<vector, pointMesh> internalField;


//- Conditions on the first patch of a small block
struct patchOfBlock
{
    meshFactory::result made;
    const pointMesh& points;
    internalField U;

    patchOfBlock()
    :
        made(meshFactory::make(testTime(), small())),
        points(pointMesh::New(*made.mesh)),
        U
        (
            IOobject
            (
                "pointU",
                testTime().timeName(),
                *made.mesh,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            points,
            dimensionedVector("0", dimVelocity, vector::zero)
        )
    {}

    static meshFactory::block small()
    {
        meshFactory::block block;
        block.n = {{2, 2, 1}};
        return block;
    }

    const pointPatch& patch() const { return points.boundary()[0]; }

    autoPtr<patchField> make(const std::string& text) const
    {
        IStringStream is(text);
        const dictionary dict(is);
        return patchField::New(patch(), U, dict);
    }
};


const solidBoundaryCondition& condition(const patchField& field)
{
    return dynamic_cast<const solidBoundaryCondition&>(field);
}


//- Corners with random states, solved by a condition
struct solved
{
    dualPatch geometry;
    cornerStates c;

    static dualPatch fiveCorners()
    {
        dualPatch p;
        p.cornerNode.setSize(5, 0);
        return p;
    }

    solved(const patchField& field, const scalar time)
    :
        geometry(fiveCorners()),
        c(geometry, 3, 2)
    {
        Random random(1);
        for (label i = 0; i < c.size(); ++i)
        {
            c.v[i] = randomVector(random);
            c.t[i] = randomVector(random);
            c.n[i] = randomNormal(random);
            c.stretch[i] = 1 + randomScalar(random, 0.5);
            c.tB[i] = c.vB[i] = vector::one;
        }
        condition(field).solve(time, c);
    }
};


//- Normal velocity (47) of a surface of impedance 3 under its traction
vector released(const cornerStates& c, const label i)
{
    const scalar z = 3*max(c.stretch[i], scalar(1));
    return c.v[i] + (((c.tB[i] - c.t[i]) & c.n[i])/z)*c.n[i];
}


//- The same fluxes at two times
void checkSame(const patchField& a, const patchField& b)
{
    CHECK(a.type() == b.type());
    CHECK(condition(a).contact() == condition(b).contact());
    CHECK(condition(a).tractionFree() == condition(b).tractionFree());
    for (const scalar time : {0.25, 1.5})
    {
        const solved A(a, time), B(b, time);
        CHECK(A.c.tB == B.c.tB);
        CHECK(A.c.vB == B.c.vB);
    }
}


struct directMapper
:
    public pointPatchFieldMapper
{
    labelList addresses;

    label size() const { return addresses.size(); }
    bool direct() const { return true; }
    bool hasUnmapped() const { return false; }
    const labelUList& directAddressing() const { return addresses; }
};


const char* const inputs[] =
{
    "type tractionFree;",
    "type contact;",
    "type traction; traction (1 2 3);",
    "type traction; traction table ((0 (0 0 0)) (2 (2 4 6)));",
    "type pressure; pressure 2e5;",
    "type pressure; pressure table ((0 0) (1 5) (2 0));",
    "type fixedVelocity; velocity (0 0 0);",
    "type fixedVelocity; velocity table ((0 (0 0 0)) (2 (2 4 6)));",
    // As others are given, and as newer releases write tables
    "type traction; traction sine; tractionCoeffs"
    "{ amplitude 1; frequency 0.3; scale (1 2 3); level (0 0 1); }",
    "type pressure; pressure sine; pressureCoeffs"
    "{ amplitude 1; frequency 0.3; scale 2; level 1; }",
    "type fixedVelocity; velocity sine; velocityCoeffs"
    "{ amplitude 1; frequency 0.3; scale (1 2 3); level (0 0 1); }"
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("free and contact surfaces (44), (47)",
    "[boundaryConditions][serial]")
{
    const patchOfBlock block;
    for (const char* type : {"tractionFree", "contact"})
    {
        INFO(type);
        const auto field(block.make(std::string("type ") + type + ";"));
        const bool isContact = (word(type) == "contact");
        CHECK(field->type() == type);
        CHECK(condition(*field).contact() == isContact);
        CHECK(condition(*field).tractionFree() == !isContact);

        const solved s(*field, 0);
        for (label i = 0; i < s.c.size(); ++i)
        {
            CHECK(s.c.tB[i] == vector::zero);
            CHECK(mag(s.c.vB[i] - released(s.c, i)) <= 1e-14);
        }
    }
}


TEST_CASE("prescribed traction", "[boundaryConditions][serial]")
{
    const patchOfBlock block;
    const auto field
    (
        block.make("type traction; traction table ((0 (0 0 0)) (2 (2 4 6)));")
    );
    CHECK_FALSE(condition(*field).contact());
    CHECK_FALSE(condition(*field).tractionFree());
    for (const scalar time : {0.0, 0.5, 2.0})
    {
        const solved s(*field, time);
        for (label i = 0; i < s.c.size(); ++i)
        {
            CHECK(mag(s.c.tB[i] - time*vector(1, 2, 3)) <= 1e-14);
            CHECK(mag(s.c.vB[i] - released(s.c, i)) <= 1e-14);
        }
    }
}


TEST_CASE("pressure follows the surface", "[boundaryConditions][serial]")
{
    const patchOfBlock block;
    const auto field
    (
        block.make("type pressure; pressure table ((0 0) (2 8));")
    );
    CHECK_FALSE(condition(*field).contact());
    CHECK_FALSE(condition(*field).tractionFree());
    const solved s(*field, 0.5);
    for (label i = 0; i < s.c.size(); ++i)
    {
        CHECK(mag(s.c.tB[i] + 2*s.c.stretch[i]*s.c.n[i]) <= 1e-14);
        CHECK(mag(s.c.vB[i] - released(s.c, i)) <= 1e-14);
    }
}


TEST_CASE("prescribed velocity (39)", "[boundaryConditions][serial]")
{
    const patchOfBlock block;
    const auto field
    (
        block.make
        (
            "type fixedVelocity; velocity table ((0 (0 0 0)) (2 (2 4 6)));"
        )
    );
    CHECK_FALSE(condition(*field).contact());
    CHECK_FALSE(condition(*field).tractionFree());
    for (const scalar time : {0.0, 0.5})
    {
        const solved s(*field, time);
        const vector wall(time*vector(1, 2, 3));
        for (label i = 0; i < s.c.size(); ++i)
        {
            const vector dv(wall - s.c.v[i]), n(s.c.n[i]);
            CHECK
            (
                mag
                (
                    s.c.tB[i]
                  - (s.c.t[i] + 3*(dv & n)*n + 2*(dv - (dv & n)*n))
                ) <= 1e-14
            );
            CHECK(mag(s.c.vB[i] - wall) <= 1e-15);
        }
    }
}


TEST_CASE("conditions written and read", "[boundaryConditions][serial]")
{
    const patchOfBlock block;
    for (const char* input : inputs)
    {
        INFO(input);
        const auto field(block.make(input));
        OStringStream os;
        field->write(os);
        INFO(os.str());
        checkSame(*field, *block.make(os.str()));
    }
}


TEST_CASE("conditions copied and mapped", "[boundaryConditions][serial]")
{
    const patchOfBlock block;
    const pointPatch& other = block.points.boundary()[1];
    directMapper mapper;
    mapper.addresses.setSize(other.size(), 0);

    for (const char* input : inputs)
    {
        INFO(input);
        const auto field(block.make(input));
        checkSame(*field, *field->clone());
        checkSame(*field, *field->clone(block.U));

        const auto mapped(patchField::New(*field, other, block.U, mapper));
        checkSame(*field, *mapped);
        CHECK(&mapped->patch() == &other);
        CHECK(mapped->size() == other.size());
    }
}


TEST_CASE("wrong input of conditions", "[boundaryConditions][serial]")
{
    const patchOfBlock block;
    const struct { const char* text; const char* word; } wrong[] =
    {
        {"type tractionFree; traction (0 0 0);", "'traction'"},
        {"type contact; friction 0.3;", "'friction'"},
        {"type traction; tracton (0 0 0);", "Did you mean 'traction'"},
        {"type pressure; presure 1;", "Did you mean 'pressure'"},
        {"type fixedVelocity; Velocity (0 0 0);", "Did you mean 'velocity'"},
        {"type traction;", "traction"},
        {"type pressure;", "pressure"},
        {"type fixedVelocity;", "velocity"},
        {"type fixedVelocity; velocity 1;", "velocity"},
        {"type fixedVelocity; velocity sometime;", "sometime"},
        {"type tractionfree;", "tractionFree"}
    };
    for (const auto& w : wrong)
    {
        const string message(errorMessage([&]{ block.make(w.text); }));
        INFO(w.text << " -> " << message);
        CHECK(message.find(w.word) != std::string::npos);
    }

    // What tools such as decomposePar may leave behind
    CHECK
    (
        errorMessage
        (
            [&]
            {
                block.make
                (
                    "type tractionFree; patchType patch;"
                    "value uniform (0 0 0);"
                );
            }
        ) == ""
    );
}


// ************************************************************************* //
