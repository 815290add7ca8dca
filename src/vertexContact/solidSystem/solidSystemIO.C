/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "passTimes.H"
#include "controlKeywords.H"
#include "dictionaryCheck.H"
#include "writtenTimes.H"
#include "IOdictionary.H"
#include "IStringStream.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Largest |F - I| at which a law of small strains is a choice, and the one
//  below which it is as good as others
constexpr Foam::scalar leavesSmall = 0.05;
constexpr Foam::scalar staysSmall = 0.005;

//- Largest maxCo that was found stable in all scenes
constexpr Foam::scalar largestCo = 1;

//- Fastest impact, by the speed of waves, in which all surfaces kept apart
constexpr Foam::scalar fastImpact = 0.7;

//- Share of its energy above which a gain is worth a warning
constexpr Foam::scalar gains = 0.01;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::solidSystem::maxCo() const
{
    const dictionary& control = runTime_.controlDict();
    const scalar maxCo = control.getOrDefault("maxCo", preset_.maxCo);
    dictionaryCheck::require(maxCo > 0, control, "maxCo", maxCo, "positive");
    return maxCo;
}


Foam::timeIntegrator Foam::solidSystem::readIntegrator
(
    const dictionary& controlDict,
    const preset& defaults
)
{
    return timeIntegrator
    (
        dictionaryCheck::readEnum
        (
            timeIntegrator::names, controlDict, "timeIntegrator",
            defaults.integrator
        )
    );
}


void Foam::solidSystem::checkIntegrator() const
{
    if
    (
        !integrator_.leapfrog()
     && integrator_.type() != integratorType::TVDRK3
    )
    {
        for (const solidBody& body : bodies_)
        {
            // Twice the same node where ranks share it: never too few
            const label nodes =
                returnReduce(body.dual().nNodes(), sumOp<label>());
            if (nodes <= std::pow(3, body.dual().nDim()))
            {
                WarningInFunction
                    << "Region '" << body.name() << "' has " << nodes
                    << " nodes. What vibrates in bodies of two cells across "
                    << "is not damped, and grows in long runs with "
                    << timeIntegrator::names[integrator_.type()]
                    << " (tests/robustness/stability.md): more cells, or "
                    << "'timeIntegrator TVDRK3'." << endl;
            }
        }
    }
    if (ratios_->active() && !integrator_.leapfrog())
    {
        FatalIOErrorInFunction(runTime_.controlDict())
            << "Keyword 'subCycling' is yes, which does not go with preset "
            << preset::names[preset_.name] << " (timeIntegrator "
            << timeIntegrator::names[integrator_.type()]
            << "). Valid integrators for it: (leapfrog)"
            << exit(FatalIOError);
    }
    for (const solidBody& body : bodies_)
    {
        if (body.variational() != integrator_.leapfrog())
        {
            FatalIOErrorInFunction(runTime_.controlDict())
                << "Keyword 'timeIntegrator': "
                << timeIntegrator::names[integrator_.type()]
                << " does not go with preset " << preset::names[preset_.name]
                << ". Valid integrators for it: "
                << (
                       body.variational()
                     ? "(leapfrog)" : "(TVDRK2 TVDRK3 symplecticEuler)"
                   )
                << exit(FatalIOError);
        }
    }
    if (!integrator_.split()) return;

    for (const solidBody& body : bodies_)
    {
        if (body.options().reconstruction == reconstructionType::full)
        {
            FatalIOErrorInFunction(runTime_.controlDict())
                << "Keyword 'timeIntegrator': symplecticEuler goes with "
                << "'reconstruction' linear or none, but region '"
                << body.name() << "' has full (fvSchemes). Valid integrators "
                << "for full: (TVDRK2 TVDRK3)" << exit(FatalIOError);
        }
    }
}


bool Foam::solidSystem::allRigid() const
{
    bool all = true;
    for (const solidBody& body : bodies_) all = all && body.rigid();
    return all;
}


void Foam::solidSystem::checkRigid() const
{
    const dictionary& control = runTime_.controlDict();
    if (allRigid() && control.getOrDefault("adjustTimeStep", true))
    {
        FatalIOErrorInFunction(control)
            << "Keyword 'adjustTimeStep' is yes, but all regions are rigid: "
            << "nothing says how long a step may be. It must be no, with "
            << "'deltaT'" << exit(FatalIOError);
    }
}


