/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "variationalBody.H"
#include "paperBody.H"
#include "rigidRegion.H"
#include "rigidMaterial.H"
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
#include "passTimes.H"
#include "regionFiles.H"
#include "writtenTimes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidBody::solidBody
(
    autoPtr<polyMesh>& mesh,
    const schemeOptions& options,
    kinematicsRule kinematics
)
:
    ownMesh_(mesh.ptr()),
    time_(ownMesh_->time()),
    name_(ownMesh_->name()),
    mesh_(const_cast<polyMesh&>(*ownMesh_)),
    options_(options),
    dual_(mesh_, options_.cells),
    material_(readMaterial()),
    pointUFile_(regionFiles::velocityFile(mesh_)),
    pointU_
    (
        IOobject
        (
            "pointU", time_.timeName(), mesh_,
            IOobject::NO_READ, IOobject::NO_WRITE
        ),
        pointMesh::New(mesh_),
        regionFiles::velocity(mesh_)
    ),
    data_
    (
        dual_, options_.scheme == schemeType::variational,
        kinematics(options_, *material_), material_->finiteStrain(),
        options_.scheme == schemeType::variational
      ? reconstructionType::none : options_.reconstruction,
        options_.limiter, options_.dissipation,
        material_->rho(), material_->cp(), material_->cs()
    ),
    mirrorPatches_(findMirrors(mesh_, pointU_)),
    symmetry_(dual_, mirrorPatches_),
    corners_(mesh_.boundaryMesh().size()),
    surfaces_(mesh_.boundaryMesh().size()),
    gravity_(dual_.nDim(), Zero),
    ownedVolume_(dual_.nodeVolume()),
    contact_(data_, symmetry_, held_)
{
    forAll(ownedVolume_, a)
    {
        if (!dual_.sharing().owned()[a]) ownedVolume_[a] = 0;
    }
    makeCorners();
    checkMotions();
}


Foam::autoPtr<Foam::solidBody> Foam::solidBody::New
(
    const Time& runTime,
    const word& region,
    const schemeOptions& defaults
)
{
    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            IOobject(region, runTime.timeName(), runTime, IOobject::MUST_READ)
        )
    );
    const schemeOptions options(regionFiles::schemes(*mesh), defaults);
    const bool variational = options.scheme == schemeType::variational;

    autoPtr<solidBody> body;
    if (rigidMaterial::describedBy(regionFiles::material(*mesh)))
    {
        body.reset(new rigidRegion(mesh, options));
    }
    else if (variational)
    {
        body.reset(new variationalBody(mesh, options));
    }
    else
    {
        body.reset(new paperBody(mesh, options));
    }
    return body;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

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


void Foam::solidBody::solveConditions(const scalar time)
{
    passTimes::timed(passTimes::boundaries, [&]
    {
        forAll(corners_, patchi)
        {
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
}


void Foam::solidBody::reportBytes(Ostream& os) const
{
    const label nNodes = returnReduce(dual_.nNodes(), sumOp<label>());
    const scalar allBytes = returnReduce(scalar(bytes()), sumOp<scalar>());
    os  << nl << "    " << label(allBytes/max(nNodes, label(1)))
        << " bytes per node" << nl;
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
    const tensor local
    (
        material_->CauchyStress(data_.state, node)
      + addedSigmaJ(node)*tensor(tensor::I)
    );

    // J sigma = P F^T is symmetric up to the drift of H and J
    return symm(inSpace(local));
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


const Foam::boundBox& Foam::solidBody::surfaceVelocities
(
    const label patchi,
    const scalar time
)
{
    bodySurface& its = surfaces_[patchi];
    if (its.velocityTime == time) return its.velocities;

    scalar least[3] = {}, most[3] = {};
    withDirections(dual_.nDim(), [&](auto D)
    {
        constexpr int d = D.value;
        const scalar* lm = data_.state.lm.cdata();
        if (its.nodes.empty()) return;
        for (int i = 0; i < d; ++i)
        {
            least[i] = most[i] = lm[its.nodes[0]*d + i];
        }
        for (const label a : its.nodes)
        {
            for (int i = 0; i < d; ++i)
            {
                least[i] = min(least[i], lm[a*d + i]);
                most[i] = max(most[i], lm[a*d + i]);
            }
        }
    });
    const boundBox now(expand(least)/data_.rho, expand(most)/data_.rho);
    its.velocities = its.velocityTime > -GREAT ? its.lastVelocities : now;
    its.velocities.min() = min(its.velocities.min(), now.min());
    its.velocities.max() = max(its.velocities.max(), now.max());
    its.lastVelocities = now;
    its.velocityTime = time;
    return its.velocities;
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
        dual_.sharing(), contact_.nodes(),
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


Foam::label Foam::solidBody::findNodeFasterThan(const scalar speed) const
{
    const label d = dual_.nDim();
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        if (mag(expand(data_.state.lm.cdata() + a*d)) >= speed*data_.rho)
        {
            return a;
        }
    }
    return -1;
}


Foam::scalar Foam::solidBody::largestSpeed() const
{
    const label d = dual_.nDim();
    placeAll();
    scalar largest = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        largest = max(largest, mag(expand(data_.state.lm.cdata() + a*d)));
    }
    return largest/data_.rho;
}


Foam::vector Foam::solidBody::meanVelocity() const
{
    return
        returnReduce(linearMomentum(), sumOp<vector>())
       /returnReduce(mass(), sumOp<scalar>());
}


void Foam::solidBody::setGravity(const vector& g)
{
    for (label i = 0; i < dual_.nDim(); ++i)
    {
        gravity_[i] = g[dual_.directions()[i]];
    }
}


void Foam::solidBody::scaleMass(const scalar factor, const scalar before)
{
    if (factor != before)
    {
        for (scalar& lm : data_.state.lm) lm *= factor/before;
    }
    if (factor == 1) return;

    material_->scaleMass(factor);
    data_.rho = material_->rho();
    data_.cp = material_->cp();
    data_.cs = material_->cs();
    forAll(corners_, patchi)
    {
        if (!corners_.set(patchi)) continue;
        corners_[patchi].zp = data_.rho*data_.cp;
        corners_[patchi].zs = data_.rho*data_.cs;
    }
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


void Foam::solidBody::write()
{
    placeAll();

    // Velocity, with its boundary conditions
    {
        vectorField& U = pointU_.primitiveFieldRef();
        forAll(U, i)
        {
            const label a = dual_.pointNode()[i];
            for (label k = 0; k < dual_.nDim(); ++k)
            {
                U[i][dual_.directions()[k]] = velocity(a, k);
            }
        }
        pointU_.instance() = time_.timeName();
        pointU_.write();
        writtenTimes::check(pointU_);
    }

    bodyFields(*this).write();
}


Foam::nodalField Foam::solidBody::field(const word& name) const
{
    placeAll();
    return bodyFields(*this).field(name);
}


std::size_t Foam::solidBody::bytes() const
{
    return data_.bytes() + dual_.bytes() + contact_.bytes();
}


// ************************************************************************* //
