/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    HenckyVonMises at one node: closed forms of proportional paths, unloading,
    dissipation, the yield condition after each step, equal principal
    stretches, and the hardening curves; how jumps of the positions yield, and
    the elastic strain of a state.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "materialPoint.H"
#include "elasticStrain.H"
#include "principalValues.H"
#include "SubField.H"
#include <algorithm>
#include <functional>
#include "HenckyVonMises.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

constexpr scalar mu = 40, kappa = 100, tauY = 0.5, slope = 2;
const char* const linear =
    "type HenckyVonMises; rho 1; mu 40; kappa 100; tauY 0.5; Hardening 2;";

template<int D>
struct plasticPoint
:
    public materialPoint<D>
{
    using materialPoint<D>::s;
    scalarField one = scalarField(1, scalar(1));

    plasticPoint(const materialModel& m, kinematicSet set = kinematicSet::FHJ)
    :
        materialPoint<D>(m, set)
    {
        if (m.initialTemperature() > 0) s.makeHeated(m.initialTemperature());
    }

    //- Deform and end the step; returns the dissipation
    scalar step(const SolidTensor<D>& F, const scalar dt = 1)
    {
        this->deform(F);
        s.sinceCommit = dt;
        return this->material.commit(s, one);
    }

    scalar strain() const { return s.epsilonPEq[0]; }

    //- Kirchhoff stress of von Mises
    scalar q() const
    {
        const tensor tau(s.J[0]*this->material.CauchyStress(s, 0));
        return std::sqrt(1.5*magSqr(dev(symm(tau))));
    }
};

SolidTensor<3> diagonal(const scalar a, const scalar b, const scalar c)
{
    auto F = SolidTensor<3>::identity();
    F(0, 0) = a;
    F(1, 1) = b;
    F(2, 2) = c;
    return F;
}

SolidTensor<3> times(const SolidTensor<3>& A, const SolidTensor<3>& B)
{
    SolidTensor<3> C;
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            C(i, j) = 0;
            for (int k = 0; k < 3; ++k) C(i, j) += A(i, k)*B(k, j);
        }
    }
    C.out = 0;
    return C;
}

SolidTensor<3> rotation(Random& random)
{
    // The principal directions of any symmetric tensor
    auto A = randomTensor<3>(random);
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < i; ++j) A(i, j) = A(j, i);
    }
    const principalValues<3> p(A);
    SolidTensor<3> Q;
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j) Q(i, j) = p.n[i][j];
    }
    Q.out = 0;
    return Q;
}

//- Plastic strain of an isochoric, proportional path of equivalent strain e
scalar exactStrain(const scalar e)
{
    return max(scalar(0), (3*mu*e - tauY)/(3*mu + slope));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE
(
    "principal values of random and degenerate tensors",
    "[materials][serial]"
)
{
    Random random(7);
    for (label sample = 0; sample < 200; ++sample)
    {
        const auto Q = rotation(random);
        auto Qt = Q;
        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j) Qt(i, j) = Q(j, i);
        }
        const scalar a = randomScalar(random) + 2, gap = sample % 3 ? 1e-9 : 0;
        const auto A =
            times(Q, times(diagonal(a, sample % 2 ? a + gap : 1, a), Qt));
        const principalValues<3> p(A);
        const auto B = p.compose(p.value);
        for (int k = 0; k < 9; ++k)
        {
            CHECK(mag(A.in[k] - B.in[k]) <= 1e-14*a);
        }
    }
}


TEST_CASE
(
    "principal values of several tensors are those of each",
    "[materials][serial]"
)
{
    // In lanes some are done before others
    Random random(11);
    for (label sample = 0; sample < 50; ++sample)
    {
        SolidTensor<3> A[nLanes];
        for (int l = 0; l < nLanes; ++l)
        {
            A[l] = diagonal(l + 1, 2, 2);
            for (int i = 0; i < 3 && l % 3; ++i)
            {
                for (int j = 0; j <= i; ++j)
                {
                    A[l](i, j) = A[l](j, i) = randomScalar(random);
                }
            }
        }
        principalValues<3> together[nLanes];
        principalValues<3>::ofLanes(A, together);
        for (int l = 0; l < nLanes; ++l)
        {
            const principalValues<3> one(A[l]);
            for (int i = 0; i < 3; ++i)
            {
                CHECK(mag(together[l].value[i] - one.value[i]) <= 1e-13);
                for (int j = 0; j < 3; ++j)
                {
                    CHECK(mag(together[l].n[i][j] - one.n[i][j]) <= 1e-12);
                }
            }
        }
    }
}


