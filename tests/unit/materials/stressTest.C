/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Stress of all laws against the derivatives of their strain energy:
    equations (9)-(13) of the paper, in one, two and three dimensions.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "materialPoint.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

const label nSamples = 20;
const scalar tol = 1e-9;        // moduli of order 1, central differences

const char* const linear = "type linearElastic; rho 2; mu 1; lambda 2;";
const char* const neo = "type neoHookean; rho 2; mu 1; kappa 3;";
const char* const mooney = "type MooneyRivlin; rho 2; mu 1; kappa 3; xi 0.1;";

const kinematicSet allSets[] =
{
    kinematicSet::F, kinematicSet::FJ, kinematicSet::FHJ
};

const jacobianForm volumetric = jacobianForm::volumetric;
const jacobianForm literal = jacobianForm::literal;


template<class Check>
void forAllModels(const Check& check)
{
    for (const char* text : {linear, neo, mooney})
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(text, form));
            check(*model);
        }
    }
}


//- P = dW/dF where H and J are those of F
template<int D>
void totalDerivative(const materialModel& model)
{
    Random random(D);
    for (const kinematicSet set : allSets)
    {
        INFO("D = " << D << ", " << conservedState::kinematicSetNames[set]);
        for (label sample = 0; sample < nSamples; ++sample)
        {
            materialPoint<D> point(model, set);
            point.deform(randomTensor<D>(random, 1, 0.25));
            const auto P = point.stress();
            for (int k = 0; k < D*D; ++k)
            {
                CHECK
                (
                    mag(P.in[k] - point.derivative(point.s.F[k], true)) <= tol
                );
            }
        }
    }
}


//- P = Sigma_F + Sigma_H x F + Sigma_J H (10) where H and J are independent
//  of F, SigmaJ = dW/dJ (12)
template<int D>
void partialDerivatives(const materialModel& model)
{
    Random random(10 + D);
    for (const kinematicSet set : {kinematicSet::FJ, kinematicSet::FHJ})
    {
        INFO("D = " << D << ", " << conservedState::kinematicSetNames[set]);
        for (label sample = 0; sample < nSamples; ++sample)
        {
            materialPoint<D> point(model, set);
            conservedState& s = point.s;
            point.deform(randomTensor<D>(random, 1, 0.25));
            const auto F = point.Fnow();
            s.J[0] += randomScalar(random, 0.2);

            // In 2D the components of H in the plane are those of F
            SolidTensor<D> SigmaF, SigmaH, SigmaHxF;
            SigmaHxF = combine(0, F, 0, F);
            if (s.solvesH)
            {
                for (label k = 0; k < s.strideH; ++k)
                {
                    s.H[k] += randomScalar(random, 0.2);
                }

                SigmaH = combine(0, F, 0, F);
                for (label k = 0; k < s.strideH; ++k)
                {
                    (D == 3 ? SigmaH.in[k] : SigmaH.out) =
                        point.derivative(s.H[D == 3 ? placeH(k) : k]);
                }
                SigmaHxF = cross(SigmaH, F);
            }
            for (int k = 0; k < D*D; ++k)
            {
                // In 3D H is kept if it is not solved, too, as cof F
                SigmaF.in[k] = point.derivative(s.F[k], false);
                if (D == 3 && !s.solvesH)
                {
                    const scalar J = s.J[0], h = 1e-3, x = s.F[k];
                    const auto at = [&](const scalar value)
                    {
                        s.F[k] = value;
                        point.deform(point.Fnow());
                        s.J[0] = J;
                        return point.energy();
                    };
                    const scalar d1 = at(x + h) - at(x - h);
                    const scalar d2 = at(x + 2*h) - at(x - 2*h);
                    at(x);
                    SigmaF.in[k] = (8*d1 - d2)/(12*h);
                }
            }

            const scalar SigmaJ = point.SigmaJ();
            CHECK(mag(SigmaJ - point.derivative(s.J[0])) <= tol);

            const auto H = point.Hnow();
            const auto P = point.stress();
            for (int k = 0; k < D*D; ++k)
            {
                CHECK
                (
                    mag
                    (
                        P.in[k]
                      - (SigmaF.in[k] + SigmaHxF.in[k] + SigmaJ*H.in[k])
                    ) <= tol
                );
            }
        }
    }
}


