/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The pass over the edges that needs stresses and sensor: adjoint of the
    corrections, dissipation and its adjoint. Also the pass that sums the waves
    for the bound of the step.

\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "variationalBlocks.H"
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


//- Fluxes of a block of edges: the data that it reads and adds to
template<int D, bool finite>
template<bool corrects>
class variationalKernelTemplate<D, finite>::fluxSums
{
    // In 2D and 3D the sums of the first node, in registers until another node
    // is first
    static constexpr int nX = D == 3 ? 3 : 1;
    static constexpr int wR = D == 3 ? 4 : 2;

    // Private data

        const scalar* P_;
        const scalar* grad_;
        const scalar* factors_;
        const bool stretched_;
        scalar* sensor_;
        scalar* U_;
        scalar* rates_;
        scalar* adjoint_;
        const index sW_;
        const scalar halfBeta_;
        const scalar epsilon_;
        const scalar moreEpsilon_;
        const scalar halfZp_;
        const scalar halfZs_;
        const scalar cp_;

        index node_ = -1;
        alignas(registerBytes) row<8> X_[nX] = {};
        row<wR> rate_{};


    // Private Member Functions

        //- Sums of S, M and N of both nodes and the smaller M; and the minima
        //  of all values, for M and for minus the larger wave factor
        struct squares
        {
            row<4> sums, least;
        };

        __attribute__((always_inline))
        inline squares squaresOf(const index a, const index b) const
        {
            const row<4> sa = rowAt<4>(sensor_ + a*sS + atSquares);
            const row<4> sb = rowAt<4>(sensor_ + b*sS + atSquares);
            const row<4> sum = sa + sb, least = sa < sb ? sa : sb;
            return squares{{sum[0], sum[1], sum[2], least[1]}, least};
        }

        //- Dissipation of edges.
        //  \param dx  deformed edges
        //  \param c  deformed areas. \param CC  squares of undeformed areas
        //  \param S  squares of both nodes, and the smaller M (jumpSensor)
        //  \param factor  wave factor
        __attribute__((always_inline))
        inline edgeDissipation<D, lanes> dissipation
        (
            const scalar* motion,
            const lanes* dx,
            const lanes (&c)[D],
            const lanes& CC,
            const lanes* S,
            const lanes& factor
        ) const
        {
            const edgeMotion<D, lanes> m = motionAt<D>(motion, dx);
            const lanes leftOut = jumpSensor::leftOut<D, lanes>
            (
                S[0], S[1], S[2], S[3], cp_
            );
            return edgeDissipation<D, lanes>
            (
                m, c, CC, factor, leftOut, epsilon_ + moreEpsilon_*leftOut,
                halfZp_, halfZs_
            );
        }

        //- Start with the first node of an edge, if it is another one
        __attribute__((always_inline))
        inline void comeTo(const index a)
        {
            if (a == node_) return;
            keep();
            node_ = a;
            #pragma GCC unroll 3
            for (int j = 0; j < nX; ++j)
            {
                X_[j] = rowAt<8>(adjoint_ + a*D*sA + j*8);
            }
            rate_ = rowAt<wR>(rates_ + a*sR + second);
        }

        __attribute__((always_inline))
        static inline lanes squareOf(const scalar* C, lanes (&c)[D])
        {
            lanes CC{};
            for (int j = 0; j < D; ++j)
            {
                c[j] = laneAt(C, j);
                CC += c[j]*c[j];
            }
            return CC;
        }


public:

    fluxSums(vertexData& d, variationalData& x)
    :
        P_(d.W.cdata() + d.offsetP()),
        grad_(x.grad.cdata()),
        factors_(d.waveFactor.cdata()),
        stretched_(d.waveFactor.size()),
        sensor_(x.sensor.data()),
        U_(x.U.data()),
        rates_(d.rates.data()),
        adjoint_(x.adjoint.data()),
        sW_(d.strideW),
        halfBeta_(0.5*x.beta),
        epsilon_(x.epsilon),
        moreEpsilon_(x.frontEpsilon - x.epsilon),
        halfZp_(0.5*d.rho*d.cp),
        halfZs_(0.5*d.rho*d.cs),
        cp_(d.cp)
    {}


    //- Put minus the wave factor of a node into the record that edges read
    __attribute__((always_inline))
    inline void begin(const index a) const
    {
        (D == 2 ? U_[a*sU] : sensor_[a*sS + atSquares + 3]) =
            stretched_ ? -factors_[a] : -1;
    }

    //- Prefetch a node that edges will reach
    __attribute__((always_inline))
    inline void fetch(const index a) const
    {
        prefetch<nP>(P_ + a*sW_);
        if constexpr (finite || D == 2) prefetch<sU>(U_ + a*sU);
        if constexpr (finite && D == 3) prefetch<sA*D>(grad_ + a*D*sA);
        prefetch<4>(sensor_ + a*sS + atSquares);
        prefetch<sR>(rates_ + a*sR);
        prefetch<sA*D>(adjoint_ + a*D*sA);
    }

