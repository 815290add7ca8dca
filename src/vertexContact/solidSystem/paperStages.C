/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The paper's integrators (timeIntegrator), Algorithm 2: each stage is an
    evaluation and an update.

\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "paperBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidSystem::account(const int stage)
{
    const scalar dt = integrator_.weight(stage)*runTime_.deltaTValue();
    if (accounts_.on())
    {
        forAll(bodies_, i)
        {
            energyAccounts::add(accounts_[i], staged_[i].stagePowers(), dt);
        }
    }
    contacts_.accumulate(dt);
}


void Foam::solidSystem::solveBoundaries
(
    const scalar time,
    const bool moved,
    const bool firstStage
)
{
    for (paperBody& body : staged_) body.prepare(time, moved);
    contacts_.solve(time, firstStage);
}


void Foam::solidSystem::evaluateStage(const scalar time, const int stage)
{
    solveBoundaries(time, true, stage == 0);
    for (paperBody& body : staged_)
    {
        body.computeFluxes(accounts_.on());
        body.finishRates(time, accounts_.on());
    }
}


void Foam::solidSystem::advance(const int stage, const updatedPart part)
{
    const scalar deltaT = runTime_.deltaTValue();
    label nBad = 0;
    for (paperBody& body : staged_)
    {
        nBad += body.advance
        (
            deltaT, integrator_.oldWeight(stage),
            integrator_.instant(stage + 1)*deltaT, part
        );
    }

    // Other ranks hear of it at the end of the step. Until then keep a state
    // that can be evaluated
    if (nBad)
    {
        wrongNode_ = firstHere
        (
            [](const solidBody& body) { return body.findBadNode(); }
        );
        for (paperBody& body : staged_)
        {
            part == updatedPart::all
          ? body.restoreOld()
          : body.restoreMomentum();
        }
    }
}


void Foam::solidSystem::complete(const int stage, const updatedPart part)
{
    const scalar deltaT = runTime_.deltaTValue();
    label nBad = 0;
    for (paperBody& body : staged_)
    {
        nBad += body.advance
        (
            deltaT, integrator_.oldWeight(stage), deltaT, part
        );
    }

    settle(nBad);
}


void Foam::solidSystem::stages(const scalar time)
{
    const int last = integrator_.nStages() - 1;
    for (int stage = 0; stage < last; ++stage)
    {
        account(stage);
        advance(stage, updatedPart::all);
        const scalar instant = integrator_.instant(stage + 1);
        evaluate
        (
            instant == 1
          ? time
          : startOfStep_ + instant*runTime_.deltaTValue(),
            stage + 1
        );
    }
    account(last);
    if (integrator_.split())
    {
        advance(last, updatedPart::momentum);
        solveBoundaries(time, false, false);
        for (paperBody& body : staged_) body.computeGradients();
        complete(last, updatedPart::kinematics);
    }
    else
    {
        complete(last, updatedPart::all);
    }
}


// ************************************************************************* //
