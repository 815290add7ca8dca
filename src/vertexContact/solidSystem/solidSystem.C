/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "generalInterface.H"
#include "passTimes.H"
#include "dictionaryCheck.H"
#include "fileError.H"
#include "writtenTimes.H"
#include "uniformDimensionedFields.H"
#include "IOdictionary.H"
#include <chrono>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(solidSystem, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Regions of the group solid in constant/regionProperties, or the default one
wordList regionNames(const Time& runTime)
{
    IOobject io
    (
        "regionProperties", runTime.constant(), runTime,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (!dictionaryCheck::isThere<IOdictionary>(io))
    {
        return wordList(1, polyMesh::defaultRegion);
    }

    const IOdictionary dict(io);
    dictionaryCheck::onlyKeywords(dict, wordList({"regions"}));
    const HashTable<wordList> groups
    (
        dict.get<HashTable<wordList>>("regions")
    );

    wordList names;
    for (const word& group : groups.sortedToc())
    {
        if (group != "solid")
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'regions': unknown group '" << group
                << "'. Valid groups: (solid)" << exit(FatalIOError);
        }
        names.append(groups[group]);
    }
    forAll(names, i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (names[i] == names[j])
            {
                FatalIOErrorInFunction(dict)
                    << "Keyword 'regions': region '" << names[i]
                    << "' is listed twice" << exit(FatalIOError);
            }
        }
        const fileName mesh
        (
            runTime.path()/runTime.constant()/names[i]/"polyMesh"
        );
        if (!isDir(mesh) && !Pstream::parRun())
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'regions': region '" << names[i]
                << "' has no mesh, there is no folder " << mesh
                << exit(FatalIOError);
        }
    }
    if (names.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'regions' lists no region. Example: "
            << "regions ( solid (bar1 bar2) );" << exit(FatalIOError);
    }
    return names;
}

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

void Foam::solidSystem::energies::operator+=(const energies& e)
{
    kinetic += e.kinetic;
    strain += e.strain;
    plasticDissipation += e.plasticDissipation;
    numericalDissipation += e.numericalDissipation;
    externalWork += e.externalWork;
    contactWork += e.contactWork;
    dampingDissipation += e.dampingDissipation;
    relaxationDissipation += e.relaxationDissipation;
    balance += e.balance;
}


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
        body.computeFluxes(energiesOn_);
        body.finishRates(time, energiesOn_);
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
        body.prepare(time, true, boundsAnew_);
        body.computeFluxes(energiesOn_);
        body.finishRates(time, energiesOn_);
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
        const bool adjusts =
            runTime_.controlDict().getOrDefault("adjustTimeStep", true);
        for (label i = 0; i < 2; ++i)
        {
            solve
            (
                0.5*(adjusts ? maxCo()*stableStep() : runTime_.deltaTValue())
            );
        }
    }
    for (solidBody& body : bodies_)
    {
        body.addContactForces();
    }
}


Foam::scalar Foam::solidSystem::stableStep()
{
    const bool anew = boundsAnew_ || !integrator_.leapfrog();
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
    fastest_ = -least.y();
    boundsAnew_ = false;
    return least.x();
}


void Foam::solidSystem::account(const int stage)
{
    const scalar dt = integrator_.weight(stage)*runTime_.deltaTValue();
    if (energiesOn_)
    {
        forAll(bodies_, i)
        {
            const solidBody::powers& p = bodies_[i].stagePowers();
            accounts_[i].numericalDissipation += dt*p.numericalDissipation;
            accounts_[i].external += dt*p.external;
            accounts_[i].contact += dt*p.contact;
        }
    }
    for (contactInterface& contact : interfaces_)
    {
        contact.accumulate(dt);
    }
}


