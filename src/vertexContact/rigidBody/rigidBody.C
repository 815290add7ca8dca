/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidBody.H"
#include "principalValues.H"
#include "obstacleMotion.H"

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

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


Foam::rigidBody::motionState Foam::rigidBody::accelerationBy
(
    const load& l
) const
{
    return
    {
        (translation_ & l.force)/mass_.mass,
        rotation_ == freedom::all ? vector(free_->inverse(now_.q) & l.moment)
      : rotation_ == freedom::axis
      ? vector((l.moment & axis_)/axisInertia_*axis_)
      : vector(Zero)
    };
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
    load l(applied_);
    if (rotation_ == freedom::all) l.moment -= presentSpin() ^ now_.L;
    return accelerationBy(l);
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
