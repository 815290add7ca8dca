/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The pass over the edges that sums up the fluxes: nLanes edges at a time,
    computed together. Components of a node that are neighbours in memory are
    loaded, and combined for an edge, as rows; the rows of the edges are
    transposed to lanes; the fluxes are transposed back and added to the nodes
    as rows, one edge after the other.

\*---------------------------------------------------------------------------*/

#include "vertexKernelTemplate.H"
#include "vectorLimiter.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

//- A row of n scalars of each of some edges, and each of them as lanes
template<int n>
class edgeRows
{
    static constexpr int stride = nLanes*((n + nLanes - 1)/nLanes);

    alignas(registerBytes) scalar of_[nLanes][stride];
    lanes as_[stride];


public:

    scalar* operator[](const int l) { return of_[l]; }

    //- Lanes of the rows
    void toLanes()
    {
        for (int k = 0; k < stride; k += nLanes)
        {
            lanes square[nLanes];
            for (int l = 0; l < nLanes; ++l)
            {
                square[l] = reinterpret_cast<const lanes&>(of_[l][k]);
            }
            transpose(square);
            for (int l = 0; l < nLanes; ++l) as_[k + l] = square[l];
        }
    }

    lanes lane(const int k) const { return as_[k]; }

    void set(const int k, const lanes& value) { as_[k] = value; }

    //- Rows of the lanes that were set; those that were not, zero
    void toRows()
    {
        for (int k = 0; k < stride; k += nLanes)
        {
            lanes square[nLanes];
            for (int l = 0; l < nLanes; ++l)
            {
                square[l] = k + l < n ? as_[k + l] : lanes{};
            }
            transpose(square);
            for (int l = 0; l < nLanes; ++l)
            {
                reinterpret_cast<lanes&>(of_[l][k]) = square[l];
            }
        }
    }
};


