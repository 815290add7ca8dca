/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::fixedVelocityBoundary

Description
    Prescribed velocity of pointU: the whole vector, some components, or one
    direction (prescribedMotion). A velocity of zero clamps the surface.

    Nodes of such a patch have this velocity in the middle of each step. Their
    reaction is the remaining force (reactionForces). With \c preset \c paper
    the whole vector only, imposed through the flux of a rigid neighbour (39):
    t^B = t + [z_p n n + z_s (I - n n)] (v^B - v).

Usage
    \verbatim
        base
        {
            type       fixedVelocity;
            velocity   (0 0 0);   // [m/s], constant or any Function1 of time
        }
        slider
        {
            type       fixedVelocity;
            velocity   (0 0 0);
            components (x z);     // y is free
        }
        ramp
        {
            type       fixedVelocity;
            direction  (1 1 0);   // the rest is free
            velocity   2;         // along it
        }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "solidPointPatchField.H"
#include "prescribedMotion.H"
#include "acousticRiemann.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

class fixedVelocityBoundary
:
    public solidBoundaryCondition
{
    prescribedMotion motion_;

public:

    static keywordList keywords()
    {
        return prescribedMotion::keywords("velocity", "m/s");
    }

    fixedVelocityBoundary() = default;

    explicit fixedVelocityBoundary(const dictionary& dict)
    :
        motion_(dict, "velocity", false)
    {}

    void write(Ostream& os) const { motion_.write(os); }

    virtual const prescribedMotion* motion() const { return &motion_; }

    virtual void solve(const scalar time, cornerStates& c) const
    {
        const vector vWall = motion_.value(time);
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
