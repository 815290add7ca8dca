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
    { kind::paper, "paper" },
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::preset::preset(const kind name)
:
    name(name),
    scheme(),
    maxCo(0.9),
    integrator(integratorType::leapfrog)
{
    switch (name)
    {
        case kind::fast:
            scheme.frontDissipation = scheme.dissipation;
            break;
        case kind::balanced:
            break;
        case kind::accurate:
            maxCo = 0.45;
            break;
        case kind::paper:
            scheme.scheme = schemeType::paper;
            scheme.dissipation = 1;
            maxCo = 0.6;
            integrator = integratorType::TVDRK2;
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
    string fluxes;
    for (const word& name : timeIntegrator::names.toc())
    {
        const timeIntegrator its(timeIntegrator::names[name]);
        fluxes += (fluxes.size() ? ", " : "") + Foam::name(its.nStages());
    }
    return
    {
        {
            "maxCo", "-", Foam::name(maxCo),
            "time step, as a share of the largest stable step"
        },
        {
            "timeIntegrator", "", timeIntegrator::names[integrator],
            keywordList::oneOf
            (
                timeIntegrator::names.toc(),
                string("flux evaluations per step: " + fluxes)
            )
        }
    };
}


// ************************************************************************* //
