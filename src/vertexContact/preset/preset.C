/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "preset.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::preset::kind> Foam::preset::names
({
    { kind::fast, "fast" },
    { kind::balanced, "balanced" },
    { kind::accurate, "accurate" },
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::preset::preset(const kind name)
:
    name(name),
    scheme(),
    maxCo(0.6),
    integrator(integratorType::TVDRK2)
{
    switch (name)
    {
        case kind::fast:
            scheme.reconstruction = reconstructionType::linear;
            scheme.kinematics = kinematicSet::FJ;
            maxCo = 0.8;
            integrator = integratorType::symplecticEuler;
            break;

        case kind::balanced:
            break;

        case kind::accurate:
            scheme.dissipation = 0.5;
            maxCo = 0.3;
            break;
    }
}


Foam::preset::preset(const dictionary& controlDict)
:
    preset
    (
        dictionaryCheck::readEnum
        (
            names, controlDict, "preset", kind::balanced
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::preset::keywords() const
{
    return
    {
        {
            "maxCo", "-", Foam::name(maxCo),
            "step, as a share of the largest one that information allows"
        },
        {
            "timeIntegrator", "", timeIntegrator::names[integrator],
            keywordList::oneOf
            (
                timeIntegrator::names.toc(), "two, three, one flux a step"
            )
        }
    };
}


// ************************************************************************* //
