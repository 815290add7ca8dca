/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::contactBoundary

Description
    Surface of pointU that takes part in the contact interfaces of
    constant/contactProperties; traction free where and while it touches
    nothing.

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
{
public:

    static keywordList keywords() { return keywordList(); }

    contactBoundary() = default;

    explicit contactBoundary(const dictionary&) {}

    void write(Ostream&) const {}

    bool tractionFree() const { return false; }

    bool contact() const { return true; }

    void solve(const scalar, cornerStates& c) const { c.setFree(); }
};

}

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidPointPatchField(contactBoundary, "contact")


// ************************************************************************* //
