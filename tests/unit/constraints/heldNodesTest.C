/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Nodes of prescribed motion: what is held, what they are given, and which
    patch has the force; and the way that friction remembers.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "IStringStream.H"
#include "meshFactory.H"
#include "medianDual.H"
#include "heldNodes.H"
#include "prescribedMotion.H"
#include "slideMemory.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

prescribedMotion motionOf
(
    const char* text,
    const char* keyword,
    const bool ofDisplacement
)
{
    IStringStream is(text);
    return prescribedMotion(dictionary(is), keyword, ofDisplacement);
}

//- A block, three of its patches that meet in a vertex, and what they prescribe
struct heldBlock
{
    const meshFactory::result made;
    const medianDual dual;
    const symmetryConstraint mirrors;
    const prescribedMotion all, moved, along;
    heldNodes held;

    heldBlock()
    :
        made(meshFactory::make(testTime(), meshFactory::block())),
        dual(*made.mesh, medianDual::cellTreatment::simplicial),
        mirrors(dual, labelList()),
        all(motionOf("velocity (1 2 3);", "velocity", false)),
        moved(motionOf("displacement (4 5 6);", "displacement", true)),
        along
        (
            motionOf("velocity 7; direction (0 0 2);", "velocity", false)
        )
    {
        const List<heldNodes::condition> conditions
        ({
            heldNodes::condition{0, &all}, heldNodes::condition{2, &moved},
            heldNodes::condition{4, &along}
        });
        held = heldNodes(dual, mirrors, conditions);
    }

    //- Patch that holds a node: the first of all three that has it
    label patchOf(const label node) const
    {
        for (const label patchi : {0, 2, 4})
        {
            for (const label a : dual.patches()[patchi].cornerNode)
            {
                if (a == node) return patchi;
            }
        }
        return -1;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("held nodes are those of the patches", "[held][serial]")
{
    const heldBlock b;
    labelHashSet expected;
    for (label a = 0; a < b.dual.nNodes(); ++a)
    {
        if (b.patchOf(a) >= 0) expected.insert(a);
    }
    CHECK(labelHashSet(b.held.nodes()) == expected);
    CHECK(label(expected.size()) == b.held.nodes().size());
    CHECK(labelHashSet(b.held.patches()) == labelHashSet({0, 2, 4}));
}


TEST_CASE("what is held is taken, and the patches' share", "[held][serial]")
{
    const heldBlock b;
    label count[3] = {0, 0, 0};
    forAll(b.held.nodes(), k)
    {
        const label patchi = b.patchOf(b.held.nodes()[k]);
        const bool partly = patchi == 4;
        ++count[patchi/2];

        scalar p[3] = {1, -2, 5}, taken[3] = {0, 0, 0};
        b.held.hold
        (
            k, p, [&](const label i, const scalar f) { taken[i] += f; }
        );
        CHECK(p[0] == (partly ? 1 : 0));
        CHECK(p[1] == (partly ? -2 : 0));
        CHECK(p[2] == 0);
        CHECK(taken[0] == (partly ? 0 : 1));
        CHECK(taken[1] == (partly ? 0 : -2));
        CHECK(taken[2] == Approx(5));

        scalar again[3] = {1, -2, 5};
        b.held.hold(k, again);
        for (int i = 0; i < 3; ++i) CHECK(again[i] == p[i]);

        scalar force[3] = {3, 4, 5};
        b.held.share
        (
            k, force, [&]
            (
                const label its, const scalar* direction, const scalar part
            )
            {
                CHECK(its == patchi);
                CHECK(part*direction[2] == Approx(5));
                CHECK(part*direction[0] == Approx(partly ? 0 : 3));
            }
        );
    }
    for (const label n : count) CHECK(n > 0);
}


TEST_CASE("held nodes move as prescribed", "[held][serial]")
{
    heldBlock b;
    constexpr scalar rho = 2, deltaT = 0.1;
    const label n = 3*b.dual.nNodes();
    scalarField lm(n, scalar(-1)), disp(n, scalar(0.5));
    b.held.impose(lm.data(), disp.cdata(), rho, 0, deltaT);
    for (label a = 0; a < b.dual.nNodes(); ++a)
    {
        const label patchi = b.patchOf(a);
        for (label i = 0; i < 3; ++i)
        {
            const scalar expected =
                patchi == 0 ? rho*(i + 1)
              : patchi == 2 ? rho*(i + 4 - 0.5)/deltaT
              : patchi == 4 && i == 2 ? rho*7 : -1;
            CHECK(lm[3*a + i] == Approx(expected));
        }
    }
}


TEST_CASE("what friction remembers", "[contact][serial]")
{
    const heldBlock b;
    slideMemory memory;
    CHECK(!memory.on());
    memory.start(b.dual.nNodes());
    CHECK(memory.on());

    // As deformed, ways are twice as long
    const auto F = [](const label) { return tensor(2*tensor::I); };
    const labelList nodes({3, 5});
    const auto add = [&]
    (
        const scalar area, const vector& way, const scalar kept
    )
    {
        slideMemory::sums s;
        s.way = area*way;
        s.area = area;
        s.kept = area*kept;
        memory.add(3, s);
    };
    add(1, vector(4, 0, 0), 1);
    add(3, vector(0, 4, 0), 1);
    memory.finish(b.dual.sharing(), nodes, F);
    CHECK(mag(memory.ways()[3] - vector(0.5, 1.5, 0)) <= 1e-15);
    CHECK(mag(memory.ways()[5]) == 0);

    // Half is kept on a third of the area; nothing is added
    add(1, vector::zero, 0.5);
    add(2, vector::zero, 1);
    memory.finish(b.dual.sharing(), nodes, F);
    CHECK(mag(memory.ways()[3] - (2.5/3)*vector(0.5, 1.5, 0)) <= 1e-15);

    memory.finish(b.dual.sharing(), nodes, F);
    CHECK(mag(memory.ways()[3]) == 0);
}


// ************************************************************************* //
