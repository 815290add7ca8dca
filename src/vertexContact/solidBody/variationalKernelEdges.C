/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The passes of the variational scheme over the edges. Where there is much to
    compute nLanes edges are computed together (edgeRows); where there is little
    their rows are added as they are.

\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "edgeRows.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Blocks of nLanes edges, which are sorted by their first node: their nodes,
//  of the last block with its last edge as often as it takes
class edgeBlocks
{
    const label* edge_;
    const label nEdges_;
    label first_ = 0;
    label farthest_ = -1;
    label last_[2*nLanes];


public:

    explicit edgeBlocks(const medianDual& dual)
    :
        edge_(dual.edgeNodes().cdata()),
        nEdges_(dual.nEdges())
    {}

    bool valid() const { return first_ < nEdges_; }

    void operator++() { first_ += nLanes; }

    label first() const { return first_; }

    //- Edges of this block
    int size() const { return min(label(nLanes), nEdges_ - first_); }

    //- Both nodes of each of nLanes edges
    const label* nodes()
    {
        const label* ends = edge_ + 2*first_;
        if (first_ + nLanes <= nEdges_) return ends;
        for (int l = 0; l < nLanes; ++l)
        {
            const label e = 2*min(label(l), nEdges_ - first_ - 1);
            last_[2*l] = ends[e];
            last_[2*l + 1] = ends[e + 1];
        }
        return last_;
    }

    //- Call f with the nodes that edges come to soon, and for the first time:
    //  they are not in the cache
    template<class Function>
    void ahead(const Function& f)
    {
        const label soon = min(first_ + prefetchDistance, nEdges_);
        const label end = min(soon + nLanes, nEdges_);
        for (label e = soon; e < end; ++e)
        {
            const label b = edge_[2*e + 1];
            if (b > farthest_)
            {
                farthest_ = b;
                f(std::ptrdiff_t(b));
            }
        }
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Classes  * * * * * * * * * * * * //

//- What nLanes edges have of the motion of their nodes, b less a: displacement,
//  velocity, position; with the derivatives of both, G applied to the edge.
//  In 3D G is applied edge by edge, and rows of the edges are kept; else lanes
//  of derivatives, of which d of them are a column.
//  \tparam differs  the difference G_a - G_b of the displacement's, else the
//                   sum; always the sum of L
template<int D, bool finite>
template<bool differs>
class Foam::variationalKernelTemplate<D, finite>::edgeLanes
{
    lanes U_[D == 3 ? 16 : 8];
    lanes G_[8];

    //- In 3D: rows of U, b less a
    scalar rows_[D == 3 ? nLanes : 1][16];


public:

    void load
    (
        const scalar* U,
        const scalar* grad,
        const label* ends,
        const row<4>* extra
    );

    lanes disp(const int i) const { return U_[i]; }
    lanes velocity(const int i) const { return U_[D + i]; }
    lanes r(const int i) const { return U_[2*D + i]; }
    lanes acceleration(const int i) const { return U_[3*D + i]; }

    //- The edge as it is now
    lanes dx(const int i) const
    {
        return finite ? r(i) + disp(i) : r(i);
    }

    //- G r of the displacement: of the difference, or of the sum
    lanes Gr(const int i) const
    {
        if constexpr (D == 3)
        {
            return G_[i];
        }
        else
        {
            lanes sum = G_[i]*r(0);
            for (int j = 1; j < D; ++j) sum += G_[4*j + i]*r(j);
            return sum;
        }
    }

    //- Of the sum of L the change over the edge
    lanes Ldx(const int i) const
    {
        if constexpr (D == 3)
        {
            return G_[D + i];
        }
        else
        {
            lanes sum = G_[D + i]*dx(0);
            for (int j = 1; j < D; ++j) sum += G_[4*j + D + i]*dx(j);
            return sum;
        }
    }

    //- In 3D, lanes 12 to 15
    lanes extra(const int k) const { return U_[12 + k]; }

    //- In 3D: components of U, b less a, of an edge
    const scalar* row(const int l) const { return rows_[l]; }
};


template<int D, bool finite>
template<bool differs>
__attribute__((always_inline))
inline void
Foam::variationalKernelTemplate<D, finite>::edgeLanes<differs>::load
(
    const scalar* U,
    const scalar* grad,
    const label* ends,
    const Foam::row<4>* extra
)
{
    typedef std::ptrdiff_t index;
    constexpr scalar s = differs ? -1 : 1;

    if constexpr (D == 1)
    {
        constexpr Foam::row<4> sign = {s, 1, 0, 0};
        lanes both[8];
        lanesOf(both, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            return joined
            (
                rowAt<4>(U + b*sU) - rowAt<4>(U + a*sU),
                rowAt<4>(grad + a*sA) + sign*rowAt<4>(grad + b*sA)
            );
        });
        for (int k = 0; k < 4; ++k)
        {
            U_[k] = both[k];
            G_[k] = both[4 + k];
        }
    }
    else if constexpr (D == 2)
    {
        constexpr Foam::row<8> sign = {s, s, 1, 1, s, s, 1, 1};
        lanesOf(U_, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            return rowAt<8>(U + b*sU) - rowAt<8>(U + a*sU);
        });
        lanesOf(G_, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            return
                rowAt<8>(grad + a*D*sA) + sign*rowAt<8>(grad + b*D*sA);
        });
    }
    else
    {
        constexpr Foam::row<8> sign = {s, s, s, 1, 1, 1, 0, 0};
        constexpr Foam::row<8> ofL = {0, 0, 0, 1, 1, 1, 0, 0};
        lanesOf(U_, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const Foam::row<8> change =
                rowAt<8>(U + b*sU) - rowAt<8>(U + a*sU);
            rowAt<8>(rows_[l]) = change;
            return change;
        });
        lanesOf(U_ + 8, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const Foam::row<4> change =
                rowAt<4>(U + b*sU + 8) - rowAt<4>(U + a*sU + 8);
            rowAt<4>(rows_[l] + 8) = change;
            return joined(change, extra[l]);
        });
        lanesOf(G_, [&](const int l)
        {
            const scalar* ga = grad + index(ends[2*l])*D*sA;
            const scalar* gb = grad + index(ends[2*l + 1])*D*sA;
            const scalar* change = rows_[l];
            Foam::row<8> byR{}, byU{};
            for (int j = 0; j < D; ++j)
            {
                const Foam::row<8> g =
                    rowAt<8>(ga + j*sA) + sign*rowAt<8>(gb + j*sA);
                byR += g*change[2*D + j];
                if constexpr (finite) byU += g*change[j];
            }
            return finite ? byR + ofL*byU : byR;
        });
    }
}


