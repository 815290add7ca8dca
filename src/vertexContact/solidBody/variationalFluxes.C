/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The pass over the edges that needs stresses and sensor: adjoint of the
    corrections, dissipation and its adjoint; and the pass that sums up waves
    for the bound of the step.

\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "edgeBlocks.H"
#include "edgeRows.H"
#include "variationalEdge.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

template<int D, bool finite>
__attribute__((always_inline))
inline row<4> variationalKernelTemplate<D, finite>::waveArea3
(
    const scalar* grad,
    const scalar* C,
    const index a,
    const index b
)
{
    row<4> c{};
    for (int j = 0; j < 3; ++j)
    {
        c +=
            (0.5*C[j*nLanes])
           *(
                rowAt<4>(grad + (a*D + j)*sA + second)
              + rowAt<4>(grad + (b*D + j)*sA + second)
            );
    }
    return c;
}


template<int D, bool finite>
template<bool corrects>
void variationalKernelTemplate<D, finite>::fluxLoop
(
    vertexData& d,
    variationalData& x,
    edgePass& pass
)
{
    const scalar* P = d.W.cdata() + d.offsetP();
    const scalar* grad = x.grad.cdata();
    scalar* sensor = x.sensor.data();
    scalar* U = x.U.data();
    scalar* rates = d.rates.data();
    scalar* adjoint = x.adjoint.data();
    const index sW = D == 2 ? sW2 : d.strideW;
    const scalar halfBeta = 0.5*x.beta;
    const scalar halfZp = 0.5*d.rho*d.cp;
    const scalar halfZs = 0.5*d.rho*d.cs;
    const index places = x.motionPlaces;
    constexpr bool moves = finite && D > 1;

    // Sums of S, M and N of both nodes and the smaller M; the least of all,
    // which are M and minus the larger factor of waves
    struct squares
    {
        row<4> sums, least;
    };
    const auto squaresOf = [&](const index a, const index b)
    {
        const row<4> sa = rowAt<4>(sensor + a*sS + atSquares);
        const row<4> sb = rowAt<4>(sensor + b*sS + atSquares);
        const row<4> sum = sa + sb, least = sa < sb ? sa : sb;
        return squares{{sum[0], sum[1], sum[2], least[1]}, least};
    };

    // In 2D and 3D: sums of the first node, in registers as long as it is the
    // same
    constexpr int nX = D == 3 ? 3 : 1;
    constexpr int wR = D == 3 ? 4 : 2;
    struct
    {
        index node = -1;
        alignas(registerBytes) row<8> X[nX] = {};
        row<wR> rates{};
    } first;
    const auto keep = [&]()
    {
        if constexpr (D > 1)
        {
            if (first.node < 0) return;
            #pragma GCC unroll 3
            for (int j = 0; j < nX; ++j)
            {
                rowAt<8>(adjoint + first.node*D*sA + j*8) = first.X[j];
            }
            rowAt<wR>(rates + first.node*sR + second) = first.rates;
        }
    };

    completeNodes complete(x.lateNodes, pass);
    const auto completeBefore = [&](const label end) __attribute__((noinline))
    {
        complete.before(end, [&](const index a) { stressNode(x, d, a); });
    };

    edgeBlocks block(d.dual, x.toMeet, pass);
    const scalar* factors = d.waveFactor.cdata();
    const bool stretched = d.waveFactor.size();
    const auto begin = [&](const index a)
    {
        (D == 2 ? U[a*sU] : sensor[a*sS + atSquares + 3]) =
            stretched ? -factors[a] : -1;
    };
    for (; block.valid(); ++block)
    {
        if constexpr (D == 1) completeBefore(block.nodes()[0]);
        else if (block.completes()) completeBefore(first.node);
        block.ahead([&](const index a)
        {
            prefetch<nP>(P + a*sW);
            if constexpr (finite || D == 2) prefetch<sU>(U + a*sU);
            if constexpr (moves && D == 3) prefetch<sA*D>(grad + a*D*sA);
            prefetch<4>(sensor + a*sS + atSquares);
            prefetch<sR>(rates + a*sR);
            prefetch<sA*D>(adjoint + a*D*sA);
            begin(a);
        });
        const label* ends = block.nodes();
        const index e = block.first();
        const scalar* C = x.area.cdata() + e*D;
        const scalar* r = x.reach.cdata() + e*D;

        // The edges as they are, in 2D from below
        lanes changed[D];
        const scalar* dx =
            finite ? reinterpret_cast<const scalar*>(changed) : r;
        if constexpr (finite && D == 1)
        {
            const lanes by = lanesByOne([&](const int l)
            {
                return
                    U[index(ends[2*l + 1])*sU] - U[index(ends[2*l])*sU];
            });
            changed[0] = laneAt(r, 0) + by;
        }
        else if constexpr (finite && D == 3)
        {
            lanes by[4];
            fourLanesOf(by, [&](const int l)
            {
                return
                    rowAt<4>(U + index(ends[2*l + 1])*sU)
                  - rowAt<4>(U + index(ends[2*l])*sU);
            });
            for (int i = 0; i < D; ++i) changed[i] = laneAt(r, i) + by[i];
        }

        lanes c[D], CC{}, S, M, N, smallerM, factor;
        for (int j = 0; j < D; ++j)
        {
            c[j] = laneAt(C, j);
            CC += c[j]*c[j];
        }

        // Differences of the stresses, times the area, as they act on
        // displacements: beta/2 (P_a - P_b) C
        alignas(registerBytes) row<4> corrections[nLanes];
        lanes more[D];
        if constexpr (D == 3)
        {
            lanes of[8];
            lanesOf(of, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                const squares both = squaresOf(a, b);
                if constexpr (corrects)
                {
                    row<4> difference{};
                    for (int j = 0; j < D; ++j)
                    {
                        difference +=
                            C[j*nLanes + l]
                           *(
                                rowAt<4>(P + a*sW + j*D)
                              - rowAt<4>(P + b*sW + j*D)
                            );
                    }
                    corrections[l] = halfBeta*difference;
                }
                row<4> deformed{};
                if constexpr (finite) deformed = waveArea3(grad, C + l, a, b);
                deformed = row<4>
                {
                    deformed[0], deformed[1], deformed[2], both.least[3]
                };
                return joined(both.sums, deformed);
            });
            for (int i = 0; finite && i < D; ++i) c[i] = of[4 + i];
            S = of[0];
            M = of[1];
            N = of[2];
            smallerM = of[3];
            factor = -of[7];
        }
        else if constexpr (D == 2)
        {
            lanes of[8];
            lanesOf(of, [&](const int l)
            {
                const row<8> ofA = rowAt<8>(sensor + index(ends[2*l])*sS);
                const row<8> ofB = rowAt<8>(sensor + index(ends[2*l + 1])*sS);
                return leastAt<0x80, 8>(ofA + ofB, ofA, ofB);
            });
            S = of[4];
            M = of[5];
            N = of[6];
            smallerM = of[7];
            if constexpr (finite)
            {
                planeArea(of, laneAt(C, 0), laneAt(C, 1), c);
                for (int i = 0; i < D; ++i) c[i] *= 0.5;
            }
            inOrder();
            lanesOf(of, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                const row<4> Ua = rowAt<4>(U + a*sU), Ub = rowAt<4>(U + b*sU);
                row<4> difference{};
                if constexpr (corrects)
                {
                    difference = rowAt<4>(P + a*sW) - rowAt<4>(P + b*sW);
                }
                return joined(leastAt<1, 4>(Ub - Ua, Ua, Ub), difference);
            });
            factor = -of[0];
            for (int i = 0; finite && i < D; ++i)
            {
                changed[i] = laneAt(r, i) + of[atU + i];
            }
            for (int i = 0; corrects && i < D; ++i)
            {
                more[i] =
                    halfBeta
                   *(of[4 + i]*laneAt(C, 0) + of[4 + D + i]*laneAt(C, 1));
            }
        }
        else
        {
            lanes of[8];
            lanesOf(of, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                const squares both = squaresOf(a, b);
                row<4> other = both.least;
                if constexpr (corrects) other[0] = P[a*sW] - P[b*sW];
                return joined(both.sums, other);
            });
            S = of[0];
            M = of[1];
            N = of[2];
            smallerM = of[3];
            factor = -of[7];
            more[0] = halfBeta*of[4]*laneAt(C, 0);
        }

        const edgeMotion<D, lanes> m = motionAt<D>
        (
            x.motion.cdata() + (e & places)*nM,
            reinterpret_cast<const lanes*>(dx)
        );
        const lanes leftOut = jumpSensor::leftOut<D, lanes>
        (
            S, M, N, smallerM, d.cp
        );
        const edgeDissipation<D, lanes> f
        (
            m, c, CC, factor, leftOut,
            x.epsilon + (x.frontEpsilon - x.epsilon)*leftOut,
            halfZp, halfZs
        );

        // To the nodes
        if constexpr (D == 3)
        {
            lanes out[8] =
                {f.s[0], f.s[1], f.s[2], lanes{}, f.z[0], f.z[1], f.z[2]};
            alignas(registerBytes) row<8> rows[nLanes];
            rowsOf(rows, out);
            for (int l = 0; l < block.size(); ++l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                scalar* Xb = adjoint + b*D*sA;
                if (a != first.node)
                {
                    keep();
                    first.node = a;
                    #pragma GCC unroll 3
                    for (int j = 0; j < D; ++j)
                    {
                        first.X[j] = rowAt<8>(adjoint + a*D*sA + j*sA);
                    }
                    first.rates = rowAt<4>(rates + a*sR + second);
                }
                constexpr row<8> sign = {-1, -1, -1, -1, 1, 1, 1, 1};
                const row<4> s = lower(rows[l]);
                row<8> sums = spliced
                (
                    corrects ? corrections[l] : row<4>{}, rows[l]
                );
                #pragma GCC unroll 3
                for (int j = 0; j < D; ++j)
                {
                    const row<8> by =
                        halves(r[j*nLanes + l], dx[j*nLanes + l]);
                    first.X[j] += by*sums;
                    rowAt<8>(Xb + j*sA) += by*(sign*sums);
                }
                first.rates += s;
                rowAt<4>(rates + b*sR + second) -= s;
            }
        }
        else if constexpr (D == 2)
        {
            lanes toA[8];
            for (int j = 0; j < D; ++j)
            {
                for (int i = 0; i < D; ++i)
                {
                    toA[j*sA + i] =
                        corrects ? more[i]*laneAt(r, j) : lanes{};
                    toA[j*sA + second + i] = f.z[i]*laneAt(dx, j);
                }
            }
            alignas(registerBytes) row<8> rows[nLanes];
            alignas(registerBytes) row<2> force[nLanes];
            rowsOf(rows, toA);
            twoRowsOf(force, f.s[0], f.s[1]);
            for (int l = 0; l < block.size(); ++l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                scalar* Xb = adjoint + b*D*sA;
                if (a != first.node)
                {
                    keep();
                    first.node = a;
                    first.X[0] = rowAt<8>(adjoint + a*D*sA);
                    first.rates = rowAt<2>(rates + a*sR + second);
                }
                constexpr row<8> sign = {-1, -1, 1, 1, -1, -1, 1, 1};
                first.X[0] += rows[l];
                rowAt<8>(Xb) += sign*rows[l];
                const row<2>& s = force[l];
                first.rates += s;
                rowAt<2>(rates + b*sR + second) -= s;
            }
        }
        else
        {
            const lanes toFirst = corrects ? more[0]*laneAt(r, 0) : lanes{};
            const lanes toSecond = f.z[0]*laneAt(dx, 0);
            alignas(registerBytes) row<4> rows[nLanes];
            fourRowsOf(rows, {toFirst, toSecond, f.s[0], lanes{}});
            for (int l = 0; l < block.size(); ++l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                const scalar* f = reinterpret_cast<const scalar*>(&rows[l]);
                constexpr row<2> sign = {-1, 1};
                rowAt<2>(adjoint + a*sA) += rowAt<2>(f);
                rowAt<2>(adjoint + b*sA) += sign*rowAt<2>(f);
                rates[a*sR + 1] += f[2];
                rates[b*sR + 1] -= f[2];
            }
        }
    }
    keep();
    completeBefore(block.leave(pass, begin));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int D, bool finite>
