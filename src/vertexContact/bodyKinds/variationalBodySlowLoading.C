/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What slow loading asks of a body: scaled mass, damping, stops (massScaling,
    massDamping, kineticRelaxation).

\*---------------------------------------------------------------------------*/

#include "variationalBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::variationalBody::findHeld()
{
    if (heldBy_.size()) return;
    heldBy_.setSize(dual_.nNodes(), -1);
    forAll(held_.nodes(), k) heldBy_[held_.nodes()[k]] = k;
}


void Foam::variationalBody::freePart(const label node, scalar* p) const
{
    if (heldBy_[node] >= 0) held_.hold(heldBy_[node], p);
}


Foam::scalar Foam::variationalBody::freeSquare(const scalarField& p) const
{
    const label d = dual_.nDim();
    scalar sum = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        scalar its[3];
        for (label i = 0; i < d; ++i) its[i] = p[a*d + i];
        freePart(a, its);
        scalar square = 0;
        for (label i = 0; i < d; ++i) square += its[i]*its[i];
        sum += ownedVolume_[a]*square;
    }
    return sum;
}


Foam::scalar Foam::variationalBody::dampedVelocity
(
    const label node,
    const label i
) const
{
    // Half a kick, as the leapfrog's
    const label d = dual_.nDim();
    const scalar* lm = data_.state.lm.cdata() + node*d;
    if (!evaluated_ || lastStep_ <= 0) return lm[i]/data_.rho;
    const scalar half = 0.5*lastStep_;
    const scalar T = damping_->tanhOf(half);
    const scalar* rate = data_.rates.cdata() + node*data_.strideRates;
    scalar change[3];
    for (label j = 0; j < d; ++j)
    {
        change[j] = (half*rate[j] - 2*T*lm[j])/(1 + T);
    }
    freePart(node, change);
    return (lm[i] + change[i])/data_.rho;
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
    // As a body that begins; the state is put back
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
    findHeld();
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
        freePart(a, lm);
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
        if (heldBy_[a] < 0)
        {
            for (label i = 0; i < d; ++i) lm[i] = 0;
            continue;
        }
        scalar p[3];
        for (label i = 0; i < d; ++i) p[i] = lm[i];
        freePart(a, p);
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
        // Of what is held the rates are zero
        const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
        for (label i = 0; i < d; ++i)
        {
            data_.state.lm[a*d + i] -= share*rate[i];
        }
    }
}


Foam::solidBody::forceBalance Foam::variationalBody::balance()
{
    forceBalance b;

    // Rates are sums already; what acts from outside is this rank's share
    const label d = dual_.nDim();
    scalarField& loads = work_;
    loads = externalForce_;
    for (const label a : contact_.nodes())
    {
        for (label i = 0; i < d; ++i)
        {
            loads[a*d + i] += contact_.forces()[a*d + i];
        }
    }
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
