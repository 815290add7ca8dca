/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The median dual on all kinds of cells, in all dimensions: volumes, closed
    dual cells, exact gradients of linear fields, weights, symmetry.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "dualChecks.H"
#include "meshFactory.H"
#include "nodeGraph.H"

#include <cmath>
#include <map>

using namespace Foam;

typedef medianDual::cellTreatment treatment;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const treatment allTreatments[] =
{
    treatment::simplicial, treatment::simplicialSingle, treatment::native
};

const treatment exactTreatments[] =
{
    treatment::simplicial, treatment::simplicialSingle
};

std::string kindName(const meshFactory::cellKind kind)
{
    static const char* names[] =
        {"hexes", "prisms", "pyramids", "tets", "mixed"};

    return names[kind];
}

const char* name(const treatment t)
{
    return medianDual::cellTreatmentNames[t].c_str();
}


//- Everything that holds for any mesh and treatment
void checkBasics(const medianDual& dual, const scalar volume)
{
    CHECK(dualChecks::consistent(dual));
    CHECK(dualChecks::gap(dual) < 1e-13);
    CHECK(dualChecks::weightError(dual) < 1e-13);
    CHECK(std::abs(dualChecks::volume(dual)/volume - 1) < 1e-12);
    CHECK(dual.thickness() > 0);
    CHECK(dual.bytes() > 0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("median dual, 3D: volumes, closed, linear-exact", "[medianDual]")
{
    for
    (
        const meshFactory::cellKind kind :
        {
            meshFactory::hexes, meshFactory::prisms, meshFactory::pyramids,
            meshFactory::tets, meshFactory::mixed
        }
    )
    for (const bool keepBox : {true, false})
    for (const treatment t : exactTreatments)
    {
        INFO(kindName(kind) << ' ' << name(t) << " box " << keepBox);

        meshFactory::block block;
        block.n = {{5, 4, 6}};
        block.upper = point(1, 0.8, 1.5);
        block.cells = kind;

        // The thin tetrahedra of the others are inverted sooner
        block.distortion =
            kind == meshFactory::tets || kind == meshFactory::pyramids
          ? 0.12
          : 0.2;
        block.keepBox = keepBox;

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, t);

        CHECK(dual.nDim() == 3);
        CHECK(dual.thickness() == 1);

        const scalar volume =
            keepBox
          ? scalar(1.2)*(Pstream::parRun() ? Pstream::nProcs() : 1)
          : dualChecks::boundaryVolume(dual);

        checkBasics(dual, volume);
        CHECK(dualChecks::gradientError(dual) < 1e-12);
    }
}


TEST_CASE("median dual, 2D in all planes", "[medianDual]")
{
    for (label empty = 0; empty < 3; ++empty)
    for
    (
        const meshFactory::cellKind kind :
        {meshFactory::hexes, meshFactory::prisms}
    )
    for (const treatment t : exactTreatments)
    {
        INFO(kindName(kind) << ' ' << name(t) << " empty " << empty);

        meshFactory::block block;
        block.n = {{7, 5, 6}};
        block.n[empty] = 1;
        block.upper = point(1, 0.8, 1.5);
        block.isEmpty[empty] = true;
        block.cells = kind;
        block.distortion = 0.2;

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, t);

        CHECK(dual.nDim() == 2);
        CHECK(dual.directions()[2] == -1);
        CHECK(dual.thickness() == Approx(block.upper[empty]).epsilon(1e-12));
        CHECK(2*dual.nNodes() == made.mesh->nPoints());

        checkBasics(dual, dualChecks::boundaryVolume(dual));
        CHECK(dualChecks::gradientError(dual) < 1e-12);

        // OpenFOAM's volumes of the prisms are exact here
        scalar volume = 0;
        for (const scalar v : made.mesh->cellVolumes())
        {
            volume += v;
        }
        reduce(volume, sumOp<scalar>());
        CHECK
        (
            dualChecks::volume(dual)*dual.thickness()
         == Approx(volume).epsilon(1e-12)
        );

        CHECK(dual.patches()[2*empty].nCorners() == 0);
    }
}


