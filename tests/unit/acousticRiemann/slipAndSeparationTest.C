/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Slip and separation, equations (21)-(26) and (40)-(49), and their choice
    by Algorithm 1: complementarity, dissipation and symmetries.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "randomSides.H"

#include <functional>

using namespace Foam;
using namespace Foam::acousticRiemann;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

const label nSamples = 500;
const scalar tol = 1e-13;       // states of order 1, impedances up to 10


//- Normal and tangential part of z a
vector times(const scalar zp, const scalar zs, const vector& a, const vector& n)
{
    return zp*(a & n)*n + zs*(a - (a & n)*n);
}


//- The states that coulombContact chooses, each often enough
void forRandomContacts
(
    const label seed,
    const std::function
    <
        void
        (
            const side&, const side&, const vector&, const scalar,
            const solution&
        )
    >& check
)
{
    Random random(seed);
    label n[3] = {0, 0, 0};
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random)), R(randomSide(random));
        const vector normal(randomNormal(random));
        const scalar k = random.sample01<scalar>();
        const solution s(contactOrRelease(L, R, normal, k));
        ++n[label(s.state)];
        check(L, R, normal, k, s);
    }
    for (const label number : n)
    {
        CHECK(number > nSamples/20);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("slip criterion (26)", "[acousticRiemann][serial]")
{
    const vector tt(3, 4, 0);
    CHECK(slipCriterion(tt, -10, 0.3) == Approx(2).epsilon(1e-15));
    CHECK(slipCriterion(tt, -20, 0.3) == Approx(-1).epsilon(1e-15));
    CHECK(slipCriterion(tt, 10, 0.3) == 5);
    CHECK(slipCriterion(vector::zero, 0, 0.3) == 0);
}


TEST_CASE("friction traction (41)", "[acousticRiemann][serial]")
{
    Random random(1);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const vector tStick(randomVector(random));
        const scalar tn = randomScalar(random);
        const scalar k = random.sample01<scalar>();
        const scalar limit = (tn < 0 ? -k*tn : 0);
        const vector tt(frictionTraction(tStick, tn, k));

        CHECK(mag(tt) == Approx(min(limit, mag(tStick))).margin(tol));
        // In the direction of the stick traction
        CHECK((tt & tStick) == Approx(mag(tt)*mag(tStick)).margin(tol));
    }
    CHECK(frictionTraction(vector::zero, -1, 0.3) == vector::zero);
    CHECK(frictionTraction(vector::zero, -1, 0) == vector::zero);
    CHECK(frictionTraction(vector(1, 0, 0), 1, 0.3) == vector::zero);
}


TEST_CASE("contact-slip (40)-(43)", "[acousticRiemann][serial]")
{
    Random random(2);
    label nLimited = 0;
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random)), R(randomSide(random));
        const vector n(randomNormal(random));
        const scalar k = random.sample01<scalar>();
        const solution s(sliding(L, R, n, k));
        const solution stick(stuck(L, R, n));
        const scalar tn = stick.t & n;

        CHECK(s.state == status::slip);

        // (40), (41)
        CHECK(mag(((s.vMinus - stick.vMinus) & n)) <= tol);
        CHECK(mag(((s.vPlus - stick.vPlus) & n)) <= tol);
        CHECK(mag((s.t & n) - tn) <= tol);
        const vector tt(tangential(s.t, n)), ttStick(tangential(stick.t, n));
        const scalar limit = (tn < 0 ? -k*tn : 0);
        if (mag(ttStick) > limit)
        {
            ++nLimited;
            CHECK(maxDiff(tt, limit/mag(ttStick)*ttStick) <= tol);
        }

        // (42)
        CHECK
        (
            maxDiff(L.zs*tangential(L.v - s.vMinus, n), tangential(L.t, n) - tt)
         <= tol
        );
        CHECK
        (
            maxDiff(R.zs*tangential(R.v - s.vPlus, n), tt - tangential(R.t, n))
         <= tol
        );
    }
    CHECK(nLimited > nSamples/2);
}


TEST_CASE("separation (44), (46)-(49)", "[acousticRiemann][serial]")
{
    Random random(3);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random)), R(randomSide(random));
        const vector n(randomNormal(random));
        const solution s(separated(L, R));

        CHECK(s.state == status::open);
        CHECK(s.t == vector::zero);
        const solution r(released(L, R, n));
        CHECK(maxDiff(times(L.zp, L.zs, L.v - r.vMinus, n), L.t) <= tol);
        CHECK(maxDiff(times(R.zp, R.zs, R.v - r.vPlus, n), -R.t) <= tol);

        // As printed, with any traction in place of zero
        const vector tC(randomVector(random));
        CHECK
        (
            maxDiff
            (
                L.v + releaseVelocity(L.zs, L.t, tC), L.v + (tC - L.t)/L.zs
            ) <= 10*tol
        );
        CHECK
        (
            maxDiff
            (
                R.v + releaseVelocity(R.zs, tC, R.t), R.v - (tC - R.t)/R.zs
            ) <= 10*tol
        );
    }
}


