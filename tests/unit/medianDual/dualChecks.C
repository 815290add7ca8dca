/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dualChecks.H"
#include "polyMesh.H"
#include "PstreamReduceOps.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Weight vectors of all boundary faces: f(node of the corner, other node of
//  the face, weight vector of the other's value at the corner)
template<class Function>
void forWeights(const medianDual& dual, const Function& f)
{
    for (const dualPatch& patch : dual.patches())
    {
        for (label facei = 0; facei < patch.nFaces(); ++facei)
        {
            const label start = patch.faceStart[facei];
            const label n = patch.faceStart[facei + 1] - start;
            const scalar* w =
                patch.weightVectors.cdata()
              + patch.weightStart[facei]*dual.nDim();

            for (label a = 0; a < n; ++a)
            {
                for (label j = 0; j < n; ++j, w += dual.nDim())
                {
                    f
                    (
                        patch.cornerNode[start + a],
                        patch.cornerNode[start + j], w
                    );
                }
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dualChecks::volume(const medianDual& dual)
{
    scalar sum = 0;
    forAll(dual.nodeVolume(), node)
    {
        if (dual.sharing().owned().test(node))
        {
            sum += dual.nodeVolume()[node];
        }
    }

    return returnReduce(sum, sumOp<scalar>());
}


Foam::scalar Foam::dualChecks::boundaryVolume(const medianDual& dual)
{
    const label d = dual.nDim();
    scalar sum = 0;
    forWeights(dual, [&](const label, const label node, const scalar* w)
    {
        for (label k = 0; k < d; ++k)
        {
            sum += dual.nodePosition()[node*d + k]*w[k]/d;
        }
    });

    return returnReduce(sum, sumOp<scalar>());
}


Foam::scalar Foam::dualChecks::gap(const medianDual& dual)
{
    const label d = dual.nDim();
    scalarField sum(dual.nNodes()*d, Zero);
    scalarField area(dual.nNodes(), Zero);

    for (label edgei = 0; edgei < dual.nEdges(); ++edgei)
    {
        const label a = dual.edgeNodes()[2*edgei];
        const label b = dual.edgeNodes()[2*edgei + 1];

        for (label k = 0; k < d; ++k)
        {
            const scalar c = dual.edgeArea()[edgei*d + k];

            sum[a*d + k] += c;
            sum[b*d + k] -= c;
            area[a] += mag(c);
            area[b] += mag(c);
        }
    }

    forWeights(dual, [&](const label node, const label, const scalar* w)
    {
        for (label k = 0; k < d; ++k) sum[node*d + k] += w[k];
    });

    dual.sharing().sum({{sum.data(), d}, {area.data(), 1}});

    scalar worst = 0;
    forAll(sum, i)
    {
        worst = max(worst, mag(sum[i])/area[i/d]);
    }

    return returnReduce(worst, maxOp<scalar>());
}


Foam::scalar Foam::dualChecks::exactGradient(const label i, const label j)
{
    static const scalar gradient[3][3] =
    {
        {0.7, -0.4, 0.3},
        {0.2, -1.1, 0.6},
        {-0.5, 0.9, 0.8}
    };

    return gradient[i][j];
}


Foam::scalarField Foam::dualChecks::gradient(const medianDual& dual)
{
    const label d = dual.nDim();
    const scalarField& x = dual.nodePosition();

    scalarField v(dual.nNodes()*d);
    for (label node = 0; node < dual.nNodes(); ++node)
    {
        for (label i = 0; i < d; ++i)
        {
            v[node*d + i] = 0.3 + 0.1*i;

            for (label j = 0; j < d; ++j)
            {
                v[node*d + i] += exactGradient(i, j)*x[node*d + j];
            }
        }
    }

    scalarField result(dual.nNodes()*d*d, Zero);

    for (label edgei = 0; edgei < dual.nEdges(); ++edgei)
    {
        const label a = dual.edgeNodes()[2*edgei];
        const label b = dual.edgeNodes()[2*edgei + 1];

        for (label i = 0; i < d; ++i)
        {
            for (label j = 0; j < d; ++j)
            {
                const scalar flux =
                    0.5*(v[a*d + i] + v[b*d + i])*dual.edgeArea()[edgei*d + j];

                result[(a*d + i)*d + j] += flux;
                result[(b*d + i)*d + j] -= flux;
            }
        }
    }

    forWeights(dual, [&](const label node, const label other, const scalar* w)
    {
        for (label i = 0; i < d; ++i)
        {
            for (label j = 0; j < d; ++j)
            {
                result[(node*d + i)*d + j] += v[other*d + i]*w[j];
            }
        }
    });

    dual.sharing().sum(result.data(), d*d);

    forAll(result, i)
    {
        result[i] /= dual.nodeVolume()[i/(d*d)];
    }

    return result;
}


Foam::scalar Foam::dualChecks::gradientError(const medianDual& dual)
{
    const label d = dual.nDim();
    const scalarField g(gradient(dual));

    scalar worst = 0;
    forAll(g, i)
    {
        const scalar exact = exactGradient((i/d) % d, i % d);

        // The largest component of the exact gradient is about 1
        worst = max(worst, mag(g[i] - exact));
    }

    return returnReduce(worst, maxOp<scalar>());
}


Foam::scalar Foam::dualChecks::weightError(const medianDual& dual)
{
    const label d = dual.nDim();
    scalar worst = 0;

    for (const dualPatch& patch : dual.patches())
    {
        for (label facei = 0; facei < patch.nFaces(); ++facei)
        {
            const label start = patch.faceStart[facei];
            const label n = patch.faceStart[facei + 1] - start;
            const scalar* s = patch.weights.cdata() + patch.weightStart[facei];
            const scalar* w =
                patch.weightVectors.cdata() + patch.weightStart[facei]*d;

            scalar x[12];
            scalar areas[12];
            for (label a = 0; a < n; ++a)
            {
                const label node = patch.cornerNode[start + a];
                for (label k = 0; k < d; ++k)
                {
                    x[a*d + k] = dual.nodePosition()[node*d + k];
                }
            }
            patch.cornerAreas(patch.faceOf(facei), x, areas);

            for (label a = 0; a < n; ++a)
            {
                const label corneri = start + a;
                const scalar area = patch.cornerArea[corneri];
                const scalar* normal = patch.cornerNormal.cdata() + corneri*d;

                scalar sum = 0;
                scalar along = 0;
                scalar normalSqr = 0;

                for (label j = 0; j < n; ++j)
                {
                    sum += s[a*n + j];
                    worst = max(worst, -s[a*n + j]/area);
                    worst = max(worst, mag(s[a*n + j] - s[j*n + a])/area);

                    for (label k = 0; k < d; ++k)
                    {
                        along += w[(a*n + j)*d + k]*normal[k];
                    }
                }

                for (label k = 0; k < d; ++k)
                {
                    normalSqr += sqr(normal[k]);

                    scalar difference = areas[a*d + k];
                    for (label j = 0; j < n; ++j)
                    {
                        difference -= w[(a*n + j)*d + k];
                    }
                    worst = max(worst, mag(difference)/area);
                }

                worst = max(worst, mag(sum - area)/area);
                worst = max(worst, mag(normalSqr - 1));

                // Less than the area where a face is warped
                worst = max(worst, (along - area)/area);
                if (along < 0.5*area)
                {
                    worst = max(worst, scalar(1));
                }
            }
        }
    }

    return returnReduce(worst, maxOp<scalar>());
}


bool Foam::dualChecks::consistent(const medianDual& dual)
{
    bool good =
        dual.pointNode().size() == dual.mesh().nPoints()
     && dual.nodePosition().size() == dual.nNodes()*dual.nDim()
     && dual.edgeArea().size() == dual.nEdges()*dual.nDim()
     && dual.patches().size() == dual.mesh().boundaryMesh().size();

    for (label node = 0; node < dual.nNodes(); ++node)
    {
        const label pointi = dual.nodePoint()[node];
        good = good && dual.pointNode()[pointi] == node;

        for (label k = 0; k < dual.nDim(); ++k)
        {
            good =
                good
             && dual.nodePosition()[node*dual.nDim() + k]
             == dual.mesh().points()[pointi][dual.directions()[k]];
        }
    }

    for (label edgei = 0; edgei < dual.nEdges(); ++edgei)
    {
        const label* e = dual.edgeNodes().cdata() + 2*edgei;

        good = good && e[0] < e[1];

        if (edgei)
        {
            good =
                good && (e[-2] < e[0] || (e[-2] == e[0] && e[-1] < e[1]));
        }
    }

    for (const dualPatch& patch : dual.patches())
    {
        forAll(patch.cornerNode, i)
        {
            good =
                good
             && dual.pointNode()[patch.cornerPoint[i]] == patch.cornerNode[i];
        }
    }

    return returnReduce(good, andOp<bool>());
}


Foam::label Foam::dualChecks::bandwidth(const medianDual& dual)
{
    label width = 0;
    for (label edgei = 0; edgei < dual.nEdges(); ++edgei)
    {
        width =
            max
            (
                width,
                dual.edgeNodes()[2*edgei + 1] - dual.edgeNodes()[2*edgei]
            );
    }

    return width;
}


// ************************************************************************* //
