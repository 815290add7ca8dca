/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The surface of a body: its boundary conditions, and the surface data that
    contact needs.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "bodyThickness.H"
#include "dictionaryCheck.H"
#include "emptyPolyPatch.H"
#include "fileError.H"
#include "OStringStream.H"
#include "passTimes.H"
#include "patchRim.H"
#include "processorPolyPatch.H"
#include "solidBoundaryCondition.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
        patch.addAreas(area);
        dual_.sharing().sum(area.data(), d);

        bodySurface& its = surfaces_[patchi];
        if (bc.contact() && data_.variational)
        {
            its.rim = patchRim::corners(mesh_, patch);
            its.rimNode = patchRim::nodes(mesh_, patch, its.rim);
            its.ends = patchRim::ends(mesh_, patch, its.rim, mirrorPatches_);
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
            << "', which is not a condition for solids." << nl
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
            if (!corners_.set(patchi)) continue;
            const solidBoundaryCondition& bc = condition(patchi);
            const bool elsewhere = bc.contact() || bc.isPressure();
            if (data_.variational && elsewhere) continue;
            findCorners(patchi);
            bc.solve(time, corners_[patchi]);
        }
    });
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


void Foam::solidBody::findCorners(const label patchi)
{
    cornerStates& c = corners_[patchi];
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();
    const scalar perRho = 1/data_.rho;
    forAll(c.geometry.cornerNode, k)
    {
        const label a = c.geometry.cornerNode[k];
        const scalar* N = c.geometry.cornerNormal.cdata() + d*k;
        const scalar* lm = data_.state.lm.cdata() + a*d;
        const scalar* P =
            data_.W.cdata() + a*data_.strideW + data_.offsetP();

        const vector area(currentArea(a, N));
        c.stretch[k] = mag(area);
        c.n[k] = area/c.stretch[k];
        for (label i = 0; i < d; ++i)
        {
            scalar PN = 0;
            for (label j = 0; j < d; ++j) PN += P[j*d + i]*N[j];
            c.v[k][dir[i]] = perRho*lm[i];
            c.t[k][dir[i]] = PN;
        }
        if (data_.waveFactor.size()) c.waveFactor[k] = data_.waveFactor[a];
        c.force[k] = vector::zero;
    }
}


Foam::vector Foam::solidBody::surfaceAround
(
    const label patchi,
    const label k
) const
{
    const scalarField& nodeArea = surfaces_[patchi].nodeArea;
    if (nodeArea.empty()) return vector::zero;

    return currentArea
    (
        dual_.patches()[patchi].cornerNode[k],
        nodeArea.cdata() + k*dual_.nDim()
    );
}


Foam::scalar Foam::solidBody::surfaceArea
(
    const label patchi,
    const label k
) const
{
    // Area along the corner's own normal
    const label d = dual_.nDim();
    const dualPatch& patch = dual_.patches()[patchi];
    const scalar* all = surfaces_[patchi].nodeArea.cdata() + k*d;
    scalar along = 0;
    for (label i = 0; i < d; ++i) along += all[i]*patch.cornerNormal[k*d + i];
    return max(along, patch.cornerArea[k]);
}


Foam::scalar Foam::solidBody::deepestContact() const
{
    scalar most = 0;
    for (const label patchi : contactPatches())
    {
        for (const scalar depth : surfaces_[patchi].depth)
        {
            most = max(most, depth);
        }
    }
    return most;
}


void Foam::solidBody::findThickness(const scalar within)
{
    const labelList patches(contactPatches());
    List<scalarField> all
    (
        bodyThickness::behind(mesh_, patches, mirrorPatches_, within)
    );
    forAll(patches, i) surfaces_[patches[i]].thickness.transfer(all[i]);
}


Foam::labelList Foam::solidBody::pressedInside(const scalar share) const
{
    DynamicList<label> nodes;
    if (!contact_.on()) return nodes;

    for (const label patchi : contactPatches())
    {
        const labelList& cornerNode = dual_.patches()[patchi].cornerNode;
        const scalarField& depth = surfaces_[patchi].depth;
        forAll(cornerNode, k)
        {
            const label a = cornerNode[k];
            if (contact_.touches(a) && contact_.gap[a] < -share*depth[k])
            {
                nodes.append(a);
            }
        }
    }
    return nodes;
}


Foam::string Foam::solidBody::whereIs(const label node) const
{
    OStringStream os;
    os  << "node at " << meshPoint(node) << " (reference) " << position(node)
        << " (current)";
    return os.str();
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
    if (slide.valid()) contact_.slide.ways() = slide();
}


void Foam::solidBody::finishSlide()
{
    contact_.slide.finish
    (
        dual_.sharing(), contact_.nodes(),
        [this](const label a) { return deformationGradient(a); }
    );
}


// ************************************************************************* //
