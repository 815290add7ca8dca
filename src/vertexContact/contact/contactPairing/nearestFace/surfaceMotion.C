/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceMotion.H"
#include "solidBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::labelList& Foam::surfaceMotion::nodes() const
{
    return side_.body->surface(side_.patchi).nodes;
}


void Foam::surfaceMotion::keepNormals()
{
    const solidBody& body = *side_.body;
    const dualPatch& patch = side_.geometry();
    const label d = body.dual().nDim();
    normal_.setSize(patch.nCorners()*d);
    forAll(patch.cornerNode, k)
    {
        const vector area(body.currentArea(patch, k));
        const scalar perArea = 1/max(mag(area), VSMALL);
        for (label i = 0; i < d; ++i)
        {
            normal_[k*d + i] = perArea*area[body.dual().directions()[i]];
        }
    }
}


void Foam::surfaceMotion::wayOf
(
    const label place,
    const scalar* carried,
    scalar* way
) const
{
    const label d = side_.body->dual().nDim();
    const scalar* disp = side_.body->state().disp.cdata() + nodes()[place]*d;
    for (label i = 0; i < d; ++i)
    {
        way[i] = disp[i] - from_[place*d + i] - carried[i];
    }
}


void Foam::surfaceMotion::findWays
(
    const vector& by,
    scalar& most,
    scalar& along
) const
{
    most = along = 0;
    if (from_.empty()) return;

    const label d = side_.body->dual().nDim();
    scalar carried[3], way[3];
    for (label i = 0; i < d; ++i)
    {
        carried[i] = by[side_.body->dual().directions()[i]];
    }
    // Compare squares if no free_ is subtracted
    const bool free = free_.size();
    const auto counted = [&](const label place, const scalar moved)
    {
        return free ? std::sqrt(moved) - free_[place] : moved;
    };
    forAll(nodes(), place)
    {
        wayOf(place, carried, way);
        scalar moved = 0;
        for (label i = 0; i < d; ++i) moved += sqr(way[i]);
        most = max(most, counted(place, moved));
    }
    along = most;
    if (along_ < any_)
    {
        along = 0;
        const labelList& place = side_.body->surface(side_.patchi).place;
        forAll(place, k)
        {
            wayOf(place[k], carried, way);
            scalar moved = 0, off = 0;
            for (label i = 0; i < d; ++i)
            {
                moved += sqr(way[i]);
                off += way[i]*normal_[k*d + i];
            }
            moved = max(moved - sqr(off), scalar(0));
            along = max(along, counted(place[k], moved));
        }
    }
    if (free) return;
    most = std::sqrt(most);
    along = std::sqrt(along);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceMotion::surfaceMotion(const contactSide& side)
:
    side_(side)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::surfaceMotion::box() const
{
    boundBox bb(boundBox::invertedBox);
    for (const label a : nodes()) bb.add(side_.body->position(a));
    return bb;
}


void Foam::surfaceMotion::start
(
    const scalar time,
    const scalar along,
    const scalar any,
    const contactSurface::bodyMotion& bodies
)
{
    const label d = side_.body->dual().nDim();
    const scalar* disp = side_.body->state().disp.cdata();
    from_.setSize(nodes().size()*d);
    label k = 0;
    for (const label a : nodes())
    {
        for (label i = 0; i < d; ++i) from_[k++] = disp[a*d + i];
    }
    if (along < any) keepNormals();
    free_.clear();
    along_ = along;
    any_ = any;
    mostAlong_ = most_ = 0;
    place_ = bodies.displacement;
    way_ = vector::zero;
    frame_ = bodies.velocity;
    since_ = last_ = time;
}


void Foam::surfaceMotion::setFree(const boundBox& box, const scalar distance)
{
    free_.setSize(nodes().size());
    bool some = false;
    forAll(nodes(), place)
    {
        // The box is zero in the directions that are left out
        const point x
        (
            side_.body->dual().projected
            (
                side_.body->position(nodes()[place])
            )
        );
        free_[place] = 0.5*max
        (
            scalar(0), surfaceMotion::distance(boundBox(x, x), box) - distance
        );
        some = some || free_[place] > 0;
    }
    if (!some) free_.clear();
}


Foam::label Foam::surfaceMotion::moved
(
    const scalar time,
    const scalar share,
    const contactSurface::bodyMotion& bodies
)
{
    look(time);
    scalar most, along;
    findWays(bodies.displacement - place_, most, along);
    return
        label(left(share) < 0)
      + 2*label(along > share*along_ || most > share*any_);
}


bool Foam::surfaceMotion::exceeded(const scalar time)
{
    if (from_.size())
    {
        const scalar way =
            (time - last_)
           *fastest(side_.body->surfaceVelocities(side_.patchi, time), frame_);
        mostAlong_ += way;
        most_ += way;
    }
    last_ = time;
    if (left() < 0) look(time);
    return left() < 0;
}


// ************************************************************************* //
