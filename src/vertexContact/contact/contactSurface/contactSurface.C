/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactSurface.H"
#include "solidBody.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A_j (s^-1)_jp of the weights s of n corners with areas A
FixedList<scalar, 16> spread
(
    const scalar* s,
    const label n,
    const FixedList<scalar, 4>& area
)
{
    // Gauss with pivots, beside the areas on the diagonal: s^T X = diag(A),
    // of which the rows of the transpose of X are asked for
    scalar S[4][8];
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            S[i][j] = s[j*n + i];
            S[i][n + j] = i == j ? area[i] : 0;
        }
    }
    for (label c = 0; c < n; ++c)
    {
        label pivot = c;
        for (label i = c + 1; i < n; ++i)
        {
            if (mag(S[i][c]) > mag(S[pivot][c])) pivot = i;
        }
        for (label j = 0; j < 2*n; ++j) Swap(S[c][j], S[pivot][j]);
        for (label i = 0; i < n; ++i)
        {
            if (i == c) continue;
            const scalar times = S[i][c]/S[c][c];
            for (label j = c; j < 2*n; ++j) S[i][j] -= times*S[c][j];
        }
    }

    FixedList<scalar, 16> result(scalar(0));
    for (label p = 0; p < n; ++p)
    {
        for (label j = 0; j < n; ++j)
        {
            result[4*j + p] = S[p][n + j]/S[p][p];
        }
    }
    return result;
}

//- Outward unit normal of the current nodes x of a face: by the same turn from
//  the reference ones as there, where it is N
vector currentNormal
(
    const FixedList<point, 4>& x,
    const FixedList<point, 4>& X,
    const label size,
    const label nDim,
    const vector& N,
    const vector& out
)
{
    if (nDim == 1) return N/mag(N);
    const vector A(contactSurface::areaNormal(X, size, out));
    const vector a(contactSurface::areaNormal(x, size, out));
    return ((A & N) < 0 ? -1 : 1)*a/max(mag(a), VSMALL);
}

//- One face of a side
contactFace makeFace
(
    const contactSide& side,
    const globalIndex& corners,
    const vector& out,
    const label facei,
    const bool current
)
{
    const solidBody& body = *side.body;
    const medianDual& dual = body.dual();
    const dualPatch& patch = dual.patches()[side.patchi];
    const scalarField& depth = body.depth(side.patchi);
    const label d = dual.nDim();

    contactFace f;
    const label start = patch.faceStart[facei];
    f.size = patch.faceStart[facei + 1] - start;
    f.firstCorner = corners.toGlobal(start);

    const scalar* s = patch.weights.cdata() + patch.weightStart[facei];
    vector mean(Zero);
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
    }
    f.spread = spread(s, f.size, f.area);
    if (f.size == 4)
    {
        const scalar both = s[2] + s[7];
        f.split = both > 0 ? s[2]/both : 0.5;

        const vector d02(f.X[2] - f.X[0]), d13(f.X[3] - f.X[1]);
        const vector n(d02 ^ d13);
        f.crossing = min
        (
            max
            (
                (((f.X[1] - f.X[0]) ^ d13) & n)/max(magSqr(n), VSMALL),
                scalar(0.02)
            ),
            scalar(0.98)
        );
    }
    f.N = mean/mag(mean);
    f.width = f.size > 1 ? contactSurface::meanEdge(f.X, f.size) : f.depth[0];

    f.n = currentNormal(f.x, f.X, f.size, d, f.N, out);
    return f;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::contactFace::message Foam::contactFace::pack() const
{
    message m(scalar(0));
    label k = 0;
    m[k++] = size;
    m[k++] = firstCorner;
    m[k++] = split;
    m[k++] = crossing;
    for (const scalar c : spread) m[k++] = c;
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
    f.split = m[k++];
    f.crossing = m[k++];
    for (scalar& c : f.spread) c = m[k++];
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


Foam::scalar Foam::contactSurface::meanEdge
(
    const FixedList<point, 4>& x,
    const label size
)
{
    scalar around = 0;
    for (label i = 0; i < size; ++i)
    {
        around += mag(x[(i + 1) % size] - x[i]);
    }
    return around/size;
}


Foam::contactFaceList Foam::contactSurface::faces
(
    const contactSide& side,
    const globalIndex& corners,
    const bool current
)
{
    const vector out(outOfPlane(side));
    contactFaceList faces(side.body->dual().patches()[side.patchi].nFaces());
    forAll(faces, facei)
    {
        faces[facei] = makeFace(side, corners, out, facei, current);
    }
    return faces;
}


Foam::contactFace Foam::contactSurface::currentFace
(
    const contactSide& side,
    const globalIndex& corners,
    const label facei
)
{
    return makeFace(side, corners, outOfPlane(side), facei, true);
}


Foam::contactSurface::outline::outline
(
    const label facei,
    const contactFace& f
)
:
    face(facei),
    box(boundBox::invertedBox),
    centre(f.centre()),
    radius(f.radius()),
    n(f.n),
    width(f.width)
{
    for (label i = 0; i < f.size; ++i) box.add(f.x[i]);
}


Foam::DynamicList<Foam::contactSurface::outline>
Foam::contactSurface::outlinesIn
(
    const contactSide& side,
    const boundBox& box
)
{
    const solidBody& body = *side.body;
    const medianDual& dual = body.dual();
    const dualPatch& patch = dual.patches()[side.patchi];
    const label d = dual.nDim();
    const vector out(outOfPlane(side));
    const scalar* Xs = dual.nodePosition().cdata();
    const scalar* disp = body.state().disp.cdata();

    DynamicList<outline> faces;
    for (label facei = 0; facei < patch.nFaces(); ++facei)
    {
        const label start = patch.faceStart[facei];
        const label size = patch.faceStart[facei + 1] - start;
        bool meets = true;
        for (label i = 0; i < d && meets; ++i)
        {
            scalar least = GREAT, most = -GREAT;
            for (label k = start; k < start + size; ++k)
            {
                const label at = patch.cornerNode[k]*d + i;
                least = min(least, Xs[at] + disp[at]);
                most = max(most, Xs[at] + disp[at]);
            }
            const direction e = dual.directions()[i];
            meets = least <= box.max()[e] && most >= box.min()[e];
        }
        if (!meets) continue;

        FixedList<point, 4> x(point::zero), X(point::zero);
        vector N(Zero);
        outline o;
        o.face = facei;
        o.box = boundBox(boundBox::invertedBox);
        o.centre = point::zero;
        for (label j = 0; j < size; ++j)
        {
            const label a = patch.cornerNode[start + j];
            X[j] = body.expand(Xs + a*d);
            x[j] = X[j] + body.expand(disp + a*d);
            N += body.expand(patch.cornerNormal.cdata() + (start + j)*d);
            o.box.add(x[j]);
            o.centre += x[j];
        }
        o.centre /= size;
        scalar radiusSqr = 0;
        for (label j = 0; j < size; ++j)
        {
            radiusSqr = max(radiusSqr, magSqr(x[j] - o.centre));
        }
        o.radius = std::sqrt(radiusSqr);
        o.n = currentNormal(x, X, size, d, N, out);
        o.width =
            size > 1 ? meanEdge(X, size) : body.depth(side.patchi)[start];
        faces.append(o);
    }
    return faces;
}


// ************************************************************************* //
