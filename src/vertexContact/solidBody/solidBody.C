/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "passTimes.H"
#include "fileError.H"
#include "Time.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "slipPointPatchField.H"
#include "solidBoundaryCondition.H"
#include "dictionaryCheck.H"
#include "patchRim.H"
#include "pointPatchFields.H"
#include "regionFiles.H"
#include "rigidMaterial.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of a rigid body, steps in a radian: contact, found at the start of a step,
//  is where it acts, but for a twentieth of the lever
constexpr scalar stepsPerTurn = 3;

bool isVariational(const schemeOptions& options)
{
    return options.scheme == schemeType::variational;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::solidBody::PoissonsRatio(const materialModel& material)
{
    const scalar mu = material.mu(), kappa = material.kappa();
    return (3*kappa - 2*mu)/(2*(3*kappa + mu));
}


Foam::kinematicSet Foam::solidBody::kinematicsOf
(
    const schemeOptions& options,
    const materialModel& material
)
{
    if (!isVariational(options)) return options.kinematics;

    return
        options.volume == volumeTreatment::smoothed
     || (
            options.volume == volumeTreatment::automatic
         && PoissonsRatio(material) >= smoothedFrom
        )
      ? kinematicSet::FJ
      : kinematicSet::F;
}



Foam::labelList Foam::solidBody::findMirrors
(
    const polyMesh& mesh,
    const pointVectorField& pointU
)
{
    DynamicList<label> mirrors;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if
        (
            isA<symmetryPolyPatch>(pp)
         || isA<symmetryPlanePolyPatch>(pp)
         || isA<slipPointPatchField<vector>>
            (
                pointU.boundaryField()[pp.index()]
            )
        )
        {
            mirrors.append(pp.index());
        }
    }
    return labelList(mirrors);
}


const Foam::solidBoundaryCondition& Foam::solidBody::condition
(
    const label patchi
) const
{
    const auto& pf = pointU_.boundaryField()[patchi];

    const auto* bc = dynamic_cast<const solidBoundaryCondition*>(&pf);

    if (!bc)
    {
        FatalFileErrorInFunction(pointUFile_)
            << "Keyword 'boundaryField': patch '" << pf.patch().name()
            << "' has the boundary condition '" << pf.type()
            << "', which is not one of a solid." << nl
            << "Valid conditions: "
            << dictionaryCheck::listed(solidBoundaryCondition::names()).c_str()
            << exit(FatalIOError);
    }

    return *bc;
}


