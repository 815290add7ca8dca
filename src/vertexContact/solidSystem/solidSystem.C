/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "passTimes.H"
#include <chrono>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

double secondsSince(const std::chrono::steady_clock::time_point& start)
{
    return
        std::chrono::duration<double>
        (
            std::chrono::steady_clock::now() - start
        ).count();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidSystem::solveBoundaries
(
    const scalar time,
    const bool moved,
    const bool firstStage
)
{
    for (solidBody& body : bodies_)
    {
        body.prepare(time, moved);
    }
    solveContact(time, firstStage);
}


void Foam::solidSystem::solveContact(const scalar time, const bool firstStage)
{
    // Contact: gaps close and open by the status of the latest first stage
    const auto start = std::chrono::steady_clock::now();
    for (contactInterface& contact : interfaces_)
    {
        contact.remember();
    }
    if (firstStage)
    {
        for (solidBody& body : bodies_)
        {
            body.contact().status = Zero;
        }
    }
    for (contactInterface& contact : interfaces_)
    {
        contact.solve(time, firstStage);
    }
    if (firstStage)
    {
        for (solidBody& body : bodies_)
        {
            if (body.hasContact())
            {
                body.dual().sharing().max(body.contact().status.data(), 1);
            }
        }
    }
    contactSeconds_ += secondsSince(start);
}


void Foam::solidSystem::evaluate(const scalar time, const int stage)
{
    if (integrator_.leapfrog())
    {
        evaluateForces(time, false);
        return;
    }
    solveBoundaries(time, true, stage == 0);

    for (solidBody& body : bodies_)
    {
        body.computeFluxes(accounts_.on());
        body.finishRates(time, accounts_.on());
    }
}


void Foam::solidSystem::pair(const scalar time, const bool all)
{
    const auto start = std::chrono::steady_clock::now();
    for (contactInterface& contact : interfaces_)
    {
        if (contact.moves()) contact.update(time, all);
    }
    ++nPairings_;
    pairingSeconds_ += secondsSince(start);
}


void Foam::solidSystem::pairMoved(const scalar time)
{
    const auto start = std::chrono::steady_clock::now();
    bool some = false, outdated = false;
    for (contactInterface& contact : interfaces_)
    {
        if (!contact.moves()) continue;
        some = true;
        outdated = outdated || contact.outdated(time);
    }
    if (!some) return;
    label nBad = 0;
    for (const solidBody& body : bodies_) nBad += body.nBad();
    const label most =
        returnReduce(label(nBad ? 2 : outdated), maxOp<label>());
    pairingSeconds_ += secondsSince(start);
    if (most == 1) pair(time, false);
}


void Foam::solidSystem::evaluateForces(const scalar time, const bool moved)
{
    if (ratios_->active())
    {
        evaluateInBlocks(time, moved);
        return;
    }

    // Contact is solved with the velocities that all other forces make
    for (solidBody& body : bodies_)
    {
        body.prepare(time, true, bound_.due());
        body.computeFluxes(accounts_.on());
        body.finishRates(time, accounts_.on());
    }

    // Here: paired after this evaluation, the bodies were evaluated again
    if (moved) pairMoved(time);

    // Contact is solved for the last step; the forces of the start act for half
    // of what the first one will be (leap)
    const auto solve = [&](const scalar deltaT)
    {
        passTimes::timed(passTimes::contact, [&]
        {
            for (solidBody& body : bodies_)
            {
                body.setContactStep(deltaT);
                body.startContact();
            }
            solveContact(time, true);
        });
    };
    const scalar lastStep = bodies_[0].lastStep();
    solve(lastStep);
    if (lastStep == 0 && interfaces_.size())
    {
        for (label i = 0; i < 2; ++i)
        {
            const scalar first =
                control_.adjusts()
              ? control_.maxCo()*stableStep()
              : runTime_.deltaTValue();
            solve(0.5*first);
        }
    }
    for (solidBody& body : bodies_)
    {
        body.addContactForces();
    }
}


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
    if (ratios_->active())
    {
        return stableCommonStep();
    }
    if (integrator_.leapfrog())
    {
        // Surfaces that meet come no closer in a step than edges do
        for (const contactInterface& contact : interfaces_)
        {
            shortest = min
            (
                shortest,
                1/(3*contact.stageStatistics().closing + VSMALL)
            );
        }
    }
    const vector least
    (
        returnReduce(vector(shortest, -fastest, 0), minOp<vector>())
    );
    bound_.seen(-least.y());
    return least.x();
}


