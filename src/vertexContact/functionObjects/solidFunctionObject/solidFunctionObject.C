/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidFunctionObject.H"
#include "dictionaryCheck.H"
#include "Time.H"
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

} // End anonymous namespace


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

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


void Foam::functionObjects::solidFunctionObject::checkKeywords
(
    const dictionary& dict,
    const keywordList& specific
) const
{
    dictionaryCheck::onlyKeywords(dict, commonKeywords() + specific);
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
    solids_(findSolids(runTime, dict))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList
Foam::functionObjects::solidFunctionObject::commonKeywords()
{
    return
    {
        {"type", "", "required", "name of the function object"},
        {"libs", "", "none", "libraries; (vertexContact) is loaded already"},
        {"functionObjectLibs", "", "none", "libs, in older releases"},
        {"enabled", "", "yes", "no: leave it out"},
        {"log", "", "yes", "of OpenFOAM, without effect"},
        {"region", "", "the only one", "name of the body"},
        {"timeStart", "s", "start", "nothing is done before"},
        {"timeEnd", "s", "end", "nothing is done afterwards"},
        {"executeControl", "", "timeStep", "when it executes, as writeControl"},
        {"executeInterval", "-", "1", "of executeControl"},
        {"writeControl", "", "timeStep", "when a row is written"},
        {"writeInterval", "-", "1", "of writeControl"},
        {"controlMode", "", "time", "of OpenFOAM's time control"},
        {"errors", "", "default", "of OpenFOAM, what an error does"},
        {"useNamePrefix", "", "no", "of OpenFOAM, without effect"}
    };
}


// ************************************************************************* //
