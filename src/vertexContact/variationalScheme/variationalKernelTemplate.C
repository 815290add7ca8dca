/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "variationalNodes.C"
#include "variationalKernelEdges.C"
#include "variationalCorrections.C"
#include "variationalFluxes.C"
#include "cornerStates.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int D, bool finite>
label variationalKernelTemplate<D, finite>::collect()
{
    label nBad = 0;
    for (index a = 0; a < d_.nNodes(); ++a) nBad += collectNode(a);
    return nBad;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::move
(
    const scalar deltaT,
    const scalar half
)
{
    const scalar perRho = 1/d_.rho, perHalf = 1/half;
    const scalar* lm = d_.state.lm.cdata();
    const scalar* oldLm = d_.old.lm.cdata();
    scalar* disp = d_.state.disp.data();
    scalar* oldDisp = d_.old.disp.data();
    scalar* rush = x_.acceleration.data();
    scalar* oldRush = x_.oldAcceleration.data();
    label nBad = 0;
    if constexpr (D == 2)
    {
        // Both components of a node at once
        typedef std::int64_t twoCounts __attribute__((vector_size(16)));
        twoCounts good{};
        scalar* U = x_.U.data();
        const scalar* damping = d_.rates.cdata() + second;
        const index n = d_.nNodes();
        for (index a = 0; a < n; ++a)
        {
            const index k = a*D;
            const row<2> v = perRho*rowAt<2>(lm + k);
            const row<2> change = rowAt<2>(lm + k) - rowAt<2>(oldLm + k);
            const row<2> u = rowAt<2>(disp + k);
            const row<2> acceleration =
                perRho*(perHalf*change - rowAt<2>(damping + a*sR));
            rowAt<2>(oldDisp + k) = u;
            rowAt<2>(disp + k) = u + deltaT*v;
            rowAt<2>(oldRush + k) = rowAt<2>(rush + k);
            rowAt<2>(rush + k) = acceleration;
            rowAt<2>(U + a*sU + atU) = u + deltaT*v;
            rowAt<2>(U + a*sU + atU + D) = v;
            rowAt<2>(U + a*sU + atU + 2*D) = acceleration;
            good -= twoCounts((v < VGREAT) & (v > -VGREAT));
        }
        return 2*n - label(good[0] + good[1]);
    }
    else if constexpr (D == 3)
    {
        for (index a = 0; a < d_.nNodes(); ++a)
        {
            const index k = a*D;
            const row<4> p = threeAt(lm + k);
            const row<4> v = perRho*p;
            const row<4> u = threeAt(disp + k);
            const row<4> next = u + deltaT*v;
            const row<4> acceleration =
                perRho
               *(
                    perHalf*(p - threeAt(oldLm + k))
                  - threeAt(d_.rates.cdata() + a*sR + second)
                );
            storeThree(oldDisp + k, u);
            storeThree(disp + k, next);
            storeThree(oldRush + k, threeAt(rush + k));
            storeThree(rush + k, acceleration);
            nBad += collectNode3(a, next, v);
        }
        return nBad;
    }
    else
    {
        for (index a = 0; a < d_.nNodes(); ++a)
        {
            oldDisp[a] = disp[a];
            disp[a] += deltaT*perRho*lm[a];
            nBad += collectNode(a);
        }
        return nBad;
    }
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::deform
(
    const label first,
    const label end
)
{
    label nBad = 0;
    for (label late = first; late < end; ++late)
    {
        nBad += !deformNode(x_.lateNodes[late]);
    }
    return nBad;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::kinematics
(
    const label first,
    const label end
)
{
    label nBad = 0;
    for (label late = first; late < end; ++late)
    {
        nBad += !moveNode(x_.lateNodes[late]);
        takeJumps(x_.lateNodes[late]);
        setJumpsAside(late);
    }
    return nBad;
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::addPressure()
{
    for (label a = 0; a < d_.nNodes(); ++a)
    {
        scalar* W = d_.W.data() + a*d_.strideW;
        const scalar more = x_.jacobian[a] - W[d_.offsetSJ()];
        const SolidTensor<D> H =
            cofactor(loadF<D>(d_.state.F.cdata(), a));
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                W[d_.offsetP() + j*D + i] += more*H(i, j);
            }
        }
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::stresses
(
    const label first,
    const label end
)
{
    for (label late = first; late < end; ++late)
    {
        addJumps(late);
        stressNode(x_.lateNodes[late]);
    }
}


template<int D, bool finite>
lanes variationalKernelTemplate<D, finite>::largestOf(const lanes* S)
{
    lanes trace{}, square{};
    for (int i = 0, k = 0; i < D; ++i)
    {
        for (int j = i; j < D; ++j, ++k)
        {
            if (i == j) trace += S[k];
            square += scalar(i == j ? 1 : 2)*S[k]*S[k];
        }
    }
    const lanes mean = (1.0/D)*trace;
    return
        mean
      + squareRoot(max(lanes{}, ((1.0/D)*square - mean*mean)*scalar(D - 1)));
}


template<int D, bool finite>
lanes variationalKernelTemplate<D, finite>::squaredFrequency
(
    const lanes* K,
    const lanes* F,
    const lanes& factor,
    const scalar cp
)
{
    lanes most = largestOf(K);
    if constexpr (finite && D > 1)
    {
        // H, the cofactor of F
        lanes H[D][D];
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                if constexpr (D == 2)
                {
                    H[i][j] = (i == j ? 1 : -1)*F[(1 - i)*2 + 1 - j];
                }
                else
                {
                    const int p = (i + 1) % 3, q = (i + 2) % 3;
                    const int r = (j + 1) % 3, s = (j + 2) % 3;
                    H[i][j] = F[3*p + r]*F[3*q + s] - F[3*p + s]*F[3*q + r];
                }
            }
        }

        // The eigenvalues of H K H^T are those of K H^T H
        lanes full[D][D], HK[D][D], S[nK];
        for (int i = 0, k = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k) full[i][j] = full[j][i] = K[k];
        }
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                HK[i][j] = lanes{};
                for (int m = 0; m < D; ++m) HK[i][j] += H[i][m]*full[m][j];
            }
        }
        for (int i = 0, k = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k)
            {
                S[k] = lanes{};
                for (int m = 0; m < D; ++m) S[k] += HK[i][m]*H[j][m];
            }
        }
        most = max(most, largestOf(S));
    }
    return cp*cp*factor*factor*most;
}