void Foam::solidSystem::advance(const int stage, const updatedPart part)
{
    const scalar deltaT = runTime_.deltaTValue();
    label nBad = 0;
    for (solidBody& body : bodies_)
    {
        nBad += body.advance
        (
            deltaT, integrator_.oldWeight(stage),
            integrator_.instant(stage + 1)*deltaT, part
        );
    }

    // Others hear of it at the end of the step: until then, a state that can
    // be evaluated
    if (nBad)
    {
        wrongNode_ = describeHere
        (
            [](const solidBody& body) { return body.findBadNode(); }
        );
        for (solidBody& body : bodies_)
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
    for (solidBody& body : bodies_)
    {
        nBad += body.advance
        (
            deltaT, integrator_.oldWeight(stage), deltaT, part
        );
    }

    settle(nBad);
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
            bodies_[i].leap(startOfStep_, deltaT, energiesOn_, accounts_[i]);
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

    // The edges of a cell hold all of its strain
    sinceBound_ += deltaT*fastest_;
    if (sinceBound_ >= boundStrain)
    {
        sinceBound_ = 0;
        boundsAnew_ = true;
    }
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


Foam::scalar Foam::solidSystem::fittedInterval() const
{
    const dictionary& control = runTime_.controlDict();
    const word writeControl
    (
        control.getOrDefault<word>("writeControl", "timeStep")
    );
    return
        writeControl == "adjustableRunTime" || writeControl == "adjustable"
      ? control.get<scalar>("writeInterval")
      : GREAT;
}


Foam::scalar Foam::solidSystem::nextFitted
(
    const scalar now,
    const scalar deltaT
) const
{
    scalar next = runTime_.endTime().value();
    const scalar interval = fittedInterval();
    if (interval < GREAT)
    {
        // Times are multiples of the interval, counted from the start of the
        // run as Time does; from zero where both are the same, so that a
        // restarted run takes the same steps to the last bit
        const scalar start = runTime_.startTime().value();
        const scalar offset =
            mag(start/interval - std::round(start/interval)) < 1e-6
          ? 0 : start;
        const scalar slack = min(scalar(1e-6), 1e-3*deltaT/interval);
        const scalar k = std::floor((now - offset)/interval + slack) + 1;
        next = min(next, offset + k*interval);
    }
    return next;
}


Foam::scalar Foam::solidSystem::fitToWriteTimes(const scalar deltaT) const
{
    const scalar now = runTime_.value();
    const scalar remaining = nextFitted(now, deltaT) - now;
    if (remaining <= 0)
    {
        return deltaT;
    }
    return remaining/max(scalar(1), std::ceil(remaining/deltaT - 1e-6));
}


template<class Find>
Foam::string Foam::solidSystem::describeHere(const Find& find) const
{
    for (const solidBody& body : bodies_)
    {
        const label node = find(body);
        if (node >= 0)
        {
            OStringStream os;
            os  << "region " << body.name() << ", node at "
                << body.mesh().points()[body.dual().nodePoint()[node]]
                << " (reference) " << body.position(node) << " (current)";
            return os.str();
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
        if (s.size())
        {
            return s;
        }
    }
    return message;
}


void Foam::solidSystem::checkTimeStep()
{
    if (leastTimeStep_ == 0)
    {
        leastTimeStep_ =
            runTime_.controlDict().getOrDefault<scalar>
            (
                "minDeltaT",
                1e-6
               *(
                    allRigid()
                  ? min(timeStepLimit_, runTime_.deltaTValue())
                  : timeStepLimit_
                )
            );
    }
    if (timeStepLimit_ >= leastTimeStep_)
    {
        return;
    }
    const string what = firstOf
    (
        describeHere
        (
            [&](const solidBody& b) { return b.findNodeWithin(timeStepLimit_); }
        )
    );
    if (runTime_.value() != startOfRun_ && !dry_)
    {
        runTime_.writeNow();
    }
    FatalErrorInFunction
        << "The stable time step has fallen to " << timeStepLimit_
        << " s, below " << leastTimeStep_ << " s (minDeltaT): "
        << what.c_str() << ", at time " << runTime_.value() << " s." << nl
        << "Likely cures: cells that are less distorted there, or a material "
        << "that is meant for such deformations." << exit(FatalError);
}


void Foam::solidSystem::stopStep
(
    const string& what,
    const string& where,
    const string& cures
)
{
    const scalar badTime = runTime_.value();
    forAll(bodies_, i)
    {
        bodies_[i].restoreOld();
        accounts_[i] = oldAccounts_[i];
        bodies_[i].contact().status = oldStatus_[i];
        bodies_[i].contact().slide = oldSlide_[i];
    }
    for (contactInterface& contact : interfaces_)
    {
        contact.restoreSums();
    }
    commonStep_ = oldCommonStep_;
    shortStep_ = oldShortStep_;
    runTime_.setTime(startOfStep_, runTime_.timeIndex() - 1);
    if (integrator_.leapfrog())
    {
        // Its velocities and tractions, as a run that starts from it has them
        evaluateForces(startOfStep_, false);
    }

    // The state that the run started from is there already
    string written
    (
        dry_ ? "Nothing was written: this is a dry run."
      : "Nothing was written: this was the first step."
    );
    if (startOfStep_ != startOfRun_ && !dry_)
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
    // Where, before the state is put back
    const string where = firstOf
    (
        wrongNode_.size()
      ? wrongNode_
      : describeHere
        (
            [](const solidBody& body) { return body.findBadNode(); }
        )
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
        "a finer mesh at the surfaces, or edges that are rounded where they "
        "dig in; an impact that fast may be beyond the scheme "
        "(tests/robustness/stability.md)."
    );
}


void Foam::solidSystem::checkEnergy()
{
    const List<energies> all(computeEnergies());
    const energies& e = all.last();
    const scalar own = e.total() - e.externalWork - e.contactWork;

    leastEnergy_ = min(leastEnergy_, own);
    largestEnergy_ = max(largestEnergy_, e.total());
    if (own - leastEnergy_ <= maxEnergyRise_*largestEnergy_)
    {
        return;
    }

    // Where: the body that has least reason for its energy, and its fastest
    // node
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
        describeHere
        (
            [&](const solidBody& body)
            {
                return
                    &body == &bodies_[worst]
                  ? body.findNodeFasterThan(fastest*(1 - 1e-12))
                  : -1;
            }
        )
    );
    OStringStream os;
    os  << "The energy has risen by " << own - leastEnergy_ << " J, "
        << (own - leastEnergy_)/largestEnergy_
        << " of its largest value (maxEnergyRise " << maxEnergyRise_ << ')';
    stopStep
    (
        os.str(),
        where,
        integrator_.leapfrog()
      ? "a smaller maxCo, or 'cells simplicial'."
      : "a smaller maxCo, 'reconstruction linear', which never gains energy, "
        "or 'cells simplicial'."
    );
}


const Foam::dictionary& Foam::solidSystem::interfaceDicts() const
{
    const dictionary& dict = contactProperties_();
    dictionaryCheck::onlyKeywords(dict, wordList({"interfaces"}));
    const dictionary& list = dict.subDict("interfaces");
    for (const entry& e : list)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(list)
                << "Keyword '" << e.keyword()
                << "' is not a dictionary: an interface is"
                << exit(FatalIOError);
        }
    }
    return list;
}


