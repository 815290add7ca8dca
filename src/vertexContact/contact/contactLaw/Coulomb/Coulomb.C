/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::contactLaws::Coulomb

Description
    Algorithm 1: stick, slip and separation with Coulomb friction, with the
    friction direction that dissipates (see acousticRiemann).

    What sticks begins to slip at the static coefficient k_s. What slips with
    the speed v has
    \f[
        k(v) = k + (k_s - k) e^{-\lambda v}
    \f]
    which without a decay \f$\lambda\f$ is k at any speed.

    Throws FatalIOError for numbers that are missing or out of their range.

Usage
    \table
        Property            | Description                         | Default
        frictionCoeff       | Coefficient k >= 0 of sliding friction [-] <!--
                            -->                                | required
        staticFrictionCoeff | Coefficient k_s >= k that ends sticking [-] <!--
                            -->                                | frictionCoeff
        frictionDecay       | lambda > 0 [s/m]             | at once, infinite
    \endtable

\*---------------------------------------------------------------------------*/

#include "contactLaw.H"
#include "dictionaryCheck.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace contactLaws
{

class Coulomb
:
    public contactLaw
{
    scalar k_;
    scalar kStatic_;

    //- 0: at once
    scalar decay_;

public:

    TypeName("Coulomb");

    //- Of its own
    static keywordList keywords()
    {
        return
        {
            {
                "frictionCoeff", "-", "required",
                "coefficient of sliding friction, at least 0"
            },
            {
                "staticFrictionCoeff", "-", "frictionCoeff",
                "coefficient at which sticking ends, at least frictionCoeff"
            },
            {
                "frictionDecay", "s/m", "at once",
                "above 0: sliding friction falls to frictionCoeff as "
                "exp(-frictionDecay speed)"
            }
        };
    }

    explicit Coulomb(const dictionary& dict)
    {
        dictionaryCheck::onlyKeywords
        (
            dict, commonKeywords() + keywords()
        );
        k_ = dictionaryCheck::readNumber(dict, "frictionCoeff", dimless);
        dictionaryCheck::require
        (
            k_ >= 0, dict, "frictionCoeff", k_, "at least 0"
        );
        kStatic_ = k_;
        if (dict.found("staticFrictionCoeff"))
        {
            kStatic_ = dictionaryCheck::readNumber
            (
                dict, "staticFrictionCoeff", dimless
            );
            dictionaryCheck::require
            (
                kStatic_ >= k_, dict, "staticFrictionCoeff", kStatic_,
                "at least frictionCoeff"
            );
        }
        decay_ = 0;
        if (dict.found("frictionDecay"))
        {
            decay_ = dictionaryCheck::readNumber
            (
                dict, "frictionDecay", dimTime/dimLength
            );
            dictionaryCheck::require
            (
                decay_ > 0, dict, "frictionDecay", decay_, "more than 0"
            );
        }
    }

    virtual void solve(UList<problem>& problems) const
    {
        using namespace acousticRiemann;

        for (problem& p : problems)
        {
            p.result =
                p.touching
              ? coulombContact(p.minus, p.plus, p.n, kStatic_)
              : separated(p.minus, p.plus);
            if (kStatic_ > k_ && p.result.state == status::slip)
            {
                const scalar share =
                    decay_ > 0
                  ? std::exp
                    (
                       -decay_
                       *mag(tangential(p.result.vPlus - p.result.vMinus, p.n))
                    )
                  : 0;
                p.result = sliding
                (
                    p.minus, p.plus, p.n, k_ + share*(kStatic_ - k_)
                );
            }
        }
    }

    virtual bool sticks() const { return kStatic_ > 0; }
};


defineTypeNameAndDebug(Coulomb, 0);
addListedModel(contactLaw, Coulomb);

} // End namespace contactLaws
} // End namespace Foam


// ************************************************************************* //
