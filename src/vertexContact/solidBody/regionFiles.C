/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionFiles.H"
#include "dictionaryCheck.H"
#include "materialModel.H"
#include "IOdictionary.H"
#include "localIOdictionary.H"
#include "pointFields.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"
#include "fileOperation.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

IOobject input
(
    const word& name,
    const fileName& instance,
    const objectRegistry& db
)
{
    return IOobject
    (
        name, instance, db, IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
}


//- Read a file. OpenFOAM does not say which one has a broken expression
dictionary parsed
(
    const IOobject& io,
    const std::function<dictionary(const IOobject&)>& read
)
{
    dictionary dict(io.objectPath());
    dictionaryCheck::withPlace
    (
        dict, "The file cannot be read", [&]() { dict = read(io); }
    );
    return dict;
}


//- Read a dictionary of the region or of the case, empty if there is no file
dictionary readIfThere
(
    const word& name,
    const fileName& instance,
    const objectRegistry& db
)
{
    IOobject io(input(name, instance, db));
    if (dictionaryCheck::isThere<IOdictionary>(io))
    {
        dictionary dict
        (
            parsed(io, [](const IOobject& its) -> dictionary
            {
                return IOdictionary(its);
            })
        );
        dict.remove("FoamFile");
        return dict;
    }
    return dictionary(io.objectPath());
}


//- fvSchemes of the region or of the case. A misspelt dictionary vertexCentred
//  is an error: otherwise it would be ignored silently
dictionary readSchemes(const Time& runTime, const objectRegistry& db)
{
    const word ours("vertexCentred");
    constexpr label letters = 4;
    const dictionary dict(readIfThere("fvSchemes", runTime.system(), db));
    for (const entry& e : dict)
    {
        if
        (
            e.keyword() != ours
         && dictionaryCheck::within
            (
                e.keyword(), wordList(1, ours), letters
            ).size()
        )
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword '" << e.keyword() << "'. Did you mean '"
                << ours << "'?" << exit(FatalIOError);
        }
    }
    return dict;
}


//- Check that each entry of a region's field is for one of its patches, or has
//  a constraint type, which patches have anyway
void checkPatches(const dictionary& field, const polyMesh& mesh)
{
    const wordList names(mesh.boundaryMesh().names());
    for (const entry& e : field.subDict("boundaryField"))
    {
        const keyType& key = e.keyword();
        bool fits =
            e.isDict()
         && polyPatch::constraintType
            (
                e.dict().getOrDefault<word>("type", word())
            );
        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            fits = fits || key.match(pp.name()) || pp.inGroups().found(key);
        }
        if (!fits)
        {
            FatalIOErrorInFunction(field)
                << "Keyword 'boundaryField': '" << key << "' is no patch of "
                << "region '" << mesh.name() << "'."
                << dictionaryCheck::proposal(key, names).c_str() << nl
                << "Its patches: " << dictionaryCheck::listed(names).c_str()
                << exit(FatalIOError);
        }
    }
}


