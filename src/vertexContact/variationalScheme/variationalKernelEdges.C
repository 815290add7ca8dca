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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

//- Gradients from edges and pairs: the sums of their first node, in registers
//  until another node is first. In 2D both columns are one row, doubled until
//  the node is complete
template<int D, bool finite>
class variationalKernelTemplate<D, finite>::gradientSums
{
    static constexpr int w = D == 2 ? 8 : sA;
    static constexpr int nC = D == 2 ? 1 : D;

    // Private data

        const scalar* U_;
        scalar* grad_;
        const scalar* perV_;

        index node_ = -1;
        row<w> Ua_{};
        row<w> sums_[nC] = {};


    // Private Member Functions

        row<w> U(const index a) const
        {
            if constexpr (D == 2) return twiceAt(U_ + a*sU + atU);
            else return rowAt<w>(U_ + a*sU);
        }

        row<w>& at(const index a, const int j) const
        {
            return rowAt<w>(grad_ + a*D*sA + j*w);
        }


public:

    explicit gradientSums(variationalData& x)
    :
        U_(x.U.cdata()),
        grad_(x.grad.data()),
        perV_(x.perV.cdata())
    {}

    //- Set the initial sums of a node
    void begin(const index a) const { zeroAt<sA*D>(grad_ + a*D*sA); }

    //- Prefetch a node that edges will reach
    void fetch(const index a) const { prefetch<sU>(U_ + a*sU); }
    void fetchSums(const index a) const { prefetch<sA*D>(grad_ + a*D*sA); }

    //- Both columns of the first node in 2D
    const row<w>& both() const { return sums_[0]; }

    //- Write the sums
    __attribute__((always_inline))
    inline void keep() const
    {
        if (node_ < 0) return;
        for (int j = 0; j < nC; ++j) at(node_, j) = sums_[j];
    }

    //- Start with the first node of an edge or pair, if it is another one
    __attribute__((always_inline))
    inline void comeTo(const index a)
    {
        if (a == node_) return;
        keep();
        node_ = a;
        Ua_ = U(a);
        for (int j = 0; j < nC; ++j) sums_[j] = at(a, j);
    }

    //- Add an edge or a pair from the first node to b.
    //  \param C  area of the edge, in lanes, or weight of the pair
    template<bool isPair>
    __attribute__((always_inline))
    inline void add(const index b, const scalar* C)
    {
        constexpr int stride = isPair ? 1 : nLanes;
        const row<w> change =
            ((isPair ? 2 : 1)*(D == 2 ? 1 : 0.5))*(U(b) - Ua_);
        for (int j = 0; j < nC; ++j)
        {
            row<w> by;
            if constexpr (D == 2) by = change*halves(C[0], C[stride]);
            else by = change*C[j*stride];
            sums_[j] += by;
            if constexpr (isPair) at(b, j) -= by;
            else at(b, j) += by;
        }
    }

    //- Complete and write the gradient of the first node
    __attribute__((always_inline))
    inline void complete()
    {
        const scalar factor = D == 2 ? 0.5*perV_[node_] : perV_[node_];
        for (int j = 0; j < nC; ++j) at(node_, j) = sums_[j] *= factor;
        node_ = -1;
    }
};


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::earlyGradients(const edgePass& pass)
{
    constexpr label p = earlyEdges::gradients;
    const earlyEdges& early = x_.early;
    const label* edge = d_.dual.edgeNodes().cdata();
    gradientSums sums(x_);

    for (const index a : early.reached(p)) sums.begin(a);
    for (const index pair : early.pairs())
    {
        sums.comeTo(x_.pairNodes[2*pair]);
        sums.template add<true>
        (
            x_.pairNodes[2*pair + 1], x_.pairArea.cdata() + D*pair
        );
    }
    edgeBlocks block(d_.dual, x_.toMeet, pass, &early, p);
    for (; block.valid(); ++block)
    {
        block.soon([&](const index b)
        {
            sums.fetch(b);
            sums.fetchSums(b);
        });
        const index first = block.first();
        for (index e = first; e < first + block.size(); ++e)
        {
            sums.comeTo(edge[2*e]);
            sums.template add<false>
            (
                edge[2*e + 1], variationalLayout::ofEdge<D>(x_.area, e)
            );
        }
    }

    const auto complete = [&](const index a)
    {
        sums.comeTo(a);
        sums.complete();
    };
    label nBad = 0;
    for (const index a : x_.lateNodes)
    {
        if (early.completes(p, a)) complete(a);
    }
    for (const index a : early.nodes(p))
    {
        complete(a);
        nBad += !deformNode(a);
    }
    sums.keep();
    return nBad;
}


template<int D, bool finite>
template<bool leavesOut>
label variationalKernelTemplate<D, finite>::gradientLoop(edgePass& pass)
{
    constexpr label p = earlyEdges::gradients;
    const earlyEdges& early = x_.early;
    const label* edge = d_.dual.edgeNodes().cdata();
    const label nEdges = d_.dual.nEdges();
    const label nPairs = x_.pairNodes.size()/2;
    gradientSums sums(x_);

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
            // In 2D it is the last one, with its columns still in registers
            if constexpr (D == 2 && finite) nBad += !deformRow(a, sums.both());
            else nBad += !deformNode(a);
        });
    };
    const auto meet = [&](const index end)
    {
        for (; met < end; ++met)
        {
            sums.fetch(met);
            if (!leavesOut || !early.reaches(p, met)) sums.begin(met);
        }
    };
    for (index a = start; a < end; ++a)
    {
        meet(e < nEdges ? x_.toMeet[e/nLanes] : d_.nNodes());
        if (leavesOut && early.completes(p, a))
        {
            // Its edges and pairs are done
            while (pair < nPairs && x_.pairNodes[2*pair] == a) ++pair;
            while (e < nEdges && edge[2*e] == a) ++e;
            continue;
        }
        sums.comeTo(a);
        for (; pair < nPairs && x_.pairNodes[2*pair] == a; ++pair)
        {
            const index b = x_.pairNodes[2*pair + 1];
            if (leavesOut && early.completes(p, b)) continue;
            meet(b + 1);
            sums.template add<true>(b, x_.pairArea.cdata() + D*pair);
        }
        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            if (leavesOut && early.hasEdge(p, e)) continue;
            const index b = edge[2*e + 1];
            meet(b + 1);
            sums.template add<false>
            (
                b, variationalLayout::ofEdge<D>(x_.area, e)
            );
        }
        sums.complete();
        if (D == 2 || a % nLanes == nLanes - 1) completeBefore(a + 1);
    }
    completeBefore(end);
    pass.edge = e;
    pass.pair = pair;
    pass.met = met;
    return nBad;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
