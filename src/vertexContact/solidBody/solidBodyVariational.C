/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The variational scheme of a body: the passes of variationalKernel in their
    order, with sums over processors and mirrors; the leapfrog; works; the
    bound of the step.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "solidBoundaryCondition.H"
#include "prescribedMotion.H"
#include "stepLimit.H"
#include "passTimes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidBody::completeTensors
(
    scalar* data,
    const label stride,
    const label columnStride,
    const label offset
) const
{
    if (symmetry_.active())
    {
        const label d = dual_.nDim();
        labelList place(d*d);
        for (label i = 0; i < d; ++i)
        {
            for (label j = 0; j < d; ++j)
            {
                place[i*d + j] = offset + j*columnStride + i;
            }
        }
        symmetry_.symmetrise(data, stride, place, 2);
    }
}


void Foam::solidBody::boundFrequencies()
{
    const label d = dual_.nDim();
    const label n = dual_.nNodes();

    scalarField sums(n*(d + 1));
    variational_->boundColumns(data_, *x_, sums);
    dual_.sharing().sum(sums.data(), d + 1);
    variational_->boundRows(data_, *x_, sums, x_->geometricBound);
    dual_.sharing().sum(x_->geometricBound.data(), d*(d + 1)/2);
    scalar largest = 0;
    for (label a = 0; a < n; ++a)
    {
        const scalar* K = x_->geometricBound.cdata() + a*d*(d + 1)/2;
        scalar trace = 0;
        for (label i = 0, k = 0; i < d; k += d - i, ++i) trace += K[k];
        largest = max(largest, trace);
    }
    reduce(largest, maxOp<scalar>());

    for (label e = 0; e < 2*dual_.nEdges(); ++e)
    {
        x_->perEdges[dual_.edgeNodes()[e]] += 1;
    }
    dual_.sharing().sum(x_->perEdges.data(), 1);
    for (scalar& n : x_->perEdges) n = 1/n;

    if (x_->smoothed)
    {
        x_->volumeImpedance = std::sqrt(data_.rho*material_->kappa());
        findFilter();
    }

    findJumpStiffness();

    // What the operator has, in two digits: not the last bits, which depend on
    // the number of processors
    const stepLimit limit(data_, *x_, symmetry_);
    const scalar ratio = limit.squaredFrequency()/(sqr(data_.cp)*largest);
    x_->boundRatio = std::ceil(1e2*ratio)/1e2;
    largestFrequency_ = data_.cp*std::sqrt(x_->boundRatio*largest);

    // The state is undeformed yet
    const scalar bound = returnReduce(boundOfStep(), minOp<scalar>());
    x_->stepRatio = std::floor(1e2*limit.step()/bound)/1e2;
}


Foam::scalar Foam::solidBody::boundOfStep()
{
    variational_->sumWaves(data_, *x_);
    dual_.sharing().sum
    (
        x_->waves.data(), variationalLayout::strideWaves(dual_.nDim())
    );
    return variational_->timeScale(data_, *x_);
}


void Foam::solidBody::findCompliances()
{
    // Area vector of all surfaces of contact at each node
    const label d = dual_.nDim();
    scalarField area(dual_.nNodes()*d, Zero);
    const auto forCorners = [&](const auto& f)
    {
        for (const dualPatch& patch : dual_.patches())
        {
            const label patchi = patch.patchIndex;
            if (!corners_.set(patchi) || !condition(patchi).contact()) continue;
            forAll(patch.cornerNode, k)
            {
                f
                (
                    patch, k, area.data() + patch.cornerNode[k]*d,
                    patch.cornerNormal.cdata() + k*d
                );
            }
        }
    };
    forCorners([&]
    (
        const dualPatch& patch, const label k, scalar* A, const scalar* n
    )
    {
        for (label i = 0; i < d; ++i) A[i] += patch.cornerArea[k]*n[i];
    });
    dual_.sharing().sum(area.data(), d);

    surfaceCompliance_.setSize(corners_.size());
    forCorners([&]
    (
        const dualPatch& patch, const label k, scalar* A, const scalar* n
    )
    {
        scalar along = 0;
        for (label i = 0; i < d; ++i) along += A[i]*n[i];
        scalarField& perVolume = surfaceCompliance_[patch.patchIndex];
        perVolume.setSize(patch.nCorners());
        perVolume[k] =
            max(along, patch.cornerArea[k])
           /dual_.nodeVolume()[patch.cornerNode[k]];
    });
}


