/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "obstacleMotion.H"
#include "dictionaryCheck.H"
#include "functionIntegral.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Round-off of a computed pose, and resolution of an interval of time
constexpr scalar roundOff = 1e-14, resolved = 1e-8;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::obstacleMotion::obstacleMotion
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    start_(mesh.time().controlDict().getOrDefault<scalar>("startTime", 0)),
    time_(mesh.time()),
    size_(max(mag(mesh.bounds().min()), mag(mesh.bounds().max()))),
    pose_(septernion::I),
    before_(septernion::I),
    after_(septernion::I)
{
    if (dict.found("motion"))
    {
        const dictionary& motion =
            dictionaryCheck::subDict(dict, "motion", "velocity (0 0 1);");
        label nGiven = 0;
        for (const word w : {"displacement", "velocity"})
        {
            if (!motion.found(w)) continue;
            ++nGiven;
            dictionaryCheck::onlyKeywords(motion, keywords());
            translation_ = dictionaryCheck::readFunction<vector>(w, motion);
            velocity_ = w == "velocity";
            if (velocity_)
            {
                functionIntegral::check
                (
                    motion, w, *translation_, "'displacement', or a function"
                );
            }
        }
        if (motion.found("solidBodyMotionFunction")) ++nGiven;
        if (nGiven != 1)
        {
            FatalIOErrorInFunction(motion)
                << "Keyword 'motion': there must be exactly one of "
                << "(displacement velocity solidBodyMotionFunction), but "
                << nGiven << " are given" << exit(FatalIOError);
        }
        if (translation_.valid()) return;

        function_.reset(new motionFunction(motion, time_));

        // Fail before the first step, not in the middle of the run
        function_->checkPose(start_);
        function_->checkPose(time_.endTime().value());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::obstacleMotion::keywords()
{
    return
    {
        {
            "displacement", "m", "one of three",
            "of all points: a vector, or any Function1 of time"
        },
        {"displacementCoeffs", "", "none", "coefficients of the Function1"},
        {
            "velocity", "m/s", "one of three",
            "of all points: a vector, or a Function1 of time that OpenFOAM can "
            "integrate"
        },
        {"velocityCoeffs", "", "none", "coefficients of the Function1"},
        {
            "solidBodyMotionFunction", "", "one of three",
            "name of a motion of OpenFOAM, beside its coefficients; not "
            "drivenLinearMotion"
        }
    };
}


Foam::septernion Foam::obstacleMotion::poseAt(const scalar time)
{
    if (translation_.valid())
    {
        // x = X - t
        return septernion
        (
            velocity_
          ? vector(-functionIntegral::to(*translation_, time))
          : vector(-translation_->value(time))
        );
    }
    return function_->poseAt(time);
}


void Foam::obstacleMotion::setTime(const scalar time)
{
    if (!moves()) return;

    if (velocity_)
    {
        pose_ = before_ = after_ = poseAt(time);
        rate_ = translation_->value(time);
        return;
    }

    // No times before the start, where a table may have no values. Nothing may
    // depend on where a run was continued, or on the length of the run
    pose_ = poseAt(time);
    const scalar least =
        given_ > 0 ? given_ : max(resolved*mag(time), SMALL);
    const bool first = time - least < start_;
    interval_ = given_ > 0 ? given_ : straight(time, least, first);
    before_ = first ? pose_ : poseAt(time - interval_);
    after_ = first ? poseAt(time + interval_) : pose_;
}


Foam::scalar Foam::obstacleMotion::straight
(
    const scalar time,
    const scalar least,
    const bool first
)
{
    constexpr scalar longer = 4;
    const auto at = [&](const scalar interval)
    {
        return poseAt(first ? time + interval : time - interval);
    };
    const scalar most =
        first ? time_.endTime().value() - time : time - start_;
    septernion near(at(least));
    scalar interval = least;
    for (; longer*interval <= most; interval *= longer)
    {
        const septernion far(at(longer*interval));
        bool bent = false, rough = false, moved = false;
        const auto look = [&]
        (
            const vector& a,
            const vector& b,
            const vector& c,
            const scalar size
        )
        {
            const scalar way = mag(c - a);
            const scalar noise =
                roundOff
               *(size + mag(a) + way*(1 + mag(time)/(longer*interval)));
            bent = bent || mag((c - a) - longer*(b - a)) > noise;
            rough = rough || (way > 0 && noise > resolved*way);
            moved = moved || way > 0;
        };
        look(pose_.t(), near.t(), far.t(), size_);
        look(pose_.r().v(), near.r().v(), far.r().v(), 1);
        if (bent || (moved && !rough)) break;
        near = far;
    }
    return
        first ? (time + interval) - time : time - (time - interval);
}


Foam::vector Foam::obstacleMotion::velocity(const point& X) const
{
    return
        velocity_ ? rate_
      : moves()
      ? vector
        (
            (after_.transformPoint(X) - before_.transformPoint(X))/interval_
        )
      : vector(vector::zero);
}


Foam::vector Foam::obstacleMotion::spin() const
{
    return moves() ? spin(before_.r(), after_.r(), interval_) : vector(Zero);
}


void Foam::obstacleMotion::endOfStep
(
    const scalar time,
    const scalar step,
    const point& X,
    vector& velocity,
    vector& spin
)
{
    const scalar half = 0.5*step;
    const septernion end(poseAt(time));
    const septernion middle(poseAt(max(start_, time - half)));
    const septernion begin(poseAt(max(start_, time - step)));
    const point x(middle.transformPoint(X));

    // The straight line through the means of both halves, at its end
    constexpr scalar ofSecond = 1.5, ofFirst = 0.5;
    spin =
        ofSecond*obstacleMotion::spin(middle.r(), end.r(), half)
      - ofFirst*obstacleMotion::spin(begin.r(), middle.r(), half);
    velocity =
        velocity_
      ? translation_->value(time)
      : vector
        (
            ofSecond/half*(end.transformPoint(X) - x)
          - ofFirst/half*(x - begin.transformPoint(X))
        );
}


Foam::vector Foam::obstacleMotion::spin
(
    const quaternion& before,
    const quaternion& after,
    const scalar interval
)
{
    quaternion turn(after*conjugate(before));
    if (turn.w() < 0) turn = quaternion(-turn.w(), -turn.v());
    const scalar s = mag(turn.v());
    return
        s > 0
      ? vector((2*std::atan2(s, turn.w())/(s*interval))*turn.v())
      : vector(vector::zero);
}


// ************************************************************************* //
