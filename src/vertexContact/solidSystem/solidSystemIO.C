/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "bodyValues.H"
#include "passTimes.H"
#include "writtenTimes.H"
#include "IOdictionary.H"
#include "IStringStream.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidSystem::log()
{
    if (!control_.logs(steps_, runTime_.value())) return;

    warnings_.checkDeformations(bodies_);

    const label nClosed = contacts_.nClosed();

    // At the pace so far
    const scalar passed = runTime_.value() - start_;
    const scalar end = runTime_.endTime().value();
    const scalar left = max(end - runTime_.value(), scalar(0));
    const scalar secondsLeft =
        passed > 0 ? std::round(left*clock_.elapsedTime()/passed) : 0;

    // With the precision of the files the line would be hard to read
    OSstream& os = Info;
    const int precision = os.precision(6);

    os  << "Step " << steps_ << "  Time " << runTime_.value()
        << " s  deltaT " << runTime_.deltaTValue() << " s  Co "
        <<
        (
            subCycling_.active()
          ? subCycling_.Courant()
          : runTime_.deltaTValue()/choice_.limit()
        );
    if (accounts_.on())
    {
        const List<bodyEnergies> all(computeEnergies());
        warnings_.checkEnergies(bodies_, all);
        const bodyEnergies& e = all.last();
        os  << "  kinetic " << e.kinetic << "  strain " << e.strain
            << "  dissipated " << e.numericalDissipation
            << "  balance " << e.balance << " J";
    }
    if (relaxation_.valid()) relaxation_->log(os);
    os  << "  contacts " << nClosed << "  left "
        << secondsLeft << " s" << endl;

    os.precision(precision);
}


const Foam::word& Foam::solidSystem::type() const
{
    return IOdictionary::typeName;
}


void Foam::solidSystem::writeIfDue()
{
    if (relaxation_.valid() && relaxation_->done())
    {
        Info<< "The bodies are in balance: the run ends" << endl;
        runTime_.writeAndEnd();
    }
    else if (asked_ >= stopSignals::writeAndEnd)
    {
        Info<< "A signal asks the run to write and to end" << endl;
        runTime_.writeAndEnd();
    }
    else if (asked_ > 0)
    {
        Info<< "A signal asks the run to write" << endl;
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
        warnings_.checkCells(bodies_);
    }
}


bool Foam::solidSystem::writeData(Ostream& os) const
{
    // Bodies set their fields. Pairings are found anew, as in a run that is
    // restarted from here
    solidSystem& self = const_cast<solidSystem&>(*this);
    self.contacts_.askToPairAll();

    // Uniform fields are text even in binary files: 17 digits restore the same
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

    // The run continues as a restarted one would
    for (solidBody& body : self.bodies_)
    {
        body.forgetRates();
    }
    self.choice_.restart();

    OStringStream text;
    text.precision(17);
    text<< "time " << runTime_.value() << ';' << nl
        << "name " << string(runTime_.timeName()) << ';' << nl
        << "lastStep "
        << (
               subCycling_.active()
             ? subCycling_.lastStep()
             : bodies_[0].lastStep()
           )
        << ';' << nl
        << "energiesOn " << (accounts_.on() ? "yes" : "no") << ';' << nl;
    choice_.write(text);
    subCycling_.write(text);
    forAll(bodies_, i)
    {
        text<< bodies_[i].recordName() << nl << '{' << nl;
        subCycling_.write(i, text);
        // Reduce it, since every rank writes
        accounts_.write(i, text);
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
    contacts_.writeRecord(text);
    functionRecords_.write(text);

    const int precision = os.precision(17);
    dictionary(IStringStream(text.str())()).write(os, false);
    os.precision(precision);

    // Detect a full disk before old times are purged
    os.flush();
    return os.good();
}


void Foam::solidSystem::reportCost(OSstream& os) const
{
    // With the precision of the files figures would be hard to read
    const int precision = os.precision(6);

    const scalar nodes = sum(subCycling::countNodes(bodies_));
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
        const scalarField stable(choice_.ofBodies());
        os  << "Stable steps at Co 1, at the end:";
        writeBodyValues(os, bodies_, stable, " s");
        os  << nl;
        subCycling_.report(stable, os);
        os  << nl;
    }

    if (steps_) warnings_.reportLaws(bodies_, os);
    warnings_.reportGain();
    if (relaxation_.valid() && !dry_) relaxation_->report(os);

    if (steps_) contacts_.reportCost(os, stepSeconds_);
    os.precision(precision);
}


// ************************************************************************* //
