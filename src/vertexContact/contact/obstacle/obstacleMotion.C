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
    runTime_(runTime),
    pose_(septernion::I),
    before_(septernion::I),
    after_(septernion::I)
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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::septernion Foam::obstacleMotion::poseAt(const scalar time)
{
    clock_->setTime(time, 0);
    return function_->transformation();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::obstacleMotion::setTime(const scalar time)
{
    if (!moves())
    {
        return;
    }

    // Not beyond the run, where a table may have no values
    const scalar dt = runTime_.deltaTValue();
    const scalar from =
        max(time - 0.5*dt, min(time, runTime_.startTime().value()));
    const scalar to =
        min(time + 0.5*dt, max(time, runTime_.endTime().value()));

    before_ = poseAt(from);
    after_ = poseAt(to);
    pose_ = poseAt(time);
    interval_ = max(to - from, VSMALL);
}


Foam::vector Foam::obstacleMotion::velocity(const point& X) const
{
    return
        moves()
      ? vector
        (
            (after_.transformPoint(X) - before_.transformPoint(X))/interval_
        )
      : vector(vector::zero);
}


// ************************************************************************* //
