/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::bodyForces::uniform

Description
    The same acceleration [m/s2] everywhere, a constant or any Function1 of
    time: for example a shaking support, seen in its own frame, or gravity that
    is applied slowly. Components in directions that are not solved are ignored.

    Throws FatalIOError for a missing acceleration and unknown keywords.

Usage
    \verbatim
        shaking
        {
            type         uniform;
            acceleration (0 0 -9.81);
        }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "bodyForce.H"
#include "dictionaryCheck.H"
#include "timeValue.H"
#include "polyMesh.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace bodyForces
{

class uniform
:
    public bodyForce
{
    const timeValue<vector> acceleration_;

    static const dictionary& checked(const dictionary& dict)
    {
        dictionaryCheck::onlyKeywords(dict, keywords());
        return dict;
    }

public:

    TypeName("uniform");

    static keywordList keywords()
    {
        return
        {
            {"type", "", "required", "name of the body force"},
            {
                "acceleration", "m/s2", "required",
                "of all points of the region; a vector, or any Function1 of "
                "time"
            },
            {"accelerationCoeffs", "", "none", "coefficients of the Function1"}
        };
    }

    uniform
    (
        const dictionary& dict,
        const medianDual& dual,
        const materialModel&
    )
    :
        bodyForce(checked(dict), dual),
        acceleration_("acceleration", dict)
    {
        dictionaryCheck::warnLeftOut
        (
            dict.name(), "acceleration", dual.mesh().time(), acceleration_,
            [&](const vector& v) { return dual.projected(v); }
        );
    }

    virtual void add(const scalar time, scalarField& acceleration) const
    {
        const vector given = acceleration_(time);
        const label d = dual().nDim();
        for (label i = 0; i < d; ++i)
        {
            const scalar along = given[dual().directions()[i]];
            for (label a = 0; a < dual().nNodes(); ++a)
            {
                acceleration[a*d + i] += along;
            }
        }
    }
};


defineTypeNameAndDebug(uniform, 0);
addListedModel(bodyForce, uniform);

} // End namespace bodyForces
} // End namespace Foam


// ************************************************************************* //
