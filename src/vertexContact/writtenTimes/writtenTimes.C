/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writtenTimes.H"
#include "dictionaryCheck.H"
#include "argList.H"
#include "IFstream.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Call setAside for the latest times that are not complete in the folders of
//  all processors, on each processor.
//  \return the latest complete time, on the master; empty if nothing was set
//      aside
template<class SetAside>
word forIncomplete(const argList& args, const SetAside& setAside)
{
    // If processors share one folder a processor has no times of its own
    const word type(fileHandler().type());
    if (type != "uncollated" && type != "masterUncollated") return word();

    {
        IFstream is(args.rootPath()/args.globalCaseName()/"system/controlDict");
        if
        (
            !is.good()
         || dictionary(is).getOrDefault<word>("startFrom", "latestTime")
         != "latestTime"
        )
        {
            return word();
        }
    }

    const fileName path(args.path());
    instantList times(fileHandler().findTimes(path, "constant"));
    wordList complete, all;
    forAll(times, i)
    {
        if (times[i].name() != "constant")
        {
            if (all.empty() || !writtenTimes::incomplete(path/times[i].name()))
            {
                complete.append(times[i].name());
            }
            all.append(times[i].name());
        }
    }

    // A time is complete if it is on every processor that has times
    List<wordList> ofRank(Pstream::nProcs());
    ofRank[Pstream::myProcNo()] = complete;
    Pstream::gatherList(ofRank);
    Pstream::scatterList(ofRank);
    const auto everywhere = [&](const word& time)
    {
        for (const wordList& names : ofRank)
        {
            if (names.size() && !names.found(time)) return false;
        }
        return true;
    };

    bool any = false;
    label latest = all.size() - 1;
    while (latest > 0 && !everywhere(all[latest]))
    {
        setAside(path/all[latest]);
        any = true;
        --latest;
    }
    reduce(any, orOp<bool>());

    wordList latestOf(Pstream::nProcs());
    if (any && latest >= 0)
    {
        latestOf[Pstream::myProcNo()] = all[latest];
    }
    Pstream::gatherList(latestOf);
    Pstream::scatterList(latestOf);
    return latestOf[Pstream::masterNo()];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::writtenTimes::record(const Time& runTime)
{
    const auto in = [&](const fileName& instance, const fileName& local)
    {
        return IOobject
        (
            "solidSystem", instance, local, runTime, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        );
    };
    IOobject its(in(runTime.timeName(), "uniform"));
    if (!runTime.processorCase() || dictionaryCheck::isThere<IOdictionary>(its))
    {
        return its;
    }
    return in(runTime.globalPath()/runTime.timeName()/"uniform", "");
}


bool Foam::writtenTimes::ends(const fileName& file)
{
    static const std::string divider("************************* //");
    constexpr std::streamoff enough = 100;

    IFstream is(file);
    if (!is.good()) return false;
    std::istream& in = is.stdStream();
    std::string tail;
    if (!isFile(file, false))
    {
        // A compressed file is read from its start
        char block[4096];
        while (in.read(block, sizeof(block)) || in.gcount() > 0)
        {
            tail.append(block, in.gcount());
            if (tail.size() > enough) tail.erase(0, tail.size() - enough);
        }
    }
    else
    {
        in.seekg(0, std::ios::end);
        const std::streamoff size = in.tellg();
        in.seekg(size > enough ? size - enough : std::streamoff(0));
        char block[enough];
        in.read(block, enough);
        tail.assign(block, in.gcount());
    }
    const auto last = tail.find_last_not_of(" \n");
    return
        last != std::string::npos
     && last + 1 >= divider.size()
     && tail.compare(last + 1 - divider.size(), divider.size(), divider) == 0;
}


bool Foam::writtenTimes::incomplete(const fileName& time)
{
    const fileName record(time/"uniform"/"solidSystem");
    if (isFile(record)) return !ends(record);
    for (const fileName& folder : readDir(time, fileName::DIRECTORY))
    {
        if (folder != "uniform") return false;
    }
    return readDir(time, fileName::FILE).empty();
}


void Foam::writtenTimes::check(const regIOobject& object)
{
    const fileName file(object.objectPath());
    if (fileHandler().type() == "uncollated" && !ends(file))
    {
        FatalErrorInFunction
            << "File " << file << " could not be written completely: is the "
            << "disk full, or the folder write-protected?" << nl
            << "Times before " << object.time().timeName()
            << " are complete. If you start the run again, it continues from "
            << "the latest of them." << exit(FatalError);
    }
}


void Foam::writtenTimes::setAsideIncomplete(const argList& args)
{
    forIncomplete(args, [](const fileName& time)
    {
        if (!mvBak(time, "incomplete"))
        {
            FatalErrorInFunction
                << "Time " << time << " is not complete (was the run killed, "
                << "or the disk full?) and cannot be renamed. Remove it, to "
                << "continue from an earlier one." << exit(FatalError);
        }
        WarningInFunction
            << "Time " << time.name() << " is not complete (was the run "
            << "killed, or the disk full?): it was renamed to " << time.name()
            << ".incomplete, to continue from the latest complete one" << endl;
    });
}


Foam::word Foam::writtenTimes::latestComplete(const argList& args)
{
    return forIncomplete(args, [](const fileName& time)
    {
        WarningInFunction
            << "Time " << time.name() << " is not complete (was the run "
            << "killed, or the disk full?): a run would rename it to "
            << time.name() << ".incomplete, to continue from the latest "
            << "complete one" << endl;
    });
}


// ************************************************************************* //