TEST_CASE("median dual, 1D along all axes", "[medianDual]")
{
    for (label along = 0; along < 3; ++along)
    for (const treatment t : allTreatments)
    {
        INFO(name(t) << " along " << along);

        meshFactory::block block;
        block.n = {{1, 1, 1}};
        block.n[along] = 12;
        block.isEmpty = {{true, true, true}};
        block.isEmpty[along] = false;
        block.upper = point(2, 3, 5);
        block.distortion = 0.3;
        block.keepBox = true;

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, t);

        CHECK(dual.nDim() == 1);
        CHECK(dual.directions()[0] == along);
        CHECK(dual.nNodes() == 13);
        CHECK(dual.nEdges() == 12);
        CHECK(dual.thickness() == Approx(30/block.upper[along]));

        const label nCopies = (Pstream::parRun() ? Pstream::nProcs() : 1);
        checkBasics(dual, nCopies*block.upper[along]);
        CHECK(dualChecks::gradientError(dual) < 1e-12);

        const dualPatch& lower = dual.patches()[2*along];
        const dualPatch& upper = dual.patches()[2*along + 1];
        REQUIRE(lower.nCorners() == 1);
        REQUIRE(upper.nCorners() == 1);
        CHECK(lower.cornerNormal[0] == -1);
        CHECK(upper.cornerNormal[0] == 1);
        CHECK(lower.cornerArea[0] == 1);
        CHECK(upper.weights[0] == 1);
    }
}


TEST_CASE("native dual: closed, exact on orthogonal grids", "[medianDual]")
{
    for (const label nDim : {2, 3})
    for (const scalar distortion : {0.0, 0.2})
    for
    (
        const meshFactory::cellKind kind :
        {
            meshFactory::hexes, meshFactory::prisms, meshFactory::pyramids,
            meshFactory::tets, meshFactory::mixed
        }
    )
    {
        if (nDim == 2 && kind > meshFactory::prisms)
        {
            continue;
        }

        INFO(kindName(kind) << ' ' << nDim << "D distorted " << distortion);

        meshFactory::block block;
        block.n = {{4, 6, nDim == 2 ? 1 : 5}};
        block.isEmpty[2] = (nDim == 2);
        block.cells = kind;
        block.distortion = 0.5*distortion;
        block.keepBox = true;

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, treatment::native);

        checkBasics(dual, Pstream::parRun() ? Pstream::nProcs() : 1);

        const scalar error = dualChecks::gradientError(dual);

        if (kind == meshFactory::hexes)
        {
            if (distortion == 0)
            {
                CHECK(error < 1e-12);

                // Edges of the mesh, each along its area
                const label nx = 4, ny = 6, nz = (nDim == 2 ? 0 : 5);
                CHECK
                (
                    dual.nEdges()
                 == nx*(ny + 1)*(nz + 1)
                  + (nx + 1)*ny*(nz + 1)
                  + (nx + 1)*(ny + 1)*nz
                );
            }
            else
            {
                // What the simplicial dual is there for
                CHECK(error > 1e-3);
            }
        }
    }
}


TEST_CASE("median dual: known values of one cell", "[medianDual]")
{
    meshFactory::block block;
    block.n = {{1, 1, 1}};
    block.isEmpty[2] = true;

    {
        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, treatment::simplicial);

        CHECK(dual.nNodes() == 4);
        CHECK(dual.nEdges() == 6);
        for (const scalar v : dual.nodeVolume())
        {
            CHECK(v == Approx(0.25).epsilon(1e-14));
        }

        // A side of 1 has 1/2, with (5 1)/6
        for (const label patchi : {0, 1, 2, 3})
        {
            const dualPatch& patch = dual.patches()[patchi];
            REQUIRE(patch.nCorners() == 2);
            CHECK(patch.cornerArea[0] == Approx(0.5));
            CHECK(patch.weights[0] == Approx(5.0/12));
            CHECK(patch.weights[1] == Approx(1.0/12));

            scalar expected[2] = {0, 0};
            expected[patchi/2] = (patchi % 2 ? 1 : -1);
            CHECK(patch.cornerNormal[0] == Approx(expected[0]));
            CHECK(patch.cornerNormal[1] == Approx(expected[1]));
        }
    }

    block.isEmpty[2] = false;

    {
        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual mean(*made.mesh, treatment::simplicial);
        const medianDual single(*made.mesh, treatment::simplicialSingle);
        const medianDual native(*made.mesh, treatment::native);

        CHECK(mean.nEdges() == 24);
        CHECK(native.nEdges() == 12);

        // Six tetrahedra round one diagonal of the cube
        CHECK(single.nEdges() == 19);

        for (const scalar v : mean.nodeVolume())
        {
            CHECK(v == Approx(0.125).epsilon(1e-14));
        }

        // (6 1 1)/8 of a third of half a face: two of the four triangles have
        // a corner with the weight of 6, and by half each
        const dualPatch& patch = mean.patches()[0];
        REQUIRE(patch.nCorners() == 4);
        CHECK(patch.cornerArea[0] == Approx(0.25));
        CHECK(patch.weights[0] == Approx(3*0.5*0.5*6.0/24));
        CHECK(patch.weights[1] == Approx(2*0.5*0.5/24));
        CHECK(patch.weights[2] == Approx(2*0.5*0.5/24));
        CHECK(patch.weights[3] == Approx(2*0.5*0.5/24));
    }
}