namespace Foam
{

//- The stretching of nLanes edges: the jump of the velocity that is
//  reconstructed from both sides, the rates at which they are stretched by the
//  mean of both nodes and get shorter, and squares along the edge: of the
//  jump, and of the change by the first of these rates
template<int D, class EdgeLanes>
struct edgeMotion
{
    lanes dx[D], jump[D];
    lanes perLength2, stretching, closing, jj, mm;

    __attribute__((always_inline))
    explicit edgeMotion(const EdgeLanes& of)
    {
        lanes xx{}, along{}, jumpAlong{};
        for (int i = 0; i < D; ++i)
        {
            const lanes change = 0.5*of.Ldx(i);
            dx[i] = of.dx(i);
            jump[i] = of.velocity(i) - change;
            xx += dx[i]*dx[i];
            along += change*dx[i];
            jumpAlong += jump[i]*dx[i];
        }
        perLength2 = reciprocal(xx);
        stretching = along*perLength2;
        closing = -(along + jumpAlong)*perLength2;
        jj = jumpAlong*jumpAlong*perLength2;
        mm = along*along*perLength2;
    }
};


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int D, bool finite>
void variationalKernelTemplate<D, finite>::gradients
(
    variationalData& x,
    const vertexData& d
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* U = x.U.cdata();
    const label nEdges = d.dual.nEdges();

    x.grad = Zero;
    scalar* grad = x.grad.data();

    const label nPairs = x.pairNodes.size()/2;
    for (label p = 0; p < nPairs; ++p)
    {
        const index a = x.pairNodes[2*p], b = x.pairNodes[2*p + 1];
        const scalar* B = x.pairArea.cdata() + D*p;
        const row<sA> change = rowAt<sA>(U + b*sU) - rowAt<sA>(U + a*sU);
        for (int j = 0; j < D; ++j)
        {
            rowAt<sA>(grad + (a*D + j)*sA) += change*B[j];
            rowAt<sA>(grad + (b*D + j)*sA) -= change*B[j];
        }
    }

    // Edges are sorted by their first node: with the last of its own, all edges
    // of a node are done
    index e = 0, farthest = -1;
    for (index a = 0; a < d.nNodes(); ++a)
    {
        scalar* ga = grad + a*D*sA;
        const row<sA> Ua = rowAt<sA>(U + a*sU);
        row<sA> sumA[D];
        for (int j = 0; j < D; ++j) sumA[j] = rowAt<sA>(ga + j*sA);

        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            const index soon =
                edge[2*min(e + prefetchDistance, index(nEdges - 1)) + 1];
            if (soon > farthest)
            {
                farthest = soon;
                prefetch<sU>(U + soon*sU);
                prefetch<sA*D>(grad + soon*D*sA);
            }

            scalar* gb = grad + index(edge[2*e + 1])*D*sA;
            const scalar* C = areaOf(x, e);
            const row<sA> half =
                0.5*(rowAt<sA>(U + index(edge[2*e + 1])*sU) - Ua);
            for (int j = 0; j < D; ++j)
            {
                const row<sA> f = half*C[j*nLanes];
                sumA[j] += f;
                rowAt<sA>(gb + j*sA) += f;
            }
        }

        const scalar perV = x.perV[a];
        for (int j = 0; j < D; ++j) rowAt<sA>(ga + j*sA) = sumA[j]*perV;
    }
}


