/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prescribedMotion.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::prescribedMotion::prescribedMotion
(
    const dictionary& dict,
    const word& keyword,
    const bool ofDisplacement
)
:
    ofDisplacement_(ofDisplacement)
{
    if (dict.found("components") && dict.found("direction"))
    {
        FatalIOErrorInFunction(dict)
            << "Keywords 'components' and 'direction' exclude each other: "
            << "'" << keyword << "' is a number with 'direction', and a "
            << "vector with 'components'" << exit(FatalIOError);
    }

    if (dict.found("direction"))
    {
        direction_ = dict.get<vector>("direction");
        const scalar length = mag(direction_);
        if (!(length > 0) || !std::isfinite(length))
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'direction' is " << direction_
                << ": it must be a vector with a finite length above 0"
                << exit(FatalIOError);
        }
        directions_ = List<vector>(1, direction_/length);
        along_ = timeValue<scalar>(keyword, dict);
        return;
    }

    if (dict.found("components"))
    {
        components_ = dict.get<wordList>("components");
        const wordList valid({"x", "y", "z"});
        for (const word& component : components_)
        {
            const label c = valid.find(component);
            if (c < 0)
            {
                dictionaryCheck::unknownModel
                (
                    dict, "components", component, valid
                );
            }
            vector unit(Zero);
            unit[c] = 1;
            directions_.append(unit);
        }
        dictionaryCheck::requireOnce(dict, "components", components_);
        if (components_.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'components' is empty. Valid components: (x y z). "
                << "The type of a free surface is 'tractionFree'"
                << exit(FatalIOError);
        }
    }
    vector_ = timeValue<vector>(keyword, dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::prescribedMotion::keywords
(
    const word& keyword,
    const word& unit
)
{
    return
    {
        {
            keyword, unit, "required",
            "a vector (with direction, a number), or any Function1 of time"
        },
        {
            word(keyword + "Coeffs"), "", "none",
            "coefficients of the Function1"
        },
        {
            "components", "", "all",
            "prescribed components, of (x y z); the others are free"
        },
        {
            "direction", "-", "none",
            "vector along which the motion is prescribed; across it the node "
            "is free"
        }
    };
}


void Foam::prescribedMotion::write(Ostream& os) const
{
    if (components_.size()) os.writeEntry("components", components_);
    if (magSqr(direction_) > 0) os.writeEntry("direction", direction_);
    vector_.write(os);
    along_.write(os);
}


// ************************************************************************* //
