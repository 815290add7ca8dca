/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What contact does to the nodes of a body: the velocities that the rule of
    contact compares, the forces that move it, their power.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "IStringStream.H"
#include "meshFactory.H"
#include "bodyContact.H"
#include "prescribedMotion.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

constexpr scalar rho = 2, deltaT = 0.1;

prescribedMotion moving()
{
    IStringStream is("velocity (1 2 3);");
    return prescribedMotion(dictionary(is), "velocity", false);
}

//- A block that touches something with its sides xMin and yMin, of which the
//  latter is held; in motion, with rates
struct touchingBlock
{
    const meshFactory::result made;
    const medianDual dual;
    const symmetryConstraint mirrors;
    const prescribedMotion motion;
    const heldNodes held;
    vertexData data;
    bodyContact contact;
    boolList touches, holds;

    touchingBlock()
    :
        made(meshFactory::make(testTime(), meshFactory::block())),
        dual(*made.mesh, medianDual::cellTreatment::simplicial),
        mirrors(dual, labelList()),
        motion(moving()),
        held
        (
            dual, mirrors,
            List<heldNodes::condition>({heldNodes::condition{2, &motion}})
        ),
        data(dual, schemeOptions(), kinematicSet::F, true, rho, 3, 1.5),
        contact(data, mirrors, held),
        touches(dual.nNodes(), false),
        holds(dual.nNodes(), false)
    {
        scalarField marks(dual.nNodes(), Zero);
        for (const label patchi : {0, 2})
        {
            for (const label a : dual.patches()[patchi].cornerNode)
            {
                touches[a] = true;
                holds[a] = holds[a] || patchi == 2;
                marks[a] = 1;
            }
        }
        contact.start();
        contact.findNodes(marks);
        for (label a = 0; a < dual.nNodes(); ++a)
        {
            for (label i = 0; i < 3; ++i)
            {
                data.state.lm[3*a + i] = rho*velocity(a)[i];
                data.rates[a*data.strideRates + i] = rate(a)[i];
            }
        }
    }

    static vector velocity(const label a) { return vector(a, 1, -a); }
    static vector rate(const label a) { return vector(3, -a, 5); }
    static vector force(const label a) { return vector(1 + a, 7, -2*a); }

    void push()
    {
        for (const label a : contact.nodes()) contact.add(a, force(a));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("nodes of contact are those of its patches", "[contact][serial]")
{
    const touchingBlock b;
    label n = 0;
    for (const bool touching : b.touches) n += touching;
    CHECK(b.contact.on());
    CHECK(b.contact.nodes().size() == n);
    for (const label a : b.contact.nodes()) CHECK(b.touches[a]);
}


TEST_CASE("velocities without and with contact", "[contact][serial]")
{
    touchingBlock b;
    b.contact.setStep(deltaT);
    CHECK(b.contact.gives() == 1);
    b.push();
    scalarField work(3*b.dual.nNodes(), Zero);
    b.contact.updateVelocity(work);
    for (const label a : b.contact.nodes())
    {
        const vector without(b.velocity(a) + deltaT/rho*b.rate(a));
        const vector by
        (
            b.holds[a] ? vector(Zero)
          : deltaT/rho/b.dual.nodeVolume()[a]*b.force(a)
        );
        CHECK
        (
            mag(b.contact.velocityWithout(a) - without)
         <= 1e-14*mag(without)
        );
        CHECK
        (
            mag(b.contact.velocityWith(a) - without - by)
         <= 1e-14*(mag(without) + mag(by))
        );
    }
    // It begins anew
    for (const scalar f : b.contact.forces()) CHECK(f == 0);
}


TEST_CASE("within a block the surface gives way by half of it",
    "[contact][serial]")
{
    touchingBlock b;
    const scalar block = 6*deltaT;
    b.contact.setBlock(deltaT, block);
    CHECK(b.contact.step() == deltaT);
    CHECK(b.contact.ahead() == Approx(0.5*block));
    CHECK
    (
        b.contact.gives()*deltaT == Approx(bodyContact::blockGives*0.5*block)
    );
    const label a = b.contact.nodes()[0];
    CHECK
    (
        mag
        (
            b.contact.velocityWithout(a)
          - b.velocity(a) - 0.5*block/rho*b.rate(a)
        )
     <= 1e-14
    );
}


TEST_CASE("what is held has no force, and is told", "[contact][serial]")
{
    touchingBlock b;
    b.push();
    scalarField sums(3*b.dual.nNodes(), Zero);
    vectorField taken(b.dual.nNodes(), vector::zero);
    b.contact.sum(sums);
    b.contact.hold
    (
        sums, [&](const label a, const label i, const scalar f)
        {
            taken[a][i] += f;
        }
    );
    scalar power = 0;
    scalarField v(3*b.dual.nNodes());
    for (label a = 0; a < b.dual.nNodes(); ++a)
    {
        const scalar V = b.dual.nodeVolume()[a];
        for (label i = 0; i < 3; ++i) v[3*a + i] = b.velocity(a)[i];
        if (b.touches[a]) power += b.force(a) & b.velocity(a);
        const vector f(b.touches[a] ? b.force(a) : vector(Zero));
        const vector itsHeld(b.holds[a] ? f : vector(Zero));
        const vector left(b.dual.expand(sums.cdata() + 3*a));
        CHECK(mag(V*left - (f - itsHeld)) <= 1e-14*mag(f));
        CHECK(mag(V*taken[a] - itsHeld) <= 1e-14*mag(f));
    }
    CHECK(b.contact.power(v) == Approx(power));

    b.contact.clearAll();
    CHECK(b.contact.power(v) == 0);
    for (const label a : b.contact.nodes()) CHECK(b.contact.gap[a] == GREAT);
}


// ************************************************************************* //