void Foam::solidBody::makeCorners()
{
    bool hasContact = false;
    const label d = dual_.nDim();

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label patchi = pp.index();
        if
        (
            isA<emptyPolyPatch>(pp)
         || isA<processorPolyPatch>(pp)
         || mirrorPatches_.found(patchi)
        )
        {
            continue;
        }

        const solidBoundaryCondition& bc = condition(patchi);
        hasContact = hasContact || bc.contact();

        // The variational scheme needs no states of a free surface
        if (bc.tractionFree() && data_.variational) continue;

        const dualPatch& patch = dual_.patches()[patchi];
        corners_.set
        (
            patchi,
            new cornerStates
            (
                patch,
                material_->rho()*material_->cp(),
                material_->rho()*material_->cs()
            )
        );

        // Area vector of the patch at each node: volume over area is half
        // the thickness of the boundary cell
        scalarField area(dual_.nNodes()*d, Zero);
        forAll(patch.cornerNode, k)
        {
            for (label i = 0; i < d; ++i)
            {
                area[patch.cornerNode[k]*d + i] +=
                    patch.cornerArea[k]*patch.cornerNormal[k*d + i];
            }
        }
        dual_.sharing().sum(area.data(), d);

        bodySurface& its = surfaces_[patchi];
        if (bc.contact() && data_.variational)
        {
            its.rim = patchRim::corners(mesh_, patch, d);
            its.rimNode = patchRim::nodes(mesh_, patch, d, its.rim);
        }

        scalarField& depth = its.depth;
        depth.setSize(patch.nCorners());
        forAll(patch.cornerNode, k)
        {
            const label a = patch.cornerNode[k];
            scalar along = 0;
            for (label i = 0; i < d; ++i)
            {
                along += area[a*d + i]*patch.cornerNormal[k*d + i];
            }
            depth[k] =
                2*dual_.nodeVolume()[a]/max(along, patch.cornerArea[k]);
        }
        if (bc.contact())
        {
            its.findNodes(patch);
            its.findSizes(dual_, patch);
        }
    }

    if (hasContact) contact_.start();
}


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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidBody::solidBody
(
    const Time& runTime,
    const word& region,
    const schemeOptions& defaults
)
:
    time_(runTime),
    name_(region),
    mesh_
    (
        IOobject(region, runTime.timeName(), runTime, IOobject::MUST_READ)
    ),
    options_(regionFiles::schemes(mesh_), defaults),
    dual_(mesh_, options_.cells),
    material_(readMaterial()),
    pointUFile_(regionFiles::velocityFile(mesh_)),
    pointU_
    (
        IOobject
        (
            "pointU", runTime.timeName(), mesh_,
            IOobject::NO_READ, IOobject::NO_WRITE
        ),
        pointMesh::New(mesh_),
        regionFiles::velocity(mesh_)
    ),
    data_
    (
        dual_, isVariational(options_), kinematicsOf(options_, *material_),
        material_->finiteStrain(),
        isVariational(options_)
      ? reconstructionType::none : options_.reconstruction,
        options_.limiter, options_.dissipation,
        material_->rho(), material_->cp(), material_->cs()
    ),
    mirrorPatches_(findMirrors(mesh_, pointU_)),
    symmetry_(dual_, mirrorPatches_),
    stretchedWaves_
    (
        (options_.stretchedWaves || data_.variational)
     && material_->stretchesWaves()
    ),
    corners_(mesh_.boundaryMesh().size()),
    surfaces_(mesh_.boundaryMesh().size()),
    boundaryArea_(dual_.nNodes(), Zero),
    gravity_(dual_.nDim(), Zero),
    bodyForces_
    (
        bodyForce::readAll
        (
            regionFiles::bodyForces(mesh_), dual_, *material_
        )
    ),
    acceleration_
    (
        bodyForces_.size() ? dual_.nNodes()*dual_.nDim() : label(0), Zero
    ),
    contact_(data_, symmetry_, held_)
{
    // Boundary areas, too, belong to the surface of a dual cell; those of
    // mirrors lie inside the whole body
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

    if (symmetry_.active())
    {
        data_.mirrorArea = dual_.edgeArea();
        symmetry_.projectEdges(dual_, data_.mirrorArea);
    }

    if (material_->plastic())
    {
        // The old state of a step needs none: it is committed at the end
        data_.state.makePlastic();
        if (data_.variational) data_.state.keepFlow();
        const scalar T0 = material_->initialTemperature();
        if (T0 > 0) data_.state.makeHeated(T0);
    }
    ownedVolume_ = dual_.nodeVolume();
    forAll(ownedVolume_, a)
    {
        if (!dual_.sharing().owned()[a]) ownedVolume_[a] = 0;
    }

    if (stretchedWaves_)
    {
        data_.waveFactor.setSize(dual_.nNodes(), scalar(1));
    }

    makeCorners();
    checkMotions();
    if (isA<rigidMaterial>(*material_))
    {
        makeRigid();
        variational_ = variationalKernel::New(data_);
        findSurfaceNodes();
    }
    else if (data_.variational)
    {
        variational_ = variationalKernel::New(data_);
        scheme_.reset
        (
            new variationalScheme
            (
                data_, *variational_, *material_, symmetry_, options_,
                mirrorPatches_
            )
        );
        // The scheme has them in blocks
        dual_.forgetEdgeArea();
        data_.mirrorArea.clear();
        findSurfaceNodes();
        externalForce_.setSize(dual_.nNodes()*dual_.nDim(), Zero);
        work_.setSize(dual_.nNodes()*dual_.nDim(), Zero);
        if (contact_.on()) findCompliances();
    }
    else
    {
        kernel_ = vertexKernel::New(data_);
    }
    readState();
    if (rigid_.valid()) fitRigid();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::solidBody::contactPatch
(
    const dictionary& dict,
    const word& keyword,
    const word& patch
) const
{
    const label patchi = mesh_.boundaryMesh().findPatchID(patch);

    if (patchi < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "': region '" << name_
            << "' has no patch '" << patch << "'." << nl
            << "Its patches: "
            << dictionaryCheck::listed(mesh_.boundaryMesh().names()).c_str()
            << exit(FatalIOError);
    }

    const auto& pf = pointU_.boundaryField()[patchi];
    const auto* bc = dynamic_cast<const solidBoundaryCondition*>(&pf);
    if (!bc || !bc->contact())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "': patch '" << patch
            << "' of region '" << name_ << "' has the type '"
            << pf.type() << "' in " << pointUFile_
            << ": it must be 'contact'" << exit(FatalIOError);
    }

    return patchi;
}


