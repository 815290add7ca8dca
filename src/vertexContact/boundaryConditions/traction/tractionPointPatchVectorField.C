/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::tractionBoundary

Description
    Dead load on pointU: a prescribed traction per reference area, fixed in
    direction, t^B = traction(time).

Usage
    \verbatim
        end
        {
            type     traction;
            traction (0 -1e5 0);   // [Pa], constant or any Function1 of time
        }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "solidPointPatchField.H"
#include "timeValue.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

class tractionBoundary
:
    public solidBoundaryCondition
{
    timeValue<vector> traction_;

public:

    static keywordList keywords()
    {
        return
        {
            {
                "traction", "Pa", "required",
                "force per reference area; a vector, or any Function1 of "
                    "time"
            },
            {"tractionCoeffs", "", "none", "coefficients of the Function1"}
        };
    }

    tractionBoundary() = default;

    explicit tractionBoundary(const dictionary& dict)
    :
        traction_("traction", dict)
    {}

    void write(Ostream& os) const { traction_.write(os); }

    virtual vector given(const scalar time) const { return traction_(time); }

    virtual void solve(const scalar time, cornerStates& c) const
    {
        const vector t = traction_(time);
        for (label i = 0; i < c.size(); ++i)
        {
            c.setTraction(i, t);
        }
    }
};

}

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidPointPatchField(tractionBoundary, "traction")


// ************************************************************************* //
