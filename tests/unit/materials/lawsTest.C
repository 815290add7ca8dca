/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The laws in states with known stress, in the limit of small strains, and
    their constants and wave speeds (18), (31).

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "materialPoint.H"
#include "MooneyRivlin.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

const jacobianForm volumetric = jacobianForm::volumetric;
const jacobianForm literal = jacobianForm::literal;

//- mu and kappa of all the laws here
const scalar mu = 1, kappa = 3, lambda = 3 - 2.0/3.0;

const char* const linear = "type linearElastic; rho 2; mu 1; kappa 3;";
const char* const neo = "type neoHookean; rho 2; mu 1; kappa 3;";
const char* const mooney = "type MooneyRivlin; rho 2; mu 1; kappa 3; xi 0.1;";


//- First order term as of linear elasticity: the difference falls with the
//  square of the strain
template<int D>
void smallStrain(const materialModel& model)
{
    Random random(D);
    for (label sample = 0; sample < 20; ++sample)
    {
        const auto G = randomTensor<D>(random);
        for (const scalar eps : {1e-3, 1e-4, 1e-5})
        {
            INFO("D = " << D << ", eps = " << eps);
            materialPoint<D> point(model, kinematicSet::FHJ);
            const auto I = SolidTensor<D>::identity();
            point.deform(combine(1, I, eps, G));
            const auto P = point.stress();
            const fullTensor sigma(point.Cauchy());

            auto inPlaneG = G;
            inPlaneG.out = 0;
            const fullTensor fullG(inPlaneG);
            scalar trG = 0;
            for (int i = 0; i < D; ++i) trG += G(i, i);
            scalar W = 0.5*lambda*sqr(trG);
            for (int i = 0; i < 3; ++i)
            {
                for (int j = 0; j < 3; ++j)
                {
                    const bool inPlane = (i < D && j < D);
                    const scalar strain = 0.5*(fullG.c[i][j] + fullG.c[j][i]);
                    const scalar expected =
                        2*mu*strain + (i == j ? lambda*trG : 0);
                    W += mu*sqr(strain);

                    if (inPlane)
                    {
                        CHECK(mag(P.in[i*D + j] - eps*expected) <= 50*sqr(eps));
                    }
                    CHECK(mag(sigma.c[i][j] - eps*expected) <= 50*sqr(eps));
                }
            }
            CHECK(mag(point.energy() - W*sqr(eps)) <= 50*eps*sqr(eps) + 1e-15);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("small strains are those of linear elasticity", "[materials][serial]")
{
    for (const char* text : {linear, neo, mooney})
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(text, form));
            smallStrain<1>(*model);
            smallStrain<2>(*model);
            smallStrain<3>(*model);
        }
    }
}


TEST_CASE("pure volume change", "[materials][serial]")
{
    for (const char* text : {neo, mooney})
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(text, form));
            for (const scalar stretch : {0.6, 0.9, 1.3})
            {
                materialPoint<3> point(*model, kinematicSet::FHJ);
                const auto I = SolidTensor<3>::identity();
                point.deform(combine(stretch, I, 0, I));
                const scalar J = pow3(stretch);

                CHECK
                (
                    maxDiff
                    (
                        point.Cauchy(),
                        combine(kappa*(J - 1), fullTensor(I), 0, fullTensor(I))
                    ) <= 1e-13
                );
                CHECK
                (
                    point.energy()
                 == Approx(0.5*kappa*sqr(J - 1)).epsilon(1e-12)
                );
            }
        }
    }
}


TEST_CASE("simple shear", "[materials][serial]")
{
    const struct { const char* text; scalar xi; } laws[] =
    {
        {neo, 0}, {mooney, 0.1}
    };
    for (const auto& law : laws)
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(law.text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(law.text, form));
            for (const scalar gamma : {-0.3, 0.5, 2.0})
            {
                materialPoint<2> point(*model, kinematicSet::FHJ);
                auto F = SolidTensor<2>::identity();
                F(0, 1) = gamma;
                point.deform(F);

                const fullTensor sigma(point.Cauchy());
                const scalar root3 = Foam::sqrt(scalar(3));
                const scalar tau =
                    gamma
                   *(
                        mu - 3*root3*law.xi
                      + 3*law.xi*Foam::sqrt(3 + sqr(gamma))
                    );
                CHECK(sigma.c[0][1] == Approx(tau).epsilon(1e-13));
                CHECK(sigma.c[1][0] == Approx(tau).epsilon(1e-13));
                // Universal relation
                CHECK
                (
                    sigma.c[0][0] - sigma.c[1][1]
                 == Approx(gamma*tau).epsilon(1e-13)
                );
            }
        }
    }
}