    //- The node whose sums are in registers
    index node() const { return node_; }

    //- Write the sums
    __attribute__((always_inline))
    inline void keep() const
    {
        if (D == 1 || node_ < 0) return;
        #pragma GCC unroll 3
        for (int j = 0; j < nX; ++j)
        {
            rowAt<8>(adjoint_ + node_*D*sA + j*8) = X_[j];
        }
        rowAt<wR>(rates_ + node_*sR + second) = rate_;
    }


    //- A block of edges in 1D.
    //  \param ends  both nodes of each edge
    //  \param n  number of edges
    //  \param C, r  area and reach, in lanes
    //  \param motion  stored by the corrections
    __attribute__((always_inline))
    inline void block1
    (
        const label* ends,
        const int n,
        const scalar* C,
        const scalar* r,
        const scalar* motion
    )
    {
        lanes dx[D] = {laneAt(r, 0)}, c[D], of[8];
        if constexpr (finite)
        {
            dx[0] += lanesByOne([&](const int l)
            {
                return
                    U_[index(ends[2*l + 1])*sU] - U_[index(ends[2*l])*sU];
            });
        }
        const lanes CC = squareOf(C, c);

        // Also load differences of the stresses, for beta/2 (P_a - P_b) C:
        // stress times area, as it acts on displacements
        lanesOf(of, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const squares both = squaresOf(a, b);
            row<4> other = both.least;
            if constexpr (corrects) other[0] = P_[a*sW_] - P_[b*sW_];
            return joined(both.sums, other);
        });
        const lanes toFirst =
            corrects
          ? halfBeta_*of[4]*laneAt(C, 0)*laneAt(r, 0)
          : lanes{};
        const edgeDissipation<D, lanes> f
        (
            dissipation(motion, dx, c, CC, of, -of[7])
        );
        const lanes toSecond = f.z[0]*dx[0];
        alignas(registerBytes) row<4> rows[nLanes];
        fourRowsOf(rows, {toFirst, toSecond, f.s[0], lanes{}});
        for (int l = 0; l < n; ++l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const scalar* f = reinterpret_cast<const scalar*>(&rows[l]);
            constexpr row<2> sign = {-1, 1};
            rowAt<2>(adjoint_ + a*sA) += rowAt<2>(f);
            rowAt<2>(adjoint_ + b*sA) += sign*rowAt<2>(f);
            rates_[a*sR + 1] += f[2];
            rates_[b*sR + 1] -= f[2];
        }
    }


    //- The same in 2D: everything in lanes
    __attribute__((always_inline))
    inline void block2
    (
        const label* ends,
        const int n,
        const scalar* C,
        const scalar* r,
        const scalar* motion
    )
    {
        lanes dx[D], c[D], of[8], S[4];
        const lanes CC = squareOf(C, c);
        lanesOf(of, [&](const int l)
        {
            const row<8> ofA = rowAt<8>(sensor_ + index(ends[2*l])*sS);
            const row<8> ofB = rowAt<8>(sensor_ + index(ends[2*l + 1])*sS);
            return leastAt<0x80, 8>(ofA + ofB, ofA, ofB);
        });
        for (int k = 0; k < 4; ++k) S[k] = of[4 + k];
        if constexpr (finite)
        {
            planeArea(of, laneAt(C, 0), laneAt(C, 1), c);
            for (int i = 0; i < D; ++i) c[i] *= 0.5;
        }
        inOrder();
        lanesOf(of, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const row<4> Ua = rowAt<4>(U_ + a*sU), Ub = rowAt<4>(U_ + b*sU);
            row<4> difference{};
            if constexpr (corrects)
            {
                difference = rowAt<4>(P_ + a*sW_) - rowAt<4>(P_ + b*sW_);
            }
            return joined(leastAt<1, 4>(Ub - Ua, Ua, Ub), difference);
        });
        const lanes factor = -of[0];
        lanes more[D];
        for (int i = 0; i < D; ++i)
        {
            dx[i] = finite ? laneAt(r, i) + of[atU + i] : laneAt(r, i);
            if constexpr (corrects)
            {
                more[i] =
                    halfBeta_
                   *(of[4 + i]*laneAt(C, 0) + of[4 + D + i]*laneAt(C, 1));
            }
        }
        const edgeDissipation<D, lanes> f
        (
            dissipation(motion, dx, c, CC, S, factor)
        );

        lanes toA[8];
        for (int j = 0; j < D; ++j)
        {
            for (int i = 0; i < D; ++i)
            {
                toA[j*sA + i] = corrects ? more[i]*laneAt(r, j) : lanes{};
                toA[j*sA + second + i] = f.z[i]*dx[j];
            }
        }
        alignas(registerBytes) row<8> rows[nLanes];
        alignas(registerBytes) row<2> force[nLanes];
        rowsOf(rows, toA);
        twoRowsOf(force, f.s[0], f.s[1]);
        for (int l = 0; l < n; ++l)
        {
            const index b = ends[2*l + 1];
            comeTo(ends[2*l]);
            constexpr row<8> sign = {-1, -1, 1, 1, -1, -1, 1, 1};
            X_[0] += rows[l];
            rowAt<8>(adjoint_ + b*D*sA) += sign*rows[l];
            rate_ += force[l];
            rowAt<2>(rates_ + b*sR + second) -= force[l];
        }
    }


    //- The same in 3D: stresses edge by edge
    __attribute__((always_inline))
    inline void block3
    (
        const label* ends,
        const int n,
        const scalar* C,
        const scalar* r,
        const scalar* motion
    )
    {
        lanes changed[D], c[D], of[8];
        if constexpr (finite)
        {
            lanes by[4];
            fourLanesOf(by, [&](const int l)
            {
                return
                    rowAt<4>(U_ + index(ends[2*l + 1])*sU)
                  - rowAt<4>(U_ + index(ends[2*l])*sU);
            });
            for (int i = 0; i < D; ++i) changed[i] = laneAt(r, i) + by[i];
        }
        const scalar* dx =
            finite ? reinterpret_cast<const scalar*>(changed) : r;
        const lanes CC = squareOf(C, c);
        alignas(registerBytes) row<4> corrections[nLanes];
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
                            rowAt<4>(P_ + a*sW_ + j*D)
                          - rowAt<4>(P_ + b*sW_ + j*D)
                        );
                }
                corrections[l] = halfBeta_*difference;
            }
            row<4> deformed{};
            if constexpr (finite) deformed = waveArea3(grad_, C + l, a, b);
            deformed = row<4>
            {
                deformed[0], deformed[1], deformed[2], both.least[3]
            };
            return joined(both.sums, deformed);
        });
        for (int i = 0; finite && i < D; ++i) c[i] = of[4 + i];
        const edgeDissipation<D, lanes> f
        (
            dissipation
            (
                motion, reinterpret_cast<const lanes*>(dx), c, CC, of, -of[7]
            )
        );

        lanes out[8] =
            {f.s[0], f.s[1], f.s[2], lanes{}, f.z[0], f.z[1], f.z[2]};
        alignas(registerBytes) row<8> rows[nLanes];
        rowsOf(rows, out);
        for (int l = 0; l < n; ++l)
        {
            const index b = ends[2*l + 1];
            scalar* Xb = adjoint_ + b*D*sA;
            comeTo(ends[2*l]);
            constexpr row<8> sign = {-1, -1, -1, -1, 1, 1, 1, 1};
            const row<4> s = lower(rows[l]);
            const row<8> sums = spliced
            (
                corrects ? corrections[l] : row<4>{}, rows[l]
            );
            #pragma GCC unroll 3
            for (int j = 0; j < D; ++j)
            {
                const row<8> by = halves(r[j*nLanes + l], dx[j*nLanes + l]);
                X_[j] += by*sums;
                rowAt<8>(Xb + j*sA) += by*(sign*sums);
            }
            rate_ += s;
            rowAt<4>(rates_ + b*sR + second) -= s;
        }
    }
};