TEST_CASE
(
    "principal values without directions are the same, in their order",
    "[materials][serial]"
)
{
    // Alone, double, triple
    Random random(13);
    for (label sample = 0; sample < 60; ++sample)
    {
        lanes in[9];
        scalar right[nLanes][3];
        for (int l = 0; l < nLanes; ++l)
        {
            const auto Q = rotation(random);
            auto Qt = Q;
            for (int i = 0; i < 3; ++i)
            {
                for (int j = 0; j < 3; ++j) Qt(i, j) = Q(j, i);
            }
            scalar* v = right[l];
            for (int i = 0; i < 3; ++i) v[i] = 2 + randomScalar(random);
            if (sample % 3 == 1) v[1] = v[l % 2 ? 0 : 2];
            if (sample % 3 == 2) v[1] = v[2] = v[0] + (l ? 0 : 1e-10);
            const auto A = times(Q, times(diagonal(v[0], v[1], v[2]), Qt));
            for (int k = 0; k < 9; ++k) in[k][l] = A.in[k];
            std::sort(v, v + 3, std::greater<scalar>());
        }
        const principalValues<3, lanes, false> p(in, lanes{});
        for (int l = 0; l < nLanes; ++l)
        {
            for (int i = 0; i < 3; ++i)
            {
                INFO("sample " << sample << ", lane " << l << ", value " << i);
                CHECK(mag(p.value[i][l] - right[l][i]) <= 1e-7);
            }
        }
    }
    const lanes plane[4] =
        {uniform<lanes>(3), uniform<lanes>(2), uniform<lanes>(2), lanes{}};
    const principalValues<2, lanes, false> p(plane, uniform<lanes>(7));
    CHECK(mag(p.value[0][0] - 4) <= 1e-14);
    CHECK(mag(p.value[1][0] + 1) <= 1e-14);
    CHECK(p.value[2][0] == 7);
}


TEST_CASE("uniaxial path against its closed form", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    for (const label steps : {1, 7, 300})
    {
        plasticPoint<3> point(*model);
        scalar dissipated = 0;
        for (label i = 1; i <= steps; ++i)
        {
            const scalar l = std::exp(0.3*i/steps);
            dissipated +=
                point.step(diagonal(l, 1/std::sqrt(l), 1/std::sqrt(l)));
        }
        const scalar ep = exactStrain(0.3);
        CHECK(mag(point.strain() - ep) <= 1e-10);
        CHECK(mag(point.q() - (tauY + slope*ep)) <= 1e-10);

        // The integral of the yield stress; one step cuts the elastic part off
        CHECK(mag(dissipated - (tauY*ep + 0.5*slope*sqr(ep))) <= 1e-10);

        // sigma_11 - sigma_22 = q, exactly uniaxial
        const tensor sigma(model->CauchyStress(point.s, 0));
        CHECK(mag(sigma.xx() - sigma.yy() - point.q()) <= 1e-9);
        CHECK(mag(sigma.yy() - sigma.zz()) <= 1e-12);
    }
}


TEST_CASE("shear path in any orientation", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    Random random(3);
    for (label sample = 0; sample < 20; ++sample)
    {
        const auto Q = rotation(random);
        auto Qt = Q;
        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j) Qt(i, j) = Q(j, i);
        }
        plasticPoint<3> point(*model);
        for (label i = 1; i <= 10; ++i)
        {
            const scalar l = std::exp(0.02*i);
            point.step(times(Q, times(diagonal(l, 1/l, 1), Qt)));
        }
        const scalar ep = exactStrain(0.2*2/std::sqrt(3.0));
        CHECK(mag(point.strain() - ep) <= 1e-10);
        CHECK(mag(point.q() - (tauY + slope*ep)) <= 1e-10);
    }
}


