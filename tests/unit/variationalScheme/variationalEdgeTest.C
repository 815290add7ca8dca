/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Motion and dissipation of one edge, as scalars and as lanes; the order in
    which loops come to edges and nodes; halves and fours of rows.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "meshFactory.H"
#include "edgeBlocks.H"
#include "edgeRows.H"
#include "variationalEdge.H"
#include "FixedList.H"

#include <random>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::mt19937 generator(1);

scalar any()
{
    return std::uniform_real_distribution<scalar>(-1, 1)(generator);
}

//- An edge of a body that moves somehow
struct movingEdge
{
    scalar dx[3], dv[3], change[3], c[3], CC, leftOut, share, factor;

    movingEdge()
    {
        CC = 0;
        for (int i = 0; i < 3; ++i)
        {
            dx[i] = any();
            dv[i] = any();
            change[i] = any();
            c[i] = any();
            CC += sqr(any());
        }
        leftOut = mag(any());
        share = mag(any());
        factor = 1 + mag(any());
    }

    edgeMotion<3, scalar> motion() const
    {
        return edgeMotion<3, scalar>(dx, dv, change);
    }

    edgeDissipation<3, scalar> dissipation() const
    {
        return edgeDissipation<3, scalar>
        (
            motion(), c, CC, factor, leftOut, share, 1.5, 0.7
        );
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("an edge that only turns has no jump", "[variational][serial]")
{
    for (int k = 0; k < 100; ++k)
    {
        const scalar spin[3] = {any(), any(), any()};
        const scalar dx[3] = {any(), any(), any()};
        const scalar dv[3] =
        {
            spin[1]*dx[2] - spin[2]*dx[1],
            spin[2]*dx[0] - spin[0]*dx[2],
            spin[0]*dx[1] - spin[1]*dx[0]
        };
        const edgeMotion<3, scalar> m(dx, dv, dv);
        for (int i = 0; i < 3; ++i) CHECK(m.jump[i] == 0);
        CHECK(mag(m.stretching) < 1e-13);
        CHECK(mag(m.closing) < 1e-13);
    }
}


TEST_CASE("an edge that gets shorter", "[variational][serial]")
{
    const scalar dx[3] = {2, 0, 0}, dv[3] = {-0.5, 0.3, 0};
    const scalar none[3] = {0, 0, 0};
    const edgeMotion<3, scalar> m(dx, dv, none);
    CHECK(m.closing == Approx(0.25));
    CHECK(m.jj == Approx(0.25));
    CHECK(m.mm == 0);
    CHECK(m.perLength2 == Approx(0.25));
}


TEST_CASE("dissipation of an edge has a sign", "[variational][serial]")
{
    for (int k = 0; k < 1000; ++k)
    {
        const movingEdge e;
        const edgeMotion<3, scalar> m = e.motion();
        const edgeDissipation<3, scalar> f = e.dissipation();

        // By the jump with what is left out of the stretching; and the powers
        // of the forces by the velocities and of their adjoint by L dx, of
        // which both nodes have half, are the same
        scalar byJump = 0, byMotion = 0;
        for (int i = 0; i < 3; ++i)
        {
            byJump +=
                f.s[i]*(m.jump[i] + e.leftOut*m.stretching*e.dx[i]);
            byMotion += f.s[i]*e.dv[i] + 2*f.z[i]*e.change[i];
        }
        CHECK(byJump >= 0);
        CHECK(byMotion == Approx(byJump).epsilon(1e-10).margin(1e-13));
    }
}


TEST_CASE("an edge of a line is one in space", "[variational][serial]")
{
    for (int k = 0; k < 100; ++k)
    {
        const movingEdge e;
        const auto alone = [](const scalar* v)
        {
            return FixedList<scalar, 3>{v[0], 0, 0};
        };
        const auto dx = alone(e.dx), dv = alone(e.dv);
        const auto change = alone(e.change), c = alone(e.c);
        const scalar CC = sqr(e.c[0]);
        const edgeMotion<1, scalar> m(e.dx, e.dv, e.change);
        const edgeMotion<3, scalar> its
        (
            dx.cdata(), dv.cdata(), change.cdata()
        );
        CHECK(m.jump[0] == its.jump[0]);
        CHECK(m.stretching == Approx(its.stretching));
        CHECK(m.closing == Approx(its.closing));
        CHECK(m.jj == Approx(its.jj));
        CHECK(m.mm == Approx(its.mm));

        const edgeDissipation<1, scalar> f
        (
            m, e.c, CC, e.factor, e.leftOut, e.share, 1.5, 0.7
        );
        const edgeDissipation<3, scalar> itsForce
        (
            its, c.cdata(), CC, e.factor, e.leftOut, e.share, 1.5, 0.7
        );
        CHECK(f.s[0] == Approx(itsForce.s[0]));
        CHECK(f.z[0] == Approx(itsForce.z[0]).margin(1e-12));
    }
}


TEST_CASE("lanes of edges are edges", "[variational][lanes][serial]")
{
    movingEdge edges[nLanes];
    lanes dx[3], dv[3], change[3], c[3], CC, leftOut, share, factor;
    for (int l = 0; l < nLanes; ++l)
    {
        const movingEdge& e = edges[l];
        for (int i = 0; i < 3; ++i)
        {
            dx[i][l] = e.dx[i];
            dv[i][l] = e.dv[i];
            change[i][l] = e.change[i];
            c[i][l] = e.c[i];
        }
        CC[l] = e.CC;
        leftOut[l] = e.leftOut;
        share[l] = e.share;
        factor[l] = e.factor;
    }
    const edgeMotion<3, lanes> m(dx, dv, change);
    const edgeDissipation<3, lanes> f
    (
        m, c, CC, factor, leftOut, share, 1.5, 0.7
    );
    for (int l = 0; l < nLanes; ++l)
    {
        const edgeDissipation<3, scalar> one = edges[l].dissipation();
        for (int i = 0; i < 3; ++i)
        {
            CHECK(f.s[i][l] == Approx(one.s[i]).epsilon(1e-12));
            CHECK(f.z[i][l] == Approx(one.z[i]).epsilon(1e-12));
        }
    }
}


TEST_CASE("nodes are met before their edges, once", "[variational][serial]")
{
    meshFactory::block block;
    block.n = {5, 4, 3};
    const auto made = meshFactory::make(testTime(), block);
    const medianDual dual
    (
        *made.mesh, medianDual::cellTreatment::simplicial
    );
    label nMet = 0, nEdges = 0, wrong = 0;
    const auto meet = [&](const label a) { wrong += a != nMet++; };
    const labelList toMeet(edgeBlocks::toMeet(dual));

    // In two parts
    edgePass pass;
    for (const label end : {10*nLanes, dual.nEdges()})
    {
        pass.end = end;
        edgeBlocks edges(dual, toMeet, pass);
        for (; edges.valid(); ++edges)
        {
            edges.ahead(meet);
            const label* ends = edges.nodes();
            for (int l = 0; l < nLanes; ++l)
            {
                const label e = min(edges.first() + l, dual.nEdges() - 1);
                wrong += ends[2*l] != dual.edgeNodes()[2*e];
                wrong += ends[2*l + 1] != dual.edgeNodes()[2*e + 1];
                wrong += ends[2*l] >= ends[2*l + 1] || ends[2*l + 1] >= nMet;
            }
            nEdges += edges.size();
        }
        const label done = edges.leave(pass, meet);
        for (label e = 0; e < dual.nEdges(); ++e)
        {
            wrong += (dual.edgeNodes()[2*e] < done) && e >= end;
        }
        CHECK(pass.met == nMet);
        CHECK(pass.edge == end);
    }
    CHECK(wrong == 0);
    CHECK(nEdges == dual.nEdges());
    CHECK(nMet == dual.nNodes());
}


TEST_CASE("late nodes are left to the caller", "[variational][serial]")
{
    const labelList late({0, 3, 4, 9});
    DynamicList<label> done;
    edgePass pass;
    for (const label end : {0, 2, 2, 4, 10})
    {
        completeNodes complete(late, pass);
        complete.before(end, [&](const label a) { done.append(a); });
    }
    CHECK(done == labelList({1, 2, 5, 6, 7, 8}));
    CHECK(pass.complete == 10);
    CHECK(pass.late == 4);
}


TEST_CASE("a pass goes as far as nodes are complete", "[variational][serial]")
{
    meshFactory::block block;
    block.n = {3, 3, 10};
    const auto made = meshFactory::make(testTime(), block);
    const medianDual dual
    (
        *made.mesh, medianDual::cellTreatment::simplicial
    );
    labelList toMeet(edgeBlocks::toMeet(dual));

    // A pair that reaches farther than any edge
    const label far = dual.nNodes() - 2;
    edgeBlocks::meetPairs(toMeet, dual, {20, far});
    label wrong = 0;
    for (label complete = 0; complete <= dual.nNodes(); ++complete)
    {
        const label end = edgeBlocks::mayGo(dual, toMeet, 0, complete);
        for (label e = 0; e < end; ++e)
        {
            wrong += dual.edgeNodes()[2*e + 1] >= complete;
            wrong += dual.edgeNodes()[2*e] > 20 && complete <= far;
        }
    }
    CHECK(wrong == 0);
    CHECK(edgeBlocks::mayGo(dual, toMeet, -1, 0) == -1);
    CHECK(edgeBlocks::mayGo(dual, toMeet, 0, 40) > 0);
    CHECK
    (
        edgeBlocks::mayGo(dual, toMeet, 0, dual.nNodes()) == dual.nEdges()
    );
}


TEST_CASE("halves of rows, and rows of four", "[lanes][serial]")
{
    const row<8> r = {0, 1, 2, 3, 4, 5, 6, 7};
    const row<8> by = halves(10, 20);
    const row<8> joint = spliced(upper(r), r);
    const row<4> three = threeOf(upper(r));
    for (int k = 0; k < 4; ++k)
    {
        CHECK(lower(r)[k] == k);
        CHECK(upper(r)[k] == k + 4);
        CHECK(by[k] == 10);
        CHECK(by[k + 4] == 20);
        CHECK(joint[k] == k + 4);
        CHECK(joint[k + 4] == k + 4);
        CHECK(three[k] == (k < 3 ? k + 4 : 0));
    }

    lanes of[4];
    fourLanesOf(of, [](const int l)
    {
        return row<4>{10.0*l, 10.0*l + 1, 10.0*l + 2, 10.0*l + 3};
    });
    row<4> rows[nLanes];
    fourRowsOf(rows, of);
    for (int l = 0; l < nLanes; ++l)
    {
        for (int k = 0; k < 4; ++k)
        {
            CHECK(of[k][l] == 10*l + k);
            CHECK(rows[l][k] == 10*l + k);
        }
    }
}


TEST_CASE("chosen scalars of rows, and rows of two", "[lanes][serial]")
{
    const row<8> r = {0, 1, 2, 3, 4, 5, 6, 7};
    const row<8> other = {7, 6, 5, 4, 3, 2, 1, 0}, high = r + 10;
    const row<4> few = picked<5, 8, 0, 5>(r);
    const row<8> all = picked<8, 0, 8, 7, 1, 2, 3, 4>(r);
    const scalar four[] = {5, 0, 0, 5}, eight[] = {0, 0, 0, 7, 1, 2, 3, 4};
    const row<8> least = leastAt<0x81, 8>(high, r, other);
    const row<4> leastOfFour =
        leastAt<0x5, 4>(lower(high), lower(other), lower(r));
    const scalar* at = reinterpret_cast<const scalar*>(&r);
    const row<8> twice = twiceAt(at + 3);
    for (int k = 0; k < 8; ++k)
    {
        CHECK(all[k] == eight[k]);
        CHECK(least[k] == (k == 0 || k == 7 ? 0 : k + 10));
        CHECK(twice[k] == 3 + k % 4);
        if (k > 3) continue;
        CHECK(few[k] == four[k]);
        CHECK(leastOfFour[k] == (k == 0 || k == 2 ? k : k + 10));
    }

    lanes first, last;
    for (int l = 0; l < nLanes; ++l)
    {
        first[l] = l;
        last[l] = 100 + l;
    }
    row<2> rows[nLanes];
    twoRowsOf(rows, first, last);
    for (int l = 0; l < nLanes; ++l)
    {
        CHECK(rows[l][0] == l);
        CHECK(rows[l][1] == 100 + l);
    }
}


TEST_CASE("values of nodes that are some scalars apart", "[lanes][serial]")
{
    scalar values[5*nLanes];
    for (int k = 0; k < 5*nLanes; ++k) values[k] = k;
    for (int n = 1; n <= nLanes; ++n)
    {
        const lanes at = stridedLanes(5, n)(values + 2);
        for (int l = 0; l < nLanes; ++l) CHECK(at[l] == 5*min(l, n - 1) + 2);
    }
}


// ************************************************************************* //
