/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidBody.H"
#include "rigidMaterial.H"
#include "obstacleMotion.H"
#include "dictionaryCheck.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Number of intervals of the run at whose ends a motion is checked
constexpr label nLooks = 16;

constexpr scalar leaves = medianDual::leaves;

//- FatalIOError for a translation along directions that are free: it would be
//  ignored. A motion that turns the body gives them its rotation only
void checkHeld
(
    const septernion& pose,
    const scalar time,
    const tensor& free,
    const dictionary& dict
)
{
    if (mag(pose.r().v()) > SMALL) return;
    const vector way(pose.transformPoint(point::zero));
    if (mag(free & way) > leaves*mag(way))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'motion' moves the body by " << way << " m until time "
            << time << " s, also in directions in which it is free: "
            << "'freeTranslation' "
            << dict.getOrDefault("freeTranslation", wordList())
            << ". Leave them out of one of the two" << exit(FatalIOError);
    }
}


//- FatalIOError for a motion that takes a point off a mirror, or turns a mirror
void checkMirrors
(
    const septernion& pose,
    const scalar time,
    const vector& way,
    const vectorField& mirrors,
    const dictionary& dict
)
{
    for (const vector& n : mirrors)
    {
        const vector turned(pose.r().R() & n);
        if (mag(way & n) > leaves*mag(way) || mag(turned - n) > leaves)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'motion' moves or turns the body off its mirror "
                << "(slip, symmetryPlane or symmetry) with the normal " << n
                << ", at time " << time << " s" << exit(FatalIOError);
        }
    }
}


