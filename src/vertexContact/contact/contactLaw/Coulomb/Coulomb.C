/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::contactLaws::Coulomb

Description
    Algorithm 1: stick, slip and separation with Coulomb friction, with the
    friction direction that dissipates (see acousticRiemann).

Usage
    \table
        Property      | Description                   | Required
        frictionCoeff | Friction coefficient k >= 0 [-] | yes
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

public:

    TypeName("Coulomb");

    //- Of its own
    static keywordList keywords()
    {
        return
        {
            {"frictionCoeff", "-", "required", "at least 0"}
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
    }

    virtual void solve(UList<problem>& problems) const
    {
        using namespace acousticRiemann;

        for (problem& p : problems)
        {
            p.result =
                p.touching
              ? coulombContact(p.minus, p.plus, p.n, k_)
              : separated(p.minus, p.plus, p.n);
        }
    }
};


defineTypeNameAndDebug(Coulomb, 0);
addListedModel(contactLaw, Coulomb);

} // End namespace contactLaws
} // End namespace Foam


// ************************************************************************* //
