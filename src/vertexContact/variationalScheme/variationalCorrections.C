/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The pass over the edges that evaluates the motion: corrections of the
    gradient, jumps of the positions with their forces, jumps of the velocities,
    which the pass of the fluxes uses, and the squares of the sensor.

    In 3D linear terms are computed row by row, edge by edge, and only the rest
    in lanes, since transposing is expensive.

\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "variationalBlocks.H"
#include "edgeRows.H"
#include "variationalEdge.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

//- Lanes of component k of a block of edges
inline const lanes& laneAt(const scalar* block, const int k)
{
    return reinterpret_cast<const lanes&>(block[k*nLanes]);
}

inline lanes& laneAt(scalar* block, const int k)
{
    return reinterpret_cast<lanes&>(block[k*nLanes]);
}


//- Store what the fluxes need of the motion of a block of edges
template<int D>
inline void store(scalar* block, const edgeMotion<D, lanes>& m)
{
    for (int i = 0; i < D; ++i) laneAt(block, i) = m.jump[i];
    laneAt(block, D) = m.stretching;
}


//- Load that motion, for the deformed edges
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
    // In 1D nothing has to be projected
    if constexpr (D > 1) m.perLength2 = reciprocal(xx);
    return m;
}


//- Corrections of a block of edges: the data that it reads and adds to
template<int D, bool finite>
template<bool corrects>
class variationalKernelTemplate<D, finite>::correctionSums
{
    static constexpr int sT = D*sA;

    // In 2D and 3D the sums of the first node, in registers until another node
    // is first. In 2D both columns are one row
    static constexpr int wC = D == 3 && !corrects ? 4 : 8;
    static constexpr int nC = D == 2 ? 1 : D;

    // Private data

        const scalar* U_;
        const scalar* grad_;
        const scalar* rush_;
        const scalar half_;
        const scalar jumpModulus_;

        //- Share with which the jumps of each node resist, or nullptr
        const scalar* share_;

        scalar* correction_;
        scalar* sensor_;
        scalar* rates_;

        index node_ = -1;
        alignas(registerBytes) row<wC> columns_[nC] = {};
        row<8> other_{};

        lanes closing_{}, opening_{};

        //- Twice the energy of the position jumps: in 2D in lanes, in 3D by
        //  the components of the jumps
        lanes laneEnergy_{};
        row<4> energy_{};


    // Private Member Functions

        //- Start with the first node of an edge, if it is another one
        __attribute__((always_inline))
        inline void comeTo(const index a)
        {
            if (a == node_) return;
            keep();
            node_ = a;
            #pragma GCC unroll 3
            for (int j = 0; j < nC; ++j)
            {
                columns_[j] = rowAt<wC>(correction_ + a*sT + j*sA);
            }
            other_ = rowAt<8>(sensor_ + a*sS);
        }

        //- Set deformed edges, and differences of velocities.
        //  \param change  differences of U between both nodes
        __attribute__((always_inline))
        static inline void setEdge
        (
            lanes* dx,
            lanes* dv,
            const scalar* r,
            const lanes* change
        )
        {
            for (int i = 0; i < D; ++i)
            {
                dx[i] =
                    finite ? laneAt(r, i) + change[atU + i] : laneAt(r, i);
                dv[i] = change[atU + second + i];
            }
        }

        //- Record how fast edges become shorter and longer
        __attribute__((always_inline))
        inline void see(const edgeMotion<D, lanes>& m)
        {
            closing_ = max(closing_, m.closing);
            opening_ = max(opening_, -m.closing);
        }

        //- Square of the haste of edges.
        //  \param acceleration  difference between both nodes
        __attribute__((always_inline))
        static inline lanes haste(const lanes* acceleration, const lanes* dx)
        {
            lanes along{};
            for (int i = 0; i < D; ++i) along += acceleration[i]*dx[i];
            return along*along;
        }

        __attribute__((always_inline))
        inline lanes stiffness(const scalar* C, const scalar* r) const
        {
            lanes CC{}, rr{};
            for (int j = 0; j < D; ++j)
            {
                CC += laneAt(C, j)*laneAt(C, j);
                rr += laneAt(r, j)*laneAt(r, j);
            }
            return edgeStiffness(jumpModulus_, CC, rr);
        }