TEST_CASE("volume change is elastic", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    for (const scalar l : {0.5, 0.9, 1.0, 1.3})
    {
        plasticPoint<3> point(*model);
        const scalar dissipated = point.step(diagonal(l, l, l));
        const scalar J = pow3(l);
        const tensor sigma(model->CauchyStress(point.s, 0));
        CHECK(dissipated == 0);
        CHECK(point.strain() == 0);
        CHECK(mag(tr(sigma)/3 - kappa*std::log(J)/J) <= 1e-10);
        CHECK(point.q() <= 1e-10);
    }
}


TEST_CASE("unloading is elastic and retraces", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    plasticPoint<3> point(*model);
    const auto at = [](const scalar e)
    {
        const scalar l = std::exp(e);
        return diagonal(l, 1/std::sqrt(l), 1/std::sqrt(l));
    };
    for (label i = 1; i <= 20; ++i) point.step(at(0.01*i));

    const scalar top = point.q(), ep = point.strain();
    const auto P = point.stress();
    const scalar back = 0.5*top/(3*mu);
    CHECK(point.step(at(0.2 - back)) == 0);
    CHECK(mag(point.q() - 0.5*top) <= 1e-10);
    point.step(at(0.2*(1 - 1e-14)));
    CHECK(point.strain() == ep);
    const auto again = point.stress();
    for (int k = 0; k < 9; ++k) CHECK(mag(P.in[k] - again.in[k]) <= 1e-10);
}


template<int D>
void randomPath(const materialModel& model)
{
    const auto& law = dynamic_cast<const HenckyVonMises&>(model);
    Random random(D);
    plasticPoint<D> point(model);
    auto F = SolidTensor<D>::identity();
    scalar before = 0;
    for (label i = 0; i < 300; ++i)
    {
        F = combine(1, F, 0.01, randomTensor<D>(random));
        F.out = 1;
        const scalar dissipated = point.step(F);
        CHECK(dissipated >= 0);
        CHECK(point.strain() >= before);

        const scalar Y = law.yieldStress(point.strain());
        if (point.strain() > before)
        {
            CHECK(mag(point.q() - Y) <= 1e-10*Y);
        }
        else
        {
            CHECK(point.q() <= Y*(1 + 1e-10));
        }
        before = point.strain();

        // Isochoric plastic flow
        scalar det = 0;
        const scalar* C = point.s.Cpi.cdata();
        if (D == 3)
        {
            det =
                C[0]*(C[3]*C[5] - sqr(C[4])) - C[1]*(C[1]*C[5] - C[2]*C[4])
              + C[2]*(C[1]*C[4] - C[2]*C[3]);
        }
        else
        {
            det = D == 2 ? (C[0]*C[2] - sqr(C[1]))*C[3] : C[0]*sqr(C[1]);
        }
        CHECK(mag(det - 1) <= 1e-11);
    }
    CHECK(before > 0.1);
}

TEST_CASE("random paths: yield condition, dissipation", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    randomPath<1>(*model);
    randomPath<2>(*model);
    randomPath<3>(*model);
}


//- The same steps, once with the flow that the stress has found
template<int D>
void keptFlow(const materialModel& model)
{
    Random random(7 + D);
    plasticPoint<D> one(model), other(model);
    other.s.keepFlow();
    auto F = SolidTensor<D>::identity();
    label nFlown = 0, nElastic = 0;
    for (label i = 0; i < 200; ++i)
    {
        F = combine(1, F, 0.01, randomTensor<D>(random));
        F.out = 1;
        const scalar dissipated = one.step(F);
        other.deform(F);
        other.s.sinceCommit = 1;
        other.stress();
        CHECK(model.commit(other.s, other.one) == Approx(dissipated));
        CHECK(other.s.sinceCommit == 0);
        CHECK(mag(one.strain() - other.strain()) <= 1e-13);
        forAll(one.s.Cpi, k)
        {
            CHECK(mag(one.s.Cpi[k] - other.s.Cpi[k]) <= 1e-12);
        }
        forAll(one.s.temperature, k)
        {
            CHECK(mag(one.s.temperature[k] - other.s.temperature[k]) <= 1e-9);
        }
        (dissipated > 0 ? nFlown : nElastic)++;
    }
    CHECK(nFlown > 50);
    CHECK(nElastic > 5);
}

