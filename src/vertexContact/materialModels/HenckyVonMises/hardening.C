/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "HenckyVonMises.H"
#include "dictionaryCheck.H"
#include "Function1.H"
#include "TableBase.H"
#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::hardening::linear::linear(const dictionary& dict)
{
    using namespace dictionaryCheck;

    const keywordList described(HenckyVonMises::keywords());
    tauY = readNumber(dict, "tauY", dimPressure);
    H = readOptional(dict, described, "Hardening", dimPressure);
    require(tauY > 0, dict, "tauY", tauY, "positive");
    require(H >= 0, dict, "Hardening", H, "at least 0");
}


Foam::hardening::table::table(const dictionary& dict)
{
    const autoPtr<Function1<scalar>> curve
    (
        dictionaryCheck::readFunction<scalar>("hardeningCurve", dict)
    );
    const scalar last =
        dictionaryCheck::readOptional
        (
            dict, HenckyVonMises::keywords(), "maxStrain", dimless
        );
    dictionaryCheck::require
    (
        last > 0, dict, "maxStrain", last, "positive"
    );

    const auto* points =
        dynamic_cast<const Function1Types::TableBase<scalar>*>(curve.get());
    if (points)
    {
        strains = points->x();
        stresses = points->y();
    }
    else
    {
        const label n = nParts;
        strains.setSize(n + 1);
        stresses.setSize(n + 1);
        for (label i = 0; i <= n; ++i)
        {
            strains[i] = i*last/n;
            stresses[i] = curve->value(strains[i]);
        }
    }

    dictionaryCheck::require
    (
        mag(strains[0]) < SMALL, dict, "hardeningCurve", strains[0],
        "a curve that begins at the plastic strain 0"
    );
    forAll(stresses, i)
    {
        dictionaryCheck::require
        (
            stresses[i] > 0, dict, "hardeningCurve", stresses[i],
            "positive everywhere"
        );
        dictionaryCheck::require
        (
            i == 0
         || (stresses[i] >= stresses[i-1] && strains[i] > strains[i-1]),
            dict, "hardeningCurve", stresses[i],
            "a curve that does not fall"
        );
    }
}


Foam::hardening::JohnsonCook::JohnsonCook(const dictionary& dict)
{
    using namespace dictionaryCheck;

    const keywordList described(keywords());
    onlyKeywords(dict, described);
    A = readNumber(dict, "A", dimPressure);
    B = readNumber(dict, "B", dimPressure);
    n = readNumber(dict, "n", dimless);
    C = readNumber(dict, "C", dimless);
    rate0 = readOptional(dict, described, "referenceRate", dimless/dimTime);
    require(A > 0, dict, "A", A, "positive");
    require(B >= 0, dict, "B", B, "at least 0");
    require(n > 0, dict, "n", n, "positive");
    require(C >= 0, dict, "C", C, "at least 0");
    require(rate0 > 0, dict, "referenceRate", rate0, "positive");

    if (!dict.found("m"))
    {
        for (const word w : {"Tmelt", "Troom"})
        {
            if (dict.found(w))
            {
                FatalIOErrorInFunction(dict)
                    << "Keyword '" << w.c_str() << "' needs 'm', the exponent "
                    << "of thermal softening, which is not given"
                    << exit(FatalIOError);
            }
        }
        return;
    }
    m = readNumber(dict, "m", dimless);
    Tmelt = readNumber(dict, "Tmelt", dimTemperature);
    Troom = readNumberOrDefault(dict, "Troom", dimTemperature, 0);
    require(m > 0, dict, "m", m, "positive");
    require(Troom >= 0, dict, "Troom", Troom, "at least 0");
    require(Tmelt > Troom, dict, "Tmelt", Tmelt, "above Troom");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::hardening::JohnsonCook::keywords()
{
    return
    {
        {"A", "Pa", "required", "initial yield stress, above 0"},
        {"B", "Pa", "required", "factor of strain^n, at least 0"},
        {"n", "-", "required", "exponent of the plastic strain, above 0"},
        {"C", "-", "required", "factor of ln(rate/referenceRate), at least 0"},
        {
            "referenceRate", "1/s", "1",
            "strain rate up to which the rate has no effect"
        },
        {
            "m", "-", "none",
            "exponent of thermal softening by the factor "
            "1 - ((T - Troom)/(Tmelt - Troom))^m"
        },
        {
            "Tmelt", "K", "with m",
            "melting point, from which the yield stress is 0"
        },
        {
            "Troom", "K", "T0",
            "with m: temperature up to which the metal does not soften"
        }
    };
}


Foam::label Foam::hardening::table::part(const scalar strain) const
{
    const auto after = std::upper_bound(strains.begin(), strains.end(), strain);
    return max(label(after - strains.begin()) - 1, label(0));
}


Foam::scalar Foam::hardening::table::increment
(
    const scalar q,
    const scalar strain,
    const scalar threeMu,
    const scalar
) const
{
    // Part by part: the trial stress falls, the curve does not
    scalar from = strain;
    for (label k = part(strain); ; ++k)
    {
        const scalar H = slope(k);
        const scalar Y = stresses[k] + H*(from - strains[k]);
        const scalar rest = q - threeMu*(from - strain);
        const scalar to = from + (rest - Y)/(threeMu + H);
        if (k + 1 >= strains.size() || to <= strains[k + 1]) return to - strain;
        from = strains[k + 1];
    }
}


Foam::scalar Foam::hardening::JohnsonCook::increment
(
    const scalar q,
    const scalar strain,
    const scalar threeMu,
    const scalar dt
) const
{
    if (dt <= 0 && C > 0) return 0;

    const auto excess = [&](const scalar d)
    {
        return q - threeMu*d - yield(strain + d)*rateFactor(d, dt);
    };

    // Falls with d, from positive at 0 to negative at q/(3 mu): regula falsi
    // with the weight of an end that stays halved
    scalar a = 0, b = q/threeMu;
    scalar fa = excess(a), fb = excess(b);
    for (int i = 0; i < mostPasses && b - a > narrowest*b; ++i)
    {
        const scalar d = (fa*b - fb*a)/(fa - fb);
        const scalar f = excess(d);
        if (mag(f) <= solved*q) return d;
        if (f > 0)
        {
            a = d;
            fa = f;
            fb *= 0.5;
        }
        else
        {
            b = d;
            fb = f;
            fa *= 0.5;
        }
    }
    return 0.5*(a + b);
}


// ************************************************************************* //
