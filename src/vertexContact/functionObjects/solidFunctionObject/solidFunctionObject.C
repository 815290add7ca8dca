/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidFunctionObject.H"
#include "dictionaryCheck.H"
#include "wholeSteps.H"
#include "Time.H"
#include "timeControl.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineModelKeywords(solidFunctionObject);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::solidSystem& findSolids
(
    const Foam::Time& runTime,
    const Foam::dictionary& dict
)
{
    using namespace Foam;

    if (!runTime.foundObject<solidSystem>("solidSystem"))
    {
        FatalIOErrorInFunction(dict)
            << "Function object '" << dict.dictName() << "' of type '"
            << dict.get<word>("type")
            << "' works in vertexContactFoam only" << exit(FatalIOError);
    }
    return runTime.lookupObjectRef<solidSystem>("solidSystem");
}

//- Rows of a run by default
constexpr Foam::scalar rowsOfRun = 1000;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::functionObjects::solidFunctionObject::passed() const
{
    const scalar start = runTime_.startTime().value();
    const scalar length = runTime_.endTime().value() - start;
    return
        length > 0
      ? wholeSteps::within(rowsOfRun*(runTime_.value() - start)/length)
      : scalar(0);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::solidFunctionObject::writeFirstRow()
{
    if (!waits_) writeRow();
    written_ = passed();
    writtenStep_ = runTime_.timeIndex();
}


Foam::autoPtr<Foam::OFstream>
Foam::functionObjects::solidFunctionObject::openFile
(
    const fileName& file
) const
{
    autoPtr<OFstream> os;

    if (solids_.dry())
    {
        if (Pstream::master()) os.reset(new OFstream("/dev/null"));
    }
    else if (Pstream::master())
    {
        const fileName dir
        (
            runTime_.globalPath()/"postProcessing"/name()
           /runTime_.timeName(runTime_.startTime().value())
        );
        mkDir(dir);
        if (isFile(dir/file))
        {
            mvBak(dir/file);
        }
        os.reset(new OFstream(dir/file));
        os->precision(16);

        if (!os->good())
        {
            FatalErrorInFunction
                << "Cannot write " << dir/file << exit(FatalError);
        }
    }

    return os;
}


void Foam::functionObjects::solidFunctionObject::writeHeads
(
    Ostream& os,
    const string& owner,
    const std::initializer_list<const char*>& names
)
{
    for (const char* head : names) os << ' ' << owner.c_str() << ':' << head;
}


void Foam::functionObjects::solidFunctionObject::checkKeywords
(
    const dictionary& dict,
    const keywordList& specific
) const
{
    dictionaryCheck::onlyKeywords(dict, commonKeywords() + specific);
    if (!controlled_ && dict.found("writeInterval"))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'writeInterval' needs a 'writeControl'. Without both, "
            << "a row is written every 1/1000 of the run"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::solidFunctionObject::solidFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    functionObject(name),
    runTime_(runTime),
    solids_(findSolids(runTime, dict)),
    controlled_(timeControl::entriesPresent(dict, "write")),
    waits_(dict.getOrDefault<scalar>("timeStart", -GREAT) > runTime.value())
{}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::functionObjects::solidFunctionObject::~solidFunctionObject()
{
    // The bodies may have been destroyed before
    if (runTime_.foundObject<solidSystem>("solidSystem"))
    {
        solids_.records().drop(name());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList
Foam::functionObjects::solidFunctionObject::commonKeywords()
{
    return
    {
        {"type", "", "required", "name of the function object"},
        {"libs", "", "none", "libraries to load; (vertexContact) is loaded"},
        {"functionObjectLibs", "", "none", "older name of libs"},
        {"enabled", "", "yes", "no: the function object does nothing"},
        {"log", "", "yes", "keyword of OpenFOAM, has no effect here"},
        {"timeStart", "s", "start", "before this time it does nothing"},
        {"timeEnd", "s", "end", "after this time it does nothing"},
        {
            "executeControl", "", "timeStep",
            "when it executes; values as for writeControl"
        },
        {
            "executeInterval", "-", "1",
            "interval of executeControl, in steps or s"
        },
        {
            "writeControl", "", "1/1000 of the run",
            "when a row is written; timeStep: every writeInterval steps"
        },
        {"writeInterval", "-", "1", "interval of writeControl, in steps or s"},
        {
            "controlMode", "", "time",
            "keyword of OpenFOAM: timeStart and timeEnd, or triggers"
        },
        {
            "errors", "", "default",
            "keyword of OpenFOAM: what happens on an error"
        },
        {
            "useNamePrefix", "", "no",
            "keyword of OpenFOAM, has no effect here"
        }
    };
}


bool Foam::functionObjects::solidFunctionObject::write()
{
    const scalar now = passed();
    if (!controlled_ && now == written_) return true;
    written_ = now;
    writtenStep_ = runTime_.timeIndex();
    return writeRow();
}


bool Foam::functionObjects::solidFunctionObject::end()
{
    if (!controlled_ && writtenStep_ != runTime_.timeIndex())
    {
        writtenStep_ = runTime_.timeIndex();
        return writeRow();
    }
    return true;
}


// ************************************************************************* //
