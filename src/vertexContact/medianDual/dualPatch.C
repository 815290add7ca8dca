/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dualPatch.H"
#include "emptyPolyPatch.H"
#include "nativeDual.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"
#include "simplexDecomposition.H"
#include "solutionNodes.H"
#include "meshFile.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Weights of one face in a dualPatch, scalar and vector, by (corner, node)
struct cornerWeights
{
    const label n;
    const label nDim;
    scalar* s;
    scalar* w;

    void add
    (
        const label a,
        const label j,
        const scalar factor,
        const scalar area,
        const scalar* vec
    )
    {
        const label i = a*n + j;
        s[i] += factor*area;

        for (label k = 0; k < nDim; ++k) w[i*nDim + k] += factor*vec[k];
    }
};


//- Magnitude of a vector
static scalar length(const scalar* v, const label nDim)
{
    scalar sum = 0;
    for (label k = 0; k < nDim; ++k) sum += v[k]*v[k];

    return std::sqrt(sum);
}


//- Area vector of a triangle of a face
static void triangleArea
(
    const label i,
    const label j,
    const label k,
    const scalar* x,
    scalar* area
)
{
    scalar p[3];
    scalar q[3];
    for (label c = 0; c < 3; ++c)
    {
        p[c] = x[3*j + c] - x[3*i + c];
        q[c] = x[3*k + c] - x[3*i + c];
    }

    elementDual::halfCross(p, q, area);
}


//- Area vector of a face in 2D, an edge from node 0 to node 1 with a
//  right-handed turn outward
static void edgeArea(const scalar* x, const scalar handedness, scalar* area)
{
    area[0] = handedness*(x[3] - x[1]);
    area[1] = -handedness*(x[2] - x[0]);
}


//- A triangle of a face, with its weights (6 1 1)/8, (60)
static void addTriangle
(
    const label i,
    const label j,
    const label k,
    const scalar* x,
    const scalar share,
    cornerWeights& weights
)
{
    const label corners[3] = {i, j, k};

    scalar area[3];
    triangleArea(i, j, k, x, area);
    const scalar magnitude = length(area, 3);

    for (label a = 0; a < 3; ++a)
    {
        for (label b = 0; b < 3; ++b)
        {
            const scalar factor = share*(a == b ? 6 : 1)/24.0;

            weights.add(corners[a], corners[b], factor, magnitude, area);
        }
    }
}


//- A face in 3D
static void addFace3D
(
    const scalar* x,
    const label* faceNodes,
    const simplexDecomposition& decomposition,
    const bool native,
    cornerWeights& weights
)
{
    const label n = weights.n;

    if (native)
    {
        for (label a = 0; a < n; ++a)
        {
            scalar area[3];
            nativeDual::cornerArea(n, a, x, area);
            weights.add(a, a, 1, length(area, 3), area);
        }
    }
    else if (n == 3)
    {
        addTriangle(0, 1, 2, x, 1, weights);
    }
    else
    {
        const label diagonal = decomposition.diagonal(faceNodes);
        const label first = (diagonal == -1 ? 0 : diagonal % 2);
        const label last = (diagonal == -1 ? 1 : first);
        const scalar share = (diagonal == -1 ? 0.5 : 1);

        for (label d = first; d <= last; ++d)
        {
            addTriangle(d, d + 1, d + 2, x, share, weights);
            addTriangle(d, d + 2, (d + 3) % 4, x, share, weights);
        }
    }
}


//- A face in 2D: weights (5 1)/6
static void addFace2D
(
    const scalar* x,
    const scalar handedness,
    const bool native,
    cornerWeights& weights
)
{
    scalar area[2];
    edgeArea(x, handedness, area);
    const scalar magnitude = length(area, 2);

    for (label a = 0; a < 2; ++a)
    {
        for (label b = 0; b < 2; ++b)
        {
            const scalar factor =
                native ? (a == b ? 0.5 : 0) : (a == b ? 5 : 1)/12.0;

            weights.add(a, b, factor, magnitude, area);
        }
    }
}


//- The mesh points of the corners of a face: in 3D the face itself, in 2D its
//  two points in front, in the order of the face, in 1D its first
static label facePoints
(
    const polyMesh& mesh,
    const polyPatch& patch,
    const face& f,
    const solutionNodes& nodes,
    label* points
)
{
    if (nodes.nDim == 3)
    {
        forAll(f, fp)
        {
            points[fp] = f[fp];
        }

        return f.size();
    }

    if (nodes.nDim == 2 && f.size() == 4)
    {
        forAll(f, fp)
        {
            const label p = f[fp];
            const label q = f.nextLabel(fp);

            if
            (
                nodes.nodePoint[nodes.pointNode[p]] == p
             && nodes.nodePoint[nodes.pointNode[q]] == q
             && nodes.pointNode[f.prevLabel(fp)] == nodes.pointNode[p]
             && nodes.pointNode[p] != nodes.pointNode[q]
            )
            {
                points[0] = p;
                points[1] = q;

                return 2;
            }
        }
    }

    if (nodes.nDim == 1)
    {
        bool isEnd = true;
        forAll(f, fp)
        {
            isEnd = isEnd && nodes.pointNode[f[fp]] == nodes.pointNode[f[0]];
        }

        if (isEnd)
        {
            points[0] = nodes.nodePoint[nodes.pointNode[f[0]]];

            return 1;
        }
    }

    FatalFileErrorInFunction(meshFile(mesh))
        << "Region " << mesh.name() << ": a face of patch " << patch.name()
        << " at " << f.centre(mesh.points()) << nl
        << "    is normal to a direction that this " << nodes.nDim
        << "D mesh leaves out: the patch should be empty."
        << exit(FatalIOError);

    return 0;
}