//- FatalIOError for a motion that takes a point and its surroundings out of the
//  directions that the mesh solves, along those that are free, or off a mirror
void checkMotion
(
    obstacleMotion& motion,
    const point& start,
    const medianDual& dual,
    const tensor& free,
    const vectorField& mirrors,
    const dictionary& dict
)
{
    const Time& runTime = dual.mesh().time();
    const scalar begin = runTime.value();
    const scalar left = max(runTime.endTime().value() - begin, scalar(0));
    for (label look = 0; look <= nLooks; ++look)
    {
        const scalar time = begin + left*look/nLooks;
        const septernion pose(motion.poseAt(time));
        const vector way(pose.transformPoint(start) - start);
        checkHeld(pose, time, free, dict);
        checkMirrors(pose, time, way, mirrors, dict);
        if (dual.nDim() == 3) continue;

        bool inside = mag(way - dual.projected(way)) <= leaves*mag(way);
        for (direction i = 0; i < vector::nComponents; ++i)
        {
            // Solved directions stay in the mesh, the others do not turn
            vector e(Zero);
            e[i] = 1;
            const bool solved = mag(dual.projected(e)) > 0;
            const vector now(pose.r().R() & e);
            const vector out
            (
                solved ? vector(now - dual.projected(now)) : vector(now - e)
            );
            inside = inside && mag(out) <= leaves;
        }
        if (!inside)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'motion' moves or turns the body out of the "
                << dual.nDim() << " directions of the mesh, at time " << time
                << " s" << exit(FatalIOError);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::rigidBody::readDirections
(
    const dictionary& dict,
    const word& keyword,
    const bool all
) const
{
    if (!dict.found(keyword)) return all ? vector::one : vector::zero;

    const wordList valid({"x", "y", "z"});
    vector is(Zero);
    for (const word& w : dict.get<wordList>(keyword))
    {
        const label which = valid.find(w);
        if (which < 0) dictionaryCheck::unknownModel(dict, keyword, w, valid);
        is[which] = 1;
    }
    return is;
}


void Foam::rigidBody::readFreedoms
(
    const dictionary& dict,
    const vectorField& mirrors
)
{
    const bool moved = dict.found("motion");
    const vector translates
    (
        readDirections(dict, "freeTranslation", !moved && !pivot_)
    );
    const vector turns(readDirections(dict, "freeRotation", !moved));
    if (pivot_ && mag(translates) > 0)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'freeTranslation' is "
            << dict.get<wordList>("freeTranslation")
            << ", but with 'pivot' the body only turns: it must be ()"
            << exit(FatalIOError);
    }
    if (pivot_ && moved)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'motion' does not work with 'pivot', a point that does "
            << "not move" << exit(FatalIOError);
    }

    // Solved directions
    const vector solved(dual_.projected(vector::one));
    translation_ = tensor::zero;
    label nAxes = 0;
    axis_ = vector::zero;
    for (label i = 0; i < 3; ++i)
    {
        if (solved[i] > 0 && translates[i] > 0) translation_[4*i] = 1;

        const bool possible =
            nDim_ == 3 || (nDim_ == 2 && solved[i] == 0);
        if (possible && turns[i] > 0)
        {
            ++nAxes;
            axis_[i] = 1;
        }
    }
    const auto requireSome = [&]
    (
        const word& key,
        const vector& given,
        const bool some
    )
    {
        if (some || cmptMax(given) <= 0 || !dict.found(key)) return;
        FatalIOErrorInFunction(dict)
            << "Keyword '" << key << "' is " << dict.get<wordList>(key)
            << ": none of these can be free in a mesh of " << nDim_
            << " directions" << exit(FatalIOError);
    };
    requireSome("freeRotation", turns, nAxes > 0);
    requireSome("freeTranslation", translates, mag(translation_) > 0);
    if (nAxes == 2)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'freeRotation' is "
            << dict.get<wordList>("freeRotation")
            << ": rotation may be free about all axes (x y z), about one, or "
            << "about none ()" << exit(FatalIOError);
    }
    rotation_ =
        nAxes == 3 ? freedom::all
      : nAxes == 1 ? freedom::axis
      : freedom::none;

    // Mirrors do not move
    for (const vector& n : mirrors)
    {
        // The free translation that the mirror takes away
        const vector across(translation_ & n);
        if (mag(across) > SMALL)
        {
            translation_ -= across*across/magSqr(across);
        }
        if (rotation_ == freedom::all)
        {
            rotation_ = freedom::axis;
            axis_ = n;
        }
        else if (rotation_ == freedom::axis && mag(axis_ & n) < alongAxis)
        {
            rotation_ = freedom::none;
        }
    }

    if (rotation_ == freedom::all)
    {
        free_.reset(new freeRotation(inertia_));
    }
    else if (rotation_ == freedom::axis)
    {
        axisInertia_ = axis_ & inertia_ & axis_;
        if (!(axisInertia_ > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'inertia' is " << mass_.inertia
                << ": the body turns about the axis " << axis_
                << ", and its inertia about this axis must be positive"
                << exit(FatalIOError);
        }
    }

    if (moved && rotation_ != freedom::none && !motion_->translates())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'freeRotation' is not (), but the "
            << "'solidBodyMotionFunction' of 'motion' prescribes the rotation. "
            << "These motions do not: (displacement velocity)"
            << exit(FatalIOError);
    }

    // A pure translation causes no rotation, held or not
    const bool mayTurn = moved && nDim_ > 1 && !motion_->translates();
    if (moved && !mayTurn && 2*tr(translation_) > 2*nDim_ - 1)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'motion' moves the body in directions that are not "
            << "free, but 'freeTranslation' "
            << dict.get<wordList>("freeTranslation") << " has all directions. "
            << "Leave out those of the motion" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidBody::rigidBody
(
    const dictionary& dict,
    const medianDual& dual,
    const vectorField& mirrors
)
:
    dual_(dual),
    nDim_(dual.nDim()),
    mass_(dict, dual),
    start_(mass_.centre)
{
    dictionaryCheck::onlyKeywords
    (
        dict, keywordList({{"type", "", "", ""}}) + rigidMaterial::keywords()
    );
    if (dict.found("pivot"))
    {
        pivot_ = true;
        start_ = dual.projected(dict.get<point>("pivot"));
    }
    toCentre_ = mass_.centre - start_;
    inertia_ = mass_.about(start_);
    if (dict.found("motion"))
    {
        motion_.reset(new obstacleMotion(dict, dual.mesh()));
    }
    readFreedoms(dict, mirrors);
    if (motion_.valid())
    {
        checkMotion(motion_(), start_, dual, translation_, mirrors, dict);
    }

    hasForce_ = dict.found("force");
    if (hasForce_)
    {
        force_ = timeValue<vector>("force", dict);
        dictionaryCheck::warnLeftOut
        (
            dict.name(), "force", dual.mesh().time(), force_,
            [&](const vector& f) { return dual.projected(f); }
        );
    }
    hasMoment_ = dict.found("moment");
    if (hasMoment_)
    {
        moment_ = timeValue<vector>("moment", dict);
        dictionaryCheck::warnLeftOut
        (
            dict.name(), "moment", dual.mesh().time(), moment_,
            [&](const vector& m) { return dual.turning(m); }
        );
    }
}


// ************************************************************************* //