TEST_CASE("flow that is kept is what is committed", "[materials][serial]")
{
    for
    (
        const std::string& text :
        {
            std::string(linear),
            std::string
            (
                "type HenckyVonMises; rho 1; mu 40; kappa 100; "
                "JohnsonCook { A 0.5; B 2; n 0.5; C 0.1; referenceRate 0.01; "
                "m 1; Tmelt 1000; } "
                "adiabaticHeating { beta 0.9; cp 0.002; T0 300; }"
            )
        }
    )
    {
        const auto model(materialFrom(text));
        keptFlow<1>(*model);
        keptFlow<2>(*model);
        keptFlow<3>(*model);
    }
}


TEST_CASE("jumps yield as nodes do", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    plasticPoint<3> point(*model);
    constexpr scalar tangent = slope/(3*mu + slope);
    scalar before = 1;
    for (const scalar e : {0.002, 0.005, 0.007, 0.01, 0.5})
    {
        // Isochoric, of an equivalent strain e
        point.step
        (
            diagonal(std::exp(e), std::exp(-0.5*e), std::exp(-0.5*e))
        );
        const scalar strain = exactStrain(e);
        CHECK(point.strain() == Approx(strain).margin(1e-12));

        // From all to the tangent, of a measure of the plastic strain that is
        // not more
        const scalar sinh2 =
            sqr(std::sinh(strain)) + 2*sqr(std::sinh(0.5*strain));
        const scalar plastic = std::asinh(std::sqrt(2*sinh2/3));
        CHECK(plastic <= strain*(1 + 1e-12));
        CHECK(plastic >= 0.95*strain);
        const scalar share = model->hourglassShare(point.s, 0);
        const scalar elastic = max(1 - 3*mu*plastic/point.q(), scalar(0));
        CHECK
        (
            share
         == Approx(strain > 0 ? tangent + (1 - tangent)*elastic : 1)
        );
        CHECK(share <= before);
        before = share;
    }
    CHECK(before == Approx(tangent));

    // In a file with six digits the determinant is not quite one
    scalar* C = point.s.Cpi.data();
    for (int k = 0; k < 6; ++k) C[k] *= 1 + 3e-6;
    CHECK(model->hourglassShare(point.s, 0) == Approx(before));

    // Flow of before the mesh was made is none of its strain, and an initial
    // stress is no flow
    C[0] = C[3] = C[5] = 1;
    CHECK(model->hourglassShare(point.s, 0) == 1);
    C[0] = 1.01;
    C[3] = 1/1.01;
    point.s.epsilonPEq = Zero;
    CHECK(model->hourglassShare(point.s, 0) == 1);
}


TEST_CASE("elastic strain and plastic part", "[materials][serial]")
{
    Random random(5);
    for (label i = 0; i < 20; ++i)
    {
        const auto given = randomTensor<3>(random, 1, 0.3);
        tensor F;
        for (int k = 0; k < 9; ++k) F[k] = given.in[k];
        const symmTensor b(symm(F & F.T()));

        // Without a plastic part: half of the logarithm of F F^T
        const symmTensor all(elasticStrain::of(F, symmTensor::I));
        CHECK(tr(all) == Approx(std::log(det(F))));
        const symmTensor none(elasticStrain::plasticPart(F, all));
        CHECK(mag(none - symmTensor::I) < 1e-12);

        // From a strain to the plastic part, and back; the volume is that of F
        const symmTensor strain(0.1*dev(b) + 0.3*symmTensor::I);
        const symmTensor CpInv(elasticStrain::plasticPart(F, strain));
        CHECK(det(CpInv) == Approx(1));
        CHECK(mag(dev(elasticStrain::of(F, CpInv) - strain)) < 1e-12);
    }
    const tensor stretch(std::exp(0.2), 0, 0, 0, std::exp(-0.2), 0, 0, 0, 1);
    const symmTensor known(elasticStrain::of(stretch, symmTensor::I));
    CHECK(known.xx() == Approx(0.2));
    CHECK(known.yy() == Approx(-0.2));
    CHECK(mag(known.zz()) < 1e-14);
}


