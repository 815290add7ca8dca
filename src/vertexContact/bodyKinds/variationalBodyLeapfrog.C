/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Forces of a body at a time, and the leapfrog: forces on its surface, held
    nodes, works, and the motion that follows from all forces.

\*---------------------------------------------------------------------------*/

#include "variationalBody.H"
#include "solidBoundaryCondition.H"
#include "passTimes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::variationalBody::findCompliances()
{
    // Area vector at each node, summed over all contact surfaces
    const label d = dual_.nDim();
    scalarField area(dual_.nNodes()*d, Zero);
    const auto forCorners = [&](const auto& f)
    {
        for (const label patchi : contactPatches())
        {
            const dualPatch& patch = dual_.patches()[patchi];
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

    forCorners([&]
    (
        const dualPatch& patch, const label k, scalar* A, const scalar* n
    )
    {
        bodySurface& its = surfaces_[patch.patchIndex];
        scalarField& perVolume = its.compliance;
        perVolume.setSize(patch.nCorners());
        its.nodeArea.setSize(patch.nCorners()*d);
        for (label i = 0; i < d; ++i) its.nodeArea[k*d + i] = A[i];
        perVolume[k] =
            surfaceArea(patch.patchIndex, k)
           /dual_.nodeVolume()[patch.cornerNode[k]];
    });
}


void Foam::variationalBody::findForces
(
    const scalar time,
    const bool wavesAnew
)
{
    nBad_ = scheme_->computeForces(stretchedWaves_ && wavesAnew);
    solveConditions(time);
}


void Foam::variationalBody::addTractions(const scalar time)
{
    const label d = dual_.nDim();
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
            const solidBoundaryCondition& bc = condition(patchi);
            if (bc.isPressure())
            {
                addPressure(patch, bc.pressure(time));
            }
            else
            {
                addTractions(patch);
            }
            loaded = true;
        }
    }
    for (label a = 0; loaded && a < dual_.nNodes(); ++a)
    {
        scalar* rate = data_.rates.data() + a*data_.strideRates;
        for (label i = 0; i < d; ++i) rate[i] += externalForce_[a*d + i];
    }
    passTimes::timed(passTimes::processors, [&]
    {
        dual_.sharing().sum(data_.rates.data(), data_.strideRates);
    });
}


void Foam::variationalBody::addTractions(const dualPatch& patch)
{
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();
    const cornerStates& c = corners_[patch.patchIndex];
    patch.forFaces([&](const dualPatch::face& f)
    {
        const scalar* s = patch.weights.cdata() + f.firstWeight;
        for (label p = 0; p < f.size; ++p)
        {
            const label a = patch.cornerNode[f.start + p];
            vector sum(c.force[f.start + p]);
            for (label j = 0; j < f.size; ++j)
            {
                sum += s[p*f.size + j]*c.tB[f.start + j];
            }
            for (label i = 0; i < d; ++i)
            {
                externalForce_[a*d + i] += sum[dir[i]]/dual_.nodeVolume()[a];
            }
        }
    });
}


void Foam::variationalBody::addPressure
(
    const dualPatch& patch,
    const scalar pressure
)
{
    const label d = dual_.nDim();
    patch.forFaces([&](const dualPatch::face& f)
    {
        scalar x[4*3], areas[4*3];
        for (label p = 0; p < f.size; ++p)
        {
            const label a = patch.cornerNode[f.start + p];
            for (label i = 0; i < d; ++i)
            {
                x[p*d + i] = dual_.nodePosition()[a*d + i];
                if (data_.finiteStrain)
                {
                    x[p*d + i] += data_.state.disp[a*d + i];
                }
            }
        }
        patch.cornerAreas(f, x, areas);
        for (label p = 0; p < f.size; ++p)
        {
            const label a = patch.cornerNode[f.start + p];
            const scalar perV = pressure/dual_.nodeVolume()[a];
            for (label i = 0; i < d; ++i)
            {
                externalForce_[a*d + i] -= perV*areas[p*d + i];
            }
        }
    });
}


void Foam::variationalBody::addBodyForces(const scalar time)
{
    const label d = dual_.nDim();
    const auto& owned = dual_.sharing().owned();
    forBodyForces(time, [&](const label a, const label i, const scalar f)
    {
        data_.rates[a*data_.strideRates + i] += f;
        if (owned[a]) externalForce_[a*d + i] += f;
    });
}


