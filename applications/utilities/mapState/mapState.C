/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    mapState

Description
    Gives a case the state that another case of the same bodies has at a time,
    on any mesh of theirs: as one with more cells, to begin under a preload.

    Of each region that both cases have, as far as the other has them: pointU,
    with the boundary conditions of this case, pointD, F0, epsilonPEq, pointT,
    and contactSlide, which is what friction remembers. Of a metal that has
    flowed the elastic strain (elasticStrain), to which the solver makes CpInv:
    where the other case has F, for both, and CpInv is not I everywhere; else
    its CpInv, with determinant 1 again. What else a run keeps (contactStatus,
    acceleration, hourglassShare) begins anew.

    They go from point to point (pointMapping) in the reference configuration,
    that of the meshes as they were made, displacements with their gradient F -
    I where the other case has it: patches that move as one stay so. The solver
    makes momentum and F anew. Regions that only this case has begin as they
    would.

Usage
    \b mapState <case> [-sourceTime <time>]

    \table
        Argument     | Description                              | Default
        case         | the other case, not decomposed           | required
        -sourceTime  | its time                                 | its last one
    \endtable

    Writes the fields to the time that controlDict starts from. This case may
    be decomposed (-parallel); each rank reads all of the other one.

    Throws FatalIOError if the other case has none of the regions or no pointU
    at that time, if that time is not complete or processors have later ones,
    for points that are not near its mesh, and if the start time has what a run
    wrote, or a field that the other case has not: states would be mixed.

SourceFiles
    mapState.C
    displacementFilter.C
    pointMapping.C

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "localIOdictionary.H"
#include "pointFields.H"
#include "pointMapping.H"
#include "regionFiles.H"
#include "systemChecks.H"
#include "dictionaryCheck.H"
#include "displacementFilter.H"
#include "elasticStrain.H"
#include "syncTools.H"
#include "writtenTimes.H"
#include "fileOperation.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of CpInv, by how much it may be off I with six digits
constexpr scalar roundedStretch = 1e-5;

//- What a field has to keep of its own: of CpInv the determinant
template<class Type>
void normalise(const word&, Field<Type>&)
{}

void normalise(const word& name, Field<symmTensor>& values)
{
    if (name != "CpInv") return;
    for (symmTensor& C : values) C /= std::cbrt(det(C));
}


//- Each rank by itself reads the mesh and the fields of the other case, and
//  searches them: as files of their own, whatever those of this case are
class alone
{
    const bool together_;

    decltype(fileOperation::fileHandlerPtr_) ours_;

public:

    alone()
    :
        together_(UPstream::parRun()),
        ours_(std::move(fileOperation::fileHandlerPtr_))
    {
        UPstream::parRun() = false;
        fileOperation::fileHandlerPtr_.reset
        (
            fileOperation::New("uncollated", false).ptr()
        );
    }

    ~alone()
    {
        fileOperation::fileHandlerPtr_ = std::move(ours_);
        UPstream::parRun() = together_;
    }
};


//- The latest time of the folders of processors, or -GREAT
scalar latestOfProcessors(const fileName& path)
{
    scalar latest = -GREAT;
    for (const fileName& folder : readDir(path, fileName::DIRECTORY))
    {
        if (folder.find("processor") != 0) continue;
        for (const instant& t : Time::findTimes(path/folder))
        {
            if (t.name() != "constant") latest = max(latest, t.value());
        }
    }
    return latest;
}