//- Flow with an initial stretch F0 is that of F F0 in 3D; what is by volume is
//  by that of the mesh
template<int D>
void stretchedFlow(const std::string& text, const bool keeps)
{
    Random random(17 + D);
    const auto plain(materialFrom(text));
    auto model(materialFrom(text));
    auto F0 = randomTensor<D>(random, 1.03, 0.02);
    F0.out = D < 3 ? 0.96 : 1;
    const fullTensor F0s(F0);
    tensor full0;
    for (int k = 0; k < 9; ++k) full0[k] = F0s.c[k/3][k % 3];
    model->setInitialStretch(initialStretch(tensorField(1, full0), D));
    const scalar J0 = det(full0);

    plasticPoint<D> one(*model, kinematicSet::F);
    plasticPoint<3> other(*plain, kinematicSet::F);
    if (keeps) one.s.keepFlow();
    auto F = SolidTensor<D>::identity();
    label nFlown = 0;
    for (label i = 0; i < 60; ++i)
    {
        F = combine(1, F, 0.01, randomTensor<D>(random));
        F.out = 1;
        const fullTensor Fs(F);
        SolidTensor<3> FF0;
        for (int a = 0; a < 3; ++a)
        {
            for (int b = 0; b < 3; ++b)
            {
                FF0(a, b) = 0;
                for (int k = 0; k < 3; ++k)
                {
                    FF0(a, b) += Fs.c[a][k]*F0s.c[k][b];
                }
            }
        }
        FF0.out = 1;
        const scalar dissipated = other.step(FF0);
        one.deform(F);
        one.s.sinceCommit = 1;
        if (keeps) one.stress();
        CHECK(mag(J0*model->commit(one.s, one.one) - dissipated) <= 1e-12);
        CHECK(mag(one.strain() - other.strain()) <= 1e-12);
        CHECK(mag(J0*one.energy() - other.energy()) <= 1e-12);
        CHECK(maxDiff(one.Cauchy(), other.Cauchy()) <= 1e-11);
        forAll(one.s.temperature, k)
        {
            // By mass: the density is that of the mesh
            CHECK
            (
                mag
                (
                    J0*(one.s.temperature[k] - 300)
                  - (other.s.temperature[k] - 300)
                ) <= 1e-9
            );
        }
        // Symmetric P F^T/J = sigma, of what has flown
        const auto P = one.stress();
        const auto G = cofactor(F);
        const fullTensor sigma(one.Cauchy());
        for (int a = 0; a < D; ++a)
        {
            for (int b = 0; b < D; ++b)
            {
                scalar sum = 0;
                for (int k = 0; k < D; ++k) sum += P(a, k)*F(b, k);
                CHECK(mag(sum/determinant(F, G) - sigma.c[a][b]) <= 1e-10);
            }
        }
        const Pair<scalar> yields(model->yieldState(one.s, 0));
        CHECK(yields.first() <= yields.second() + 1e-12);
        if (dissipated > 0) ++nFlown;
    }
    CHECK(nFlown > 10);
}

TEST_CASE("flow with an initial stretch", "[materials][serial]")
{
    for (const bool keeps : {false, true})
    {
        const std::string text
        (
            std::string(linear)
          + " adiabaticHeating { beta 0.9; cp 0.002; T0 300; }"
        );
        stretchedFlow<1>(text, keeps);
        stretchedFlow<2>(text, keeps);
        stretchedFlow<3>(text, keeps);
    }
}


