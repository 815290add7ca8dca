/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Interface states of the acoustic Riemann problem with contact-stick:
    equations (19), (20), (27)-(39) of the paper.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "randomSides.H"

using namespace Foam;
using namespace Foam::acousticRiemann;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

const label nSamples = 500;
const scalar tol = 1e-13;   // states of order 1, impedances up to 10

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("tangential part (32)", "[acousticRiemann][serial]")
{
    Random random(1);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const vector a(randomVector(random)), n(randomNormal(random));
        const vector at(tangential(a, n));
        CHECK(mag(at & n) <= tol);
        CHECK(maxDiff((a & n)*n + at, a) <= tol);
    }
}


TEST_CASE
(
    "contact-stick as printed (30), (33), (34)",
    "[acousticRiemann][serial]"
)
{
    Random random(2);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random)), R(randomSide(random));
        const vector n(randomNormal(random));

        // (30)
        const scalar vnL = L.v & n, vnR = R.v & n;
        const scalar tnL = L.t & n, tnR = R.t & n;
        const scalar zp = L.zp + R.zp;
        const scalar vn = (L.zp*vnL + R.zp*vnR)/zp + (tnR - tnL)/zp;
        const scalar tn =
            L.zp*R.zp/zp*(tnL/L.zp + tnR/R.zp) + L.zp*R.zp/zp*(vnR - vnL);

        CHECK(mag(stickVelocity(L.zp, vnL, tnL, R.zp, vnR, tnR) - vn) <= tol);
        CHECK(mag(stickTraction(L.zp, vnL, tnL, R.zp, vnR, tnR) - tn) <= tol);

        // (33)
        const vector vtL(L.v - vnL*n), vtR(R.v - vnR*n);
        const vector ttL(L.t - tnL*n), ttR(R.t - tnR*n);
        const scalar zs = L.zs + R.zs;
        const vector vt((L.zs*vtL + R.zs*vtR)/zs + (ttR - ttL)/zs);
        const vector tt
        (
            L.zs*R.zs/zs*(ttL/L.zs + ttR/R.zs) + L.zs*R.zs/zs*(vtR - vtL)
        );

        // (34)
        CHECK(maxDiff(stickTraction(L, R, n), tn*n + tt) <= tol);
        CHECK(maxDiff(stickVelocity(L, R, n), vn*n + vt) <= tol);

        const solution s(stuck(L, R, n));
        CHECK(s.state == status::stick);
        CHECK(maxDiff(s.t, tn*n + tt) <= tol);
        CHECK(maxDiff(s.vMinus, vn*n + vt) <= tol);
        CHECK(s.vMinus == s.vPlus);
    }
}


TEST_CASE
(
    "contact-stick satisfies the jump conditions (29)",
    "[acousticRiemann][serial]"
)
{
    Random random(3);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random)), R(randomSide(random));
        const vector n(randomNormal(random));
        const solution s(stuck(L, R, n));

        const vector jumpL(L.v - s.vMinus), jumpR(R.v - s.vPlus);
        CHECK
        (
            maxDiff
            (
                L.zp*(jumpL & n)*n + L.zs*tangential(jumpL, n), L.t - s.t
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                R.zp*(jumpR & n)*n + R.zs*tangential(jumpR, n), s.t - R.t
            ) <= tol
        );
    }
}


TEST_CASE("impact of two bars (19), (20)", "[acousticRiemann][serial]")
{
    const scalar v0 = 3, z = 7;
    const vector n(1, 0, 0);
    const side L{v0*n, Zero, z, z/2}, R{Zero, Zero, z, z/2};

    const solution s(coulombContact(L, R, n, 0));
    CHECK(s.state == status::stick);
    CHECK(s.vMinus.x() == Approx(v0/2).epsilon(1e-15));
    CHECK(s.vPlus.x() == Approx(v0/2).epsilon(1e-15));
    CHECK(s.t.x() == Approx(-z*v0/2).epsilon(1e-15));
    CHECK(maxDiff(s.t, s.t.x()*n) == 0);

    // (19a), (19b)
    CHECK(z*(v0 - s.vMinus.x()) == Approx(0 - s.t.x()).epsilon(1e-15));
    CHECK(z*(0 - s.vPlus.x()) == Approx(-(0 - s.t.x())).epsilon(1e-15));
}


