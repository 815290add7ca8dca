/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    mapState

Description
    Gives a case the state of another case of the same bodies at a given time.
    The meshes may differ: for example a finer mesh can start from a preload.

    For each region of both cases it maps the fields that the other case has:
    pointU, with the boundary conditions of this case, pointD, F0, epsilonPEq,
    pointT, and contactSlide, the memory of friction. For a metal that has
    flowed it maps the elastic strain (elasticStrain), from which the solver
    finds CpInv and the volume of F0, if the other case has F, and CpInv is not
    I everywhere. Otherwise it maps CpInv, and scales its determinant back to 1.
    Other records of a run (contactStatus, acceleration, hourglassShare) begin
    anew.

    Values are mapped from points to points (pointMapping) in the reference
    configuration, that of the meshes as they were made. Displacements use their
    gradient F - I if the other case has F; patches that move as one stay so.
    The solver computes momentum and F anew. Regions that only this case has
    begin as they would without mapState.

Usage
    \b mapState <case> [-sourceTime <time>]

    \table
        Argument     | Description                              | Default
        case         | the other case, not decomposed           | required
        -sourceTime  | its time                                 | its last one
    \endtable

    Writes the fields to the time that controlDict starts from. This case may
    be decomposed (-parallel); each rank reads all of the other one.

    Throws FatalIOError if the other case has none of the regions, or no pointU
    at that time; if a mesh has other directions, or only one of both regions is
    rigid, or this one lacks the other's plasticity or heating; if that time is
    incomplete, or processors have later ones; for points far from its mesh; and
    if the start time has results of a run, or a field that the other case
    lacks: states would be mixed.

SourceFiles
    mapState.C
    pointMapping.C

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "localIOdictionary.H"
#include "pointFields.H"
#include "pointMapping.H"
#include "regionFiles.H"
#include "rigidMaterial.H"
#include "systemChecks.H"
#include "dictionaryCheck.H"
#include "elasticStrain.H"
#include "emptyPolyPatch.H"
#include "syncTools.H"
#include "writtenTimes.H"
#include "fileOperation.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- How far CpInv may be from I because it was written with six digits
constexpr scalar roundedStretch = 1e-5;

//- Restore the properties that mapping loses: the determinant of CpInv
template<class Type>
void normalise(const word&, Field<Type>&)
{}

void normalise(const word& name, Field<symmTensor>& values)
{
    if (name != "CpInv") return;
    for (symmTensor& C : values) C /= std::cbrt(det(C));
}


//- While it lives, each rank by itself reads and searches the mesh and the
//  fields of the other case: as uncollated files, whatever this case has
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


//- The latest time in the processors' folders, or -GREAT
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


//- Whether there is a file of that name at the time of a mesh or, in a folder,
//  at that of a case
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


//- The file with a field of the other mesh for all regions, or nothing. F0 must
//  have a file of its own: the meaning of a shared one depends on the region,
//  and a region with its own file must be one that can take F0
fileName sharedFile(const word& name, const polyMesh& mesh)
{
    return name == "F0" ? fileName() : regionFiles::sharedField(name, mesh);
}


//- Error: existing data would be mixed with what is mapped
void refuse(const fileName& file, const char* why)
{
    FatalFileErrorInFunction(file)
        << "This file exists, but " << why << ". The run would start with a "
        << "mixture of two states. Remove the file, or set 'startTime' to a "
        << "time without it"
        << exit(FatalIOError);
}


//- Error: the state of a region of the other case is none of this case
template<class Type>
void refuseState
(
    const fileName& file,
    const word& region,
    const char* what,
    const Type& theirs,
    const Type& ours
)
{
    FatalFileErrorInFunction(file)
        << "Region '" << region << "': " << what << ": " << theirs
        << " in the other case, but " << ours << " in this one, which cannot "
        << "have that state" << exit(FatalIOError);
}


//- Number of points of a mesh, and of those that are outside, over all
//  processors
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


//- Read the values of a point field of the other mesh, from its own file or the
//  case's
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

    // Boundary conditions of the other case are not needed
    const dictionary dict
    (
        own
      ? dictionary(localIOdictionary(io, pointFieldType::typeName))
      : regionFiles::readShared(shared)
    );
    values = Field<Type>("internalField", dict, mesh.nPoints());
    return true;
}


//- Write values at the points of this case. \return the name of the field
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


//- Map a field if the other case has it. \return its name, or nothing
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


//- Whether a region of the other case is of a metal that has flowed, and its
//  elastic strain can be computed
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


//- All points of a patch have the same displacement
bool movesAsOne(const polyPatch& pp, const vectorField& displacement)
{
    scalar most = 0;
    for (const label p : pp.meshPoints())
    {
        most = max
        (
            most, mag(displacement[p] - displacement[pp.meshPoints()[0]])
        );
    }
    return most == 0;
}


//- Remove derivatives of a displacement along patches that move as one
void holdSides
(
    tensorField& gradient,
    const vectorField& displacement,
    const polyMesh& mesh
)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp) || !movesAsOne(pp, displacement)) continue;
        forAll(pp.meshPoints(), k)
        {
            tensor& G = gradient[pp.meshPoints()[k]];
            G = G & sqr(pp.pointNormals()[k]);
        }
    }
}