        //- Mean of both nodes' shares with which jumps resist, for the n edges
        //  that exist
        __attribute__((always_inline))
        inline lanes shares(const label* ends, const int n) const
        {
            lanes both{};
            for (int l = 0; l < n; ++l)
            {
                both[l] = 0.5*(share_[ends[2*l]] + share_[ends[2*l + 1]]);
            }
            return both;
        }


public:

    correctionSums(vertexData& d, variationalData& x)
    :
        U_(x.U.cdata()),
        grad_(x.grad.cdata()),
        rush_(x.acceleration.cdata()),
        half_(0.5*x.beta),
        jumpModulus_(x.jumpModulus),
        share_
        (
            d.state.hourglassShare.size()
          ? d.state.hourglassShare.cdata()
          : nullptr
        ),
        correction_(x.adjoint.data()),
        sensor_(x.sensor.data()),
        rates_(d.rates.data())
    {}


    //- Set the initial sums of a node
    __attribute__((always_inline))
    inline void begin(const index a) const
    {
        zeroAt<sT>(correction_ + a*sT);
        zeroAt<sS>(sensor_ + a*sS);
        if constexpr (D == 1) zeroAt<sR>(rates_ + a*sR);
    }

    //- Prefetch a node that edges will reach
    __attribute__((always_inline))
    inline void fetch(const index a) const
    {
        prefetch<sU>(U_ + a*sU);
        prefetch<sA*D>(grad_ + a*D*sA);
    }

    //- The node whose sums are in registers
    index node() const { return node_; }

    //- Write the sums
    __attribute__((always_inline))
    inline void keep() const
    {
        if (D == 1 || node_ < 0) return;
        #pragma GCC unroll 3
        for (int j = 0; j < nC; ++j)
        {
            rowAt<wC>(correction_ + node_*sT + j*sA) = columns_[j];
        }
        rowAt<8>(sensor_ + node_*sS) = other_;
    }

    //- The largest rates of all edges so far, and the energy of their jumps
    void totals(scalar& closing, scalar& fastest, scalar& jumpEnergy) const
    {
        jumpEnergy += 0.5*(energy_[0] + energy_[1] + energy_[2]);
        for (int l = 0; l < nLanes; ++l)
        {
            closing = max(closing, closing_[l]);
            fastest = max(fastest, max(closing_[l], opening_[l]));
            jumpEnergy += 0.5*laneEnergy_[l];
        }
    }


