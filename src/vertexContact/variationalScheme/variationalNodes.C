/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Work on a node after all of its edges have added to it.

\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "edgeRows.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

template<int D, bool finite>
inline label variationalKernelTemplate<D, finite>::collectNode(const index a)
{
    const scalar perRho = 1/d_.rho;
    const scalar* lm = d_.state.lm.cdata() + a*D;
    const scalar* disp = d_.state.disp.cdata() + a*D;
    if constexpr (D == 3)
    {
        return collectNode3(a, threeAt(disp), perRho*threeAt(lm));
    }
    else
    {
        scalar* U = x_.U.data() + a*sU + atU;
        label nBad = 0;
        for (int i = 0; i < D; ++i)
        {
            const scalar v = perRho*lm[i];
            nBad += !(mag(v) < VGREAT);
            U[i] = disp[i];
            U[second + i] = v;
            if constexpr (D == 2) U[2*D + i] = x_.acceleration[a*D + i];
        }
        return nBad;
    }
}


template<int D, bool finite>
inline label variationalKernelTemplate<D, finite>::collectNode3
(
    const index a,
    const row<4>& disp,
    const row<4>& v
)
{
    rowAt<8>(x_.U.data() + a*sU) = joined(disp, v);
    const auto good = (v < VGREAT) & (v > -VGREAT);
    return 4 + label(good[0] + good[1] + good[2] + good[3]);
}


template<int D, bool finite>
inline scalar variationalKernelTemplate<D, finite>::invert
(
    row<4>* inverse,
    const scalar* g
)
{
    const row<4> F[3] =
    {
        rowAt<4>(g) + row<4>{1, 0, 0, 0},
        rowAt<4>(g + sA) + row<4>{0, 1, 0, 0},
        rowAt<4>(g + 2*sA) + row<4>{0, 0, 1, 0}
    };
    // The columns of the cofactor are the rows of the inverse, times det
    inverse[0] = cross(F[1], F[2]);
    inverse[1] = cross(F[2], F[0]);
    inverse[2] = cross(F[0], F[1]);
    const scalar det = dotOfThree(F[0], inverse[0]);
    const scalar perDet = 1/det;
    for (int k = 0; k < 3; ++k) inverse[k] *= perDet;
    return det;
}


template<int D, bool finite>
inline bool variationalKernelTemplate<D, finite>::deformRow
(
    const index a,
    const row<8>& g
)
{
    // From the derivatives of the displacement, both columns in one row
    const row<4> H = picked<5, 4, 1, 0>(g)*row<4>{1, -1, -1, 1}
      + row<4>{1, 0, 0, 1};
    const scalar det = H[0]*H[3] - H[1]*H[2];
    const row<4> inverse = H*(1/det);
    rowAt<4>(x_.inverse.data() + a*nP) = inverse;

    // L_ij = sum_k dv_i/dX_k inverse_kj; derivatives of the displacement stay
    constexpr row<8> one = {1, 1, 0, 0, 1, 1, 0, 0};
    const row<8> per = joined(inverse, row<4>{});
    rowAt<8>(x_.grad.data() + a*D*sA) =
        picked<0, 1, 2, 3, 4, 5, 2, 3>(g)
       *(one + picked<8, 8, 0, 0, 8, 8, 1, 1>(per))
      + picked<8, 8, 6, 7, 8, 8, 6, 7>(g)*picked<8, 8, 2, 2, 8, 8, 3, 3>(per);
    return det > 0;
}


template<int D, bool finite>
inline bool variationalKernelTemplate<D, finite>::deformNode(const index a)
{
    if constexpr (!finite)
    {
        return true;
    }
    scalar* g = x_.grad.data() + a*D*sA;
    if constexpr (D == 2 && finite)
    {
        return deformRow(a, rowAt<8>(g));
    }
    else if constexpr (D == 3 && finite)
    {
        row<4> inverse[3], L[D] = {};
        const scalar det = invert(inverse, g);
        for (int k = 0; k < D; ++k)
        {
            const row<4> v = rowAt<4>(g + k*sA + second);
            for (int j = 0; j < D; ++j) L[j] += v*inverse[k][j];
        }
        for (int j = 0; j < D; ++j) rowAt<4>(g + j*sA + second) = L[j];
        return det > 0;
    }
    else
    {
        const scalar F = 1 + g[0];
        g[second] /= F;
        return F > 0;
    }
}


