/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "obstacleMotion.H"
#include "IStringStream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::obstacleMotion::obstacleMotion
(
    const dictionary& dict,
    const Time& runTime
)
:
    runTime_(runTime)
{
    if (dict.found("motion"))
    {
        clock_.reset
        (
            new Time
            (
                dictionary
                (
                    IStringStream
                    (
                        "startFrom startTime; startTime 0; endTime 1;"
                        "deltaT 1; writeControl timeStep; writeInterval 1;"
                    )()
                ),
                runTime.rootPath(), runTime.caseName(),
                "system", "constant", false, false
            )
        );
        function_ =
            solidBodyMotionFunction::New(dict.subDict("motion"), *clock_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::septernion Foam::obstacleMotion::pose(const scalar time) const
{
    if (!moves())
    {
        return septernion::I;
    }
    clock_->setTime(time, 0);
    return function_->transformation();
}


Foam::vector Foam::obstacleMotion::velocity
(
    const scalar time,
    const point& x
) const
{
    if (!moves())
    {
        return vector::zero;
    }

    // Not beyond the run, where a table may have no values
    const scalar dt = runTime_.deltaTValue();
    const scalar from =
        max(time - 0.5*dt, min(time, runTime_.startTime().value()));
    const scalar to =
        min(time + 0.5*dt, max(time, runTime_.endTime().value()));

    const point X(pose(time).invTransformPoint(x));
    return
        (pose(to).transformPoint(X) - pose(from).transformPoint(X))
       /max(to - from, VSMALL);
}


// ************************************************************************* //
