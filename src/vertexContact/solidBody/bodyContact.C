/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyContact.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyContact::bodyContact
(
    const vertexData& data,
    const symmetryConstraint& symmetry,
    const heldNodes& held
)
:
    data_(data),
    dual_(data.dual),
    symmetry_(symmetry),
    held_(held)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyContact::start()
{
    on_ = true;
    const label n = dual_.nNodes();
    status.setSize(n, Zero);
    gap.setSize(n, GREAT);
    force.setSize(n, vector::zero);
    area.setSize(n, Zero);
}


void Foam::bodyContact::findNodes(scalarField touches)
{
    dual_.sharing().max(touches.data(), 1);
    DynamicList<label> nodes, held;
    forAll(touches, a)
    {
        if (touches[a] > 0.5) nodes.append(a);
    }
    forAll(held_.nodes(), k)
    {
        if (touches[held_.nodes()[k]] > 0.5) held.append(k);
    }
    nodes_.transfer(nodes);
    heldPlaces_.transfer(held);
    if (on_) forces_.setSize(dual_.nNodes()*dual_.nDim(), Zero);
}


void Foam::bodyContact::clear()
{
    const label d = dual_.nDim();
    for (const label a : nodes_)
    {
        force[a] = vector::zero;
        area[a] = 0;
        for (label i = 0; i < d; ++i) forces_[a*d + i] = 0;
    }
}


void Foam::bodyContact::clearAll()
{
    for (const label a : nodes_) gap[a] = GREAT;
    clear();
}


void Foam::bodyContact::sum(scalarField& sums) const
{
    // The sums of all other nodes are not used
    const label d = dual_.nDim();
    for (const label a : nodes_)
    {
        for (label i = 0; i < d; ++i) sums[a*d + i] = forces_[a*d + i];
    }
    dual_.sharing().sum(sums.data(), d);
}


void Foam::bodyContact::complete(scalarField& sums) const
{
    dual_.sharing().sum(sums.data(), dual_.nDim());
    hold(sums, [](const label, const label, const scalar) {});
}


void Foam::bodyContact::updateVelocity(scalarField& sums)
{
    const label d = dual_.nDim();
    sum(sums);
    hold(sums, [](const label, const label, const scalar) {});
    const scalar share = gives_*step_/data_.rho;
    setVelocity([&](const label a)
    {
        return share*dual_.expand(sums.cdata() + a*d);
    });
}


Foam::scalar Foam::bodyContact::power(const scalarField& velocity) const
{
    const label d = dual_.nDim();
    scalar all = 0;
    for (const label a : nodes_)
    {
        scalar power = 0;
        for (label i = 0; i < d; ++i)
        {
            power += forces_[a*d + i]*velocity[a*d + i];
        }
        all += dual_.nodeVolume()[a]*power;
    }
    return all;
}


void Foam::bodyContact::setBlock(const scalar deltaT, const scalar block)
{
    step_ = deltaT;
    ahead_ = 0.5*block;
    gives_ = blockGives*0.5*block/deltaT;
}


// ************************************************************************* //