void variationalKernelTemplate<D, finite>::fluxes
(
    vertexData& d,
    variationalData& x,
    edgePass& pass
) const
{
    x.beta > 0 ? fluxLoop<true>(d, x, pass) : fluxLoop<false>(d, x, pass);
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::sumWaves
(
    const vertexData& d,
    variationalData& x
) const
{
    const scalar* F = d.state.F.cdata();
    scalar* grad = x.grad.data();
    const scalar* factors = d.waveFactor.cdata();
    const bool stretched = d.waveFactor.size();
    scalar* waves = x.waves().data();

    // That of the first node, as long as it is the same
    index node = -1;
    row<sK> sum{};

    edgePass pass(d.dual.nEdges());
    edgeBlocks block(d.dual, x.toMeet, pass);
    const auto begin = [&](const index a)
    {
        zeroAt<sK>(waves + a*sK);
        if constexpr (finite && D == 3)
        {
            // The state may be another one than that of the last forces
            const SolidTensor<D> f = loadF<D>(F, a);
            row<4> columns[D];
            for (int j = 0; j < D; ++j)
            {
                columns[j] = row<4>{f(0, j), f(1, j), f(2, j), 0};
            }
            storeCofactor(grad + a*D*sA, columns);
        }
    };
    for (; block.valid(); ++block)
    {
        block.ahead([&](const index a)
        {
            if constexpr (finite && D == 2) prefetch<nP>(F + a*nP);
            begin(a);
        });
        const label* ends = block.nodes();
        const scalar* C = x.area.cdata() + index(block.first())*D;
        lanes c[D], cc{}, CC{};
        for (int j = 0; j < D; ++j)
        {
            c[j] = laneAt(C, j);
            CC += c[j]*c[j];
        }
        lanes of[4];
        if constexpr (finite && D == 3)
        {
            fourLanesOf(of, [&](const int l)
            {
                return waveArea3(grad, C + l, ends[2*l], ends[2*l + 1]);
            });
            for (int i = 0; i < D; ++i) c[i] = of[i];
        }
        else if constexpr (finite && D == 2)
        {
            fourLanesOf(of, [&](const int l)
            {
                return
                    rowAt<4>(F + index(ends[2*l])*nP)
                  + rowAt<4>(F + index(ends[2*l + 1])*nP);
            });
            planeArea(of, laneAt(C, 0), laneAt(C, 1), c);
            for (int i = 0; i < D; ++i) c[i] *= 0.5;
        }
        for (int i = 0; i < D; ++i) cc += c[i]*c[i];
        const lanes larger = finite && D > 1 ? max(cc, CC) : cc;
        lanes wave = larger*inverseSquareRoot(larger + VSMALL);
        if (stretched)
        {
            wave *= lanesByOne([&](const int l)
            {
                return max(factors[ends[2*l]], factors[ends[2*l + 1]]);
            });
        }
        const lanes zn = (d.cp - d.cs)*wave*reciprocal(cc + VSMALL);
        const lanes zs = d.cs*wave;
        lanes out[8] = {};
        for (int i = 0, k = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k)
            {
                out[k] = zn*c[i]*c[j];
                if (i == j) out[k] += zs;
            }
        }
        alignas(registerBytes) row<8> rows[nLanes];
        rowsOf(rows, out);
        for (int l = 0; l < block.size(); ++l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            if (a != node)
            {
                if (node >= 0) rowAt<sK>(waves + node*sK) = sum;
                node = a;
                sum = rowAt<sK>(waves + a*sK);
            }
            const row<sK> w =
                rowAt<sK>(reinterpret_cast<const scalar*>(&rows[l]));
            sum += w;
            rowAt<sK>(waves + b*sK) += w;
        }
    }
    if (node >= 0) rowAt<sK>(waves + node*sK) = sum;
    block.leave(pass, begin);
}

} // End namespace Foam


// ************************************************************************* //
