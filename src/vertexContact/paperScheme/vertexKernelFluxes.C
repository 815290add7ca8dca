/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The pass over the edges that sums the fluxes, for nLanes edges at a time.
    Components of a node that are contiguous in memory are loaded, and combined
    for an edge, as rows. The rows of the edges are transposed to lanes. The
    fluxes are transposed back and added to the nodes as rows, one edge after
    the other.

\*---------------------------------------------------------------------------*/

#include "vertexKernelTemplate.H"
#include "edgeRows.H"
#include "paperEdge.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

template<int D, int nSJ, reconstructionType R, bool finite>
template<limiterType limiter, bool energy>
void vertexKernelTemplate<D, nSJ, R, finite>::fluxLoop()
{
    typedef std::ptrdiff_t index;

    const label* edge = d_.dual.edgeNodes().cdata();
    const scalar* edgeArea = d_.edgeArea();
    const scalar* X = d_.dual.nodePosition().cdata();
    const scalar* V = d_.dual.nodeVolume().cdata();
    const scalar* W = d_.W.cdata();
    const scalar* grad = d_.grad.cdata();
    const scalar* F = d_.state.F.cdata();
    const scalar* H = d_.state.H.cdata();
    const scalar* factor =
        d_.waveFactor.size() ? d_.waveFactor.cdata() : nullptr;
    scalar* rates = d_.rates.data();

    const label nEdges = d_.dual.nEdges();
    const scalar halfZp = 0.5*d_.dissipation*d_.rho*d_.cp;
    const scalar halfZs = 0.5*d_.dissipation*d_.rho*d_.cs;
    const scalar perZp = 0.5/(d_.rho*d_.cp);
    scalar dissipation = 0;

    // Row widths: components of v and SigmaJ, of a column, of gradients
    constexpr int wU = rowWidth(D + nSJ);
    constexpr int wC = rowWidth(D);
    constexpr int wG = strideWidth(sG);
    constexpr int nU = paddedStride(D + nSJ);
    constexpr int nC = paddedStride(D);

    // Places of the data of an edge: area; twice the deformed area (2D: sum of
    // F); difference and sum of v and SigmaJ, and of the tractions (the sum is
    // twice the average); twice the changes of both nodes to mid-edge
    constexpr bool moves = finite && D > 1;
    constexpr int atArea = 0;
    constexpr int atDifference = atArea + nC;
    constexpr int atT = atDifference + nU;
    constexpr int atDeformed = atT + nC;
    constexpr int atSum = atDeformed + (moves ? 4 : 0);
    constexpr int atTDifference = atSum + (full ? nU : 0);
    constexpr int atChangeA = atTDifference + (full ? nC : 0);
    constexpr int atChangeB = atChangeA + (none ? 0 : sG);
    constexpr int nOfNodes = atChangeB + (none ? 0 : sG);

    edgeRows<nOfNodes> of;
    edgeRows<sRates> flux;

    // The second node gets the negative fluxes; waves are added at both nodes
    constexpr int wR = strideWidth(sRates);
    alignas(registerBytes) scalar sign[sRates];
    for (int k = 0; k < sRates; ++k) sign[k] = (k == atWave ? 1 : -1);

    // Rates of the first node. Edges are sorted by it, and edges from earlier
    // nodes came before: so a node is complete after its last edge. Then all
    // rates but the waves are divided by the volume
    row<wR> ratesA[sRates/wR] = {};
    index nodeA = -1, farthest = -1;
    alignas(registerBytes) scalar divided[sRates], undivided[sRates];
    for (int k = 0; k < sRates; ++k)
    {
        divided[k] = (k == atWave ? 0 : 1);
        undivided[k] = 1 - divided[k];
    }
    const auto load = [&](const index a)
    {
        nodeA = a;
        for (int k = 0; k < sRates; k += wR)
        {
            ratesA[k/wR] = rowAt<wR>(rates + a*sRates + k);
        }
    };
    const auto finish = [&]
    {
        const scalar perV = 1/V[nodeA];
        for (int k = 0; k < sRates; k += wR)
        {
            rowAt<wR>(rates + nodeA*sRates + k) =
                ratesA[k/wR]
               *(rowAt<wR>(divided + k)*perV + rowAt<wR>(undivided + k));
        }
    };
    const auto finishUpTo = [&](const index a)
    {
        // No edges start at the nodes in between
        while (nodeA < a)
        {
            if (nodeA >= 0) finish();
            if (nodeA + 1 == d_.nNodes()) break;
            load(nodeA + 1);
        }
    };

    // Copy of the last edges, which may be fewer than lanes
    label lastEdge[2*nLanes];
    scalar lastArea[D*nLanes + 4];

    for (label e0 = 0; e0 < nEdges; e0 += nLanes)
    {
        const int some = min(label(nLanes), nEdges - e0);
        const label* ends = edge + 2*e0;
        const scalar* areas = edgeArea + D*e0;
        if (e0 + nLanes >= nEdges)
        {
            // In the copy rows of areas can be read to their end
            for (int l = 0; l < nLanes; ++l)
            {
                const label e = min(e0 + l, nEdges - 1);
                for (int i = 0; i < 2; ++i) lastEdge[2*l + i] = edge[2*e + i];
                for (int i = 0; i < D; ++i)
                {
                    lastArea[D*l + i] = edgeArea[D*e + i];
                }
            }
            for (int i = 0; i < 4; ++i) lastArea[D*nLanes + i] = 0;
            ends = lastEdge;
            areas = lastArea;
        }

        // Prefetch nodes that edges will soon reach for the first time: they
        // are not in the cache
        const label soon = min(e0 + prefetchDistance, nEdges);
        for (label e = soon; e < min(soon + nLanes, nEdges); ++e)
        {
            const index b = edge[2*e + 1];
            if (b <= farthest) continue;
            farthest = b;
            prefetch<sW>(W + b*sW);
            if constexpr (!none) prefetch<sG*D>(grad + b*sG*D);
            if constexpr (finite && D == 3) prefetch<9>(H + 9*b);
            prefetch<sRates>(rates + b*sRates);
        }

        for (int l = 0; l < nLanes; ++l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const scalar* C = areas + D*l;
            const scalar* Wa = W + a*sW;
            const scalar* Wb = W + b*sW;
            rowWriter to(of[l]);

            to.template put<atArea, wC>(rowAt<wC>(C));
            to.template put<atDifference, wU>(rowAt<wU>(Wb) - rowAt<wU>(Wa));

            // Sums over the columns of P and of H
            row<wC> t{}, tDifference{};
            for (int j = 0; j < D; ++j)
            {
                const row<wC> Pa = rowAt<wC>(Wa + atP + j*D);
                const row<wC> Pb = rowAt<wC>(Wb + atP + j*D);
                t += (Pa + Pb)*C[j];
                if constexpr (full) tDifference += (Pb - Pa)*C[j];
            }
            to.template put<atT, wC>(t);

            if constexpr (finite && D == 3)
            {
                row<wC> c{};
                for (int j = 0; j < D; ++j)
                {
                    c +=
                        (
                            rowAt<wC>(H + 9*a + 3*j)
                          + rowAt<wC>(H + 9*b + 3*j)
                        )*C[j];
                }
                to.template put<atDeformed, wC>(c);
            }
            else if constexpr (finite && D == 2)
            {
                to.template put<atDeformed, 4>
                (
                    rowAt<4>(F + 4*a) + rowAt<4>(F + 4*b)
                );
            }

            if constexpr (full)
            {
                to.template put<atSum, wU>(rowAt<wU>(Wa) + rowAt<wU>(Wb));
                to.template put<atTDifference, wC>(tDifference);
            }

            if constexpr (!none)
            {
                // Twice the changes from both nodes to mid-edge
                scalar r[D];
                for (int j = 0; j < D; ++j) r[j] = X[b*D + j] - X[a*D + j];
                const auto change = [&](const scalar* g)
                {
                    row<wG> sum = rowAt<wG>(g)*r[0];
                    for (int j = 1; j < D; ++j) sum += rowAt<wG>(g + j*sG)*r[j];
                    return sum;
                };
                to.template putAll<atChangeA, wG, sG>(grad + a*sG*D, change);
                to.template putAll<atChangeB, wG, sG>(grad + b*sG*D, change);
            }
        }
        of.toLanes();

        paperEdge<D, nSJ, R, moves, lanes> at;
        for (int i = 0; i < D; ++i)
        {
            at.area[i] = of.lane(atArea + i);
            at.difference[i] = of.lane(atDifference + i);
            at.t[i] = 0.5*of.lane(atT + i);
            if constexpr (full)
            {
                at.vAvg[i] = 0.5*of.lane(atSum + i);
                at.tDifference[i] = of.lane(atTDifference + i);
            }
        }
        if constexpr (nSJ == 1) at.differenceSJ = of.lane(atDifference + D);
        if constexpr (moves && D == 3)
        {
            for (int i = 0; i < D; ++i) at.c[i] = 0.5*of.lane(atDeformed + i);
        }
        else if constexpr (moves)
        {
            lanes meanF[4];
            for (int k = 0; k < 4; ++k) meanF[k] = 0.5*of.lane(atDeformed + k);
            planeArea(meanF, at.area[0], at.area[1], at.c.v);
        }
        else
        {
            at.c = at.area;
        }
        at.twiceA = of.from(atChangeA);
        at.twiceB = of.from(atChangeB);
        at.isFaster = factor;
        if (factor)
        {
            for (int l = 0; l < nLanes; ++l)
            {
                at.faster[l] = max(factor[ends[2*l]], factor[ends[2*l + 1]]);
            }
        }

        at.template solve<limiter, energy>(halfZp, halfZs, perZp);

        for (int i = 0; i < D; ++i) flux.set(i, at.traction[i]);
        if constexpr (nSJ == 1) flux.set(D, at.fluxJ);
        flux.set(atWave, at.wave);
        if constexpr (full)
        {
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    flux.set
                    (
                        atRateF + i*D + j, at.velocity[i]*at.area[j]
                    );
                }
            }
        }
        if constexpr (energy)
        {
            for (int l = 0; l < some; ++l) dissipation += at.power[l];
        }

        // Add to the nodes
        constexpr int nRates = atRateF + (full ? nP : 0);
        for (int k = nRates; k < sRates; ++k) flux.set(k, lanes{});
        flux.toRows();
        for (int l = 0; l < some; ++l)
        {
            const index a = ends[2*l];
            if (a != nodeA) finishUpTo(a);
            scalar* rb = rates + index(ends[2*l + 1])*sRates;
            for (int k = 0; k < sRates; k += wR)
            {
                const row<wR> f = rowAt<wR>(flux[l] + k);
                ratesA[k/wR] += f;
                rowAt<wR>(rb + k) += rowAt<wR>(sign + k)*f;
            }
        }
    }
    finishUpTo(d_.nNodes());

    if constexpr (energy)
    {
        d_.numericalDissipation += dissipation;
    }
}

} // End namespace Foam


// ************************************************************************* //
