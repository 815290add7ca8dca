/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What slow loading requires of a body: scaled mass, damping and stops
    (massScaling, massDamping, kineticRelaxation).

\*---------------------------------------------------------------------------*/

#include "variationalBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::variationalBody::freeSquare(const scalarField& p) const
{
    const label d = dual_.nDim();
    scalar sum = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        scalar its[3];
        for (label i = 0; i < d; ++i) its[i] = p[a*d + i];
        held_.freePart(a, its);
        scalar square = 0;
        for (label i = 0; i < d; ++i) square += its[i]*its[i];
        sum += ownedVolume_[a]*square;
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::variationalBody::scaleMass
(
    const scalar factor,
    const scalar before
)
{
    deformableBody::scaleMass(factor, before);
    if (factor != 1) scheme_->scaleMass(factor);
}


Foam::scalar Foam::variationalBody::undeformedTimeScale()
{
    // Evaluate as at the start of a run; the state is put back afterwards
    conservedState start
    (
        dual_.nNodes(), dual_.nDim(), kinematicsOf(options_, *material_),
        data_.finiteStrain
    );
    if (material_->plastic()) start.makePlastic();
    const scalarField F(data_.state.F);
    const scalarField waveFactor(data_.waveFactor);
    data_.state.F = start.F;
    data_.waveFactor = scalar(1);
    if (stretchedWaves_ && material_->initial().on())
    {
        material_->waveFactors(start, data_.waveFactor);
    }

    const scalar step = returnReduce
    (
        scheme_->boundOfStep(), minOp<scalar>()
    );

    data_.state.F = F;
    data_.waveFactor = waveFactor;
    return step;
}


void Foam::variationalBody::setDamping(const dictionary& dict)
{
    damping_.reset(new massDamping(dict));
    damping_->setTime(time_.value());
}


Foam::scalar Foam::variationalBody::freeKineticEnergy() const
{
    return 0.5*freeSquare(data_.state.lm)/data_.rho;
}


Foam::scalar Foam::variationalBody::heldKineticEnergy() const
{
    const label d = dual_.nDim();
    scalar sum = 0;
    for (const label a : held_.nodes())
    {
        scalar lm[3], held[3];
        for (label i = 0; i < d; ++i) held[i] = lm[i] = data_.state.lm[a*d + i];
        held_.freePart(a, lm);
        for (label i = 0; i < d; ++i)
        {
            sum += ownedVolume_[a]*sqr(held[i] - lm[i]);
        }
    }
    return 0.5*sum/data_.rho;
}


void Foam::variationalBody::stop()
{
    const label d = dual_.nDim();
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        scalar* lm = data_.state.lm.data() + a*d;
        scalar p[3];
        for (label i = 0; i < d; ++i) p[i] = lm[i];
        held_.freePart(a, p);
        for (label i = 0; i < d; ++i) lm[i] -= p[i];
    }
    scheme_->forget();
}


void Foam::variationalBody::startFromRest()
{
    const scalar half = 0.5*lastStep_;
    const label d = dual_.nDim();
    const scalar share =
        damping_.valid() ? half/(1 - damping_->tanhOf(half)) : half;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        // Rates of held components are zero
        const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
        for (label i = 0; i < d; ++i)
        {
            data_.state.lm[a*d + i] -= share*rate[i];
        }
    }
}


Foam::leapfrogBody::forceBalance Foam::variationalBody::balance()
{
    forceBalance b;

    // Rates are complete sums; external forces are this rank's share
    const label d = dual_.nDim();
    scalarField& loads = work_;
    loads = externalForce_;
    contact_.forComponents([&](label, const label a, const label i)
    {
        loads[a*d + i] += contact_.forces()[a*d + i];
    });
    dual_.sharing().sum(loads.data(), d);
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
        scalar out = 0, load = 0;
        for (label i = 0; i < d; ++i)
        {
            out += sqr(rate[i]);
            load += sqr(loads[a*d + i]);
        }
        b.unbalanced += ownedVolume_[a]*std::sqrt(out);
        b.loads += ownedVolume_[a]*std::sqrt(load);
    }
    reduce(b.unbalanced, sumOp<scalar>());
    reduce(b.loads, sumOp<scalar>());
    return b;
}


// ************************************************************************* //
