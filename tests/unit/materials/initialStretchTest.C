/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Laws of bodies with an initial stretch F0: energy, stress and waves per
    volume of the mesh against those of the same law from its natural state.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "materialPoint.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

const label nSamples = 20;
const scalar tol = 1e-8;        // moduli of order 1, central differences

const char* const linear = "type linearElastic; rho 2; mu 1; lambda 2;";
const char* const neo = "type neoHookean; rho 2; mu 1; kappa 3;";
const char* const Hencky =
    "type HenckyVonMises; rho 2; mu 1; kappa 3; tauY 100;";
const char* const mooney = "type MooneyRivlin; rho 2; mu 1; kappa 3; xi 0.1;";

//- An F0 with what D directions have
template<int D>
tensor randomF0(Random& random)
{
    const auto in = randomTensor<D>(random, 1, 0.25);
    const scalar out = D < 3 ? 1 + randomScalar(random, 0.25) : 1;
    tensor F0(Zero);
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            F0[3*i + j] =
                i < D && j < D ? in.in[(i % D)*D + j % D] : i == j ? out : 0;
        }
    }
    return F0;
}

template<int D>
void setF0(materialModel& model, const tensor& F0)
{
    model.setInitialStretch(initialStretch(tensorField(1, F0), D));
}


//- P = dW/dF, with F, or with F and the Jacobian
template<int D>
void derivatives(const char* text)
{
    Random random(D);
    for (const kinematicSet set : {kinematicSet::F, kinematicSet::FJ})
    {
        INFO(text << ", D = " << D);
        for (label sample = 0; sample < nSamples; ++sample)
        {
            auto model(materialFrom(text));
            const tensor F0(randomF0<D>(random));
            setF0<D>(*model, F0);
            CHECK(model->initial().on());
            CHECK(mag(model->initial().value(0) - F0) == 0);
            CHECK(mag(model->initial().J(0) - det(F0)) <= 1e-14);

            materialPoint<D> point(*model, set);
            point.deform(randomTensor<D>(random, 1, 0.25));
            const auto P = point.stress();
            for (int k = 0; k < D*D; ++k)
            {
                CHECK
                (
                    mag(P.in[k] - point.derivative(point.s.F[k], true)) <= tol
                );
            }
            if (point.s.solvesJ)
            {
                CHECK
                (
                    mag(point.SigmaJ() - point.derivative(point.s.J[0])) <= tol
                );
            }
        }
    }
}


//- Energy and Cauchy stress are those of F F0, or F + F0 - I, in 3D, whatever
//  the number of directions
template<int D>
void natural(const char* text)
{
    Random random(10 + D);
    const auto plain(materialFrom(text));
    CHECK(!plain->initial().on());
    for (label sample = 0; sample < nSamples; ++sample)
    {
        INFO(text << ", D = " << D);
        auto model(materialFrom(text));
        const tensor F0(randomF0<D>(random));
        setF0<D>(*model, F0);
        materialPoint<D> point(*model, kinematicSet::F);
        point.deform(randomTensor<D>(random, 1, 0.25));

        materialPoint<3> full(*plain, kinematicSet::F);
        const fullTensor F(point.Fnow());
        SolidTensor<3> FF0;
        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j)
            {
                FF0(i, j) = 0;
                if (!model->finiteStrain())
                {
                    FF0(i, j) = F.c[i][j] + F0[3*i + j] - (i == j ? 1 : 0);
                    continue;
                }
                for (int k = 0; k < 3; ++k)
                {
                    FF0(i, j) += F.c[i][k]*F0[3*k + j];
                }
            }
        }
        FF0.out = 1;
        full.deform(FF0);
        const scalar J0 = model->finiteStrain() ? det(F0) : 1;
        CHECK(mag(J0*point.energy() - full.energy()) <= 1e-13);
        CHECK
        (
            mag
            (
                J0*model->strainEnergy(point.s, scalarField(1, scalar(3)))
              - 3*full.energy()
            ) <= 1e-12
        );
        CHECK(maxDiff(point.Cauchy(), full.Cauchy()) <= 1e-12);
    }
}


//- The factor bounds waves along the principal directions: dP_ii/dF_ii by that
//  of the undeformed body, times what the scheme accounts for itself. With an
//  initial stretch, or without
template<int D>
void waves(const char* text, const bool initial = true)
{
    Random random(20 + D);
    scalar closest = 0;
    for (label sample = 0; sample < 10*nSamples; ++sample)
    {
        INFO(text << ", D = " << D);
        auto model(materialFrom(text));
        scalar s[3], l[3] = {1, 1, 1};
        for (scalar& x : s) x = std::exp(0.7*randomScalar(random));
        if (D == 1) s[1] = s[2];
        for (int i = 0; i < D; ++i) l[i] = std::exp(0.3*randomScalar(random));
        if (initial)
        {
            setF0<D>(*model, tensor(s[0], 0, 0, 0, s[1], 0, 0, 0, s[2]));
        }
        CHECK(model->stretchesWaves() == model->finiteStrain());

        materialPoint<D> point(*model, kinematicSet::F);
        SolidTensor<D> F;
        for (int k = 0; k < D*D; ++k) F.in[k] = 0;
        for (int i = 0; i < D; ++i) F(i, i) = l[i];
        F.out = 1;
        point.deform(F);
        scalarField factor;
        model->waveFactors(point.s, factor);
        CHECK(factor[0] >= 1);

        for (int i = 0; i < D; ++i)
        {
            const auto at = [&](const scalar change)
            {
                F(i, i) = l[i] + change;
                point.deform(F);
                return point.stress()(i, i);
            };
            const scalar h = 1e-5;
            const scalar modulus = (at(h) - at(-h))/(2*h);
            F(i, i) = l[i];
            const scalar allowed =
                model->rho()*sqr(model->cp()*factor[0])
               *max(scalar(1), sqr(l[0]*l[1]*l[2]/l[i]));
            CHECK(modulus <= (1 + 1e-7)*allowed);
            closest = max(closest, modulus/allowed);
        }
    }
    CHECK(closest > 0.9);
}


void all(const char* text)
{
    derivatives<1>(text);
    derivatives<2>(text);
    derivatives<3>(text);
    natural<1>(text);
    natural<2>(text);
    natural<3>(text);
    waves<1>(text);
    waves<2>(text);
    waves<3>(text);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("initial stretch, linearElastic", "[materials][serial]")
{
    all(linear);
}


TEST_CASE("initial stretch, neoHookean", "[materials][serial]")
{
    all(neo);
}


TEST_CASE("initial stretch, MooneyRivlin", "[materials][serial]")
{
    all(mooney);
}


TEST_CASE("initial stretch, HenckyVonMises", "[materials][serial]")
{
    all(Hencky);
}


TEST_CASE("waves of HenckyVonMises, no stretch", "[materials][serial]")
{
    waves<1>(Hencky, false);
    waves<2>(Hencky, false);
    waves<3>(Hencky, false);
}


// ************************************************************************* //
