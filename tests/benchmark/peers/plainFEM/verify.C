/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What has a known answer: tensors, single points, bodies, bars, contact.

\*---------------------------------------------------------------------------*/

#include "bars.H"
#include "cases.H"
#include "run.H"

#include <algorithm>
#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace plainFEM
{

namespace
{

bool good = true;

//- A line: what, and its error, which is to be at most limit
void check(const std::string& what, const double error, const double limit)
{
    const bool ok = error <= limit;
    good = good && ok;
    std::printf
    (
        "%-62s %9.2e <= %7.0e  %s\n",
        what.c_str(), error, limit, ok ? "ok" : "WRONG"
    );
}

//- The same numbers in each run, from -1 to 1
double anyNumber()
{
    static std::mt19937 engine(1);
    return 2.0*engine()/engine.max() - 1;
}

const neoHookean rubber(1000, 1e6, 0.4);
const neoHookean stiff(8930, 585e6, 0.495);
const HenckyVonMises elasticCopper(8930, 117e9, 0.35, 1e12, 0);
const HenckyVonMises copper(8930, 117e9, 0.35, 0.4e9, 0.1e9);


// * * * * * * * * * * * * * * * Single points * * * * * * * * * * * * * * * //

void numbers()
{
    double root = 0, log = 0;
    for (int k = 0; k < 1000; ++k)
    {
        lanes a{};
        const double range = k % 2 ? 10 : 0.05;
        for (int l = 0; l < width; ++l) a[l] = std::exp(range*anyNumber());
        const lanes r = inverseCubeRoot(a), e = logarithm(a);
        for (int l = 0; l < width; ++l)
        {
            root = std::max(root, std::abs(r[l]*std::cbrt(a[l]) - 1));
            log = std::max(log, std::abs(e[l] - std::log(a[l]))/range);
        }
    }
    check("cube roots", root, 1e-14);
    check("logarithms", log, 1e-14);
}

//- Nodes to lanes and back
template<int D>
void lanesOfNodes(const std::string& name)
{
    nodalField<D> x(20), f(20, typename nodal<D>::type{});
    for (auto& at : x) for (int d = 0; d < D; ++d) at[d] = anyNumber();
    const int nodes[8] = {3, 14, 15, 9, 2, 6, 5, 3};
    lanes values[D];
    gather(x.data(), nodes, values);
    subtract(f.data(), nodes, values);
    double off = 0;
    for (int l = 0; l < width; ++l) for (int d = 0; d < D; ++d)
    {
        off = std::max(off, std::abs(values[d][l] - x[nodes[l]][d]));
        const int times = std::count(nodes, nodes + width, nodes[l]);
        off = std::max(off, std::abs(f[nodes[l]][d] + times*x[nodes[l]][d]));
    }
    check("from nodes and back, " + name, off, 1e-15);
}

symmetric<3> anySymmetric(const double range)
{
    symmetric<3> A;
    for (lanes& a : A.at) for (int l = 0; l < width; ++l)
    {
        a[l] = range*anyNumber();
    }
    return A;
}

//- The greatest difference in any lane
template<class Tensor>
double difference(const Tensor& A, const Tensor& B)
{
    double off = 0;
    for (std::size_t k = 0; k < std::size(A.at); ++k)
    {
        const lanes d = A.at[k] - B.at[k];
        off = std::max(off, greatest(d < 0.0 ? -d : d));
    }
    return off;
}

void tensorFunctions()
{
    double series = 0, inverse = 0;
    for (int k = 0; k < 300; ++k)
    {
        const symmetric<3> A = anySymmetric(0.06);
        symmetric<3> E, L;
        for (int l = 0; l < width; ++l)
        {
            ofPrincipal(A, l, exponentialFunction::of, E);
            ofPrincipal(A, l, naturalLogarithm::of, L);
        }
        series = std::max(series, difference(exponential(A), E));
        series = std::max(series, difference(logarithmOf1Plus(A), L));
        // Both small ones and large ones
        const symmetric<3> B = anySymmetric(0.3);
        symmetric<3> X = exponential(B);
        for (int i : {0, 3, 5}) X.at[i] -= 1.0;
        inverse = std::max(inverse, difference(logarithmOf1Plus(X), B));
    }
    check("functions of tensors: series and principal values", series, 1e-14);
    check("logarithm of the exponential", inverse, 1e-14);
}

//- Copper stretched by e = 1 while it turns by 2 rad, in so many steps:
//  q = (Y + H e)/(1 + H/3mu), tau = q (n n - 1/3)
void plasticPoint(const int steps)
{
    HenckyVonMises::point<3> point;
    point.volume = point.perVolume = all(1);
    point.metric = {};
    for (int i : {0, 3, 5}) point.metric.at[i] = all(1);
    tensor<3> F{}, P{};
    lanes work{}, energy{};
    for (int k = 1; k <= steps; ++k)
    {
        const double e = 1.0*k/steps, turn = 2.0*k/steps;
        const double U = std::exp(e), V = std::exp(-e/2);
        const double rows[9] =
        {
            std::cos(turn)*U, -std::sin(turn)*V, 0,
            std::sin(turn)*U, std::cos(turn)*V, 0,
            0, 0, V
        };
        for (int i = 0; i < 9; ++i) F.at[i] = all(rows[i]);
        const tensor<3> cof = cofactor(F);
        energy = lanes{};
        P = copper.stress(point, F, cof, determinant(F, cof), energy, work);
    }
    const double Y = copper.yield, H = copper.hardening, mu = copper.mu;
    const double q = (Y + H)/(1 + H/(3*mu)), strain = 1 - q/(3*mu);
    const double n[3] = {std::cos(2.0), std::sin(2.0), 0};
    double off = 0;
    for (int i = 0; i < 3; ++i) for (int j = 0; j < 3; ++j)
    {
        double tau = 0;
        for (int k = 0; k < 3; ++k) tau += P(i, k)[0]*F(j, k)[0];
        off = std::max(off, std::abs(tau/q - n[i]*n[j] + (i == j)/3.0));
    }
    const std::string name = "plastic point, " + std::to_string(steps)
      + (steps > 1 ? " steps: " : " step: ");
    check(name + "stress", off, 1e-10);
    check(name + "strain", std::abs(point.strain[0]/strain - 1), 1e-10);
    check
    (
        name + "work",
        std::abs(work[0]/(Y*strain + H/2*strain*strain) - 1), 1e-10
    );
    check(name + "energy", std::abs(energy[0]/(q*q/(6*mu)) - 1), 1e-10);
}


// * * * * * * * * * * * * * * * * *  Bodies * * * * * * * * * * * * * * * * //

template<int D>
bool isInside(const place<D>& p)
{
    return std::all_of(p.begin(), p.end(), [](double c)
    {
        return c > 1e-9 && c < 1 - 1e-9;
    });
}

//- A unit block of n elements in each direction, inner points moved
template<int D>
mesh<D> distorted(const int n)
{
    mesh<D> m;
    std::array<int, D> number;
    number.fill(n);
    m.addBlock(number, [&](place<D> p)
    {
        const bool inside = isInside<D>(p);
        for (double& c : p) c += inside ? 0.25/n*anyNumber() : 0;
        return p;
    });
    return m;
}

//- Largest component at the nodes that count
template<int D, class Counts>
double largest(const nodalField<D>& f, const Counts& counts)
{
    double most = 0;
    for (std::size_t i = 0; i < f.size(); ++i) for (int d = 0; d < D; ++d)
    {
        if (counts(i)) most = std::max(most, std::abs(f[i][d]));
    }
    return most;
}

//- Move the nodes to A X and compute the forces
template<int D, class Material>
void deform(body<D, Material>& b, const double (&A)[3][3])
{
    for (std::size_t i = 0; i < b.x.size(); ++i) for (int d = 0; d < D; ++d)
    {
        b.x[i][d] = b.f[i][d] = 0;
        for (int k = 0; k < D; ++k) b.x[i][d] += A[d][k]*b.X[i][k];
    }
    b.forces(0);
}

template<int D, class Material>
void patchTest(const std::string& name, const Material& material)
{
    const mesh<D> m = distorted<D>(4);
    body<D, Material> b(m, material, 0);
    double A[3][3];
    for (auto& row : A) for (double& a : row) a = 0.2*anyNumber();
    for (int i = 0; i < 3; ++i) A[i][i] += 1;
    deform(b, A);
    auto every = [](int) { return true; };
    const double most = largest<D>(b.f, every);
    check
    (
        "patch test, " + name,
        largest<D>(b.f, [&](int i) { return isInside<D>(m.points[i]); })/most,
        1e-12
    );
    const double c = std::cos(1), s = std::sin(1);
    deform(b, {{c, -s, 0}, {s, c, 0}, {0, 0, 1}});
    check("a rotation has no forces, " + name, largest<D>(b.f, every)/most,
        1e-12);
}

template<int D, class Material>
void derivativeTest(const std::string& name, const Material& material)
{
    body<D, Material> b(distorted<D>(2), material, 0);
    for (auto& x : b.x) for (int d = 0; d < D; ++d) x[d] += 0.05*anyNumber();
    b.forces(0);
    const nodalField<D> f = b.f;
    double off = 0;
    for (std::size_t i = 0; i < b.x.size(); ++i) for (int d = 0; d < D; ++d)
    {
        const double h = 1e-6, at = b.x[i][d];
        double energy[2];
        for (int k : {0, 1})
        {
            b.x[i][d] = at + (k ? h : -h);
            b.forces(0);
            energy[k] = b.strainEnergy;
        }
        b.x[i][d] = at;
        off = std::max(off, std::abs((energy[1] - energy[0])/(2*h) + f[i][d]));
    }
    check("forces are derivatives of the energy, " + name,
        off/largest<D>(f, [](int) { return true; }), 1e-8);
}

template<int D, class Material>
double momentum(const body<D, Material>& b, const int axis)
{
    double total = 0;
    for (std::size_t i = 0; i < b.v.size(); ++i)
    {
        total += b.mass[i]*b.v[i][axis];
    }
    return total;
}

//- A free body that swings with large strains, without viscosity
template<int D, class Material>
void energyTest(const std::string& name, const Material& material)
{
    const mesh<D> m = distorted<D>(4);
    double off[2] = {0, 0};
    for (int k : {0, 1})
    {
        body<D, Material> b(m, material, 0);
        for (std::size_t i = 0; i < b.v.size(); ++i)
        {
            b.v[i][0] = 0.2*material.c*(m.points[i][0] - 0.5);
            b.v[i][1] = 0.1*material.c*m.points[i][0];
        }
        const double before = momentum(b, 1);
        const history h =
            run<D, Material>(b, nullptr, k ? 0.25 : 0.5, 4/material.c, {0, 0});
        for (const row& r : h.rows)
        {
            off[k] = std::max(off[k], std::abs(r.energy + r.plasticWork - 1));
        }
        if (k)
        {
            check("momentum, " + name,
                std::abs(momentum(b, 1)/before - 1), 1e-12);
        }
    }
    check("energy at half of the step, " + name, off[1], 3e-3);
    check("    over that at the whole step", off[1]/off[0], 0.35);
}

//- A body that hits a plane and flies away
template<int D, class Material>
void contactTest(const std::string& name, const Material& material)
{
    body<D, Material> b(distorted<D>(6), material, 0.06);
    b.throwAlong(0, 0.05*material.c);
    const double before = momentum(b, 0);
    const plane wall = {0, -1, 1.01};
    const history h =
        run<D, Material>(b, &wall, 0.9, 6/material.c, {0, 0});
    const double impulse = h.rows.back().impulse;
    check("impulse of a plane is the change of momentum, " + name,
        std::abs(impulse/(momentum(b, 0) - before) - 1), 1e-12);
    check("    over twice the momentum, less one",
        std::abs(impulse/(2*before) + 1), 0.2);
    check("    rise of the energy", h.rise, 1e-3);
}


// * * * * * * * * * * * * * * * * * * Bars  * * * * * * * * * * * * * * * * //

//- A free bar that swings in its first mode: with the step dt the lumped
//  elements have sin(w dt/2) = c dt/h sin(k h/2), and the displacement of the
//  end is dt V sin(w t)/sin(w dt)
void standingWave()
{
    const int n = 100, steps = 1000;
    bar b(100, 0.01, 10, n, 0);
    const double k = M_PI/b.length, dt = 0.7*b.h/b.c;
    for (int i = 0; i <= n; ++i) b.v[i] = 0.1*std::cos(k*b.h*i);
    for (int step = 0; step < steps; ++step)
    {
        b.stresses(0);
        b.move(step ? dt : dt/2, dt, 0);
        for (int end : {0, 1}) b.moveEnd(end, dt, 0);
    }
    const double angle = 2*std::asin(b.c*dt/b.h*std::sin(k*b.h/2));
    const double by = 0.1*dt*std::sin(angle*steps)/std::sin(angle);
    const double exact = 0.1*std::sin(k*b.c*dt*steps)/(k*b.c);
    double off = 0, waveOff = 0;
    for (int i = 0; i <= n; ++i)
    {
        const double mode = std::cos(k*b.h*i);
        off = std::max(off, std::abs(b.u[i] - by*mode));
        waveOff = std::max(waveOff, std::abs(b.u[i] - exact*mode));
    }
    check("standing wave of a bar, as the elements have it", off, 1e-13);
    check("    as a bar has it", waveOff/(0.1/(k*b.c)), 1e-3);
}

//- Equal bars share their velocity for as long as waves run to the ends and
//  back: the impulse is rho c V/2 times 0.2 s
void impactOfBars()
{
    bar left(100, 0.01, 10, 400, 0.1), right(100, 0.01, 10, 400, 0);
    const history h = run(left, right, 0.01, 0.9, 0.06, 0.35);
    const row& last = h.rows.back();
    check("impact of equal bars: impulse", std::abs(last.impulse/0.01 + 1),
        0.01);
    check("    velocity after it, over the first one",
        std::abs(last.velocity)/0.1, 0.02);
    double total = 0;
    for (const bar* b : {&left, &right})
    {
        for (int i = 0; i <= b->n; ++i)
        {
            total += b->v[i]*b->rho*b->h*(i % b->n ? 1 : 0.5);
        }
    }
    check("    momentum", std::abs(total/0.01 - 1), 1e-12);
    check("    rise of the energy", h.rise, 1e-3);
}

} // End namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

bool verify()
{
    numbers();
    lanesOfNodes<2>("2D");
    lanesOfNodes<3>("3D");
    tensorFunctions();
    for (int steps : {1, 10, 1000}) plasticPoint(steps);

    patchTest<2>("2D neo-Hookean", rubber);
    patchTest<3>("3D neo-Hookean", stiff);
    patchTest<3>("3D Hencky", elasticCopper);
    derivativeTest<2>("2D neo-Hookean", rubber);
    derivativeTest<3>("3D neo-Hookean", stiff);
    derivativeTest<3>("3D Hencky", elasticCopper);
    energyTest<2>("2D neo-Hookean", rubber);
    energyTest<3>("3D neo-Hookean", stiff);
    energyTest<3>("3D Hencky", elasticCopper);
    energyTest<3>("3D plastic", copper);
    contactTest<2>("2D neo-Hookean", rubber);
    contactTest<3>("3D Hencky", elasticCopper);

    standingWave();
    impactOfBars();
    return good;
}


} // End namespace plainFEM

// ************************************************************************* //
