/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeIntegrator.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::integratorType> Foam::timeIntegrator::names
({
    { integratorType::TVDRK2, "TVDRK2" },
    { integratorType::TVDRK3, "TVDRK3" },
    { integratorType::symplecticEuler, "symplecticEuler" },
    { integratorType::leapfrog, "leapfrog" },
});


const Foam::timeIntegrator::coefficients Foam::timeIntegrator::all_[] =
{
    // stages, split, leapfrog, weights of the old state, instants, shares
    {2, false, false, {0, 0.5}, {0, 1, 1}, {0.5, 0.5}},
    {
        3, false, false, {0, 0.75, 1.0/3}, {0, 1, 0.5, 1},
        {1.0/6, 1.0/6, 2.0/3}
    },
    {1, true, false, {0}, {0, 1}, {1}},
    {1, false, true, {0}, {0, 1}, {1}}
};


// ************************************************************************* //
