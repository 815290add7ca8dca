/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Sub-cycling: the steps of a body within its block, while contact is solved
    several times with the shorter steps of another body. stepRatios.H describes
    the scheme, and why it cannot feed energy.

\*---------------------------------------------------------------------------*/

#include "variationalBody.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::variationalBody::keepStart()
{
    if (!block_.valid()) block_.reset(new stepBlock);
    block_->lm = data_.state.lm;
    block_->disp = data_.state.disp;
    block_->acceleration = scheme_->acceleration();
    block_->lastStep = lastStep_;
}


void Foam::variationalBody::keepFreeRates()
{
    if (!contact_.on()) return;
    if (!block_.valid()) block_.reset(new stepBlock);
    const label d = dual_.nDim();
    scalarField& rates = block_->freeRates;
    scalarField& forces = block_->freeForces;
    rates.setSize(contact_.nodes().size()*d);
    forces.setSize(contact_.nodes().size()*d);
    contact_.forComponents([&](const label k, const label a, const label i)
    {
        rates[k*d + i] = data_.rates[a*data_.strideRates + i];
        forces[k*d + i] = externalForce_[a*d + i];
    });
}


void Foam::variationalBody::restoreFreeRates()
{
    if (!contact_.on()) return;
    const label d = dual_.nDim();
    contact_.forComponents([&](const label k, const label a, const label i)
    {
        data_.rates[a*data_.strideRates + i] = block_->freeRates[k*d + i];
        externalForce_[a*d + i] = block_->freeForces[k*d + i];
    });
}


void Foam::variationalBody::startBlock()
{
    if (!block_.valid()) block_.reset(new stepBlock);
    stepBlock& b = *block_;
    ++b.number;
    b.inside = contact_.on();
    b.elapsed = 0;
    if (!contact_.on()) return;

    const label d = dual_.nDim();
    b.impulse.setSize(dual_.nNodes()*d);
    b.path.setSize(dual_.nNodes()*d);
    b.mean.setSize(dual_.nNodes()*d);
    b.startDisp.setSize(contact_.nodes().size()*d);
    contact_.forComponents([&](const label k, const label a, const label i)
    {
        b.startDisp[k*d + i] = data_.state.disp[a*d + i];
        b.impulse[a*d + i] = 0;
        b.path[a*d + i] = b.mean[a*d + i] =
            data_.state.lm[a*d + i]/data_.rho;
    });
}


void Foam::variationalBody::placeSurface(const scalar time)
{
    if (!contact_.on()) return;
    stepBlock& b = *block_;
    const label d = dual_.nDim();
    contact_.forComponents([&](const label k, const label a, const label i)
    {
        const scalar v = data_.state.lm[a*d + i]/data_.rho;
        b.path[a*d + i] = b.mean[a*d + i];
        data_.state.disp[a*d + i] =
            b.startDisp[k*d + i] - 0.5*lastStep_*v + time*b.path[a*d + i];
    });
}


void Foam::variationalBody::putSurfaceBack()
{
    if (!contact_.on()) return;
    const label d = dual_.nDim();
    contact_.forComponents([&](const label k, const label a, const label i)
    {
        data_.state.disp[a*d + i] = block_->startDisp[k*d + i];
    });
    block_->inside = false;
}


void Foam::variationalBody::addContactImpulse
(
    const scalar deltaT,
    const scalar block
)
{
    stepBlock& b = *block_;
    b.elapsed += deltaT;
    if (!contact_.on()) return;

    const label d = dual_.nDim();
    contact_.forComponents([&](label, const label a, const label i)
    {
        b.impulse[a*d + i] += deltaT*contact_.forces()[a*d + i];
        work_[a*d + i] = b.impulse[a*d + i]/b.elapsed;
    });
    contact_.complete(work_);

    // As leap() finds it
    const scalar T = damping_.valid() ? damping_->tanhOf(block) : 0;
    contact_.forComponents([&](label, const label a, const label i)
    {
        const scalar force =
            data_.rates[a*data_.strideRates + i] + work_[a*d + i];
        b.mean[a*d + i] =
            (data_.state.lm[a*d + i] + 0.5*block*force)/(data_.rho*(1 + T));
    });
}


void Foam::variationalBody::endBlock()
{
    putSurfaceBack();
    const label d = dual_.nDim();
    contact_.forComponents([&](label, const label a, const label i)
    {
        contact_.forces()[a*d + i] = block_->impulse[a*d + i]/block_->elapsed;
    });
    addContactForces();
}


// ************************************************************************* //
