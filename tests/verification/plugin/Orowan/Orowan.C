/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::contactLaws::Orowan

Description
    Orowan's friction, of metal forming: Coulomb's, but the shear traction is
    at most that at which the softer body yields,
    |t_t| <= min(k <-t_n>, tauMax).

    Also an example of a contact law in a library of its own: this file, and
    one line in Make/files.

Usage
    In system/controlDict:
    \verbatim
        libs (vertexContact plugin);
    \endverbatim
    In constant/contactProperties, in an interface:
    \verbatim
        law { type Orowan; frictionCoeff 0.3; tauMax 1e8; }
    \endverbatim

    \table
        Property      | Description                     | Required
        frictionCoeff | Friction coefficient k >= 0 [-] | yes
        tauMax        | Largest shear traction >= 0 [Pa] | yes
    \endtable

\*---------------------------------------------------------------------------*/

#include "contactLaw.H"
#include "dictionaryCheck.H"
#include "dimensionSets.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace contactLaws
{

class Orowan
:
    public contactLaw
{
    scalar k_;
    scalar tauMax_;

public:

    TypeName("Orowan");

    //- Of its own
    static keywordList keywords()
    {
        return
        {
            {"frictionCoeff", "-", "required", "at least 0"},
            {"tauMax", "Pa", "required", "largest shear traction, at least 0"}
        };
    }

    explicit Orowan(const dictionary& dict)
    {
        using namespace dictionaryCheck;

        onlyKeywords(dict, commonKeywords() + keywords());
        k_ = readNumber(dict, "frictionCoeff", dimless);
        require(k_ >= 0, dict, "frictionCoeff", k_, "at least 0");
        tauMax_ = readNumber(dict, "tauMax", dimPressure);
        require(tauMax_ >= 0, dict, "tauMax", tauMax_, "at least 0");
    }

    virtual void solve(UList<problem>& problems) const
    {
        using namespace acousticRiemann;

        for (problem& p : problems)
        {
            if (!p.touching)
            {
                p.result = separated(p.minus, p.plus);
                continue;
            }

            // Normal traction if they stay in contact (30b)
            const scalar pressure =
                -(stickTraction(p.minus, p.plus, p.n) & p.n);
            const scalar k =
                k_*pressure > tauMax_ ? tauMax_/pressure : k_;
            p.result = coulombContact(p.minus, p.plus, p.n, k);
        }
    }

    virtual bool sticks() const { return k_ > 0 && tauMax_ > 0; }
};


defineTypeNameAndDebug(Orowan, 0);
addListedModel(contactLaw, Orowan);

} // End namespace contactLaws
} // End namespace Foam


// ************************************************************************* //
