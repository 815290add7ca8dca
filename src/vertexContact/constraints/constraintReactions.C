/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "constraintReactions.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::constraintReactions::constraintReactions
(
    const heldNodes& held,
    const symmetryConstraint& symmetry,
    const labelList& contactNodes,
    const label nPatches,
    const label nDim
)
:
    held_(held),
    symmetry_(symmetry),
    patches_(max(nPatches, whole + 1)),
    old_(patches_.size())
{
    labelHashSet known(held.nodes());
    DynamicList<label> nodes(held.nodes()), mirrors;
    forAll(symmetry.nodes(), i)
    {
        if (known.insert(symmetry.nodes()[i]))
        {
            nodes.append(symmetry.nodes()[i]);
            mirrors.append(i);
        }
    }
    nodes_.transfer(nodes);
    mirrors_.transfer(mirrors);

    const labelHashSet touches(contactNodes);
    DynamicList<label> touching;
    forAll(nodes_, k)
    {
        if (touches.found(nodes_[k])) touching.append(k);
    }
    touching_.transfer(touching);

    freeRates_.setSize(nodes_.size()*nDim, Zero);
    contactRates_ = freeRates_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::constraintReactions::startStep()
{
    old_ = patches_;
    for (patchReaction& r : patches_)
    {
        r.stepImpulse = vector::zero;
        r.stepTwist = vector::zero;
    }
    stepTime_ = 0;
}


void Foam::constraintReactions::takeFree(const vertexData& data)
{
    const label d = data.dual.nDim();
    forAll(nodes_, k)
    {
        const scalar* rate = data.rates.cdata() + nodes_[k]*data.strideRates;
        for (label i = 0; i < d; ++i) freeRates_[k*d + i] = rate[i];
    }
}


void Foam::constraintReactions::takeContact
(
    const scalarField& rates,
    const label nDim
)
{
    for (const label k : touching_)
    {
        const scalar* rate = rates.cdata() + nodes_[k]*nDim;
        for (label i = 0; i < nDim; ++i) contactRates_[k*nDim + i] = rate[i];
    }
}


void Foam::constraintReactions::add(const vertexData& data, const scalar kick)
{
    const medianDual& dual = data.dual;
    const label d = dual.nDim();
    const label nHeld = held_.nodes().size();
    stepTime_ += kick;

    forAll(nodes_, k)
    {
        const label a = nodes_[k];
        if (!dual.sharing().owned()[a]) continue;

        scalar impulse[3], v[3];
        for (label i = 0; i < d; ++i)
        {
            const scalar lm = data.state.lm[a*d + i];
            const scalar old = data.old.lm[a*d + i];
            impulse[i] =
                dual.nodeVolume()[a]
               *(
                    lm - old
                  - kick*(freeRates_[k*d + i] + contactRates_[k*d + i])
                );
            v[i] = 0.5*(lm + old)/data.rho;
        }
        const auto add = [&]
        (
            const label patchi,
            const scalar* direction,
            const scalar part
        )
        {
            patchReaction& its = patches_[patchi];
            for (label i = 0; i < d; ++i)
            {
                const label c = dual.directions()[i];
                its.impulse[c] += part*direction[i];
                its.stepImpulse[c] += part*direction[i];
                its.work += part*direction[i]*v[i];
            }
        };
        if (k < nHeld) held_.share(k, impulse, add);
        else symmetry_.share(mirrors_[k - nHeld], impulse, add);
    }
}


void Foam::constraintReactions::addWhole
(
    const rigidBody::reaction& r,
    const scalar kick
)
{
    // All ranks have the same
    stepTime_ += kick;
    if (!Pstream::master()) return;
    patchReaction& its = patches_[whole];
    its.impulse += r.impulse;
    its.stepImpulse += r.impulse;
    its.stepTwist += r.twist;
    its.work += r.work;
}


// ************************************************************************* //
