/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::pressureBoundary

Description
    Follower load on pointU: a pressure on the current surface. In the default
    scheme it acts on the deformed faces (variationalBody, addPressure). In the
    paper's scheme the deformation gradient of the nodes gives the current
    surface:
    t^B = -p |H N| n = -p H N per reference area (Nanson's rule).

Usage
    \verbatim
        inside
        {
            type     pressure;
            pressure 2e5;   // [Pa], constant or any Function1 of time
        }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "solidPointPatchField.H"
#include "timeValue.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

class pressureBoundary
:
    public solidBoundaryCondition
{
    timeValue<scalar> pressure_;

public:

    static keywordList keywords()
    {
        return
        {
            {
                "pressure", "Pa", "required",
                "acts on the current surface and pushes if positive; a "
                    "number, or any Function1 of time"
            },
            {"pressureCoeffs", "", "none", "coefficients of the Function1"}
        };
    }

    pressureBoundary() = default;

    explicit pressureBoundary(const dictionary& dict)
    :
        pressure_("pressure", dict)
    {}

    void write(Ostream& os) const { pressure_.write(os); }

    virtual bool isPressure() const { return true; }

    virtual scalar pressure(const scalar time) const { return pressure_(time); }

    virtual void solve(const scalar time, cornerStates& c) const
    {
        const scalar p = pressure_(time);
        for (label i = 0; i < c.size(); ++i)
        {
            c.setTraction(i, (-p*c.stretch[i])*c.n[i]);
        }
    }
};

}

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidPointPatchField(pressureBoundary, "pressure")


// ************************************************************************* //