template<int D, bool finite>
template<bool corrects>
void variationalKernelTemplate<D, finite>::correctLoop
(
    variationalData& x,
    const vertexData& d
)
{
    const scalar* U = x.U.cdata();
    const scalar* grad = x.grad.cdata();
    scalar* correction = x.correction.data();
    scalar* sensor = x.sensor.data();
    const scalar half = 0.5*x.beta;
    lanes closing{};
    constexpr row<4> none[nLanes] = {};

    // In 3D: sums of the first node, in registers as long as it is the same
    struct
    {
        index node = -1;
        scalar* toCorrection = nullptr;
        scalar* toSensor = nullptr;
        row<4> correction[3] = {}, sensor{};

        void load(const index a, scalar* c, scalar* s)
        {
            node = a;
            toCorrection = c;
            toSensor = s;
            sensor = rowAt<4>(s);
            for (int j = 0; corrects && j < 3; ++j)
            {
                correction[j] = rowAt<4>(c + j*4);
            }
        }

        void store() const
        {
            if (node < 0) return;
            rowAt<4>(toSensor) = sensor;
            for (int j = 0; corrects && j < 3; ++j)
            {
                rowAt<4>(toCorrection + j*4) = correction[j];
            }
        }
    } first;

    for (edgeBlocks block(d.dual); block.valid(); ++block)
    {
        block.ahead([&](const index b)
        {
            prefetch<sU>(U + b*sU);
            prefetch<sA*D>(grad + b*D*sA);
            if (corrects) prefetch<sT>(correction + b*sT);
            prefetch<sS>(sensor + b*sS);
        });
        const label* ends = block.nodes();
        const scalar* C = areaOf(x, block.first());
        edgeLanes<true> of;
        of.load(U, grad, ends, none);
        const edgeMotion<D, edgeLanes<true>> m(of);
        closing = max(closing, m.closing);

        // Corrections, of a column or of all, and squares
        lanes out[8] = {};
        if constexpr (corrects)
        {
            for (int i = 0; i < D; ++i)
            {
                const lanes change = half*of.Gr(i);
                if constexpr (D == 3)
                {
                    out[i] = change;
                }
                else
                {
                    for (int j = 0; j < D; ++j)
                    {
                        out[j*D + i] =
                            change*reinterpret_cast<const lanes&>(C[j*nLanes]);
                    }
                }
            }
        }
        out[4] = m.jj;
        out[5] = m.mm;
        if constexpr (D > 1)
        {
            lanes hastening{};
            for (int i = 0; i < D; ++i)
            {
                hastening += of.acceleration(i)*m.dx[i];
            }
            out[6] = hastening*hastening;
        }
        row<8> rows[nLanes];
        rowsOf(rows, out);

        for (int l = 0; l < block.size(); ++l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const scalar* r = reinterpret_cast<const scalar*>(&rows[l]);
            if constexpr (D == 3)
            {
                if (a != first.node)
                {
                    first.store();
                    first.load(a, correction + a*sT, sensor + a*sS);
                }
            }
            if constexpr (corrects)
            {
                if constexpr (D == 3)
                {
                    for (int j = 0; j < D; ++j)
                    {
                        const row<4> f = rowAt<4>(r)*C[j*nLanes + l];
                        first.correction[j] += f;
                        rowAt<4>(correction + b*sT + j*sC) -= f;
                    }
                }
                else
                {
                    rowAt<sT>(correction + a*sT) += rowAt<sT>(r);
                    rowAt<sT>(correction + b*sT) -= rowAt<sT>(r);
                }
            }
            if constexpr (D == 3)
            {
                first.sensor += rowAt<4>(r + 4);
            }
            else
            {
                rowAt<4>(sensor + a*sS) += rowAt<4>(r + 4);
            }
            rowAt<4>(sensor + b*sS) += rowAt<4>(r + 4);
        }
    }
    first.store();

    x.closing = 0;
    for (int l = 0; l < nLanes; ++l) x.closing = max(x.closing, closing[l]);
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::correct
(
    variationalData& x,
    const vertexData& d
) const
{
    x.correction = Zero;
    x.sensor = Zero;
    x.beta > 0 ? correctLoop<true>(x, d) : correctLoop<false>(x, d);
}


template<int D, bool finite>
template<bool corrects, bool volume>
void variationalKernelTemplate<D, finite>::fluxLoop
(
    vertexData& d,
    variationalData& x
)
{
    const scalar* U = x.U.cdata();
    const scalar* grad = x.grad.cdata();
    const scalar* P = d.W.cdata() + d.offsetP();
    const scalar* F = d.state.F.cdata();
    const scalar* H = d.state.H.cdata();
    const scalar* sensor = x.sensor.cdata();
    const scalar* stiffness = x.jumpStiffness.cdata();
    scalar* rates = d.rates.data();
    scalar* adjoint = x.adjoint.data();
    const index sW = d.strideW;
    const scalar halfBeta = 0.5*x.beta;
    const scalar halfZp = 0.5*d.rho*d.cp;
    const scalar halfZs = 0.5*d.rho*d.cs;
    constexpr bool moves = finite && D > 1;

    // What the second node has in common with the first, and what it loses
    constexpr int firstOfWaves = variationalLayout::atWaves(D);
    alignas(registerBytes) scalar sign[sR];
    for (int k = 0; k < sR; ++k) sign[k] = k < firstOfWaves ? -1 : 1;

    // Sums of the first node, in registers as long as it is the same (in one
    // dimension they are short)
    constexpr int nX = D == 3 ? 3 : 1;
    struct
    {
        index node = -1;
        scalar* toRates = nullptr;
        scalar* toX = nullptr;
        row<8> rates{}, X[nX] = {};
        row<4> waves{};

        void load(const index a, scalar* r, scalar* x)
        {
            node = a;
            toRates = r;
            toX = x;
            rates = rowAt<8>(r);
            if constexpr (D == 3) waves = rowAt<4>(r + 8);
            for (int j = 0; j < nX; ++j) X[j] = rowAt<8>(x + j*8);
        }

        void store() const
        {
            if (node < 0) return;
            rowAt<8>(toRates) = rates;
            if constexpr (D == 3) rowAt<4>(toRates + 8) = waves;
            for (int j = 0; j < nX; ++j) rowAt<8>(toX + j*8) = X[j];
        }
    } first;

    for (edgeBlocks block(d.dual); block.valid(); ++block)
    {
        edgeLanes<false> of;
        block.ahead([&](const index b)
        {
            prefetch<sU>(U + b*sU);
            prefetch<sA*D>(grad + b*D*sA);
            prefetch<nP>(P + b*sW);
            if constexpr (moves) prefetch<nP>((D == 3 ? H : F) + b*nP);
            prefetch<sA*D>(adjoint + b*D*sA);
            prefetch<sR>(rates + b*sR);
        });
        const label* ends = block.nodes();
        const scalar* area = areaOf(x, block.first());
        lanes C[D], c[D], f[D];
        for (int j = 0; j < D; ++j)
        {
            C[j] = reinterpret_cast<const lanes&>(area[j*nLanes]);
        }

        // Sums of the squares, the smaller M, the larger factor of waves;
        // differences of P applied to C; areas that both nodes make of C
        lanes S, M, N, smallerM, factor;
        const auto sumAndLarger = [&](const index a, const index b)
        {
            // The factor is negative
            const row<4> sa = rowAt<4>(sensor + a*sS);
            const row<4> sb = rowAt<4>(sensor + b*sS);
            const row<4> sum = sa + sb, least = sa < sb ? sa : sb;
            return std::make_pair
            (
                row<4>{sum[0], sum[1], sum[2], least[3]}, least
            );
        };
        if constexpr (D == 3)
        {
            row<4> extra[nLanes], Pc[nLanes];
            for (int l = 0; l < nLanes; ++l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                row<4> deformed{}, difference{};
                for (int j = 0; j < D; ++j)
                {
                    const scalar Cj = area[j*nLanes + l];
                    if constexpr (finite)
                    {
                        deformed += Cj
                           *(
                                rowAt<4>(H + a*nP + j*D)
                              + rowAt<4>(H + b*nP + j*D)
                            );
                    }
                    if constexpr (corrects)
                    {
                        difference += Cj
                           *(
                                rowAt<4>(P + a*sW + j*D)
                              - rowAt<4>(P + b*sW + j*D)
                            );
                    }
                }
                extra[l] = deformed;
                Pc[l] = difference;
            }
            of.load(U, grad, ends, extra);
            lanes more[8];
            lanesOf(more, [&](const int l)
            {
                const auto s = sumAndLarger(ends[2*l], ends[2*l + 1]);
                return joined
                (
                    s.first,
                    row<4>{Pc[l][0], Pc[l][1], Pc[l][2], s.second[1]}
                );
            });
            S = more[0];
            M = more[1];
            N = more[2];
            factor = -more[3];
            for (int i = 0; i < D; ++i)
            {
                f[i] = more[4 + i];
                c[i] = finite ? 0.5*of.extra(i) : C[i];
            }
            smallerM = more[7];
        }
        else
        {
            of.load(U, grad, ends, nullptr);
            lanes more[8];
            lanesOf(more, [&](const int l)
            {
                const auto s = sumAndLarger(ends[2*l], ends[2*l + 1]);
                return joined(s.first, s.second);
            });
            S = more[0];
            M = more[1];
            N = more[2];
            factor = -more[3];
            smallerM = more[5];

            lanes FP[8];
            lanesOf(FP, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                row<4> sum{}, difference{};
                if constexpr (D == 2)
                {
                    if constexpr (finite)
                    {
                        sum = rowAt<4>(F + a*nP) + rowAt<4>(F + b*nP);
                    }
                    if constexpr (corrects)
                    {
                        difference =
                            rowAt<4>(P + a*sW) - rowAt<4>(P + b*sW);
                    }
                }
                else if constexpr (corrects)
                {
                    difference[0] = P[a*sW] - P[b*sW];
                }
                return joined(sum, difference);
            });
            for (int i = 0; i < D; ++i)
            {
                f[i] = FP[4 + i]*C[0];
                if constexpr (D == 2) f[i] += FP[4 + D + i]*C[1];
                c[i] = C[i];
            }
            if constexpr (moves)
            {
                // The in-plane cofactor is a permutation of F
                c[0] = 0.5*(FP[3]*C[0] - FP[2]*C[1]);
                c[1] = 0.5*(FP[0]*C[1] - FP[1]*C[0]);
            }
        }
        const edgeMotion<D, edgeLanes<false>> m(of);

        // Rates of both nodes; adjoints of the first and the second node by r,
        // and of both by dx
        lanes out[2*8] = {}, uA[D], uB[D], z[D];

        // Force of the jump of the positions, and its adjoint; adjoint of the
        // corrections
        for (int i = 0; i < D; ++i)
        {
            lanes s{};
            if constexpr (D > 1)
            {
                const lanes k = rowAt<nLanes>(stiffness + block.first());
                s = k*(of.disp(i) - 0.5*of.Gr(i));
            }
            out[i] = s;
            const lanes g = corrects ? halfBeta*f[i] : lanes{};
            uA[i] = g - 0.5*s;
            uB[i] = -g - 0.5*s;
        }

        lanes fast;
        const lanes leftOut = jumpSensor::leftOut<D, lanes>
        (
            S, M, N, smallerM, d.cp, fast
        );
        const lanes share = x.epsilon + (1 - x.epsilon)*leftOut;

        // Waves, along and across their direction (34a), (65)
        lanes jump[D], cc{}, CC{}, jc{};
        for (int i = 0; i < D; ++i)
        {
            jump[i] = m.jump[i] + leftOut*m.stretching*m.dx[i];
            cc += c[i]*c[i];
            CC += C[i]*C[i];
            jc += jump[i]*c[i];
        }
        const lanes larger = moves ? max(cc, CC) : cc;
        lanes wave = factor*larger*inverseSquareRoot(larger + VSMALL);

        // Of the full dissipation, what it would damp: for the step
        const lanes perCC = reciprocal(cc + VSMALL);
        const lanes zn = (d.cp - d.cs)*wave*perCC, zs = d.cs*wave;
        for (int i = 0, k = firstOfWaves; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k)
            {
                out[k] = zn*c[i]*c[j];
                if (i == j) out[k] += zs;
            }
        }

        wave *= share;
        const lanes along = (halfZp - halfZs)*jc*perCC;
        lanes s[D], sx{};
        for (int i = 0; i < D; ++i)
        {
            s[i] = wave*(halfZs*jump[i] + along*c[i]);
            out[i] += s[i];
            out[D + i] = s[i];
            sx += s[i]*m.dx[i];
        }

        // Adjoint of the jump
        const lanes left = leftOut*sx*m.perLength2;
        for (int i = 0; i < D; ++i) z[i] = -0.5*(s[i] - left*m.dx[i]);

        // Differences of the rate of the volume
        lanes q{};
        if constexpr (volume)
        {
            lanes Cr{}, rr{}, difference{};
            for (int j = 0; j < D; ++j)
            {
                Cr += C[j]*of.r(j);
                rr += of.r(j)*of.r(j);
                const scalar* trace = grad + j*sA + D + j;
                difference += lanesByOne([&](const int l)
                {
                    return
                        trace[index(ends[2*l])*D*sA]
                      - trace[index(ends[2*l + 1])*D*sA];
                });
            }
            q =
                (0.25*x.volumeImpedance/(D + 1))*fast*Cr
               *rr*inverseSquareRoot(rr)*difference;
        }

        // To the nodes
        row<8> rowsRates[2][nLanes], rowsA[nLanes], rowsB[nLanes];
        lanes toA[8] = {}, toB[8] = {};
        if constexpr (D < 3)
        {
            for (int j = 0; j < D; ++j)
            {
                for (int i = 0; i < D; ++i)
                {
                    toA[j*sA + i] = uA[i]*of.r(j);
                    toB[j*sA + i] = uB[i]*of.r(j);
                    toA[j*sA + D + i] = toB[j*sA + D + i] = z[i]*m.dx[j];
                }
                if constexpr (volume)
                {
                    toA[j*sA + D + j] += q;
                    toB[j*sA + D + j] -= q;
                }
            }
        }
        else
        {
            for (int i = 0; i < D; ++i)
            {
                toA[i] = uA[i];
                toB[i] = uB[i];
                toA[D + i] = toB[D + i] = z[i];
            }
            toA[7] = q;
        }
        if constexpr (D == 1)
        {
            // All in one square
            for (int k = 0; k < 2; ++k)
            {
                out[4 + k] = toA[k];
                out[6 + k] = toB[k];
            }
        }
        rowsOf(rowsRates[0], out);
        if constexpr (D == 3) rowsOf(rowsRates[1], out + 8);
        if constexpr (D > 1)
        {
            rowsOf(rowsA, toA);
            rowsOf(rowsB, toB);
        }

        for (int l = 0; l < block.size(); ++l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            scalar* ra = rates + a*sR;
            scalar* rb = rates + b*sR;
            scalar* Xa = adjoint + a*D*sA;
            scalar* Xb = adjoint + b*D*sA;
            if constexpr (D > 1)
            {
                if (a != first.node)
                {
                    first.store();
                    first.load(a, ra, Xa);
                }
            }
            if constexpr (D == 1)
            {
                const scalar* r =
                    reinterpret_cast<const scalar*>(&rowsRates[0][l]);
                rowAt<4>(ra) += rowAt<4>(r);
                rowAt<4>(rb) += rowAt<4>(sign)*rowAt<4>(r);
                rowAt<2>(Xa) += rowAt<2>(r + 4);
                rowAt<2>(Xb) += rowAt<2>(r + 6);
            }
            else if constexpr (D == 2)
            {
                first.rates += rowsRates[0][l];
                rowAt<8>(rb) += rowAt<8>(sign)*rowsRates[0][l];
                first.X[0] += rowsA[l];
                rowAt<8>(Xb) += rowsB[l];
            }
            else
            {
                const row<4> waves =
                    rowAt<4>(reinterpret_cast<scalar*>(&rowsRates[1][l]));
                first.rates += rowsRates[0][l];
                first.waves += waves;
                rowAt<8>(rb) += rowAt<8>(sign)*rowsRates[0][l];
                rowAt<4>(rb + 8) += waves;

                constexpr row<8> byR = {1, 1, 1, 1, 1, 1, 0, 0};
                constexpr row<8> byU = {0, 0, 0, 1, 1, 1, 0, 0};
                const scalar* change = of.row(l);
                for (int j = 0; j < D; ++j)
                {
                    const scalar rj = change[2*D + j];
                    row<8> by = byR*rj;
                    if constexpr (finite) by += byU*change[j];
                    row<8> more = by*rowsA[l], less = by*rowsB[l];
                    if constexpr (volume)
                    {
                        more[D + j] += rowsA[l][7];
                        less[D + j] -= rowsA[l][7];
                    }
                    first.X[j] += more;
                    rowAt<8>(Xb + j*sA) += less;
                }
            }
        }
    }
    first.store();
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::fluxes
(
    vertexData& d,
    variationalData& x
) const
{
    d.rates = Zero;
    x.adjoint = Zero;
    scalar* sensor = x.sensor.data();
    for (index a = 0; a < d.nNodes(); ++a)
    {
        sensor[a*sS + 3] = d.waveFactor.size() ? -d.waveFactor[a] : -1;
    }
    const bool volume = x.volumeImpedance > 0;
    if (x.beta > 0)
    {
        volume ? fluxLoop<true, true>(d, x) : fluxLoop<true, false>(d, x);
    }
    else
    {
        volume ? fluxLoop<false, true>(d, x) : fluxLoop<false, false>(d, x);
    }
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::jumpEnergy
(
    const vertexData& d,
    const variationalData& x
) const
{
    if constexpr (D == 1)
    {
        return 0;
    }
    constexpr row<4> none[nLanes] = {};
    scalar energy = 0;
    edgeLanes<false> of;
    for (edgeBlocks block(d.dual); block.valid(); ++block)
    {
        of.load(x.U.cdata(), x.grad.cdata(), block.nodes(), none);
        lanes squares{};
        for (int i = 0; i < D; ++i)
        {
            const lanes jump = of.disp(i) - 0.5*of.Gr(i);
            squares += jump*jump;
        }
        squares *= rowAt<nLanes>(x.jumpStiffness.cdata() + block.first());
        for (int l = 0; l < block.size(); ++l) energy += 0.5*squares[l];
    }
    return energy;
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::forces
(
    vertexData& d,
    const variationalData& x
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* T = x.adjoint.cdata();
    const label nEdges = d.dual.nEdges();
    scalar* rates = d.rates.data();

    const label nPairs = x.pairNodes.size()/2;
    for (label p = 0; p < nPairs; ++p)
    {
        const index a = x.pairNodes[2*p], b = x.pairNodes[2*p + 1];
        const scalar* B = x.pairArea.cdata() + D*p;
        row<sA> f{};
        for (int j = 0; j < D; ++j)
        {
            f +=
                (
                    rowAt<sA>(T + (a*D + j)*sA) - rowAt<sA>(T + (b*D + j)*sA)
                )*B[j];
        }
        rowAt<sA>(rates + a*sR) += f;
        rowAt<sA>(rates + b*sR) -= f;
    }

    index e = 0;
    for (index a = 0; a < d.nNodes(); ++a)
    {
        row<sA> Ta[D], sum = rowAt<sA>(rates + a*sR);
        for (int j = 0; j < D; ++j) Ta[j] = rowAt<sA>(T + (a*D + j)*sA);
        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            const index b = edge[2*e + 1];
            const scalar* C = areaOf(x, e);
            row<sA> f{};
            for (int j = 0; j < D; ++j)
            {
                f += (Ta[j] + rowAt<sA>(T + (b*D + j)*sA))*(0.5*C[j*nLanes]);
            }
            sum += f;
            rowAt<sA>(rates + b*sR) -= f;
        }

        // Not the waves, of which some are in a row of 3D
        constexpr row<sA> isForce = forceRow();
        rowAt<sA>(rates + a*sR) = sum*(isForce*x.perV[a] + (1 - isForce));
    }
}

} // End namespace Foam


// ************************************************************************* //