TEST_CASE("two dissimilar bars up to release", "[acousticRiemann][serial]")
{
    // Impedances 0.7 and 1, left bar at 0.1 m/s
    const vector n(0, 1, 0);
    const auto contact = [&]
    (
        const scalar vL, const scalar tL, const scalar vR, const scalar tR
    )
    {
        const side L{vL*n, tL*n, 0.7, 0.5}, R{vR*n, tR*n, 1, 0.6};
        return contactOrRelease(L, R, n, 0.3);
    };

    const scalar v1 = 0.07/1.7, t1 = -0.07/1.7;
    const solution impact(contact(0.1, 0, 0, 0));
    CHECK(impact.state == status::stick);
    CHECK(impact.vMinus.y() == Approx(v1).epsilon(1e-14));
    CHECK(impact.vPlus.y() == Approx(v1).epsilon(1e-14));
    CHECK(impact.t.y() == Approx(t1).epsilon(1e-14));

    // The wave returns from the free end of the right bar: still in contact
    const scalar v2 = (0.7*v1 + 2*v1 - t1)/1.7, t2 = (t1 + 0.7*v1)/1.7;
    const solution back(contact(v1, t1, 2*v1, 0));
    CHECK(back.state == status::stick);
    CHECK(back.vPlus.y() == Approx(v2).epsilon(1e-14));
    CHECK(back.vPlus.y() == Approx(0.0896194).epsilon(1e-6));
    CHECK(back.t.y() == Approx(t2).epsilon(1e-13));
    CHECK(back.t.y() == Approx(-0.0072664).epsilon(1e-5));

    // The wave returns from the left bar: release
    const solution release(contact(2*v1 - 0.1, 0, v2, t2));
    CHECK(release.state == status::open);
    CHECK(release.t == vector::zero);
    CHECK(release.vMinus.y() == Approx(-0.0176471).epsilon(1e-5));
    CHECK(release.vPlus.y() == Approx(2*v1).epsilon(1e-13));
}


TEST_CASE("jump of the pressure only (36), (37)", "[acousticRiemann][serial]")
{
    Random random(4);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random));
        side R(randomSide(random));
        const vector n(randomNormal(random));
        const scalar jump = randomScalar(random);   // [SigmaJ] Lambda_H
        R.t = L.t + jump*n;

        // Less the mean by impedances
        const vector dv
        (
            stickVelocity(L, R, n)
          - (L.zp*(L.v & n) + R.zp*(R.v & n))/(L.zp + R.zp)*n
          - (L.zs*tangential(L.v, n) + R.zs*tangential(R.v, n))/(L.zs + R.zs)
        );
        CHECK(maxDiff(dv, jump/(L.zp + R.zp)*n) <= tol);
    }
}


TEST_CASE("the same material on both sides (38)", "[acousticRiemann][serial]")
{
    Random random(5);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random));
        side R(randomSide(random));
        R.zp = L.zp;
        R.zs = L.zs;
        const vector n(randomNormal(random));
        const vector dv(R.v - L.v), dt(R.t - L.t);

        CHECK
        (
            maxDiff
            (
                stickTraction(L, R, n),
                0.5*(L.t + R.t)
              + 0.5*L.zp*(dv & n)*n + 0.5*L.zs*(dv - (dv & n)*n)
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                stickVelocity(L, R, n),
                0.5*(L.v + R.v)
              + 0.5/L.zp*(dt & n)*n + 0.5/L.zs*(dt - (dt & n)*n)
            ) <= 10*tol
        );
    }
}


TEST_CASE
(
    "rigid surface: limit of infinite impedance (39)",
    "[acousticRiemann][serial]"
)
{
    Random random(6);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random));
        side R(randomSide(random));
        const vector n(randomNormal(random));
        const vector rigid(rigidTraction(L, R.v, n));

        // As printed
        const vector dv(R.v - L.v);
        CHECK
        (
            maxDiff
            (
                rigid, L.t + L.zp*(dv & n)*n + L.zs*(dv - (dv & n)*n)
            ) <= tol
        );

        // The traction of the right side drops out, its velocity remains
        for (const scalar ratio : {1e4, 1e8, 1e12})
        {
            R.zp = ratio*L.zp;
            R.zs = ratio*L.zs;
            const scalar bound = 100/ratio + tol;
            CHECK(maxDiff(stickTraction(L, R, n), rigid) <= bound);
            CHECK(maxDiff(stickVelocity(L, R, n), R.v) <= 10*bound);
        }

        // Does not give energy to the body beyond the work of the wall
        CHECK(((rigid - L.t) & dv) >= 0);
        CHECK(maxDiff(rigidTraction(L, L.v, n), L.t) <= tol);
    }
}


TEST_CASE("impedance ratio of a million", "[acousticRiemann][serial]")
{
    const vector n(1, 0, 0);
    const side L{vector(1, 2, 0), vector(-3, 1, 0), 1e-3, 5e-4};
    const side R{vector(-1, 0, 1), vector(-2, 0, 2), 1e3, 5e2};

    const solution s(stuck(L, R, n));
    CHECK(1e-3*(1 - s.vMinus.x()) == Approx(-3 - s.t.x()).epsilon(1e-9));
    CHECK(5e-4*(2 - s.vMinus.y()) == Approx(1 - s.t.y()).epsilon(1e-9));
    CHECK(1e3*(-1 - s.vPlus.x()) == Approx(s.t.x() + 2).epsilon(1e-9));
    CHECK(5e2*(1 - s.vPlus.z()) == Approx(s.t.z() - 2).epsilon(1e-9));
}


// ************************************************************************* //