TEST_CASE("separation of two bars (21)-(24)", "[acousticRiemann][serial]")
{
    const scalar v0 = 3, z = 7;
    const vector n(1, 0, 0);
    const side L{Zero, Zero, z, z/2}, R{v0*n, Zero, z, z/2};

    const solution s(contactOrRelease(L, R, n, 0.5));
    CHECK(s.state == status::open);
    CHECK(s.t == vector::zero);
    CHECK(s.vMinus == vector::zero);
    CHECK(s.vPlus == v0*n);

    // A compressed bar lets go at more than its speed
    const side C{Zero, -z*n, z, z/2}, D{Zero, -z*n, z, z/2};
    CHECK(maxDiff(released(C, D, n).vMinus, n) <= tol);
    CHECK(maxDiff(released(C, D, n).vPlus, -n) <= tol);
}


TEST_CASE
(
    "Algorithm 1 chooses a complementary state",
    "[acousticRiemann][serial]"
)
{
    forRandomContacts
    (
        4,
        []
        (
            const side& L,
            const side& R,
            const vector& n,
            const scalar k,
            const solution& s
        )
        {
            const vector trial(stickTraction(L, R, n));
            const scalar tn = s.t & n;
            const vector tt(tangential(s.t, n));
            const vector gapRate(s.vPlus - s.vMinus);
            const vector slipRate(tangential(gapRate, n));

            if (s.state == status::open)
            {
                CHECK((trial & n) >= 0);
                CHECK(s.t == vector::zero);
                CHECK((gapRate & n) >= -tol);
                return;
            }

            // In contact: compressed, neither gap nor penetration
            CHECK((trial & n) < 0);
            CHECK(mag(tn - (trial & n)) <= tol);
            CHECK(mag(gapRate & n) <= tol);
            CHECK(mag(tt) <= -k*tn + tol);

            if (s.state == status::stick)
            {
                CHECK(slipRate == vector::zero);
                CHECK(maxDiff(s.t, trial) <= tol);
            }
            else
            {
                CHECK(mag(tangential(trial, n)) > -k*(trial & n));
                CHECK(mag(tt) == Approx(-k*tn).margin(tol));
                // The left body is pulled along with the right one
                CHECK(mag(slipRate) > 0);
                CHECK
                (
                    (tt & slipRate)
                 == Approx(mag(tt)*mag(slipRate)).margin(10*tol)
                );
            }
        }
    );
}


TEST_CASE
(
    "nothing gives energy: interface and bodies",
    "[acousticRiemann][serial]"
)
{
    forRandomContacts
    (
        5,
        []
        (
            const side& L,
            const side& R,
            const vector& n,
            const scalar k,
            const solution& s
        )
        {
            // Friction
            const scalar friction =
                tangential(s.t, n) & tangential(s.vPlus - s.vMinus, n);
            if (s.state == status::slip)
            {
                const vector tStick(tangential(stickTraction(L, R, n), n));
                const vector tt(tangential(s.t, n));
                CHECK(friction >= 0);
                CHECK
                (
                    friction
                 == Approx
                    (
                        (1/L.zs + 1/R.zs)*(tt & (tStick - tt))
                    ).margin(100*tol)
                );
            }
            else
            {
                CHECK(mag(friction) == 0);
            }
            CHECK(mag((s.t & n)*((s.vPlus - s.vMinus) & n)) <= tol);

            // Upwinding, of both bodies
            const vector dtL(s.t - L.t), dvL(s.vMinus - L.v);
            const vector dtR(s.t - R.t), dvR(s.vPlus - R.v);
            CHECK(((dtL & n)*(dvL & n)) >= -tol);
            CHECK((tangential(dtL, n) & tangential(dvL, n)) >= -tol);
            CHECK(((dtR & n)*(dvR & n)) <= tol);
            CHECK((tangential(dtR, n) & tangential(dvR, n)) <= tol);
            CHECK((dtL & dvL) - (dtR & dvR) > 0);

            // Its value: jump of the tractions over the impedances
            CHECK
            (
                (dtL & dvL)
             == Approx
                (
                    sqr(dtL & n)/L.zp + magSqr(tangential(dtL, n))/L.zs
                ).margin(100*tol)
            );
            CHECK
            (
               -(dtR & dvR)
             == Approx
                (
                    sqr(dtR & n)/R.zp + magSqr(tangential(dtR, n))/R.zs
                ).margin(100*tol)
            );
        }
    );
}