    //- A block of edges in 1D.
    //  \param ends  both nodes of each edge
    //  \param n  number of edges
    //  \param C, r  area and reach, in lanes
    //  \param motion  stored for the fluxes
    __attribute__((always_inline))
    inline void block1
    (
        const label* ends,
        const int n,
        const scalar* C,
        const scalar* r,
        scalar* motion
    )
    {
        // Differences of displacement and velocity, difference of the first
        // derivatives, and sum of the second ones
        constexpr row<4> sign = {-1, 1, 0, 0};
        lanes of[8], dx[D], dv[D];
        lanesOf(of, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            return joined
            (
                rowAt<4>(U_ + b*sU) - rowAt<4>(U_ + a*sU),
                rowAt<4>(grad_ + a*sA) + sign*rowAt<4>(grad_ + b*sA)
            );
        });
        setEdge(dx, dv, r, of);
        const lanes change[D] = {0.5*of[5]*dx[0]};
        const edgeMotion<D, lanes> m(dx, dv, change);
        store(motion, m);
        see(m);
        const lanes more =
            corrects ? half_*of[4]*laneAt(r, 0)*laneAt(C, 0) : lanes{};
        alignas(registerBytes) row<4> rows[nLanes];
        fourRowsOf(rows, {m.jj, m.mm, more, lanes{}});
        for (int l = 0; l < n; ++l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            const scalar* f = reinterpret_cast<const scalar*>(&rows[l]);
            rowAt<2>(sensor_ + a*sS) += rowAt<2>(f);
            rowAt<2>(sensor_ + b*sS) += rowAt<2>(f);
            if constexpr (corrects)
            {
                correction_[a*sT] += f[2];
                correction_[b*sT] -= f[2];
            }
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
        scalar* motion
    )
    {
        const lanes whole = stiffness(C, r);
        const lanes k = share_ ? shares(ends, n)*whole : whole;
        lanes of[8], sum[8], difference[8], dx[D], dv[D];
        lanesOf(of, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            return rowAt<8>(U_ + b*sU) - rowAt<8>(U_ + a*sU);
        });
        setEdge(dx, dv, r, of);
        inOrder();
        lanesOf(sum, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            return rowAt<8>(grad_ + a*sT) + rowAt<8>(grad_ + b*sT);
        });
        if constexpr (corrects)
        {
            inOrder();
            lanesOf(difference, [&](const int l)
            {
                const index a = ends[2*l], b = ends[2*l + 1];
                return rowAt<8>(grad_ + a*sT) - rowAt<8>(grad_ + b*sT);
            });
        }

        // Contributions to columns, and to forces and squares
        lanes out[8] = {}, change[D], square{};
        for (int i = 0; i < D; ++i)
        {
            change[i] = 0.5*(sum[D + i]*dx[0] + sum[sA + D + i]*dx[1]);
            const lanes jump =
                of[atU + i]
              - 0.5*(sum[i]*laneAt(r, 0) + sum[sA + i]*laneAt(r, 1));
            const lanes force = k*jump;
            square += jump*jump;
            laneEnergy_ += force*jump;
            out[D + i] = -0.5*force;
            if constexpr (corrects)
            {
                out[i] =
                    half_
                   *(
                        difference[i]*laneAt(r, 0)
                      + difference[sA + i]*laneAt(r, 1)
                    );
            }
        }
        const edgeMotion<D, lanes> m(dx, dv, change);
        store(motion, m);
        see(m);
        lanes toA[8];
        if constexpr (corrects)
        {
            for (int j = 0; j < D; ++j)
            {
                for (int i = 0; i < D; ++i)
                {
                    toA[j*sA + i] = out[i]*laneAt(C, j);
                    toA[j*sA + second + i] = out[D + i]*laneAt(r, j);
                }
            }
        }
        out[atJumps] = 0.25*whole*square;
        out[4] = m.jj;
        out[5] = m.mm;
        out[6] = haste(of + atU + 2*D, dx);
        out[7] = m.mm;
        alignas(registerBytes) row<8> rows[nLanes];
        rowsOf(rows, out);
        alignas(registerBytes) row<8> columns[nLanes];
        if constexpr (corrects)
        {
            rowsOf(columns, toA);
        }

        for (int l = 0; l < n; ++l)
        {
            const index b = ends[2*l + 1];
            comeTo(ends[2*l]);
            const row<8>& f = rows[l];
            constexpr row<8> sign = {-1, -1, 1, 1, -1, -1, 1, 1};
            constexpr row<8> forceSign = {1, 1, -1, -1, 1, 1, 1, 1};
            if constexpr (corrects)
            {
                const row<8>& column = columns[l];
                columns_[0] += column;
                rowAt<8>(correction_ + b*sT) += sign*column;
            }
            else
            {
                const row<8> column =
                    picked<2, 3, 8, 8, 2, 3, 8, 8>(f)
                   *halves(r[l], r[nLanes + l]);
                columns_[0] += column;
                rowAt<8>(correction_ + b*sT) += column;
            }
            other_ += f;
            rowAt<8>(sensor_ + b*sS) += forceSign*f;
        }
    }


    //- The same in 3D: linear terms edge by edge
    __attribute__((always_inline))
    inline void block3
    (
        const label* ends,
        const int n,
        const scalar* C,
        const scalar* r,
        scalar* motion
    )
    {
        const lanes whole = stiffness(C, r);
        const lanes stiff = share_ ? shares(ends, n)*whole : whole;
        const scalar* k = reinterpret_cast<const scalar*>(&stiff);
        alignas(registerBytes) row<8> differences[nLanes];
        alignas(registerBytes) row<8> sums[nLanes];
        alignas(registerBytes) row<4> force[nLanes];
        lanes of[8], dx[D], dv[D], change[D], square{};
        lanesOf(of, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            return
                differences[l] = rowAt<8>(U_ + b*sU) - rowAt<8>(U_ + a*sU);
        });
        setEdge(dx, dv, r, of);

        // Sums over both nodes of G r for the displacement and L dx for the
        // velocity; then the acceleration
        const scalar* byV =
            finite ? reinterpret_cast<const scalar*>(dx) : r;
        lanesOf(of, [&](const int l)
        {
            const index a = ends[2*l], b = ends[2*l + 1];
            row<8> ofA{}, ofB{};
            #pragma GCC unroll 3
            for (int j = 0; j < D; ++j)
            {
                const row<8> by = halves(r[j*nLanes + l], byV[j*nLanes + l]);
                ofA += by*rowAt<8>(grad_ + (a*D + j)*sA);
                ofB += by*rowAt<8>(grad_ + (b*D + j)*sA);
            }
            const row<8> sum = ofA + ofB;
            const row<4> jump =
                threeOf(lower(differences[l]) - 0.5*lower(sum));
            force[l] = k[l]*jump;
            energy_ += force[l]*jump;
            if (share_) square[l] = dotOfThree(jump, jump);
            if constexpr (corrects)
            {
                sums[l] =
                    joined(half_*(lower(ofA) - lower(ofB)), -0.5*force[l]);
            }
            return spliced
            (
                threeAt(rush_ + b*D) - threeAt(rush_ + a*D), sum
            );
        });
        for (int i = 0; i < D; ++i) change[i] = 0.5*of[second + i];
        const edgeMotion<D, lanes> m(dx, dv, change);
        store(motion, m);
        see(m);
        alignas(registerBytes) row<4> squares[nLanes];
        fourRowsOf
        (
            squares, {m.jj, m.mm, haste(of, dx), 0.25*whole*square}
        );

        for (int l = 0; l < n; ++l)
        {
            const index b = ends[2*l + 1];
            scalar* Cb = correction_ + b*sT;
            comeTo(ends[2*l]);
            constexpr row<8> sign = {-1, -1, -1, -1, 1, 1, 1, 1};
            #pragma GCC unroll 3
            for (int j = 0; j < D; ++j)
            {
                const scalar rj = r[j*nLanes + l];
                if constexpr (corrects)
                {
                    const row<8> by = halves(C[j*nLanes + l], rj);
                    columns_[j] += by*sums[l];
                    rowAt<8>(Cb + j*sA) += by*(sign*sums[l]);
                }
                else
                {
                    const row<4> f = force[l]*(-0.5*rj);
                    columns_[j] += f;
                    rowAt<4>(Cb + j*sA) += f;
                }
            }
            const row<8> other = joined(-0.5*force[l], squares[l]);
            other_ += other;
            rowAt<8>(sensor_ + b*sS) += sign*other;
        }
    }
};


