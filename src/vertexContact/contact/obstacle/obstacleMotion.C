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
    start_(runTime.controlDict().getOrDefault<scalar>("startTime", 0)),
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

    // Not before the start nor beyond the end, where a table may have no
    // values; and nothing that depends on where a run was continued
    const bool first = time - interval_ < start_;
    pose_ = poseAt(time);
    before_ = first ? pose_ : poseAt(time - interval_);
    after_ = first ? poseAt(time + interval_) : pose_;
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
