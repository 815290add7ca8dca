/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Rotation of a rigid body on which no moment acts.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "freeRotation.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Test Cases  * * * * * * * * * * * * * * * //

TEST_CASE("A free asymmetric top keeps momentum and energy")
{
    // Principal axes that are not those of the frame
    const freeRotation top(symmTensor(2, 0.3, -0.2, 3, 0.4, 4));
    REQUIRE
    (
        mag
        (
            inv(top.inverse(quaternion::I))
          - symmTensor(2, 0.3, -0.2, 3, 0.4, 4)
        )
      < 1e-14
    );
    const vector L(1, -2, 0.5);
    quaternion q(quaternion::I);
    const auto energy = [&]() { return 0.5*(L & top.inverse(q) & L); };
    const scalar before = energy();

    // The momentum is the state: that of the velocities is the same
    scalar first = 0, last = 0;
    const label n = 200000;
    for (label i = 0; i < n; ++i)
    {
        top.turn(q, L, 0.02);
        const scalar off = mag(energy()/before - 1);
        if (i < n/10) first = max(first, off);
        if (i >= n - n/10) last = max(last, off);
    }
    const vector omega(top.inverse(q) & L);
    REQUIRE(mag((inv(top.inverse(q)) & omega) - L) < 1e-13*mag(L));
    REQUIRE(mag(mag(q) - 1) < 1e-14);
    REQUIRE(first < 1e-4);
    REQUIRE(last < 1.01*first);
}


TEST_CASE("A symmetric top precesses as theory says, whatever the step")
{
    const scalar I = 2, I3 = 3, angle = 0.4, size = 5, time = 7;
    const freeRotation top(symmTensor(I, 0, 0, I, 0, I3));
    const vector L(size*std::sin(angle), 0, size*std::cos(angle));
    for (const label n : {1, 7, 1000})
    {
        quaternion q(quaternion::I);
        for (label i = 0; i < n; ++i) top.turn(q, L, time/n);

        // The axis of the body goes about L with L/I
        quaternion about(L/size, time*size/I);
        const vector axis(q.transform(vector(0, 0, 1)));
        REQUIRE(mag(axis - about.transform(vector(0, 0, 1))) < 1e-11);
    }
}


TEST_CASE("A turn about an axis of space is that")
{
    quaternion q(vector(0.6, 0, 0.8), 0.3);
    const vector X(q.transform(vector(1, 2, 3)));
    freeRotation::turnAbout(q, vector(0, 0, 1), 0.5);
    const vector x(q.transform(vector(1, 2, 3)));
    const scalar c = std::cos(0.5), s = std::sin(0.5);
    REQUIRE
    (
        mag(x - vector(c*X.x() - s*X.y(), s*X.x() + c*X.y(), X.z())) < 1e-13
    );
}


// ************************************************************************* //
