/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Nodes with prescribed motion: which motions are valid, and which nodes they
    hold; and the effect of damping on velocities.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "solidBoundaryCondition.H"
#include "prescribedMotion.H"
#include "dictionaryCheck.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::solidBody::dampedVelocity
(
    const label node,
    const label i
) const
{
    // Advance by half a kick, as in the leapfrog
    const label d = dual_.nDim();
    const scalar* lm = data_.state.lm.cdata() + node*d;
    if (!evaluated_ || lastStep_ <= 0) return lm[i]/data_.rho;
    const scalar half = 0.5*lastStep_;
    const scalar T = damping_->tanhOf(half);
    const scalar* rate = data_.rates.cdata() + node*data_.strideRates;
    scalar change[3];
    for (label j = 0; j < d; ++j)
    {
        change[j] = (half*rate[j] - 2*T*lm[j])/(1 + T);
    }
    held_.freePart(node, change);
    return (lm[i] + change[i])/data_.rho;
}


void Foam::solidBody::checkMotions() const
{
    const FixedList<label, 3>& dir = dual_.directions();
    forAll(corners_, patchi)
    {
        if (!corners_.set(patchi)) continue;
        const pointPatchField<vector>& pf = pointU_.boundaryField()[patchi];
        const solidBoundaryCondition& its = condition(patchi);
        const prescribedMotion* motion = its.motion();
        dictionaryCheck::warnLeftOut
        (
            "Region " + name() + ", patch " + pf.patch().name(),
            !motion ? "traction"
          : motion->ofDisplacement() ? "displacement" : "velocity",
            mesh_.time(),
            [&](const scalar time) { return its.given(time); },
            [&](const vector& v) { return dual_.projected(v); }
        );
        if (!motion) continue;

        const bool partly = motion->ofDisplacement() || !motion->complete();
        if (!data_.variational && partly)
        {
            FatalFileErrorInFunction(pointUFile_)
                << "Keyword 'boundaryField': patch '" << pf.patch().name()
                << "' of type '" << pf.type() << "' prescribes "
                << (
                       motion->ofDisplacement()
                     ? "a displacement" : "a part of the velocity"
                   )
                << ". With 'preset paper' a patch can only prescribe the whole "
                << "velocity"
                << exit(FatalIOError);
        }

        for (const vector& direction : motion->directions())
        {
            wordList valid(dual_.nDim());
            for (label i = 0; i < dual_.nDim(); ++i)
            {
                valid[i] = word(vector::componentNames[dir[i]]);
            }
            const vector out(direction - dual_.projected(direction));
            if (mag(out) > medianDual::leaves)
            {
                FatalFileErrorInFunction(pointUFile_)
                    << "Keyword 'boundaryField': patch '" << pf.patch().name()
                    << "' of type '" << pf.type() << "' has 'components' or a "
                    << "'direction' along (" << direction.x() << ' '
                    << direction.y() << ' ' << direction.z()
                    << "), which the mesh leaves out (empty). "
                    << "Valid components: "
                    << dictionaryCheck::listed(valid).c_str()
                    << exit(FatalIOError);
            }
        }
    }
}


void Foam::solidBody::findSurfaceNodes()
{
    DynamicList<heldNodes::condition> motions;
    scalarField touches(dual_.nNodes(), Zero);
    for (const dualPatch& patch : dual_.patches())
    {
        const label patchi = patch.patchIndex;
        if (!corners_.set(patchi)) continue;
        const solidBoundaryCondition& its = condition(patchi);
        if (its.motion())
        {
            motions.append(heldNodes::condition{patchi, its.motion()});
        }
        if (its.contact())
        {
            for (const label a : patch.cornerNode) touches[a] = 1;
        }
    }
    held_ = heldNodes(dual_, symmetry_, motions);

    contact_.findNodes(touches);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidBody::checkStart(const scalar time)
{
    forAll(corners_, patchi)
    {
        const prescribedMotion* motion =
            corners_.set(patchi) ? condition(patchi).motion() : nullptr;
        if (!motion || !motion->ofDisplacement()) continue;

        // Nodes that other patches hold, too, may be elsewhere: take the least
        const vector given(motion->value(time));
        const dualPatch& patch = dual_.patches()[patchi];
        scalar least = GREAT;
        forAll(patch.cornerNode, k)
        {
            const vector jump
            (
                dual_.projected(given)
              - expand
                (
                    data_.state.disp.cdata() + patch.cornerNode[k]*dual_.nDim()
                )
            );
            scalar length = motion->complete() ? mag(jump) : 0;
            for (const vector& direction : motion->directions())
            {
                length = max(length, mag(direction & jump));
            }
            least = min(least, length/surfaces_[patchi].depth[k]);
        }
        reduce(least, minOp<scalar>());
        if (least > largestJump && least < GREAT)
        {
            FatalFileErrorInFunction(pointUFile_)
                << "Keyword 'boundaryField': patch '"
                << pointU_.boundaryField()[patchi].patch().name()
                << "' has a 'displacement' of " << given
                << " m at the start, time " << time
                << " s, but pointD gives its nodes another position. The "
                << "surface would jump by " << least << " of its cell size, "
                << "and at most " << largestJump << " is allowed"
                << exit(FatalIOError);
        }
    }
}


void Foam::solidBody::accountReactions()
{
    reactions_.reset
    (
        new constraintReactions
        (
            held_, symmetry_, contact_.nodes(), mesh_.boundaryMesh().size(),
            dual_.nDim()
        )
    );
}


Foam::labelList Foam::solidBody::reactingPatches() const
{
    labelHashSet patches(mirrorPatches_);
    patches.insert(held_.patches());
    return patches.sortedToc();
}


// ************************************************************************* //
