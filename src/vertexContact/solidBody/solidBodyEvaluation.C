/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    An evaluation of a body, of either scheme: from its state to rates, but for
    contact; the step that they allow; and a stage of the paper's integrators.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "passTimes.H"
#include "solidBoundaryCondition.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of a rigid body, steps in a radian: contact, found at the start of a step,
//  is where it acts, but for a twentieth of the lever
constexpr scalar stepsPerTurn = 3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidBody::symmetriseGradients()
{
    const label d = dual_.nDim();
    const label stride = d*data_.strideG;

    // Place of the derivative in direction m of component k
    const auto place = [&](const label k, const label m)
    {
        return m*data_.strideG + k;
    };

    labelList ofVector(d*d), ofScalar(d), ofTensor(d*d*d);
    for (label i = 0; i < d; ++i)
    {
        ofScalar[i] = place(d, i);
        for (label j = 0; j < d; ++j)
        {
            ofVector[i*d + j] = place(i, j);
            for (label m = 0; m < d; ++m)
            {
                ofTensor[(i*d + j)*d + m] =
                    place(data_.offsetP() + j*d + i, m);
            }
        }
    }

    scalar* grad = data_.grad.data();
    symmetry_.symmetrise(grad, stride, ofVector, 2);
    if (data_.nSJ && data_.nG > d)
    {
        symmetry_.symmetrise(grad, stride, ofScalar, 1);
    }
    if (options_.reconstruction == reconstructionType::full)
    {
        symmetry_.symmetrise(grad, stride, ofTensor, 3);
    }
}


