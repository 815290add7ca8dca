/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidRegion.H"
#include "solidBoundaryCondition.H"
#include "fileError.H"
#include "regionFiles.H"
#include "Time.H"
#include <functional>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Share of the squares of velocities at the start, and of displacements, that
//  may be other than rigid motion: they are written with six digits
constexpr Foam::scalar largestLost = 2.5e-11;

//- The polar decomposition ends at this square of a change: round-off of nine
//  components. Then its largest number of passes: it converges from everywhere
constexpr Foam::scalar turnedEnough = 1e-30;
constexpr Foam::label mostTurns = 100;

//- Steps per radian: contact, found at the start of a step, acts where it was
//  found, but for a twentieth of the lever
constexpr Foam::scalar stepsPerTurn = 3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::kinematicSet Foam::rigidRegion::kinematicsOf
(
    const schemeOptions&,
    const materialModel&
)
{
    return kinematicSet::F;
}


void Foam::rigidRegion::makeRigid()
{
    const dictionary dict(regionFiles::material(mesh_));
    if (!data_.variational)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'type' is rigid, which does not work with preset paper"
            << exit(FatalIOError);
    }
    if (regionFiles::bodyForces(mesh_).size())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'type' is rigid, but the region has bodyForces. Use "
            << "the keyword 'force' of this file instead"
            << exit(FatalIOError);
    }
    for (const dualPatch& patch : dual_.patches())
    {
        const label patchi = patch.patchIndex;
        if (!corners_.set(patchi) || condition(patchi).contact()) continue;
        FatalFileErrorInFunction(pointUFile_)
            << "Keyword 'boundaryField': patch '"
            << mesh_.boundaryMesh()[patchi].name() << "' of the rigid region '"
            << name_ << "' has the type '"
            << pointU_.boundaryField()[patchi].type()
            << "'. Valid types: (contact tractionFree); forces and motions "
            << "are given in mechanicalProperties" << exit(FatalIOError);
    }

    // One normal per mirror
    DynamicList<vector> normals;
    for (const dualPatch& patch : dual_.patches())
    {
        if (!mirrorPatches_.found(patch.patchIndex)) continue;
        const vector n(dual_.areaVector(patch));
        if (mag(n) > 0) normals.append(n/mag(n));
    }
    rigid_.reset(new rigidBody(dict, dual_, vectorField(normals)));

    // The largest area on which contact may press
    scalar area = 0;
    for (const label patchi : contactPatches())
    {
        area += sum(corners_[patchi].geometry.cornerArea);
    }
    reduce(area, sumOp<scalar>());
    forAll(corners_, patchi)
    {
        if (!corners_.set(patchi)) continue;
        const dualPatch& patch = corners_[patchi].geometry;
        scalarField& compliance = surfaces_[patchi].compliance;
        compliance.setSize(patch.nCorners());
        forAll(compliance, k)
        {
            compliance[k] =
                data_.rho*area
               *rigid_->compliance(dual_.position(patch.cornerNode[k]));
        }
    }
}