template<int D, bool finite>
lanes variationalKernelTemplate<D, finite>::timeScales(const label first) const
{
    const int n = min(label(nLanes), d_.nNodes() - first);
    lanes K[nK], F[nP], waves[nK];
    const stridedLanes K_(nK, n), waves_(sK, n), F_(nP, n), scalars(1, n);
    for (int k = 0; k < nK; ++k)
    {
        K[k] = K_(x_.geometricBound.cdata() + first*nK + k);
        waves[k] = waves_(x_.waves().cdata() + first*sK + k);
    }
    for (int k = 0; k < nP; ++k)
    {
        F[k] = F_(d_.state.F.cdata() + first*nP + k);
    }
    const lanes perV = scalars(x_.perV.cdata() + first);
    const lanes factor =
        d_.waveFactor.size()
      ? scalars(d_.waveFactor.cdata() + first)
      : uniform<lanes>(1);
    const lanes square = x_.boundRatio*squaredFrequency(K, F, factor, d_.cp);

    const lanes damping =
        (0.5*x_.frontEpsilon)*perV*largestOf(waves);
    return
        (2*x_.stepRatio)
       *reciprocal(squareRoot(damping*damping + square) + damping);
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::largestBound() const
{
    lanes largest{};
    const label n = x_.geometricBound.size()/nK;
    for (label first = 0; first < n; first += nLanes)
    {
        lanes K[nK];
        const stridedLanes K_(nK, min(label(nLanes), n - first));
        for (int k = 0; k < nK; ++k)
        {
            K[k] = K_(x_.geometricBound.cdata() + first*nK + k);
        }
        largest = max(largest, largestOf(K));
    }
    scalar most = 0;
    for (int l = 0; l < nLanes; ++l) most = max(most, largest[l]);
    return most;
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::timeScale(const label node) const
{
    return timeScales(node)[0];
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::timeScale() const
{
    lanes least = uniform<lanes>(GREAT);
    for (label a = 0; a < d_.nNodes(); a += nLanes)
    {
        least = min(least, timeScales(a));
    }
    scalar shortest = GREAT;
    for (int l = 0; l < nLanes; ++l) shortest = min(shortest, least[l]);
    return shortest;
}


template<int D, bool finite>
template<class Function>
void variationalKernelTemplate<D, finite>::forWeights(const Function& f) const
{
    const label* edge = d_.dual.edgeNodes().cdata();
    const scalar* area = d_.edgeArea();
    scalar g[D];
    for (label e = 0; e < d_.dual.nEdges(); ++e)
    {
        for (int j = 0; j < D; ++j) g[j] = 0.5*area[D*e + j];
        f(edge[2*e], edge[2*e + 1], g);
        for (int j = 0; j < D; ++j) g[j] = -g[j];
        f(edge[2*e + 1], edge[2*e], g);
    }
    for (label p = 0; p < x_.pairNodes.size()/2; ++p)
    {
        const scalar* B = x_.pairArea.cdata() + D*p;
        f(x_.pairNodes[2*p], x_.pairNodes[2*p + 1], B);
        f(x_.pairNodes[2*p + 1], x_.pairNodes[2*p], B);
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::boundColumns
(
    scalarField& sums
) const
{
    sums = Zero;
    forWeights([&](const label a, const label b, const scalar* g)
    {
        scalar gg = 0;
        for (int j = 0; j < D; ++j)
        {
            sums[a*(D + 1) + j] -= g[j];
            gg += g[j]*g[j];
        }
        sums[b*(D + 1) + D] += std::sqrt(gg);
    });
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::boundRows
(
    const scalarField& sums,
    scalarField& bound
) const
{
    const scalar* V = d_.dual.nodeVolume().cdata();
    const auto& owned = d_.dual.sharing().owned();
    bound = Zero;
    const auto add = [&](const label a, const label b, const scalar* g)
    {
        scalar gg = 0, ownB = 0;
        for (int j = 0; j < D; ++j)
        {
            gg += g[j]*g[j];
            ownB += sums[b*(D + 1) + j]*sums[b*(D + 1) + j];
        }
        if (gg < VSMALL) return;
        const scalar column = sums[b*(D + 1) + D] + std::sqrt(ownB);
        const scalar factor = column/(std::sqrt(gg)*V[a]*V[b]);
        for (int i = 0, k = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k)
            {
                bound[a*nK + k] += factor*g[i]*g[j];
            }
        }
    };
    forWeights(add);
    for (label a = 0; a < d_.nNodes(); ++a)
    {
        if (owned[a]) add(a, a, sums.cdata() + a*(D + 1));
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

template<int D>
autoPtr<variationalKernel> newVariationalKernel
(
    vertexData& d,
    variationalData& x
)
{
    if (d.finiteStrain)
    {
        return autoPtr<variationalKernel>
        (
            new variationalKernelTemplate<D, true>(d, x)
        );
    }
    return autoPtr<variationalKernel>
    (
        new variationalKernelTemplate<D, false>(d, x)
    );
}

} // End namespace Foam


// ************************************************************************* //