Foam::labelList Foam::solidBody::contactPatches() const
{
    DynamicList<label> patches;
    forAll(corners_, patchi)
    {
        if (corners_.set(patchi) && condition(patchi).contact())
        {
            patches.append(patchi);
        }
    }
    return labelList(patches);
}


Foam::tensor Foam::solidBody::deformationGradient(const label node) const
{
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();

    tensor F(tensor::I);
    for (label i = 0; i < d; ++i)
    {
        for (label j = 0; j < d; ++j)
        {
            F[3*dir[i] + dir[j]] = data_.state.F[(node*d + i)*d + j];
        }
    }
    return F;
}


Foam::vector Foam::solidBody::currentArea
(
    const label node,
    const scalar* N
) const
{
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();

    vector area(Zero);
    if (!data_.finiteStrain || d == 1)
    {
        // In uniaxial strain the cofactor is 1
        for (label i = 0; i < d; ++i) area[dir[i]] = N[i];
    }
    else if (d == 2)
    {
        scalar c[2];
        planeArea(data_.state.F.cdata() + 4*node, N[0], N[1], c);
        for (label i = 0; i < 2; ++i) area[dir[i]] = c[i];
    }
    else
    {
        const SolidTensor<3> F(loadF<3>(data_.state.F.cdata(), node));
        const SolidTensor<3> H
        (
            data_.state.strideH
          ? loadH<3>(F, data_.state.H.cdata(), node)
          : cofactor(F)
        );
        for (label i = 0; i < 3; ++i)
        {
            area[i] = H(i, 0)*N[0] + H(i, 1)*N[1] + H(i, 2)*N[2];
        }
    }
    return area;
}


Foam::FixedList<Foam::label, 3> Foam::solidBody::allDirections() const
{
    FixedList<label, 3> dir(dual_.directions());
    label next = dual_.nDim();
    for (label c = 0; c < 3; ++c)
    {
        bool used = false;
        for (label i = 0; i < dual_.nDim(); ++i) used = used || dir[i] == c;
        if (!used) dir[next++] = c;
    }
    return dir;
}


Foam::tensor Foam::solidBody::inSpace(const tensor& local) const
{
    const FixedList<label, 3> dir(allDirections());
    tensor T(Zero);
    for (label i = 0; i < 3; ++i)
    {
        for (label j = 0; j < 3; ++j)
        {
            T[3*dir[i] + dir[j]] = local[3*i + j];
        }
    }
    return T;
}


Foam::symmTensor Foam::solidBody::CauchyStress(const label node) const
{
    tensor local(material_->CauchyStress(data_.state, node));
    if (scheme_.valid() && evaluated_)
    {
        // The pressure that acts
        local += scheme_->addedSigmaJ(node)*tensor(tensor::I);
    }

    // J sigma = P F^T is symmetric up to the drift of H and J
    return symm(inSpace(local));
}


void Foam::solidBody::setGravity(const vector& g)
{
    for (label i = 0; i < dual_.nDim(); ++i)
    {
        gravity_[i] = g[dual_.directions()[i]];
    }
    if (rigid_.valid()) rigid_->setGravity(expand(gravity_.cdata()));
}


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


Foam::scalar Foam::solidBody::commitPlasticity()
{
    return
        material_->plastic()
      ? material_->commit(data_.state, ownedVolume_)
      : 0;
}


void Foam::solidBody::restoreOld()
{
    if (reactions_.valid()) reactions_->restore();
    if (rigid_.valid())
    {
        rigid_->restore(block_.valid());
        lastStep_ = block_.valid() ? block_->lastStep : oldStep_;
        placeSurface();
        return;
    }
    if (data_.variational)
    {
        data_.state.lm = block_.valid() ? block_->lm : data_.old.lm;
        data_.state.disp = block_.valid() ? block_->disp : data_.old.disp;
        if (block_.valid()) scheme_->acceleration() = block_->acceleration;
        else scheme_->restoreAcceleration();
        lastStep_ = block_.valid() ? block_->lastStep : oldStep_;
        if (block_.valid()) block_->inside = false;
        scheme_->forget();
    }
    else
    {
        data_.state.assignSolved(data_.old);
    }
    data_.state.sinceCommit = 0;
    keptPlasticity_.restore(data_.state);
}


// ************************************************************************* //
