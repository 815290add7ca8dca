/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "dictionaryCheck.H"
#include "writtenTimes.H"
#include "IOdictionary.H"
#include "IStringStream.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidSystem::checkControls() const
{
    const dictionary& control = runTime_.controlDict();
    const scalar maxCo = control.getOrDefault<scalar>("maxCo", 0.3);
    dictionaryCheck::require(maxCo > 0, control, "maxCo", maxCo, "positive");
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
            }
        }
        for (contactInterface& contact : interfaces_)
        {
            if
            (
                Pstream::master()
             && dict.found("interface_" + contact.name())
            )
            {
                const dictionary& d =
                    dict.subDict("interface_" + contact.name());
                contact.setImpulse
                (
                    d.get<vector>("impulse"), d.get<vector>("plusImpulse")
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
        const energies e = computeEnergies().last();
        os  << "  kinetic " << e.kinetic << "  strain " << e.strain
            << "  dissipated " << e.numericalDissipation
            << "  balance " << e.balance << " J";
    }
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
    if (asked_ >= stopSignals::writeAndEnd)
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

    // Reduced here, since every rank writes
    const List<energies> e(computeEnergies());

    OStringStream text;
    text.precision(17);
    text<< "time " << runTime_.value() << ';' << nl
        << "energiesOn " << (energiesOn_ ? "yes" : "no") << ';' << nl;
    forAll(bodies_, i)
    {
        text<< "region_" << bodies_[i].name() << nl << '{' << nl
            << "    initialEnergy " << initialEnergy_[i] << ';' << nl
            << "    numericalDissipation " << e[i].numericalDissipation
            << ';' << nl
            << "    plasticDissipation " << e[i].plasticDissipation
            << ';' << nl
            << "    externalWork " << e[i].externalWork << ';' << nl
            << "    contactWork " << e[i].contactWork << ';' << nl
            << '}' << nl;
    }
    for (const contactInterface& contact : interfaces_)
    {
        const vector impulse
        (
            returnReduce(contact.impulse(), sumOp<vector>())
        );
        const vector plusImpulse
        (
            returnReduce(contact.plusImpulse(), sumOp<vector>())
        );
        text<< "interface_" << contact.name() << nl << '{' << nl
            << "    impulse " << impulse << ';' << nl
            << "    plusImpulse " << plusImpulse << ';' << nl
            << '}' << nl;
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


void Foam::solidSystem::reportCost(Ostream& os) const
{
    label nodes = 0;
    for (const solidBody& body : bodies_)
    {
        for (const bool mine : body.dual().sharing().owned())
        {
            if (mine) ++nodes;
        }
    }
    reduce(nodes, sumOp<label>());
    if (steps_)
    {
        os  << "Steps: " << steps_ << " in " << stepSeconds_ << " s, "
            << 1e6*stepSeconds_/(scalar(steps_)*nodes)
            << " us per node and step" << nl << nl;
    }

    if (interfaces_.size() && steps_)
    {
        const scalar percent = 100/max(stepSeconds_, VSMALL);
        os  << "Contact: " << percent*pairingSeconds_
            << " % of the time of the steps in " << nPairings_
            << " pairings, " << percent*contactSeconds_ << " % in fluxes"
            << nl << nl;
    }
}


// ************************************************************************* //
