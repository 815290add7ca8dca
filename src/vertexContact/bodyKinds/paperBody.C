/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "paperBody.H"
#include "passTimes.H"
#include "solidBoundaryCondition.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::kinematicSet Foam::paperBody::kinematicsOf
(
    const schemeOptions& options,
    const materialModel&
)
{
    return options.kinematics;
}


Foam::scalar Foam::paperBody::shortestTimeScale(const bool)
{
    scalar shortest = GREAT;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        shortest = min(shortest, paperBody::timeScaleOf(a));
    }
    return shortest;
}


void Foam::paperBody::symmetriseGradients()
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


void Foam::paperBody::addBodyForces(const scalar time, const bool energy)
{
    const scalar* v = data_.W.cdata();
    const auto& owned = dual_.sharing().owned();
    forBodyForces(time, [&](const label a, const label i, const scalar f)
    {
        data_.rates[a*data_.strideRates + i] += f;
        if (energy && owned[a])
        {
            powers_.external += dual_.nodeVolume()[a]*f*v[a*data_.strideW + i];
        }
    });
}


void Foam::paperBody::readDeformation
(
    const bool hasF,
    const bool hasDisplacement
)
{
    if (!hasF)
    {
        if (hasDisplacement) deformationFromDisplacement();
        return;
    }

    conservedState& s = data_.state;
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();
    const auto H =
        s.solvesH
      ? readIfPresent<tensor>("H", dimless)
      : autoPtr<tensorField>();
    const auto J =
        s.solvesJ
      ? readIfPresent<scalar>("J", dimless)
      : autoPtr<scalarField>();

    const label out = d == 2 ? 3 - dir[0] - dir[1] : 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        findKinematics(a);
        if (H.valid())
        {
            const tensor& given = H()[a];
            if (d == 2) s.H[a] = given[4*out];
            for (label k = 0; d == 3 && k < 9; ++k)
            {
                s.H[9*a + placeH(k)] = given[k];
            }
        }
        if (J.valid()) s.J[a] = J()[a];
    }
}


void Foam::paperBody::deformationFromDisplacement()
{
    // The gradient of the displacement takes the place of the velocity's
    conservedState& s = data_.state;
    const label d = dual_.nDim();
    data_.W = Zero;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        for (label i = 0; i < d; ++i)
        {
            data_.W[a*data_.strideW + i] = s.disp[a*d + i];
        }
    }
    computeGradients(true);

    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        const scalar* grad = data_.grad.cdata() + a*d*data_.strideG;
        for (label i = 0; i < d; ++i)
        {
            for (label j = 0; j < d; ++j)
            {
                s.F[(a*d + i)*d + j] += grad[j*data_.strideG + i];
            }
        }
        findKinematics(a);
    }
}


void Foam::paperBody::findKinematics(const label node)
{
    conservedState& s = data_.state;
    withDirections(s.nDim, [&](auto D)
    {
        const SolidTensor<D.value> F = loadF<D.value>(s.F.cdata(), node);
        const SolidTensor<D.value> H = cofactor(F);
        const scalar J = determinant(F, H);
        for (label k = 0; D.value == 3 && k < s.strideH; ++k)
        {
            s.H[9*node + placeH(k)] = H.in[k];
        }
        if (D.value == 2 && s.solvesH) s.H[node] = J;
        if (s.solvesJ) s.J[node] = J;
    });
}


