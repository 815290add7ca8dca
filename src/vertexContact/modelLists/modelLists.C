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

void writeKeywords(Ostream& os, const char* of, const keywordList& keywords)
{
    os  << of << nl;
    keywords.write(os);
    os  << nl;
}

//- Write names that OpenFOAM provides
void writeNames(Ostream& os, const char* of, const wordList& names)
{
    os  << of << nl << "    " << dictionaryCheck::listed(names).c_str() << nl
        << nl;
}

//- Write names, and below each its keywords
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

//- Write the models of a base class that has the usual tables
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
    writeKeywords
    (
        os, "all but rigid; give one of (E nu), (mu lambda), (mu kappa)",
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
    regionFiles::startFields().write(os);
    os  << nl;
}


void listContactLaws(Ostream& os)
{
    writeKeywords(os, "all", contactLaw::commonKeywords());
    writeModels<contactLaw>(os);
}


void listPairings(Ostream& os)
{
    writeKeywords(os, "all", contactPairing::commonKeywords());
    writeModels<contactPairing>(os);
    writeKeywords
    (
        os, "instead of two sides: an interface of many surfaces",
        generalInterface::keywords()
    );
    writeKeywords
    (
        os, "instead of two sides: an interface with an obstacle",
        obstacleInterface::keywords()
    );
    writeKeywords
    (
        os, "'motion' of an obstacle, and of a rigid region",
        obstacleMotion::keywords()
    );
    writeNames
    (
        os, "'type' of an obstacle (searchableSurface of OpenFOAM)",
        searchableSurface::dictConstructorTablePtr_->sortedToc()
    );
    writeNames
    (
        os, "'solidBodyMotionFunction' of a motion (of OpenFOAM)",
        solidBodyMotionFunction::dictionaryConstructorTablePtr_->sortedToc()
    );
}


void listBoundaryConditions(Ostream& os)
{
    writeKeywords(os, "all", solidBoundaryCondition::commonKeywords());
    const auto& keywordsOf =
        *solidBoundaryCondition::keywordsOfModelMemberFunctionTablePtr_;
    writeModels(os, keywordsOf.sortedToc(), keywordsOf);
    writeNames
    (
        os, "of OpenFOAM: mirrors, and empty for directions that are left out",
        solidBoundaryCondition::mirrorNames()
    );
}


void listSchemes(Ostream& os)
{
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
    // A row for each option of any preset, a column for each preset
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
    controlKeywords::keywords().write(os);
    os  << nl;
}


void listIntegrators(Ostream& os)
{
    for (const word& name : timeIntegrator::names.toc())
    {
        const timeIntegrator integrator(timeIntegrator::names[name]);
        os  << name << nl << "    evaluates fluxes "
            << integrator.nStages()
            << (integrator.nStages() > 1 ? " times" : " time") << " per step"
            << (
                   integrator.leapfrog() ? "; for the variational scheme"
               : integrator.split()
               ? "; for preset paper with reconstruction linear and none"
               : "; for preset paper"
               )
            << nl;
    }
    os  << nl;
    writeKeywords(os, "with leapfrog", stepRatios::keywords());
}


void listFunctionObjects(Ostream& os)
{
    typedef functionObjects::solidFunctionObject base;
    writeKeywords(os, "all", base::commonKeywords());
    const auto& keywordsOf = *base::keywordsOfModelMemberFunctionTablePtr_;
    writeModels(os, keywordsOf.sortedToc(), keywordsOf);
}


//- An option: name, usage, heading of its list, and function that writes it
struct listOption
{
    const char* name;
    const char* usage;
    const char* heading;
    void (*write)(Ostream&);
};

const listOption options[] =
{
    {
        "listMaterials",
        "List materials and their keywords",
        "Materials: 'type' in constant/<region>/mechanicalProperties",
        listMaterials
    },
    {
        "listStartFields",
        "List fields that a run may start with, and their units and types",
        "Start fields: point fields in <time>/<region>, or in <time> with one "
        "value for all regions; pointU is required",
        listStartFields
    },
    {
        "listContactLaws",
        "List contact laws and their keywords",
        "Contact laws: dictionary 'law' of an interface in "
        "constant/contactProperties",
        listContactLaws
    },
    {
        "listPairings",
        "List pairings of an interface, obstacles, and their keywords",
        "Pairings: 'pairing' of an interface in constant/contactProperties",
        listPairings
    },
    {
        "listBoundaryConditions",
        "List boundary conditions of pointU and their keywords",
        "Boundary conditions: 'type' of a patch in 0/<region>/pointU",
        listBoundaryConditions
    },
    {
        "listBodyForces",
        "List body forces and their keywords",
        "Body forces: 'type' of each dictionary in "
        "constant/<region>/bodyForces",
        writeModels<bodyForce>
    },
    {
        "listSchemes",
        "List keywords and values of vertexCentred (fvSchemes)",
        "Schemes: dictionary 'vertexCentred' in system/<region>/fvSchemes, "
        "with the defaults of preset balanced, and of preset paper for its "
        "keywords",
        listSchemes
    },
    {
        "listControls",
        "List keywords of controlDict, also those of slow loading",
        "Controls: keywords of vertexContact in system/controlDict, with the "
        "defaults of preset balanced; <region> is a name, or a regular "
        "expression for names in quotes",
        listControls
    },
    {
        "listPresets",
        "List presets and the options that they set",
        "Presets: 'preset' in system/controlDict; the default is balanced",
        listPresets
    },
    {
        "listIntegrators",
        "List time integrators",
        "Time integrators: 'timeIntegrator' in system/controlDict",
        listIntegrators
    },
    {
        "listFunctionObjects",
        "List function objects of vertexContact and their keywords",
        "Function objects of vertexContact: 'type' in 'functions' in "
        "system/controlDict",
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
    if (!any) return false;

    // Load the user's libraries, as Time would
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
            os  << option.heading << nl << nl;
            option.write(os);
        }
    }
    os.flush();
    return true;
}


// ************************************************************************* //
