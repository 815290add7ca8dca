/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactPairing.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(contactPairing, 0);
    defineRunTimeSelectionTable(contactPairing, dictionary);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::contactPairing> Foam::contactPairing::New
(
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
{
    const word pairingType
    (
        dict.getOrDefault<word>("pairing", "matching")
    );

    vertexContactLookupConstructor(contactPairing, dictionary, pairingType)

    if (!constructorFound)
    {
        dictionaryCheck::unknownModel
        (
            dict, "pairing", pairingType,
            dictionaryConstructorTablePtr_->sortedToc()
        );
    }

    return constructorPtr(dict, minus, plus);
}


Foam::wordList Foam::contactPairing::keywords()
{
    return wordList({"pairing", "direction"});
}


// ************************************************************************* //
