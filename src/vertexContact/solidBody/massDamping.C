/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "massDamping.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::massDamping::massDamping(const dictionary& dict)
:
    dict_(dict),
    function_("coefficient", dict_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::massDamping::keywords()
{
    return
    {
        {
            "coefficient", "1/s", "required",
            "damping force per mass and velocity: a number, or any Function1 "
            "of time"
        },
        {"coefficientCoeffs", "", "none", "coefficients of the Function1"}
    };
}


void Foam::massDamping::setTime(const scalar time)
{
    coefficient_ = function_(time);
    dictionaryCheck::require
    (
        coefficient_ >= 0 && std::isfinite(coefficient_), dict_,
        "coefficient", coefficient_, "at least 0, and finite, at all times"
    );
}


// ************************************************************************* //
