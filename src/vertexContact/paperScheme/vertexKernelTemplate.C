/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexKernelTemplate.H"
#include "vertexKernelFluxes.C"
#include <cmath>
#include <type_traits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

template<int D, int nSJ, reconstructionType R, bool finite>
inline SolidTensor<D> vertexKernelTemplate<D, nSJ, R, finite>::rateF
(
    const label a
) const
{
    SolidTensor<D> G;
    for (int i = 0; i < D; ++i)
    {
        for (int j = 0; j < D; ++j)
        {
            G(i, j) =
                full
              ? d_.rates[a*sRates + atRateF + i*D + j]
              : d_.grad[a*sG*D + atGrad(i, j)];
        }
    }
    G.out = 0;
    return G;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int D, int nSJ, reconstructionType R, bool finite>
void vertexKernelTemplate<D, nSJ, R, finite>::velocities()
{
    const label n = d_.nNodes();
    const scalar perRho = 1/d_.rho;
    const scalar* lm = d_.state.lm.cdata();
    scalar* W = d_.W.data();

    for (label a = 0; a < n; ++a)
    {
        for (int i = 0; i < D; ++i) W[a*sW + i] = perRho*lm[a*D + i];
    }

    if constexpr (finite && D == 3)
    {
        if (!d_.state.solvesH)
        {
            scalar* H = d_.state.H.data();
            for (label a = 0; a < n; ++a)
            {
                const SolidTensor<3> G =
                    cofactor(loadF<3>(d_.state.F.cdata(), a));
                for (int k = 0; k < 9; ++k) H[9*a + placeH(k)] = G.in[k];
            }
        }
    }
}


template<int D, int nSJ, reconstructionType R, bool finite>
void vertexKernelTemplate<D, nSJ, R, finite>::gradients()
{
    constexpr int w = strideWidth(sG);
    const label* edge = d_.dual.edgeNodes().cdata();
    const scalar* area = d_.edgeArea();
    const scalar* V = d_.dual.nodeVolume().cdata();
    const scalar* W = d_.W.cdata();
    const label nEdges = d_.dual.nEdges();

    d_.grad = Zero;
    scalar* grad = d_.grad.data();

    // Edges are sorted by their first node: a node is complete after the last
    // edge that starts there
    label e = 0, farthest = -1;
    for (label a = 0; a < d_.nNodes(); ++a)
    {
        scalar* ga = grad + a*sG*D;
        row<w> Wa[sG/w], sumA[D*sG/w];
        for (int k = 0; k < sG/w; ++k) Wa[k] = rowAt<w>(W + a*sW + k*w);
        for (int k = 0; k < D*sG/w; ++k) sumA[k] = rowAt<w>(ga + k*w);

        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            const label soon =
                edge[2*min(e + prefetchDistance, nEdges - 1) + 1];
            if (soon > farthest)
            {
                farthest = soon;
                prefetch<nG>(W + soon*sW);
                prefetch<sG*D>(grad + soon*sG*D);
            }

            const label b = edge[2*e + 1];
            scalar* gb = grad + b*sG*D;
            for (int k = 0; k < sG/w; ++k)
            {
                const row<w> average =
                    0.5*(Wa[k] + rowAt<w>(W + b*sW + k*w));
                for (int j = 0; j < D; ++j)
                {
                    const row<w> f = average*area[D*e + j];
                    sumA[j*sG/w + k] += f;
                    rowAt<w>(gb + j*sG + k*w) -= f;
                }
            }
        }

        const scalar perV = 1/V[a];
        for (int k = 0; k < D*sG/w; ++k) rowAt<w>(ga + k*w) = sumA[k]*perV;
    }
}


template<int D, int nSJ, reconstructionType R, bool finite>
void vertexKernelTemplate<D, nSJ, R, finite>::addBoundaryGradients
(
    const dualPatch& patch,
    const cornerStates* c
)
{
    const FixedList<label, 3>& dir = d_.dual.directions();
    const scalar* V = d_.dual.nodeVolume().cdata();
    const scalar* W = d_.W.cdata();
    scalar* grad = d_.grad.data();
    constexpr int wide = strideWidth(sG);
    alignas(64) scalar values[4][sG];

    patch.forFaces([&](const dualPatch::face& f)
    {
        const label start = f.start, nf = f.size;
        const scalar* w = patch.weightVectors.cdata() + D*f.firstWeight;

        // Values at the corners: velocity fluxes, nodal stresses
        for (label j = 0; j < nf; ++j)
        {
            const label b = patch.cornerNode[start + j];
            scalar* u = values[j];
            for (int k = 0; k < sG; k += wide)
            {
                rowAt<wide>(u + k) = rowAt<wide>(W + b*sW + k);
            }
            if (c)
            {
                for (int i = 0; i < D; ++i) u[i] = c->vB[start + j][dir[i]];
            }
        }

        for (label p = 0; p < nf; ++p)
        {
            const label a = patch.cornerNode[start + p];
            const scalar perV = 1/V[a];
            scalar* g = grad + label(sG)*D*a;
            for (label j = 0; j < nf; ++j)
            {
                const scalar* wpj = w + D*(p*nf + j);
                for (int k = 0; k < sG; k += wide)
                {
                    const row<wide> u = rowAt<wide>(values[j] + k);
                    for (int i = 0; i < D; ++i)
                    {
                        rowAt<wide>(g + i*sG + k) += u*(perV*wpj[i]);
                    }
                }
            }
        }
    });
}


