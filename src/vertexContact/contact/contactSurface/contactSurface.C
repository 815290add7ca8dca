/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactSurface.H"
#include "solidBody.H"
#include "rankRows.H"
#include "vectorField.H"

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

//- Normal of the nodes x of a face: cross product of the diagonals; in 2D of
//  the edge and the direction left out; zero in 1D
vector areaNormal(const contactFace& f, const FixedList<point, 4>& x)
{
    switch (f.size)
    {
        case 4: return 0.5*((x[2] - x[0]) ^ (x[3] - x[1]));
        case 3: return 0.5*((x[1] - x[0]) ^ (x[2] - x[0]));
        case 2: return (x[1] - x[0]) ^ f.out;
        default: return vector::zero;
    }
}

//- Outward unit normal of the current nodes: by the same turn from the
//  reference ones as there, where it is N
vector currentNormal(const contactFace& f)
{
    if (f.size == 1) return f.N;
    const vector A(areaNormal(f, f.X)), a(areaNormal(f, f.x));
    return ((A & f.N) < 0 ? -1 : 1)*a/max(mag(a), VSMALL);
}

//- Unit vector along the direction that a 2D body leaves out (1D: the first)
vector outOfPlane(const contactSide& side)
{
    const vector e(vector::one - side.body->dual().projected(vector::one));
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

//- Positions of the nodes of a body, current or reference ones, in its solution
//  directions
struct positions
{
    const solidBody& body;
    const bool current;
    const label d;
    const scalar* X;
    const scalar* disp;
    const vector out;

    positions(const contactSide& side, const bool current)
    :
        body(*side.body),
        current(current),
        d(body.dual().nDim()),
        X(body.dual().nodePosition().cdata()),
        disp(body.state().disp.cdata()),
        out(outOfPlane(side))
    {}

    scalar component(const label node, const label i) const
    {
        return X[node*d + i] + (current ? disp[node*d + i] : 0);
    }

    point operator()(const label node) const
    {
        const point x(body.dual().position(node));
        return current ? x + body.expand(disp + node*d) : x;
    }
};

//- A face of a side with its nodes, normals, depths and width only
contactFace placedFace
(
    const positions& at,
    const contactSide& side,
    const dualPatch::face& its
)
{
    const dualPatch& patch = side.geometry();
    const medianDual& dual = at.body.dual();
    const bodySurface& surface = at.body.surface(side.patchi);

    contactFace f;
    f.size = its.size;
    if (surface.thickness.size()) f.thickness = surface.thickness[its.index];
    f.out = at.out;
    vector mean(Zero);
    for (label j = 0; j < f.size; ++j)
    {
        const label k = its.start + j;
        const label a = patch.cornerNode[k];
        f.X[j] = dual.position(a);
        f.x[j] = at(a);
        f.depth[j] = surface.depth[k];
        mean += dual.cornerNormal(patch, k);
    }
    f.N = mean/mag(mean);
    f.n = currentNormal(f);
    f.width = f.size > 1 ? bodySurface::meanEdge(f.X, f.size) : f.depth[0];
    return f;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

const Foam::dualPatch& Foam::contactSide::geometry() const
{
    return body->dual().patches()[patchi];
}


void Foam::contactSurface::joinOnAll(List<boundBox>& boxes)
{
    combineOnAll(boxes, [](boundBox& a, const boundBox& b) { a.add(b); });
}


Foam::boundBox Foam::contactSurface::grown(boundBox box, const scalar by)
{
    box.min() -= by*vector::one;
    box.max() += by*vector::one;
    return box;
}


Foam::surfacePlace Foam::contactSurface::place
(
    const contactSide& side,
    const label corner
)
{
    const cornerStates& c = side.body->corners(side.patchi);
    return
    {
        side.body->dual().projected
        (
            side.body->position(c.geometry.cornerNode[corner])
        ),
        c.n[corner],
        c.stretch[corner]
    };
}


Foam::surfacePlace Foam::contactSurface::place
(
    const contactSide& side,
    const contactStencil& stencil
)
{
    surfacePlace sum{Zero, Zero, 0};
    for (label j = 0; j < stencil.size; ++j)
    {
        const surfacePlace c(place(side, stencil.corner[j]));
        sum.x += stencil.value[j]*c.x;
        sum.n += stencil.value[j]*c.n;
        sum.stretch += stencil.value[j]*c.stretch;
    }
    return sum;
}


Foam::contactFaceList Foam::contactSurface::faces
(
    const contactSide& side,
    const globalIndex& corners
)
{
    contactFaceList faces(side.geometry().nFaces());
    forAll(faces, facei)
    {
        faces[facei] = face(side, corners, facei, false);
    }
    return faces;
}


Foam::contactFace Foam::contactSurface::face
(
    const contactSide& side,
    const globalIndex& corners,
    const label facei,
    const bool current
)
{
    const dualPatch& patch = side.geometry();
    const boolList& rim = side.body->surface(side.patchi).rim;
    const boolList& ends = side.body->surface(side.patchi).ends;
    const dualPatch::face its(patch.faceOf(facei));

    contactFace f(placedFace(positions(side, current), side, its));
    f.firstCorner = corners.toGlobal(its.start);
    for (label j = 0; j < f.size; ++j)
    {
        const label k = its.start + j;
        f.area[j] = patch.cornerArea[k];
        f.rim[j] = rim.size() && rim[k];
        f.ends[j] = ends.size() && ends[k];
    }
    const scalar* s = patch.weights.cdata() + its.firstWeight;
    f.spread = spread(s, f.size, f.area);
    if (f.size == 4)
    {
        const scalar both = s[2] + s[7];
        f.split = both > 0 ? s[2]/both : 0.5;

        const vector d02(f.X[2] - f.X[0]), d13(f.X[3] - f.X[1]);
        const vector n(d02 ^ d13);
        const auto place = [&](const vector& along)
        {
            return min
            (
                max
                (
                    (((f.X[1] - f.X[0]) ^ along) & n)/max(magSqr(n), VSMALL),
                    scalar(contactFace::leastCrossing)
                ),
                scalar(1 - contactFace::leastCrossing)
            );
        };
        f.crossings[0] = place(d13);
        f.crossings[1] = place(d02);
    }
    return f;
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
    width(f.width),
    depth(f.depth[0]),
    C(point::zero),
    N(f.N),
    R(0)
{
    for (label i = 0; i < f.size; ++i)
    {
        box.add(f.x[i]);
        C += f.X[i];
    }
    C /= f.size;
    for (label i = 0; i < f.size; ++i) R = max(R, mag(f.X[i] - C));
}


Foam::contactSurface::snapshot::snapshot
(
    const contactSide& side,
    const bool current,
    const bodyMotion& motion
)
:
    side(side),
    current(current),
    box(boundBox::invertedBox),
    motion(motion)
{
    const positions x(side, current);
    for (const label a : side.geometry().cornerNode) box.add(x(a));
}


void Foam::contactSurface::snapshot::findFaces(const UList<boundBox>& boxes)
{
    found = true;
    const dualPatch& patch = side.geometry();
    const FixedList<label, 3>& directions = side.body->dual().directions();
    const positions x(side, current);
    for (label start = 0; start < patch.nFaces(); start += runLength)
    {
        const label end = min(start + runLength, patch.nFaces());
        run its{boundBox(point::zero, point::zero), faces.size(), end - start};
        for (label i = 0; i < x.d; ++i)
        {
            scalar& least = its.box.min()[directions[i]] = GREAT;
            scalar& most = its.box.max()[directions[i]] = -GREAT;
            for
            (
                label k = patch.faceStart[start]; k < patch.faceStart[end]; ++k
            )
            {
                const scalar at = x.component(patch.cornerNode[k], i);
                least = min(least, at);
                most = max(most, at);
            }
        }
        for (const boundBox& other : boxes)
        {
            if (!meet(its.box, other)) continue;
            runs.append(its);
            for (label facei = start; facei < end; ++facei)
            {
                faces.append
                (
                    outline(facei, placedFace(x, side, patch.faceOf(facei)))
                );
                axis += faces.last().n;
            }
            break;
        }
    }
}


bool Foam::contactSurface::snapshot::meet
(
    const boundBox& a,
    const boundBox& b
) const
{
    const FixedList<label, 3>& directions = side.body->dual().directions();
    bool all = true;
    for (label i = 0; i < side.body->dual().nDim(); ++i)
    {
        const direction e = directions[i];
        all = all && a.min()[e] <= b.max()[e] && a.max()[e] >= b.min()[e];
    }
    return all;
}


Foam::List<Foam::contactSurface::bodyMotion>
Foam::contactSurface::bodyMotions(const UList<contactSide>& sides)
{
    struct sums
    {
        vector momentum = vector::zero;
        scalar mass = 0;
        vector displaced = vector::zero;    // times volume
        scalar volume = 0;
    };
    List<sums> all(sides.size());
    List<bodyMotion> motions(sides.size());

    forAll(all, i)
    {
        const solidBody& body = *sides[i].body;
        if (i && sides[i - 1].body == &body)
        {
            all[i] = all[i - 1];
            continue;
        }
        all[i].momentum = body.linearMomentum();
        all[i].mass = body.mass();
        all[i].displaced = body.displacedVolume();
        all[i].volume = body.volume();
    }
    combineRowsOnAll(all, plusEqOp<scalar>());
    forAll(all, i)
    {
        motions[i].velocity = all[i].momentum/all[i].mass;
        motions[i].displacement = all[i].displaced/all[i].volume;
    }
    return motions;
}


Foam::PtrList<Foam::contactSurface::snapshot>
Foam::contactSurface::snapshots
(
    const UList<contactSide>& sides,
    const bool current
)
{
    const label n = sides.size();
    PtrList<snapshot> all(n);
    if (!n) return all;

    const List<bodyMotion> motions(bodyMotions(sides));
    List<boundBox> boxes(n);
    forAll(boxes, i)
    {
        all.set(i, new snapshot(sides[i], current, motions[i]));
        boxes[i] = all[i].box;
    }
    joinOnAll(boxes);
    forAll(boxes, i) all[i].box = boxes[i];
    return all;
}


void Foam::contactSurface::findFaces
(
    PtrList<snapshot>& sides,
    const UList<labelPair>& pairs,
    const scalar search
)
{
    const label n = sides.size();
    if (!n) return;

    List<DynamicList<boundBox>> boxes(n);
    for (const labelPair& pair : pairs)
    {
        const label a = pair.first(), b = pair.second();
        boxes[a].append(grown(sides[b].box, search));
        if (b != a) boxes[b].append(grown(sides[a].box, search));
    }
    vectorField axes(n);
    forAll(axes, i)
    {
        sides[i].findFaces(boxes[i]);
        axes[i] = sides[i].axis;
    }
    combineOnAll(axes, plusEqOp<vector>());

    // The cone around the mean normal; without one, all directions
    scalarField least(n, scalar(1));
    forAll(least, i)
    {
        sides[i].axis = axes[i];
        if (mag(axes[i]) < SMALL) continue;
        sides[i].axis /= mag(axes[i]);
        for (const outline& o : sides[i].faces)
        {
            least[i] = min(least[i], o.n & sides[i].axis);
        }
    }
    combineOnAll(least, minEqOp<scalar>());
    forAll(least, i)
    {
        if (mag(axes[i]) >= SMALL)
        {
            sides[i].angle = std::acos(max(least[i], scalar(-1)));
        }
    }
}


bool Foam::contactSurface::snapshot::mayOppose
(
    const snapshot& other,
    const scalar by
) const
{
    const scalar between =
        std::acos(max(min(axis & other.axis, scalar(1)), scalar(-1)));
    return angle + other.angle + between > by - roundOff;
}


Foam::DynamicList<Foam::contactSurface::outline>
Foam::contactSurface::snapshot::in(const boundBox& box) const
{
    if (!found)
    {
        snapshot near(*this);
        near.findFaces(List<boundBox>(1, box));
        return near.in(box);
    }
    DynamicList<outline> some;
    for (const run& its : runs)
    {
        if (!meet(its.box, box)) continue;
        for (label i = its.start; i < its.start + its.size; ++i)
        {
            if (meet(faces[i].box, box)) some.append(faces[i]);
        }
    }
    return some;
}


// ************************************************************************* //