void Foam::variationalBody::holdDissipation()
{
    // Dissipation does not move nodes that contact or a boundary holds
    const label d = dual_.nDim();
    scalar* damping = data_.rates.data() + variationalLayout::second(d);
    const label stride = data_.strideRates;
    if (symmetry_.active()) symmetry_.project(damping, stride);
    forAll(held_.nodes(), k)
    {
        held_.hold(k, damping + held_.nodes()[k]*stride);
    }
    for (const label a : contact_.nodes())
    {
        if (!contact_.touches(a)) continue;
        for (label i = 0; i < d; ++i) damping[a*stride + i] = 0;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::variationalBody::setHolding(const List<boolList>& corners)
{
    // Area at each node, summed over all surfaces that hold
    scalarField area(dual_.nNodes(), Zero);
    for (const label patchi : contactPatches())
    {
        const dualPatch& patch = dual_.patches()[patchi];
        forAll(corners[patchi], k)
        {
            if (corners[patchi][k])
            {
                area[patch.cornerNode[k]] += patch.cornerArea[k];
            }
        }
    }
    dual_.sharing().sum(area.data(), 1);

    for (const label patchi : contactPatches())
    {
        bodySurface& its = surfaces_[patchi];
        its.holdCompliance.setSize(its.rimNode.size());
        forAll(its.rimNode, k)
        {
            const label a = dual_.patches()[patchi].cornerNode[k];
            its.holdCompliance[k] =
                its.rimNode[k] ? area[a]/dual_.nodeVolume()[a] : 0;
        }
    }
}


void Foam::variationalBody::evaluate
(
    const scalar time,
    const bool wavesAnew
)
{
    findForces(time, wavesAnew);
    addTractions(time);
    evaluated_ = true;
    reusable_ = true;
    if (damping_.valid()) damping_->setTime(time);
    addBodyForces(time);
    if (reactions_.valid()) reactions_->takeFree(data_);
    react();
    if (symmetry_.active())
    {
        symmetry_.project(data_.rates.data(), data_.strideRates);
    }
}


void Foam::variationalBody::updateContactVelocity()
{
    if (contact_.on()) contact_.updateVelocity(work_);
}


void Foam::variationalBody::addContactForces()
{
    if (!contact_.on()) return;
    const label d = dual_.nDim();
    contact_.sum(work_);
    if (reactions_.valid()) reactions_->takeContact(work_, d);
    contact_.hold
    (
        work_, [&](const label a, const label i, const scalar f)
        {
            if (dual_.sharing().owned()[a]) externalForce_[a*d + i] -= f;
        }
    );
    for (const label a : contact_.nodes())
    {
        scalar* rate = data_.rates.data() + a*data_.strideRates;
        for (label i = 0; i < d; ++i) rate[i] += work_[a*d + i];
    }
}


void Foam::variationalBody::react()
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


Foam::scalar Foam::variationalBody::imposedWork
(
    const scalarField& velocity
) const
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


Foam::variationalBody::powers Foam::variationalBody::powersOf
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
    });
    p.contact = contact_.power(velocity);
    return p;
}


Foam::scalar Foam::variationalBody::internalPower
(
    const scalarField& velocity
) const
{
    const label d = dual_.nDim();
    const powers p(powersOf(velocity));
    scalar all = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
        for (label i = 0; i < d; ++i)
        {
            all += ownedVolume_[a]*rate[i]*velocity[a*d + i];
        }
    }
    return all - p.external - p.contact + p.numericalDissipation;
}


Foam::variationalBody::powers Foam::variationalBody::presentPowers() const
{
    if (!evaluated_) return powers();
    const label d = dual_.nDim();
    scalarField v(dual_.nNodes()*d);
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        for (label i = 0; i < d; ++i) v[a*d + i] = middleVelocity(a, i);
    }
    powers p(powersOf(v));
    if (damping_.valid())
    {
        // Use the mean over the half step, so that free motions balance
        // exactly: damping has no swing
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            for (label i = 0; i < d; ++i)
            {
                scalar& mean = v[a*d + i];
                mean = 0.5*(mean + velocity(a, i));
            }
        }
        p.damping = dampingPower(v, damping_->ofMean(0.5*lastStep_));
    }
    return p;
}


void Foam::variationalBody::keepOld()
{
    data_.old.lm = data_.state.lm;
    data_.old.disp = data_.state.disp;
    scheme_->keepAcceleration();
    oldStep_ = lastStep_;
}


void Foam::variationalBody::leap
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
    scalar* lm = data_.state.lm.data();
    const scalar perRho = 1/data_.rho;

    // With damping as in massDamping, otherwise undamped
    const scalar T = damping_.valid() ? damping_->tanhOf(kick) : 0;
    const scalar keep = (1 - T)/(1 + T), share = kick/(1 + T);
    withDirections(d, [&](auto D)
    {
        scalar* old = data_.old.lm.data();
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
            for (int i = 0; i < D.value; ++i)
            {
                const label k = a*D.value + i;
                old[k] = lm[k];
                lm[k] = keep*lm[k] + share*rate[i];
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
        // With the mean of both velocities the work of all forces is exactly
        // the growth of the kinetic energy
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
        if (lastStep_ == 0)
        {
            // The first kick lasts half a step. With the mean velocity internal
            // forces do less work in it than the strain energy loses, which
            // changes with the velocity at its end
            forAll(v, k) v[k] = perRho*(lm[k] - data_.old.lm[k]);
            accounts.startSwing += 0.5*kick*internalPower(v);
        }
    }
    if (reactions_.valid()) reactions_->add(data_, kick);

    if (d > 1) holdDissipation();
    scheme_->move(deltaT, kick);
    oldStep_ = lastStep_;
    data_.state.sinceCommit = deltaT;
    lastStep_ = step;
    evaluated_ = false;
}


// ************************************************************************* //
