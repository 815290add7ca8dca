/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::contactLaws::tied

Description
    Bonded surfaces: the contact-stick condition (34) whatever the traction,
    from the start and across whatever gap the meshes have.

\*---------------------------------------------------------------------------*/

#include "contactLaw.H"
#include "dictionaryCheck.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace contactLaws
{

class tied
:
    public contactLaw
{
public:

    TypeName("tied");

    //- Of its own
    static keywordList keywords() { return keywordList(); }

    explicit tied(const dictionary& dict)
    {
        dictionaryCheck::onlyKeywords(dict, commonKeywords());
    }

    virtual void solve(UList<problem>& problems) const
    {
        using namespace acousticRiemann;

        for (problem& p : problems) p.result = stuck(p.minus, p.plus, p.n);
    }

    virtual bool bonded() const { return true; }
};


defineTypeNameAndDebug(tied, 0);
addListedModel(contactLaw, tied);

} // End namespace contactLaws
} // End namespace Foam


// ************************************************************************* //
