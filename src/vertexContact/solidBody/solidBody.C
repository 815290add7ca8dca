/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBody.H"
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
