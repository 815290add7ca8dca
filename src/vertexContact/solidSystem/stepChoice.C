/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    How long a step of a solidSystem may be, and how long it is. Steps of their
    own for the bodies: subCycling.C.

\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "passTimes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::solidSystem::stableStep()
{
    const bool anew = bound_.due() || !integrator_.leapfrog();
    scalar shortest = GREAT, fastest = 0;
    forAll(bodies_, i)
    {
        bodyStep_[i] = passTimes::timed(passTimes::stableStep, [&]
        {
            return bodies_[i].timeScale(anew);
        });
        shortest = min(shortest, bodyStep_[i]);
        fastest = max(fastest, bodies_[i].fastestStretching());
    }
    forAll(bodies_, i)
    {
        // It takes the shortest step of all
        if (bodies_[i].rigid()) bodyStep_[i] = shortest;
    }
    if (ratios_->active()) return stableCommonStep();
    if (integrator_.leapfrog())
    {
        // Surfaces that meet come no closer in a step than edges do
        shortest = min(shortest, contacts_.closingTime());
    }
    const vector least
    (
        returnReduce(vector(shortest, -fastest, 0), minOp<vector>())
    );
    bound_.seen(-least.y());
    return least.x();
}


void Foam::solidSystem::chooseStep()
{
    // A fixed step needs the stable one only where the Courant number is
    // printed
    const bool adjusts = control_.adjusts();
    if (!adjusts && !ratios_->active()) bound_.always();
    if
    (
        adjusts
     || ratios_->active()
     || timeStepLimit_ == 0
     || control_.logs(done_.steps + 1, startOfStep_ + runTime_.deltaTValue())
    )
    {
        timeStepLimit_ = stableStep();
        checkTimeStep();
    }
    if (ratios_->active())
    {
        chooseSteps(adjusts);
    }
    else if (adjusts)
    {
        const scalar stable =
            integrator_.leapfrog()
          ? leastLimit_.of(timeStepLimit_)
          : timeStepLimit_;
        runTime_.setDeltaT(control_.fitted(control_.maxCo()*stable), false);
    }
}


// ************************************************************************* //
