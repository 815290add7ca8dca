/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "cornerStates.H"
#include "vertexKernel.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

namespace Foam
{

template<int D, bool finite>
inline SolidVector<D> variationalKernelTemplate<D, finite>::waveArea
(
    const conservedState& s,
    const label a,
    const label b,
    const scalar* C
)
{
    SolidVector<D> c;
    if constexpr (!finite || D == 1)
    {
        // In uniaxial strain the cofactor is 1
        for (int i = 0; i < D; ++i) c[i] = C[i];
    }
    else if constexpr (D == 2)
    {
        // The in-plane cofactor is a permutation of F
        const scalar* Fa = s.F.cdata() + 4*a;
        const scalar* Fb = s.F.cdata() + 4*b;
        c[0] = 0.5*((Fa[3] + Fb[3])*C[0] - (Fa[2] + Fb[2])*C[1]);
        c[1] = 0.5*((Fa[0] + Fb[0])*C[1] - (Fa[1] + Fb[1])*C[0]);
    }
    else
    {
        const scalar* Ha = s.H.cdata() + 9*a;
        const scalar* Hb = s.H.cdata() + 9*b;
        for (int i = 0; i < 3; ++i)
        {
            c[i] = 0;
            for (int j = 0; j < 3; ++j)
            {
                c[i] += 0.5*(Ha[3*j + i] + Hb[3*j + i])*C[j];
            }
        }
    }
    return c;
}


template<int D, bool finite>
inline variationalKernelTemplate<D, finite>::edgeMotion::edgeMotion
(
    const scalar* Xa,
    const scalar* Xb,
    const scalar* Ua,
    const scalar* Ub,
    const scalar* La,
    const scalar* Lb
)
{
    for (int i = 0; i < D; ++i)
    {
        dx[i] = Xb[i] - Xa[i];
        if (finite) dx[i] += Ub[i] - Ua[i];
    }

    scalar xx = 0, along = 0, jumpAlong = 0;
    for (int i = 0; i < D; ++i)
    {
        scalar change = 0;
        for (int j = 0; j < D; ++j)
        {
            change += 0.5*(La[j*sU + i] + Lb[j*sU + i])*dx[j];
        }
        jump[i] = Ub[D + i] - Ua[D + i] - change;
        xx += dx[i]*dx[i];
        along += change*dx[i];
        jumpAlong += jump[i]*dx[i];
    }
    perLength2 = 1/xx;
    stretching = along*perLength2;
    closing = -(along + jumpAlong)*perLength2;
    jj = jumpAlong*jumpAlong*perLength2;
    mm = along*along*perLength2;
}


template<int D, bool finite>
inline void variationalKernelTemplate<D, finite>::positionJump
(
    const scalar* U,
    const scalar* grad,
    const label a,
    const label b,
    const scalar* r,
    scalar* jump
)
{
    for (int i = 0; i < D; ++i) jump[i] = U[b*sU + i] - U[a*sU + i];
    for (int j = 0; j < D; ++j)
    {
        const scalar* ga = grad + (a*D + j)*sU;
        const scalar* gb = grad + (b*D + j)*sU;
        for (int i = 0; i < D; ++i) jump[i] -= 0.5*(ga[i] + gb[i])*r[j];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int D, bool finite>
void variationalKernelTemplate<D, finite>::collect
(
    vertexData& d,
    variationalData& x
) const
{
    const label n = d.nNodes();
    const scalar perRho = 1/d.rho;
    const scalar* lm = d.state.lm.cdata();
    const scalar* disp = d.state.disp.cdata();
    scalar* W = d.W.data();
    scalar* U = x.U.data();

    for (label a = 0; a < n; ++a)
    {
        for (int i = 0; i < D; ++i)
        {
            const scalar v = perRho*lm[a*D + i];
            U[a*sU + i] = disp[a*D + i];
            U[a*sU + D + i] = v;
            W[a*d.strideW + i] = v;
        }
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::gradients
(
    variationalData& x,
    const vertexData& d
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* area = d.edgeArea();
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* U = x.U.cdata();
    const label nEdges = d.dual.nEdges();

    x.grad = Zero;
    scalar* grad = x.grad.data();

    const label nPairs = x.pairNodes.size()/2;
    for (label p = 0; p < nPairs; ++p)
    {
        const label a = x.pairNodes[2*p], b = x.pairNodes[2*p + 1];
        const scalar* B = x.pairArea.cdata() + D*p;
        for (int k = 0; k < sU; k += wU)
        {
            const row<wU> change =
                rowAt<wU>(U + b*sU + k) - rowAt<wU>(U + a*sU + k);
            for (int j = 0; j < D; ++j)
            {
                rowAt<wU>(grad + (a*D + j)*sU + k) += change*B[j];
                rowAt<wU>(grad + (b*D + j)*sU + k) -= change*B[j];
            }
        }
    }

    // Edges are sorted by their first node: with the last of its own, all edges
    // of a node are done
    label e = 0, farthest = -1;
    for (label a = 0; a < d.nNodes(); ++a)
    {
        scalar* ga = grad + a*sU*D;
        row<wU> Ua[sU/wU], sumA[D*sU/wU];
        for (int k = 0; k < sU/wU; ++k) Ua[k] = rowAt<wU>(U + a*sU + k*wU);
        for (int k = 0; k < D*sU/wU; ++k) sumA[k] = rowAt<wU>(ga + k*wU);

        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            const label soon =
                edge[2*min(e + prefetchDistance, nEdges - 1) + 1];
            if (soon > farthest)
            {
                farthest = soon;
                prefetch<sU>(U + soon*sU);
                prefetch<sU*D>(grad + soon*sU*D);
            }

            const label b = edge[2*e + 1];
            scalar* gb = grad + b*sU*D;
            for (int k = 0; k < sU/wU; ++k)
            {
                const row<wU> half =
                    0.5*(rowAt<wU>(U + b*sU + k*wU) - Ua[k]);
                for (int j = 0; j < D; ++j)
                {
                    const row<wU> f = half*area[D*e + j];
                    sumA[j*sU/wU + k] += f;
                    rowAt<wU>(gb + j*sU + k*wU) += f;
                }
            }
        }

        const scalar perV = 1/V[a];
        for (int k = 0; k < D*sU/wU; ++k) rowAt<wU>(ga + k*wU) = sumA[k]*perV;
    }
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::deform
(
    variationalData& x,
    const vertexData& d
) const
{
    if constexpr (!finite)
    {
        return 0;
    }
    label nBad = 0;
    for (label a = 0; a < d.nNodes(); ++a)
    {
        scalar* g = x.grad.data() + a*sU*D;
        SolidTensor<D> F;
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                F(i, j) = (i == j ? 1 : 0) + g[j*sU + i];
            }
        }
        F.out = 1;
        const SolidTensor<D> H = cofactor(F);
        const scalar det = determinant(F, H);
        if (!(det > 0)) ++nBad;
        const scalar perDet = 1/det;
        scalar* inverse = x.inverse.data() + a*nP;
        scalar L[nP];
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j) inverse[i*D + j] = perDet*H(j, i);
        }
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                scalar sum = 0;
                for (int k = 0; k < D; ++k)
                {
                    sum += g[k*sU + D + i]*inverse[k*D + j];
                }
                L[i*D + j] = sum;
            }
        }
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j) g[j*sU + D + i] = L[i*D + j];
        }
    }
    return nBad;
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::correct
(
    variationalData& x,
    const vertexData& d
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* area = d.edgeArea();
    const scalar* X = d.dual.nodePosition().cdata();
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* grad = x.grad.cdata();
    const label nEdges = d.dual.nEdges();
    const scalar* U = x.U.cdata();
    const scalar half = 0.5*x.beta;
    const bool corrects = x.beta > 0;

    x.correction = Zero;
    x.roughness = Zero;
    scalar closing = 0;
    scalar* correction = x.correction.data();
    scalar* rough = x.roughness.data();
    const scalar* rush = x.acceleration.cdata();

    label e = 0, farthest = -1;
    for (label a = 0; a < d.nNodes(); ++a)
    {
        const scalar* ga = grad + a*sU*D;
        row<wC> Ga[D] = {}, sumA[D] = {};
        if (corrects)
        {
            for (int j = 0; j < D; ++j)
            {
                Ga[j] = rowAt<wC>(ga + j*sU);
                sumA[j] = rowAt<wC>(correction + a*sT + j*sC);
            }
        }
        for (; e < nEdges && edge[2*e] == a; ++e)
        {
            const label soon =
                edge[2*min(e + prefetchDistance, nEdges - 1) + 1];
            if (soon > farthest)
            {
                farthest = soon;
                prefetch<sU>(U + soon*sU);
                prefetch<sU*D>(grad + soon*sU*D);
                if (corrects) prefetch<sT>(correction + soon*sT);
            }

            const label b = edge[2*e + 1];
            const scalar* gb = grad + b*sU*D;
            const edgeMotion m
            (
                X + a*D, X + b*D, U + a*sU, U + b*sU, ga + D, gb + D
            );
            closing = max(closing, m.closing);
            scalar squares[nS] = {m.jj, m.mm};
            if constexpr (nS > 2)
            {
                scalar hastening = 0;
                for (int i = 0; i < D; ++i)
                {
                    hastening += (rush[b*D + i] - rush[a*D + i])*m.dx[i];
                }
                squares[2] = hastening*hastening;
            }
            for (int k = 0; k < nS; ++k)
            {
                rough[nS*a + k] += squares[k];
                rough[nS*b + k] += squares[k];
            }
            if (!corrects) continue;

            row<wC> change{};
            for (int j = 0; j < D; ++j)
            {
                change +=
                    (Ga[j] - rowAt<wC>(gb + j*sU))
                   *(half*(X[b*D + j] - X[a*D + j]));
            }
            for (int j = 0; j < D; ++j)
            {
                const row<wC> f = change*area[D*e + j];
                sumA[j] += f;
                rowAt<wC>(correction + b*sT + j*sC) -= f;
            }
        }
        if (corrects)
        {
            const scalar perV = 1/V[a];
            for (int j = 0; j < D; ++j)
            {
                rowAt<wC>(correction + a*sT + j*sC) = sumA[j]*perV;
            }
        }
    }
    x.closing = closing;
}


