/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The pass over the edges that looks at the motion: corrections of the
    gradient, jumps of the positions with their forces, jumps of the velocities,
    which the pass of the fluxes takes up, and the squares of the sensor.

    In three dimensions what is of first degree is computed row by row, edge by
    edge, and only what is not in lanes: transposing is what costs.

\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "edgeBlocks.H"
#include "edgeRows.H"
#include "variationalEdge.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

//- The lanes of component k of a block of edges
inline const lanes& laneAt(const scalar* block, const int k)
{
    return reinterpret_cast<const lanes&>(block[k*nLanes]);
}

inline lanes& laneAt(scalar* block, const int k)
{
    return reinterpret_cast<lanes&>(block[k*nLanes]);
}


//- Keep what the fluxes need of the motion of a block of edges
template<int D>
inline void store(scalar* block, const edgeMotion<D, lanes>& m)
{
    for (int i = 0; i < D; ++i) laneAt(block, i) = m.jump[i];
    laneAt(block, D) = m.stretching;
}


//- The same motion, with the edges as they are
template<int D>
inline edgeMotion<D, lanes> motionAt(const scalar* block, const lanes* dx)
{
    edgeMotion<D, lanes> m;
    lanes xx{};
    for (int i = 0; i < D; ++i)
    {
        m.jump[i] = laneAt(block, i);
        m.dx[i] = dx[i];
        xx += dx[i]*dx[i];
    }
    m.stretching = laneAt(block, D);
    // Along a line nothing has to be projected
    if constexpr (D > 1) m.perLength2 = reciprocal(xx);
    return m;
}