void Foam::solidSystem::readLaws()
{
    const dictionary& list = interfaceDicts();
    for (contactInterface& contact : interfaces_)
    {
        contact.readLaw(list.subDict(contact.dictName()));
    }
    contactProperties_->changed = false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidSystem::solidSystem(Time& runTime)
:
    regIOobject
    (
        IOobject
        (
            "solidSystem", runTime.timeName(), "uniform", runTime,
            IOobject::NO_READ, IOobject::AUTO_WRITE
        )
    ),
    runTime_(runTime),
    preset_(runTime.controlDict()),
    integrator_(readIntegrator(runTime.controlDict(), preset_))
{
    checkControls();
    checkProcessors();
    const dictionary record(readRecord());

    const wordList regions(regionNames(runTime));
    bodies_.setSize(regions.size());
    forAll(regions, i)
    {
        bodies_.set(i, new solidBody(runTime, regions[i], preset_.scheme));
    }

    ratios_.reset(new stepRatios(runTime.controlDict(), countNodes()));
    checkIntegrator();
    checkRigid();
    readSlowLoading(record);

    IOobject contactIO
    (
        "contactProperties", runTime.constant(), runTime,
        IOobject::MUST_READ_IF_MODIFIED, IOobject::NO_WRITE
    );
    if (dictionaryCheck::isThere<IOdictionary>(contactIO))
    {
        contactProperties_.reset(new watchedDictionary(contactIO));
        const dictionary& list = interfaceDicts();
        // Pairs with an interface of their own are not those of many
        for (const bool general : {false, true})
        {
            for (const entry& e : list)
            {
                if (generalInterface::describedBy(e.dict()) == general)
                {
                    contactInterface::append
                    (
                        e.keyword(), e.dict(), bodies_, interfaces_
                    );
                }
            }
        }
    }

    // A contact patch outside all interfaces would silently be free
    for (const solidBody& body : bodies_)
    {
        for (const label patchi : body.contactPatches())
        {
            bool named = false;
            for (const contactInterface& contact : interfaces_)
            {
                for (const contactSide& s : contact.sides())
                {
                    named = named || (s.body == &body && s.patchi == patchi);
                }
            }
            if (!named)
            {
                FatalFileErrorInFunction(contactIO.objectPath())
                    << "Keyword 'interfaces': no interface has patch '"
                    << body.mesh().boundaryMesh()[patchi].name()
                    << "' of region '" << body.name()
                    << "' as a side, but its 'type' in pointU is "
                    << "'contact'" << exit(FatalIOError);
            }
        }
    }

    checkImpacts();

    IOobject gravityIO
    (
        "g", runTime.constant(), runTime,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (dictionaryCheck::isThere<uniformDimensionedVectorField>(gravityIO))
    {
        const uniformDimensionedVectorField g(gravityIO);
        if (g.dimensions() != dimAcceleration)
        {
            FatalFileErrorInFunction(gravityIO.objectPath())
                << "Keyword 'dimensions' is " << g.dimensions()
                << ": it must be " << dimAcceleration << exit(FatalIOError);
        }
        for (solidBody& body : bodies_)
        {
            body.setGravity(g.value());
        }
    }

    accounts_.setSize(bodies_.size());
    largestGradient_.setSize(bodies_.size(), scalar(0));
    bodyStep_.setSize(bodies_.size(), scalar(0));
    oldStatus_.setSize(bodies_.size());
    oldSlide_.setSize(bodies_.size());
    initialEnergy_.setSize(bodies_.size(), scalar(0));
    readAccounts(record);
    functionRecords_ = record.subOrEmptyDict("functionObjects");
    readSteps(record);
    maxEnergyRise_ =
        runTime.controlDict().getOrDefault<scalar>("maxEnergyRise", 0);
    if (maxEnergyRise_ > 0)
    {
        accountEnergies();
    }
    startOfRun_ = runTime_.value();

    for (solidBody& body : bodies_)
    {
        body.releaseMeshTables();
    }
    if (integrator_.leapfrog())
    {
        evaluate(startOfRun_, 0);
    }

    // Time::run() compares the end with deltaT, which is not ours before the
    // first step
    const scalar left = runTime_.endTime().value() - startOfRun_;
    if (runTime_.controlDict().getOrDefault("adjustTimeStep", true) && left > 0)
    {
        runTime_.setDeltaT(min(runTime_.deltaTValue(), 0.5*left), false);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::solidSystem::findBody(const word& region) const
{
    forAll(bodies_, i)
    {
        if (bodies_[i].name() == region) return i;
    }
    return -1;
}


void Foam::solidSystem::accountEnergies()
{
    if (!energiesOn_ && integrator_.leapfrog())
    {
        energiesOn_ = true;
        evaluate(runTime_.value(), 0);
        energiesOn_ = false;
    }

    // Works and dissipation count from now
    if (!energiesOn_ && !accountsContinued_)
    {
        forAll(bodies_, i)
        {
            initialEnergy_[i] = 0;
            initialEnergy_[i] = bodyEnergies(i).total();
        }
    }
    energiesOn_ = true;
}


void Foam::solidSystem::accountReactions()
{
    bool on = true;
    for (solidBody& body : bodies_)
    {
        if (body.reactionsOn()) continue;
        body.accountReactions();
        on = false;
    }
    // They need the rates of this instant
    if (!on) evaluate(runTime_.value(), 0);
}


Foam::solidSystem::energies Foam::solidSystem::bodyEnergies
(
    const label i
) const
{
    // To the time of the state, half a step after the last of the leapfrog
    solidBody::powers accounts(accounts_[i]);
    if (energiesOn_ && integrator_.leapfrog())
    {
        const solidBody::powers p(bodies_[i].presentPowers());
        const scalar half = 0.5*bodies_[i].lastStep();
        accounts.numericalDissipation += half*p.numericalDissipation;
        accounts.external += half*p.external;
        accounts.contact += half*p.contact;
        accounts.damping += half*p.damping;
    }

    energies e;
    e.kinetic = returnReduce(bodies_[i].kineticEnergy(), sumOp<scalar>());
    e.strain = returnReduce(bodies_[i].strainEnergy(), sumOp<scalar>());
    e.numericalDissipation =
        returnReduce(accounts.numericalDissipation, sumOp<scalar>());
    e.plasticDissipation = returnReduce(accounts.plastic, sumOp<scalar>());
    e.externalWork = returnReduce(accounts.external, sumOp<scalar>());
    e.contactWork = returnReduce(accounts.contact, sumOp<scalar>());
    if (damped_)
    {
        e.dampingDissipation = returnReduce(accounts.damping, sumOp<scalar>());
    }
    if (relaxation_.valid())
    {
        e.relaxationDissipation =
            returnReduce(accounts.relaxation, sumOp<scalar>());
    }
    e.balance =
        e.total() - initialEnergy_[i] + e.numericalDissipation
      + e.plasticDissipation + e.dampingDissipation
      + e.relaxationDissipation - e.externalWork - e.contactWork;
    return e;
}


Foam::List<Foam::solidSystem::energies>
Foam::solidSystem::computeEnergies() const
{
    List<energies> all(bodies_.size() + 1);
    forAll(bodies_, i)
    {
        all[i] = bodyEnergies(i);
        all.last() += all[i];
    }
    for (const contactInterface& contact : interfaces_)
    {
        all.last().frictionDissipation += contact.sums().friction;
    }
    reduce(all.last().frictionDissipation, sumOp<scalar>());
    return all;
}


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

    // What a step that goes wrong has to put back
    startOfStep_ = runTime_.value();
    oldAccounts_ = accounts_;
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

    // A fixed step needs it only where the Courant number is printed
    const dictionary& control = runTime_.controlDict();
    const bool adjusts = control.getOrDefault("adjustTimeStep", true);
    if (!adjusts && !ratios_->active())
    {
        // Nobody looks at how fast edges are strained
        sinceBound_ = GREAT;
    }
    if
    (
        adjusts
     || ratios_->active()
     || timeStepLimit_ == 0
     || logs(steps_ + 1, startOfStep_ + runTime_.deltaTValue())
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
        runTime_.setDeltaT(fitToWriteTimes(maxCo()*stable), false);
    }
    stepSeconds_ += secondsSince(start);
}


void Foam::solidSystem::finishStep()
{
    const auto start = std::chrono::steady_clock::now();
    const scalar time = runTime_.value();
    const int last = integrator_.nStages() - 1;
    if (integrator_.leapfrog())
    {
        leap(time);
        if (relaxation_.valid()) relax(time);
        if (maxEnergyRise_ > 0)
        {
            checkEnergy();
        }
        ++steps_;
        stepSeconds_ += secondsSince(start);
        return;
    }

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
        for (solidBody& body : bodies_)
        {
            body.computeGradients();
        }
        complete(last, updatedPart::kinematics);
    }
    else
    {
        complete(last, updatedPart::all);
    }
    if (maxEnergyRise_ > 0)
    {
        checkEnergy();
    }

    ++steps_;
    stepSeconds_ += secondsSince(start);
}


// ************************************************************************* //
