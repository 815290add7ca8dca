/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What contact sends and tells: records of scalars, answers that add up, and
    the state of an overlap.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "contactAnswer.H"
#include "overlapState.H"
#include "scalarRecord.H"
#include "surfaceState.H"
#include "contactFace.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

namespace
{

template<class T>
T sentAndRead(const T& record)
{
    scalar buffer[scalarRecord::size<T>() + 1];
    scalar* out = buffer;
    scalarRecord::put(record, out);
    CHECK(out == buffer + scalarRecord::size<T>());

    T back;
    const scalar* in = buffer;
    scalarRecord::get(back, in);
    CHECK(in == out);
    return back;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Records are their scalars, in their order", "[contact][serial]")
{
    surfaceState s;
    s.x = point(1, 2, 3);
    s.v = vector(4, 5, 6);
    s.n = vector(0, 0, 1);
    s.stretch = 1.5;
    s.compliance = 0.25;
    s.inner = 1;
    const surfaceState t(sentAndRead(s));
    CHECK(t.x == s.x);
    CHECK(t.v == s.v);
    CHECK(t.n == s.n);
    CHECK(t.stretch == s.stretch);
    CHECK(t.compliance == s.compliance);
    CHECK(t.inner == s.inner);
    for (label i = 0; i < 6; ++i) CHECK(scalarRecord::cdata(t)[i] == i + 1);
    CHECK(scalarRecord::size<surfaceState>() == surfaceRows*nLanes);

    nodeAnswer a;
    a.force = vector(1, -2, 3);
    a.area = 4;
    a.gap = -0.5;
    a.status = 2;
    a.nodeForce = vector(7, 8, 9);
    const nodeAnswer b(sentAndRead(a));
    CHECK(b.force == a.force);
    CHECK(b.area == a.area);
    CHECK(b.gap == a.gap);
    CHECK(b.status == a.status);
    CHECK(b.nodeForce == a.nodeForce);

    // The bytes of a face are sent as they are
    CHECK(std::is_trivially_destructible<contactFace>::value);
    CHECK(sizeof(contactFace) % sizeof(scalar) == 0);
}


TEST_CASE("Answers add up, but the least gap and the largest status",
    "[contact][serial]")
{
    fluxAnswer sum;
    CHECK(sum.gap == GREAT);
    CHECK(sum.status == 0);

    fluxAnswer a;
    a.force = vector(1, 0, 0);
    a.area = 2;
    a.gap = 0.25;
    a.status = 2;
    a.tractionFlux = vector(0, 3, 0);
    a.velocityFlux = vector(0, 0, 5);
    fluxAnswer b(a);
    b.gap = -0.125;
    b.status = 1;
    for (const fluxAnswer* more : {&a, &b}) sum += *more;
    CHECK(sum.force == vector(2, 0, 0));
    CHECK(sum.area == 4);
    CHECK(sum.gap == -0.125);
    CHECK(sum.status == 2);
    CHECK(sum.tractionFlux == vector(0, 6, 0));
    CHECK(sum.velocityFlux == vector(0, 0, 10));

    nodeAnswer node;
    nodeAnswer other;
    other.nodeForce = vector(1, 2, 3);
    node += other;
    node += other;
    CHECK(node.nodeForce == vector(2, 4, 6));
    CHECK(node.gap == GREAT);
}


TEST_CASE("The state of an overlap at its centroid", "[contact][serial]")
{
    contactOverlap over;
    over.minus.area = 2;
    over.plus.area = 3;
    const surfacePlace below{point(0, 0, 0), vector(0, 1, 0), 1.5};
    surfacePlace above{point(0.5, 0.1, 0), vector(0, -1, 0), 0.5};

    const overlapState facing(over, below, above);
    CHECK(facing.opposed);
    CHECK(mag(facing.n - vector(0, 1, 0)) < 1e-15);
    CHECK(facing.gap == Approx(0.1).epsilon(1e-15));
    CHECK(facing.minusArea == 3);
    CHECK(facing.plusArea == 1.5);
    CHECK(facing.area == 2.25);

    // An edge of what is above, on what is below, and edges that cross
    above.n = vector(0.8, -0.6, 0);
    contactOverlap edge(over);
    edge.normal.plus = 0;
    const overlapState lying(edge, below, above);
    CHECK(lying.opposed);
    CHECK(mag(lying.n - below.n) < 1e-15);
    CHECK(lying.gap == Approx(0.1).epsilon(1e-15));
    edge.normal.plus = 1;
    edge.normal.crossing = 1;
    const overlapState crossing(edge, below, above, vector(0, -1, 0));
    CHECK(mag(crossing.n - below.n) < 1e-15);
    above.n = vector(1, -0.05, 0);
    CHECK_FALSE(overlapState(edge, below, above, vector(0, -1, 0)).opposed);

    above.n = vector(0, 1, 0);
    const overlapState aside(over, below, above);
    CHECK_FALSE(aside.opposed);
    CHECK(mag(aside.n - below.n) < 1e-15);
}


TEST_CASE("The mean of records by the weights of a stencil",
    "[contact][serial]")
{
    contactStencil s;
    s.size = 2;
    s.corner[0] = 2;
    s.corner[1] = 0;
    s.value[0] = 0.75;
    s.value[1] = 0.25;
    List<surfacePlace> places(3);
    places[0] = {point(4, 0, 0), vector(1, 0, 0), 2};
    places[1] = {point(GREAT, 0, 0), vector::zero, GREAT};
    places[2] = {point(0, 8, 0), vector(0, 1, 0), 1};
    const surfacePlace mean(scalarRecord::mean(s, places));
    CHECK(mean.x == point(1, 6, 0));
    CHECK(mean.n == vector(0.25, 0.75, 0));
    CHECK(mean.stretch == 1.25);
}


// ************************************************************************* //
