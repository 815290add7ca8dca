/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "materialModel.H"
#include "dictionaryCheck.H"
#include "dimensionSets.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(materialModel, 0);
    defineRunTimeSelectionTable(materialModel, dictionary);
    defineModelKeywords(materialModel);
}

const Foam::Enum<Foam::jacobianForm>
Foam::materialModel::jacobianFormNames
({
    { jacobianForm::volumetric, "volumetric" },
    { jacobianForm::literal, "literal" },
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Moduli of what does not deform, by its density [m2/s2]: the impedance of any
//  other body, added to it, is lost in round-off
constexpr Foam::scalar stiffest = 1e60;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialModel::materialModel
(
    const dictionary& dict,
    const keywordList& specific
)
{
    using namespace dictionaryCheck;

    onlyKeywords(dict, commonKeywords() + specific);

    rho_ = readNumber(dict, "rho", dimDensity);
    require(rho_ > 0, dict, "rho", rho_, "positive");

    DynamicList<word> given;
    for (const word w : {"E", "nu", "mu", "lambda", "kappa"})
    {
        if (dict.found(w))
        {
            given.append(w);
        }
    }

    const auto isPair = [&](const word& a, const word& b)
    {
        return given.size() == 2 && given.found(a) && given.found(b);
    };

    if (isPair("E", "nu"))
    {
        const scalar E = readNumber(dict, "E", dimPressure);
        const scalar nu = readNumber(dict, "nu", dimless);
        require(E > 0, dict, "E", E, "positive");
        require
        (
            nu > -1 && nu < 0.5, dict, "nu", nu,
            "greater than -1 and less than 0.5"
        );
        mu_ = E/(2*(1 + nu));
        kappa_ = E/(3*(1 - 2*nu));
    }
    else if (isPair("mu", "kappa"))
    {
        mu_ = readNumber(dict, "mu", dimPressure);
        kappa_ = readNumber(dict, "kappa", dimPressure);
    }
    else if (isPair("mu", "lambda"))
    {
        mu_ = readNumber(dict, "mu", dimPressure);
        require(mu_ > 0, dict, "mu", mu_, "positive");
        const scalar lambda = readNumber(dict, "lambda", dimPressure);
        kappa_ = lambda + 2*mu_/3;
        require
        (
            kappa_ > 0, dict, "lambda", lambda, "greater than -2 mu/3"
        );
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "Elastic constants given: " << listed(given).c_str() << nl
            << "Give exactly one of the pairs (E nu), (mu lambda), "
            << "(mu kappa)" << exit(FatalIOError);
    }

    require(mu_ > 0, dict, "mu", mu_, "positive");
    require(kappa_ > 0, dict, "kappa", kappa_, "positive");
}


Foam::materialModel::materialModel(const scalar rho)
:
    rho_(rho),
    mu_(stiffest*rho),
    kappa_(stiffest*rho)
{}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::materialModel> Foam::materialModel::New
(
    const dictionary& dict,
    const jacobianForm form
)
{
    const word modelType(dict.get<word>("type"));

    findListedModel(materialModel, dict, "type", modelType)
    return constructorPtr(dict, form);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::materialModel::commonKeywords()
{
    return
    {
        {"type", "", "required", "name of the material law"},
        {"rho", "kg/m3", "required", "density in the reference configuration"},
        {"E", "Pa", "with nu", "Young's modulus"},
        {"nu", "-", "with E", "Poisson's ratio"},
        {"mu", "Pa", "if no E, nu", "shear modulus"},
        {"lambda", "Pa", "with mu", "Lame's first parameter"},
        {"kappa", "Pa", "with mu", "bulk modulus, may replace lambda"}
    };
}


Foam::scalar Foam::materialModel::cp() const
{
    return std::sqrt((kappa_ + 4*mu_/3)/rho());
}


Foam::scalar Foam::materialModel::cs() const
{
    return std::sqrt(mu_/rho());
}


// ************************************************************************* //