void Foam::solidSystem::checkImpacts() const
{
    // The speed of waves follows the stretch anyway
    if (integrator_.leapfrog()) return;

    for (const contactInterface& all : interfaces_)
    for (const contactInterface& contact : all.parts())
    {
        const List<contactSide> sides(contact.sides());
        const solidBody& a = *sides.first().body;
        const solidBody& b = *sides.last().body;
        const bool stretches =
            (a.material().stretchesWaves() && !a.options().stretchedWaves)
         || (b.material().stretchesWaves() && !b.options().stretchedWaves);

        // Of an obstacle: as if it were at rest
        const vector v(a.meanVelocity());
        const scalar speed = mag(sides.size() > 1 ? v - b.meanVelocity() : v);
        const scalar cp = min(a.material().cp(), b.material().cp());
        if (stretches && speed > fastImpact*cp)
        {
            WarningInFunction
                << "Interface '" << contact.name() << "': the bodies approach "
                << "with " << speed/cp << " of the speed of their waves. "
                << "Above " << fastImpact << " surfaces may go through each "
                << "other (tests/robustness/stability.md): 'waveSpeed "
                << "stretched' in fvSchemes." << endl;
        }
    }
}


void Foam::solidSystem::checkControls() const
{
    controlKeywords::check(runTime_);
    if (maxCo() > largestCo)
    {
        WarningInFunction
            << "maxCo is " << maxCo() << ": above " << largestCo
            << " steps may be unstable (tests/robustness/stability.md)."
            << endl;
    }
    const dictionary& control = runTime_.controlDict();
    const scalar rise = control.getOrDefault<scalar>("maxEnergyRise", 1);
    dictionaryCheck::require
    (
        rise > 0, control, "maxEnergyRise", rise, "positive"
    );
    const scalar least = control.getOrDefault<scalar>("minDeltaT", 0);
    dictionaryCheck::require
    (
        least >= 0, control, "minDeltaT", least, "at least 0"
    );
    const label interval = control.getOrDefault<label>("logInterval", 100);
    dictionaryCheck::require
    (
        interval > 0, control, "logInterval", interval, "positive"
    );
}


void Foam::solidSystem::checkProcessors() const
{
    if (!Pstream::parRun()) return;

    const fileName mine
    (
        fileHandler().filePath(runTime_.path()/runTime_.constant())
    );
    label missing = mine.size() ? labelMax : Pstream::myProcNo();
    reduce(missing, minOp<label>());
    if (missing != labelMax)
    {
        FatalErrorInFunction
            << "There is no " << runTime_.constant() << " folder of processor"
            << missing << ", but the run has " << Pstream::nProcs()
            << " ranks." << nl << "Decompose the case for as many: "
            << "decomposePar -allRegions -force" << exit(FatalError);
    }
}