//- Plane and uniaxial strain are three-dimensional states like any other
template<int D>
void embedded(const materialModel& model)
{
    Random random(20 + D);
    for (const kinematicSet set : allSets)
    {
        INFO("D = " << D << ", " << conservedState::kinematicSetNames[set]);
        for (label sample = 0; sample < nSamples; ++sample)
        {
            materialPoint<D> point(model, set);
            point.deform(randomTensor<D>(random, 1, 0.25));
            if (point.s.solvesJ) point.s.J[0] += randomScalar(random, 0.2);
            if (point.s.solvesH) point.s.H[0] += randomScalar(random, 0.2);

            materialPoint<3> full(model, set);
            const fullTensor F(point.Fnow()), H(point.Hnow());
            for (int i = 0; i < 3; ++i)
            {
                for (int j = 0; j < 3; ++j)
                {
                    full.s.F[3*i + j] = F.c[i][j];
                    if (full.s.strideH) full.s.H[3*j + i] = H.c[i][j];
                }
            }
            full.s.J = point.s.J;

            CHECK(mag(point.energy() - full.energy()) <= 1e-13);
            CHECK(maxDiff(point.Cauchy(), full.Cauchy()) <= 1e-13);

            const auto P = point.stress();
            const auto fullP = full.stress();
            for (int i = 0; i < 3; ++i)
            {
                for (int j = 0; j < 3; ++j)
                {
                    if (i < D && j < D)
                    {
                        CHECK(mag(P.in[i*D + j] - fullP.in[3*i + j]) <= 1e-13);
                    }
                    else if (i != j)
                    {
                        CHECK(mag(fullP.in[3*i + j]) <= 1e-13);
                    }
                }
            }
            if (point.s.solvesJ)
            {
                CHECK(mag(point.SigmaJ() - full.SigmaJ()) <= 1e-13);
            }
        }
    }
}


//- Neither energy nor stress without deformation, no stress that is not new
template<int D>
void undeformed(const materialModel& model)
{
    for (const kinematicSet set : allSets)
    {
        INFO("D = " << D << ", " << conservedState::kinematicSetNames[set]);
        const materialPoint<D> point(model, set);
        CHECK(mag(point.energy()) <= 1e-15);
        CHECK(maxDiff(fullTensor(point.stress()), fullTensor()) <= 1e-15);
        CHECK(maxDiff(point.Cauchy(), fullTensor()) <= 1e-15);
    }
}


//- Superposed rotations change neither energy nor SigmaJ, and turn the stress
template<int D>
void objective(const materialModel& model)
{
    Random random(30 + D);
    for (const kinematicSet set : allSets)
    {
        INFO("D = " << D << ", " << conservedState::kinematicSetNames[set]);
        for (label sample = 0; sample < nSamples; ++sample)
        {
            materialPoint<D> point(model, set), turned(model, set);
            point.deform(randomTensor<D>(random, 1, 0.25));
            if (point.s.solvesJ) point.s.J[0] += randomScalar(random, 0.2);
            if (point.s.solvesH)
            {
                for (scalar& h : point.s.H) h += randomScalar(random, 0.2);
            }

            const vector axis
            (
                D == 2 ? vector(0, 0, 1) : randomNormal(random)
            );
            const tensor Q(rotation(axis, randomScalar(random, 3)));
            turned.s = point.s;
            const auto turn = [&](const scalarField& from, scalarField& to)
            {
                for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j)
                {
                    to[i*D + j] = 0;
                    for (int k = 0; k < D; ++k)
                    {
                        to[i*D + j] += Q[3*i + k]*from[k*D + j];
                    }
                }
            };
            turn(point.s.F, turned.s.F);
            if (D == 3 && point.s.strideH)
            {
                const auto H = point.Hnow();
                scalarField H1(9), QH(9);
                for (int k = 0; k < 9; ++k) H1[k] = H.in[k];
                turn(H1, QH);
                for (int k = 0; k < 9; ++k) turned.s.H[placeH(k)] = QH[k];
            }

            CHECK(mag(turned.energy() - point.energy()) <= 1e-13);
            if (point.s.solvesJ)
            {
                CHECK(mag(turned.SigmaJ() - point.SigmaJ()) <= 1e-13);
            }

            const auto P = point.stress();
            scalarField QP(D*D), P1(D*D);
            for (int k = 0; k < D*D; ++k) P1[k] = P.in[k];
            turn(P1, QP);
            const auto turnedP = turned.stress();
            for (int k = 0; k < D*D; ++k)
            {
                CHECK(mag(turnedP.in[k] - QP[k]) <= 1e-13);
            }

            const fullTensor fullQ(Q), sigma(point.Cauchy());
            CHECK
            (
                maxDiff
                (
                    turned.Cauchy(),
                    dotTransposed
                    (
                        fullQ, dotTransposed(fullQ, sigma)
                    )
                ) <= 1e-13
            );
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("stress is the derivative of the energy", "[materials][serial]")
{
    forAllModels
    (
        [](const materialModel& model)
        {
            totalDerivative<1>(model);
            totalDerivative<2>(model);
            totalDerivative<3>(model);
        }
    );
}


TEST_CASE("stress with F, H and J apart (10)-(12)", "[materials][serial]")
{
    for (const char* text : {neo, mooney})
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(text, form));
            partialDerivatives<1>(*model);
            partialDerivatives<2>(*model);
            partialDerivatives<3>(*model);
        }
    }
}


