/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Nodes whose motion is prescribed: what may be, and the reactions.

    The reaction of a node is what the step applies to it: mass times the
    difference of the velocity it is given and the one that all other forces
    would give it, by the time for which they act. Nodes of prescribed motion
    in all directions belong to the first of their patches; otherwise each
    patch has the part of the force that is along its own directions.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "solidBoundaryCondition.H"
#include "prescribedMotion.H"
#include "dictionaryCheck.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Largest jump of a surface at the start, by the thickness of its cells: the
//  strain that they get with the first step
constexpr Foam::scalar largestJump = 1e-3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidBody::checkMotions() const
{
    const FixedList<label, 3>& dir = dual_.directions();
    forAll(corners_, patchi)
    {
        const prescribedMotion* motion =
            corners_.set(patchi) ? condition(patchi).motion() : nullptr;
        if (!motion) continue;

        const pointPatchField<vector>& pf = pointU_.boundaryField()[patchi];
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
                << ". 'preset paper' takes all of the velocity only"
                << exit(FatalIOError);
        }

        for (const vector& direction : motion->directions())
        {
            vector out(direction);
            wordList valid(dual_.nDim());
            for (label i = 0; i < dual_.nDim(); ++i)
            {
                out[dir[i]] = 0;
                valid[i] = word(vector::componentNames[dir[i]]);
            }
            if (mag(out) > 1e-6)
            {
                FatalFileErrorInFunction(pointUFile_)
                    << "Keyword 'boundaryField': patch '" << pf.patch().name()
                    << "' of type '" << pf.type() << "' has 'components' or a "
                    << "'direction' (" << direction.x() << ' '
                    << direction.y() << ' ' << direction.z()
                    << ") of a direction that the mesh leaves out (empty). "
                    << "Valid components: "
                    << dictionaryCheck::listed(valid).c_str()
                    << exit(FatalIOError);
            }
        }
    }
}


void Foam::solidBody::checkStart() const
{
    forAll(corners_, patchi)
    {
        const prescribedMotion* motion =
            corners_.set(patchi) ? condition(patchi).motion() : nullptr;
        if (!motion || !motion->ofDisplacement()) continue;

        // Nodes that other patches hold, too, may be elsewhere: the least jump
        const vector given(motion->value(time_.value()));
        const dualPatch& patch = dual_.patches()[patchi];
        scalar least = GREAT;
        forAll(patch.cornerNode, k)
        {
            const vector jump
            (
                projected(given)
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
            least = min(least, length/depth_[patchi][k]);
        }
        reduce(least, minOp<scalar>());
        if (least > largestJump && least < 0.1*GREAT)
        {
            FatalFileErrorInFunction(pointUFile_)
                << "Keyword 'boundaryField': patch '"
                << pointU_.boundaryField()[patchi].patch().name()
                << "' has a 'displacement' of " << given
                << " m at the start, time " << time_.value()
                << " s, but its nodes are elsewhere (pointD): the surface "
                << "would jump by " << least << " of its cells, "
                << largestJump << " are allowed" << exit(FatalIOError);
        }
    }
}


void Foam::solidBody::accountReactions(const scalar kick)
{
    reactionAccount& r = *reactions_;
    const label d = dual_.nDim();
    const label nFixed = fixedNodes_.size();
    const label nAlong = directions_.nodes().size();
    r.stepTime += kick;

    forAll(r.nodes, k)
    {
        const label a = r.nodes[k];
        if (!dual_.sharing().owned()[a]) continue;

        scalar impulse[3], v[3];
        for (label i = 0; i < d; ++i)
        {
            const scalar lm = data_.state.lm[a*d + i];
            const scalar old = data_.old.lm[a*d + i];
            impulse[i] =
                dual_.nodeVolume()[a]
               *(
                    lm - old
                  - kick*(r.freeRates[k*d + i] + r.contactRates[k*d + i])
                );
            v[i] = 0.5*(lm + old)/data_.rho;
        }
        const auto add = [&]
        (
            const label patchi,
            const scalar* direction,
            const scalar part
        )
        {
            patchReaction& its = r.patches[patchi];
            for (label i = 0; i < d; ++i)
            {
                const label c = dual_.directions()[i];
                its.impulse[c] += part*direction[i];
                its.stepImpulse[c] += part*direction[i];
                its.work += part*direction[i]*v[i];
            }
        };
        if (k < nFixed)
        {
            add(held_[fixedPlace_[k]].patch, impulse, 1);
        }
        else if (k < nFixed + nAlong)
        {
            directions_.share(k - nFixed, impulse, add);
        }
        else
        {
            symmetry_.share(r.mirrors[k - nFixed - nAlong], impulse, add);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidBody::accountReactions()
{
    reactions_.reset(new reactionAccount);
    reactionAccount& r = *reactions_;

    labelHashSet held(fixedNodes_);
    held.insert(directions_.nodes());
    DynamicList<label> nodes, mirrors;
    nodes.append(fixedNodes_);
    nodes.append(directions_.nodes());
    forAll(symmetry_.nodes(), i)
    {
        if (held.insert(symmetry_.nodes()[i]))
        {
            nodes.append(symmetry_.nodes()[i]);
            mirrors.append(i);
        }
    }
    r.nodes.transfer(nodes);
    r.mirrors.transfer(mirrors);

    const labelHashSet touches(contactNodes_);
    DynamicList<label> touching;
    forAll(r.nodes, k)
    {
        if (touches.found(r.nodes[k])) touching.append(k);
    }
    r.touching.transfer(touching);

    r.freeRates.setSize(r.nodes.size()*dual_.nDim(), Zero);
    r.contactRates = r.freeRates;
    r.patches.setSize(mesh_.boundaryMesh().size());
    r.old = r.patches;
}


void Foam::solidBody::startReactions()
{
    if (!reactions_.valid()) return;
    reactions_->old = reactions_->patches;
    for (patchReaction& r : reactions_->patches) r.stepImpulse = vector::zero;
    reactions_->stepTime = 0;
}


Foam::labelList Foam::solidBody::reactingPatches() const
{
    labelHashSet patches(mirrorPatches_);
    for (const heldPatch& h : held_) patches.insert(h.patch);
    patches.insert(directionPatches_);
    return patches.sortedToc();
}


// ************************************************************************* //
