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
        {
            "rho", "kg/m3", "or mass",
            "density; mass and inertia follow from the mesh"
        },
        {
            "mass", "kg", "or rho",
            "mass; in 2D per metre of thickness, in 1D per square metre of "
            "cross-section"
        },
        {
            "inertia", "kg m2", "uniform density",
            "symmTensor about the centre of mass, as the body lies at the "
            "start"
        },
        {
            "centreOfMass", "m", "of the mesh",
            "centre of mass; only with inertia"
        },
        {
            "pivot", "m", "none",
            "fixed point of the body, about which it turns"
        },
        {
            "freeTranslation", "", "(x y z)",
            "directions of free translation; () is the default with motion "
            "or pivot"
        },
        {
            "freeRotation", "", "(x y z)",
            "axes of free rotation: all, one, or none (); () is the default "
            "with motion"
        },
        {
            "force", "N", "none",
            "force at the centre of mass: a vector, or any Function1 of "
            "time"
        },
        {"forceCoeffs", "", "none", "coefficients of the Function1"},
        {"moment", "N m", "none", "a vector, or any Function1 of time"},
        {"momentCoeffs", "", "none", "coefficients of the Function1"},
        {
            "motion", "", "at rest",
            "dictionary: motion in the directions that are not free, by "
            "displacement, velocity, or solidBodyMotionFunction"
        }
    };
}


// ************************************************************************* //