void Foam::solidBody::addBodyForces(const scalar time, const bool energy)
{
    const label d = dual_.nDim();
    const scalar* v = data_.W.cdata();
    const auto& owned = dual_.sharing().owned();

    // Force per volume
    const auto add = [&](const label a, const label i, const scalar f)
    {
        data_.rates[a*data_.strideRates + i] += f;
        if (data_.variational)
        {
            if (owned[a]) externalForce_[a*d + i] += f;
        }
        else if (energy && owned[a])
        {
            powers_.external += dual_.nodeVolume()[a]*f*v[a*data_.strideW + i];
        }
    };

    for (label i = 0; i < d; ++i)
    {
        if (gravity_[i] != 0)
        {
            const scalar f = material_->weightRho()*gravity_[i];
            for (label a = 0; a < dual_.nNodes(); ++a) add(a, i, f);
        }
    }

    if (bodyForces_.size())
    {
        acceleration_ = Zero;
        for (const bodyForce& force : bodyForces_)
        {
            force.add(time, acceleration_);
        }
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            for (label i = 0; i < d; ++i)
            {
                add(a, i, material_->weightRho()*acceleration_[a*d + i]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidBody::findCorners(const label patchi)
{
    cornerStates& c = corners_[patchi];
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();
    forAll(c.geometry.cornerNode, k)
    {
        const label a = c.geometry.cornerNode[k];
        const scalar* N = c.geometry.cornerNormal.cdata() + d*k;
        const scalar* W = data_.W.cdata() + a*data_.strideW;
        const scalar* P = W + data_.offsetP();

        const vector area(currentArea(a, N));
        c.stretch[k] = mag(area);
        c.n[k] = area/c.stretch[k];
        for (label i = 0; i < d; ++i)
        {
            scalar PN = 0;
            for (label j = 0; j < d; ++j) PN += P[j*d + i]*N[j];
            c.v[k][dir[i]] = W[i];
            c.t[k][dir[i]] = PN;
        }
        if (data_.waveFactor.size()) c.waveFactor[k] = data_.waveFactor[a];
        c.force[k] = vector::zero;
    }
}


void Foam::solidBody::prepare
(
    const scalar time,
    const bool moved,
    const bool wavesAnew
)
{
    if (rigid_.valid()) return;
    if (data_.variational)
    {
        nBad_ = scheme_->computeForces(stretchedWaves_ && wavesAnew);
    }
    else
    {
        kernel_->velocities(data_);
    }
    if (moved && !data_.variational)
    {
        passTimes::timed(passTimes::stress, [&]
        {
            material_->stress
            (
                data_.state,
                data_.W.data() + data_.offsetP(),
                data_.nSJ ? data_.W.data() + data_.nDim() : nullptr,
                data_.strideW
            );
        });
        if (stretchedWaves_ && wavesAnew)
        {
            passTimes::timed(passTimes::waveSpeeds, [&]
            {
                material_->waveFactors(data_.state, data_.waveFactor);
            });
        }
    }

    passTimes::timed(passTimes::boundaries, [&]
    {
        forAll(corners_, patchi)
        {
            // In the variational scheme contact asks for the few corners that
            // are near anything
            if
            (
                corners_.set(patchi)
             && !(data_.variational && condition(patchi).contact())
            )
            {
                findCorners(patchi);
                condition(patchi).solve(time, corners_[patchi]);
            }
        }
    });

    if (contact_.on() && !data_.variational)
    {
        contact_.force = vector::zero;
        contact_.area = Zero;
        contact_.gap = GREAT;
    }
}


void Foam::solidBody::computeGradients(const bool withNodes)
{
    kernel_->gradients(data_);
    for (const dualPatch& patch : dual_.patches())
    {
        if (patch.nFaces() && !mirrorPatches_.found(patch.patchIndex))
        {
            kernel_->addBoundaryGradients
            (
                data_, patch,
                withNodes ? nullptr : statesOf(patch.patchIndex)
            );
        }
    }
    dual_.sharing().sum(data_.grad.data(), dual_.nDim()*data_.strideG);
    if (symmetry_.active())
    {
        symmetriseGradients();
    }
}


void Foam::solidBody::computeFluxes(const bool energy)
{
    if (rigid_.valid()) return;
    if (data_.variational)
    {
        addTractions();
        return;
    }

    // Pass A: gradients, and nodes
    typedef passTimes times;
    times::timed(times::gradients, [&] { computeGradients(); });

    // Pass B: limiter and fluxes
    data_.numericalDissipation = 0;
    powers_ = powers();
    times::timed(times::fluxes, [&] { kernel_->fluxes(data_, energy); });
    for (const dualPatch& patch : dual_.patches())
    {
        const label patchi = patch.patchIndex;
        if (patch.nFaces() && !mirrorPatches_.found(patchi))
        {
            const scalar power = kernel_->addBoundaryFluxes
            (
                data_, patch, statesOf(patchi), energy
            );
            (condition(patchi).contact() ? powers_.contact : powers_.external)
                += power;
        }
    }
    powers_.numericalDissipation = data_.numericalDissipation;
    times::timed(times::processors, [&]
    {
        dual_.sharing().sum(data_.rates.data(), data_.strideRates);
    });
}


void Foam::solidBody::finishRates(const scalar time, const bool energy)
{
    evaluated_ = true;
    reusable_ = true;
    if (rigid_.valid())
    {
        evaluateRigid(time);
        return;
    }
    if (damping_.valid()) damping_->setTime(time);
    addBodyForces(time, energy);
    if (reactions_.valid()) reactions_->takeFree(data_);
    if (data_.variational) react();

    if (symmetry_.active())
    {
        symmetry_.project(data_.rates.data(), data_.strideRates);
        if
        (
            !data_.variational
         && options_.reconstruction == reconstructionType::full
        )
        {
            symmetry_.symmetrise
            (
                data_.rates.data() + data_.offsetRateF(), data_.strideRates
            );
        }
    }
}


Foam::scalar Foam::solidBody::timeScale(const bool anew)
{
    if (rigid_.valid())
    {
        return 1/(stepsPerTurn*mag(rigid_->presentSpin()) + 1/GREAT);
    }
    if (waveSumIsConstant_) return constantTimeScale_;

    scalar shortest = GREAT;
    if (data_.variational)
    {
        shortest = scheme_->timeScale(anew);
    }
    else
    {
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            shortest = min(shortest, timeScaleOf(a));
        }
    }

    waveSumIsConstant_ = !data_.finiteStrain && !stretchedWaves_;
    constantTimeScale_ = shortest;

    return shortest;
}


Foam::scalar Foam::solidBody::fastestStretching() const
{
    return
        scheme_.valid() && !waveSumIsConstant_
      ? scheme_->fastestStretching() : 0;
}


Foam::label Foam::solidBody::advance
(
    const scalar deltaT,
    const scalar oldWeight,
    const scalar sinceCommit,
    const updatedPart part
)
{
    data_.state.sinceCommit = sinceCommit;
    return passTimes::timed(passTimes::update, [&]
    {
        return kernel_->advance(data_, deltaT, oldWeight, part);
    });
}


// ************************************************************************* //
