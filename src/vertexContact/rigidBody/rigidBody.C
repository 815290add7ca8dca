/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidBody.H"
#include "principalValues.H"
#include "rigidMaterial.H"
#include "obstacleMotion.H"
#include "dictionaryCheck.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Inertia in space, from that in the reference configuration
symmTensor turned(const symmTensor& inertia, const quaternion& q)
{
    const tensor R(q.R());
    return symm(R & inertia & R.T());
}


//- Number of intervals of the run at whose ends a motion is checked
constexpr label nLooks = 16;

//- Share of a motion that may leave the directions of the mesh: a motion is
//  written with few digits
constexpr scalar leaves = 1e-6;

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

    vector is(Zero);
    for (const word& w : dict.get<wordList>(keyword))
    {
        label which = -1;
        for (label i = 0; i < 3; ++i)
        {
            if (w == vector::componentNames[i]) which = i;
        }
        if (which < 0)
        {
            dictionaryCheck::unknownModel
            (
                dict, keyword, w, wordList({"x", "y", "z"})
            );
        }
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


Foam::vector Foam::rigidBody::spin(const state& s, const vector& L) const
{
    return
        rotation_ == freedom::all ? vector(free_->inverse(s.q) & L)
      : rotation_ == freedom::axis ? vector(L/axisInertia_)
      : L;
}


Foam::scalar Foam::rigidBody::kinetic
(
    const state& s,
    const vector& P,
    const vector& L
) const
{
    const vector w(spin(s, L));
    return
        0.5*magSqr(P)/mass_.mass
      + 0.5
       *(
            rotation_ == freedom::none
          ? (w & turned(inertia_, s.q) & w)
          : (w & L)
        );
}


Foam::rigidBody::works Foam::rigidBody::powers(const motionState& v) const
{
    works p;
    p.contact =
        (contact_.force & v.velocity) + (contact_.moment & v.spin);
    p.external =
        (applied_.force & translation_ & v.velocity)
      - (contact_.force & held() & v.velocity)
      + (
            rotation_ == freedom::none
          ? -(contact_.moment & v.spin)
          : (applied_.moment & v.spin)
        );
    return p;
}


Foam::rigidBody::state Foam::rigidBody::present
(
    const scalar lastStep,
    const bool loaded
) const
{
    state s(now_);
    if (loaded)
    {
        const load l(total());
        s.P += 0.5*lastStep*(translation_ & l.force);
        s.L += freeTwist(0.5*lastStep, l.moment);
    }
    return s;
}


Foam::vector Foam::rigidBody::freeTwist
(
    const scalar by,
    const vector& moment
) const
{
    return
        rotation_ == freedom::all ? vector(by*moment)
      : rotation_ == freedom::axis ? vector(by*(moment & axis_)*axis_)
      : vector(Zero);
}


Foam::vector Foam::rigidBody::angularRate(const vector& moment) const
{
    return
        rotation_ == freedom::all ? vector(free_->inverse(now_.q) & moment)
      : rotation_ == freedom::axis
      ? vector((moment & axis_)/axisInertia_*axis_)
      : vector(Zero);
}


Foam::vector Foam::rigidBody::linear(const state& s) const
{
    state then(s);
    then.q = s.middle;
    return
        s.P + mass_.mass*(spin(then, s.L) ^ then.q.transform(toCentre_));
}


Foam::vector Foam::rigidBody::angular(const state& s) const
{
    if (rotation_ == freedom::all) return s.L;
    state then(s);
    then.q = s.middle;
    return turned(inertia_, then.q) & spin(then, s.L);
}


Foam::rigidBody::reaction Foam::rigidBody::reactionOf
(
    const load& l,
    const scalar kick
) const
{
    reaction r;
    r.impulse = dual_.projected(linear(now_) - linear(old_) - kick*l.force);
    r.twist = dual_.turning(angular(now_) - angular(old_) - kick*l.moment);

    // A pivot does no work
    if (motion_.valid())
    {
        r.work =
            0.5/mass_.mass*(r.impulse & held() & (old_.P + now_.P));
        if (rotation_ == freedom::none)
        {
            const vector none(Zero);
            r.work +=
                kinetic(now_, none, now_.L) - kinetic(old_, none, old_.L)
              - 0.5*kick*(l.moment & (old_.L + now_.L));
        }
    }
    return r;
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


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::rigidBody::~rigidBody() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::rigidBody::isHeld() const
{
    if (pivot_) return true;
    for (label i = 0; i < nDim_; ++i)
    {
        if (translation_[4*dual_.directions()[i]] < 1 - SMALL) return true;
    }
    return
        (nDim_ == 3 && rotation_ != freedom::all)
     || (nDim_ == 2 && rotation_ == freedom::none);
}


Foam::scalar Foam::rigidBody::compliance(const point& X) const
{
    const vector r(X - start_);
    scalar turning = 0;
    if (rotation_ == freedom::all)
    {
        // Compliance for the force that turns the body most
        const tensor across(*r);
        const tensor turns
        (
            across & free_->inverse(quaternion::I) & across.T()
        );
        const principalValues<3> most(turns.cdata(), 0);
        turning = max(most.value[0], max(most.value[1], most.value[2]));
    }
    else if (rotation_ == freedom::axis)
    {
        turning = magSqr(r ^ axis_)/axisInertia_;
    }
    return
        (magSqr(translation_) > SMALL ? 1/mass_.mass : 0) + turning;
}


Foam::rigidBody::motionState Foam::rigidBody::motion
(
    const scalar lastStep
) const
{
    motionState m{now_.P/mass_.mass, presentSpin()};
    if (rotation_ == freedom::all)
    {
        // The spin in the middle of the step
        m.spin += 0.5*lastStep*(free_->inverse(now_.q) & (m.spin ^ now_.L));
    }
    return m;
}


Foam::vector Foam::rigidBody::awayFromMotion
(
    const point& X,
    const scalar time
)
{
    if (!motion_.valid()) return vector::zero;

    // The distance that the next step would close: see leap()
    const septernion pose(motion_->poseAt(time));
    vector away
    (
        held() & (pose.transformPoint(start_) - start_ - now_.shift)
    );
    if (rotation_ == freedom::none)
    {
        away += (pose.r().R() - rotation()) & (X - start_);
    }
    return away;
}


Foam::rigidBody::motionState Foam::rigidBody::acceleration() const
{
    motionState a;
    a.velocity = (translation_ & applied_.force)/mass_.mass;
    a.spin = angularRate
    (
        rotation_ == freedom::all
      ? vector(applied_.moment - (presentSpin() ^ now_.L))
      : applied_.moment
    );
    return a;
}


Foam::rigidBody::motionState Foam::rigidBody::contactAcceleration() const
{
    motionState a;
    a.velocity = (translation_ & contact_.force)/mass_.mass;
    a.spin = angularRate(contact_.moment);
    return a;
}


Foam::rigidBody::motionState Foam::rigidBody::fullAcceleration
(
    const scalar lastStep
)
{
    motionState a(acceleration());
    const motionState c(contactAcceleration());
    a.velocity += c.velocity;
    a.spin += c.spin;
    if (motion_.valid() && lastStep > 0)
    {
        vector v, w;
        motion_->endOfStep(now_.time, lastStep, start_, v, w);
        a.velocity += 2/lastStep*(held() & (v - now_.P/mass_.mass));
        if (rotation_ == freedom::none) a.spin += 2/lastStep*(w - now_.L);
    }
    return a;
}


bool Foam::rigidBody::finite() const
{
    return std::isfinite(magSqr(now_.P) + magSqr(now_.L) + magSqr(now_.shift));
}


void Foam::rigidBody::setPose(const vector& shift, const tensor& rotation)
{
    now_.shift = shift;
    now_.q = quaternion(rotation);
    now_.q /= mag(now_.q);
    now_.middle = now_.q;
}


Foam::rigidBody::motionState Foam::rigidBody::freePart
(
    const motionState& v
) const
{
    return motionState{translation_ & v.velocity, freeTwist(1, v.spin)};
}


void Foam::rigidBody::setMotion(const motionState& v, const scalar time)
{
    motionState m(freePart(v));
    now_.time = time;
    if (motion_.valid())
    {
        motion_->setTime(time);
        m.velocity += held() & motion_->velocity(start_);
        if (rotation_ == freedom::none) m.spin = motion_->spin();
    }
    now_.P = mass_.mass*m.velocity;
    now_.L =
        rotation_ == freedom::all ? vector(turned(inertia_, now_.q) & m.spin)
      : rotation_ == freedom::axis ? vector(axisInertia_*m.spin)
      : m.spin;
}


void Foam::rigidBody::findLoads(const scalar time)
{
    vector f(mass_.mass*gravity_);
    if (hasForce_) f += force_(time);
    applied_.force = f;
    applied_.moment = now_.q.transform(toCentre_) ^ f;
    if (hasMoment_) applied_.moment += moment_(time);
    contact_ = load();
}


Foam::rigidBody::works Foam::rigidBody::leap
(
    const scalar time,
    const scalar deltaT,
    const scalar kick,
    const bool energy,
    reaction* reacted
)
{
    old_ = now_;
    const load l(total());
    const scalar perMass = 1/mass_.mass;

    // Momenta
    now_.P = translation_ & (now_.P + kick*l.force);
    now_.L += freeTwist(kick, l.moment);
    septernion pose(septernion::I);
    if (motion_.valid())
    {
        pose = motion_->poseAt(time + deltaT);
        const vector way(pose.transformPoint(start_) - start_ - now_.shift);
        now_.P += mass_.mass/deltaT*(held() & way);
        if (rotation_ == freedom::none)
        {
            now_.L = obstacleMotion::spin(now_.q, pose.r(), deltaT);
        }
    }
    else if (rotation_ == freedom::none)
    {
        now_.L = vector::zero;
    }

    // Works, with the orientation at which the loads act
    works sums;
    if (energy && Pstream::master())
    {
        motionState mean;
        mean.velocity = 0.5*perMass*(old_.P + now_.P);
        mean.spin = 0.5*(spin(old_, old_.L) + spin(old_, now_.L));
        sums = powers(mean);
        sums.external *= kick;
        sums.contact *= kick;
        sums.external += mean.velocity & held() & (now_.P - old_.P);
    }

    // Position
    now_.time = time + deltaT;
    now_.shift += deltaT*perMass*now_.P;
    now_.middle = now_.q;
    if (rotation_ == freedom::all)
    {
        free_->turn(now_.middle, now_.L, 0.5*deltaT);
        free_->turn(now_.q, now_.L, deltaT);
    }
    else if (rotation_ == freedom::axis)
    {
        const scalar angle = deltaT*(now_.L & axis_)/axisInertia_;
        freeRotation::turnAbout(now_.middle, axis_, 0.5*angle);
        freeRotation::turnAbout(now_.q, axis_, angle);
    }
    else if (motion_.valid())
    {
        // Half way; an arc cosine would lose digits
        const quaternion& end = pose.r();
        now_.middle +=
            (now_.q.w()*end.w() + (now_.q.v() & end.v()) < 0 ? -1.0 : 1.0)*end;
        now_.middle /= mag(now_.middle);
        now_.q = pose.r();
        if (energy && Pstream::master())
        {
            const vector none(Zero);
            sums.external +=
                kinetic(now_, none, now_.L) - kinetic(old_, none, old_.L);
        }
    }
    if (reacted) *reacted = reactionOf(l, kick);
    return sums;
}


Foam::scalar Foam::rigidBody::kineticEnergy
(
    const scalar lastStep,
    const bool loaded
) const
{
    if (!Pstream::master()) return 0;
    const state s(present(lastStep, loaded));
    return kinetic(s, s.P, s.L);
}


Foam::scalar Foam::rigidBody::swing
(
    const scalar lastStep,
    const bool loaded
) const
{
    if (!Pstream::master()) return 0;
    const state s(present(lastStep, loaded));
    return kinetic(s, s.P - now_.P, s.L - now_.L);
}


Foam::scalar Foam::rigidBody::freeKineticEnergy() const
{
    if (!Pstream::master()) return 0;
    const vector L(rotation_ == freedom::none ? vector(Zero) : now_.L);
    return kinetic(now_, translation_ & now_.P, L);
}


Foam::scalar Foam::rigidBody::heldKineticEnergy() const
{
    if (!Pstream::master()) return 0;
    const vector L(rotation_ == freedom::none ? now_.L : vector(Zero));
    return kinetic(now_, held() & now_.P, L);
}


void Foam::rigidBody::stop()
{
    now_.P = held() & now_.P;
    if (rotation_ != freedom::none) now_.L = vector::zero;
}


void Foam::rigidBody::startFromRest(const scalar half)
{
    const load all(total());
    now_.P -= half*(translation_ & all.force);
    now_.L -= freeTwist(half, all.moment);
}


Foam::rigidBody::loadBalance Foam::rigidBody::balance() const
{
    loadBalance b;
    if (!Pstream::master()) return b;
    const load all(total());
    const scalar perLength =
        std::sqrt(mass_.mass/max(tr(inertia_)/nDim_, VSMALL));
    b.unbalanced =
        mag(translation_ & all.force)
      + perLength*mag(freeTwist(1, all.moment));
    b.loads = mag(applied_.force) + mag(contact_.force);
    return b;
}


Foam::vector Foam::rigidBody::linearMomentum() const
{
    return Pstream::master() ? linear(now_) : vector(vector::zero);
}


Foam::vector Foam::rigidBody::angularMomentum() const
{
    if (!Pstream::master()) return vector::zero;

    // angular() is about the point of reference (a pivot if there is one), at
    // which the linear momentum counts
    const vector L
    (
        ((start_ + now_.shift) ^ linear(now_)) + angular(now_)
    );
    return dual_.turning(L);
}


Foam::rigidBody::works Foam::rigidBody::presentPowers() const
{
    if (!Pstream::master()) return works();
    return powers(motionState{now_.P/mass_.mass, spin(now_, now_.L)});
}


void Foam::rigidBody::write(Ostream& os) const
{
    const auto numbers = [](const quaternion& q)
    {
        return scalarList({q.w(), q.v().x(), q.v().y(), q.v().z()});
    };
    os  << "    shift " << now_.shift << ';' << nl
        << "    orientation " << flatOutput(numbers(now_.q)) << ';' << nl
        << "    middle " << flatOutput(numbers(now_.middle)) << ';' << nl
        << "    momentum " << now_.P << ';' << nl
        << "    " << (rotation_ == freedom::none ? "spin " : "angularMomentum ")
        << now_.L << ';' << nl;
}


void Foam::rigidBody::read(const dictionary& record)
{
    now_.shift = record.get<vector>("shift");
    const auto orientation = [&](const word& name)
    {
        const List<scalar> q(record.get<List<scalar>>(name));
        return quaternion(q[0], vector(q[1], q[2], q[3]));
    };
    now_.q = orientation("orientation");
    // Records of earlier versions have only one orientation
    now_.middle = orientation
    (
        record.found("middle") ? "middle" : "orientation"
    );
    now_.P = record.get<vector>("momentum");

    // The free directions may have changed since
    const bool held = record.found("spin");
    const vector L
    (
        record.get<vector>(held ? "spin" : "angularMomentum")
    );
    now_.L = held == (rotation_ == freedom::none) ? L : vector(Zero);
}


void Foam::rigidBody::report(Ostream& os) const
{
    os  << "    rigid, mass " << mass_.mass << " kg, centre of mass "
        << mass_.centre << " m, inertia about it " << mass_.inertia
        << " kg m2" << nl << "    free to translate in (";
    bool first = true;
    for (label i = 0; i < 3; ++i)
    {
        if (translation_[4*i] > 0.5)
        {
            os  << (first ? "" : " ") << vector::componentNames[i];
            first = false;
        }
    }
    os  << "), to turn about ";
    if (rotation_ == freedom::all) os << "all axes";
    else if (rotation_ == freedom::axis) os << "the axis " << axis_;
    else os << "no axis";
    if (pivot_) os << ", pivot " << start_;
    os  << "; force " << (hasForce_ ? "on" : "off")
        << ", moment " << (hasMoment_ ? "on" : "off")
        << ", motion " << (motion_.valid() ? "on" : "off");
}


// ************************************************************************* //
