/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::fixedVelocityBoundary

Description
    Prescribed velocity of pointU, imposed through the flux of a rigid
    neighbour (39): t^B = t + [z_p n n + z_s (I - n n)] (v^B - v).
    A velocity of zero clamps the surface.

Usage
    \verbatim
        base
        {
            type     fixedVelocity;
            velocity (0 0 0);   // [m/s], constant or any Function1 of time
        }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "solidPointPatchField.H"
#include "timeValue.H"
#include "acousticRiemann.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

class fixedVelocityBoundary
{
    timeValue<vector> velocity_;

public:

    static keywordList keywords()
    {
        return
        {
            {
                "velocity", "m/s", "required",
                "vector, or any Function1 of time"
            },
            {"velocityCoeffs", "", "none", "coefficients of the Function1"}
        };
    }

    fixedVelocityBoundary() = default;

    explicit fixedVelocityBoundary(const dictionary& dict)
    :
        velocity_("velocity", dict)
    {}

    void write(Ostream& os) const { velocity_.write(os); }

    bool tractionFree() const { return false; }

    bool contact() const { return false; }

    vector velocity(const scalar time) const { return velocity_(time); }

    void solve(const scalar time, cornerStates& c) const
    {
        const vector vWall = velocity_(time);
        for (label i = 0; i < c.size(); ++i)
        {
            const acousticRiemann::side body
            {
                c.v[i], c.t[i], c.waveFactor[i]*c.zp, c.waveFactor[i]*c.zs
            };
            c.tB[i] = acousticRiemann::rigidTraction(body, vWall, c.n[i]);
            c.vB[i] = vWall;
        }
    }
};

}

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidPointPatchField(fixedVelocityBoundary, "fixedVelocity")


// ************************************************************************* //