//- The corners of a patch
static void calculatePatch
(
    const polyMesh& mesh,
    const polyPatch& patch,
    const solutionNodes& nodes,
    const scalarField& x,
    const simplexDecomposition& decomposition,
    const bool native,
    dualPatch& result
)
{
    const label nDim = nodes.nDim;
    const label nFaces = patch.size();

    result.faceStart.setSize(nFaces + 1);
    result.weightStart.setSize(nFaces + 1);

    label nCorners = 0;
    label nWeights = 0;

    for (label facei = 0; facei < nFaces; ++facei)
    {
        const label n = (nDim == 3 ? patch[facei].size() : nDim);

        result.faceStart[facei] = nCorners;
        result.weightStart[facei] = nWeights;

        nCorners += n;
        nWeights += n*n;
    }

    result.faceStart[nFaces] = nCorners;
    result.weightStart[nFaces] = nWeights;

    result.cornerNode.setSize(nCorners);
    result.cornerPoint.setSize(nCorners);
    result.cornerArea.setSize(nCorners);
    result.cornerNormal.setSize(nCorners*nDim);
    result.weights.setSize(nWeights, Zero);
    result.weightVectors.setSize(nWeights*nDim, Zero);

    for (label facei = 0; facei < nFaces; ++facei)
    {
        const face& f = patch[facei];

        label points[4];
        label faceNodes[4];
        scalar faceX[12];

        const label n = facePoints(mesh, patch, f, nodes, points);

        for (label a = 0; a < n; ++a)
        {
            faceNodes[a] = nodes.pointNode[points[a]];

            for (label k = 0; k < nDim; ++k)
            {
                faceX[a*nDim + k] = x[faceNodes[a]*nDim + k];
            }
        }

        cornerWeights weights
        {
            n, nDim, result.weights.data() + result.weightStart[facei],
            result.weightVectors.data() + result.weightStart[facei]*nDim
        };

        if (nDim == 3)
        {
            addFace3D(faceX, faceNodes, decomposition, native, weights);
        }
        else if (nDim == 2)
        {
            addFace2D(faceX, nodes.handedness, native, weights);
        }
        else
        {
            const vector outward = f.areaNormal(mesh.points());
            const scalar area = (outward[nodes.directions[0]] < 0 ? -1 : 1);

            weights.add(0, 0, 1, 1, &area);
        }

        for (label a = 0; a < n; ++a)
        {
            const label corneri = result.faceStart[facei] + a;

            scalar area = 0;
            scalar normal[3] = {0, 0, 0};

            for (label j = 0; j < n; ++j)
            {
                const label i = a*n + j;
                area += weights.s[i];
                for (label k = 0; k < nDim; ++k)
                {
                    normal[k] += weights.w[i*nDim + k];
                }
            }

            const scalar magnitude = max(length(normal, nDim), VSMALL);

            result.cornerNode[corneri] = faceNodes[a];
            result.cornerPoint[corneri] = points[a];
            result.cornerArea[corneri] = area;

            for (label k = 0; k < nDim; ++k)
            {
                result.cornerNormal[corneri*nDim + k] = normal[k]/magnitude;
            }
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dualPatch::calculate
(
    const polyMesh& mesh,
    const solutionNodes& nodes,
    const scalarField& x,
    const simplexDecomposition& decomposition,
    const bool native,
    PtrList<dualPatch>& patches
)
{
    patches.setSize(mesh.boundaryMesh().size());

    forAll(mesh.boundaryMesh(), patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];

        patches.set(patchi, new dualPatch());
        patches[patchi].nDim = nodes.nDim;
        patches[patchi].patchIndex = patchi;
        patches[patchi].name = patch.name();
        patches[patchi].handedness = nodes.handedness;

        if (!isA<emptyPolyPatch>(patch) && !isA<processorPolyPatch>(patch))
        {
            calculatePatch
            (
                mesh,
                patch,
                nodes,
                x,
                decomposition,
                native,
                patches[patchi]
            );
        }
    }
}


void Foam::dualPatch::cornerAreas
(
    const face& f,
    const scalar* x,
    scalar* areas
) const
{
    if (nDim == 1)
    {
        areas[0] = weightVectors[f.firstWeight];
        return;
    }

    if (nDim == 2)
    {
        scalar area[2];
        edgeArea(x, handedness, area);
        for (label k = 0; k < 4; ++k) areas[k] = 0.5*area[k % 2];
        return;
    }

    for (label k = 0; k < 3*f.size; ++k) areas[k] = 0;

    // Each corner of a triangle gets a third
    const auto add = [&]
    (
        const label i,
        const label j,
        const label k,
        const scalar share
    )
    {
        scalar area[3];
        triangleArea(i, j, k, x, area);
        for (const label a : {i, j, k})
        {
            for (label c = 0; c < 3; ++c) areas[3*a + c] += share/3*area[c];
        }
    };

    if (f.size == 3)
    {
        add(0, 1, 2, 1);
        return;
    }

    // Nodes have a common weight if they share a triangle: across a diagonal
    // only if it splits the face, never in the native dual
    const scalar* s = weights.cdata() + f.firstWeight;
    const bool first = s[2] > 0, second = s[7] > 0;
    if (!first && !second)
    {
        for (label a = 0; a < f.size; ++a)
        {
            nativeDual::cornerArea(f.size, a, x, areas + 3*a);
        }
        return;
    }

    const scalar share = first && second ? 0.5 : 1;
    for (label d = first ? 0 : 1; d < (second ? 2 : 1); ++d)
    {
        add(d, d + 1, d + 2, share);
        add(d, d + 2, (d + 3) % 4, share);
    }
}


// ************************************************************************* //