template<int D, bool finite>
inline void variationalKernelTemplate<D, finite>::takeForce(const index a)
{
    const row<4> force = -2*rowAt<4>(x_.sensor.cdata() + a*sS);
    scalar* rates = d_.rates.data() + a*sR;
    if constexpr (D == 2)
    {
        rowAt<4>(rates) = row<4>{force[2], force[3], 0, 0};
    }
    else if constexpr (D == 3)
    {
        rowAt<8>(rates) = joined(threeOf(force), row<4>{});
    }
}


template<int D, bool finite>
inline void variationalKernelTemplate<D, finite>::takeJumps(const index a)
{
    scalar* c = x_.adjoint.data() + a*D*sA;
    if constexpr (D == 1)
    {
        zeroAt<sA>(c);
    }
    else if (x_.beta > 0)
    {
        if constexpr (D == 2)
        {
            rowAt<8>(c) = picked<2, 3, 8, 8, 6, 7, 8, 8>(rowAt<8>(c));
        }
        else
        {
            for (int j = 0; j < D; ++j)
            {
                rowAt<8>(c + j*sA) =
                    joined(rowAt<4>(c + j*sA + second), row<4>{});
            }
        }
    }
}


template<int D, bool finite>
inline void variationalKernelTemplate<D, finite>::setJumpsAside
(
    const label late
)
{
    scalar* c = x_.adjoint.data() + index(x_.lateNodes[late])*D*sA;
    if constexpr (D > 1)
    {
        scalar* jumps =
            x_.lateJumps.data() + late*variationalLayout::strideJump(D);
        for (int j = 0; j < D; ++j)
        {
            for (int i = 0; i < D; ++i) jumps[j*second + i] = c[j*sA + i];
        }
    }
    zeroAt<D*sA>(c);
}


template<int D, bool finite>
inline void variationalKernelTemplate<D, finite>::addJumps(const label late)
{
    if constexpr (D > 1)
    {
        scalar* T = x_.adjoint.data() + index(x_.lateNodes[late])*D*sA;
        const scalar* jumps =
            x_.lateJumps.cdata() + late*variationalLayout::strideJump(D);
        for (int j = 0; j < D; ++j)
        {
            for (int i = 0; i < D; ++i) T[j*sA + i] += jumps[j*second + i];
        }
    }
}


template<int D, bool finite>
inline row<4> variationalKernelTemplate<D, finite>::storeCofactor
(
    scalar* g,
    const row<4>* F
)
{
    const row<4> first = cross(F[1], F[2]);
    rowAt<4>(g + second) = first;
    rowAt<4>(g + sA + second) = cross(F[2], F[0]);
    rowAt<4>(g + 2*sA + second) = cross(F[0], F[1]);
    return first;
}


