/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The passes of the variational scheme over the edges that compute little, the
    gradient and its transpose: rows of nodes are added directly. Passes that
    compute more handle nLanes edges together: variationalCorrections.C and
    variationalFluxes.C.

\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "edgeBlocks.H"
#include "edgeRows.H"
#include "variationalEdge.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

namespace Foam
{

template<int D, bool finite>
label variationalKernelTemplate<D, finite>::earlyGradients(const edgePass& pass)
{
    constexpr label p = earlyEdges::gradients;
    const earlyEdges& early = x_.early;
    const label* edge = d_.dual.edgeNodes().cdata();
    scalar* grad = x_.grad.data();

    // The sums of the first node, in registers until another node is first. In
    // 2D both columns are one row, and twice the sum, as in gradientLoop()
    constexpr int w = D == 2 ? 8 : sA;
    constexpr int nC = D == 2 ? 1 : D;
    const scalar half = D == 2 ? 1 : 0.5;
    const auto U = [&](const index a)
    {
        if constexpr (D == 2) return twiceAt(x_.U.cdata() + a*sU + atU);
        else return rowAt<sA>(x_.U.cdata() + a*sU);
    };
    const auto sumAt = [&](const index a, const int j) -> auto&
    {
        return rowAt<w>(grad + a*D*sA + j*w);
    };
    index node = -1;
    row<w> Ua{}, sums[nC] = {};
    const auto keep = [&]()
    {
        if (node < 0) return;
        for (int j = 0; j < nC; ++j) sumAt(node, j) = sums[j];
    };
    const auto add = [&]
    (
        const index a, const index b, const scalar* C, const int stride,
        const scalar toA, const scalar toB
    )
    {
        if (a != node)
        {
            keep();
            node = a;
            Ua = U(a);
            for (int j = 0; j < nC; ++j) sums[j] = sumAt(a, j);
        }
        const row<w> change = U(b) - Ua;
        for (int j = 0; j < nC; ++j)
        {
            row<w> by;
            if constexpr (D == 2) by = change*halves(C[0], C[stride]);
            else by = change*C[j*stride];
            sums[j] += toA*by;
            sumAt(b, j) += toB*by;
        }
    };

    for (const index a : early.reached(p)) zeroAt<sA*D>(grad + a*D*sA);
    for (const index pair : early.pairs())
    {
        const label* ends = x_.pairNodes.cdata() + 2*pair;
        const scalar* B = x_.pairArea.cdata() + D*pair;
        add(ends[0], ends[1], B, 1, 2*half, -2*half);
    }
    edgeBlocks block(d_.dual, x_.toMeet, pass, &early, p);
    for (; block.valid(); ++block)
    {
        block.soon([&](const index b)
        {
            prefetch<sU>(x_.U.cdata() + b*sU);
            prefetch<sA*D>(grad + b*D*sA);
        });
        const index first = block.first();
        for (index e = first; e < first + block.size(); ++e)
        {
            const scalar* C = variationalLayout::ofEdge<D>(x_.area, e);
            add(edge[2*e], edge[2*e + 1], C, nLanes, half, half);
        }
    }
    keep();

    const auto divide = [&](const index a)
    {
        const scalar factor = D == 2 ? 0.5*x_.perV[a] : x_.perV[a];
        for (int j = 0; j < nC; ++j) sumAt(a, j) *= factor;
    };
    label nBad = 0;
    for (const index a : x_.lateNodes)
    {
        if (early.completes(p, a)) divide(a);
    }
    for (const index a : early.nodes(p))
    {
        divide(a);
        nBad += !deformNode(a);
    }
    return nBad;
}


template<int D, bool finite>
template<bool leavesOut>
label variationalKernelTemplate<D, finite>::gradientLoop(edgePass& pass)
{
    const label* edge = d_.dual.edgeNodes().cdata();
    const scalar* U = x_.U.cdata();
    const label nEdges = d_.dual.nEdges();
    const label nPairs = x_.pairNodes.size()/2;
    scalar* grad = x_.grad.data();
    constexpr label p = earlyEdges::gradients;
    const earlyEdges& early = x_.early;

    // Edges and pairs are sorted by their first node: a node is complete after
    // the last edge and pair that start there
    index e = pass.edge, pair = pass.pair, met = pass.met;
    const index start = pass.complete;
    const index end = edgeBlocks::nodesBefore(d_.dual, pass.end);
    completeNodes complete(x_.lateNodes, pass);
    label nBad = 0;
    const auto completeBefore = [&](const label end)
    {
        complete.before(end, [&](const index a)
        {
            if (leavesOut && early.completes(p, a)) return;
            nBad += !deformNode(a);
        });
    };
    const auto meet = [&](const index end)
    {
        for (; met < end; ++met)
        {
            prefetch<sU>(U + met*sU);
            if (leavesOut && early.reaches(p, met)) continue;
            zeroAt<sA*D>(grad + met*D*sA);
        }
    };
    const auto leave = [&]()
    {
        pass.edge = e;
        pass.pair = pair;
        pass.met = met;
    };
    // Leaves out a node that is complete early: its edges and pairs are done
    const auto passedBy = [&](const index a)
    {
        if (!leavesOut || !early.completes(p, a)) return false;
        while (pair < nPairs && x_.pairNodes[2*pair] == a) ++pair;
        while (e < nEdges && edge[2*e] == a) ++e;
        return true;
    };
    if constexpr (D == 2)
    {
        // One row has both columns, doubled until the node is complete
        const auto twice = [&](const index a)
        {
            return twiceAt(U + a*sU + atU);
        };
        label nextLate = pass.late;
        const label nLate = x_.lateNodes.size();
        for (index a = start; a < end; ++a)
        {
            meet(e < nEdges ? x_.toMeet[e/nLanes] : d_.nNodes());
            const bool late = nextLate < nLate && x_.lateNodes[nextLate] == a;
            nextLate += late;
            if (passedBy(a)) continue;
            const row<8> Ua = twice(a);
            row<8> sum = rowAt<8>(grad + a*8);
            for (; pair < nPairs && x_.pairNodes[2*pair] == a; ++pair)
            {
                const index b = x_.pairNodes[2*pair + 1];
                if (leavesOut && early.completes(p, b)) continue;
                const scalar* B = x_.pairArea.cdata() + D*pair;
                meet(b + 1);
                const row<8> change = (twice(b) - Ua)*halves(2*B[0], 2*B[1]);
                sum += change;
                rowAt<8>(grad + b*8) -= change;
            }
            for (; e < nEdges && edge[2*e] == a; ++e)
            {
                if (leavesOut && early.hasEdge(p, e)) continue;
                const index b = edge[2*e + 1];
                meet(b + 1);
                const scalar* C = variationalLayout::ofEdge<D>(x_.area, e);
                const row<8> change = (twice(b) - Ua)*halves(C[0], C[nLanes]);
                sum += change;
                rowAt<8>(grad + b*8) += change;
            }
            sum *= 0.5*x_.perV[a];
            if (late)
            {
                rowAt<8>(grad + a*8) = sum;
            }
            else if constexpr (finite)
            {
                nBad += !deformRow(a, sum);
            }
            else
            {
                rowAt<8>(grad + a*8) = sum;
            }
        }
        pass.late = nextLate;
        pass.complete = end;
        leave();
        return nBad;
    }
    for (index a = start; a < end; ++a)
    {
        meet(e < nEdges ? x_.toMeet[e/nLanes] : d_.nNodes());
        if (passedBy(a)) continue;
        scalar* ga = grad + a*D*sA;
        const row<sA> Ua = rowAt<sA>(U + a*sU);
        for (; pair < nPairs && x_.pairNodes[2*pair] == a; ++pair)
        {
            const index b = x_.pairNodes[2*pair + 1];
            if (leavesOut && early.completes(p, b)) continue;
            const scalar* B = x_.pairArea.cdata() + D*pair;
            meet(b + 1);
            const row<sA> change = rowAt<sA>(U + b*sU) - Ua;
            for (int j = 0; j < D; ++j)
            {
                rowAt<sA>(ga + j*sA) += change*B[j];
                rowAt<sA>(grad + (b*D + j)*sA) -= change*B[j];
            }
        }

        row<sA> sumA[D];
        for (int j = 0; j < D; ++j) sumA[j] = rowAt<sA>(ga + j*sA);
        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            if (leavesOut && early.hasEdge(p, e)) continue;
            const index b = edge[2*e + 1];
            meet(b + 1);
            scalar* gb = grad + b*D*sA;
            const scalar* C = variationalLayout::ofEdge<D>(x_.area, e);
            const row<sA> half = 0.5*(rowAt<sA>(U + b*sU) - Ua);
            for (int j = 0; j < D; ++j)
            {
                sumA[j] += half*C[j*nLanes];
                rowAt<sA>(gb + j*sA) += half*C[j*nLanes];
            }
        }

        const scalar perV = x_.perV[a];
        for (int j = 0; j < D; ++j) rowAt<sA>(ga + j*sA) = sumA[j]*perV;
        if (a % nLanes == nLanes - 1) completeBefore(a + 1);
    }
    completeBefore(end);
    leave();
    return nBad;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::gradients(edgePass& pass)
{
    if (pass.early) return earlyGradients(pass);
    return
        x_.early.any()
      ? gradientLoop<true>(pass)
      : gradientLoop<false>(pass);
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::forces(edgePass& pass)
{
    const label* edge = d_.dual.edgeNodes().cdata();
    const scalar* T = x_.adjoint.cdata();
    const label nEdges = d_.dual.nEdges();
    scalar* rates = d_.rates.data();

    // A column of T, and the resulting rates; in 1D without the rest of the row
    constexpr int w = 2*second;

    const label nPairs = x_.pairNodes.size()/2;
    const index start = pass.complete;
    const index end = edgeBlocks::nodesBefore(d_.dual, pass.end);
    label& pair = pass.pair;
    for (; pair < nPairs && x_.pairNodes[2*pair] < end; ++pair)
    {
        const index a = x_.pairNodes[2*pair], b = x_.pairNodes[2*pair + 1];
        const scalar* B = x_.pairArea.cdata() + D*pair;
        row<w> f{};
        for (int j = 0; j < D; ++j)
        {
            f +=
                B[j]
               *(rowAt<w>(T + (a*D + j)*sA) - rowAt<w>(T + (b*D + j)*sA));
        }
        rowAt<w>(rates + a*sR) += f;
        rowAt<w>(rates + b*sR) -= f;
    }

    index e = pass.edge, farthest = pass.met - 1;
    const auto leave = [&]()
    {
        pass.edge = e;
        pass.met = farthest + 1;
        pass.complete = end;
    };

    if constexpr (D == 2)
    {
        // One row has both columns
        for (index a = start; a < end; ++a)
        {
            const row<8> Ta = rowAt<8>(T + a*8);
            row<8> both{};
            for (; e < nEdges && edge[2*e] == a; ++e)
            {
                const index soon =
                    edge[2*min(e + prefetchDistance, index(nEdges - 1)) + 1];
                if (soon > farthest)
                {
                    farthest = soon;
                    prefetch<8>(T + soon*8);
                    prefetch<sR>(rates + soon*sR);
                }
                const index b = edge[2*e + 1];
                const scalar* C = variationalLayout::ofEdge<D>(x_.area, e);
                const row<8> f =
                    (Ta + rowAt<8>(T + b*8))*halves(C[0], C[nLanes]);
                both += f;
                rowAt<4>(rates + b*sR) -= 0.5*(lower(f) + upper(f));
            }
            scalar* rate = rates + a*sR;
            const row<4> sum =
                x_.perV[a]
               *(rowAt<4>(rate) + 0.5*(lower(both) + upper(both)));
            rowAt<4>(rate) =
                row<4>{sum[0] + sum[2], sum[1] + sum[3], sum[2], sum[3]};
        }
        leave();
        return;
    }
    for (index a = start; a < end; ++a)
    {
        row<w> Ta[D], sum = rowAt<w>(rates + a*sR);
        for (int j = 0; j < D; ++j) Ta[j] = rowAt<w>(T + (a*D + j)*sA);
        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            const index soon =
                edge[2*min(e + prefetchDistance, index(nEdges - 1)) + 1];
            if (soon > farthest)
            {
                farthest = soon;
                prefetch<sA*D>(T + soon*D*sA);
                prefetch<sR>(rates + soon*sR);
            }
            const index b = edge[2*e + 1];
            const scalar* C = variationalLayout::ofEdge<D>(x_.area, e);
            row<w> f{};
            for (int j = 0; j < D; ++j)
            {
                f += (0.5*C[j*nLanes])*(Ta[j] + rowAt<w>(T + (b*D + j)*sA));
            }
            sum += f;
            rowAt<w>(rates + b*sR) -= f;
        }

        // All edges of this node are done. The whole rate includes the
        // dissipation's
        sum *= x_.perV[a];
        scalar* rate = rates + a*sR;
        rowAt<w>(rate) = sum;
        for (int i = 0; i < D; ++i) rate[i] = sum[i] + sum[second + i];
    }
    leave();
}

} // End namespace Foam


// ************************************************************************* //