template<int D, int nSJ, reconstructionType R, bool finite>
template<limiterType limiter, bool energy>
void vertexKernelTemplate<D, nSJ, R, finite>::fluxLoop(vertexData& d) const
{
    typedef SolidVector<D, lanes> vectorLanes;

    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* edgeArea = d.edgeArea();
    const scalar* X = d.dual.nodePosition().cdata();
    const scalar* W = d.W.cdata();
    const scalar* grad = d.grad.cdata();
    const scalar* F = d.state.F.cdata();
    const scalar* H = d.state.H.cdata();
    scalar* rates = d.rates.data();

    const label nEdges = d.dual.nEdges();
    const scalar halfZp = 0.5*d.rho*d.cp;
    const scalar halfZs = 0.5*d.rho*d.cs;
    const scalar perZp = 0.5/(d.rho*d.cp);
    scalar dissipation = 0;

    // Rows of an edge: components of v and SigmaJ, of a column, of gradients
    constexpr int wU = rowWidth(D + nSJ);
    constexpr int wC = rowWidth(D);
    constexpr int wG = strideWidth(sG);
    constexpr int nU = paddedStride(D + nSJ);
    constexpr int nC = paddedStride(D);

    // Places of what an edge has of its nodes: area, deformed area (2D: sum of
    // F), difference and sum of v and SigmaJ, and of the tractions, changes of
    // both nodes to mid-edge
    constexpr bool moves = finite && D > 1;
    constexpr int atArea = 0;
    constexpr int atDeformed = atArea + nC;
    constexpr int atDifference = atDeformed + (moves ? 4 : 0);
    constexpr int atSum = atDifference + nU;
    constexpr int atT = atSum + (full ? nU : 0);
    constexpr int atTDifference = atT + nC;
    constexpr int atChangeA = atTDifference + (full ? nC : 0);
    constexpr int atChangeB = atChangeA + (none ? 0 : sG);
    constexpr int nOfNodes = atChangeB + (none ? 0 : sG);

    edgeRows<nOfNodes> of;
    edgeRows<sRates> flux;

    // The last edges, if they are fewer than lanes
    label lastEdge[2*nLanes];
    scalar lastArea[D*nLanes + 4];

    for (label e0 = 0; e0 < nEdges; e0 += nLanes)
    {
        const int some = min(label(nLanes), nEdges - e0);
        const label* ends = edge + 2*e0;
        const scalar* areas = edgeArea + D*e0;
        if (e0 + nLanes >= nEdges)
        {
            // Copied, so that rows of areas can be read to their end
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

        // The far nodes of edges that come soon are not in the cache
        const label soon = min(e0 + prefetchDistance, nEdges);
        for (label e = soon; e < min(soon + nLanes, nEdges); ++e)
        {
            const label b = edge[2*e + 1];
            prefetch<sW>(W + b*sW);
            if constexpr (!none) prefetch<sG*D>(grad + b*sG*D);
            if constexpr (finite && D == 3) prefetch<9>(H + 9*b);
            prefetch<sRates>(rates + b*sRates);
        }

        for (int l = 0; l < nLanes; ++l)
        {
            const label a = ends[2*l], b = ends[2*l + 1];
            const scalar* C = areas + D*l;
            const scalar* Wa = W + a*sW;
            const scalar* Wb = W + b*sW;
            scalar* to = of[l];

            rowAt<wC>(to + atArea) = rowAt<wC>(C);
            rowAt<wU>(to + atDifference) = rowAt<wU>(Wb) - rowAt<wU>(Wa);
            if constexpr (full)
            {
                rowAt<wU>(to + atSum) = rowAt<wU>(Wa) + rowAt<wU>(Wb);
            }

            // Sums over the columns of P, and of H
            row<wC> t{}, tDifference{};
            for (int j = 0; j < D; ++j)
            {
                const row<wC> Pa = rowAt<wC>(Wa + atP + j*D);
                const row<wC> Pb = rowAt<wC>(Wb + atP + j*D);
                t += (Pa + Pb)*(0.5*C[j]);
                if constexpr (full) tDifference += (Pb - Pa)*C[j];
            }
            rowAt<wC>(to + atT) = t;
            if constexpr (full) rowAt<wC>(to + atTDifference) = tDifference;

            if constexpr (finite && D == 3)
            {
                row<wC> c{};
                for (int j = 0; j < D; ++j)
                {
                    c +=
                        (
                            rowAt<wC>(H + 9*a + 3*j)
                          + rowAt<wC>(H + 9*b + 3*j)
                        )*(0.5*C[j]);
                }
                rowAt<wC>(to + atDeformed) = c;
            }
            else if constexpr (finite && D == 2)
            {
                rowAt<4>(to + atDeformed) =
                    rowAt<4>(F + 4*a) + rowAt<4>(F + 4*b);
            }

            if constexpr (!none)
            {
                // Changes from both nodes to mid-edge
                scalar r[D];
                for (int j = 0; j < D; ++j)
                {
                    r[j] = 0.5*(X[b*D + j] - X[a*D + j]);
                }
                const scalar* ga = grad + a*sG*D;
                const scalar* gb = grad + b*sG*D;
                for (int k = 0; k < sG; k += wG)
                {
                    row<wG> sumA = rowAt<wG>(ga + k)*r[0];
                    row<wG> sumB = rowAt<wG>(gb + k)*r[0];
                    for (int j = 1; j < D; ++j)
                    {
                        sumA += rowAt<wG>(ga + j*sG + k)*r[j];
                        sumB += rowAt<wG>(gb + j*sG + k)*r[j];
                    }
                    rowAt<wG>(to + atChangeA + k) = sumA;
                    rowAt<wG>(to + atChangeB + k) = sumB;
                }
            }
        }
        of.toLanes();

        // Direction of the waves (65)
        vectorLanes area, c, n;
        for (int i = 0; i < D; ++i) area[i] = of.lane(atArea + i);
        if constexpr (finite && D == 3)
        {
            for (int i = 0; i < D; ++i) c[i] = of.lane(atDeformed + i);
        }
        else if constexpr (finite && D == 2)
        {
            // The in-plane cofactor is a permutation of F
            const auto twiceF = [&](const int k)
            {
                return of.lane(atDeformed + k);
            };
            c[0] = 0.5*(twiceF(3)*area[0] - twiceF(2)*area[1]);
            c[1] = 0.5*(twiceF(0)*area[1] - twiceF(1)*area[0]);
        }
        else
        {
            c = area;
        }
        const lanes cc = dot(c, c);
        const lanes perC = inverseSquareRoot(cc + VSMALL);
        for (int i = 0; i < D; ++i) n[i] = perC*c[i];

        // Waves cross the deformed area where that is larger: so do the
        // dissipation, which else lags behind the central fluxes (momentum)
        // or outruns the time step (J), and the step
        const lanes larger = moves ? max(cc, dot(area, area)) : cc;
        const lanes perWave = inverseSquareRoot(larger + VSMALL);
        const lanes waveC = larger*perWave;

        // States at both sides of mid-edge: jump and average of the velocity,
        // average of the traction; with the differences of the nodes, first
        vectorLanes difference, jump, vAvg, t, tDifference;
        for (int i = 0; i < D; ++i)
        {
            difference[i] = jump[i] = of.lane(atDifference + i);
            t[i] = of.lane(atT + i);
            if constexpr (full)
            {
                vAvg[i] = 0.5*of.lane(atSum + i);
                tDifference[i] = of.lane(atTDifference + i);
            }
        }
        const lanes differenceSJ =
            nSJ == 1 ? of.lane(atDifference + D) : lanes{};
        lanes jumpSJ = differenceSJ;

        // Corrections of the averages
        vectorLanes vCorrection, tCorrection;

        if constexpr (!none)
        {
            vectorLanes da, db;
            for (int i = 0; i < D; ++i)
            {
                da[i] = of.lane(atChangeA + i);
                db[i] = of.lane(atChangeB + i);
            }
            if constexpr (full)
            {
                vCorrection = slopeLimiter::limitAverage<limiter>
                (
                    n, difference, da, db
                );
            }
            slopeLimiter::limitVectors<limiter>(n, difference, da, db);
            if constexpr (linear)
            {
                slopeLimiter::keepDissipative(n, difference, da, db);
            }
            for (int i = 0; i < D; ++i) jump[i] -= da[i] + db[i];

            if constexpr (nSJ == 1)
            {
                jumpSJ -=
                    slopeLimiter::limited<limiter, lanes>
                    (
                        of.lane(atChangeA + D), differenceSJ
                    )
                  + slopeLimiter::limited<limiter, lanes>
                    (
                        of.lane(atChangeB + D), differenceSJ
                    );
                if constexpr (linear)
                {
                    jumpSJ = select
                    (
                        jumpSJ*differenceSJ < lanes{}, lanes{}, jumpSJ
                    );
                }
            }

            if constexpr (full)
            {
                for (int i = 0; i < D; ++i)
                {
                    da[i] = db[i] = lanes{};
                    for (int j = 0; j < D; ++j)
                    {
                        const int k = atP_(i, j);
                        da[i] += of.lane(atChangeA + k)*area[j];
                        db[i] += of.lane(atChangeB + k)*area[j];
                    }
                }
                tCorrection = slopeLimiter::limitAverage<limiter>
                (
                    n, tDifference, da, db
                );
            }
        }

        // Traction, contact-stick condition (34a): average of the stress and
        // acoustic dissipation of the velocity jump, times area
        const lanes jumpN = (halfZp - halfZs)*dot(jump, n);
        vectorLanes dissipative;
        for (int i = 0; i < D; ++i)
        {
            dissipative[i] = waveC*(halfZs*jump[i] + jumpN*n[i]);
            if constexpr (full)
            {
                vAvg[i] += vCorrection[i];
                dissipative[i] += tCorrection[i];
            }
        }

        // Dissipation of J (63c), (64)
        const lanes fluxJ =
            nSJ == 1 ? perZp*cc*perWave*jumpSJ : lanes{};

        for (int i = 0; i < D; ++i) flux.set(i, t[i] + dissipative[i]);
        if constexpr (nSJ == 1) flux.set(D, fluxJ);
        flux.set(atWave, waveC);
        if constexpr (full)
        {
            // Velocity of the kinematic fluxes (63a)
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    flux.set(atRateF + i*D + j, vAvg[i]*area[j]);
                }
            }
        }

        // Discrete energy equation of the edge, what its fluxes take from the
        // two nodes beyond the telescoping part (68), (72):
        //   va.Pa C - vb.Pb C - (va - vb).t - vAvg.(Pa - Pb) C,
        // in which the means of the nodes cancel
        if constexpr (energy)
        {
            lanes power = fluxJ*differenceSJ;
            for (int i = 0; i < D; ++i)
            {
                power += difference[i]*dissipative[i];
                if constexpr (full) power += vCorrection[i]*tDifference[i];
            }
            for (int l = 0; l < some; ++l) dissipation += power[l];
        }

        // To the nodes; the waves add up at both
        constexpr int wR = strideWidth(sRates);
        constexpr int nRates = atRateF + (full ? nP : 0);
        for (int k = nRates; k < sRates; ++k) flux.set(k, lanes{});
        flux.toRows();
        for (int l = 0; l < some; ++l)
        {
            scalar* ra = rates + ends[2*l]*sRates;
            scalar* rb = rates + ends[2*l + 1]*sRates;
            const scalar* f = flux[l];
            for (int k = 0; k < sRates; k += wR)
            {
                rowAt<wR>(ra + k) += rowAt<wR>(f + k);
                rowAt<wR>(rb + k) -= rowAt<wR>(f + k);
            }
            rb[atWave] += 2*f[atWave];
        }
    }

    if constexpr (energy)
    {
        d.numericalDissipation += dissipation;
    }
}

} // End namespace Foam


// ************************************************************************* //