template<int D, int nSJ, reconstructionType R, bool finite>
void vertexKernelTemplate<D, nSJ, R, finite>::fluxes(const bool energy)
{
    d_.rates = Zero;

    const auto run = [&](auto limiter)
    {
        constexpr auto type = decltype(limiter)::value;
        energy ? fluxLoop<type, true>() : fluxLoop<type, false>();
    };

    if constexpr (none)
    {
        run(std::integral_constant<limiterType, limiterType::none>());
    }
    else
    {
        slopeLimiter::withLimiter(d_.limiter, run);
    }
}


template<int D, int nSJ, reconstructionType R, bool finite>
scalar vertexKernelTemplate<D, nSJ, R, finite>::addBoundaryFluxes
(
    const dualPatch& patch,
    const cornerStates* c,
    const bool energy
)
{
    return
        energy
      ? boundaryFluxLoop<true>(patch, c)
      : boundaryFluxLoop<false>(patch, c);
}


template<int D, int nSJ, reconstructionType R, bool finite>
template<bool energy>
scalar vertexKernelTemplate<D, nSJ, R, finite>::boundaryFluxLoop
(
    const dualPatch& patch,
    const cornerStates* c
)
{
    if (!c && !full && !energy) return 0;

    const FixedList<label, 3>& dir = d_.dual.directions();
    const scalar* V = d_.dual.nodeVolume().cdata();
    const scalar* W = d_.W.cdata();
    scalar* rates = d_.rates.data();
    scalar power = 0, storage = 0;

    patch.forFaces([&](const dualPatch::face& f)
    {
        const label start = f.start, nf = f.size;
        const scalar* s = patch.weights.cdata() + f.firstWeight;
        const scalar* w = patch.weightVectors.cdata() + D*f.firstWeight;

        for (label p = 0; p < nf; ++p)
        {
            const label a = patch.cornerNode[start + p];
            const scalar* Wa = W + a*sW;

            SolidVector<D> force, vP;
            scalar L[nP];
            for (int i = 0; i < D; ++i) force[i] = vP[i] = 0;
            for (int k = 0; k < nP; ++k) L[k] = 0;

            for (label j = 0; j < nf; ++j)
            {
                const label b = patch.cornerNode[start + j];
                for (int i = 0; i < D; ++i)
                {
                    const scalar vBj =
                        c ? c->vB[start + j][dir[i]] : W[b*sW + i];
                    if (c) force[i] += s[p*nf + j]*c->tB[start + j][dir[i]];
                    if constexpr (full || energy)
                    {
                        for (int k = 0; k < D; ++k)
                        {
                            L[i*D + k] += vBj*w[D*(p*nf + j) + k];
                        }
                    }
                    if (j == p) vP[i] = vBj;
                }
            }

            const scalar perV = 1/V[a];
            for (int i = 0; i < D; ++i) rates[a*sRates + i] += perV*force[i];
            if constexpr (full)
            {
                for (int k = 0; k < nP; ++k)
                {
                    rates[a*sRates + atRateF + k] += perV*L[k];
                }
            }

            if constexpr (energy)
            {
                // Energy that the corner's fluxes store in the node, without
                // the telescoping part of the edges, and power that enters:
                // the difference is dissipated
                for (int i = 0; i < D; ++i)
                {
                    power += vP[i]*force[i];
                    storage += Wa[i]*force[i];
                    for (int k = 0; k < D; ++k)
                    {
                        scalar areaK = 0;
                        for (label j = 0; j < nf; ++j)
                        {
                            areaK += w[D*(p*nf + j) + k];
                        }
                        storage +=
                            Wa[atP_(i, k)]*(L[i*D + k] - Wa[i]*areaK);
                    }
                }
            }
        }
    });

    d_.numericalDissipation += power - storage;
    return power;
}


template<int D, int nSJ, reconstructionType R, bool finite>
label vertexKernelTemplate<D, nSJ, R, finite>::advance
(
    const scalar deltaT,
    const scalar oldWeight,
    const updatedPart part
)
{
    // H is stored where it is solved (2D: the out-of-plane component)
    constexpr bool mayH = finite && D > 1;
    const auto go = [&](auto solvesH)
    {
        constexpr bool H = decltype(solvesH)::value;
        return
            part == updatedPart::kinematics
          ? advanceNodes<true, updatedPart::kinematics, H>(deltaT, 0)
          : oldWeight == 0
          ? advanceNodes<true, updatedPart::all, H>(deltaT, 0)
          : advanceNodes<false, updatedPart::all, H>(deltaT, oldWeight);
    };
    return
        part == updatedPart::momentum
      ? advanceNodes<true, updatedPart::momentum, false>(deltaT, 0)
      : mayH && d_.state.solvesH
      ? go(std::integral_constant<bool, mayH>())
      : go(std::false_type());
}