void Foam::rigidRegion::fitRigid()
{
    const label d = dual_.nDim();

    // Means, and sums about them, of this rank's share
    scalar mass = 0;
    vector meanX(Zero), meanU(Zero), meanV(Zero);
    const auto displacement = [&](const label a)
    {
        return expand(data_.state.disp.cdata() + a*d);
    };
    const auto speed = [&](const label a)
    {
        return expand(data_.state.lm.cdata() + a*d)/data_.rho;
    };
    forAll(ownedVolume_, a)
    {
        const scalar V = ownedVolume_[a];
        mass += V;
        meanX += V*(dual_.position(a) - rigid_->start());
        meanU += V*displacement(a);
        meanV += V*speed(a);
    }
    reduce(mass, sumOp<scalar>());
    meanX = returnReduce(meanX, sumOp<vector>())/mass;
    meanU = returnReduce(meanU, sumOp<vector>())/mass;
    meanV = returnReduce(meanV, sumOp<vector>())/mass;

    tensor turned(Zero), own(Zero);
    vector momentum(Zero);
    scalar speedSqr = 0, movedSqr = 0;
    forAll(ownedVolume_, a)
    {
        const scalar V = ownedVolume_[a];
        const vector r(dual_.position(a) - rigid_->start() - meanX);
        const vector y(r + displacement(a) - meanU);
        const vector v(speed(a) - meanV);
        turned += V*(y*r);
        own += V*(magSqr(y)*tensor::I - y*y);
        momentum += V*(y ^ v);
        speedSqr += V*magSqr(speed(a));
        movedSqr += V*magSqr(displacement(a));
    }
    reduce(turned, sumOp<tensor>());
    reduce(own, sumOp<tensor>());
    reduce(momentum, sumOp<vector>());
    reduce(speedSqr, sumOp<scalar>());
    reduce(movedSqr, sumOp<scalar>());

    // The nearest rotation, by Newton's method for the polar decomposition.
    // Directions that are not solved stay as they are
    const scalar size = mag(turned);
    const vector solved(dual_.projected(vector::one));
    for (direction c = 0; c < 3; ++c)
    {
        if (solved[c] == 0)
        {
            turned[4*c] = size;
            own[4*c] = max(own[4*c], SMALL*mag(own) + VSMALL);
        }
    }
    if (!(det(turned) > 0))
    {
        FatalFileErrorInFunction(pointUFile_.path()/"pointD")
            << "Keyword 'internalField': the displacements turn the rigid "
            << "region '" << name_ << "' inside out, or flatten it"
            << exit(FatalIOError);
    }
    tensor R(turned);
    if (max(mag(data_.state.disp)) > 0 || Pstream::parRun())
    {
        for (label i = 0; i < mostTurns; ++i)
        {
            const tensor next(0.5*(R + inv(R).T()));
            const scalar change = magSqr(next - R);
            R = next;
            if (change < turnedEnough) break;
        }
    }
    else
    {
        R = tensor::I;
    }
    rigid_->setPose(meanX + meanU - (R & meanX), R);

    const auto overBody = [&](const std::function<scalar(label)>& of)
    {
        scalar sum = 0;
        forAll(ownedVolume_, a) sum += ownedVolume_[a]*of(a);
        return returnReduce(sum, sumOp<scalar>());
    };
    const scalar bent = overBody([&](const label a)
    {
        const vector r(dual_.position(a) - rigid_->start() - meanX);
        return magSqr(r + displacement(a) - meanU - (R & r));
    });
    placeLost_ = bent > largestLost*(movedSqr + SMALL*size);

    rigidBody::motionState v;
    if (d > 1) v.spin = dual_.turning(inv(own) & momentum);
    v.velocity = meanV - (v.spin ^ (R & meanX));
    rigid_->setMotion(v, time_.value());

    // The fields may contain the prescribed motion or leave it out
    const auto lostBy = [&](const rigidBody::motionState& its)
    {
        return overBody([&](const label a)
        {
            const vector r(R & (dual_.position(a) - rigid_->start()));
            return magSqr(speed(a) - its.velocity - (its.spin ^ r));
        });
    };
    velocityLost_ =
        min(lostBy(rigid_->freePart(v)), lostBy(rigid_->motion(0)))
      > largestLost*speedSqr;
}


void Foam::rigidRegion::placeNode
(
    const label a,
    const tensor& R,
    const vector& shift,
    const rigidBody::motionState& v
)
{
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();
    const vector r0(dual_.position(a) - rigid_->start());
    const vector moved((R - tensor::I) & r0);
    const vector r(r0 + moved);
    const vector u(shift + moved);
    const vector lm
    (
        data_.rho
       *(v.velocity + (v.spin ^ (r - 0.5*lastStep_*(v.spin ^ r))))
    );
    scalar* F = data_.state.F.data() + a*d*d;
    for (label i = 0; i < d; ++i)
    {
        data_.state.disp[a*d + i] = u[dir[i]];
        data_.state.lm[a*d + i] = lm[dir[i]];
        for (label j = 0; j < d; ++j) F[i*d + j] = R[3*dir[i] + dir[j]];
    }
}


void Foam::rigidRegion::setRates
(
    const label a,
    const rigidBody::motionState& v,
    const rigidBody::motionState& rate
)
{
    const vector r
    (
        position(a) - rigid_->start() - rigid_->shift()
    );
    const vector f
    (
        data_.rho
       *(rate.velocity + (rate.spin ^ r) + (v.spin ^ (v.spin ^ r)))
    );
    const label d = dual_.nDim();
    for (label i = 0; i < d; ++i)
    {
        data_.rates[a*data_.strideRates + i] = f[dual_.directions()[i]];
    }
}


