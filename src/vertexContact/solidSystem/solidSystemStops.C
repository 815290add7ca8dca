/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    How a run ends that has failed: the state at the start of the step is
    written, and a message says where, when, and what the user may do.

\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "systemChecks.H"
#include "writtenTimes.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- The fastest node is the first with this share of the largest speed, since
//  products may differ in the last bits
constexpr Foam::scalar asFast = 1 - 1e-12;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::solidSystem::firstHere
(
    const std::function<label(const solidBody&)>& find
) const
{
    for (const solidBody& body : bodies_)
    {
        const label node = find(body);
        if (node >= 0)
        {
            return "region " + body.name() + ", " + body.whereIs(node);
        }
    }
    return string();
}


Foam::string Foam::solidSystem::firstOf(const string& message)
{
    List<string> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = message;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    for (const string& s : all)
    {
        if (s.size()) return s;
    }
    return message;
}


void Foam::solidSystem::checkTimeStep()
{
    if (leastTimeStep_ == 0)
    {
        // Steps are counted by a division
        leastTimeStep_ = max
        (
            VSMALL,
            control_.minDeltaT
            (
                stepControl::leastStep
               *(
                    systemChecks::allRigid(bodies_)
                  ? min(choice_.limit(), runTime_.deltaTValue())
                  : choice_.limit()
                )
            )
        );
    }
    if (choice_.limit() >= leastTimeStep_) return;
    string what = firstOf
    (
        firstHere([&](const solidBody& body)
        {
            return body.findNodeWithin(choice_.limit());
        })
    );
    string cures
    (
        "less distorted cells at this place, or a material that is meant for "
        "such deformations."
    );
    if (what.empty())
    {
        // Not the cells of a body
        scalar fastest = 0;
        for (const contactInterface& contact : interfaces())
        {
            const scalar closing = returnReduce
            (
                contact.stageStatistics().closing, maxOp<scalar>()
            );
            if (closing > fastest)
            {
                what =
                    "the surfaces of interface " + contact.name()
                  + " approach each other too fast";
                fastest = closing;
            }
        }
        for (solidBody& body : bodies_)
        {
            if (body.rigid() && body.timeScale(false) <= choice_.limit())
            {
                what = "the rigid region " + body.name() + " turns too fast";
            }
        }
        cures = "a lower speed, or a smaller minDeltaT.";
    }
    if (runTime_.value() != start_ && !dry_)
    {
        runTime_.writeNow();
    }
    FatalErrorInFunction
        << "The stable time step has fallen to " << choice_.limit()
        << " s, below " << leastTimeStep_ << " s (minDeltaT): "
        << what.c_str() << ", at time " << runTime_.value() << " s." << nl
        << "Likely cures: " << cures.c_str() << exit(FatalError);
}


void Foam::solidSystem::stopStep
(
    const string& what,
    const string& where,
    const string& cures
)
{
    const scalar badTime = runTime_.value();
    accounts_.restore();
    forAll(bodies_, i)
    {
        bodies_[i].restoreOld();
    }
    contacts_.restoreStart();
    subCycling_.restore();
    runTime_.setTime(startOfStep_, runTime_.timeIndex() - 1);
    if (integrator_.leapfrog())
    {
        // Velocities and tractions as a run has them that starts from this
        evaluateForces(startOfStep_, false);
    }

    // The state that the run started from exists already
    string written
    (
        dry_ ? "Nothing was written: this is a dry run."
      : "Nothing was written: this was the first step."
    );
    if (startOfStep_ != start_ && !dry_)
    {
        runTime_.writeNow();
        writtenTimes::check(*this);
        written =
            "The state at the start of this step was written to time "
          + runTime_.timeName() + '.';
    }

    FatalErrorInFunction
        << what.c_str() << ": " << where.c_str() << ", in the step to time "
        << badTime << " s." << nl
        << written.c_str() << nl
        << "Likely cures: " << cures.c_str() << exit(FatalError);
}


void Foam::solidSystem::stopOnBadState()
{
    // Find the place before the state is put back
    const string where = firstOf
    (
        wrongNode_.size()
      ? wrongNode_
      : firstHere([](const solidBody& body) { return body.findBadNode(); })
    );
    stopStep
    (
        "The state is not finite or has a Jacobian that is not positive",
        where,
        integrator_.leapfrog()
      ? "a smaller maxCo or a finer mesh where the deformation is largest."
      : "a smaller maxCo, 'reconstruction linear' or a finer mesh where the "
        "deformation is largest."
    );
}


void Foam::solidSystem::stopOnLostContact(const string& where)
{
    stopStep
    (
        "A surface has gone through another one",
        where,
        "contact also on the faces around this place; a finer mesh at the "
        "surfaces, or round edges where edges dig in; the impact may be too "
        "fast for the scheme "
        "(tests/robustness/stability.md)."
    );
}


void Foam::solidSystem::checkEnergy()
{
    if (maxEnergyRise_ == 0) return;

    const List<bodyEnergies> all(computeEnergies());
    const scalar rise = accounts_.rise(all.last());
    if (rise <= maxEnergyRise_*accounts_.largest() + all.last().roundOff)
    {
        return;
    }

    // The place: the body whose energy is least explained, and its fastest node
    label worst = 0;
    for (label i = 1; i < bodies_.size(); ++i)
    {
        if (all[i].numericalDissipation < all[worst].numericalDissipation)
        {
            worst = i;
        }
    }
    scalar fastest = 0;
    forAll(bodies_, i)
    {
        if (i == worst) fastest = bodies_[i].largestSpeed();
    }
    reduce(fastest, maxOp<scalar>());
    const string where = firstOf
    (
        firstHere([&](const solidBody& body)
        {
            return
                &body == &bodies_[worst]
              ? body.findNodeFasterThan(fastest*asFast)
              : -1;
        })
    );
    OStringStream os;
    os  << "The energy has risen by " << rise << " J, "
        << rise/accounts_.largest()
        << " of its largest value (maxEnergyRise " << maxEnergyRise_ << ')';
    stopStep
    (
        os.str(),
        where,
        rise == all.last().contactGain
      ? "surfaces that are not inside each other at the start; a finer mesh "
        "where edges or corners meet. The energy came from contact."
      : integrator_.leapfrog()
      ? "a smaller maxCo, or 'cells simplicial'."
      : "a smaller maxCo, 'reconstruction linear', which never gains energy, "
        "or 'cells simplicial'."
    );
}


// ************************************************************************* //