TEST_CASE("energy of many nodes is that of each", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    Random random(3);
    conservedState s(19, 3, kinematicSet::F, true);
    s.makePlastic();
    scalarField volume(s.nNodes), one(s.nNodes, scalar(1));
    scalar sum = 0;
    const auto deform = [&]()
    {
        forAll(s.F, k) s.F[k] += 0.02*(random.sample01<scalar>() - 0.5);
    };
    deform();
    model->commit(s, one);
    deform();
    forAll(volume, a)
    {
        volume[a] = 1 + random.sample01<scalar>();
        conservedState alone(1, 3, kinematicSet::F, true);
        alone.makePlastic();
        alone.F = SubField<scalar>(s.F, 9, 9*a);
        alone.Cpi = SubField<scalar>(s.Cpi, s.strideCpi, s.strideCpi*a);
        sum += volume[a]*model->strainEnergy(alone, one);
    }
    CHECK(sum > 0);
    CHECK(model->strainEnergy(s, volume) == Approx(sum).epsilon(1e-13));
}


TEST_CASE("two dimensions are three with a plane", "[materials][serial]")
{
    const auto model(materialFrom(linear));
    plasticPoint<2> flat(*model);
    plasticPoint<3> solid(*model);
    Random random(5);
    auto F2 = SolidTensor<2>::identity();
    for (label i = 0; i < 50; ++i)
    {
        F2 = combine(1, F2, 0.02, randomTensor<2>(random));
        F2.out = 1;
        auto F3 = SolidTensor<3>::identity();
        for (int a = 0; a < 2; ++a)
        {
            for (int b = 0; b < 2; ++b) F3(a, b) = F2(a, b);
        }
        flat.step(F2);
        solid.step(F3);
        CHECK(mag(flat.strain() - solid.strain()) <= 1e-12);
        const tensor a(model->CauchyStress(flat.s, 0));
        const tensor b(model->CauchyStress(solid.s, 0));
        CHECK(mag(a - b) <= 1e-10);
        CHECK(mag(flat.energy() - solid.energy()) <= 1e-12);
    }
}


TEST_CASE("hardening curves", "[materials][serial]")
{
    const std::string common =
        "type HenckyVonMises; rho 1; mu 40; kappa 100; ";
    const auto stretched = [](const materialModel& m, const scalar dt)
    {
        plasticPoint<3> point(m);
        for (label i = 1; i <= 20; ++i)
        {
            const scalar l = std::exp(0.02*i);
            point.step(diagonal(l, 1/std::sqrt(l), 1/std::sqrt(l)), dt);
        }
        return point;
    };

    SECTION("a table of a straight line is linear hardening")
    {
        const auto table(materialFrom
        (
            common + "hardeningCurve table ((0 0.5) (0.1 0.7) (5 10.5));"
        ));
        const auto line(materialFrom(linear));
        const auto a = stretched(*table, 1), b = stretched(*line, 1);
        CHECK(mag(a.strain() - b.strain()) <= 1e-12);
        CHECK(mag(a.q() - b.q()) <= 1e-10);
    }

    SECTION("a table with kinks, beyond its end constant")
    {
        const auto table(materialFrom
        (
            common + "hardeningCurve table ((0 0.5) (0.1 0.8) (0.2 0.9));"
        ));
        const auto p = stretched(*table, 1);
        CHECK(mag(p.q() - 0.9) <= 1e-10);
        CHECK(mag(p.strain() - (0.4 - 0.9/(3*mu))) <= 1e-10);
    }

    SECTION("Johnson-Cook without rates")
    {
        const auto jc(materialFrom
        (
            common + "JohnsonCook { A 0.5; B 0.3; n 0.4; C 0; }"
        ));
        const auto p = stretched(*jc, 1);
        const scalar Y = 0.5 + 0.3*std::pow(p.strain(), 0.4);
        CHECK(mag(p.q() - Y) <= 1e-10);
        CHECK(mag(p.strain() + Y/(3*mu) - 0.4) <= 1e-10);
    }

    SECTION("Johnson-Cook with rates")
    {
        const auto jc(materialFrom
        (
            common
          + "JohnsonCook { A 0.5; B 0; n 1; C 0.1; referenceRate 2; }"
        ));
        // Perfectly plastic: strain follows with 0.02 a step
        for (const scalar dt : {1e-1, 1e-3, 1e-5})
        {
            const auto p = stretched(*jc, dt);
            const scalar Y =
                0.5*(1 + 0.1*std::log(max(scalar(1), 0.02/dt/2)));
            CHECK(mag(p.q() - Y) <= 1e-9);
        }
    }
}