template<int D, bool finite>
label variationalKernelTemplate<D, finite>::kinematics
(
    vertexData& d,
    variationalData& x
) const
{
    label nBad = 0;
    scalar* F = d.state.F.data();
    for (label a = 0; a < d.nNodes(); ++a)
    {
        const scalar* g = x.grad.cdata() + a*sU*D;
        const scalar* c = x.correction.cdata() + a*sT;
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                scalar sum = g[j*sU + i];
                if (x.beta > 0) sum += c[j*sC + i];
                F[a*nP + i*D + j] = (i == j ? 1 : 0) + sum;
            }
        }

        bool good = true;
        if constexpr (finite)
        {
            const SolidTensor<D> f = loadF<D>(F, a);
            const SolidTensor<D> H = cofactor(f);
            const scalar J = determinant(f, H);
            good = J > 0;
            if constexpr (D == 3)
            {
                for (int k = 0; k < 9; ++k)
                {
                    d.state.H[9*a + placeH(k)] = H.in[k];
                }
            }
            if (x.smoothed) x.jacobian[a] = J;
        }
        else
        {
            for (int k = 0; k < nP; ++k)
            {
                good = good && mag(F[a*nP + k]) < largestLinearF;
            }
        }
        if (!good) ++nBad;
    }
    return nBad;
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::smooth
(
    variationalData& x,
    const vertexData& d
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* area = d.edgeArea();
    const scalar* X = d.dual.nodePosition().cdata();
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* J = x.jacobian.cdata();
    scalar* average = x.average.data();
    constexpr scalar share = 0.5/(D + 1);

    x.average = Zero;
    for (label e = 0; e < d.dual.nEdges(); ++e)
    {
        const label a = edge[2*e], b = edge[2*e + 1];
        scalar k = 0;
        for (int j = 0; j < D; ++j)
        {
            k += area[D*e + j]*(X[b*D + j] - X[a*D + j]);
        }
        const scalar f = share*k*(J[b] - J[a]);
        average[a] += f;
        average[b] -= f;
    }
    for (label a = 0; a < d.nNodes(); ++a) average[a] /= V[a];
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::addPressure
(
    vertexData& d,
    const variationalData& x
) const
{
    for (label a = 0; a < d.nNodes(); ++a)
    {
        scalar* W = d.W.data() + a*d.strideW;
        const scalar more = x.jacobian[a] - W[D];
        const SolidTensor<D> H =
            cofactor(loadF<D>(d.state.F.cdata(), a));
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j)
            {
                W[d.offsetP() + j*D + i] += more*H(i, j);
            }
        }
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::fluxes
(
    vertexData& d,
    variationalData& x
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* area = d.edgeArea();
    const scalar* X = d.dual.nodePosition().cdata();
    const scalar* U = x.U.cdata();
    const scalar* grad = x.grad.cdata();
    const scalar* factor =
        d.waveFactor.size() ? d.waveFactor.cdata() : nullptr;
    const scalar* P = d.W.cdata() + d.offsetP();
    const label sW = d.strideW;
    const label sR = d.strideRates;
    const scalar halfBeta = 0.5*x.beta;
    const scalar halfZp = 0.5*d.rho*d.cp;
    const scalar halfZs = 0.5*d.rho*d.cs;
    const scalar* rough = x.roughness.cdata();
    const scalar* perEdges = x.perEdges.cdata();
    const scalar* stiffness = x.jumpStiffness.cdata();
    const label nEdges = d.dual.nEdges();

    d.rates = Zero;
    x.adjoint = Zero;
    const bool accounts = x.dissipative.size();
    if (accounts) x.dissipative = Zero;
    scalar* rates = d.rates.data();
    scalar* adjoint = x.adjoint.data();

    label farthest = -1;
    for (label e = 0; e < nEdges; ++e)
    {
        const label soon = edge[2*min(e + prefetchDistance, nEdges - 1) + 1];
        if (soon > farthest)
        {
            farthest = soon;
            prefetch<sU>(U + soon*sU);
            prefetch<sU*D>(grad + soon*sU*D);
            prefetch<nP>(P + soon*sW);
            prefetch<2*sT>(adjoint + soon*2*sT);
        }

        const label a = edge[2*e], b = edge[2*e + 1];
        const scalar* C = area + D*e;
        scalar* Xa = adjoint + a*2*sT;
        scalar* Xb = adjoint + b*2*sT;

        // Force of the jump of the positions, and its adjoint
        scalar apart[D], r[D];
        for (int j = 0; j < D; ++j) r[j] = X[b*D + j] - X[a*D + j];
        positionJump(U, grad, a, b, r, apart);
        for (int i = 0; i < D; ++i)
        {
            const scalar s = stiffness[e]*apart[i];
            rates[a*sR + i] += s;
            rates[b*sR + i] -= s;
            if (accounts)
            {
                x.dissipative[a*D + i] -= s;
                x.dissipative[b*D + i] += s;
            }
            for (int j = 0; j < D; ++j)
            {
                Xa[j*sC + i] -= 0.5*s*r[j];
                Xb[j*sC + i] -= 0.5*s*r[j];
            }
        }

        // Adjoint of the corrections
        if (halfBeta > 0)
        {
            scalar f[D];
            for (int i = 0; i < D; ++i) f[i] = 0;
            for (int j = 0; j < D; ++j)
            {
                for (int i = 0; i < D; ++i)
                {
                    f[i] += (P[a*sW + j*D + i] - P[b*sW + j*D + i])*C[j];
                }
            }
            for (int j = 0; j < D; ++j)
            {
                const scalar rj = halfBeta*r[j];
                for (int i = 0; i < D; ++i)
                {
                    Xa[j*sC + i] += f[i]*rj;
                    Xb[j*sC + i] -= f[i]*rj;
                }
            }
        }

        const edgeMotion m
        (
            X + a*D, X + b*D, U + a*sU, U + b*sU,
            grad + a*sU*D + D, grad + b*sU*D + D
        );
        const scalar* dx = m.dx;
        scalar fast;
        const scalar leftOut = jumpSensor::leftOut<D>
        (
            rough + nS*a, perEdges[a], rough + nS*b, perEdges[b], d.cp, fast
        );
        const scalar share = x.epsilon + (1 - x.epsilon)*leftOut;
        scalar jump[D];
        for (int i = 0; i < D; ++i)
        {
            jump[i] = m.jump[i] + leftOut*m.stretching*dx[i];
        }

        // Differences of the rate of the volume
        if (x.volumeImpedance > 0)
        {
            scalar Cr = 0, rr = 0, difference = 0;
            for (int j = 0; j < D; ++j)
            {
                Cr += C[j]*r[j];
                rr += r[j]*r[j];
                difference +=
                    grad[(a*D + j)*sU + D + j] - grad[(b*D + j)*sU + D + j];
            }
            const scalar q =
                0.25*fast*x.volumeImpedance*Cr*std::sqrt(rr)/(D + 1)
               *difference;
            for (int j = 0; j < D; ++j)
            {
                Xa[sT + j*sC + j] += q;
                Xb[sT + j*sC + j] -= q;
            }
        }

        // Waves, along and across their direction (34a), (65)
        const SolidVector<D> c = waveArea(d.state, a, b, C);
        scalar cc = 0, CC = 0, jc = 0;
        for (int i = 0; i < D; ++i)
        {
            cc += c[i]*c[i];
            CC += C[i]*C[i];
            jc += jump[i]*c[i];
        }
        scalar wave = std::sqrt(finite && D > 1 ? max(cc, CC) : cc);
        if (factor) wave *= max(factor[a], factor[b]);

        // Of the full dissipation, what it would damp: for the step
        const scalar perCC = 1/(cc + VSMALL);
        for (int i = 0, k = D; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k)
            {
                const scalar z =
                    wave
                   *(
                        (d.cp - d.cs)*c[i]*c[j]*perCC + (i == j ? d.cs : 0)
                    );
                rates[a*sR + k] += z;
                rates[b*sR + k] += z;
            }
        }
        wave *= share;
        const scalar along = (halfZp - halfZs)*jc*perCC;

        scalar s[D];
        for (int i = 0; i < D; ++i)
        {
            s[i] = wave*(halfZs*jump[i] + along*c[i]);
            rates[a*sR + i] += s[i];
            rates[b*sR + i] -= s[i];
        }

        // Adjoint of the jump
        scalar sx = 0;
        for (int i = 0; i < D; ++i) sx += s[i]*dx[i];
        const scalar left = leftOut*sx*m.perLength2;
        for (int i = 0; i < D; ++i)
        {
            const scalar zi = -0.5*(s[i] - left*dx[i]);
            for (int j = 0; j < D; ++j)
            {
                Xa[sT + j*sC + i] += zi*dx[j];
                Xb[sT + j*sC + i] += zi*dx[j];
            }
        }
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::collectAdjoint
(
    variationalData& x,
    const vertexData& d
) const
{
    for (label a = 0; a < d.nNodes(); ++a)
    {
        scalar* A = x.adjoint.data() + a*2*sT;
        scalar* Z = A + sT;
        if constexpr (finite)
        {
            // Z (G x)^-T
            const scalar* inverse = x.inverse.cdata() + a*nP;
            scalar old[D][D];
            for (int j = 0; j < D; ++j)
            {
                for (int i = 0; i < D; ++i) old[i][j] = Z[j*sC + i];
            }
            for (int j = 0; j < D; ++j)
            {
                for (int i = 0; i < D; ++i)
                {
                    scalar sum = 0;
                    for (int k = 0; k < D; ++k)
                    {
                        sum += old[i][k]*inverse[j*D + k];
                    }
                    Z[j*sC + i] = sum;
                }
            }
        }
        for (int k = 0; k < sT; ++k) A[k] += Z[k];
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::stresses
(
    variationalData& x,
    const vertexData& d
) const
{
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* P = d.W.cdata() + d.offsetP();
    for (label a = 0; a < d.nNodes(); ++a)
    {
        const scalar perV = 1/V[a];
        const scalar* A = x.adjoint.cdata() + a*2*sT;
        scalar* T = x.T.data() + a*sT;
        for (int j = 0; j < D; ++j)
        {
            for (int i = 0; i < D; ++i)
            {
                T[j*sC + i] =
                    P[a*d.strideW + j*D + i] + perV*A[j*sC + i];
            }
        }
    }
}


template<int D, bool finite>
template<int parts>
void variationalKernelTemplate<D, finite>::forceLoop
(
    vertexData& d,
    variationalData& x
)
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* area = d.edgeArea();
    const scalar* V = d.dual.nodeVolume().cdata();
    const scalar* T = x.T.cdata();
    const scalar* A = x.adjoint.cdata();
    const label nEdges = d.dual.nEdges();
    const label sR = d.strideRates;
    scalar* rates = d.rates.data();
    scalar* part = x.dissipative.data();

    // The dissipative part of T, times the volume
    const auto partOf = [&](const label a, const int j, const int i)
    {
        return A[a*2*sT + sT + j*sC + i]/V[a];
    };

    if constexpr (parts == 2)
    {
        for (label a = 0; a < d.nNodes(); ++a)
        {
            for (int i = 0; i < D; ++i) part[a*D + i] += rates[a*sR + i];
        }
    }

    for (label e = 0; e < nEdges; ++e)
    {
        const label a = edge[2*e], b = edge[2*e + 1];
        const scalar* C = area + D*e;
        row<wC> f{};
        for (int j = 0; j < D; ++j)
        {
            f +=
                (rowAt<wC>(T + a*sT + j*sC) + rowAt<wC>(T + b*sT + j*sC))
               *(0.5*C[j]);
        }
        scalar force[wC];
        rowAt<wC>(force) = f;
        for (int i = 0; i < D; ++i)
        {
            rates[a*sR + i] += force[i];
            rates[b*sR + i] -= force[i];
        }
        if constexpr (parts == 2)
        {
            for (int i = 0; i < D; ++i)
            {
                scalar sum = 0;
                for (int j = 0; j < D; ++j)
                {
                    sum += 0.5*C[j]*(partOf(a, j, i) + partOf(b, j, i));
                }
                part[a*D + i] += sum;
                part[b*D + i] -= sum;
            }
        }
    }

    const label nPairs = x.pairNodes.size()/2;
    for (label p = 0; p < nPairs; ++p)
    {
        const label a = x.pairNodes[2*p], b = x.pairNodes[2*p + 1];
        const scalar* B = x.pairArea.cdata() + D*p;
        for (int i = 0; i < D; ++i)
        {
            scalar sum = 0, sumPart = 0;
            for (int j = 0; j < D; ++j)
            {
                sum += B[j]*(T[a*sT + j*sC + i] - T[b*sT + j*sC + i]);
                if constexpr (parts == 2)
                {
                    sumPart += B[j]*(partOf(a, j, i) - partOf(b, j, i));
                }
            }
            rates[a*sR + i] += sum;
            rates[b*sR + i] -= sum;
            if constexpr (parts == 2)
            {
                part[a*D + i] += sumPart;
                part[b*D + i] -= sumPart;
            }
        }
    }

    for (label a = 0; a < d.nNodes(); ++a)
    {
        const scalar perV = 1/V[a];
        for (int i = 0; i < D; ++i)
        {
            rates[a*sR + i] *= perV;
            if constexpr (parts == 2) part[a*D + i] *= perV;
        }
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::forces
(
    vertexData& d,
    variationalData& x,
    const bool energy
) const
{
    energy ? forceLoop<2>(d, x) : forceLoop<1>(d, x);
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::jumpEnergy
(
    const vertexData& d,
    const variationalData& x
) const
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* X = d.dual.nodePosition().cdata();
    scalar energy = 0;
    for (label e = 0; e < d.dual.nEdges(); ++e)
    {
        const label a = edge[2*e], b = edge[2*e + 1];
        scalar jump[D], r[D];
        for (int j = 0; j < D; ++j) r[j] = X[b*D + j] - X[a*D + j];
        positionJump(x.U.cdata(), x.grad.cdata(), a, b, r, jump);
        for (int i = 0; i < D; ++i)
        {
            energy += 0.5*x.jumpStiffness[e]*jump[i]*jump[i];
        }
    }
    return energy;
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::addTractions
(
    const vertexData& d,
    const dualPatch& patch,
    const cornerStates& c,
    scalarField& force
) const
{
    const FixedList<label, 3>& dir = d.dual.directions();
    const scalar* V = d.dual.nodeVolume().cdata();
    for (label f = 0; f < patch.nFaces(); ++f)
    {
        const label start = patch.faceStart[f];
        const label nf = patch.faceStart[f + 1] - start;
        const scalar* s = patch.weights.cdata() + patch.weightStart[f];
        for (label p = 0; p < nf; ++p)
        {
            const label a = patch.cornerNode[start + p];
            vector sum(c.force[start + p]);
            for (label j = 0; j < nf; ++j)
            {
                sum += s[p*nf + j]*c.tB[start + j];
            }
            for (int i = 0; i < D; ++i) force[a*D + i] += sum[dir[i]]/V[a];
        }
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::corners
(
    const vertexData& d,
    cornerStates& c
) const
{
    const dualPatch& g = c.geometry;
    const FixedList<label, 3>& dir = d.dual.directions();
    const scalar* P = d.W.cdata() + d.offsetP();

    for (label k = 0; k < g.nCorners(); ++k)
    {
        const label a = g.cornerNode[k];
        const scalar* N = g.cornerNormal.cdata() + D*k;
        const SolidVector<D> h = waveArea(d.state, a, a, N);
        const scalar magH = std::sqrt(dot(h, h));

        for (int i = 0; i < D; ++i)
        {
            scalar PN = 0;
            for (int j = 0; j < D; ++j) PN += P[a*d.strideW + j*D + i]*N[j];
            c.v[k][dir[i]] = d.W[a*d.strideW + i];
            c.t[k][dir[i]] = PN;
            c.n[k][dir[i]] = h[i]/magH;
        }
        c.stretch[k] = magH;
        if (d.waveFactor.size()) c.waveFactor[k] = d.waveFactor[a];
        c.force[k] = vector::zero;
    }
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::largestOf
(
    const scalar trace,
    const scalar square
)
{
    const scalar mean = trace/D;
    return mean + std::sqrt(max(scalar(0), (square/D - mean*mean)*(D - 1)));
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::squaredFrequency
(
    const vertexData& d,
    const variationalData& x,
    const label a
) const
{
    const scalar* K = x.geometricBound.cdata() + a*nK;
    scalar undeformed = 0, most = 0;
    for (int i = 0, k = 0; i < D; k += D - i, ++i) undeformed += K[k];
    most = undeformed;
    if constexpr (finite && D > 1)
    {
        // K : H^T H
        const SolidTensor<D> H = cofactor(loadF<D>(d.state.F.cdata(), a));
        scalar deformed = 0;
        for (int i = 0, k = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k)
            {
                scalar HH = 0;
                for (int m = 0; m < D; ++m) HH += H(m, i)*H(m, j);
                deformed += (i == j ? 1 : 2)*HH*K[k];
            }
        }
        most = max(most, deformed);
    }
    if (d.waveFactor.size()) most *= d.waveFactor[a]*d.waveFactor[a];
    return d.cp*d.cp*most;
}


template<int D, bool finite>
scalar variationalKernelTemplate<D, finite>::damping
(
    const vertexData& d,
    const label a
) const
{
    scalar trace = 0, square = 0;
    const scalar* z = d.rates.cdata() + a*d.strideRates + D;
    for (int i = 0, k = 0; i < D; ++i)
    {
        for (int j = i; j < D; ++j, ++k)
        {
            if (i == j) trace += z[k];
            square += (i == j ? 1 : 2)*z[k]*z[k];
        }
    }
    return largestOf(trace, square)/d.dual.nodeVolume()[a];
}


template<int D, bool finite>
template<class Function>
void variationalKernelTemplate<D, finite>::forWeights
(
    const vertexData& d,
    const variationalData& x,
    const Function& f
)
{
    const label* edge = d.dual.edgeNodes().cdata();
    const scalar* area = d.edgeArea();
    scalar g[D];
    for (label e = 0; e < d.dual.nEdges(); ++e)
    {
        for (int j = 0; j < D; ++j) g[j] = 0.5*area[D*e + j];
        f(edge[2*e], edge[2*e + 1], g);
        for (int j = 0; j < D; ++j) g[j] = -g[j];
        f(edge[2*e + 1], edge[2*e], g);
    }
    for (label p = 0; p < x.pairNodes.size()/2; ++p)
    {
        const scalar* B = x.pairArea.cdata() + D*p;
        f(x.pairNodes[2*p], x.pairNodes[2*p + 1], B);
        f(x.pairNodes[2*p + 1], x.pairNodes[2*p], B);
    }
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::boundColumns
(
    const vertexData& d,
    const variationalData& x,
    scalarField& sums
) const
{
    sums = Zero;
    forWeights(d, x, [&](const label a, const label b, const scalar* g)
    {
        scalar gg = 0;
        for (int j = 0; j < D; ++j)
        {
            sums[a*(D + 1) + j] -= g[j];
            gg += g[j]*g[j];
        }
        sums[b*(D + 1) + D] += std::sqrt(gg);
    });
}


template<int D, bool finite>
void variationalKernelTemplate<D, finite>::boundRows
(
    const vertexData& d,
    const variationalData& x,
    const scalarField& sums,
    scalarField& bound
) const
{
    const scalar* V = d.dual.nodeVolume().cdata();
    const auto& owned = d.dual.sharing().owned();
    bound = Zero;
    const auto add = [&](const label a, const label b, const scalar* g)
    {
        scalar gg = 0, ownB = 0;
        for (int j = 0; j < D; ++j)
        {
            gg += g[j]*g[j];
            ownB += sums[b*(D + 1) + j]*sums[b*(D + 1) + j];
        }
        if (gg < VSMALL) return;
        const scalar column = sums[b*(D + 1) + D] + std::sqrt(ownB);
        const scalar factor = column/(std::sqrt(gg)*V[a]*V[b]);
        for (int i = 0, k = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j, ++k)
            {
                bound[a*nK + k] += factor*g[i]*g[j];
            }
        }
    };
    forWeights(d, x, add);
    for (label a = 0; a < d.nNodes(); ++a)
    {
        if (owned[a]) add(a, a, sums.cdata() + a*(D + 1));
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

template<int D>
autoPtr<variationalKernel> newVariationalKernel(const vertexData& d)
{
    variationalKernel* k = nullptr;
    if (d.finiteStrain)
    {
        k = new variationalKernelTemplate<D, true>();
    }
    else
    {
        k = new variationalKernelTemplate<D, false>();
    }
    return autoPtr<variationalKernel>(k);
}

} // End namespace Foam


// ************************************************************************* //