template<int D, bool finite>
template<bool corrects>
label variationalKernelTemplate<D, finite>::correctLoop(edgePass& pass)
{
    if (x_.early.any() ? pass.early : pass.edge == 0)
    {
        x_.closing = x_.fastest = x_.jumpEnergy = 0;
    }
    correctionSums<corrects> sums(d_, x_);
    const label firstLate = pass.late;
    label nBad = 0;
    overBlocks(earlyEdges::corrections, pass, sums, [&](const index a)
    {
        if constexpr (D > 1) takeForce(a);
        nBad += !moveNode(a);
        takeJumps(a);
    });
    // Forces of late nodes before the sums over processors, which include the
    // rates
    const label nLate = pass.early ? x_.lateNodes.size() : pass.late;
    for (label late = firstLate; D > 1 && late < nLate; ++late)
    {
        const label a = x_.lateNodes[late];
        if (x_.early.completes(earlyEdges::corrections, a) == pass.early)
        {
            takeForce(a);
        }
    }
    sums.totals(x_.closing, x_.fastest, x_.jumpEnergy);
    return nBad;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::correct(edgePass& pass)
{
    return x_.beta > 0 ? correctLoop<true>(pass) : correctLoop<false>(pass);
}

} // End namespace Foam


// ************************************************************************* //