TEST_CASE("heat of plastic work", "[materials][serial]")
{
    const std::string heat = "adiabaticHeating { beta 0.9; cp 2; T0 300; }";
    const auto stretch = [](plasticPoint<3>& p, const label n)
    {
        for (label k = 1; k <= n; ++k)
        {
            const scalar e = 0.2*k/n;
            p.step(diagonal(std::exp(e), std::exp(-e/2), std::exp(-e/2)));
        }
    };

    SECTION("is the work, where the hardening is a straight line")
    {
        const auto law(materialFrom(linear + heat));
        plasticPoint<3> p(*law);
        stretch(p, 7);
        const scalar e = p.strain();
        REQUIRE(e > 0.1);
        const scalar rise = 0.45*(tauY*e + 0.5*slope*e*e);
        CHECK(mag(p.s.temperature[0] - 300 - rise) <= 1e-11);
    }

    SECTION("softens")
    {
        // 1 - T* = exp(-k (A e + B e^2/2)) if both exponents are one
        const auto law(materialFrom
        (
            "type HenckyVonMises; rho 1; mu 40; kappa 100;"
            "JohnsonCook { A 0.5; B 2; n 1; C 0; m 1; Tmelt 300.2; }" + heat
        ));
        const auto error = [&](const label n)
        {
            plasticPoint<3> p(*law);
            stretch(p, n);
            const scalar e = p.strain();
            const scalar cold =
                std::exp(-0.45/0.2*(0.5*e + 0.5*2*e*e));
            CHECK(cold < 0.8);
            return (300.2 - p.s.temperature[0])/0.2 - cold;
        };
        const scalar coarse = error(100), fine = error(200);
        CHECK(mag(fine) < 2e-3);
        CHECK(mag(coarse/fine - 2) < 0.1);
    }

    SECTION("nothing bears a load where it is molten")
    {
        const auto law(materialFrom
        (
            "type HenckyVonMises; rho 1; mu 40; kappa 100;"
            "JohnsonCook { A 0.5; B 0; n 1; C 0; m 1; Tmelt 301; Troom 200; }"
          + heat
        ));
        plasticPoint<3> p(*law);
        p.s.temperature[0] = 301;
        stretch(p, 3);
        CHECK(p.q() <= 1e-12);
        CHECK(p.s.temperature[0] == 301);
    }
}


TEST_CASE("plastic input that is wrong", "[materials][serial]")
{
    const std::string common =
        "type HenckyVonMises; rho 1; mu 40; kappa 100; ";
    const auto refused = [&](const std::string& text, const char* word)
    {
        const string message
        (
            errorMessage([&]{ materialFrom(common + text); })
        );
        INFO(text << " -> " << message);
        CHECK(message.find(word) != std::string::npos);
    };
    refused("", "tauY");
    refused("tauY 0;", "tauY");
    refused("tauY 1; Hardening -1;", "Hardening");
    refused("tauY 1; JohnsonCook { A 1; B 1; n 1; C 0; }", "JohnsonCook");
    refused("JohnsonCook { A 1; B 1; n 1; D 0; }", "D");
    refused("hardeningCurve table ((0 1) (1 0.5));", "hardeningCurve");
    refused("hardeningCurve table ((0.1 1) (1 2));", "hardeningCurve");
    refused
    (
        "Hardening 1; hardeningCurve table ((0 1) (1 2));", "Hardening"
    );
}


// ************************************************************************* //