TEST_CASE("simplicial dual has no preferred side", "[medianDual]")
{
    // A mesh that is its own mirror image in x, with y and z distorted by
    // x*x only: volumes and edges have to be, too
    for
    (
        const meshFactory::cellKind kind :
        {meshFactory::hexes, meshFactory::pyramids}
    )
    for (const label nDim : {2, 3})
    {
        if (nDim == 2 && kind == meshFactory::pyramids)
        {
            continue;
        }

        INFO(kindName(kind) << ' ' << nDim << 'D');

        meshFactory::block block;
        block.n = {{6, 4, nDim == 2 ? 1 : 4}};
        block.isEmpty[2] = (nDim == 2);
        block.lower = point(-1, 0, 0);
        block.cells = kind;
        block.map = [nDim](const point& p)
        {
            return point
            (
                p.x()*(1 + 0.1*p.y() - (nDim == 3 ? 0.2*p.z() : 0)),
                p.y() + 0.2*sqr(p.x()),
                p.z() + (nDim == 3 ? 0.1*sqr(p.x())*p.y() : 0)
            );
        };

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, treatment::simplicial);

        const label d = dual.nDim();
        const scalarField& x = dual.nodePosition();

        labelList mirror(dual.nNodes(), label(-1));
        forAll(mirror, a)
        {
            forAll(mirror, b)
            {
                scalar distance = mag(x[a*d] + x[b*d]);
                for (label k = 1; k < d; ++k)
                {
                    distance += mag(x[a*d + k] - x[b*d + k]);
                }

                if (distance < 1e-9)
                {
                    mirror[a] = b;
                }
            }

            REQUIRE(mirror[a] != -1);
            CHECK
            (
                dual.nodeVolume()[a]
             == Approx(dual.nodeVolume()[mirror[a]]).epsilon(1e-12)
            );
        }

        std::map<std::pair<label, label>, label> edges;
        for (label e = 0; e < dual.nEdges(); ++e)
        {
            const label* ab = dual.edgeNodes().cdata() + 2*e;
            edges[{ab[0], ab[1]}] = e;
        }

        scalar worst = 0;
        label nMissing = 0;
        for (label e = 0; e < dual.nEdges(); ++e)
        {
            const label a = mirror[dual.edgeNodes()[2*e]];
            const label b = mirror[dual.edgeNodes()[2*e + 1]];
            const auto found = edges.find({min(a, b), max(a, b)});

            if (found == edges.end())
            {
                ++nMissing;
                continue;
            }

            for (label k = 0; k < d; ++k)
            {
                const scalar sign = (a < b ? 1 : -1)*(k == 0 ? -1 : 1);

                worst =
                    max
                    (
                        worst,
                        mag
                        (
                            dual.edgeArea()[e*d + k]
                          - sign*dual.edgeArea()[found->second*d + k]
                        )
                    );
            }
        }

        CHECK(nMissing == 0);
        CHECK(worst < 1e-14);
    }
}


TEST_CASE("single split does not depend on labels", "[medianDual]")
{
    // The same grid twice, numbered from the other end the second time
    auto edgeSet = [](const bool reverse, const scalar distortion)
    {
        meshFactory::block block;
        block.n = {{3, 4, 2}};
        block.distortion = distortion;

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const polyMesh& mesh = *made.mesh;

        meshFactory::cellsByFaces cells;
        const label nPoints = mesh.nPoints();
        auto renumbered = [&](const label pointi)
        {
            return reverse ? nPoints - 1 - pointi : pointi;
        };

        cells.points.setSize(nPoints);
        forAll(mesh.points(), pointi)
        {
            cells.points[renumbered(pointi)] = mesh.points()[pointi];
        }

        cells.cells.resize(mesh.nCells());
        forAll(mesh.cells(), celli)
        {
            const label newCell = (reverse ? mesh.nCells() - 1 - celli : celli);
            faceList& faces = cells.cells[newCell];
            for (const label facei : mesh.cells()[celli])
            {
                face f(mesh.faces()[facei]);
                if (mesh.faceOwner()[facei] != celli)
                {
                    f = f.reverseFace();
                }
                forAll(f, fp)
                {
                    f[fp] = renumbered(f[fp]);
                }
                if (reverse)
                {
                    std::rotate(f.begin(), f.begin() + 1, f.end());
                }
                faces.append(f);
            }
        }

        cells.patchNames = {"all"};
        cells.patchTypes = {"patch"};
        cells.patchOf = [](const face&) { return 0; };

        const meshFactory::result again(meshFactory::make(testTime(), cells));
        const medianDual dual(*again.mesh, treatment::simplicialSingle);

        std::map<std::pair<label, label>, scalar> result;
        for (label e = 0; e < dual.nEdges(); ++e)
        {
            const label a =
                renumbered(dual.nodePoint()[dual.edgeNodes()[2*e]]);
            const label b =
                renumbered(dual.nodePoint()[dual.edgeNodes()[2*e + 1]]);

            result[{min(a, b), max(a, b)}] =
                (a < b ? 1 : -1)*dual.edgeArea()[3*e];
        }

        return result;
    };

    for (const scalar distortion : {0.0, 0.2})
    {
        const auto one = edgeSet(false, distortion);
        const auto other = edgeSet(true, distortion);

        REQUIRE(one.size() == other.size());

        scalar worst = 0;
        bool same = true;
        auto o = other.begin();
        for (const auto& e : one)
        {
            same = same && e.first == o->first;
            worst = max(worst, mag(e.second - o->second));
            ++o;
        }

        CHECK(same);
        CHECK(worst < 1e-15);
    }
}