void Foam::solidSystem::leap(const scalar time)
{
    if (ratios_->active())
    {
        leapInBlocks(time);
        return;
    }

    const scalar deltaT = runTime_.deltaTValue();
    const scalar middle = 0.5*(bodies_[0].lastStep() + deltaT);
    forAll(bodies_, i)
    {
        passTimes::timed(passTimes::update, [&]
        {
            bodies_[i].leap(startOfStep_, deltaT, accounts_.on(), accounts_[i]);
        });
    }
    const auto start = std::chrono::steady_clock::now();
    passTimes::timed(passTimes::contact, [&]
    {
        for (contactInterface& contact : interfaces_)
        {
            contact.accumulate(middle);
            contact.slide(middle, deltaT);
        }
        for (solidBody& body : bodies_)
        {
            body.finishSlide();
        }
    });
    contactSeconds_ += secondsSince(start);

    bound_.pass(deltaT);
    evaluateForces(time, true);

    label nBad = 0;
    for (const solidBody& body : bodies_)
    {
        nBad += body.nBad();
    }
    settle(nBad);
}


void Foam::solidSystem::settle(const label nBad)
{
    // Outdated pairings and signals share the reduction. The leapfrog has
    // paired before it solved contact
    bool outdated = false;
    string lost;
    const auto start = std::chrono::steady_clock::now();
    for (contactInterface& contact : interfaces_)
    {
        if (lost.empty()) lost = contact.lost();
        outdated =
            outdated
         || (
                !integrator_.leapfrog() && contact.moves()
             && contact.outdated(runTime_.value())
            );
    }
    pairingSeconds_ += secondsSince(start);
    const vector all
    (
        returnReduce
        (
            vector
            (
                nBad + wrongNode_.size() + lost.size(), outdated,
                signals_.take()
            ),
            sumOp<vector>()
        )
    );
    if (all.x() > 0)
    {
        const string where = firstOf(lost);
        if (where.size())
        {
            stopOnLostContact(where);
        }
        stopOnBadState();
    }
    pairAgain_ = pairAgain_ || all.y() > 0;
    asked_ += label(all.z());

    forAll(bodies_, i)
    {
        accounts_[i].plastic += passTimes::timed(passTimes::plasticity, [&]
        {
            return bodies_[i].commitPlasticity();
        });
    }
}


void Foam::solidSystem::keepStart()
{
    startOfStep_ = runTime_.value();
    accounts_.keep();
    forAll(bodies_, i)
    {
        oldStatus_[i] = bodies_[i].contact().status;
        oldSlide_[i] = bodies_[i].contact().slide;
        if (maxEnergyRise_ > 0 || integrator_.leapfrog())
        {
            bodies_[i].keepPlasticity();
        }
    }
    for (solidBody& body : bodies_)
    {
        body.startReactions();
    }
    for (contactInterface& contact : interfaces_)
    {
        contact.keepSums();
    }
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
     || control_.logs(steps_ + 1, startOfStep_ + runTime_.deltaTValue())
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidSystem::startStep()
{
    const auto start = std::chrono::steady_clock::now();
    if (contactProperties_.valid() && contactProperties_->changed)
    {
        readLaws();
        for (solidBody& body : bodies_)
        {
            body.forgetRates();
        }
    }
    if (pairAgain_)
    {
        pair(runTime_.value(), pairAll_);
        for (solidBody& body : bodies_)
        {
            body.forgetRates();
        }
        pairAgain_ = pairAll_ = false;
    }

    keepStart();

    // With the leapfrog the last step did, unless the state was written or the
    // bodies were paired since: then as a run does that is started from it
    bool evaluated = integrator_.leapfrog();
    for (const solidBody& body : bodies_)
    {
        evaluated = evaluated && body.evaluated();
    }
    if (!evaluated)
    {
        for (solidBody& body : bodies_)
        {
            if (integrator_.leapfrog()) body.keepOld();
        }
        evaluate(startOfStep_, 0);
    }

    chooseStep();
    stepSeconds_ += secondsSince(start);
}


void Foam::solidSystem::finishStep()
{
    const auto start = std::chrono::steady_clock::now();
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
    stepSeconds_ += secondsSince(start);
}


// ************************************************************************* //
