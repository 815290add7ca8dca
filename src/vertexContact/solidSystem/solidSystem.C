/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "passTimes.H"
#include "stopwatch.H"
#include "writtenTimes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidSystem::evaluate(const scalar time, const int stage)
{
    if (integrator_.leapfrog()) evaluateForces(time, false);
    else evaluateStage(time, stage);
}


void Foam::solidSystem::evaluateForces(const scalar time, const bool moved)
{
    if (subCycling_.active())
    {
        subCycling_.evaluate
        (
            time, moved, choice_.due(), [this] { return choice_.first(); }
        );
        return;
    }

    // Contact needs the velocities that result from all other forces
    for (leapfrogBody& body : leaping_)
    {
        body.evaluate(time, choice_.due());
    }

    // Pair here: if the surfaces were paired after this evaluation, it would
    // have to be repeated
    if (moved) contacts_.pairMoved(time);

    // Solve contact for the last step. At the start of a run the forces act for
    // half of the first step (leap)
    const auto solve = [&](const scalar deltaT)
    {
        passTimes::timed(passTimes::contact, [&]
        {
            for (solidBody& body : bodies_)
            {
                body.contact().setStep(deltaT);
                body.contact().clearAll();
            }
            contacts_.solve(time, true);
        });
    };
    const scalar lastStep = bodies_[0].lastStep();
    solve(lastStep);
    if (lastStep == 0 && interfaces().size())
    {
        for (label i = 0; i < 2; ++i) solve(0.5*choice_.first());
    }
    for (leapfrogBody& body : leaping_)
    {
        body.addContactForces();
    }
}


void Foam::solidSystem::leap(const scalar time)
{
    const scalar deltaT = runTime_.deltaTValue();
    label nBad = 0;
    if (subCycling_.active())
    {
        nBad = subCycling_.leap(startOfStep_, deltaT);
    }
    else
    {
        const scalar middle = 0.5*(bodies_[0].lastStep() + deltaT);
        forAll(leaping_, i)
        {
            passTimes::timed(passTimes::update, [&]
            {
                leaping_[i].leap
                (
                    startOfStep_, deltaT, accounts_.on(), accounts_[i]
                );
            });
        }
        passTimes::timed(passTimes::contact, [&]
        {
            contacts_.slide(middle, deltaT);
        });
    }

    if (!nBad)
    {
        choice_.pass(deltaT);
        evaluateForces(time, true);
        for (const solidBody& body : bodies_) nBad += body.nBad();
    }
    settle(nBad);
}


void Foam::solidSystem::settle(const label nBad)
{
    // Outdated pairings and signals share one reduction. The leapfrog has
    // already paired before it solved contact
    const contactSystem::findings found
    (
        contacts_.look(runTime_.value(), !integrator_.leapfrog())
    );
    const vector all
    (
        returnReduce
        (
            vector
            (
                nBad + wrongNode_.size() + found.failure.size(),
                found.outdated, signals_.take()
            ),
            sumOp<vector>()
        )
    );
    if (all.x() > 0)
    {
        const string where = firstOf(found.failure);
        if (where.size())
        {
            stopOnLostContact(where);
        }
        stopOnBadState();
    }
    if (all.y() > 0) contacts_.askToPair();
    asked_ += label(all.z());

    forAll(bodies_, i)
    {
        passTimes::timed(passTimes::plasticity, [&]
        {
            bodies_[i].commitPlasticity(accounts_[i]);
        });
    }
}


void Foam::solidSystem::keepStart()
{
    startOfStep_ = runTime_.value();
    accounts_.keep();
    contacts_.keepStart();
    for (solidBody& body : bodies_)
    {
        if (maxEnergyRise_ > 0 || integrator_.leapfrog())
        {
            body.keepPlasticity();
        }
        if (body.reactions().valid()) body.reactions()->startStep();
    }
}


template<class Function>
auto Foam::solidSystem::orWrite(const Function& f) -> decltype(f())
{
    const bool throws = FatalIOError.throwExceptions();
    try
    {
        const auto result = f();
        FatalIOError.throwExceptions(throws);
        return result;
    }
    catch (const IOerror& wrong)
    {
        FatalIOError.throwExceptions(throws);
        if (runTime_.value() != start_ && !dry_)
        {
            runTime_.writeNow();
            writtenTimes::check(*this);
        }
        IOerror message(wrong);
        message.throwExceptions(throws);
        message.exit();
        throw;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidSystem::startStep()
{
    const stopwatch watch(stepSeconds_);
    const bool otherLaws = orWrite([&]
    {
        return contacts_.readModifiedLaws();
    });
    if (contacts_.pairIfAsked(runTime_.value()) || otherLaws)
    {
        for (solidBody& body : bodies_) body.forgetRates();
    }

    keepStart();

    // With the leapfrog the last step has evaluated the forces. If the state
    // was written or the bodies were paired since, evaluate as at a restart
    bool evaluated = integrator_.leapfrog();
    for (const solidBody& body : bodies_)
    {
        evaluated = evaluated && body.evaluated();
    }
    if (!evaluated)
    {
        for (leapfrogBody& body : leaping_) body.keepOld();
        evaluate(startOfStep_, 0);
    }

    orWrite([&]
    {
        const bool logs = control_.logs
        (
            steps_ + 1, startOfStep_ + runTime_.deltaTValue()
        );
        if (choice_.look(logs)) checkTimeStep();
        choice_.take();
        return true;
    });
}


void Foam::solidSystem::finishStep()
{
    const stopwatch watch(stepSeconds_);
    const scalar time = runTime_.value();
    if (integrator_.leapfrog())
    {
        leap(time);
        if (relaxation_.valid()) relax(time);
    }
    else
    {
        stages(time);
    }
    checkEnergy();

    ++steps_;
}


// ************************************************************************* //