TEST_CASE("linear elasticity: uniaxial strain, rotation", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    CHECK_FALSE(model->finiteStrain());

    materialPoint<1> bar(*model, kinematicSet::F);
    bar.s.F[0] = 1.25;
    CHECK(bar.stress().in[0] == Approx(0.25*(lambda + 2*mu)).epsilon(1e-14));
    const fullTensor sigma(bar.Cauchy());
    CHECK(sigma.c[0][0] == Approx(0.25*(lambda + 2*mu)).epsilon(1e-14));
    CHECK(sigma.c[1][1] == Approx(0.25*lambda).epsilon(1e-14));
    CHECK(sigma.c[2][2] == Approx(0.25*lambda).epsilon(1e-14));
    CHECK
    (
        bar.energy() == Approx(0.5*(lambda + 2*mu)*sqr(0.25)).epsilon(1e-14)
    );

    // A rotation counts as a strain cos - 1: good for small ones only
    const scalar c = 0.8, s = 0.6;
    materialPoint<2> plane(*model, kinematicSet::F);
    plane.s.F[0] = plane.s.F[3] = c;
    plane.s.F[1] = -s;
    plane.s.F[2] = s;
    const fullTensor turned(plane.Cauchy());
    const scalar p = 2*(lambda + mu)*(c - 1);
    CHECK(turned.c[0][0] == Approx(p).epsilon(1e-14));
    CHECK(turned.c[1][1] == Approx(p).epsilon(1e-14));
    CHECK(turned.c[2][2] == Approx(2*lambda*(c - 1)).epsilon(1e-14));
    CHECK(mag(turned.c[0][1]) <= 1e-15);
    CHECK(mag(turned.c[1][0]) <= 1e-15);
}


TEST_CASE("parameters of Mooney-Rivlin", "[materials][serial]")
{
    const auto model
    (
        materialFrom("type MooneyRivlin; rho 1; E 2.5; nu 0.4; xi 0.05;")
    );
    const auto& law =
        dynamic_cast<const isotropicMaterial<MooneyRivlinLaw>&>(*model).law();

    CHECK(law.xi() == 0.05);
    CHECK
    (
        2*law.zeta() + 3*Foam::sqrt(scalar(3))*law.xi()
     == Approx(2.5/2.8).epsilon(1e-14)
    );

    // Without the cofactor term it is the neo-Hookean law
    Random random(3);
    for (const jacobianForm form : {volumetric, literal})
    {
        const auto mr
        (
            materialFrom("type MooneyRivlin; rho 1; mu 1; kappa 3; xi 0;", form)
        );
        const auto nh(materialFrom(neo, form));
        for (label sample = 0; sample < 20; ++sample)
        {
            materialPoint<3> a(*mr, kinematicSet::FHJ);
            materialPoint<3> b(*nh, kinematicSet::FHJ);
            a.deform(randomTensor<3>(random, 1, 0.25));
            for (scalar& h : a.s.H) h += randomScalar(random, 0.2);
            a.s.J[0] += randomScalar(random, 0.2);
            b.s = a.s;
            CHECK(maxDiff(a.stress(), b.stress()) <= 1e-13);
            CHECK(mag(a.SigmaJ() - b.SigmaJ()) <= 1e-13);
            CHECK(mag(a.energy() - b.energy()) <= 1e-13);
        }
    }
}


TEST_CASE("pairs of elastic constants", "[materials][serial]")
{
    // The same material, near the incompressible limit, too
    for (const scalar nu : {-0.5, 0.0, 0.3, 0.4999})
    {
        INFO("nu = " << nu);
        const scalar E = 7;
        const scalar G = E/(2*(1 + nu)), K = E/(3*(1 - 2*nu));
        const scalar L = E*nu/((1 + nu)*(1 - 2*nu));

        const auto check = [&](const string& pair)
        {
            INFO(pair);
            const auto model(materialFrom("type neoHookean; rho 11; " + pair));
            CHECK(model->rho() == 11);
            CHECK(model->mu() == Approx(G).epsilon(1e-11));
            CHECK(model->kappa() == Approx(K).epsilon(1e-11));
            CHECK(model->lambda() == Approx(L).epsilon(1e-11).margin(1e-11));
        };
        const auto entry = [](const char* name, const scalar value)
        {
            OStringStream os;
            os.precision(17);
            os  << name << ' ' << value << "; ";
            return os.str();
        };
        check(entry("E", E) + entry("nu", nu));
        check(entry("mu", G) + entry("lambda", L));
        check(entry("kappa", K) + entry("mu", G));
    }
}


TEST_CASE("wave speeds (18), (31)", "[materials][serial]")
{
    // Two bars of the paper
    const auto bar(materialFrom("type linearElastic; rho 0.01; E 100; nu 0;"));
    CHECK(bar->cp() == Approx(100).epsilon(1e-14));
    CHECK(bar->cs() == Approx(Foam::sqrt(scalar(5000))).epsilon(1e-14));

    // Stiffness of the undeformed body, felt by waves of small amplitude
    for (const char* text : {linear, neo, mooney})
    {
        for (const jacobianForm form : {volumetric, literal})
        {
            INFO(text << ' ' << materialModel::jacobianFormNames[form]);
            const auto model(materialFrom(text, form));
            const scalar h = 1e-4;
            const auto stiffness = [&](const int k)
            {
                materialPoint<3> plus(*model, kinematicSet::FHJ);
                materialPoint<3> minus(*model, kinematicSet::FHJ);
                auto F = SolidTensor<3>::identity();
                F.in[k] += h;
                plus.deform(F);
                F.in[k] -= 2*h;
                minus.deform(F);
                return (plus.stress().in[k] - minus.stress().in[k])/(2*h);
            };
            CHECK(model->rho() == 2);
            CHECK(2*sqr(model->cp()) == Approx(stiffness(0)).epsilon(1e-6));
            CHECK(2*sqr(model->cp()) == Approx(lambda + 2*mu).epsilon(1e-14));
            CHECK(2*sqr(model->cs()) == Approx(stiffness(1)).epsilon(1e-6));
            CHECK(2*sqr(model->cs()) == Approx(mu).epsilon(1e-14));
        }
    }
}


// ************************************************************************* //