TEST_CASE("plane and uniaxial strain", "[materials][serial]")
{
    forAllModels
    (
        [](const materialModel& model)
        {
            embedded<1>(model);
            embedded<2>(model);
        }
    );
}


TEST_CASE("undeformed: no energy, no stress", "[materials][serial]")
{
    forAllModels
    (
        [](const materialModel& model)
        {
            undeformed<1>(model);
            undeformed<2>(model);
            undeformed<3>(model);
        }
    );
}


TEST_CASE("finite strain laws are objective", "[materials][serial]")
{
    for (const char* text : {neo, mooney})
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(text, form));
            CHECK(model->finiteStrain());
            objective<2>(*model);
            objective<3>(*model);
        }
    }
}


TEST_CASE("Cauchy stress (13)", "[materials][serial]")
{
    Random random(40);
    for (const char* text : {neo, mooney})
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(text, form));
            for (label sample = 0; sample < nSamples; ++sample)
            {
                materialPoint<3> point(*model, kinematicSet::FHJ);
                point.deform(randomTensor<3>(random, 1, 0.25));

                // Angular momentum: symmetric as long as H = cof F
                const fullTensor sigma(point.Cauchy());
                for (int i = 0; i < 3; ++i)
                {
                    const int j = (i + 1) % 3;
                    CHECK(mag(sigma.c[i][j] - sigma.c[j][i]) <= 1e-13);
                }

                point.s.J[0] += randomScalar(random, 0.2);
                for (scalar& h : point.s.H) h += randomScalar(random, 0.2);
                const fullTensor PFt
                (
                    dotTransposed
                    (
                        fullTensor(point.stress()), fullTensor(point.Fnow())
                    )
                );
                CHECK
                (
                    maxDiff
                    (
                        point.Cauchy(), combine(1/point.s.J[0], PFt, 0, PFt)
                    ) <= 1e-13
                );
            }
        }
    }
}


TEST_CASE
(
    "jacobian volumetric: SigmaJ and a lower bound",
    "[materials][serial]"
)
{
    Random random(50);
    for (const char* text : {neo, mooney})
    {
        INFO(text);
        const auto model(materialFrom(text));
        for (label sample = 0; sample < 10*nSamples; ++sample)
        {
            materialPoint<3> point(*model, kinematicSet::FHJ);
            point.deform(randomTensor<3>(random, 1, 0.25));
            point.s.J[0] = 1 + randomScalar(random);
            for (scalar& h : point.s.H) h = randomScalar(random);

            CHECK
            (
                point.SigmaJ() == Approx(3*(point.s.J[0] - 1)).epsilon(1e-14)
            );
            CHECK(point.energy() > 1.5*sqr(point.s.J[0] - 1));
        }
    }

    // The whole energy depends on J: it is not bounded
    for (const char* text : {neo, mooney})
    {
        INFO(text);
        const auto model(materialFrom(text, literal));
        materialPoint<3> point(*model, kinematicSet::FHJ);
        point.s.J[0] = 1.1;
        CHECK(point.energy() < 0);
    }
}