template<int D, bool finite>
template<bool corrects>
void variationalKernelTemplate<D, finite>::fluxLoop(edgePass& pass)
{
    fluxSums<corrects> sums(d_, x_);
    overBlocks(earlyEdges::fluxes, pass, sums, [&](const index a)
    {
        stressNode(a);
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int D, bool finite>
void variationalKernelTemplate<D, finite>::fluxes(edgePass& pass)
{
    x_.beta > 0 ? fluxLoop<true>(pass) : fluxLoop<false>(pass);
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::sumWaves()
{
    const scalar* F = d_.state.F.cdata();
    scalar* grad = x_.grad.data();
    const scalar* factors = d_.waveFactor.cdata();
    const bool stretched = d_.waveFactor.size();
    scalar* waves = x_.waves().data();

    // Sums of the first node, kept until another node is first
    index node = -1;
    row<sK> sum{};

    edgePass pass(d_.dual.nEdges());
    edgeBlocks block(d_.dual, x_.toMeet, pass);
    const auto begin = [&](const index a)
    {
        zeroAt<sK>(waves + a*sK);
        if constexpr (finite && D == 3)
        {
            // The state may have changed since the last forces
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
        const scalar* C = x_.area.cdata() + index(block.first())*D;
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
        const lanes zn = (d_.cp - d_.cs)*wave*reciprocal(cc + VSMALL);
        const lanes zs = d_.cs*wave;
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