template<int D, bool finite>
template<bool corrects>
label variationalKernelTemplate<D, finite>::correctLoop
(
    vertexData& d,
    variationalData& x,
    edgePass& pass
)
{
    constexpr int sT = D*sA;
    const scalar* U = x.U.cdata();
    const scalar* grad = x.grad.cdata();
    const scalar half = 0.5*x.beta;
    scalar* correction = x.adjoint.data();
    scalar* sensor = x.sensor.data();
    scalar* rates = d.rates.data();
    lanes closing{}, opening{};
    if (pass.edge == 0) x.closing = x.fastest = 0;

    // In 2D and 3D: sums of the first node, in registers as long as it is the
    // same. In 2D both columns are one row
    constexpr int wC = D == 3 && !corrects ? 4 : 8;
    constexpr int nC = D == 2 ? 1 : D;
    struct
    {
        index node = -1;
        alignas(registerBytes) row<wC> columns[nC] = {};
        row<8> other{};
    } first;
    const auto keep = [&]()
    {
        if constexpr (D > 1)
        {
            if (first.node < 0) return;
            #pragma GCC unroll 3
            for (int j = 0; j < nC; ++j)
            {
                rowAt<wC>(correction + first.node*sT + j*sA) =
                    first.columns[j];
            }
            rowAt<8>(sensor + first.node*sS) = first.other;
        }
    };
    const auto come = [&](const index a)
    {
        if constexpr (D > 1)
        {
            first.node = a;
            #pragma GCC unroll 3
            for (int j = 0; j < nC; ++j)
            {
                first.columns[j] = rowAt<wC>(correction + a*sT + j*sA);
            }
            first.other = rowAt<8>(sensor + a*sS);
        }
    };

    completeNodes complete(x.lateNodes, pass);
    const label firstLate = pass.late;
    const index places = x.motionPlaces;
    label nBad = 0;
    // Apart from the loops, for which there are registers enough without it
    const auto completeBefore = [&](const label end) __attribute__((noinline))
    {
        complete.before(end, [&](const index a)
        {
            if constexpr (D > 1) takeForce(d, x, a);
            nBad += !moveNode(d, x, a);
            takeJumps(x, a);
        });
    };

    edgeBlocks block(d.dual, x.toMeet, pass);
    const auto begin = [&](const index a)
    {
        zeroAt<sT>(correction + a*sT);
        zeroAt<sS>(sensor + a*sS);
        if constexpr (D == 1) zeroAt<sR>(rates + a*sR);
    };
    for (; block.valid(); ++block)
    {
        // All edges before this block are done, and so are the nodes before
        // its first one, or, in 2D and 3D, that of the last edge
        if constexpr (D == 1) completeBefore(block.nodes()[0]);
        else if (block.completes()) completeBefore(first.node);
        block.ahead([&](const index a)
        {
            prefetch<sU>(U + a*sU);
            prefetch<sA*D>(grad + a*D*sA);
            begin(a);
        });
        const label* ends = block.nodes();
        const index e = block.first();
        const scalar* C = x.area.cdata() + e*D;
        const scalar* r = x.reach.cdata() + e*D;
        scalar* motion = x.motion.data() + (e & places)*nM;

        lanes dx[D], dv[D], change[D], acceleration[D], CC{}, rr{};
        for (int j = 0; D > 1 && j < D; ++j)
        {
            CC += laneAt(C, j)*laneAt(C, j);
            rr += laneAt(r, j)*laneAt(r, j);
        }
        const lanes stiffness = edgeStiffness(x.jumpModulus, CC, rr);
        const auto setEdge = [&](const lanes* U)
        {
            for (int i = 0; i < D; ++i)
            {
                dx[i] = finite ? laneAt(r, i) + U[atU + i] : laneAt(r, i);
                dv[i] = U[atU + second + i];
            }
        };
        const auto squaresOf = [&](const edgeMotion<D, lanes>& m)
        {
            closing = max(closing, m.closing);
            opening = max(opening, -m.closing);
            lanes hastening{};
            if constexpr (D > 1)
            {
                for (int i = 0; i < D; ++i) hastening += acceleration[i]*dx[i];
            }
            return hastening*hastening;
        };

        if constexpr (D == 3)
        {
            const scalar* rush = x.acceleration.cdata();
            const scalar* k = reinterpret_cast<const scalar*>(&stiffness);
            alignas(registerBytes) row<8> differences[nLanes];
            alignas(registerBytes) row<8> sums[nLanes];
            alignas(registerBytes) row<4> force[nLanes];
            lanes of[8];
            lanesOf(of, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                return
                    differences[l] = rowAt<8>(U + b*sU) - rowAt<8>(U + a*sU);
            });
            setEdge(of);

            // G r of the displacement, L dx of the velocity: from both nodes;
            // the acceleration besides
            const scalar* byV =
                finite ? reinterpret_cast<const scalar*>(dx) : r;
            lanesOf(of, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                row<8> ofA{}, ofB{};
                #pragma GCC unroll 3
                for (int j = 0; j < D; ++j)
                {
                    const row<8> by =
                        halves(r[j*nLanes + l], byV[j*nLanes + l]);
                    ofA += by*rowAt<8>(grad + (a*D + j)*sA);
                    ofB += by*rowAt<8>(grad + (b*D + j)*sA);
                }
                const row<8> sum = ofA + ofB;
                force[l] =
                    k[l]*threeOf(lower(differences[l]) - 0.5*lower(sum));
                if constexpr (corrects)
                {
                    sums[l] =
                        joined(half*(lower(ofA) - lower(ofB)), -0.5*force[l]);
                }
                return spliced
                (
                    threeAt(rush + b*D) - threeAt(rush + a*D), sum
                );
            });
            for (int i = 0; i < D; ++i)
            {
                acceleration[i] = of[i];
                change[i] = 0.5*of[second + i];
            }
            const edgeMotion<D, lanes> m(dx, dv, change);
            store(motion, m);
            alignas(registerBytes) row<4> squares[nLanes];
            fourRowsOf(squares, {m.jj, m.mm, squaresOf(m), lanes{}});

            for (int l = 0; l < block.size(); ++l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                scalar* Cb = correction + b*sT;
                if (a != first.node)
                {
                    keep();
                    come(a);
                }
                #pragma GCC unroll 3
                for (int j = 0; j < D; ++j)
                {
                    const scalar rj = r[j*nLanes + l];
                    if constexpr (corrects)
                    {
                        constexpr row<8> sign = {-1, -1, -1, -1, 1, 1, 1, 1};
                        const row<8> by = halves(C[j*nLanes + l], rj);
                        first.columns[j] += by*sums[l];
                        rowAt<8>(Cb + j*sA) += by*(sign*sums[l]);
                    }
                    else
                    {
                        const row<4> f = force[l]*(-0.5*rj);
                        first.columns[j] += f;
                        rowAt<4>(Cb + j*sA) += f;
                    }
                }
                constexpr row<8> sign = {-1, -1, -1, -1, 1, 1, 1, 1};
                const row<8> other = joined(-0.5*force[l], squares[l]);
                first.other += other;
                rowAt<8>(sensor + b*sS) += sign*other;
            }
        }
        else if constexpr (D == 2)
        {
            lanes of[8], sum[8], difference[8];
            lanesOf(of, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                return rowAt<8>(U + b*sU) - rowAt<8>(U + a*sU);
            });
            setEdge(of);
            inOrder();
            lanesOf(sum, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                return rowAt<8>(grad + a*D*sA) + rowAt<8>(grad + b*D*sA);
            });
            if constexpr (corrects)
            {
                inOrder();
                lanesOf(difference, [&](const int l)
                {
                    const index a = ends[2*l], b = ends[2*l + 1];
                    return rowAt<8>(grad + a*D*sA) - rowAt<8>(grad + b*D*sA);
                });
            }

            // What is added to columns, and to forces and squares
            lanes out[8] = {}, force[D];
            for (int i = 0; i < D; ++i)
            {
                acceleration[i] = of[atU + 2*D + i];
                change[i] = 0.5*(sum[D + i]*dx[0] + sum[sA + D + i]*dx[1]);
                force[i] =
                    stiffness
                   *(
                        of[atU + i]
                      - 0.5*(sum[i]*laneAt(r, 0) + sum[sA + i]*laneAt(r, 1))
                    );
                out[D + i] = -0.5*force[i];
                if constexpr (corrects)
                {
                    out[i] =
                        half
                       *(
                            difference[i]*laneAt(r, 0)
                          + difference[sA + i]*laneAt(r, 1)
                        );
                }
            }
            const edgeMotion<D, lanes> m(dx, dv, change);
            store(motion, m);
            out[4] = m.jj;
            out[5] = m.mm;
            out[6] = squaresOf(m);
            out[7] = m.mm;
            alignas(registerBytes) row<8> rows[nLanes];
            rowsOf(rows, out);
            alignas(registerBytes) row<8> columns[nLanes];
            if constexpr (corrects)
            {
                lanes toA[8];
                for (int j = 0; j < D; ++j)
                {
                    for (int i = 0; i < D; ++i)
                    {
                        toA[j*sA + i] = out[i]*laneAt(C, j);
                        toA[j*sA + second + i] = out[D + i]*laneAt(r, j);
                    }
                }
                rowsOf(columns, toA);
            }

            for (int l = 0; l < block.size(); ++l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                if (a != first.node)
                {
                    keep();
                    come(a);
                }
                const row<8>& f = rows[l];
                constexpr row<8> sign = {-1, -1, 1, 1, -1, -1, 1, 1};
                constexpr row<8> forceSign = {1, 1, -1, -1, 1, 1, 1, 1};
                if constexpr (corrects)
                {
                    const row<8>& column = columns[l];
                    first.columns[0] += column;
                    rowAt<8>(correction + b*sT) += sign*column;
                }
                else
                {
                    const row<8> column =
                        picked<2, 3, 8, 8, 2, 3, 8, 8>(f)
                       *halves(r[l], r[nLanes + l]);
                    first.columns[0] += column;
                    rowAt<8>(correction + b*sT) += column;
                }
                first.other += f;
                rowAt<8>(sensor + b*sS) += forceSign*f;
            }
        }
        else
        {
            // Differences of displacement and velocity; that of the first
            // derivatives, the sum of the second
            constexpr row<4> sign = {-1, 1, 0, 0};
            lanes of[8];
            lanesOf(of, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                return joined
                (
                    rowAt<4>(U + b*sU) - rowAt<4>(U + a*sU),
                    rowAt<4>(grad + a*sA) + sign*rowAt<4>(grad + b*sA)
                );
            });
            setEdge(of);
            change[0] = 0.5*of[5]*dx[0];
            const edgeMotion<D, lanes> m(dx, dv, change);
            store(motion, m);
            squaresOf(m);
            const lanes more =
                corrects ? half*of[4]*laneAt(r, 0)*laneAt(C, 0) : lanes{};
            alignas(registerBytes) row<4> rows[nLanes];
            fourRowsOf(rows, {m.jj, m.mm, more, lanes{}});
            for (int l = 0; l < block.size(); ++l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                const scalar* f = reinterpret_cast<const scalar*>(&rows[l]);
                rowAt<2>(sensor + a*sS) += rowAt<2>(f);
                rowAt<2>(sensor + b*sS) += rowAt<2>(f);
                if constexpr (corrects)
                {
                    correction[a*sT] += f[2];
                    correction[b*sT] -= f[2];
                }
            }
        }
    }
    keep();
    completeBefore(block.leave(pass, begin));
    for (label late = firstLate; D > 1 && late < pass.late; ++late)
    {
        // Before the sums over processors: those of the rates follow
        takeForce(d, x, x.lateNodes[late]);
    }

    for (int l = 0; l < nLanes; ++l)
    {
        x.closing = max(x.closing, closing[l]);
        x.fastest = max(x.fastest, max(closing[l], opening[l]));
    }
    return nBad;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::correct
(
    vertexData& d,
    variationalData& x,
    edgePass& pass
) const
{
    return
        x.beta > 0
      ? correctLoop<true>(d, x, pass)
      : correctLoop<false>(d, x, pass);
}

} // End namespace Foam


// ************************************************************************* //
