/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "Time.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "slipPointPatchField.H"
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
    mesh_(*ownMesh_),
    options_(options),
    dual_(mesh_, options_.cells),
    material_(readMaterial()),
    pointUFile_(regionFiles::velocityFile(mesh_)),
    pointU_
    (
        IOobject
        (
            "pointU", time_.timeName(), mesh_,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        pointMesh::New(mesh_),
        regionFiles::velocity(mesh_)
    ),
    data_
    (
        dual_, options_, kinematics(options_, *material_),
        material_->finiteStrain(), material_->rho(), material_->cp(),
        material_->cs()
    ),
    mirrorPatches_(findMirrors(mesh_, pointU_)),
    symmetry_(dual_, mirrorPatches_),
    corners_(mesh_.boundaryMesh().size()),
    surfaces_(mesh_.boundaryMesh().size()),
    gravity_(dual_.nDim(), Zero),
    ownedVolume_(dual_.ownedVolume()),
    contact_(data_, symmetry_, held_)
{
    makeCorners();
    checkMotions();
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::solidBody::reportBytes(Ostream& os) const
{
    const label nNodes = returnReduce(dual_.nNodes(), sumOp<label>());
    const scalar allBytes = returnReduce(scalar(bytes()), sumOp<scalar>());
    os  << nl << "    " << label(allBytes/max(nNodes, label(1)))
        << " bytes per node" << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::solidBody::displacedVolume() const
{
    vector all(Zero);
    forAll(ownedVolume_, a)
    {
        all +=
            ownedVolume_[a]
           *expand(data_.state.disp.cdata() + a*dual_.nDim());
    }
    return all;
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


Foam::vector Foam::solidBody::stepVelocity(const label node) const
{
    const label d = dual_.nDim();
    if (inBlock())
    {
        return expand(block_->path.cdata() + d*node);
    }
    return expand(data_.state.lm.cdata() + d*node)/data_.rho;
}


Foam::vector Foam::solidBody::meanStepVelocity(const label node) const
{
    const label d = dual_.nDim();
    if (inBlock())
    {
        return expand(block_->mean.cdata() + d*node);
    }
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


void Foam::solidBody::write()
{
    placeAll();

    // Velocity, with its boundary conditions
    {
        vectorField& U = pointU_.primitiveFieldRef();
        forAll(U, i) U[i] = velocity(dual_.pointNode()[i]);
        pointU_.instance() = time_.timeName();
        pointU_.write();
        writtenTimes::check(pointU_);
    }

    bodyFields(*this).write();
}


Foam::nodalField Foam::solidBody::field
(
    const word& name,
    const labelUList& nodes
) const
{
    placeAll();
    return bodyFields(*this).field(name, nodes);
}


std::size_t Foam::solidBody::bytes() const
{
    return data_.bytes() + dual_.bytes() + contact_.bytes();
}


// ************************************************************************* //