void Foam::rigidRegion::placeContactNodes()
{
    const tensor R(rigid_->rotation());
    const rigidBody::motionState v(rigid_->motion(lastStep_));
    for (const label a : contact_.nodes())
    {
        placeNode(a, R, rigid_->shift(), v);
    }
}


void Foam::rigidRegion::sumContact()
{
    const label d = dual_.nDim();
    const point centre(rigid_->start() + rigid_->shift());
    rigidBody::load all;
    for (const label a : contact_.nodes())
    {
        const vector f
        (
            dual_.nodeVolume()[a]*expand(contact_.forces().cdata() + a*d)
        );
        all.force += f;
        all.moment += (dual_.projected(position(a)) - centre) ^ f;
    }
    const tensor sums
    (
        returnReduce
        (
            tensor(all.force, all.moment, vector::zero), sumOp<tensor>()
        )
    );
    all.force = sums.x();
    all.moment = sums.y();
    rigid_->setContact(all);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidRegion::rigidRegion
(
    autoPtr<polyMesh>& mesh,
    const schemeOptions& options
)
:
    solidBody(mesh, options, kinematicsOf)
{
    makeRigid();
    findSurfaceNodes();
    readState();
    fitRigid();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rigidRegion::setOpposite
(
    const List<boolList>& corners,
    const scalar area
)
{
    // Areas of the whole surface, of corners with something opposite, and of
    // overlaps. The last is larger where a corner meets several faces, smaller
    // where an overlap begins
    vector areas(0, 0, area);
    for (const label patchi : contactPatches())
    {
        const scalarField& its = corners_[patchi].geometry.cornerArea;
        const boolList& opposite = corners[patchi];
        forAll(its, k)
        {
            areas.x() += its[k];
            if (opposite.size() && opposite[k]) areas.y() += its[k];
        }
    }
    reduce(areas, sumOp<vector>());
    const scalar most = max(areas.y(), areas.z());
    oppositeShare_ = most > 0 ? min(scalar(1), most/areas.x()) : 1;
}


void Foam::rigidRegion::checkStart(const scalar time)
{
    // A jump would push other bodies, and give them energy from nowhere
    scalar most = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        const vector jump
        (
            dual_.projected(rigid_->awayFromMotion(dual_.position(a), time))
        );
        most = max
        (
            most,
            mag(jump)/std::pow(dual_.nodeVolume()[a], scalar(1)/dual_.nDim())
        );
    }
    reduce(most, maxOp<scalar>());
    if (most > largestJump)
    {
        const dictionary dict(regionFiles::material(mesh_));
        FatalIOErrorInFunction(dict)
            << "Keyword 'motion' of the rigid region '" << name_ << "': at the "
            << "start, time " << time << " s, pointD gives the body another "
            << "position. It would jump by " << most << " of its cell size, "
            << "and at most " << largestJump << " is allowed"
            << exit(FatalIOError);
    }
}


void Foam::rigidRegion::readRigid(const dictionary& record)
{
    if (record.size()) rigid_->read(record);
    else if (placeLost_)
    {
        WarningInFunction
            << "Region " << name_ << ": this rigid body cannot have the "
            << "displacements of pointD. It starts from the nearest ones that "
            << "it can have" << endl;
    }
    if (record.empty() && velocityLost_)
    {
        const rigidBody::motionState v(rigid_->motion(0));
        WarningInFunction
            << "Region " << name_ << ": this rigid body cannot move with the "
            << "velocities of pointU. It starts with the velocity "
            << v.velocity << " m/s and the angular velocity " << v.spin
            << " 1/s" << endl;
    }
    placeAll();
}


void Foam::rigidRegion::setGravity(const vector& g)
{
    solidBody::setGravity(g);
    rigid_->setGravity(expand(gravity_.cdata()));
}


Foam::scalar Foam::rigidRegion::timeScale(const bool)
{
    return 1/(stepsPerTurn*mag(rigid_->presentSpin()) + 1/GREAT);
}


void Foam::rigidRegion::restoreOld()
{
    if (reactions_.valid()) reactions_->restore();
    rigid_->restore(block_.valid());
    lastStep_ = block_.valid() ? block_->lastStep : oldStep_;
    placeContactNodes();
}


Foam::labelList Foam::rigidRegion::reactingPatches() const
{
    // The reaction of a held region acts on it as a whole
    return labelList(rigid_->isHeld() ? 1 : 0, constraintReactions::whole);
}


Foam::vector Foam::rigidRegion::displacedVolume() const
{
    vector first(Zero);
    forAll(ownedVolume_, a)
    {
        first += ownedVolume_[a]*(dual_.position(a) - rigid_->start());
    }
    return
        volume()*rigid_->shift()
      + ((rigid_->rotation() - tensor::I) & first);
}


void Foam::rigidRegion::placeAll() const
{
    rigidRegion& self = const_cast<rigidRegion&>(*this);
    const tensor R(rigid_->rotation());
    const rigidBody::motionState v(rigid_->motion(lastStep_));
    const rigidBody::motionState now{v.velocity, rigid_->presentSpin()};
    const rigidBody::motionState rate
    (
        self.rigid_->fullAcceleration(lastStep_)
    );
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        self.placeNode(a, R, rigid_->shift(), v);
        self.setRates(a, now, rate);
    }
}