void Foam::solidBody::deform()
{
    variationalData& x = *x_;
    const label d = dual_.nDim();
    const label sA = variationalLayout::strideColumn(d);
    const label sC = variationalLayout::strideC(d, x.beta > 0);
    const label sS = variationalLayout::strideSensor(d);

    typedef passTimes times;
    nBad_ = times::timed(times::velocities, [&]
    {
        return
            collected_ ? nBadCollected_ : variational_->collect(data_, x);
    });
    collected_ = false;
    nBad_ += times::timed(times::gradients, [&]
    {
        return variational_->gradients(x, data_);
    });
    times::timed(times::processors, [&]
    {
        dual_.sharing().sum(x.grad.data(), d*sA);
    });
    nBad_ += times::timed(times::inverses, [&]
    {
        completeTensors(x.grad.data(), d*sA, sA, 0);
        completeTensors(x.grad.data(), d*sA, sA, variationalLayout::second(d));
        return variational_->deform(x, data_);
    });

    nBad_ += times::timed(times::corrections, [&]
    {
        return variational_->correct(data_, x);
    });
    times::timed(times::processors, [&]
    {
        if (sC)
        {
            dual_.sharing().sum
            (
                {{x.correction.data(), d*sC}, {x.sensor.data(), sS}}
            );
        }
        else
        {
            dual_.sharing().sum(x.sensor.data(), sS);
        }
    });
    nBad_ += times::timed(times::kinematics, [&]
    {
        if (x.beta > 0) completeTensors(x.correction.data(), d*sC, sC, 0);
        if (d > 1)
        {
            completeTensors
            (
                x.correction.data(), d*sC, sC,
                variationalLayout::atJump(d, x.beta > 0)
            );
        }
        return variational_->kinematics(data_, x);
    });

    if (x.smoothed)
    {
        times::timed(times::volume, [&]
        {
            smoothJacobian();
            data_.state.J = x.jacobian;
        });
    }
}


void Foam::solidBody::findJumpStiffness()
{
    const label d = dual_.nDim();
    // In uniaxial strain nothing shears
    const scalar modulus = d > 1 ? jumpShare*material_->jumpModulus() : 0;
    for (label e = 0; e < dual_.nEdges(); ++e)
    {
        const label a = dual_.edgeNodes()[2*e], b = dual_.edgeNodes()[2*e + 1];
        scalar CC = 0, rr = 0;
        for (label j = 0; j < d; ++j)
        {
            CC += sqr(data_.edgeArea()[e*d + j]);
            rr += sqr
            (
                dual_.nodePosition()[b*d + j] - dual_.nodePosition()[a*d + j]
            );
        }
        x_->jumpStiffness[e] = modulus*std::sqrt(CC/rr);
    }
}


void Foam::solidBody::smoothJacobian()
{
    variationalData& x = *x_;
    const auto removed = [&]
    {
        // w (1 - M)
        variational_->smooth(x, data_);
        dual_.sharing().sum(x.average.data(), 1);
        for (scalar& r : x.average) r *= -x.filter;
    };
    removed();
    x.unsmoothed = x.jacobian;
    x.jacobian = x.average;
    removed();
    forAll(x.jacobian, a) x.jacobian[a] = x.unsmoothed[a] - x.average[a];
}


void Foam::solidBody::findFilter()
{
    // Power method for the largest eigenvalue of 1 - M, of which the start has
    // all directions; rounded up to two digits
    variationalData& x = *x_;
    forAll(x.jacobian, a)
    {
        scalar phase = 0;
        for (label j = 0; j < dual_.nDim(); ++j)
        {
            phase +=
                (j + 1)*17.3*dual_.nodePosition()[a*dual_.nDim() + j]
               /std::pow(dual_.nodeVolume()[a], 1.0/dual_.nDim());
        }
        x.jacobian[a] = std::sin(phase);
    }
    scalar largest = 0;
    for (label pass = 0; pass < 40; ++pass)
    {
        variational_->smooth(x, data_);
        dual_.sharing().sum(x.average.data(), 1);
        scalar before = 0, after = 0;
        forAll(x.average, a)
        {
            if (dual_.sharing().owned()[a])
            {
                before += dual_.nodeVolume()[a]*sqr(x.jacobian[a]);
                after += dual_.nodeVolume()[a]*sqr(x.average[a]);
            }
        }
        reduce(before, sumOp<scalar>());
        reduce(after, sumOp<scalar>());
        largest = std::sqrt(after/before);
        forAll(x.average, a) x.jacobian[a] = -x.average[a]/largest;
    }
    x.filter = 1/(std::ceil(1e2*largest)/1e2);
}