TEST_CASE("no friction and unlimited friction", "[acousticRiemann][serial]")
{
    Random random(6);
    label nClosed = 0;
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const side L(randomSide(random)), R(randomSide(random));
        const vector n(randomNormal(random));
        const solution stick(stuck(L, R, n));
        const solution none(coulombContact(L, R, n, 0));
        const solution unlimited(coulombContact(L, R, n, GREAT));

        if ((stick.t & n) >= 0)
        {
            CHECK(none.state == status::open);
            CHECK(unlimited.state == status::open);
            continue;
        }
        ++nClosed;

        CHECK(none.state == status::slip);
        CHECK(maxDiff(none.t, (stick.t & n)*n) <= tol);
        CHECK
        (
            maxDiff
            (
                tangential(none.vMinus, n),
                tangential(L.v, n) - tangential(L.t, n)/L.zs
            ) <= 10*tol
        );
        CHECK
        (
            maxDiff
            (
                tangential(none.vPlus, n),
                tangential(R.v, n) + tangential(R.t, n)/R.zs
            ) <= 10*tol
        );

        CHECK(unlimited.state == status::stick);
        CHECK(maxDiff(unlimited.t, stick.t) <= tol);
        CHECK(maxDiff(unlimited.vMinus, stick.vMinus) <= tol);
        CHECK(maxDiff(unlimited.vPlus, stick.vPlus) <= tol);
    }
    CHECK(nClosed > nSamples/4);
}


TEST_CASE
(
    "stick and slip meet at the limit of friction",
    "[acousticRiemann][serial]"
)
{
    const vector n(0, 0, 1);
    const side L{vector(0, 0, 2), vector(1, 0, 0), 2, 1};
    const side R{vector(0, 0, -1), vector(0, 2, 0), 3, 1.5};
    const vector trial(stickTraction(L, R, n));
    const scalar k = mag(tangential(trial, n))/mag(trial & n);

    const solution below(coulombContact(L, R, n, k*(1 - 1e-10)));
    const solution above(coulombContact(L, R, n, k*(1 + 1e-10)));
    CHECK(below.state == status::slip);
    CHECK(above.state == status::stick);
    CHECK(maxDiff(below.t, above.t) <= 1e-9);
    CHECK(maxDiff(below.vMinus, above.vMinus) <= 1e-9);
    CHECK(maxDiff(below.vPlus, above.vPlus) <= 1e-9);
}


TEST_CASE
(
    "contact and release meet at zero trial traction",
    "[acousticRiemann][serial]"
)
{
    const vector n(1, 0, 0);
    const side R{Zero, Zero, 1, 0.5};
    for (const scalar v : {-1e-12, 0.0, 1e-12})
    {
        const side L{vector(v, 0, 0), Zero, 2, 1};
        const solution s(coulombContact(L, R, n, 0.2));
        CHECK(s.state == (v > 0 ? status::stick : status::open));
        CHECK(mag(s.t) <= 1e-12);
        CHECK(maxDiff(s.vPlus, vector::zero) <= 1e-12);
    }
}


TEST_CASE("the two bodies may be swapped", "[acousticRiemann][serial]")
{
    forRandomContacts
    (
        7,
        []
        (
            const side& L,
            const side& R,
            const vector& n,
            const scalar k,
            const solution& s
        )
        {
            const side L2{R.v, -R.t, R.zp, R.zs}, R2{L.v, -L.t, L.zp, L.zs};
            const solution s2(contactOrRelease(L2, R2, -n, k));
            CHECK(s2.state == s.state);
            CHECK(maxDiff(s2.t, -s.t) <= tol);
            CHECK(maxDiff(s2.vMinus, s.vPlus) <= 10*tol);
            CHECK(maxDiff(s2.vPlus, s.vMinus) <= 10*tol);
        }
    );
}


TEST_CASE("the frame of reference does not matter", "[acousticRiemann][serial]")
{
    Random random(8);
    forRandomContacts
    (
        9,
        [&]
        (
            const side& L,
            const side& R,
            const vector& n,
            const scalar k,
            const solution& s
        )
        {
            const tensor Q
            (
                rotation(randomNormal(random), randomScalar(random, 3))
            );
            const vector v0(randomVector(random));
            const side L2{(Q & L.v) + v0, Q & L.t, L.zp, L.zs};
            const side R2{(Q & R.v) + v0, Q & R.t, R.zp, R.zs};
            const solution s2(contactOrRelease(L2, R2, Q & n, k));
            CHECK(s2.state == s.state);
            CHECK(maxDiff(s2.t, Q & s.t) <= 10*tol);
            CHECK(maxDiff(s2.vMinus, (Q & s.vMinus) + v0) <= 10*tol);
            CHECK(maxDiff(s2.vPlus, (Q & s.vPlus) + v0) <= 10*tol);
        }
    );
}


// ************************************************************************* //
