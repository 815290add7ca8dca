/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "schemeOptions.H"
#include "dictionaryCheck.H"
#include "dimensionSets.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

template<class Names>
Foam::string oneOf(const Names& names, const char* meaning)
{
    return Foam::keywordList::oneOf(names.toc(), meaning);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::schemeType>
Foam::schemeOptions::schemeNames
({
    { schemeType::variational, "variational" },
    { schemeType::paper, "paper" },
});

const Foam::Enum<Foam::volumeTreatment>
Foam::schemeOptions::volumeNames
({
    { volumeTreatment::automatic, "automatic" },
    { volumeTreatment::nodal, "nodal" },
    { volumeTreatment::smoothed, "smoothed" },
});

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
    #define limiterWord(name) { limiterType::name, #name },
    forAllLimiters(limiterWord)
    #undef limiterWord
});

const Foam::Enum<bool> Foam::schemeOptions::waveSpeedNames
({
    { false, "linear" },
    { true, "stretched" },
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::schemeOptions::refuseOther(const dictionary& dict) const
{
    const bool paper = (scheme == schemeType::paper);
    const keywordList others = paper ? variationalKeywords() : paperKeywords();
    for (const keywordList::keyword& other : others.all)
    {
        if (dict.found(other.name))
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '" << other.name << "' belongs to the "
                << (paper ? "variational scheme, but 'preset paper' in "
                  "controlDict selects the paper's scheme."
                : "paper's scheme, which needs 'preset paper' in controlDict.")
                << nl << "Keywords of the selected scheme: "
                << dictionaryCheck::listed(keywords().names()).c_str()
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::schemeOptions::schemeOptions
(
    const dictionary& fvSchemes,
    const schemeOptions& defaults
)
:
    schemeOptions(defaults)
{
    if (!fvSchemes.found("vertexCentred")) return;

    using namespace dictionaryCheck;

    const dictionary& dict =
        subDict(fvSchemes, "vertexCentred", "cells simplicial;");
    refuseOther(dict);
    onlyKeywords(dict, keywords());

    cells = readEnum(medianDual::cellTreatmentNames, dict, "cells", cells);
    dissipation =
        readNumberOrDefault(dict, "dissipation", dimless, dissipation);
    require
    (
        dissipation > 0 && dissipation <= 1,
        dict, "dissipation", dissipation, "above 0 and at most 1"
    );

    if (scheme == schemeType::variational)
    {
        correction =
            readNumberOrDefault(dict, "correction", dimless, correction);
        require
        (
            correction >= 0 && correction <= 0.5,
            dict, "correction", correction, "at least 0 and at most 0.5"
        );
        volume = readEnum(volumeNames, dict, "volume", volume);
        frontDissipation = readNumberOrDefault
        (
            dict, "frontDissipation", dimless, frontDissipation
        );
        require
        (
            frontDissipation >= dissipation && frontDissipation <= 1,
            dict, "frontDissipation", frontDissipation,
            ("at least dissipation (" + Foam::name(dissipation)
          + "), and at most 1").c_str()
        );
        return;
    }

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
    stretchedWaves =
        readEnum(waveSpeedNames, dict, "waveSpeed", stretchedWaves);

    if (reconstruction == reconstructionType::none) limiter = limiterType::none;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::schemeOptions::commonKeywords() const
{
    return
    {
        {
            "cells", "", medianDual::cellTreatmentNames[cells],
            oneOf
            (
                medianDual::cellTreatmentNames,
                "quads and hexes: mean of their splits into simplices, one "
                "split, or mesh edges only"
            )
        },
        {
            "dissipation", "-", Foam::name(dissipation),
            "share of the Riemann solver's dissipation in smooth motion "
            "(paper: of the momentum, everywhere); above 0 and at most 1"
        }
    };
}


Foam::keywordList Foam::schemeOptions::variationalKeywords() const
{
    return
    {
        {
            "correction", "-", Foam::name(correction),
            "factor of the correction of averages in the gradient, 0 to 0.5: "
            "1/3 gives fourth order on a line; 0 gives second order, cheaper"
        },
        {
            "volume", "", volumeNames[volume],
            oneOf
            (
                volumeNames,
                "Jacobian in the energy: smoothed from a Poisson's ratio of "
                "0.45 on, never, or always"
            )
        },
        {
            "frontDissipation", "-", Foam::name(frontDissipation),
            "dissipation at sharp waves, from dissipation to 1; more shortens "
            "the stable step"
        }
    };
}


Foam::keywordList Foam::schemeOptions::paperKeywords() const
{
    return
    {
        {
            "reconstruction", "", reconstructionNames[reconstruction],
            oneOf
            (
                reconstructionNames,
                "nothing (first order), the velocity in the traction jump, "
                "or velocity and stress"
            )
        },
        {
            "limiter", "", limiterNames[limiter],
            oneOf(limiterNames, "slope limiter, along each edge")
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
                "isochoric stress: from F alone, or as printed in the paper"
            )
        },
        {
            "waveSpeed", "", waveSpeedNames[stretchedWaves],
            oneOf
            (
                waveSpeedNames,
                "waves of the undeformed, or of the stretched material"
            )
        }
    };
}


Foam::keywordList Foam::schemeOptions::keywords() const
{
    return
        commonKeywords()
      + (
            scheme == schemeType::paper
          ? paperKeywords()
          : variationalKeywords()
        );
}


// ************************************************************************* //