TEST_CASE("nodes are numbered such that neighbours are close", "[medianDual]")
{
    meshFactory::block block;
    block.n = {{40, 5, 4}};

    const meshFactory::result made(meshFactory::make(testTime(), block));
    const medianDual dual(*made.mesh, treatment::simplicial);

    // Little more than two layers of 6 x 5 points
    CHECK(dualChecks::bandwidth(dual) <= 75);

    // Nothing to gain: as in the mesh, two layers of 5 x 5 points
    block.n = {{4, 4, 40}};

    const meshFactory::result good(meshFactory::make(testTime(), block));
    const medianDual same(*good.mesh, treatment::simplicial);

    forAll(same.pointNode(), pointi)
    {
        CHECK(same.pointNode()[pointi] == pointi);
    }
}


TEST_CASE("nodes near given ones are together", "[medianDual][serial]")
{
    // Layers of rows of nodes. Those near the ends of rows are in as many parts
    // as there are rows
    const label across = 10, rows = 8, layers = 12, layer = across*rows;
    const label n = layer*layers, distance = 4;
    const nodeGraph graph(n, [&](const auto& edge)
    {
        for (label a = 0; a < n; ++a)
        {
            if (a % across < across - 1) edge(a, a + 1);
            if (a % layer < layer - across) edge(a, a + across);
            if (a < n - layer) edge(a, a + layer);
        }
    });
    labelList ends(rows*layers);
    forAll(ends, row) ends[row] = across*row + across - 1;
    const labelList newNode(graph.gather(ends, distance));

    labelList order(n, label(-1));
    forAll(newNode, a) order[newNode[a]] = a;
    const auto isNear = [&](const label a)
    {
        return across - 1 - a % across < distance;
    };
    const label window = label(graph.span(identity(n))) + 1;
    label nParts = 0, nMoved = 0;
    for (label i = 0; i < n; ++i)
    {
        REQUIRE(order[i] >= 0);
        CHECK(order[i]/window == i/window);
        nMoved += order[i] != i;
        nParts += isNear(order[i]) && (i == 0 || !isNear(order[i - 1]));
    }
    CHECK(nMoved > 0);
    CHECK(nParts <= n/window/2 + 1);
    CHECK(nParts < ends.size()/2);

    // Elsewhere nothing changes
    CHECK(graph.gather(labelList(), distance) == identity(n));
}


TEST_CASE("median dual in small and large units", "[medianDual]")
{
    for (const scalar size : {1e-9, 1e-3, 1e6})
    for (const treatment t : exactTreatments)
    {
        INFO(size << ' ' << name(t));

        meshFactory::block block;
        block.n = {{3, 3, 3}};
        block.distortion = 0.2;
        block.map = [size](const point& p)
        {
            return point(size*p.x(), size*p.y(), size*p.z());
        };

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, t);

        CHECK(dualChecks::gap(dual) < 1e-13);

        // The field has a constant of order 1: round-off of that, over size
        CHECK
        (
            dualChecks::volume(dual)
         == Approx(dualChecks::boundaryVolume(dual)).epsilon(1e-12)
        );
    }
}


TEST_CASE("median dual: thin layers", "[medianDual]")
{
    for (const scalar thin : {1e-3, 1e-6})
    for (const treatment t : allTreatments)
    {
        INFO(thin << ' ' << name(t));

        meshFactory::block block;
        block.n = {{4, 4, 4}};
        block.upper = point(1, 1, thin);
        block.distortion = 0.1;
        block.keepBox = true;

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const medianDual dual(*made.mesh, t);

        checkBasics(dual, thin*(Pstream::parRun() ? Pstream::nProcs() : 1));
    }
}

// ************************************************************************* //
