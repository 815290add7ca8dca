/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "schemeOptions.H"
#include "dictionaryCheck.H"
#include "Switch.H"
#include "dimensionSets.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::reconstructionType>
Foam::schemeOptions::reconstructionNames
({
    { reconstructionType::none, "none" },
    { reconstructionType::linear, "linear" },
    { reconstructionType::full, "full" },
});

const Foam::Enum<Foam::limiterType>
Foam::schemeOptions::limiterNames
({
    { limiterType::none, "none" },
    { limiterType::BarthJespersen, "BarthJespersen" },
    { limiterType::Venkatakrishnan, "Venkatakrishnan" },
});


const Foam::wordList Foam::schemeOptions::waveSpeedNames
({
    "linear", "stretched"
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::schemeOptions::schemeOptions
(
    const dictionary& fvSchemes,
    const schemeOptions& defaults
)
:
    schemeOptions(defaults)
{
    if (!fvSchemes.found("vertexCentred"))
    {
        return;
    }

    using namespace dictionaryCheck;

    const dictionary& dict = fvSchemes.subDict("vertexCentred");
    onlyKeywords(dict, keywords());

    cells = readEnum(medianDual::cellTreatmentNames, dict, "cells", cells);
    reconstruction =
        readEnum(reconstructionNames, dict, "reconstruction", reconstruction);
    limiter = readEnum(limiterNames, dict, "limiter", limiter);
    kinematics = readEnum
    (
        conservedState::kinematicSetNames, dict, "kinematics", kinematics
    );
    jacobian = readEnum
    (
        materialModel::jacobianFormNames, dict, "jacobian", jacobian
    );

    preserveAngularMomentum = dict.getOrDefault<Switch>
    (
        "preserveAngularMomentum", preserveAngularMomentum
    );

    dissipation =
        readNumberOrDefault(dict, "dissipation", dimless, dissipation);
    require
    (
        dissipation > 0 && dissipation <= 1,
        dict, "dissipation", dissipation, "above 0 and at most 1"
    );

    if (dict.found("waveSpeed"))
    {
        const word speed(dict.get<word>("waveSpeed"));
        if (!waveSpeedNames.found(speed))
        {
            unknownModel(dict, "waveSpeed", speed, waveSpeedNames);
        }
        stretchedWaves = (speed == waveSpeedNames[true]);
    }

    if (reconstruction == reconstructionType::none)
    {
        limiter = limiterType::none;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::schemeOptions::keywords() const
{
    const auto oneOf = [](const auto& names, const char* meaning)
    {
        return keywordList::oneOf(names.toc(), meaning);
    };

    return
    {
        {
            "cells", "", medianDual::cellTreatmentNames[cells],
            oneOf
            (
                medianDual::cellTreatmentNames,
                "mean of the splits of quads and hexes, one split, mesh edges"
            )
        },
        {
            "reconstruction", "", reconstructionNames[reconstruction],
            oneOf
            (
                reconstructionNames,
                "first order, velocity in the traction jump, all"
            )
        },
        {
            "limiter", "", limiterNames[limiter],
            oneOf(limiterNames, "along each edge")
        },
        {
            "kinematics", "", conservedState::kinematicSetNames[kinematics],
            oneOf
            (
                conservedState::kinematicSetNames,
                "geometric conservation laws that are solved"
            )
        },
        {
            "jacobian", "", materialModel::jacobianFormNames[jacobian],
            oneOf
            (
                materialModel::jacobianFormNames,
                "isochoric stress from F alone, or as printed in the paper"
            )
        },
        {
            "preserveAngularMomentum", "", preserveAngularMomentum
          ? "yes" : "no",
            "internal forces without torque"
        },
        {
            "waveSpeed", "", waveSpeedNames[stretchedWaves],
            keywordList::oneOf
            (
                waveSpeedNames, "of the undeformed material, or the stretched"
            )
        },
        {
            "dissipation", "-", Foam::name(dissipation),
            "share of that of the momentum at edges, above 0 and at most 1"
        }
    };
}


// ************************************************************************* //