//- There is a file of that name at the time of a mesh, or in a folder at that
//  of a case
bool has
(
    const word& name,
    const objectRegistry& db,
    const fileName& folder = fileName()
)
{
    IOobject io
    (
        name, db.time().timeName(), folder, db,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    return io.typeHeaderOk<localIOdictionary>(false);
}


//- The file of all regions with a field of the other mesh, or nothing. Of F0
//  only its own: what that of a case is for depends on the region, and a region
//  with a file must be one that can take it
fileName sharedFile(const word& name, const polyMesh& mesh)
{
    return name == "F0" ? fileName() : regionFiles::sharedField(name, mesh);
}


//- End where what is there would be mixed with what is mapped
void refuse(const fileName& file, const char* why)
{
    FatalFileErrorInFunction(file)
        << "The file is there, but " << why << ": it would begin with two "
        << "states mixed. Remove it, or set 'startTime' to a time without"
        << exit(FatalIOError);
}


//- How many points of a mesh there are, and how many of them are outside, over
//  all processors
labelPair counts(const polyMesh& mesh, const boolList& outside)
{
    const bitSet masters(syncTools::getMasterPoints(mesh));
    labelPair n(0, 0);
    for (const label i : masters)
    {
        ++n.first();
        if (outside[i]) ++n.second();
    }
    return labelPair
    (
        returnReduce(n.first(), sumOp<label>()),
        returnReduce(n.second(), sumOp<label>())
    );
}


//- The values of a point field of the other mesh, in its own file or in that of
//  the case
template<class Type>
bool readValues(const word& name, const polyMesh& mesh, Field<Type>& values)
{
    typedef GeometricField<Type, pointPatchField, pointMesh> pointFieldType;

    IOobject io
    (
        name, mesh.time().timeName(), mesh,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    const bool own = dictionaryCheck::isThere<pointFieldType>(io);
    const fileName shared(sharedFile(name, mesh));
    if (!own && shared.empty()) return false;

    // Boundary conditions of the other case are no matter of ours
    const dictionary dict
    (
        own
      ? dictionary(localIOdictionary(io, pointFieldType::typeName))
      : regionFiles::readShared(shared)
    );
    values = Field<Type>("internalField", dict, mesh.nPoints());
    return true;
}


//- Write values at the points of this case. \return the name
template<class Type>
word writeValues
(
    const word& name,
    const dimensionSet& dims,
    const polyMesh& target,
    const Field<Type>& values
)
{
    GeometricField<Type, pointPatchField, pointMesh> field
    (
        IOobject
        (
            name, target.time().timeName(), target,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        pointMesh::New(target),
        dimensioned<Type>(name, dims, Zero)
    );
    field.primitiveFieldRef() = values;
    normalise(name, field.primitiveFieldRef());
    field.write();
    return name;
}


//- Map a field, if the other case has it. \return its name, or nothing
template<class Type>
word mapField
(
    const word& name,
    const dimensionSet& dims,
    const pointMapping& mapping,
    const polyMesh& source,
    const polyMesh& target
)
{
    Field<Type> values;
    {
        const alone here;
        if (!readValues(name, source, values)) return word();
    }
    return writeValues(name, dims, target, mapping.map(values));
}


//- Whether a region of the other case is of metal that has flowed, and its
//  elastic strain can be had
bool hasElasticStrain(const polyMesh& source)
{
    symmTensorField CpInv;
    if (!has("F", source) || !has("CpInv", source)) return false;
    readValues("CpInv", source, CpInv);
    scalar flown = 0;
    for (const symmTensor& C : CpInv)
    {
        flown = max(flown, mag(C - symmTensor(symmTensor::I)));
    }
    return flown > roundedStretch;
}


//- The displacement, if the other case has it: with its gradient, if that is
//  there. \return its name, or nothing
word mapDisplacement
(
    const pointMapping& mapping,
    const polyMesh& source,
    const polyMesh& target
)
{
    vectorField values;
    tensorField gradient;
    {
        const alone here;
        if (!readValues("pointD", source, values)) return word();
        readValues("F", source, gradient);
        gradient -= tensor(tensor::I);
        if (gradient.size())
        {
            displacementFilter::holdSides(gradient, values, source);
        }
        if (hasElasticStrain(source))
        {
            displacementFilter::smooth(values, gradient, source);
        }
    }
    return writeValues
    (
        "pointD", dimLength, target,
        gradient.empty()
      ? mapping.map(values)
      : mapping.map(values, gradient, source.points(), target.points())
    );
}


//- The elastic strain of a metal, from F and CpInv of the other case
word mapElasticStrain
(
    const pointMapping& mapping,
    const polyMesh& source,
    const polyMesh& target
)
{
    symmTensorField strain;
    {
        const alone here;
        tensorField F, F0;
        readValues("F", source, F);
        readValues("CpInv", source, strain);
        readValues("F0", source, F0);
        forAll(strain, i)
        {
            strain[i] = elasticStrain::of
            (
                F0.empty() ? F[i] : F[i] & F0[i], strain[i]
            );
        }
    }
    return writeValues
    (
        "elasticStrain", dimless, target, mapping.map(strain)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Gives the case the state of another case of the same bodies, on any "
        "mesh"
    );
    argList::noFunctionObjects();
    argList::addArgument("case");
    argList::addOption
    (
        "sourceTime", "time", "time of the other case, the last one by default"
    );

    #include "setRootCase.H"
    #include "createTime.H"

    fileName sourcePath(args[1]);
    sourcePath.toAbsolute();
    sourcePath.clean();
    Time sourceTime
    (
        Time::controlDictName, sourcePath.path(), fileName(sourcePath.name()),
        word("system"), word("constant"), false
    );
    const instantList times(sourceTime.times());
    scalar wanted = times.last().value();
    args.readIfPresent("sourceTime", wanted);
    const label timei = Time::findClosestTimeIndex(times, wanted);
    if
    (
        timei < 0
     || mag(times[timei].value() - wanted) > 1e-9*max(scalar(1), mag(wanted))
    )
    {
        FatalFileErrorInFunction(sourcePath)
            << "Option '-sourceTime' is " << wanted << ": the case has no such "
            << "time" << exit(FatalIOError);
    }
    sourceTime.setTime(times[timei], timei);
    {
        const alone here;
        const scalar latest = latestOfProcessors(sourcePath);
        if (!args.found("sourceTime") && latest > times[timei].value())
        {
            FatalFileErrorInFunction(sourcePath)
                << "The last time is " << sourceTime.timeName()
                << ", but processors have the later time " << latest
                << ". Use reconstructPar, or '-sourceTime'"
                << exit(FatalIOError);
        }
        if (writtenTimes::incomplete(sourcePath/sourceTime.timeName()))
        {
            FatalFileErrorInFunction(sourcePath/sourceTime.timeName())
                << "The time is not complete (was the run killed, or the disk "
                << "full?). Use '-sourceTime' for an earlier one"
                << exit(FatalIOError);
        }
    }
    const fileName start(runTime.path()/runTime.timeName());
    if (has("solidSystem", runTime, "uniform"))
    {
        refuse(start/"uniform"/"solidSystem", "this case has run to here");
    }

    // The meshes of the regions that both have. All is looked at before
    // anything is written
    const wordList sourceNames(systemChecks::regionNames(sourceTime));
    const wordList names(systemChecks::regionNames(runTime));
    PtrList<polyMesh> targets(names.size()), sources(names.size());
    PtrList<pointMapping> mappings(names.size());
    label nMapped = 0;
    forAll(names, i)
    {
        const word& name = names[i];
        if (!sourceNames.found(name))
        {
            Info<< "Region " << name << ": not in the other case" << nl;
            continue;
        }
        ++nMapped;
        targets.set
        (
            i,
            new polyMesh
            (
                IOobject
                (
                    name, runTime.timeName(), runTime, IOobject::MUST_READ
                )
            )
        );
        const fileName sourceFile
        (
            sourceTime.path()/sourceTime.timeName()/name
        );
        wordList missing({"lm"});
        bool moves = false;
        word instead;
        {
            const alone here;
            sources.set
            (
                i,
                new polyMesh
                (
                    IOobject
                    (
                        name, sourceTime.timeName(), sourceTime,
                        IOobject::MUST_READ
                    )
                )
            );
            mappings.set
            (
                i,
                new pointMapping
                (
                    targets[i].points(), sources[i], sourceFile/"pointU"
                )
            );
            const auto theirs = [&](const word& field)
            {
                return
                    has(field, sources[i])
                 || sharedFile(field, sources[i]).size();
            };
            moves = theirs("pointU");
            const bool strained = hasElasticStrain(sources[i]);
            if (strained) instead = "CpInv";
            for
            (
                const word field :
                {
                    "pointD", "F0", "CpInv", "elasticStrain", "epsilonPEq",
                    "pointT", "contactSlide"
                }
            )
            {
                if (!(theirs(field) || (strained && field == "elasticStrain")))
                {
                    missing.append(field);
                }
            }
        }
        if (!moves)
        {
            FatalFileErrorInFunction(sourceFile)
                << "There is no pointU" << exit(FatalIOError);
        }
        for (const word& field : missing)
        {
            if (!has(field, targets[i])) continue;
            refuse
            (
                start/name/field,
                field == "lm" ? "this case has run to here"
              : "the other case has none"
            );
        }
        if (instead.size() && has(instead, targets[i]))
        {
            refuse
            (
                start/name/instead, "elasticStrain is mapped in place of it"
            );
        }
    }
    forAll(names, i)
    {
        if (!sources.set(i)) continue;
        const word& name = names[i];
        const polyMesh& target = targets[i];
        const polyMesh& source = sources[i];
        const pointMapping& mapping = mappings[i];
        vectorField velocity;
        bool strained = false;
        {
            const alone here;
            readValues("pointU", source, velocity);
            strained = hasElasticStrain(source);
        }
        pointVectorField pointU
        (
            IOobject
            (
                "pointU", runTime.timeName(), target,
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            pointMesh::New(target),
            regionFiles::velocity(target)
        );
        pointU.primitiveFieldRef() = mapping.map(velocity);
        pointU.write();

        const auto map = [&](auto zero, const char* field, dimensionSet dims)
        {
            return mapField<decltype(zero)>
            (
                field, dims, mapping, source, target
            );
        };
        DynamicList<word> done({word("pointU")});
        for
        (
            const word& field :
            {
                mapDisplacement(mapping, source, target),
                map(tensor(Zero), "F0", dimless),
                strained
              ? mapElasticStrain(mapping, source, target)
              : map(symmTensor(Zero), "CpInv", dimless),
                strained
              ? word()
              : map(symmTensor(Zero), "elasticStrain", dimless),
                map(scalar(0), "epsilonPEq", dimless),
                map(scalar(0), "pointT", dimTemperature),
                map(vector(Zero), "contactSlide", dimLength)
            }
        )
        {
            if (field.size()) done.append(field);
        }
        const labelPair n(counts(target, mapping.outside()));
        const scalar furthest =
            returnReduce(mapping.furthest(), maxOp<scalar>());
        Info<< "Region " << name << ": "
            << dictionaryCheck::listed(done).c_str() << " from "
            << source.nPoints() << " to " << n.first() << " points";
        if (n.second())
        {
            Info<< ", " << n.second() << " of them outside, by up to "
                << furthest << " m";
        }
        Info<< nl;
    }
    if (!nMapped)
    {
        FatalFileErrorInFunction(sourcePath)
            << "The case has none of the regions "
            << dictionaryCheck::listed(names).c_str() << ". It has "
            << dictionaryCheck::listed(sourceNames).c_str()
            << exit(FatalIOError);
    }
    Info<< nl << "Wrote time " << runTime.timeName() << " from that of "
        << sourceTime.timeName() << nl << nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
