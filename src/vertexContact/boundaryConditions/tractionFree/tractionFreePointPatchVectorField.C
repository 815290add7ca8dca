/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::tractionFreeBoundary

Description
    Traction-free surface of pointU (44): t^B = 0, and the surface moves with
    its nodes.

Usage
    \verbatim
        sides { type tractionFree; }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "solidPointPatchField.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

class tractionFreeBoundary
:
    public solidBoundaryCondition
{
public:

    tractionFreeBoundary() = default;

    explicit tractionFreeBoundary(const dictionary&) {}

    virtual bool tractionFree() const { return true; }
};

}

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidPointPatchField(tractionFreeBoundary, "tractionFree")


// ************************************************************************* //
