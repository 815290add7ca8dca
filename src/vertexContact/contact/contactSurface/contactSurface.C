/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactSurface.H"
#include "solidBody.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::contactFace::message Foam::contactFace::pack() const
{
    message m(scalar(0));
    label k = 0;
    m[k++] = size;
    m[k++] = firstCorner;
    m[k++] = smoothing;
    m[k++] = width;
    for (direction i = 0; i < 3; ++i) m[k++] = n[i];
    for (direction i = 0; i < 3; ++i) m[k++] = N[i];
    for (label j = 0; j < 4; ++j)
    {
        for (direction i = 0; i < 3; ++i) m[k++] = x[j][i];
        for (direction i = 0; i < 3; ++i) m[k++] = X[j][i];
        m[k++] = area[j];
        m[k++] = depth[j];
    }
    return m;
}


Foam::contactFace Foam::contactFace::unpack(const message& m)
{
    contactFace f;
    label k = 0;
    f.size = label(m[k++]);
    f.firstCorner = label(m[k++]);
    f.smoothing = m[k++];
    f.width = m[k++];
    for (direction i = 0; i < 3; ++i) f.n[i] = m[k++];
    for (direction i = 0; i < 3; ++i) f.N[i] = m[k++];
    for (label j = 0; j < 4; ++j)
    {
        for (direction i = 0; i < 3; ++i) f.x[j][i] = m[k++];
        for (direction i = 0; i < 3; ++i) f.X[j][i] = m[k++];
        f.area[j] = m[k++];
        f.depth[j] = m[k++];
    }
    return f;
}


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::vector Foam::contactSurface::outOfPlane(const contactSide& side)
{
    const medianDual& dual = side.body->dual();
    vector e(vector::one);
    for (label i = 0; i < dual.nDim(); ++i) e[dual.directions()[i]] = 0;
    for (direction i = 0; i < 3; ++i)
    {
        if (e[i] > 0)
        {
            vector first(Zero);
            first[i] = 1;
            return first;
        }
    }
    return vector::zero;
}


Foam::vector Foam::contactSurface::areaNormal
(
    const FixedList<point, 4>& x,
    const label size,
    const vector& outOfPlane
)
{
    switch (size)
    {
        case 4: return 0.5*((x[2] - x[0]) ^ (x[3] - x[1]));
        case 3: return 0.5*((x[1] - x[0]) ^ (x[2] - x[0]));
        case 2: return (x[1] - x[0]) ^ outOfPlane;
        default: return vector::zero;
    }
}


Foam::contactFaceList Foam::contactSurface::faces
(
    const contactSide& side,
    const globalIndex& corners,
    const bool current
)
{
    const solidBody& body = *side.body;
    const medianDual& dual = body.dual();
    const dualPatch& patch = dual.patches()[side.patchi];
    const scalarField& depth = body.depth(side.patchi);
    const label d = dual.nDim();
    const vector out(outOfPlane(side));

    contactFaceList faces(patch.nFaces());
    forAll(faces, facei)
    {
        contactFace& f = faces[facei];
        const label start = patch.faceStart[facei];
        f.size = patch.faceStart[facei + 1] - start;
        f.firstCorner = corners.toGlobal(start);

        const scalar* s = patch.weights.cdata() + patch.weightStart[facei];
        vector mean(Zero);
        scalar diagonal = 0, area = 0;
        for (label j = 0; j < f.size; ++j)
        {
            const label k = start + j;
            const label a = patch.cornerNode[k];
            f.X[j] = body.expand(dual.nodePosition().cdata() + a*d);
            f.x[j] =
                current
              ? f.X[j] + body.expand(body.state().disp.cdata() + a*d)
              : f.X[j];
            f.area[j] = patch.cornerArea[k];
            f.depth[j] = depth[k];
            mean += body.expand(patch.cornerNormal.cdata() + k*d);
            diagonal += s[j*f.size + j]/(f.size*patch.cornerArea[k]);
            area += patch.cornerArea[k];
        }
        f.smoothing = f.size > 1 ? (1 - diagonal)/(f.size - 1) : 0;
        f.N = mean/mag(mean);
        f.width = d == 3 ? std::sqrt(area) : d == 2 ? area : f.depth[0];

        // The same turn from reference to current nodes
        const vector A(areaNormal(f.X, f.size, out));
        const vector a(areaNormal(f.x, f.size, out));
        f.n =
            d == 1 ? f.N
          : ((A & f.N) < 0 ? -1 : 1)*a/max(mag(a), VSMALL);
    }
    return faces;
}


// ************************************************************************* //