void Foam::rigidRegion::report(Ostream& os) const
{
    const auto onOff = [](const bool on) { return on ? "on" : "off"; };
    dual_.report(os);
    rigid_->report(os);
    os  << nl << "    gravity " << onOff(hasGravity())
        << ", contact " << onOff(contact_.on());
    reportBytes(os);
}


void Foam::rigidRegion::evaluate(const scalar time, const bool)
{
    evaluated_ = true;
    reusable_ = true;
    rigid_->findLoads(time);
    nBad_ = rigid_->finite() ? 0 : 1;
    const rigidBody::motionState v
    {
        vector::zero, rigid_->presentSpin()
    };
    const rigidBody::motionState rate(rigid_->acceleration());
    for (const label a : contact_.nodes()) setRates(a, v, rate);
}


void Foam::rigidRegion::updateContactVelocity()
{
    if (!contact_.on()) return;
    sumContact();
    const rigidBody::motionState push(rigid_->contactAcceleration());
    const point centre(rigid_->start() + rigid_->shift());
    const scalar step = contact_.gives()*contact_.step();
    contact_.setVelocity([&](const label a)
    {
        return step*(push.velocity + (push.spin ^ (position(a) - centre)));
    });
}


void Foam::rigidRegion::addContactForces()
{
    if (contact_.on()) sumContact();
}


void Foam::rigidRegion::leap
(
    const scalar time,
    const scalar deltaT,
    const scalar kick,
    const scalar step,
    const bool energy,
    powers& accounts
)
{
    const label d = dual_.nDim();
    contact_.forComponents([&](label, const label a, const label i)
    {
        data_.old.lm[a*d + i] = data_.state.lm[a*d + i];
    });
    const bool reacts = reactions_.valid();
    rigidBody::reaction held;
    const rigidBody::works sums
    (
        rigid_->leap(time, deltaT, kick, energy, reacts ? &held : nullptr)
    );
    if (reacts) reactions_->addWhole(held, kick);
    accounts.external += sums.external;
    accounts.contact += sums.contact;
    oldStep_ = lastStep_;
    lastStep_ = step;
    evaluated_ = false;
    placeContactNodes();
}


void Foam::rigidRegion::keepOld()
{
    rigid_->keepOld();
    oldStep_ = lastStep_;
}


Foam::solidBody::powers Foam::rigidRegion::presentPowers() const
{
    powers p;
    if (!evaluated_) return p;
    const rigidBody::works now(rigid_->presentPowers());
    p.external = now.external;
    p.contact = now.contact;
    return p;
}


void Foam::rigidRegion::keepStart()
{
    if (!block_.valid()) block_.reset(new stepBlock);
    rigid_->keepStart();
    block_->lastStep = lastStep_;
}


void Foam::rigidRegion::stop()
{
    rigid_->stop();
    placeAll();
}


void Foam::rigidRegion::startFromRest()
{
    rigid_->startFromRest(0.5*lastStep_);
    placeAll();
}


Foam::leapfrogBody::forceBalance Foam::rigidRegion::balance()
{
    const rigidBody::loadBalance its(rigid_->balance());
    forceBalance b;
    b.unbalanced = returnReduce(its.unbalanced, sumOp<scalar>());
    b.loads = returnReduce(its.loads, sumOp<scalar>());
    return b;
}


// ************************************************************************* //
