/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "modelLists.H"
#include "argList.H"
#include "IFstream.H"
#include "dlLibraryTable.H"
#include "dictionaryCheck.H"
#include "preset.H"
#include "bodyForce.H"
#include "contactLaw.H"
#include "contactPairing.H"
#include "generalInterface.H"
#include "obstacleInterface.H"
#include "obstacleMotion.H"
#include "solidBoundaryCondition.H"
#include "solidFunctionObject.H"
#include "controlKeywords.H"
#include "regionFiles.H"
#include "stepRatios.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

void writeHeading(Ostream& os, const char* what)
{
    os  << what << nl << nl;
}

void writeKeywords(Ostream& os, const char* of, const keywordList& keywords)
{
    os  << of << nl;
    keywords.write(os);
    os  << nl;
}

//- Names, and below each its own keywords
template<class Table>
void writeModels(Ostream& os, const wordList& names, const Table& keywordsOf)
{
    for (const word& name : names)
    {
        os  << name << nl;
        if (keywordsOf.found(name))
        {
            keywordsOf[name]().write(os);
        }
        else
        {
            os  << "    (its keywords are not described)" << nl;
        }
    }
    os  << nl;
}

//- Models of a base class that has the usual tables
template<class Base>
void writeModels(Ostream& os)
{
    writeModels
    (
        os,
        Base::dictionaryConstructorTablePtr_->sortedToc(),
        *Base::keywordsOfModelMemberFunctionTablePtr_
    );
}


void listMaterials(Ostream& os)
{
    writeHeading
    (
        os, "Materials: 'type' in constant/<region>/mechanicalProperties"
    );
    writeKeywords
    (
        os, "all but rigid, with one of (E nu), (mu lambda), (mu kappa)",
        materialModel::commonKeywords()
    );
    writeModels<materialModel>(os);
    writeKeywords
    (
        os, "constant/solidProperties, for regions without a file of their own",
        regionFiles::sharedKeywords()
    );
}


void listStartFields(Ostream& os)
{
    writeHeading
    (
        os,
        "Start fields: point fields in <time>/<region>, or with one value in "
        "<time>, and their types; pointU is required"
    );
    regionFiles::startFields().write(os);
    os  << nl;
}


void listContactLaws(Ostream& os)
{
    writeHeading
    (
        os,
        "Contact laws: dictionary 'law' of an interface in "
        "constant/contactProperties"
    );
    writeKeywords(os, "all", contactLaw::commonKeywords());
    writeModels<contactLaw>(os);
}


void listPairings(Ostream& os)
{
    writeHeading
    (
        os,
        "Pairings: 'pairing' of an interface in constant/contactProperties"
    );
    writeKeywords(os, "all", contactPairing::commonKeywords());
    writeModels<contactPairing>(os);
    writeKeywords
    (
        os, "an interface of many surfaces instead",
        generalInterface::keywords()
    );
    writeKeywords
    (
        os, "an interface with an obstacle instead",
        obstacleInterface::keywords()
    );
    writeKeywords
    (
        os, "'motion' of an obstacle, and of a rigid region",
        obstacleMotion::keywords()
    );
    os  << "'type' of an obstacle (searchableSurface of OpenFOAM)" << nl
        << "    "
        << dictionaryCheck::listed
           (
               searchableSurface::dictConstructorTablePtr_->sortedToc()
           ).c_str()
        << nl << nl
        << "'solidBodyMotionFunction' of a motion (of OpenFOAM)" << nl
        << "    "
        << dictionaryCheck::listed
           (
               solidBodyMotionFunction::dictionaryConstructorTablePtr_
             ->sortedToc()
           ).c_str()
        << nl << nl;
}


void listBoundaryConditions(Ostream& os)
{
    writeHeading
    (
        os, "Boundary conditions: 'type' of a patch in 0/<region>/pointU"
    );
    writeKeywords(os, "all", solidBoundaryCondition::commonKeywords());
    const auto& keywordsOf =
        *solidBoundaryCondition::keywordsOfModelMemberFunctionTablePtr_;
    writeModels(os, keywordsOf.sortedToc(), keywordsOf);
    os  << "of OpenFOAM, as mirrors or for directions that are left out" << nl
        << "    "
        << dictionaryCheck::listed
           (
               solidBoundaryCondition::mirrorNames()
           ).c_str()
        << nl << nl;
}


void listBodyForces(Ostream& os)
{
    writeHeading
    (
        os,
        "Body forces: 'type' of each dictionary in "
        "constant/<region>/bodyForces"
    );
    writeModels<bodyForce>(os);
}


