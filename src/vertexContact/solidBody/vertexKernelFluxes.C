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
#include "acousticDissipation.H"
#include "edgeRows.H"
#include "vectorLimiter.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

template<int D, int nSJ, reconstructionType R, bool finite>
template<limiterType limiter, bool energy>
void vertexKernelTemplate<D, nSJ, R, finite>::fluxLoop(vertexData& d) const
{
    typedef SolidVector<D, lanes> vectorLanes;
    typedef std::ptrdiff_t index;

    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* edgeArea = d.edgeArea();
    const scalar* X = d.dual.nodePosition().cdata();
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* W = d.W.cdata();
    const scalar* grad = d.grad.cdata();
    const scalar* F = d.state.F.cdata();
    const scalar* H = d.state.H.cdata();
    const scalar* factor =
        d.waveFactor.size() ? d.waveFactor.cdata() : nullptr;
    scalar* rates = d.rates.data();

    const label nEdges = d.dual.nEdges();
    const scalar halfZp = 0.5*d.dissipation*d.rho*d.cp;
    const scalar halfZs = 0.5*d.dissipation*d.rho*d.cs;
    const scalar perZp = 0.5/(d.rho*d.cp);
    scalar dissipation = 0;

    // Rows of an edge: components of v and SigmaJ, of a column, of gradients
    constexpr int wU = rowWidth(D + nSJ);
    constexpr int wC = rowWidth(D);
    constexpr int wG = strideWidth(sG);
    constexpr int nU = paddedStride(D + nSJ);
    constexpr int nC = paddedStride(D);

    // Places of what an edge has of its nodes: area, twice the deformed area
    // (2D: sum of F), difference and sum of v and SigmaJ, and of the tractions
    // (the sum: twice the average), twice the changes of both nodes to mid-edge
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

    // What the first node gains, the other one loses; waves add up at both
    constexpr int wR = strideWidth(sRates);
    alignas(registerBytes) scalar sign[sRates];
    for (int k = 0; k < sRates; ++k) sign[k] = (k == atWave ? 1 : -1);

    // Rates of the first node of the edges, which are sorted by it: complete
    // with the last of its edges, since those to nodes before it came before.
    // Then they are divided by the volume, waves are not
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
        // Nodes between have no edges that start there
        while (nodeA < a)
        {
            if (nodeA >= 0) finish();
            if (nodeA + 1 == d.nNodes()) break;
            load(nodeA + 1);
        }
    };

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

        // Nodes that edges come to soon, and for the first time, are not in
        // the cache
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

            // Sums over the columns of P, and of H
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

        const auto changeA = [&](const int k)
        {
            return 0.5*of.lane(atChangeA + k);
        };
        const auto changeB = [&](const int k)
        {
            return 0.5*of.lane(atChangeB + k);
        };

        // Direction of the waves (65)
        vectorLanes area, c, n;
        for (int i = 0; i < D; ++i) area[i] = of.lane(atArea + i);
        if constexpr (finite && D == 3)
        {
            for (int i = 0; i < D; ++i) c[i] = 0.5*of.lane(atDeformed + i);
        }
        else if constexpr (finite && D == 2)
        {
            lanes F[4];
            for (int k = 0; k < 4; ++k) F[k] = 0.5*of.lane(atDeformed + k);
            planeArea(F, area[0], area[1], c.v);
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
        lanes perWave = inverseSquareRoot(larger + VSMALL);
        lanes waveC = larger*perWave;
        if (factor)
        {
            lanes faster{};
            for (int l = 0; l < nLanes; ++l)
            {
                faster[l] = max(factor[ends[2*l]], factor[ends[2*l + 1]]);
            }
            waveC *= faster;
            perWave *= reciprocal(faster);
        }

        // States at both sides of mid-edge: jump and average of the velocity,
        // average of the traction; with the differences of the nodes, first
        vectorLanes difference, jump, vAvg, t, tDifference;
        for (int i = 0; i < D; ++i)
        {
            difference[i] = jump[i] = of.lane(atDifference + i);
            t[i] = 0.5*of.lane(atT + i);
            if constexpr (full)
            {
                vAvg[i] = 0.5*of.lane(atSum + i);
                tDifference[i] = of.lane(atTDifference + i);
            }
        }
        const lanes differenceSJ =
            nSJ == 1 ? of.lane(atDifference + D) : lanes{};
        lanes jumpSJ = differenceSJ;

        // Corrections of the averages: half of what the limited changes of both
        // sides differ
        vectorLanes vCorrection, tCorrection;

        if constexpr (!none)
        {
            vectorLanes da, db;
            for (int i = 0; i < D; ++i)
            {
                da[i] = changeA(i);
                db[i] = changeB(i);
            }
            if constexpr (full)
            {
                slopeLimiter::limitVectors<limiter>(n, difference, da, db);
                for (int i = 0; i < D; ++i)
                {
                    jump[i] -= da[i] + db[i];
                    vCorrection[i] = 0.5*(da[i] - db[i]);
                    vAvg[i] += vCorrection[i];
                }
            }
            else
            {
                jump = slopeLimiter::dissipativeJump<limiter>
                (
                    n, difference, da, db
                );
            }

            if constexpr (nSJ == 1)
            {
                jumpSJ -=
                    slopeLimiter::limited<limiter, lanes>
                    (
                        changeA(D), differenceSJ
                    )
                  + slopeLimiter::limited<limiter, lanes>
                    (
                        changeB(D), differenceSJ
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
                        da[i] += changeA(k)*area[j];
                        db[i] += changeB(k)*area[j];
                    }
                }
                slopeLimiter::limitVectors<limiter>(n, tDifference, da, db);
                for (int i = 0; i < D; ++i)
                {
                    tCorrection[i] = 0.5*(da[i] - db[i]);
                }
            }
        }

        // Traction, contact-stick condition (34a): average of the stress and
        // acoustic dissipation of the velocity jump, times area
        vectorLanes dissipative;
        acousticDissipation<D, lanes>
        (
            jump.v, n.v, uniform<lanes>(1), waveC, halfZp, halfZs,
            dissipative.v
        );
        for (int i = 0; full && i < D; ++i) dissipative[i] += tCorrection[i];

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

        // To the nodes
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
    finishUpTo(d.nNodes());

    if constexpr (energy)
    {
        d.numericalDissipation += dissipation;
    }
}

} // End namespace Foam


// ************************************************************************* //
