/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Bodies that collide with their mirror image are computed once, against the
    plane of symmetry. Geometry and materials are those of the tutorials, and so
    is where the probes are.

\*---------------------------------------------------------------------------*/

#include "bars.H"
#include "cases.H"
#include "run.H"

#include <functional>
#include <map>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace plainFEM
{

namespace
{

//- tutorials/twoBarImpact
void twoBars(const settings& s, const double E, const double end)
{
    bar left(E, 0.01, 10, s.elements, 0.1), right(100, 0.01, 10, s.elements, 0);
    run(left, right, 0.01, s.co, s.viscosity, end).write(s, end, 4000, false);
}

void similar(const settings& s)
{
    twoBars(s, 100, 0.35);
}

void dissimilar(const settings& s)
{
    twoBars(s, 49, 0.7);
}

//- One of two bodies that meet at a plane
template<int D, class Material>
void half
(
    const settings& s,
    body<D, Material>& b,
    const plane& wall,
    const double end,
    const probes& at
)
{
    history h = run(b, &wall, s.co, end, at);
    h.bodies = 2;
    h.write(s, end, 400, false);
}

//- tutorials/ringCollision: ring 1
void rings(const settings& s)
{
    // Elements of a quarter as in its Allrun
    const int n = s.elements;
    const std::map<int, int> known = {{10, 31}, {20, 63}, {40, 127}, {80, 255}};
    const auto found = known.find(n);
    const int quarter = found == known.end() ? n*63/20 : found->second;
    mesh<2> m;
    m.addBlock({n, 4*quarter}, [](const place<2>& p) -> place<2>
    {
        const double r = 0.03 + 0.01*p[0], angle = 2*M_PI*p[1];
        return {r*std::cos(angle), r*std::sin(angle)};
    });
    body<2, neoHookean> b(m, {1000, 1e6, 0.4}, s.viscosity);
    b.throwAlong(0, 0.59);
    half(s, b, {0, -1, 0.044}, 0.04, {0, m.nearest({0.04, 0})});
}

//- tutorials/nearlyIncompressibleBars: bar 1
void incompressible(const settings& s)
{
    const int n = s.elements;
    mesh<2> m;
    m.addBlock({5*n, n}, [](const place<2>& p) -> place<2>
    {
        return {32.4e-3*p[0], 6.4e-3*(p[1] - 0.5)};
    });
    body<2, neoHookean> b(m, {8930, 585e6, 0.495}, s.viscosity);
    b.throwAlong(0, 50);
    half(s, b, {0, -1, 36.4e-3}, 325e-6, {0, m.nearest({32.4e-3, 0})});
}

//- tutorials/nonMatchingBars: bar 2, against its mirror image, which matches
void nonMatching(const settings& s)
{
    const int n = s.elements;
    mesh<3> m;
    m.addBlock({5*n, n, n}, [](const place<3>& p) -> place<3>
    {
        return {32.8e-3 + 32.4e-3*p[0], 3.2e-3*p[1], 3.2e-3*p[2]};
    });
    body<3, neoHookean> b(m, {8930, 585e6, 0.495}, s.viscosity);
    b.throwAlong(0, -50);
    half
    (
        s, b, {0, 1, 32.6e-3}, 300e-6,
        {0, m.nearest({65.2e-3, 3.2e-3, 3.2e-3})}
    );
}

//- A quarter of the rod of tutorials/taylorBar: a core, two blocks around it
mesh<3> quarterRod(const int half, const int along)
{
    constexpr double R = 3.2e-3, core = 1.6e-3, corner = 1.376e-3;
    constexpr double length = 32.4e-3;
    mesh<3> m;
    m.addBlock({half, along, half}, [&](const place<3>& p) -> place<3>
    {
        auto across = [&](double a, double b)
        {
            return a*(core + b*(corner - core));
        };
        return {across(p[0], p[2]), length*p[1], across(p[2], p[0])};
    });
    // From the core to the mantle, and from an axis to the diagonal
    auto ring = [&](double out, double turn, double& far, double& near)
    {
        const double angle = turn*M_PI/4;
        far = (1 - out)*(core + turn*(corner - core)) + out*R*std::cos(angle);
        near = (1 - out)*turn*corner + out*R*std::sin(angle);
    };
    m.addBlock({half, along, half}, [&](const place<3>& p)
    {
        place<3> at = {0, length*p[1], 0};
        ring(p[0], p[2], at[0], at[2]);
        return at;
    });
    // The other way round, or its elements were inside out
    m.addBlock({half, along, half}, [&](const place<3>& p)
    {
        place<3> at = {0, length*p[1], 0};
        ring(p[0], 1 - p[2], at[2], at[0]);
        return at;
    });
    return m;
}

//- tutorials/taylorBar
void taylor(const settings& s)
{
    if (s.elements % 2)
    {
        throw std::runtime_error("elements over the radius are even");
    }
    const mesh<3> m = quarterRod(s.elements/2, 9*s.elements);
    const HenckyVonMises copper(8930, 117e9, 0.35, 0.4e9, 0.1e9);
    body<3, HenckyVonMises> b(m, copper, s.viscosity);
    b.throwAlong(1, -227);
    for (std::size_t i = 0; i < m.points.size(); ++i)
    {
        for (int d : {0, 2})
        {
            if (m.points[i][d] < 1e-9) b.mobility[i][d] = 0;
        }
    }
    const plane wall = {1, 1, 0};
    const probes at =
        {1, m.nearest({0, 32.4e-3, 0}), m.nearest({3.2e-3, 0, 0})};
    run(b, &wall, s.co, 80e-6, at).write(s, 80e-6, 400, true);
}

} // End namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

void runCase(const settings& s)
{
    const std::map<std::string, void (*)(const settings&)> known =
    {
        {"similar", similar}, {"dissimilar", dissimilar}, {"rings", rings},
        {"incompressible", incompressible}, {"nonMatching", nonMatching},
        {"taylor", taylor}
    };
    const auto found = known.find(s.name);
    if (found == known.end())
    {
        std::string names;
        for (const auto& one : known) names += " " + one.first;
        throw std::runtime_error("no case " + s.name + "; there are" + names);
    }
    found->second(s);
}


} // End namespace plainFEM

// ************************************************************************* //