Foam::dictionary Foam::solidSystem::readRecord()
{
    IOobject io
    (
        "solidSystem", runTime_.timeName(), "uniform", runTime_,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (!dictionaryCheck::isThere<IOdictionary>(io))
    {
        return dictionary();
    }
    const IOdictionary record(io);
    const scalar exact = record.get<scalar>("time");
    if (runTime_.timeName(exact) != runTime_.timeName())
    {
        return dictionary();
    }
    runTime_.setTime(exact, runTime_.timeIndex());
    return record;
}


void Foam::solidSystem::readSteps(const dictionary& record)
{
    leastLimit_.read(record);
    commonStep_ = record.getOrDefault<scalar>("lastStep", 0);
    shortStep_ = record.getOrDefault<scalar>("shortStep", commonStep_);
    if (record.found("shortStep") && !ratios_->active())
    {
        FatalIOErrorInFunction(runTime_.controlDict())
            << "Keyword 'subCycling' is no, but the run that this one goes on "
            << "from had steps of their own: it must be yes. "
            << "'maxSubCycles 1' gives one step to all regions."
            << exit(FatalIOError);
    }
    forAll(bodies_, i)
    {
        const dictionary& its =
            record.subOrEmptyDict("region_" + bodies_[i].name());
        bodies_[i].setLastStep
        (
            its.getOrDefault<scalar>("lastStep", commonStep_)
        );
        ratios_->read(i, its);
        bodies_[i].readRigid(its.subOrEmptyDict("rigid"));
    }
}


void Foam::solidSystem::readAccounts(const dictionary& dict)
{
    // Accounts that were not kept cannot be continued
    bool continued = dict.getOrDefault("energiesOn", false);
    if (!dict.empty())
    {
        forAll(bodies_, i)
        {
            const word key("region_" + bodies_[i].name());
            if (!dict.found(key))
            {
                continued = false;
                break;
            }
            const dictionary& body = dict.subDict(key);
            initialEnergy_[i] = body.get<scalar>("initialEnergy");
            if (Pstream::master())
            {
                accounts_[i].numericalDissipation =
                    body.get<scalar>("numericalDissipation");
                accounts_[i].plastic =
                    body.getOrDefault<scalar>("plasticDissipation", 0);
                accounts_[i].external = body.get<scalar>("externalWork");
                accounts_[i].contact = body.get<scalar>("contactWork");
                accounts_[i].damping =
                    body.getOrDefault<scalar>("dampingDissipation", 0);
                accounts_[i].relaxation =
                    body.getOrDefault<scalar>("relaxationDissipation", 0);
            }
        }
        for (contactInterface& contact : interfaces_)
        {
            if (dict.found("interface_" + contact.name()))
            {
                contact.readRecord
                (
                    dict.subDict("interface_" + contact.name())
                );
            }
        }
    }

    accountsContinued_ = continued;
    if (!continued)
    {
        forAll(bodies_, i)
        {
            accounts_[i] = solidBody::powers();
            initialEnergy_[i] = 0;
            initialEnergy_[i] = bodyEnergies(i).total();
        }
    }
}


void Foam::solidSystem::checkRange()
{
    forAll(bodies_, i)
    {
        scalar& largest = largestGradient_[i];
        const bool warned = largest > leavesSmall;
        largest = max(largest, bodies_[i].largestGradient());
        if (bodies_[i].data().finiteStrain || warned)
        {
            continue;
        }
        reduce(largest, maxOp<scalar>());
        if (largest > leavesSmall)
        {
            WarningInFunction
                << "Region " << bodies_[i].name() << ": |F - I| has reached "
                << largest << ", but " << bodies_[i].material().type()
                << " is a law of small strains and rotations, whose stress is "
                << "then wrong by about as much." << nl
                << "    A step with neoHookean takes about 1.25 times as long "
                << "(tests/benchmark/features.md)." << endl;
        }
    }
}


void Foam::solidSystem::checkDissipation(const List<energies>& all)
{
    forAll(bodies_, i)
    {
        const energies& e = all[i];
        const scalar share = -e.numericalDissipation/(e.total() + VSMALL);
        if (!warnedOfGain_ && share > gains)
        {
            warnedOfGain_ = true;
            WarningInFunction
                << "Region " << bodies_[i].name() << " has gained "
                << 100*share << " % of its energy from the fluxes, which "
                << "ought to take some (numericalDissipation < 0)." << nl
                << "    Likely cures: "
                << (
                       integrator_.leapfrog()
                     ? "a smaller maxCo."
                     : "'reconstruction linear', which does not gain energy; "
                       "more than three cells across the body."
                   )
                << endl;
        }
    }

    const energies& e = all.last();
    const scalar own = e.total() - e.externalWork;
    for (label i = 0; i < 2; ++i)
    {
        const scalar now = i ? own - e.contactWork : own;
        leastLogged_[i] = min(leastLogged_[i], now);
        riseLogged_[i] = max(riseLogged_[i], now - leastLogged_[i]);
    }
    largestLogged_ = max(largestLogged_, e.total());
}


void Foam::solidSystem::reportGain() const
{
    // Obstacles that move do work, which the first does not know; and the
    // second takes what contact stores and gives back for a rise
    const scalar rise = min(riseLogged_[0], riseLogged_[1]);
    if (!warnedOfGain_ && rise > gains*largestLogged_)
    {
        WarningInFunction
            << "The energy has risen by " << 100*rise/largestLogged_
            << " % of its largest value, without work." << nl
            << "    Likely cures: a finer mesh, a smaller maxCo; for standing "
            << "loads no law 'tied'. "
            << "'maxEnergyRise' in controlDict ends a run where it happens."
            << endl;
    }
}


void Foam::solidSystem::reportRange(Ostream& os) const
{
    forAll(bodies_, i)
    {
        const solidBody& body = bodies_[i];
        if (!body.data().finiteStrain || body.rigid() || !steps_)
        {
            continue;
        }
        if (body.material().plastic())
        {
            const scalar flow = returnReduce
            (
                max(body.state().epsilonPEq), maxOp<scalar>()
            );
            if (flow == 0)
            {
                os  << "Region " << body.name() << " has not yielded: a step "
                    << "with neoHookean takes about 0.85 of the time of one "
                    << "with " << body.material().type() << nl << nl;
            }
            continue;
        }
        const scalar largest =
            returnReduce(largestGradient_[i], maxOp<scalar>());
        if (largest < staysSmall)
        {
            os  << "Region " << body.name() << ": |F - I| stayed below "
                << largest << " where it was logged. linearElastic, whose "
                << "stress differs by about as much, takes about 0.8 of the "
                << "time of " << body.material().type() << nl << nl;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::solidSystem::logs(const label steps, const scalar time) const
{
    const label interval =
        runTime_.controlDict().getOrDefault<label>("logInterval", 100);
    const bool last =
        time > runTime_.endTime().value() - 0.5*runTime_.deltaTValue();
    return last || steps % max(label(1), interval) == 0;
}


void Foam::solidSystem::log()
{
    if (!logs(steps_, runTime_.value()))
    {
        return;
    }

    checkRange();

    label nClosed = 0;
    for (const contactInterface& contact : interfaces_)
    {
        const auto& s = contact.stageStatistics();
        nClosed += s.nStick + s.nSlip;
    }
    reduce(nClosed, sumOp<label>());

    const scalar done = runTime_.value() - startOfRun_;
    const scalar left = runTime_.endTime().value() - runTime_.value();
    const scalar elapsed = clock_.elapsedTime();

    // The file's precision would make the line unreadable
    OSstream& os = Info;
    const int precision = os.precision(6);

    os  << "Step " << steps_ << "  Time " << runTime_.value()
        << " s  deltaT " << runTime_.deltaTValue() << " s  Co "
        << runTime_.deltaTValue()/timeStepLimit_;
    if (energiesOn_)
    {
        const List<energies> all(computeEnergies());
        checkDissipation(all);
        const energies& e = all.last();
        os  << "  kinetic " << e.kinetic << "  strain " << e.strain
            << "  dissipated " << e.numericalDissipation
            << "  balance " << e.balance << " J";
    }
    if (relaxation_.valid()) relaxation_->log(os);
    os  << "  contacts " << nClosed << "  left "
        << (done > 0 ? std::round(max(left, scalar(0))*elapsed/done) : 0)
        << " s" << endl;

    os.precision(precision);
}


const Foam::word& Foam::solidSystem::type() const
{
    return IOdictionary::typeName;
}


void Foam::solidSystem::write()
{
    if (relaxation_.valid() && relaxation_->done())
    {
        Info<< "The bodies are in balance: the run ends" << endl;
        runTime_.writeAndEnd();
    }
    else if (asked_ >= stopSignals::writeAndEnd)
    {
        Info<< "Asked by a signal to write and to end" << endl;
        runTime_.writeAndEnd();
    }
    else if (asked_ > 0)
    {
        Info<< "Asked by a signal to write" << endl;
        runTime_.writeNow();
    }
    else
    {
        runTime_.write();
    }
    asked_ = 0;

    if (runTime_.writeTime())
    {
        writtenTimes::check(*this);
    }
}


bool Foam::solidSystem::writeData(Ostream& os) const
{
    // Bodies set their fields; pairings are found as in a run that is
    // restarted from here
    solidSystem& self = const_cast<solidSystem&>(*this);
    for (const contactInterface& contact : interfaces_)
    {
        self.pairAgain_ = pairAgain_ || contact.moves();
        self.pairAll_ = self.pairAgain_;
    }

    // In binary files, uniform fields are text: 17 digits bring back the same
    // double
    const unsigned int digits = IOstream::defaultPrecision();
    if (runTime_.writeFormat() == IOstream::BINARY)
    {
        IOstream::defaultPrecision(17);
    }
    for (solidBody& body : self.bodies_)
    {
        body.write();
    }
    IOstream::defaultPrecision(digits);

    // The run goes on as one that is started from here does
    for (solidBody& body : self.bodies_)
    {
        body.forgetRates();
    }
    self.sinceBound_ = 0;
    self.boundsAnew_ = true;

    // Reduced here, since every rank writes
    const auto total = [](const scalar share)
    {
        return returnReduce(share, sumOp<scalar>());
    };

    OStringStream text;
    text.precision(17);
    text<< "time " << runTime_.value() << ';' << nl
        << "lastStep "
        << (ratios_->active() ? commonStep_ : bodies_[0].lastStep())
        << ';' << nl
        << "energiesOn " << (energiesOn_ ? "yes" : "no") << ';' << nl;
    leastLimit_.write(text);
    if (ratios_->active()) text<< "shortStep " << shortStep_ << ';' << nl;
    forAll(bodies_, i)
    {
        text<< "region_" << bodies_[i].name() << nl << '{' << nl;
        if (ratios_->active())
        {
            text<< "    lastStep " << bodies_[i].lastStep() << ';' << nl;
            ratios_->write(i, text);
        }
        text
            << "    initialEnergy " << initialEnergy_[i] << ';' << nl
            << "    numericalDissipation "
            << total(accounts_[i].numericalDissipation) << ';' << nl
            << "    plasticDissipation " << total(accounts_[i].plastic)
            << ';' << nl
            << "    externalWork " << total(accounts_[i].external) << ';' << nl
            << "    contactWork " << total(accounts_[i].contact) << ';' << nl;
        if (damped_)
        {
            text<< "    dampingDissipation " << total(accounts_[i].damping)
                << ';' << nl;
        }
        if (relaxation_.valid())
        {
            text<< "    relaxationDissipation "
                << total(accounts_[i].relaxation) << ';' << nl;
        }
        if (bodies_[i].massFactor() != 1)
        {
            text<< "    massFactor " << bodies_[i].massFactor() << ';' << nl;
        }
        if (bodies_[i].rigid())
        {
            text<< "    rigid" << nl << "    {" << nl;
            bodies_[i].writeRigid(text);
            text<< "    }" << nl;
        }
        text<< '}' << nl;
    }
    if (relaxation_.valid())
    {
        text<< "relaxation" << nl << '{' << nl;
        relaxation_->write(text);
        text<< '}' << nl;
    }
    for (const contactInterface& contact : interfaces_)
    {
        text<< "interface_" << contact.name() << nl << '{' << nl;
        contact.writeRecord(text);
        text<< '}' << nl;
    }
    if (functionWriters_.size())
    {
        text<< "functionObjects" << nl << '{' << nl;
        for (const word& name : functionWriters_.sortedToc())
        {
            text<< name << nl << '{' << nl;
            functionWriters_[name](text);
            text<< '}' << nl;
        }
        text<< '}' << nl;
    }

    const int precision = os.precision(17);
    dictionary(IStringStream(text.str())()).write(os, false);
    os.precision(precision);

    // So that a disk that is full is seen before old times are purged
    os.flush();
    return os.good();
}


void Foam::solidSystem::report(Ostream& os) const
{
    os  << "Preset " << preset::names[preset_.name] << ": timeIntegrator "
        << timeIntegrator::names[integrator_.type()];
    if (runTime_.controlDict().getOrDefault("adjustTimeStep", true))
    {
        os  << ", maxCo " << maxCo() << nl;
    }
    else
    {
        os  << ", fixed step" << nl;
    }
    if (ratios_->active())
    {
        os  << "Steps of their own for the regions" << nl;
    }
    massScaling_->report(bodies_, os);
    if (relaxation_.valid())
    {
        os  << "Relaxation: at each peak of the kinetic energy what is free "
            << "is stopped" << nl;
    }
    for (const solidBody& body : bodies_)
    {
        os  << "Region " << body.name() << nl;
        body.report(os);
        os  << nl;
    }
    for (const contactInterface& contact : interfaces_)
    {
        contact.report(os);
    }
    if (interfaces_.empty())
    {
        os  << "No contact interfaces" << nl;
    }
    os  << endl;
}


void Foam::solidSystem::reportCost(OSstream& os) const
{
    // The file's precision would make figures unreadable
    const int precision = os.precision(6);

    const scalarField bodyNodes(countNodes());
    const scalar nodes = sum(bodyNodes);
    if (steps_)
    {
        os  << "Steps: " << steps_ << " in " << stepSeconds_ << " s, "
            << 1e6*stepSeconds_/(scalar(steps_)*max(nodes, scalar(1)))
            << " us per node and step" << nl << nl;
        if (passTimes::wanted())
        {
            scalar bytes = 0;
            for (const solidBody& body : bodies_) bytes += body.bytes();
            reduce(bytes, sumOp<scalar>());
            passTimes::report
            (
                os, stepSeconds_, scalar(steps_)*nodes, bytes/nodes
            );
        }
    }

    if (steps_ && bodies_.size() > 1)
    {
        scalarField stable(bodyStep_);
        os  << "Stable steps at Co 1, at the end:";
        forAll(bodies_, i)
        {
            stable[i] = returnReduce(stable[i], minOp<scalar>());
            os  << ' ' << bodies_[i].name() << ' ' << stable[i] << " s";
        }
        os  << nl;
        reportSteps(os, stable);
        os  << nl;
    }

    reportRange(os);
    reportGain();
    if (relaxation_.valid() && !dry_) relaxation_->report(os);

    if (interfaces_.size() && steps_)
    {
        const scalar percent = 100/max(stepSeconds_, VSMALL);
        os  << "Contact: " << percent*pairingSeconds_
            << " % of the time of the steps in " << nPairings_
            << " pairings, " << percent*contactSeconds_ << " % in fluxes"
            << nl << nl;
    }
    os.precision(precision);
}


// ************************************************************************* //
