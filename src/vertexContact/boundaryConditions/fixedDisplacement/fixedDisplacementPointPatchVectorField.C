/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::fixedDisplacementBoundary

Description
    Prescribed displacement of a surface, a condition of pointU: the whole
    vector, some components, or one direction (prescribedMotion).

    In each step the nodes get the velocity that brings them from their current
    position to X + u(t) at the end of the step. So round-off does not
    accumulate, and a restarted run continues from where it was. The reaction is
    the remaining force (reactionForces). A displacement that starts abruptly
    sends a wave into the body; use a table or Function1 with smooth ends.

    At the start of the run the surface must be at X + u, to 1e-3 of its
    boundary cells: otherwise the first step would close the difference. Not
    with preset paper, whose conditions are fluxes.

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