void Foam::paperBody::reportScheme(Ostream& os) const
{
    const label d = dual_.nDim();
    const conservedState& s = data_.state;
    const auto onOff = [](const bool on) { return on ? "on" : "off"; };

    os  << ", reconstruction "
        << schemeOptions::reconstructionNames[options_.reconstruction]
        << ", limiter " << schemeOptions::limiterNames[options_.limiter]
        << nl
        << "    kinematics "
        << conservedState::kinematicSetNames
           [
               !s.solvesJ ? kinematicSet::F
             : s.solvesH || d == 1 ? options_.kinematics
             : kinematicSet::FJ
           ]
        << (data_.finiteStrain ? "" : " (small strains need no more)")
        << ", jacobian "
        << (
               data_.finiteStrain
             ? materialModel::jacobianFormNames[options_.jacobian]
             : word("none")
           )
        << nl
        << "    stored per node: momentum " << d << ", displacement " << d
        << ", F " << d*d << ", H " << s.strideH << ", J "
        << label(s.solvesJ) << ", stress " << d*d + data_.nSJ
        << " components" << nl
        << "    H solved " << onOff(s.solvesH)
        << ", J solved " << onOff(s.solvesJ)
        << ", gradients " << onOff
           (
               data_.reconstruction != reconstructionType::none
           )
        << ", limiter " << onOff(options_.limiter != limiterType::none)
        << ", dissipation " << options_.dissipation
        << ", waves " << (stretchedWaves_ ? "stretched" : "linear");
}


void Foam::paperBody::computeGradients(const bool withNodes)
{
    kernel_->gradients();
    for (const dualPatch& patch : dual_.patches())
    {
        if (patch.nFaces() && !mirrorPatches_.found(patch.patchIndex))
        {
            kernel_->addBoundaryGradients
            (
                patch, withNodes ? nullptr : statesOf(patch.patchIndex)
            );
        }
    }
    dual_.sharing().sum(data_.grad.data(), dual_.nDim()*data_.strideG);
    if (symmetry_.active())
    {
        symmetriseGradients();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::paperBody::paperBody
(
    autoPtr<polyMesh>& mesh,
    const schemeOptions& options
)
:
    solidBody(mesh, options, kinematicsOf),
    kernel_(vertexKernel::New(data_)),
    boundaryArea_(dual_.nNodes(), Zero)
{
    // Boundary areas belong to the surface of a dual cell, too, except those of
    // mirrors, which are inside the whole body
    for (const dualPatch& patch : dual_.patches())
    {
        if (!mirrorPatches_.found(patch.patchIndex))
        {
            forAll(patch.cornerNode, k)
            {
                boundaryArea_[patch.cornerNode[k]] += patch.cornerArea[k];
            }
        }
    }
    dual_.sharing().sum(boundaryArea_.data(), 1);
    readState();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::paperBody::prepare(const scalar time, const bool moved)
{
    kernel_->velocities();
    if (moved)
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
        if (stretchedWaves_)
        {
            passTimes::timed(passTimes::waveSpeeds, [&]
            {
                material_->waveFactors(data_.state, data_.waveFactor);
            });
        }
    }
    solveConditions(time);

    if (contact_.on())
    {
        contact_.force = vector::zero;
        contact_.area = Zero;
        contact_.gap = GREAT;
    }
}


void Foam::paperBody::computeFluxes(const bool energy)
{
    // Pass A: gradients, and nodes
    typedef passTimes times;
    times::timed(times::gradients, [&] { computeGradients(); });

    // Pass B: limiter and fluxes
    data_.numericalDissipation = 0;
    powers_ = powers();
    times::timed(times::fluxes, [&] { kernel_->fluxes(energy); });
    for (const dualPatch& patch : dual_.patches())
    {
        const label patchi = patch.patchIndex;
        if (patch.nFaces() && !mirrorPatches_.found(patchi))
        {
            const scalar power = kernel_->addBoundaryFluxes
            (
                patch, statesOf(patchi), energy
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


void Foam::paperBody::finishRates(const scalar time, const bool energy)
{
    evaluated_ = true;
    reusable_ = true;
    addBodyForces(time, energy);
    if (symmetry_.active())
    {
        symmetry_.project(data_.rates.data(), data_.strideRates);
        if (options_.reconstruction == reconstructionType::full)
        {
            const label d = dual_.nDim();
            symmetry_.symmetrise
            (
                data_.rates.data() + data_.offsetRateF(), data_.strideRates,
                identity(d*d), 2
            );
        }
    }
}


Foam::label Foam::paperBody::advance
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
        return kernel_->advance(deltaT, oldWeight, part);
    });
}


void Foam::paperBody::restoreOld()
{
    data_.state.assignSolved(data_.old);
    data_.state.sinceCommit = 0;
    restorePlasticity();
}


// ************************************************************************* //
