/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    How a solidSystem is read, and what it reports before the first step.

\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "bodiesOfKind.H"
#include "paperBody.H"
#include "regionFiles.H"
#include "systemChecks.H"
#include "writtenTimes.H"
#include "dictionaryCheck.H"
#include "uniformDimensionedFields.H"
#include "IOdictionary.H"
#include "OStringStream.H"
#include <sstream>
#include <string>
#include <vector>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(solidSystem, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef std::vector<std::string> textLines;

//- What a body says about itself, by lines. Rounded, so that bodies that differ
//  by round-off say the same. Collective
textLines reportOf(const Foam::solidBody& body)
{
    Foam::OStringStream text;
    text.precision(10);
    body.report(text);

    std::istringstream lines(text.str());
    textLines list;
    std::string line;
    while (std::getline(lines, line)) list.push_back(line);
    return list;
}


//- Number of lines that are not the same; all, if one has more lines
std::size_t differences(const textLines& a, const textLines& b)
{
    if (a.size() != b.size()) return a.size();
    std::size_t n = 0;
    for (std::size_t k = 0; k < a.size(); ++k) n += a[k] != b[k];
    return n;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::PtrList<Foam::solidBody> Foam::solidSystem::readBodies() const
{
    const wordList regions(systemChecks::regionNames(runTime_));
    regionFiles::check(runTime_, regions);
    PtrList<solidBody> bodies(regions.size());
    forAll(regions, i)
    {
        bodies.set
        (
            i, solidBody::New(runTime_, regions[i], preset_.scheme).ptr()
        );
    }
    return bodies;
}


void Foam::solidSystem::readGravity()
{
    IOobject gravityIO
    (
        "g", runTime_.constant(), runTime_,
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
        if (bodies_.size())
        {
            dictionaryCheck::warnLeftOut
            (
                gravityIO.objectPath(), "value", g.value(),
                bodies_[0].dual().projected(g.value())
            );
        }
    }
}


Foam::dictionary Foam::solidSystem::readRecord()
{
    systemChecks::processors(runTime_);
    IOobject io(writtenTimes::record(runTime_));
    if (!dictionaryCheck::isThere<IOdictionary>(io)) return dictionary();
    const IOdictionary record(io);
    const scalar exact = record.get<scalar>("time");

    // The record is valid only in the folder into which it was written, not in
    // a copy. Compare names, not times: if a run needs more digits than
    // timePrecision, Time restarts with even more digits, and the exact time
    // gets another name. Records of earlier versions have no name
    const word name(record.getOrDefault("name", runTime_.timeName(exact)));
    if (name != runTime_.timeName()) return dictionary();

    // The folder keeps its name: fields are read from there
    dimensionedScalar& time = runTime_;
    time.value() = exact;
    return record;
}


void Foam::solidSystem::readMotions(const dictionary& record)
{
    const scalar step = record.getOrDefault<scalar>("lastStep", 0);
    forAll(bodies_, i)
    {
        const dictionary its(record.subOrEmptyDict(bodies_[i].recordName()));
        const scalar own = its.getOrDefault<scalar>("lastStep", step);
        bodies_[i].setLastStep(own);
        bodies_[i].readRigid(its.subOrEmptyDict("rigid"));
        bodies_[i].checkStart(runTime_.value() - 0.5*(step - own));
    }
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
    control_(runTime, preset_),
    integrator_
    (
        dictionaryCheck::readEnum
        (
            timeIntegrator::names, runTime.controlDict(), "timeIntegrator",
            preset_.integrator
        )
    ),
    record_(readRecord()),
    bodies_(readBodies()),
    leaping_
    (
        integrator_.leapfrog()
      ? bodiesOfKind<leapfrogBody>(bodies_)
      : UPtrList<leapfrogBody>()
    ),
    staged_
    (
        integrator_.leapfrog()
      ? UPtrList<paperBody>()
      : bodiesOfKind<paperBody>(bodies_)
    ),
    contacts_
    (
        bodies_, leaping_,
        integrator_.leapfrog() ? control_.contactIterations() : 1
    ),
    accounts_(bodies_, leaping_),
    subCycling_
    (
        runTime.controlDict(), control_, bodies_, leaping_, contacts_,
        accounts_
    ),
    choice_
    (
        runTime, control_, integrator_.leapfrog(), bodies_, contacts_,
        subCycling_
    ),
    functionRecords_(record_),
    maxEnergyRise_(control_.maxEnergyRise()),
    warnings_(bodies_.size())
{
    systemChecks::integrator(integrator_, preset_, control_, bodies_);
    systemChecks::rigid(control_, bodies_);
    readSlowLoading(record_);
    // Surfaces are paired with the velocities of the earlier run
    readMotions(record_);
    contacts_.read(runTime);
    // With the leapfrog the speed of waves follows the stretch
    if (!integrator_.leapfrog()) systemChecks::impacts(interfaces());
    readGravity();

    contacts_.readRecord(record_);
    accounts_.read(record_);
    choice_.read(record_);
    subCycling_.read(record_, runTime.controlDict());
    forAll(bodies_, i)
    {
        subCycling_.read(i, record_.subOrEmptyDict(bodies_[i].recordName()));
    }
    if (maxEnergyRise_ > 0) accountEnergies();
    start_ = runTime_.value();

    for (solidBody& body : bodies_)
    {
        body.releaseMeshTables();
    }
    if (integrator_.leapfrog())
    {
        evaluate(start_, 0);
    }

    // Time::run() compares the end with deltaT. Before the first step that is
    // not the solver's own
    const scalar left = runTime_.endTime().value() - start_;
    if (control_.adjusts() && left > 0)
    {
        runTime_.setDeltaT(min(runTime_.deltaTValue(), 0.5*left), false);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidSystem::accountEnergies()
{
    if (accounts_.on()) return;
    accounts_.switchOn();
    if (integrator_.leapfrog()) evaluate(runTime_.value(), 0);
    accounts_.begin();
}


void Foam::solidSystem::accountReactions()
{
    bool on = true;
    for (solidBody& body : bodies_)
    {
        if (body.reactions().valid()) continue;
        body.accountReactions();
        on = false;
    }
    // Reactions need the rates of this instant
    if (!on) evaluate(runTime_.value(), 0);
}


void Foam::solidSystem::reportBodies(Ostream& os) const
{
    std::vector<textLines> all;
    forAll(bodies_, i)
    {
        const textLines lines(reportOf(bodies_[i]));

        // The first of the bodies before this that differ in the fewest lines
        label like = -1;
        std::size_t nNew = lines.size();
        for (label other = 0; other < i && nNew; ++other)
        {
            const std::size_t n = differences(lines, all[other]);
            if (n < nNew)
            {
                nNew = n;
                like = other;
            }
        }

        os  << "Region " << bodies_[i].name();
        if (like != -1)
        {
            os  << (nNew ? ", otherwise as " : ", as ") << bodies_[like].name();
        }
        os  << nl;
        for (std::size_t k = 0; k < lines.size(); ++k)
        {
            if (like == -1 || lines[k] != all[like][k])
            {
                os  << lines[k].c_str() << nl;
            }
        }
        if (nNew || i == bodies_.size() - 1) os << nl;
        all.push_back(lines);
    }
}


void Foam::solidSystem::report(Ostream& os) const
{
    os  << "Preset " << preset::names[preset_.name] << ": timeIntegrator "
        << timeIntegrator::names[integrator_.type()];
    if (control_.adjusts())
    {
        os  << ", maxCo " << control_.maxCo() << nl;
    }
    else
    {
        os  << ", fixed step" << nl;
    }
    if (subCycling_.active())
    {
        os  << "Each region has a time step of its own" << nl;
    }
    massScaling_->report(bodies_, os);
    if (relaxation_.valid())
    {
        os  << "Relaxation: all free nodes are stopped at each peak of the "
            << "kinetic energy" << nl;
    }
    reportBodies(os);
    contacts_.report(os);
    os  << endl;
}


// ************************************************************************* //
