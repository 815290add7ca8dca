/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidMaterial.H"
#include "dictionaryCheck.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(rigidMaterial, 0);
    addListedModel(materialModel, rigidMaterial);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidMaterial::rigidMaterial(const dictionary& dict, const jacobianForm)
:
    materialModel(dictionaryCheck::readNumber(dict, "rho", dimDensity))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::rigidMaterial::keywords()
{
    return
    {
        {"rho", "kg/m3", "or mass", "density: mass and inertia of the mesh"},
        {"mass", "kg", "or rho", "in 2D per metre, in 1D per square metre"},
        {
            "inertia", "kg m2", "as of one density",
            "symmTensor about the centre of mass, at the start"
        },
        {"centreOfMass", "m", "that of the mesh", "with inertia"},
        {
            "pivot", "m", "none",
            "point of the body that stays where it is"
        },
        {
            "freeTranslation", "", "(x y z)",
            "directions; with motion none"
        },
        {
            "freeRotation", "", "(x y z)",
            "all, one axis, or none; with motion none"
        },
        {
            "force", "N", "none",
            "at the centre of mass: vector, or any Function1 of time"
        },
        {"forceCoeffs", "", "none", "coefficients of the Function1"},
        {"moment", "N m", "none", "vector, or any Function1 of time"},
        {"momentCoeffs", "", "none", "coefficients of the Function1"},
        {
            "motion", "", "none",
            "of what is not free: displacement, velocity, or "
            "solidBodyMotionFunction"
        }
    };
}


// ************************************************************************* //
