/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heldNodes.H"
#include "prescribedMotion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::heldNodes::setValues
(
    const List<condition>& conditions,
    const scalar time,
    const scalar deltaT,
    scalarField& values
) const
{
    forAll(conditions, c)
    {
        const prescribedMotion& motion = *conditions[c].motion;
        const vector value
        (
            motion.value(time + (motion.ofDisplacement() ? 1 : 0.5)*deltaT)
        );
        for (label i = 0; i < nDim_; ++i)
        {
            values[c*nDim_ + i] = value[directions_[i]];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heldNodes::heldNodes
(
    const medianDual& dual,
    const symmetryConstraint& mirrors,
    const UList<condition>& conditions
)
:
    directions_(dual.directions()),
    nDim_(dual.nDim())
{
    scalarField first(dual.nNodes(), GREAT);
    DynamicList<condition> complete, partial;
    for (const condition& c : conditions)
    {
        if (!c.motion->complete())
        {
            partial.append(c);
            continue;
        }
        for (const label a : dual.patches()[c.patch].cornerNode)
        {
            first[a] = min(first[a], scalar(complete.size()));
        }
        complete.append(c);
    }
    dual.sharing().min(first.data(), 1);

    DynamicList<label> nodes, conditionOf;
    forAll(first, a)
    {
        if (first[a] < complete.size())
        {
            nodes.append(a);
            conditionOf.append(label(first[a] + 0.5));
        }
    }
    nComplete_ = nodes.size();
    along_ = directionConstraint(dual, mirrors, partial, nodes);
    nodes.append(along_.nodes());

    nodes_.transfer(nodes);
    conditionOf_.transfer(conditionOf);
    complete_.transfer(complete);
    partial_.transfer(partial);
    completeValues_.setSize(complete_.size()*nDim_, Zero);
    partialValues_.setSize(partial_.size()*nDim_, Zero);

    if (nodes_.empty()) return;
    placeOf_.setSize(dual.nNodes(), -1);
    forAll(nodes_, k) placeOf_[nodes_[k]] = k;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::heldNodes::impose
(
    scalar* lm,
    const scalar* disp,
    const scalar rho,
    const scalar time,
    const scalar deltaT
)
{
    setValues(complete_, time, deltaT, completeValues_);
    setValues(partial_, time, deltaT, partialValues_);
    for (label k = 0; k < nComplete_; ++k)
    {
        const label c = conditionOf_[k];
        const scalar* value = completeValues_.cdata() + c*nDim_;
        const label start = nodes_[k]*nDim_;
        for (label i = 0; i < nDim_; ++i)
        {
            lm[start + i] =
                rho
               *(
                    complete_[c].motion->ofDisplacement()
                  ? (value[i] - disp[start + i])/deltaT
                  : value[i]
                );
        }
    }
    along_.impose(lm, disp, partialValues_, rho, deltaT);
}


Foam::labelList Foam::heldNodes::patches() const
{
    DynamicList<label> patches;
    for (const condition& c : complete_) patches.append(c.patch);
    for (const condition& c : partial_) patches.append(c.patch);
    return labelList(std::move(patches));
}


// ************************************************************************* //
