/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "systemChecks.H"
#include "stepControl.H"
#include "stepRatios.H"
#include "dictionaryCheck.H"
#include "fileError.H"
#include "IOdictionary.H"
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Fastest impact, over the wave speed, in which all surfaces stayed apart, as
//  measured (tests/robustness/stability.md)
constexpr Foam::scalar fastImpact = 0.7;

//- Names of the integrators for which a condition holds
template<class Condition>
Foam::string integrators(const Condition& holds)
{
    using namespace Foam;
    wordList valid;
    for (const word& name : timeIntegrator::names.toc())
    {
        if (holds(timeIntegrator(timeIntegrator::names[name])))
        {
            valid.append(name);
        }
    }
    return dictionaryCheck::listed(valid);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::systemChecks::regionNames(const Time& runTime)
{
    IOobject io
    (
        "regionProperties", runTime.constant(), runTime,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (!dictionaryCheck::isThere<IOdictionary>(io))
    {
        const word instance
        (
            runTime.findInstance
            (
                polyMesh::meshSubDir, "points", IOobject::READ_IF_PRESENT
            )
        );
        const fileName points
        (
            runTime.path()/instance/polyMesh::meshSubDir/"points"
        );
        if (!isFile(points) && !Pstream::parRun())
        {
            FatalFileErrorInFunction(io.objectPath())
                << "There is neither this file, which names the regions, nor "
                << "constant/polyMesh, the mesh of a case without regions"
                << exit(FatalIOError);
        }
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
    dictionaryCheck::requireOnce(dict, "regions", names);
    for (const word& name : names)
    {
        const fileName mesh
        (
            runTime.path()/runTime.constant()/name/"polyMesh"
        );
        if (!isDir(mesh) && !Pstream::parRun())
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'regions': region '" << name
                << "' has no mesh: there is no folder " << mesh
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


void Foam::systemChecks::processors(const Time& runTime)
{
    if (!Pstream::parRun()) return;

    const fileName mine
    (
        fileHandler().filePath(runTime.path()/runTime.constant())
    );
    label missing = mine.size() ? labelMax : Pstream::myProcNo();
    reduce(missing, minOp<label>());
    if (missing != labelMax)
    {
        FatalErrorInFunction
            << "There is no " << runTime.constant() << " folder of processor"
            << missing << ", but the run has " << Pstream::nProcs()
            << " ranks." << nl
            << "Decompose the case for this number of ranks: "
            << "decomposePar -allRegions -force" << exit(FatalError);
    }
}


void Foam::systemChecks::integrator
(
    const timeIntegrator& integrator,
    const preset& given,
    const stepControl& control,
    const PtrList<solidBody>& bodies
)
{
    if
    (
        !integrator.leapfrog()
     && integrator.type() != integratorType::TVDRK3
    )
    {
        for (const solidBody& body : bodies)
        {
            // Counts a node once on each rank that shares it: never too few
            const label nodes =
                returnReduce(body.dual().nNodes(), sumOp<label>());
            if (nodes <= std::pow(3, body.dual().nDim()))
            {
                WarningInFunction
                    << "Region '" << body.name() << "' has " << nodes
                    << " nodes. Vibrations in bodies of two cells across are "
                    << "not damped, and grow in long runs with "
                    << timeIntegrator::names[integrator.type()]
                    << " (tests/robustness/stability.md). Use more cells, or "
                    << "'timeIntegrator TVDRK3'." << endl;
            }
        }
    }
    if (stepRatios::wanted(control.dict()) && !integrator.leapfrog())
    {
        FatalIOErrorInFunction(control.dict())
            << "Keyword 'subCycling' is yes, which does not work with preset "
            << preset::names[given.name] << " (timeIntegrator "
            << timeIntegrator::names[integrator.type()]
            << "). Valid integrators for it: (leapfrog)"
            << exit(FatalIOError);
    }
    if (control.contactIterations() > 1 && !integrator.leapfrog())
    {
        WarningInFunction
            << "contactIterations has no effect with preset "
            << preset::names[given.name] << endl;
    }
    for (const solidBody& body : bodies)
    {
        if (body.variational() != integrator.leapfrog())
        {
            FatalIOErrorInFunction(control.dict())
                << "Keyword 'timeIntegrator': "
                << timeIntegrator::names[integrator.type()]
                << " does not work with preset " << preset::names[given.name]
                << ". Valid integrators for it: "
                << integrators([&](const timeIntegrator& its)
                   {
                       return its.leapfrog() == body.variational();
                   }).c_str()
                << exit(FatalIOError);
        }
    }
    if (!integrator.split()) return;

    for (const solidBody& body : bodies)
    {
        if (body.options().reconstruction == reconstructionType::full)
        {
            FatalIOErrorInFunction(control.dict())
                << "Keyword 'timeIntegrator': symplecticEuler needs "
                << "'reconstruction' linear or none, but region '"
                << body.name() << "' has full (fvSchemes). Valid integrators "
                << "for full: "
                << integrators([](const timeIntegrator& its)
                   {
                       return !its.leapfrog() && !its.split();
                   }).c_str()
                << exit(FatalIOError);
        }
    }
}


bool Foam::systemChecks::allRigid(const PtrList<solidBody>& bodies)
{
    bool all = true;
    for (const solidBody& body : bodies) all = all && body.rigid();
    return all;
}


void Foam::systemChecks::rigid
(
    const stepControl& control,
    const PtrList<solidBody>& bodies
)
{
    if (allRigid(bodies) && control.adjusts())
    {
        FatalIOErrorInFunction(control.dict())
            << "Keyword 'adjustTimeStep' is yes, but all regions are rigid: "
            << "there is no stable step. 'adjustTimeStep' must be no, with "
            << "'deltaT'" << exit(FatalIOError);
    }
}


void Foam::systemChecks::contactPatches
(
    const fileName& file,
    const PtrList<solidBody>& bodies,
    const PtrList<contactInterface>& interfaces
)
{
    std::set<std::pair<const solidBody*, label>> named;
    for (const contactInterface& contact : interfaces)
    {
        for (const contactSide& s : contact.sides())
        {
            named.emplace(s.body, s.patchi);
        }
    }
    for (const solidBody& body : bodies)
    {
        for (const label patchi : body.contactPatches())
        {
            if (!named.count({&body, patchi}))
            {
                FatalFileErrorInFunction(file)
                    << "Keyword 'interfaces': no interface has patch '"
                    << body.mesh().boundaryMesh()[patchi].name()
                    << "' of region '" << body.name()
                    << "' as a side, but its 'type' in pointU is "
                    << "'contact'" << exit(FatalIOError);
            }
        }
    }
}


void Foam::systemChecks::sameSides
(
    const dictionary& list,
    const PtrList<contactInterface>& interfaces
)
{
    typedef std::pair<const solidBody*, label> surface;
    std::map<std::tuple<surface, surface, std::string>, word> known;
    for (const contactInterface& contact : interfaces)
    {
        if (contact.many()) continue;
        const List<contactSide> sides(contact.sides());
        const surface a(sides.first().body, sides.first().patchi);
        const surface b(sides.last().body, sides.last().patchi);

        // A side may meet several obstacles, but each of them once
        const bool alone = sides.size() < 2;
        std::string obstacle;
        if (alone)
        {
            const dictionary& dict = list.subDict(contact.dictName());
            const dictionary& shape = dict.subDict("obstacle");
            obstacle =
                shape.digest().str()
              + dict.subOrEmptyDict("motion").digest().str();

            // A mesh without this keyword has the file of the interface's name
            const bool mesh =
                shape.get<word>("type").find("Mesh") != std::string::npos;
            if (mesh && !shape.found("file")) obstacle += contact.name();
        }
        const auto place = known.emplace
        (
            std::make_tuple(std::min(a, b), std::max(a, b), obstacle),
            contact.name()
        );
        if (!place.second)
        {
            FatalIOErrorInFunction(list)
                << "Keyword 'interfaces': '" << place.first->second << "' and '"
                << contact.name() << "' have the same "
                << (alone ? "'side', 'obstacle' and 'motion'" : "'sides'")
                << ", whose contact would count twice" << exit(FatalIOError);
        }
    }
}


void Foam::systemChecks::impacts
(
    const PtrList<contactInterface>& interfaces
)
{
    for (const contactInterface& all : interfaces)
    for (const contactInterface& contact : all.parts())
    {
        const List<contactSide> sides(contact.sides());
        const solidBody& a = *sides.first().body;
        const solidBody& b = *sides.last().body;
        const bool stretches =
            (a.material().stretchesWaves() && !a.options().stretchedWaves)
         || (b.material().stretchesWaves() && !b.options().stretchedWaves);

        // Obstacles are taken to be at rest
        const vector v(a.meanVelocity());
        const scalar speed = mag(sides.size() > 1 ? v - b.meanVelocity() : v);
        const scalar cp = min(a.material().cp(), b.material().cp());
        if (stretches && speed > fastImpact*cp)
        {
            WarningInFunction
                << "Interface '" << contact.name() << "': the bodies approach "
                << "each other at " << speed/cp << " of their wave speed. "
                << "Above " << fastImpact << " surfaces may go through each "
                << "other (tests/robustness/stability.md). Use 'waveSpeed "
                << "stretched' in fvSchemes." << endl;
        }
    }
}


// ************************************************************************* //
