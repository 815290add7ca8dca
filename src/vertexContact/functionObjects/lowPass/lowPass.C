/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lowPass.H"
#include "mathematicalConstants.H"
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::lowPass::lowPass(const scalar frequency, const label nPoles)
:
    frequency_(frequency),
    omega_(constant::mathematical::twoPi*frequency),
    nPoles_(nPoles)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::lowPass::advance
(
    state& s,
    const vector& input,
    const scalar deltaT
) const
{
    const scalar a = omega_*deltaT;
    if (a <= 0) return;

    // The particular solution follows the straight line with a lag. The
    // difference from the initial state decays
    const vector slope((input - s.input)/a);
    if (nPoles_ == 1)
    {
        const vector start(s.value - s.input + slope);
        s.value = input - slope + std::exp(-a)*start;
    }
    else
    {
        const scalar b = a/std::sqrt(scalar(2));
        const scalar decay = std::exp(-b), c = std::cos(b), r = std::sin(b);
        const scalar root = std::sqrt(scalar(2));
        const vector z(s.value - s.input + root*slope);
        const vector v(s.rate - slope);
        s.value = input - root*slope + decay*(c*z + r*(z + root*v));
        s.rate = slope + decay*(c*v - r*(root*z + v));
    }
    s.input = input;
}


// ************************************************************************* //
