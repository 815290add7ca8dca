/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Meshes that the median dual refuses, and what it says.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "medianDual.H"
#include "meshFactory.H"

#include <cmath>

using namespace Foam;

typedef medianDual::cellTreatment treatment;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

string message(const polyMesh& mesh, const treatment t)
{
    return errorMessage([&]{ const medianDual dual(mesh, t); });
}

const treatment allTreatments[] =
{
    treatment::simplicial, treatment::simplicialSingle, treatment::native
};

//- Cells with all boundary faces in one patch
meshFactory::result oneBoundary
(
    const pointField& points,
    const std::vector<faceList>& cells
)
{
    meshFactory::cellsByFaces what;
    what.points = points;
    what.cells = cells;
    what.patchNames = {"all"};
    what.patchTypes = {"patch"};
    what.patchOf = [](const face&) { return 0; };

    return meshFactory::make(testTime(), what);
}

const pointField cube
({
    point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0),
    point(0, 0, 1), point(1, 0, 1), point(1, 1, 1), point(0, 1, 1)
});

bool has(const string& text, const std::string& what)
{
    return text.find(what) != std::string::npos;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("inverted cells are refused", "[medianDual][serial]")
{
    for (const label nDim : {1, 2, 3})
    for (const treatment t : allTreatments)
    {
        INFO(nDim << "D " << medianDual::cellTreatmentNames[t]);

        meshFactory::block block;
        block.name = "bar";
        block.n = {{5, nDim > 1 ? 4 : 1, nDim > 2 ? 3 : 1}};
        block.isEmpty = {{false, nDim < 2, nDim < 3}};
        block.map = [](const point& p)
        {
            // One layer of points moves past the next one
            return
                mag(p.x() - 0.4) < 0.01 ? point(0.7, p.y(), p.z()) : p;
        };

        const meshFactory::result made(meshFactory::make(testTime(), block));
        const string text(message(*made.mesh, t));

        // The region, the first cell and where it is, and how many more
        CHECK(has(text, made.mesh->name()));
        CHECK(has(text, "cell 2 at (0.65"));
        CHECK(has(text, "inverted"));
        CHECK(has(text, "others") == (nDim > 1));
    }
}


TEST_CASE("cells without volume are refused", "[medianDual][serial]")
{
    for (const treatment t : allTreatments)
    {
        pointField points(cube);
        for (label i = 4; i < 8; ++i)
        {
            points[i].z() = 0;
        }

        const meshFactory::result made
        (
            oneBoundary
            (
                points,
                {meshFactory::facesOf(labelList({0, 1, 2, 3, 4, 5, 6, 7}))}
            )
        );

        CHECK(has(message(*made.mesh, t), "no volume"));
    }
}


TEST_CASE("a cell may have one bad split, not two", "[medianDual][serial]")
{
    // A dart in 2D: one diagonal is outside, the other one is fine
    meshFactory::block block;
    block.n = {{1, 1, 1}};
    block.isEmpty[2] = true;
    block.map = [](const point& p)
    {
        return p.x() > 0.5 && p.y() > 0.5 ? point(0.3, 0.3, p.z()) : p;
    };

    {
        const meshFactory::result made(meshFactory::make(testTime(), block));
        CHECK(message(*made.mesh, treatment::simplicial).empty());
    }

    // A bow tie
    block.map = [](const point& p)
    {
        return
            p.y() > 0.5
          ? point(p.x() < 0.5 ? 1.001 : 0, p.y(), p.z())
          : p;
    };

    {
        const meshFactory::result made(meshFactory::make(testTime(), block));
        CHECK(has(message(*made.mesh, treatment::simplicial), "inverted"));
    }
}


TEST_CASE("general polyhedra are refused", "[medianDual][serial]")
{
    for (const treatment t : allTreatments)
    {
        // A cube with one side made of two triangles
        faceList faces(meshFactory::facesOf(labelList({0,1,2,3,4,5,6,7})));
        const face top(faces[1]);
        faces[1] = face(labelList({top[0], top[1], top[2]}));
        faces.append(face(labelList({top[0], top[2], top[3]})));

        const meshFactory::result made(oneBoundary(cube, {faces}));
        const string text(message(*made.mesh, t));

        CHECK(has(text, made.mesh->name()));
        CHECK(has(text, "cell 0 at"));
        CHECK(has(text, "with 7 faces"));

        // OpenFOAM's wedge: a cube with one edge collapsed
        const faceList wedge
        ({
            face(labelList({0, 3, 2, 1})),
            face(labelList({0, 4, 5, 3})),
            face(labelList({1, 2, 6})),
            face(labelList({0, 1, 6, 4})),
            face(labelList({2, 3, 5, 6})),
            face(labelList({4, 6, 5}))
        });
        const meshFactory::result made2(oneBoundary(cube, {wedge}));
        CHECK(has(message(*made2.mesh, t), "cell 0 at"));
    }
}


TEST_CASE("2D and 1D meshes are one straight layer", "[medianDual][serial]")
{
    meshFactory::block block;
    block.n = {{3, 3, 2}};
    block.isEmpty[2] = true;

    {
        const meshFactory::result made(meshFactory::make(testTime(), block));
        const string text(message(*made.mesh, treatment::simplicial));
        CHECK(has(text, "one cell thick"));
        CHECK(has(text, made.mesh->name()));
    }

    block.n[2] = 1;
    block.map = [](const point& p)
    {
        return point(p.x() + 0.1*p.z(), p.y(), p.z());
    };

    {
        const meshFactory::result made(meshFactory::make(testTime(), block));
        CHECK
        (
            has
            (
                message(*made.mesh, treatment::native),
                "neither along nor across"
            )
        );
    }

    block.n = {{3, 1, 2}};
    block.isEmpty = {{false, true, true}};
    block.map = nullptr;

    {
        const meshFactory::result made(meshFactory::make(testTime(), block));
        CHECK
        (
            has(message(*made.mesh, treatment::simplicial), "one cell thick")
        );
    }
}


TEST_CASE("patches that are no boundary are refused", "[medianDual][serial]")
{
    // One side of a 2D mesh is a patch, the other one empty
    meshFactory::cellsByFaces what;
    what.points = cube;
    what.cells = {meshFactory::facesOf(labelList({0, 1, 2, 3, 4, 5, 6, 7}))};
    what.patchNames = {"sides", "back"};
    what.patchTypes = {"patch", "empty"};
    what.patchOf = [](const face& f)
    {
        return f == face(labelList({0, 3, 2, 1})) ? 1 : 0;
    };

    const meshFactory::result made(meshFactory::make(testTime(), what));
    CHECK(has(message(*made.mesh, treatment::simplicial), "should be empty"));

    // A sector of a ring about x
    const scalar c = std::cos(0.04), s = std::sin(0.04);
    what.points = pointField
    ({
        point(0, c, -s), point(1, c, -s), point(1, 2*c, -2*s),
        point(0, 2*c, -2*s), point(0, c, s), point(1, c, s),
        point(1, 2*c, 2*s), point(0, 2*c, 2*s)
    });
    what.patchNames = {"sides", "back", "front"};
    what.patchTypes = {"patch", "wedge", "wedge"};
    what.patchOf = [](const face& f)
    {
        return
            f == face(labelList({0, 3, 2, 1})) ? 1
          : f == face(labelList({4, 5, 6, 7})) ? 2 : 0;
    };

    const meshFactory::result ring(meshFactory::make(testTime(), what));
    const string text(message(*ring.mesh, treatment::simplicial));
    CHECK(has(text, "patch back is of type wedge"));
    CHECK(has(text, ring.mesh->name()));
}

// ************************************************************************* //