void Foam::solidBody::computeForces(const bool energy)
{
    variationalData& x = *x_;
    const label d = dual_.nDim();
    const label sA = variationalLayout::strideColumn(d);

    typedef passTimes times;
    if (x.smoothed)
    {
        // SigmaJ where it acts, S SigmaJ, in place of that of the smoothed J
        times::timed(times::volume, [&]
        {
            forAll(x.jacobian, a)
            {
                x.jacobian[a] = data_.W[a*data_.strideW + d];
            }
            smoothJacobian();
            variational_->addPressure(data_, x);
        });
    }

    times::timed(times::fluxes, [&] { variational_->fluxes(data_, x); });
    times::timed(times::processors, [&]
    {
        dual_.sharing().sum(x.adjoint.data(), d*sA);
    });
    times::timed(times::adjoint, [&]
    {
        completeTensors(x.adjoint.data(), d*sA, sA, 0);
        completeTensors
        (
            x.adjoint.data(), d*sA, sA, variationalLayout::second(d)
        );
        variational_->stresses(x, data_);
    });
    times::timed(times::forces, [&] { variational_->forces(data_, x); });

    externalForce_ = Zero;
    bool loaded = false;
    for (const dualPatch& patch : dual_.patches())
    {
        const label patchi = patch.patchIndex;
        if
        (
            patch.nFaces() && corners_.set(patchi)
         && !condition(patchi).motion()
         && !condition(patchi).contact()
        )
        {
            variational_->addTractions
            (
                data_, patch, corners_[patchi], externalForce_
            );
            loaded = true;
        }
    }
    for (label a = 0; loaded && a < dual_.nNodes(); ++a)
    {
        scalar* rate = data_.rates.data() + a*data_.strideRates;
        for (label i = 0; i < d; ++i) rate[i] += externalForce_[a*d + i];
    }
    times::timed(times::processors, [&]
    {
        dual_.sharing().sum(data_.rates.data(), data_.strideRates);
    });
}


void Foam::solidBody::clearContact()
{
    const label d = dual_.nDim();
    for (const label a : contactNodes_)
    {
        contact_.force[a] = vector::zero;
        contact_.area[a] = 0;
        for (label i = 0; i < d; ++i) contactForce_[a*d + i] = 0;
    }
}


