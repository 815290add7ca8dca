/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepChoice.H"
#include "passTimes.H"
#include "rankRows.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::stepChoice::stable()
{
    const bool anew = bound_.due() || !leapfrog_;
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
        // A rigid body takes the shortest step of all
        if (bodies_[i].rigid()) bodyStep_[i] = shortest;
    }
    if (subCycling_.active()) return subCycling_.stableStep(bodyStep_, bound_);
    if (leapfrog_)
    {
        // In a step surfaces approach by no more than edges may shorten
        shortest = min(shortest, contacts_.closingTime());
    }
    const vector least
    (
        returnReduce(vector(shortest, -fastest, 0), minOp<vector>())
    );
    bound_.seen(-least.y());
    return least.x();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepChoice::stepChoice
(
    Time& runTime,
    const stepControl& control,
    const bool leapfrog,
    PtrList<solidBody>& bodies,
    contactSystem& contacts,
    subCycling& ownSteps
)
:
    runTime_(runTime),
    control_(control),
    leapfrog_(leapfrog),
    bodies_(bodies),
    contacts_(contacts),
    subCycling_(ownSteps),
    bodyStep_(bodies.size(), scalar(0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::stepChoice::first()
{
    const scalar step = stable();
    return
        control_.adjusts()
      ? min(control_.maxCo()*step, control_.maxDeltaT())
      : runTime_.deltaTValue();
}


Foam::scalarField Foam::stepChoice::ofBodies() const
{
    scalarField steps(bodyStep_);
    combineOnAll(steps, minEqOp<scalar>());
    return steps;
}


bool Foam::stepChoice::look(const bool logs)
{
    // A fixed step needs the stable one only where the Courant number is
    // printed
    const bool follows = control_.adjusts() || subCycling_.active();
    if (!follows) bound_.always();
    if (!follows && limit_ > 0 && !logs) return false;
    limit_ = stable();
    return true;
}


void Foam::stepChoice::take()
{
    const bool adjusts = control_.adjusts();
    const bool own = subCycling_.active();
    const scalar wanted =
        own
      ? subCycling_.wantedStep(leastLimit_)
      : control_.maxCo()
       *(leapfrog_ && adjusts ? leastLimit_.of(limit_) : limit_);
    if (adjusts) runTime_.setDeltaT(control_.fitted(wanted), false);
    if (own) subCycling_.divide(runTime_.deltaTValue());
}


// ************************************************************************* //
