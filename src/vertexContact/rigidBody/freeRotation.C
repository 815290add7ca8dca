/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "freeRotation.H"
#include "principalValues.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The quaternion of a rotation by an angle about a unit axis
quaternion turned(const vector& axis, const scalar angle)
{
    return quaternion(std::cos(0.5*angle), std::sin(0.5*angle)*axis);
}

//- A symmetric tensor with given values along the rows of a tensor
symmTensor along(const tensor& axes, const vector& values)
{
    return
        values.x()*sqr(axes.x()) + values.y()*sqr(axes.y())
      + values.z()*sqr(axes.z());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::freeRotation::freeRotation(const symmTensor& inertia)
{
    const tensor A(inertia);
    const principalValues<3> p(A.cdata(), 0);

    label order[3] = {0, 1, 2};
    std::sort
    (
        order, order + 3,
        [&](const label i, const label j) { return p.value[i] < p.value[j]; }
    );
    const auto axis = [&](const label i)
    {
        const label k = order[i];
        return vector(p.n[0][k], p.n[1][k], p.n[2][k]);
    };
    moments_ = vector
    (
        p.value[order[0]], p.value[order[1]], p.value[order[2]]
    );
    axes_ = tensor(axis(0), axis(1), axis(0) ^ axis(1));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensor Foam::freeRotation::inverse(const quaternion& q) const
{
    return along
    (
        axes_ & q.R().T(),
        vector(1/moments_.x(), 1/moments_.y(), 1/moments_.z())
    );
}


void Foam::freeRotation::turn
(
    quaternion& q,
    const vector& L,
    const scalar deltaT
) const
{
    // In the frame of the body L rotates the other way
    vector l(q.invTransform(L));
    const auto aboutOwn = [&](const direction k, const scalar time)
    {
        const vector a(axes_[3*k], axes_[3*k + 1], axes_[3*k + 2]);
        const scalar speed = (l & a)*(1/moments_[k] - 1/moments_.y());
        const quaternion r(turned(a, time*speed));
        q = q*r;
        l = r.invTransform(l);
    };
    aboutOwn(0, 0.5*deltaT);
    aboutOwn(2, deltaT);
    aboutOwn(0, 0.5*deltaT);

    const scalar size = mag(L);
    if (size > 0) q = turned(L/size, deltaT*size/moments_.y())*q;
    q /= mag(q);
}


void Foam::freeRotation::turnAbout
(
    quaternion& q,
    const vector& axis,
    const scalar angle
)
{
    q = turned(axis, angle)*q;
    q /= mag(q);
}


// ************************************************************************* //