void listSchemes(Ostream& os)
{
    writeHeading
    (
        os,
        "Schemes: dictionary 'vertexCentred' in system/<region>/fvSchemes, "
        "defaults of preset balanced and, for the paper's scheme, of paper"
    );
    const schemeOptions variational(preset(preset::kind::balanced).scheme);
    writeKeywords(os, "all", variational.commonKeywords());
    writeKeywords
    (
        os, "variational scheme", variational.variationalKeywords()
    );
    writeKeywords
    (
        os, "preset paper", preset(preset::kind::paper).scheme.paperKeywords()
    );
    os  << nl;
}


void listPresets(Ostream& os)
{
    writeHeading
    (
        os,
        "Presets: 'preset' in system/controlDict; the default is balanced"
    );

    // A row for each option of any, a column for each preset
    const wordList names(preset::names.toc());
    List<keywordList> values(names.size());
    List<stringList> rows(1, stringList(names.size() + 1));
    forAll(names, i)
    {
        const preset p(preset::names[names[i]]);
        values[i] = p.keywords() + p.scheme.keywords();
        rows[0][i + 1] = names[i];
        for (const keywordList::keyword& option : values[i].all)
        {
            label row = 1;
            while (row < rows.size() && rows[row][0] != option.name) ++row;
            if (row == rows.size())
            {
                rows.append(stringList(names.size() + 1, "-"));
                rows[row][0] = option.name;
            }
            rows[row][i + 1] = option.deflt;
        }
    }
    keywordList::writeColumns(os, rows);
    os  << nl;
}


void listControls(Ostream& os)
{
    writeHeading
    (
        os,
        "Controls: keywords of vertexContact in system/controlDict, defaults "
        "of preset balanced; <region> is a name, or a regular expression of "
        "names in quotes"
    );
    controlKeywords::keywords().write(os);
    os  << nl;
}


void listIntegrators(Ostream& os)
{
    writeHeading
    (
        os,
        "Time integrators: 'timeIntegrator' in system/controlDict"
    );
    for (const word& name : timeIntegrator::names.toc())
    {
        const timeIntegrator integrator(timeIntegrator::names[name]);
        os  << name << nl << "    fluxes are evaluated "
            << integrator.nStages()
            << (integrator.nStages() > 1 ? " times" : " time") << " a step"
            << (
                   integrator.leapfrog() ? "; for the variational scheme"
               : integrator.split()
               ? "; for preset paper with reconstruction linear and none"
               : "; for preset paper"
               )
            << nl;
    }
    os  << nl;
    writeKeywords(os, "leapfrog", stepRatios::keywords());
}


void listFunctionObjects(Ostream& os)
{
    writeHeading
    (
        os,
        "Function objects of vertexContact: 'type' in 'functions' in "
        "system/controlDict"
    );
    typedef functionObjects::solidFunctionObject base;
    writeKeywords(os, "all", base::commonKeywords());
    const auto& keywordsOf = *base::keywordsOfModelMemberFunctionTablePtr_;
    writeModels(os, keywordsOf.sortedToc(), keywordsOf);
}


//- An option and what it does
struct listOption
{
    const char* name;
    const char* usage;
    void (*write)(Ostream&);
};

const listOption options[] =
{
    {"listMaterials", "List materials and their keywords", listMaterials},
    {
        "listStartFields", "List fields that a run may begin with",
        listStartFields
    },
    {
        "listContactLaws", "List contact laws and their keywords",
        listContactLaws
    },
    {
        "listPairings",
        "List pairings of an interface, obstacles, and their keywords",
        listPairings
    },
    {
        "listBoundaryConditions",
        "List boundary conditions of pointU and their keywords",
        listBoundaryConditions
    },
    {
        "listBodyForces", "List body forces and their keywords",
        listBodyForces
    },
    {
        "listSchemes", "List keywords and values of vertexCentred (fvSchemes)",
        listSchemes
    },
    {
        "listControls", "List keywords of controlDict and of slow loading",
        listControls
    },
    {"listPresets", "List presets and what they stand for", listPresets},
    {"listIntegrators", "List time integrators", listIntegrators},
    {
        "listFunctionObjects",
        "List function objects of vertexContact and their keywords",
        listFunctionObjects
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::modelLists::addOptions()
{
    for (const listOption& option : options)
    {
        argList::addBoolOption(option.name, option.usage);
    }
}


bool Foam::modelLists::write(const argList& args, Ostream& os)
{
    bool any = false;
    for (const listOption& option : options)
    {
        any = any || args.found(option.name);
    }
    if (!any)
    {
        return false;
    }

    // Models of the user's libraries, as Time would load them
    dlLibraryTable libraries;
    IFstream is(args.rootPath()/args.globalCaseName()/"system/controlDict");
    if (is.good())
    {
        libraries.open(dictionary(is), "libs");
    }

    for (const listOption& option : options)
    {
        if (args.found(option.name))
        {
            option.write(os);
        }
    }
    os.flush();
    return true;
}


// ************************************************************************* //
