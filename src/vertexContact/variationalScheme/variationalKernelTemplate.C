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
label variationalKernelTemplate<D, finite>::collect
(
    vertexData& d,
    variationalData& x
) const
{
    label nBad = 0;
    for (index a = 0; a < d.nNodes(); ++a) nBad += collectNode(d, x, a);
    return nBad;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::move
(
    vertexData& d,
    variationalData& x,
    const scalar deltaT,
    const scalar half
) const
{
    const scalar perRho = 1/d.rho, perHalf = 1/half;
    const scalar* lm = d.state.lm.cdata();
    const scalar* oldLm = d.old.lm.cdata();
    scalar* disp = d.state.disp.data();
    scalar* oldDisp = d.old.disp.data();
    scalar* rush = x.acceleration.data();
    scalar* oldRush = x.oldAcceleration.data();
    label nBad = 0;
    if constexpr (D == 2)
    {
        // Both components of a node at once
        typedef std::int64_t twoCounts __attribute__((vector_size(16)));
        twoCounts good{};
        scalar* U = x.U.data();
        const scalar* damping = d.rates.cdata() + second;
        const index n = d.nNodes();
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
        for (index a = 0; a < d.nNodes(); ++a)
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
                  - threeAt(d.rates.cdata() + a*sR + second)
                );
            storeThree(oldDisp + k, u);
            storeThree(disp + k, next);
            storeThree(oldRush + k, threeAt(rush + k));
            storeThree(rush + k, acceleration);
            nBad += collectNode3(d, x, a, next, v);
        }
        return nBad;
    }
    else
    {
        for (index a = 0; a < d.nNodes(); ++a)
        {
            oldDisp[a] = disp[a];
            disp[a] += deltaT*perRho*lm[a];
            nBad += collectNode(d, x, a);
        }
        return nBad;
    }
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::deform
(
    variationalData& x,
    const label first,
    const label end
) const
{
    label nBad = 0;
    for (label late = first; late < end; ++late)
    {
        nBad += !deformNode(x, x.lateNodes[late]);
    }
    return nBad;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::kinematics
(
    vertexData& d,
    variationalData& x,
    const label first,
    const label end
) const
{
    label nBad = 0;
    for (label late = first; late < end; ++late)
    {
        nBad += !moveNode(d, x, x.lateNodes[late]);
        takeJumps(x, x.lateNodes[late]);
        setJumpsAside(x, late);
    }
    return nBad;
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::smooth
(
    variationalData& x,
    const vertexData& d
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* k = x.smoothing.cdata();
    const scalar* J = x.jacobian.cdata();
    scalar* average = x.average.data();
    const label nEdges = d.dual.nEdges();

    x.average = Zero;
    index e = 0;
    for (index a = 0; a < d.nNodes(); ++a)
    {
        const scalar Ja = J[a];
        scalar sum = average[a];
        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            const index b = edge[2*e + 1];
            const scalar f = k[e]*(J[b] - Ja);
            sum += f;
            average[b] -= f;
        }
        average[a] = x.perV[a]*sum;
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::addPressure
(
    vertexData& d,
    const variationalData& x
) const
{
    for (label a = 0; a < d.nNodes(); ++a)
    {
        scalar* W = d.W.data() + a*d.strideW;
        const scalar more = x.jacobian[a] - W[d.offsetSJ()];
        const SolidTensor<D> H =
            cofactor(loadF<D>(d.state.F.cdata(), a));
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                W[d.offsetP() + j*D + i] += more*H(i, j);
            }
        }
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::stresses
(
    variationalData& x,
    const vertexData& d,
    const label first,
    const label end
) const
{
    for (label late = first; late < end; ++late)
    {
        addJumps(x, late);
        stressNode(x, d, x.lateNodes[late]);
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::addTractions
(
    const vertexData& d,
    const dualPatch& patch,
    const cornerStates& c,
    scalarField& force
) const
{
    const FixedList<label, 3>& dir = d.dual.directions();
    const scalar* V = d.dual.nodeVolume().cdata();
    patch.forFaces([&](const dualPatch::face& f)
    {
        const scalar* s = patch.weights.cdata() + f.firstWeight;
        for (label p = 0; p < f.size; ++p)
        {
            const label a = patch.cornerNode[f.start + p];
            vector sum(c.force[f.start + p]);
            for (label j = 0; j < f.size; ++j)
            {
                sum += s[p*f.size + j]*c.tB[f.start + j];
            }
            for (int i = 0; i < D; ++i) force[a*D + i] += sum[dir[i]]/V[a];
        }
    });
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::addSurfacePressure
(
    const vertexData& d,
    const dualPatch& patch,
    const scalar pressure,
    scalarField& force
) const
{
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* X = d.dual.nodePosition().cdata();
    const scalar* disp = d.state.disp.cdata();
    patch.forFaces([&](const dualPatch::face& f)
    {
        scalar x[4*D], areas[4*D];
        for (label p = 0; p < f.size; ++p)
        {
            const label a = patch.cornerNode[f.start + p];
            for (int i = 0; i < D; ++i)
            {
                x[p*D + i] = X[a*D + i];
                if constexpr (finite) x[p*D + i] += disp[a*D + i];
            }
        }
        patch.cornerAreas(D, f, x, areas);
        for (label p = 0; p < f.size; ++p)
        {
            const label a = patch.cornerNode[f.start + p];
            const scalar perV = pressure/V[a];
            for (int i = 0; i < D; ++i)
            {
                force[a*D + i] -= perV*areas[p*D + i];
            }
        }
    });
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
lanes variationalKernelTemplate<D, finite>::timeScales
(
    const vertexData& d,
    const variationalData& x,
    const label first
)
{
    const int n = min(label(nLanes), d.nNodes() - first);
    lanes K[nK], F[nP], waves[nK];
    const stridedLanes K_(nK, n), waves_(sK, n), F_(nP, n), scalars(1, n);
    for (int k = 0; k < nK; ++k)
    {
        K[k] = K_(x.geometricBound.cdata() + first*nK + k);
        waves[k] = waves_(x.waves().cdata() + first*sK + k);
    }
    for (int k = 0; k < nP; ++k)
    {
        F[k] = F_(d.state.F.cdata() + first*nP + k);
    }
    const lanes perV = scalars(x.perV.cdata() + first);
    const lanes factor =
        d.waveFactor.size()
      ? scalars(d.waveFactor.cdata() + first)
      : uniform<lanes>(1);
    const lanes square = x.boundRatio*squaredFrequency(K, F, factor, d.cp);

    const lanes damping =
        (0.5*x.frontEpsilon)*perV*largestOf(waves);
    return
        (2*x.stepRatio)
       *reciprocal(squareRoot(damping*damping + square) + damping);
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::largestBound
(
    const variationalData& x
) const
{
    lanes largest{};
    const label n = x.geometricBound.size()/nK;
    for (label first = 0; first < n; first += nLanes)
    {
        lanes K[nK];
        const stridedLanes K_(nK, min(label(nLanes), n - first));
        for (int k = 0; k < nK; ++k)
        {
            K[k] = K_(x.geometricBound.cdata() + first*nK + k);
        }
        largest = max(largest, largestOf(K));
    }
    scalar most = 0;
    for (int l = 0; l < nLanes; ++l) most = max(most, largest[l]);
    return most;
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::timeScale
(
    const vertexData& d,
    const variationalData& x,
    const label node
) const
{
    return timeScales(d, x, node)[0];
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::timeScale
(
    const vertexData& d,
    const variationalData& x
) const
{
    lanes least = uniform<lanes>(GREAT);
    for (label a = 0; a < d.nNodes(); a += nLanes)
    {
        least = min(least, timeScales(d, x, a));
    }
    scalar shortest = GREAT;
    for (int l = 0; l < nLanes; ++l) shortest = min(shortest, least[l]);
    return shortest;
}


template<int D, bool finite>
template<class Function>
void variationalKernelTemplate<D, finite>::forWeights
(
    const vertexData& d,
    const variationalData& x,
    const Function& f
)
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* area = d.edgeArea();
    scalar g[D];
    for (label e = 0; e < d.dual.nEdges(); ++e)
    {
        for (int j = 0; j < D; ++j) g[j] = 0.5*area[D*e + j];
        f(edge[2*e], edge[2*e + 1], g);
        for (int j = 0; j < D; ++j) g[j] = -g[j];
        f(edge[2*e + 1], edge[2*e], g);
    }
    for (label p = 0; p < x.pairNodes.size()/2; ++p)
    {
        const scalar* B = x.pairArea.cdata() + D*p;
        f(x.pairNodes[2*p], x.pairNodes[2*p + 1], B);
        f(x.pairNodes[2*p + 1], x.pairNodes[2*p], B);
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::boundColumns
(
    const vertexData& d,
    const variationalData& x,
    scalarField& sums
) const
{
    sums = Zero;
    forWeights(d, x, [&](const label a, const label b, const scalar* g)
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
    const vertexData& d,
    const variationalData& x,
    const scalarField& sums,
    scalarField& bound
) const
{
    const scalar* V = d.dual.nodeVolume().cdata();
    const auto& owned = d.dual.sharing().owned();
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
    forWeights(d, x, add);
    for (label a = 0; a < d.nNodes(); ++a)
    {
        if (owned[a]) add(a, a, sums.cdata() + a*(D + 1));
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

template<int D>
autoPtr<variationalKernel> newVariationalKernel(const vertexData& d)
{
    variationalKernel* k = nullptr;
    if (d.finiteStrain)
    {
        k = new variationalKernelTemplate<D, true>();
    }
    else
    {
        k = new variationalKernelTemplate<D, false>();
    }
    return autoPtr<variationalKernel>(k);
}

} // End namespace Foam


// ************************************************************************* //
