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
    onlyKeywords
    (
        dict,
        wordList
        ({
            "cells", "reconstruction", "limiter", "kinematics", "jacobian",
            "preserveAngularMomentum", "waveSpeed", "dissipation"
        })
    );

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
        if (speed != "linear" && speed != "stretched")
        {
            unknownModel
            (
                dict, "waveSpeed", speed, wordList({"linear", "stretched"})
            );
        }
        stretchedWaves = (speed == "stretched");
    }

    if (reconstruction == reconstructionType::none)
    {
        limiter = limiterType::none;
    }
}


// ************************************************************************* //
