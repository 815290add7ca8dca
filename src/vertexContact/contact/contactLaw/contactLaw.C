/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactLaw.H"
#include "dictionaryCheck.H"
#include "IStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(contactLaw, 0);
    defineRunTimeSelectionTable(contactLaw, dictionary);
    defineModelKeywords(contactLaw);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::contactLaw> Foam::contactLaw::New(const dictionary& dict)
{
    const word lawType(dict.get<word>("type"));

    findListedModel(contactLaw, dict, "type", lawType)
    return constructorPtr(dict);
}


const Foam::dictionary& Foam::contactLaw::dictIn(const dictionary& dict)
{
    return dictionaryCheck::subDict(dict, "law", "type frictionless;");
}


Foam::autoPtr<Foam::contactLaw> Foam::contactLaw::ofInterface
(
    const dictionary& dict
)
{
    return New
    (
        dict.found("law")
      ? dictIn(dict)
      : dictionary(IStringStream("type frictionless;")())
    );
}


// ************************************************************************* //
