/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceMotion.H"
#include "solidBody.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceMotion::surfaceMotion(const contactSide& side)
:
    side_(side)
{
    labelHashSet nodes(side.body->dual().patches()[side.patchi].cornerNode);
    nodes_ = nodes.sortedToc();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::surfaceMotion::box() const
{
    boundBox bb(boundBox::invertedBox);
    for (const label a : nodes_) bb.add(side_.body->position(a));
    return bb;
}


Foam::scalar Foam::surfaceMotion::speed(const vector& frame) const
{
    const label d = side_.body->dual().nDim();
    const scalar* lm = side_.body->state().lm.cdata();
    const scalar perRho = 1/side_.body->material().rho();
    scalar largest = 0;
    for (const label a : nodes_)
    {
        largest = max
        (
            largest, mag(perRho*side_.body->expand(lm + a*d) - frame)
        );
    }
    return largest;
}


void Foam::surfaceMotion::start
(
    const scalar time,
    const scalar allowed,
    const scalar speed,
    const vector& frame
)
{
    const label d = side_.body->dual().nDim();
    const scalar* disp = side_.body->state().disp.cdata();
    from_.setSize(nodes_.size()*d);
    label k = 0;
    for (const label a : nodes_)
    {
        for (label i = 0; i < d; ++i) from_[k++] = disp[a*d + i];
    }
    allowed_ = allowed;
    frame_ = frame;
    since_ = time;
    const scalar fastest = speed + reserve*side_.body->material().cp();
    nextTime_ =
        nodes_.size() ? time + allowed/max(fastest, VSMALL) : scalar(GREAT);
}


bool Foam::surfaceMotion::exceeded
(
    const scalar time,
    const scalar share
) const
{
    if (time - since_ < share*(nextTime_ - since_))
    {
        return false;
    }
    const label d = side_.body->dual().nDim();
    const scalar* disp = side_.body->state().disp.cdata();
    scalar carried[3];
    for (label i = 0; i < d; ++i)
    {
        carried[i] =
            (time - since_)*frame_[side_.body->dual().directions()[i]];
    }
    label k = 0;
    scalar most = 0;
    const scalar limit = sqr(share*allowed_);
    for (const label a : nodes_)
    {
        scalar moved = 0;
        for (label i = 0; i < d; ++i)
        {
            moved += sqr(disp[a*d + i] - from_[k++] - carried[i]);
        }
        if (moved > limit) return true;
        most = max(most, moved);
    }
    if (share < 1) return false;

    const scalar soon = speed(frame_) + reserve*side_.body->material().cp();
    nextTime_ = max(nextTime_, time + (allowed_ - std::sqrt(most))/soon);
    return false;
}


// ************************************************************************* //
