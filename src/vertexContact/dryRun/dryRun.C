/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dryRun.H"
#include "solidSystem.H"
#include "solidFunctionObject.H"
#include "dictionaryCheck.H"
#include "wholeSteps.H"
#include "timeControlFunctionObject.H"
#include <sys/resource.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Time spent on trial steps, unless the run is shorter [s]
constexpr double trialSeconds = 1;

//- Growth of the number of steps, as a share, from which on it is reported
constexpr scalar worthTelling = 0.02;

//- Largest memory that the process has had so far [bytes]
double largestMemory()
{
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    #ifdef __APPLE__
    return double(usage.ru_maxrss);
    #else
    return 1024*double(usage.ru_maxrss);
    #endif
}

//- The function objects of controlDict from this library, and the names of the
//  others: those may write at any time and place
PtrList<functionObject> ownFunctionObjects
(
    const Time& runTime,
    wordList& others
)
{
    PtrList<functionObject> own;
    const dictionary* functions =
        runTime.controlDict().findDict("functions");
    if (!functions || !runTime.functionObjects().status()) return own;

    const auto& known =
        *functionObjects::solidFunctionObject::
        keywordsOfModelMemberFunctionTablePtr_;
    for (const entry& e : *functions)
    {
        if (!e.isDict() || !e.dict().getOrDefault("enabled", true)) continue;
        const dictionary& dict = e.dict();
        const word name(e.keyword());
        if (!known.found(dict.getOrDefault<word>("type", word::null)))
        {
            others.append(name);
        }
        else if (functionObjects::timeControl::entriesPresent(dict))
        {
            own.append(new functionObjects::timeControl(name, runTime, dict));
        }
        else
        {
            own.append(functionObject::New(name, runTime, dict).ptr());
        }
    }
    return own;
}


//- Write a number of steps, with all digits unless these are more than a number
//  has
void writeCount(OSstream& os, const scalar n)
{
    if (n < 1/SMALL) os << std::int64_t(n);
    else os << n;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::dryRun(solidSystem& solids, Time& runTime, OSstream& os)
{
    solids.setDry();
    const scalar readingSeconds = solids.secondsSinceStart();
    const scalar startOfRun = runTime.value();

    // With the precision of the files figures would be hard to read
    const int precision = os.precision(4);

    wordList others;
    PtrList<functionObject> functions(ownFunctionObjects(runTime, others));

    const scalar end = runTime.endTime().value();
    const auto goesOn = [&]()
    {
        return runTime.value() < end - 0.5*runTime.deltaTValue();
    };
    const auto endStep = [&]()
    {
        ++runTime;
        solids.finishStep();
        for (functionObject& f : functions)
        {
            f.execute();
            f.write();
        }
    };

    os  << "Dry run: nothing is written" << nl << nl;
    if (!goesOn())
    {
        os  << "Steps: none, because the time is " << runTime.value()
            << " s and endTime is " << end << " s" << nl << endl;
        os.precision(precision);
        return;
    }

    // The first step is not timed, since it is the first to touch much of the
    // memory
    solids.startStep();
    const scalar deltaT = runTime.deltaTValue();
    const scalar stable = solids.timeStepLimit();
    const scalar steps = solids.control().stepsToEnd(deltaT);
    const bool adjusts = solids.control().adjusts();
    endStep();

    // Ranks have to agree on the end. Between two looks at the clock at most
    // double the number of steps
    const clockTime trial;
    double seconds = 0;
    label tried = 0;
    while (seconds < trialSeconds && goesOn())
    {
        const label several =
            tried ? min(tried, label(trialSeconds*tried/seconds) - tried + 1)
          : label(1);
        for (label i = 0; i < several && goesOn(); ++i, ++tried)
        {
            solids.startStep();
            endStep();
        }
        seconds = returnReduce(trial.elapsedTime(), maxOp<double>());
    }

    scalar nodes = 0, bytes = 0;
    for (const solidBody& body : solids.bodies())
    {
        nodes += body.dual().nNodes();
        bytes += body.bytes();
    }
    reduce(nodes, sumOp<scalar>());
    reduce(bytes, sumOp<scalar>());
    const scalar resident = returnReduce(largestMemory(), sumOp<scalar>());
    constexpr scalar MB = 1e6;

    os  << "Memory: " << bytes/MB << " MB in " << std::int64_t(nodes)
        << " nodes, " << std::int64_t(bytes/nodes + 0.5)
        << " bytes per node; " << resident/MB << " MB at most for "
        << (Pstream::parRun() ? "all processes" : "the process") << nl
        << "Step: " << deltaT << " s at the start, stable step is " << stable
        << " s (at Co 1)" << nl
        << "Steps: ";
    writeCount(os, steps);
    os  << " to time " << end << " s with this step" << nl;

    if (solids.bodies().size() > 1) solids.reportSteps(os);

    if (tried)
    {
        const scalar perStep = seconds/tried;
        os  << "Trial: " << tried << " steps to time " << runTime.value()
            << " s in " << seconds << " s, " << 1e6*perStep << " us a step"
            << nl
            << "Run time: about " << readingSeconds + steps*perStep
            << " s, of which " << readingSeconds << " s to read" << nl;

        // If the number of steps per time grows linearly, as in the trial
        const scalar more =
            0.5*(stable/solids.timeStepLimit() - 1)*(end - startOfRun)
           /(runTime.value() - startOfRun);
        if (adjusts && more > worthTelling)
        {
            os  << "    " << readingSeconds + steps*(1 + more)*perStep
                << " s if the stable step goes on falling as in the trial: by "
                << 100*(1 - solids.timeStepLimit()/stable)
                << " %" << nl;
        }
        os  << "    not included: the time to write";
        if (solids.control().fittedInterval() < GREAT)
        {
            os  << ' ';
            writeCount
            (
                os,
                wholeSteps::within
                (
                    (end - startOfRun)/solids.control().fittedInterval()
                )
            );
            os  << " times";
        }
        os  << ", and later costs of contact and plastic flow" << nl;
    }
    else
    {
        os  << "Run time: " << readingSeconds << " s to read, and one step"
            << nl;
    }
    if (others.size())
    {
        os  << "Not used in the trial: function objects "
            << dictionaryCheck::listed(others).c_str() << nl;
    }
    os  << endl;
    os.precision(precision);
}


// ************************************************************************* //