template<int D, bool finite>
inline bool variationalKernelTemplate<D, finite>::moveNode(const index a)
{
    scalar* F = d_.state.F.data();
    const scalar perV = x_.perV[a];
    scalar* sensor = x_.sensor.data() + a*sS;
    const row<4> squares = rowAt<4>(sensor + atSquares)*x_.perEdges[a];
    const scalar* g = x_.grad.cdata() + a*D*sA;
    const scalar* c = x_.adjoint.cdata() + a*D*sA;
    const bool holdsJumps = d_.state.flow.jumpEnergy.size();
    if constexpr (D == 2)
    {
        row<8> sum = rowAt<8>(g);
        if (x_.beta > 0) sum += perV*rowAt<8>(c);
        if (holdsJumps) d_.state.flow.jumpEnergy[a] = perV*sensor[atJumps];
        const row<4> f = picked<0, 4, 1, 5>(sum) + row<4>{1, 0, 0, 1};
        rowAt<4>(F + a*nP) = f;
        rowAt<8>(sensor) = joined(f, squares);
    }
    else if constexpr (D == 3)
    {
        if (holdsJumps) d_.state.flow.jumpEnergy[a] = perV*sensor[atJumps];
        rowAt<4>(sensor + atSquares) = squares;
        row<4> f[D];
        for (int j = 0; j < D; ++j)
        {
            f[j] = rowAt<4>(g + j*sA);
            if (x_.beta > 0) f[j] += perV*rowAt<4>(c + j*sA);
        }
        f[0] += row<4>{1, 0, 0, 0};
        f[1] += row<4>{0, 1, 0, 0};
        f[2] += row<4>{0, 0, 1, 0};
        storeRows(F + a*nP, f[0], f[1], f[2]);
        if constexpr (finite)
        {
            // Overwrite L, which the corrections have used
            const row<4> H = storeCofactor(x_.grad.data() + a*D*sA, f);
            const scalar J = dotOfThree(f[0], H);
            if (x_.smoothed) x_.jacobian[a] = J;
            return J > 0;
        }
    }
    else
    {
        rowAt<4>(sensor + atSquares) = squares;
        F[a] = 1 + (x_.beta > 0 ? g[0] + perV*c[0] : g[0]);
    }

    if constexpr (finite)
    {
        const SolidTensor<D> f = loadF<D>(F, a);
        const scalar J = determinant(f);
        if (x_.smoothed) x_.jacobian[a] = J;
        return J > 0;
    }
    else
    {
        bool good = true;
        for (int k = 0; k < nP; ++k)
        {
            good = good && mag(F[a*nP + k]) < largestLinearF;
        }
        return good;
    }
}


template<int D, bool finite>
inline void variationalKernelTemplate<D, finite>::stressNode(const index a)
{
    const scalar* P = d_.W.cdata() + d_.offsetP() + a*d_.strideW;
    const scalar perV = x_.perV[a];
    scalar* T = x_.adjoint.data() + a*D*sA;
    if constexpr (D == 2)
    {
        // Each row has both columns
        row<8> sum = rowAt<8>(T);
        if constexpr (finite)
        {
            // Z (G x)^-T
            constexpr row<8> one = {1, 1, 0, 0, 1, 1, 0, 0};
            const row<8> inverse =
                joined(rowAt<4>(x_.inverse.cdata() + a*nP), row<4>{});
            sum =
                picked<0, 1, 2, 3, 4, 5, 2, 3>(sum)
               *(one + picked<8, 8, 0, 0, 8, 8, 2, 2>(inverse))
              + picked<8, 8, 6, 7, 8, 8, 6, 7>(sum)
               *picked<8, 8, 1, 1, 8, 8, 3, 3>(inverse);
        }
        rowAt<8>(T) =
            picked<0, 1, 8, 8, 2, 3, 8, 8>(joined(rowAt<4>(P), row<4>{}))
          + perV*sum;
    }
    else if constexpr (D == 3)
    {
        row<4> Z[D] = {}, inverse[3];
        if constexpr (finite) invert(inverse, x_.grad.cdata() + a*D*sA);
        for (int k = 0; k < D; ++k)
        {
            const row<4> z = rowAt<4>(T + k*sA + second);
            if constexpr (finite)
            {
                // Z (G x)^-T
                for (int j = 0; j < D; ++j) Z[j] += z*inverse[j][k];
            }
            else
            {
                Z[k] = z;
            }
        }
        for (int j = 0; j < D; ++j)
        {
            rowAt<8>(T + j*sA) = joined
            (
                threeOf(rowAt<4>(P + j*D)) + perV*rowAt<4>(T + j*sA),
                perV*Z[j]
            );
        }
    }
    else
    {
        T[0] = P[0] + perV*T[0];
        T[second] *= finite ? perV/(1 + x_.grad[a*sA]) : perV;
    }
}

} // End namespace Foam


// ************************************************************************* //
