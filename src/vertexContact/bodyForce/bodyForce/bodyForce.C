/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyForce.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(bodyForce, 0);
    defineRunTimeSelectionTable(bodyForce, dictionary);
    defineModelKeywords(bodyForce);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyForce::bodyForce(const dictionary& dict, const medianDual& dual)
:
    name_(dict.dictName()),
    dual_(dual)
{}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::bodyForce> Foam::bodyForce::New
(
    const dictionary& dict,
    const medianDual& dual,
    const materialModel& material
)
{
    const word forceType(dict.get<word>("type"));

    findListedModel(bodyForce, dict, "type", forceType)
    return constructorPtr(dict, dual, material);
}


Foam::PtrList<Foam::bodyForce> Foam::bodyForce::readAll
(
    const dictionary& forces,
    const medianDual& dual,
    const materialModel& material
)
{
    PtrList<bodyForce> all;
    for (const entry& e : forces)
    {
        if (e.keyword() == "FoamFile") continue;
        if (!e.isDict())
        {
            FatalIOErrorInFunction(forces)
                << "Keyword '" << e.keyword()
                << "' is not a dictionary. A body force must be one, as in "
                << "shaking { type uniform; acceleration (1 0 0); }"
                << exit(FatalIOError);
        }
        all.append(New(e.dict(), dual, material));
    }
    return all;
}


// ************************************************************************* //