template<int D, int nSJ, reconstructionType R, bool finite>
template<bool first, updatedPart part, bool solvesH>
label vertexKernelTemplate<D, nSJ, R, finite>::advanceNodes
(
    const scalar deltaT,
    const scalar oldWeight
)
{
    constexpr bool momentum = (part != updatedPart::kinematics);
    constexpr bool kinematics = (part != updatedPart::momentum);
    const label n = d_.nNodes();
    const scalar* W = d_.W.cdata();
    conservedState& s = d_.state;
    conservedState& o = d_.old;
    const conservedState& next = first ? o : s;
    const scalar weight = 1 - oldWeight;
    label nBad = 0;

    // u + dt r. The first stage writes it over the old u, which then changes
    // places with u; later stages average it with the old u
    const auto update = [=]
    (
        auto count,
        scalar* __restrict u,
        scalar* __restrict uOther,
        const scalar* __restrict rate
    )
    {
        constexpr int m = decltype(count)::value;
        scalar now[m];
        for (int k = 0; k < m; ++k) now[k] = u[k] + deltaT*rate[k];
        if constexpr (first)
        {
            for (int k = 0; k < m; ++k) uOther[k] = now[k];
        }
        else
        {
            for (int k = 0; k < m; ++k)
            {
                u[k] = oldWeight*uOther[k] + weight*now[k];
            }
        }
    };
    using one = std::integral_constant<int, 1>;
    using vectorSize = std::integral_constant<int, D>;
    using tensorSize = std::integral_constant<int, nP>;

    for (label a = 0; a < n; ++a)
    {
        const scalar* rates = d_.rates.cdata() + a*sRates;

        if constexpr (kinematics)
        {
            const SolidTensor<D> G = rateF(a);
            if constexpr (finite)
            {
                const SolidTensor<D> F = loadF<D>(s.F.cdata(), a);
                if constexpr (nSJ == 1)
                {
                    const SolidTensor<D> H = loadH<D>
                    (
                        F, s.strideH ? s.H.cdata() : nullptr, a
                    );
                    const scalar rateJ = ddot(H, G) + rates[D];    // (63c)
                    update(one(), &s.J[a], &o.J[a], &rateJ);
                }
                if constexpr (solvesH)
                {
                    const SolidTensor<D> rateH = cross(F, G);     // (63b)
                    if constexpr (D == 2)
                    {
                        update(one(), &s.H[a], &o.H[a], &rateH.out);
                    }
                    else
                    {
                        scalar columns[9];
                        for (int k = 0; k < 9; ++k)
                        {
                            columns[placeH(k)] = rateH.in[k];
                        }
                        update(tensorSize(), &s.H[9*a], &o.H[9*a], columns);
                    }
                }
            }

            update(tensorSize(), &s.F[a*nP], &o.F[a*nP], G.in);   // (63a)
            update
            (
                vectorSize(), &s.disp[a*D], &o.disp[a*D], W + a*sW // (66)
            );
        }
        if constexpr (momentum)
        {
            update(vectorSize(), &s.lm[a*D], &o.lm[a*D], rates);  // (62a)
        }

        // Check that the state can be continued
        bool good = true;
        if constexpr (momentum)
        {
            for (int i = 0; i < D; ++i)
            {
                good = good && std::isfinite(next.lm[a*D + i]);
            }
        }
        if constexpr (kinematics && finite)
        {
            const scalar detF = determinant(loadF<D>(next.F.cdata(), a));
            good = good && detF > 0;
            if constexpr (nSJ == 1) good = good && next.J[a] > 0;
        }
        else if constexpr (kinematics)
        {
            for (int k = 0; k < nP; ++k)
            {
                good = good && mag(next.F[a*nP + k]) < largestLinearF;
            }
        }
        if (!good) ++nBad;
    }

    if constexpr (first)
    {
        if (momentum) s.exchangeMomentum(o);
        if (kinematics) s.exchangeKinematics(o);
    }
    return nBad;
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

template<int D, int nSJ, bool finite>
autoPtr<vertexKernel> newVertexKernelOf(vertexData& d)
{
    using kind = reconstructionType;
    vertexKernel* k = nullptr;
    switch (d.reconstruction)
    {
        case kind::none:
            k = new vertexKernelTemplate<D, nSJ, kind::none, finite>(d);
            break;
        case kind::linear:
            k = new vertexKernelTemplate<D, nSJ, kind::linear, finite>(d);
            break;
        case kind::full:
            k = new vertexKernelTemplate<D, nSJ, kind::full, finite>(d);
            break;
    }
    return autoPtr<vertexKernel>(k);
}


template<int D>
autoPtr<vertexKernel> newVertexKernel(vertexData& d)
{
    return
        !d.finiteStrain ? newVertexKernelOf<D, 0, false>(d)
      : d.nSJ ? newVertexKernelOf<D, 1, true>(d)
      : newVertexKernelOf<D, 0, true>(d);
}

} // End namespace Foam


// ************************************************************************* //