void Foam::solidBody::holdDissipation()
{
    // What contact or a boundary holds is not moved by the dissipation
    const label d = dual_.nDim();
    scalar* damping = data_.rates.data() + variationalLayout::second(d);
    const label stride = data_.strideRates;
    if (symmetry_.active()) symmetry_.project(damping, stride);
    forAll(held_.nodes(), k)
    {
        held_.hold(k, damping + held_.nodes()[k]*stride);
    }
    if (hasContact_)
    {
        for (const label a : contactNodes_)
        {
            if (contact_.status[a] < 0.5) continue;
            for (label i = 0; i < d; ++i) damping[a*stride + i] = 0;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidBody::startContact()
{
    if (!hasContact_) return;
    for (const label a : contactNodes_) contact_.gap[a] = GREAT;
    clearContact();
}


void Foam::solidBody::updateContactVelocity()
{
    if (!hasContact_) return;
    const label d = dual_.nDim();
    const scalar step = contactGives_*contactStep_;
    contactVelocity_.setSize(contactForce_.size(), Zero);
    if (rigid_.valid())
    {
        updateRigidContactVelocity(step);
    }
    else
    {
        // Other nodes' sums are not used
        for (const label a : contactNodes_)
        {
            for (label i = 0; i < d; ++i)
            {
                work_[a*d + i] = contactForce_[a*d + i];
            }
        }
        completeContact();
        const scalar share = step/data_.rho;
        for (const label a : contactNodes_)
        {
            for (label i = 0; i < d; ++i)
            {
                contactVelocity_[a*d + i] = share*work_[a*d + i];
            }
        }
    }
    clearContact();
    for (const label a : contactNodes_) contact_.status[a] = 0;
}


void Foam::solidBody::addContactForces()
{
    if (!hasContact_) return;
    if (rigid_.valid())
    {
        sumContact();
        return;
    }
    const label d = dual_.nDim();
    // Other nodes' sums are not used
    scalarField& sum = work_;
    for (const label a : contactNodes_)
    {
        for (label i = 0; i < d; ++i) sum[a*d + i] = contactForce_[a*d + i];
    }
    dual_.sharing().sum(sum.data(), d);
    if (reactions_.valid()) reactions_->takeContact(sum, d);
    if (symmetry_.active()) symmetry_.project(sum.data(), d);
    for (const label k : heldContacts_)
    {
        const label a = held_.nodes()[k];
        const bool owned = dual_.sharing().owned()[a];
        held_.hold
        (
            k, sum.data() + a*d, [&](const label i, const scalar f)
            {
                if (owned) externalForce_[a*d + i] -= f;
            }
        );
    }
    for (const label a : contactNodes_)
    {
        scalar* rate = data_.rates.data() + a*data_.strideRates;
        for (label i = 0; i < d; ++i) rate[i] += sum[a*d + i];
    }
}


void Foam::solidBody::rememberSlide()
{
    if (contact_.slide.on()) return;
    contact_.slide.start(dual_.nNodes());
    const auto slide = readIfPresent<vector>("contactSlide", dimLength);
    if (slide.valid())
    {
        forAll(contact_.slide.ways(), a)
        {
            contact_.slide.ways()[a] =
                slide().primitiveField()[dual_.nodePoint()[a]];
        }
    }
}


void Foam::solidBody::finishSlide()
{
    contact_.slide.finish
    (
        dual_.sharing(), contactNodes_,
        [this](const label a) { return deformationGradient(a); }
    );
}


Foam::vector Foam::solidBody::stepVelocity(const label node) const
{
    const label d = dual_.nDim();
    if (block_.valid() && block_->inside)
    {
        return expand(block_->path.cdata() + d*node);
    }
    return expand(data_.state.lm.cdata() + d*node)/data_.rho;
}


Foam::vector Foam::solidBody::meanStepVelocity(const label node) const
{
    const label d = dual_.nDim();
    if (block_.valid() && block_->inside) return stepVelocity(node);
    return
        0.5
       *(stepVelocity(node) + expand(data_.old.lm.cdata() + d*node)/data_.rho);
}


void Foam::solidBody::react()
{
    const label d = dual_.nDim();
    forAll(held_.nodes(), k)
    {
        const label a = held_.nodes()[k];
        const bool owned = dual_.sharing().owned()[a];
        held_.hold
        (
            k, data_.rates.data() + a*data_.strideRates,
            [&](const label i, const scalar f)
            {
                if (owned) externalForce_[a*d + i] -= f;
            }
        );
    }
}


Foam::scalar Foam::solidBody::imposedWork(const scalarField& velocity) const
{
    const label d = dual_.nDim();
    const scalar* v = velocity.cdata();
    const scalar* lm = data_.state.lm.cdata();
    const scalar* old = data_.old.lm.cdata();
    scalar work = 0;
    forAll(held_.nodes(), k)
    {
        const label a = held_.nodes()[k];
        if (!dual_.sharing().owned()[a]) continue;
        scalar change[3];
        for (label i = 0; i < d; ++i) change[i] = lm[a*d + i] - old[a*d + i];
        held_.hold
        (
            k, change, [&](const label i, const scalar given)
            {
                work += dual_.nodeVolume()[a]*v[a*d + i]*given;
            }
        );
    }
    return work;
}


Foam::solidBody::powers Foam::solidBody::powersOf
(
    const scalarField& velocity
) const
{
    powers p;
    withDirections(dual_.nDim(), [&](auto D)
    {
        constexpr int d = D.value;
        constexpr int atDamping = variationalLayout::second(d);
        const scalar* v = velocity.cdata();
        const scalar* external = externalForce_.cdata();
        const scalar* contact = contactForce_.cdata();
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            const scalar V = dual_.nodeVolume()[a];
            const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
            scalar ofExternal = 0, damped = 0;
            for (int i = 0; i < d; ++i)
            {
                const label k = a*d + i;
                ofExternal += external[k]*v[k];
                damped += rate[atDamping + i]*v[k];
            }
            p.external += V*ofExternal;
            p.numericalDissipation -= ownedVolume_[a]*damped;
        }
        for (const label a : contactNodes_)
        {
            scalar power = 0;
            for (int i = 0; i < d; ++i) power += contact[a*d + i]*v[a*d + i];
            p.contact += dual_.nodeVolume()[a]*power;
        }
    });
    return p;
}


Foam::solidBody::powers Foam::solidBody::presentPowers() const
{
    if (!evaluated_) return powers();
    if (rigid_.valid())
    {
        const rigidBody::works now(rigid_->presentPowers(lastStep_));
        powers p;
        p.external = now.external;
        p.contact = now.contact;
        return p;
    }
    const label d = dual_.nDim();
    scalarField v(dual_.nNodes()*d);
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        for (label i = 0; i < d; ++i) v[a*d + i] = velocity(a, i);
    }
    powers p(powersOf(v));
    if (damping_.valid())
    {
        // Since the time of the momentum, so that free motions balance exactly
        forAll(v, k) v[k] = 0.5*(v[k] + data_.state.lm[k]/data_.rho);
        p.damping = dampingPower(v, damping_->ofMean(0.5*lastStep_));
    }
    return p;
}


void Foam::solidBody::keepOld()
{
    if (rigid_.valid())
    {
        rigid_->keepOld();
        oldStep_ = lastStep_;
        return;
    }
    data_.old.lm = data_.state.lm;
    data_.old.disp = data_.state.disp;
    x_->oldAcceleration = x_->acceleration;
    oldStep_ = lastStep_;
}


void Foam::solidBody::leap
(
    const scalar time,
    const scalar deltaT,
    const bool energy,
    powers& accounts
)
{
    leap
    (
        time, deltaT, 0.5*(lastStep_ + deltaT), deltaT, energy, accounts
    );
}


void Foam::solidBody::leap
(
    const scalar time,
    const scalar deltaT,
    const scalar kick,
    const scalar step,
    const bool energy,
    powers& accounts
)
{
    if (rigid_.valid())
    {
        leapRigid(time, deltaT, kick, step, energy, accounts);
        return;
    }
    const label d = dual_.nDim();
    scalar* lm = data_.state.lm.data();
    const scalar perRho = 1/data_.rho;

    if (damping_.valid())
    {
        kickDamped(kick);
    }
    else withDirections(d, [&](auto D)
    {
        scalar* old = data_.old.lm.data();
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
            for (int i = 0; i < D.value; ++i)
            {
                const label k = a*D.value + i;
                old[k] = lm[k];
                lm[k] += kick*rate[i];
            }
        }
    });
    held_.impose
    (
        data_.state.lm.data(), data_.state.disp.cdata(), data_.rho, time,
        deltaT
    );
    if (symmetry_.active()) symmetry_.project(lm, d);

    if (energy)
    {
        // With the mean of both velocities the works of all forces are the
        // growth of the kinetic energy, exactly
        scalarField& v = work_;
        forAll(v, k) v[k] = 0.5*perRho*(data_.old.lm[k] + lm[k]);
        const powers p(powersOf(v));
        accounts.numericalDissipation += kick*p.numericalDissipation;
        accounts.external += kick*p.external;
        accounts.contact += kick*p.contact;
        accounts.external += imposedWork(v);
        if (damping_.valid())
        {
            accounts.damping +=
                kick*dampingPower(v, damping_->ofMean(kick));
        }
    }
    if (reactions_.valid()) reactions_->add(data_, kick);

    if (d > 1) holdDissipation();
    nBadCollected_ = variational_->move(data_, *x_, deltaT, kick);
    collected_ = true;
    oldStep_ = lastStep_;
    data_.state.sinceCommit = deltaT;
    lastStep_ = step;
    evaluated_ = false;
}


// ************************************************************************* //
