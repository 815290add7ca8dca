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


// ************************************************************************* //
