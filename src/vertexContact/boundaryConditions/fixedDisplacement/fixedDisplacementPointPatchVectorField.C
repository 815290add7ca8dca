/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::fixedDisplacementBoundary

Description
    Prescribed displacement of a surface, a condition of pointU: all of it, some
    components, or what is along a direction (prescribedMotion).

    In each step the nodes have the velocity that brings them from where they
    are to X + u(t) at its end: round-off does not add up, and a run that is
    restarted goes on from there. Their reaction is the force that is left
    (reactionForces). A displacement that starts with a jolt makes a wave: a
    table with smooth ends, or Function1's of that kind, do not.

    Where the surface is at the start of the run has to be u then, to 1e-3 of
    its boundary cells: a jump would be a step's. Not with preset paper, whose
    conditions are fluxes.

Usage
    \verbatim
        top
        {
            type         fixedDisplacement;
            displacement table ((0 (0 0 0)) (1e-3 (0 0 -1e-3)));    // [m]
            components   (z);   // x and y are free; default: all
        }
        jaw
        {
            type         fixedDisplacement;
            direction    (1 1 0);
            displacement table ((0 0) (1e-3 -1e-3));    // along it
        }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "solidPointPatchField.H"
#include "prescribedMotion.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

class fixedDisplacementBoundary
:
    public solidBoundaryCondition
{
    prescribedMotion motion_;

public:

    static keywordList keywords()
    {
        return prescribedMotion::keywords("displacement", "m");
    }

    fixedDisplacementBoundary() = default;

    explicit fixedDisplacementBoundary(const dictionary& dict)
    :
        motion_(dict, "displacement", true)
    {}

    void write(Ostream& os) const { motion_.write(os); }

    virtual const prescribedMotion* motion() const { return &motion_; }
};

}

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidPointPatchField(fixedDisplacementBoundary, "fixedDisplacement")


// ************************************************************************* //
