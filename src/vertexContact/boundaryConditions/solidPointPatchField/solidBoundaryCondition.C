/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBoundaryCondition.H"
#include "prescribedMotion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineModelKeywords(solidBoundaryCondition);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::solidBoundaryCondition::mirrorNames()
{
    return wordList({"slip", "symmetryPlane", "symmetry", "empty"});
}


Foam::wordList Foam::solidBoundaryCondition::names()
{
    wordList all(keywordsOfModelMemberFunctionTablePtr_->toc());
    all.append(mirrorNames());
    Foam::sort(all);
    return all;
}


Foam::keywordList Foam::solidBoundaryCondition::commonKeywords()
{
    return
    {
        {"type", "", "required", "name of the boundary condition"},
        {
            "patchType", "", "none",
            "keyword of OpenFOAM: type of a patch with a constraint"
        },
        {"value", "m/s", "none", "not used; the run computes the velocity"}
    };
}


Foam::vector Foam::solidBoundaryCondition::given(const scalar time) const
{
    return
        motion() && motion()->complete() ? motion()->value(time)
      : vector(Zero);
}


// ************************************************************************* //