//- Map the displacement if the other case has it, with its gradient if there is
//  one. \return its name, or nothing
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
            holdSides(gradient, values, source);
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


//- Map the elastic strain of a metal, from F, J and CpInv of the other case.
//  F and J include F0
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
        scalarField J;
        readValues("F", source, F);
        readValues("J", source, J);
        readValues("CpInv", source, strain);
        readValues("F0", source, F0);
        forAll(strain, i)
        {
            strain[i] = elasticStrain::of
            (
                F0.empty() ? F[i] : F[i] & F0[i], strain[i]
            );
            if (J.size())
            {
                strain[i] += symmTensor(std::log(J[i]/det(F[i]))/3*I);
            }
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
        "Gives this case the state of another case with the same bodies; the "
        "meshes may differ"
    );
    argList::noFunctionObjects();
    argList::addArgument("case");
    argList::addOption
    (
        "sourceTime", "time",
        "time of the other case (default: its last time)"
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
            << "Option '-sourceTime' is " << wanted << ": the other case has "
            << "no such time" << exit(FatalIOError);
    }
    sourceTime.setTime(times[timei], timei);
    {
        const alone here;
        const scalar latest = latestOfProcessors(sourcePath);
        if (!args.found("sourceTime") && latest > times[timei].value())
        {
            FatalFileErrorInFunction(sourcePath)
                << "The last time of the other case is "
                << sourceTime.timeName()
                << ", but its processor folders have the later time " << latest
                << ". Use reconstructPar, or select a time by '-sourceTime'"
                << exit(FatalIOError);
        }
        if (writtenTimes::incomplete(sourcePath/sourceTime.timeName()))
        {
            FatalFileErrorInFunction(sourcePath/sourceTime.timeName())
                << "This time is not complete (was the run killed, or the disk "
                << "full?). Select an earlier time by '-sourceTime'"
                << exit(FatalIOError);
        }
    }
    const fileName start(runTime.path()/runTime.timeName());
    if (has("solidSystem", runTime, "uniform"))
    {
        refuse
        (
            start/"uniform"/"solidSystem", "this case has run to this time"
        );
    }

    // Meshes of the regions that both cases have. Check everything before
    // anything is written
    const wordList sourceNames(systemChecks::regionNames(sourceTime));
    const wordList names(systemChecks::regionNames(runTime));
    PtrList<polyMesh> targets(names.size()), sources(names.size());
    PtrList<pointMapping> mappings(names.size());
    List<wordList> without(names.size());
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
        const dictionary material(regionFiles::material(targets[i]));
        const autoPtr<materialModel> law
        (
            rigidMaterial::describedBy(material)
          ? new rigidMaterial(1)
          : materialModel::New(material, jacobianForm::volumetric).ptr()
        );
        without[i] = regionFiles::fieldsWithout(*law);
        word foreign;
        Vector<label> directions;
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
            directions = sources[i].geometricD();
            for (const word& field : without[i])
            {
                if (foreign.empty() && has(field, sources[i])) foreign = field;
            }
        }
        const word type(regionFiles::material(sources[i]).get<word>("type"));
        if (directions != targets[i].geometricD())
        {
            refuseState
            (
                sourceFile, name, "the directions of the mesh (1: solved)",
                directions, targets[i].geometricD()
            );
        }
        if
        (
            type != law->type()
         && (type == rigidMaterial::typeName || isA<rigidMaterial>(*law))
        )
        {
            refuseState(sourceFile, name, "'type'", type, law->type());
        }
        if (foreign.size())
        {
            FatalFileErrorInFunction(sourceFile/foreign)
                << "Region '" << name << "': the other case has this field, of "
                << "type " << type << ", but type " << law->type() << " of "
                << "this case has no such state" << exit(FatalIOError);
        }

        wordList missing({"lm"});
        bool moves = false;
        word instead;
        {
            const alone here;
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
                    !without[i].found(field)
                 && (
                        has(field, sources[i])
                     || sharedFile(field, sources[i]).size()
                    );
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
                << "The other case has no field pointU at this time"
                << exit(FatalIOError);
        }
        for (const word& field : missing)
        {
            if (!has(field, targets[i])) continue;
            refuse
            (
                start/name/field,
                field == "lm" ? "this case has run to this time"
              : "the other case has no such field"
            );
        }
        if (instead.size() && has(instead, targets[i]))
        {
            refuse
            (
                start/name/instead, "elasticStrain is mapped instead of it"
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

        const auto map = [&](auto zero, const word& field, dimensionSet dims)
        {
            if (without[i].found(field)) return word();
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
            Info<< ", " << n.second() << " of them outside its mesh, by up to "
                << furthest << " m";
        }
        Info<< nl;
    }
    if (!nMapped)
    {
        FatalFileErrorInFunction(sourcePath)
            << "The other case has none of the regions "
            << dictionaryCheck::listed(names).c_str() << ". Its regions: "
            << dictionaryCheck::listed(sourceNames).c_str()
            << exit(FatalIOError);
    }
    Info<< nl << "Wrote time " << runTime.timeName() << " from that of "
        << sourceTime.timeName() << nl << nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
