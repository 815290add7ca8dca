/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The pass over the edges that sums up the fluxes: nLanes edges at a time,
    gathered from their nodes, computed together, and added to their nodes one
    after the other, in the order of the edges.

\*---------------------------------------------------------------------------*/

#include "vertexKernelTemplate.H"
#include "vectorLimiter.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

//- Components of some edges, each as lanes
template<int n>
struct edgeLanes
{
    alignas(registerBytes) scalar of[n > 0 ? n : 1][nLanes];

    lanes operator[](const int k) const
    {
        lanes r;
        for (int l = 0; l < nLanes; ++l) r[l] = of[k][l];
        return r;
    }

    void set(const int k, const lanes& value)
    {
        for (int l = 0; l < nLanes; ++l) of[k][l] = value[l];
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
    scalar* rateLm = d.rateLm.data();
    scalar* rateF = d.rateF.data();
    scalar* rateJ = d.rateJ.data();
    scalar* waveSum = d.waveSum.data();

    const label nEdges = d.dual.nEdges();
    const scalar halfZp = 0.5*d.rho*d.cp;
    const scalar halfZs = 0.5*d.rho*d.cs;
    const scalar perZp = 0.5/(d.rho*d.cp);
    scalar dissipation = 0;

    for (label e0 = 0; e0 < nEdges; e0 += nLanes)
    {
        // What the edges need of their nodes; the last ones, if there are too
        // few, are those of the last edge
        edgeLanes<nW> Wa, Wb;
        edgeLanes<nR> changeA, changeB;
        edgeLanes<D> C, wave;

        for (int l = 0; l < nLanes; ++l)
        {
            const label e = min(e0 + l, nEdges - 1);
            const label a = edge[2*e], b = edge[2*e + 1];
            const SolidVector<D> Ce = SolidVector<D>::load(edgeArea + D*e);
            const SolidVector<D> ce = waveArea(d.state, a, b, Ce);
            for (int i = 0; i < D; ++i)
            {
                C.of[i][l] = Ce[i];
                wave.of[i][l] = ce[i];
            }
            const scalar* ofA = W + a*nW;
            const scalar* ofB = W + b*nW;
            for (int k = 0; k < nW; ++k)
            {
                Wa.of[k][l] = ofA[k];
                Wb.of[k][l] = ofB[k];
            }
            if constexpr (!none)
            {
                // Changes from both nodes to mid-edge
                SolidVector<D> r;
                for (int i = 0; i < D; ++i)
                {
                    r[i] = 0.5*(X[b*D + i] - X[a*D + i]);
                }
                const scalar* ga = grad + a*nR*D;
                const scalar* gb = grad + b*nR*D;
                for (int k = 0; k < nR; ++k)
                {
                    scalar sumA = ga[k*D]*r[0], sumB = gb[k*D]*r[0];
                    for (int i = 1; i < D; ++i)
                    {
                        sumA += ga[k*D + i]*r[i];
                        sumB += gb[k*D + i]*r[i];
                    }
                    changeA.of[k][l] = sumA;
                    changeB.of[k][l] = sumB;
                }
            }
        }

        // Direction of the waves (65)
        vectorLanes area, c, n;
        for (int i = 0; i < D; ++i)
        {
            area[i] = C[i];
            c[i] = wave[i];
        }
        const lanes cc = dot(c, c);
        const lanes magC = squareRoot(dot(area, area));
        const lanes magc = squareRoot(cc);
        const lanes perC = 1/(magc + VSMALL);
        for (int i = 0; i < D; ++i) n[i] = perC*c[i];

        // Waves cross the deformed area where that is larger: so do the
        // dissipation, which else lags behind the central fluxes (momentum)
        // or outruns the time step (J), and the step
        const lanes waveC = finite ? max(magc, magC) : magC;

        // States at both sides of mid-edge: jump and average of the velocity,
        // average of the traction; with the differences of the nodes, first
        vectorLanes difference, jump, vAvg, t, tDifference;
        for (int i = 0; i < D; ++i)
        {
            difference[i] = jump[i] = Wb[i] - Wa[i];
            vAvg[i] = 0.5*(Wa[i] + Wb[i]);
            t[i] = tDifference[i] = lanes{};
            for (int j = 0; j < D; ++j)
            {
                const lanes Pa = Wa[atP + i*D + j], Pb = Wb[atP + i*D + j];
                t[i] += 0.5*(Pa + Pb)*area[j];
                tDifference[i] += (Pb - Pa)*area[j];
            }
        }
        const lanes differenceSJ = nSJ == 1 ? Wb[D] - Wa[D] : lanes{};
        lanes jumpSJ = differenceSJ;

        // Corrections of the averages
        vectorLanes vCorrection, tCorrection;

        if constexpr (!none)
        {
            vectorLanes da, db;
            for (int i = 0; i < D; ++i)
            {
                da[i] = changeA[i];
                db[i] = changeB[i];
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
                        changeA[D], differenceSJ
                    )
                  + slopeLimiter::limited<limiter, lanes>
                    (
                        changeB[D], differenceSJ
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
                        const int k = atP + i*D + j;
                        da[i] += changeA[k]*area[j];
                        db[i] += changeB[k]*area[j];
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
            nSJ == 1 ? perZp*cc/(waveC + VSMALL)*jumpSJ : lanes{};

        edgeLanes<D> force;
        edgeLanes<D*D> velocity;
        edgeLanes<1> volume, speed, lost;
        for (int i = 0; i < D; ++i)
        {
            force.set(i, t[i] + dissipative[i]);

            // Velocity of the kinematic fluxes (63a)
            if constexpr (full)
            {
                for (int j = 0; j < D; ++j)
                {
                    velocity.set(i*D + j, vAvg[i]*area[j]);
                }
            }
        }
        if constexpr (nSJ == 1) volume.set(0, fluxJ);
        speed.set(0, waveC);

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
            lost.set(0, power);
        }

        // To the nodes
        const int some = min(label(nLanes), nEdges - e0);
        for (int l = 0; l < some; ++l)
        {
            const label a = edge[2*(e0 + l)], b = edge[2*(e0 + l) + 1];
            for (int i = 0; i < D; ++i)
            {
                rateLm[a*D + i] += force.of[i][l];
                rateLm[b*D + i] -= force.of[i][l];
            }
            if constexpr (full)
            {
                for (int k = 0; k < nP; ++k)
                {
                    rateF[a*nP + k] += velocity.of[k][l];
                    rateF[b*nP + k] -= velocity.of[k][l];
                }
            }
            if constexpr (nSJ == 1)
            {
                rateJ[a] += volume.of[0][l];
                rateJ[b] -= volume.of[0][l];
            }
            waveSum[a] += speed.of[0][l];
            waveSum[b] += speed.of[0][l];
            if constexpr (energy) dissipation += lost.of[0][l];
        }
    }

    if constexpr (energy)
    {
        d.numericalDissipation += dissipation;
    }
}

} // End namespace Foam


// ************************************************************************* //