//- The mesh is the single default region, whose files are those of the case
bool isCase(const polyMesh& mesh)
{
    return mesh.name() == polyMesh::defaultRegion;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::regionFiles::sharedKeywords()
{
    return
    {
        {
            "<region>", "", "none",
            "dictionary as in mechanicalProperties; <region> is a name, or a "
            "regular expression for names in quotes"
        }
    };
}


Foam::keywordList Foam::regionFiles::startFields()
{
    return
    {
        {
            "pointU", "m/s", "vector",
            "velocity; its patches have the boundary conditions"
        },
        {
            "pointD", "m", "vector",
            "displacement, and the stress that it causes"
        },
        {
            "F0", "-", "tensor",
            "deformation gradient from the stress-free state to the mesh"
        },
        {
            "CpInv", "-", "symmTensor",
            "inverse plastic right Cauchy-Green tensor, with determinant 1; "
            "only HenckyVonMises"
        },
        {
            "elasticStrain", "-", "symmTensor",
            "logarithmic elastic strain, replaces CpInv and the volume of F0; "
            "only HenckyVonMises"
        },
        {
            "epsilonPEq", "-", "scalar",
            "equivalent plastic strain; only HenckyVonMises"
        },
        {"pointT", "K", "scalar", "temperature; only with adiabaticHeating"},
        {
            "hourglassShare", "-", "scalar",
            "stiffness against hourglass modes, relative to that of the "
            "elastic material; only HenckyVonMises; written by runs"
        },
        {
            "contactSlide", "m", "vector",
            "distance of a sticking point from where it began to stick; "
            "written by runs and mapState"
        }
    };
}


Foam::dictionary Foam::regionFiles::material(const polyMesh& mesh)
{
    const Time& runTime = mesh.time();
    const IOobject own
    (
        input("mechanicalProperties", runTime.constant(), mesh)
    );
    IOobject io(own);
    if (!dictionaryCheck::isThere<IOdictionary>(io))
    {
        const dictionary shared
        (
            readIfThere("solidProperties", runTime.constant(), runTime)
        );
        if (shared.isDict(mesh.name())) return shared.subDict(mesh.name());
        if (shared.size())
        {
            FatalIOErrorInFunction(shared)
                << "No entry is for region '" << mesh.name()
                << "', and the region has no file " << own.objectPath()
                << '.' << nl << "Valid entries: "
                << dictionaryCheck::listed(shared.toc()).c_str()
                << exit(FatalIOError);
        }
    }

    // If there is none, OpenFOAM ends with its own message
    return IOdictionary(own);
}


Foam::dictionary Foam::regionFiles::bodyForces(const polyMesh& mesh)
{
    const Time& runTime = mesh.time();
    IOobject own(input("bodyForces", runTime.constant(), mesh));
    if (dictionaryCheck::isThere<IOdictionary>(own) || isCase(mesh))
    {
        return readIfThere("bodyForces", runTime.constant(), mesh);
    }
    return readIfThere("bodyForces", runTime.constant(), runTime);
}


Foam::dictionary Foam::regionFiles::schemes(const polyMesh& mesh)
{
    // OpenFOAM's tools require a file in each region, usually without our
    // dictionary
    const Time& runTime = mesh.time();
    dictionary own(readSchemes(runTime, mesh));
    if (own.found("vertexCentred") || isCase(mesh)) return own;
    return readSchemes(runTime, runTime);
}


Foam::fileName Foam::regionFiles::velocityFile(const polyMesh& mesh)
{
    IOobject own(input("pointU", mesh.time().timeName(), mesh));
    const fileName shared(sharedField(own.name(), mesh));
    return
        dictionaryCheck::isThere<pointVectorField>(own) || shared.empty()
      ? own.objectPath()
      : shared;
}


Foam::fileName Foam::regionFiles::sharedField
(
    const word& name,
    const polyMesh& mesh
)
{
    // Start fields only: a name such as F may mean anything else. Not the
    // memory of friction, which belongs to one body
    if
    (
        isCase(mesh)
     || name == "contactSlide"
     || !startFields().names().found(name)
    )
    {
        return fileName();
    }

    const Time& runTime = mesh.time();
    const fileName file(runTime.globalPath()/runTime.timeName()/name);
    return fileHandler().isFile(file) ? file : fileName();
}


Foam::wordList Foam::regionFiles::fieldsWithout(const materialModel& law)
{
    wordList names;
    if (!law.plastic())
    {
        names = wordList
        ({
            "CpInv", "elasticStrain", "epsilonPEq", "hourglassShare"
        });
    }
    if (!(law.initialTemperature() > 0)) names.append(word("pointT"));
    return names;
}


void Foam::regionFiles::checkFields
(
    const polyMesh& mesh,
    const materialModel& law
)
{
    const wordList without(fieldsWithout(law));
    for (const keywordList::keyword& field : startFields().all)
    {
        IOobject io(input(field.name, mesh.time().timeName(), mesh));
        if
        (
            without.found(field.name)
         && io.typeHeaderOk<localIOdictionary>(false)
        )
        {
            FatalFileErrorInFunction(io.objectPath())
                << "The field " << field.name << " (" << field.meaning.c_str()
                << ") does not work with type " << law.type()
                << " of region '" << mesh.name() << "'." << nl
                << "Remove the field"
                <<
                (
                    field.deflt == "symmTensor"
                  ? ", or give a stretch by the field F0" : ""
                )
                << exit(FatalIOError);
        }
    }
}


Foam::dictionary Foam::regionFiles::readShared(const fileName& file)
{
    autoPtr<ISstream> is(fileHandler().NewIFstream(file));
    dictionary field(is());
    field.name() = file;
    field.remove("FoamFile");
    return field;
}


Foam::dictionary Foam::regionFiles::velocity(const polyMesh& mesh)
{
    const IOobject own(input("pointU", mesh.time().timeName(), mesh));
    const fileName shared(velocityFile(mesh));
    if (shared == own.objectPath())
    {
        // If there is none, OpenFOAM ends with its own message
        const dictionary field
        (
            parsed(own, [](const IOobject& its) -> dictionary
            {
                return localIOdictionary(its, pointVectorField::typeName);
            })
        );
        checkPatches(field, mesh);
        return field;
    }

    // The shared file has no entries for the boundaries between processors
    dictionary field(readShared(shared));
    dictionary& patches = field.subDict("boundaryField");
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<processorPolyPatch>(pp))
        {
            dictionary type;
            type.add("type", pp.type());
            patches.set(pp.name(), type);
        }
    }
    return field;
}


void Foam::regionFiles::check(const Time& runTime, const wordList& regions)
{
    const dictionary shared
    (
        readIfThere("solidProperties", runTime.constant(), runTime)
    );
    for (const entry& e : shared)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(shared)
                << "Keyword '" << e.keyword()
                << "' is not a dictionary. The material of a region must be one"
                << exit(FatalIOError);
        }
        bool fits = false;
        for (const word& region : regions)
        {
            fits = fits || e.keyword().match(region);
        }
        if (!fits)
        {
            FatalIOErrorInFunction(shared)
                << "Keyword '" << e.keyword() << "' matches no region." << nl
                << "Valid regions: "
                << dictionaryCheck::listed(regions).c_str()
                << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
