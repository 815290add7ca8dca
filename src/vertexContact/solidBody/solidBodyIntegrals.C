/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What is looked for in all of a region, and summed over it.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::solidBody::findNodeWithin(const scalar timeScale) const
{
    if (rigid_.valid()) return -1;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        if (timeScaleOf(a) <= timeScale) return a;
    }
    return -1;
}


Foam::scalar Foam::solidBody::largestGradient() const
{
    if (rigid_.valid()) return 0;
    scalar largest = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        // With the initial stretch, as far as strains are small
        tensor gradient(deformationGradient(a) - tensor::I);
        if (material_->initial().on())
        {
            gradient += inSpace(material_->initial().value(a)) - tensor::I;
        }
        largest = max(largest, magSqr(gradient));
    }
    return std::sqrt(largest);
}


Foam::scalar Foam::solidBody::largestSpeed() const
{
    const label d = dual_.nDim();
    placeAll();
    scalar largest = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        largest = max(largest, mag(expand(data_.state.lm.cdata() + a*d)));
    }
    return largest/data_.rho;
}


Foam::label Foam::solidBody::findNodeFasterThan(const scalar speed) const
{
    const label d = dual_.nDim();
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        if (mag(expand(data_.state.lm.cdata() + a*d)) >= speed*data_.rho)
        {
            return a;
        }
    }
    return -1;
}


Foam::label Foam::solidBody::findBadNode() const
{
    if (rigid_.valid()) return rigid_->finite() || !dual_.nNodes() ? -1 : 0;
    const label d = dual_.nDim();
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        for (label i = 0; i < d; ++i)
        {
            if (!std::isfinite(data_.state.lm[a*d + i])) return a;
        }
        if (data_.finiteStrain)
        {
            const scalar* F = data_.state.F.cdata();
            const scalar detF =
                d == 1 ? determinant(loadF<1>(F, a))
              : d == 2 ? determinant(loadF<2>(F, a))
              : determinant(loadF<3>(F, a));
            if (!(detF > 0)) return a;
            if (data_.state.solvesJ && !(data_.state.J[a] > 0)) return a;
        }
        else
        {
            for (label k = 0; k < d*d; ++k)
            {
                if (!(mag(data_.state.F[a*d*d + k]) < largestLinearF)) return a;
            }
        }
    }
    return -1;
}


Foam::scalar Foam::solidBody::kineticEnergy() const
{
    if (rigid_.valid()) return rigid_->kineticEnergy(lastStep_, evaluated_);
    scalar sum = 0;
    withDirections(dual_.nDim(), [&](auto D)
    {
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            scalar vv = 0;
            for (int i = 0; i < D.value; ++i) vv += sqr(velocity(a, i));
            sum += ownedVolume_[a]*vv;
        }
    });
    return 0.5*data_.rho*sum;
}


Foam::scalar Foam::solidBody::swing() const
{
    if (rigid_.valid()) return rigid_->swing(lastStep_, evaluated_);
    if (!evaluated_) return 0;
    scalar sum = 0;
    withDirections(dual_.nDim(), [&](auto D)
    {
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
            scalar power = 0;
            for (int i = 0; i < D.value; ++i)
            {
                power += rate[i]*(velocity(a, i) - middleVelocity(a, i));
            }
            sum += ownedVolume_[a]*power;
        }
    });
    return 0.25*lastStep_*sum;
}


Foam::scalar Foam::solidBody::strainEnergy() const
{
    if (rigid_.valid()) return 0;
    scalar sum = material_->totalStrainEnergy(data_.state, ownedVolume_);
    if (data_.variational) sum += scheme_->jumpEnergy();
    return sum;
}


Foam::scalar Foam::solidBody::mass() const
{
    if (rigid_.valid()) return Pstream::master() ? rigid_->mass() : 0;
    return data_.rho*sum(ownedVolume_);
}


Foam::vector Foam::solidBody::meanVelocity() const
{
    return
        returnReduce(linearMomentum(), sumOp<vector>())
       /returnReduce(mass(), sumOp<scalar>());
}


Foam::vector Foam::solidBody::linearMomentum() const
{
    if (rigid_.valid()) return rigid_->linearMomentum();
    scalar sum[3] = {};
    withDirections(dual_.nDim(), [&](auto D)
    {
        const scalar* p = data_.state.lm.cdata();
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            for (int i = 0; i < D.value; ++i)
            {
                sum[i] += ownedVolume_[a]*p[a*D.value + i];
            }
        }
    });
    return expand(sum);
}


Foam::vector Foam::solidBody::angularMomentum() const
{
    if (rigid_.valid()) return rigid_->angularMomentum();

    // x_i p_j - x_j p_i. No component can change that has a direction left out
    // in both factors
    tensor sum(Zero);
    withDirections(dual_.nDim(), [&](auto D)
    {
        constexpr int d = D.value;
        const scalar* X = dual_.nodePosition().cdata();
        const scalar* u = data_.state.disp.cdata();
        const scalar* p = data_.state.lm.cdata();
        scalar L[d][d] = {};
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            scalar x[d];
            for (int i = 0; i < d; ++i) x[i] = X[a*d + i] + u[a*d + i];
            for (int i = 0; i < d; ++i)
            {
                for (int j = i + 1; j < d; ++j)
                {
                    L[i][j] +=
                        ownedVolume_[a]*(x[i]*p[a*d + j] - x[j]*p[a*d + i]);
                }
            }
        }
        const FixedList<label, 3>& dir = dual_.directions();
        for (int i = 0; i < d; ++i)
        {
            for (int j = i + 1; j < d; ++j)
            {
                sum[3*dir[i] + dir[j]] = L[i][j];
                sum[3*dir[j] + dir[i]] = -L[i][j];
            }
        }
    });
    return vector(sum.yz(), sum.zx(), sum.xy());
}


const Foam::boundBox& Foam::solidBody::surfaceVelocities
(
    const label patchi,
    const scalar time
)
{
    bodySurface& its = surfaces_[patchi];
    if (its.velocityTime == time) return its.velocities;

    scalar least[3] = {}, most[3] = {};
    withDirections(dual_.nDim(), [&](auto D)
    {
        constexpr int d = D.value;
        const scalar* lm = data_.state.lm.cdata();
        if (its.nodes.empty()) return;
        for (int i = 0; i < d; ++i)
        {
            least[i] = most[i] = lm[its.nodes[0]*d + i];
        }
        for (const label a : its.nodes)
        {
            for (int i = 0; i < d; ++i)
            {
                least[i] = min(least[i], lm[a*d + i]);
                most[i] = max(most[i], lm[a*d + i]);
            }
        }
    });
    const boundBox now(expand(least)/data_.rho, expand(most)/data_.rho);
    its.velocities = its.velocityTime > -GREAT ? its.lastVelocities : now;
    its.velocities.min() = min(its.velocities.min(), now.min());
    its.velocities.max() = max(its.velocities.max(), now.max());
    its.lastVelocities = now;
    its.velocityTime = time;
    return its.velocities;
}


// ************************************************************************* //
