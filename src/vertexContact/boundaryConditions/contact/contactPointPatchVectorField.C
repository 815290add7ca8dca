/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::contactBoundary

Description
    Surface of pointU that takes part in the contact interfaces of
    constant/contactProperties. It is traction free wherever it touches nothing.

Usage
    \verbatim
        right { type contact; }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "solidPointPatchField.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

class contactBoundary
:
    public solidBoundaryCondition
{
public:

    contactBoundary() = default;

    explicit contactBoundary(const dictionary&) {}

    virtual bool contact() const { return true; }
};

}

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidPointPatchField(contactBoundary, "contact")


// ************************************************************************* //