TEST_CASE("many nodes with a stride", "[materials][serial]")
{
    Random random(60);
    for (const char* text : {linear, neo, mooney})
    {
        INFO(text);
        const auto model(materialFrom(text));
        const label nNodes = 5, stride = 12;
        conservedState s(nNodes, 3, kinematicSet::FHJ, model->finiteStrain());
        scalarField P(nNodes*stride, scalar(-7)), alone(P);

        for (scalar& f : s.F) f += randomScalar(random, 0.2);
        for (scalar& h : s.H) h += randomScalar(random, 0.2);
        for (scalar& j : s.J) j += randomScalar(random, 0.2);

        model->stress(s, P.data(), s.solvesJ ? P.data() + 9 : nullptr, stride);
        model->stress(s, alone.data(), nullptr, stride);
        for (label i = 0; i < nNodes; ++i)
        {
            materialPoint<3> point(*model, kinematicSet::FHJ);
            for (int k = 0; k < 9; ++k)
            {
                point.s.F[k] = s.F[9*i + k];
                if (s.strideH) point.s.H[k] = s.H[9*i + k];
            }
            if (s.solvesJ) point.s.J[0] = s.J[i];

            const auto one = point.stress();
            for (int k = 0; k < 9; ++k)
            {
                CHECK(mag(P[i*stride + placeH(k)] - one.in[k]) <= 1e-14);
                CHECK
                (
                    mag(alone[i*stride + placeH(k)] - one.in[k]) <= 1e-14
                );
            }
            if (s.solvesJ)
            {
                CHECK(mag(P[i*stride + 9] - point.SigmaJ()) <= 1e-14);
            }
            scalarField volume(s.nNodes, Zero);
            volume[i] = 1;
            CHECK
            (
                mag(model->strainEnergy(s, volume) - point.energy()) <= 1e-14
            );
            CHECK
            (
                maxDiff(fullTensor(model->CauchyStress(s, i)), point.Cauchy())
             <= 1e-13
            );

            // Nothing else is touched
            for (label k = (s.solvesJ ? 10 : 9); k < stride; ++k)
            {
                CHECK(P[i*stride + k] == -7);
            }
            for (label k = 9; k < stride; ++k)
            {
                CHECK(alone[i*stride + k] == -7);
            }
        }
    }
}


TEST_CASE("wave factors against the stress", "[materials][serial]")
{
    // Speed of plane waves along a principal direction: that of dP_ii/dl_i
    for (const char* text : {linear, neo, mooney})
    {
        INFO(text);
        const auto model(materialFrom(text));
        materialPoint<3> point(*model, kinematicSet::F);
        Random random(5);
        for (label sample = 0; sample < nSamples; ++sample)
        {
            scalar l[3];
            for (scalar& x : l) x = std::exp(0.7*randomScalar(random));
            const scalar J = l[0]*l[1]*l[2];
            const auto stretched = [&](const int i, const scalar change)
            {
                SolidTensor<3> F;
                for (int k = 0; k < 9; ++k) F.in[k] = 0;
                for (int k = 0; k < 3; ++k) F(k, k) = l[k];
                F(i, i) += change;
                F.out = 0;
                point.deform(F);
                return point.stress()(i, i);
            };

            scalar most = 1;
            for (int i = 0; i < 3; ++i)
            {
                const scalar h = 1e-5;
                const scalar modulus =
                    (stretched(i, h) - stretched(i, -h))/(2*h);
                most = max
                (
                    most,
                    modulus
                   /(
                        model->rho()*sqr(model->cp())
                       *max(scalar(1), sqr(J/l[i]))
                    )
                );
            }
            stretched(0, 0);

            scalarField factor;
            model->waveFactors(point.s, factor);
            const scalar expected =
                model->stretchesWaves() ? std::sqrt(most) : 1;
            CHECK(mag(factor[0] - expected) <= 1e-7*expected);
        }
    }
}


// ************************************************************************* //
