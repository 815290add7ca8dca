/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "angularMomentumProjection.H"
#include "PstreamReduceOps.H"
#include "symmTensor.H"
#include "tensor.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int D>
inline Foam::vector Foam::angularMomentumProjection::arm
(
    const vertexData& d,
    const label a,
    const scalar dt
)
{
    const scalar* X = d.dual.nodePosition().cdata() + a*D;
    const scalar* u = d.state.disp.cdata() + a*D;
    vector y(Zero);
    for (direction i = 0; i < D; ++i)
    {
        y[i] = X[i] + u[i];
    }
    if (dt > 0)
    {
        const scalar* lm = d.state.lm.cdata() + a*D;
        const scalar* lm0 = d.old.lm.cdata() + a*D;
        for (direction i = 0; i < D; ++i)
        {
            y[i] += 0.5*dt/d.rho*(lm[i] - lm0[i]);
        }
    }
    return y;
}


template<int D>
void Foam::angularMomentumProjection::addSums
(
    const vertexData& d,
    const scalar dt,
    scalar* sums
)
{
    const bitSet& owned = d.dual.sharing().owned();
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* rates = d.rates.cdata();
    scalar volume = 0;
    vector first(Zero), torque(Zero);
    symmTensor second(Zero);

    for (label a = 0; a < d.nNodes(); ++a)
    {
        const vector y(arm<D>(d, a, dt));
        vector f(Zero);
        for (direction i = 0; i < D; ++i) f[i] = rates[a*d.strideRates + i];
        torque += V[a]*(y ^ f);

        const scalar v = owned[a] ? V[a] : 0;
        volume += v;
        first += v*y;
        second += v*sqr(y);
    }

    sums[0] = volume;
    for (direction i = 0; i < 3; ++i)
    {
        sums[1 + i] = first[i];
        sums[10 + i] = torque[i];
    }
    for (direction i = 0; i < 6; ++i) sums[4 + i] = second[i];
}


template<int D>
Foam::scalar Foam::angularMomentumProjection::project
(
    vertexData& d,
    const scalar dt,
    const scalar* sums,
    const bool power
) const
{
    const bitSet& owned = d.dual.sharing().owned();
    const scalar* V = d.dual.nodeVolume().cdata();

    const scalar volume = sums[0];
    const vector centre(vector(sums[1], sums[2], sums[3])/volume);
    const vector torque(sums[10], sums[11], sums[12]);
    symmTensor second(Zero);
    for (direction i = 0; i < 6; ++i) second[i] = sums[4 + i];
    second -= volume*sqr(centre);
    const symmTensor inertia(tr(second)*symmTensor::I - second);

    vector omega(Zero);
    if (D == 2)
    {
        omega.z() = torque.z()/inertia.zz();
    }
    else if (magSqr(axis_) > 0)
    {
        omega = (axis_ & torque)/(axis_ & inertia & axis_)*axis_;
    }
    else
    {
        omega = inv(inertia) & torque;
    }

    scalar* rates = d.rates.data();
    scalar taken = 0;
    for (label a = 0; a < d.nNodes(); ++a)
    {
        const vector change(omega ^ (arm<D>(d, a, dt) - centre));
        for (direction i = 0; i < D; ++i)
        {
            rates[a*d.strideRates + i] -= change[i];
        }
        if (power && owned[a])
        {
            scalar vChange = 0;
            for (direction i = 0; i < D; ++i)
            {
                vChange += d.W[a*d.strideW + i]*change[i];
            }
            taken += V[a]*vChange;
        }
    }
    return taken;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::angularMomentumProjection::angularMomentumProjection
(
    const vertexData& d,
    const symmetryConstraint& symmetry,
    const bool wanted
)
:
    axis_(Zero)
{
    const bool mirrors = returnReduce(symmetry.active(), orOp<bool>());
    active_ = wanted && d.finiteStrain && d.nDim() > 1;

    if (active_ && mirrors)
    {
        active_ = d.nDim() == 3 && symmetry.commonNormal(axis_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::angularMomentumProjection::measure
(
    const vertexData& d,
    const scalar dt,
    scalar* sums
) const
{
    d.nDim() == 2 ? addSums<2>(d, dt, sums) : addSums<3>(d, dt, sums);
}


Foam::scalar Foam::angularMomentumProjection::correct
(
    vertexData& d,
    const scalar dt,
    const scalar* sums,
    const bool power
) const
{
    return
        d.nDim() == 2
      ? project<2>(d, dt, sums, power)
      : project<3>(d, dt, sums, power);
}


// ************************************************************************* //
