/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::contactLaws::frictionless

Description
    Contact-slip without friction, (40)-(43) with k = 0; separation (44)-(49)
    where the trial traction (30b) is tensile.

\*---------------------------------------------------------------------------*/

#include "contactLaw.H"
#include "dictionaryCheck.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace contactLaws
{

class frictionless
:
    public contactLaw
{
public:

    TypeName("frictionless");

    //- Of its own
    static keywordList keywords() { return keywordList(); }

    explicit frictionless(const dictionary& dict)
    {
        dictionaryCheck::onlyKeywords(dict, commonKeywords());
    }

    virtual void solve(UList<problem>& problems) const
    {
        using namespace acousticRiemann;

        for (problem& p : problems)
        {
            p.result =
                p.touching
              ? coulombContact(p.minus, p.plus, p.n, 0)
              : separated(p.minus, p.plus);
            if (p.result.state == status::stick)
            {
                // A trial without shear: nothing distinguishes stick and slip
                p.result = sliding(p.minus, p.plus, p.n, 0);
            }
        }
    }
};


defineTypeNameAndDebug(frictionless, 0);
addListedModel(contactLaw, frictionless);

} // End namespace contactLaws
} // End namespace Foam


// ************************************************************************* //
