/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeIntegrator.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::integratorType> Foam::timeIntegrator::names
({
    #define integratorWord(name, ...) { integratorType::name, #name },
    forAllIntegrators(integratorWord)
    #undef integratorWord
});


const Foam::timeIntegrator::coefficients Foam::timeIntegrator::all_[] =
{
    #define integratorRow(name, ...) { __VA_ARGS__ },
    forAllIntegrators(integratorRow)
    #undef integratorRow
};


// ************************************************************************* //
