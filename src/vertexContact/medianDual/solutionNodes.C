/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solutionNodes.H"
#include "coupledPolyPatch.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"
#include "wedgePolyPatch.H"
#include "meshFile.H"

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace Foam
{
    // Tolerance for edges along or across the solution directions, and for a
    // constant thickness. Generous, since meshes are written with few digits
    static const scalar straightness = 1e-3;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Root of the group of a point, with path halving
static label groupRoot(labelList& parent, label i)
{
    while (parent[i] != i)
    {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }

    return i;
}


//- FatalIOError for patches over which the dual mesh cannot be closed
static void checkPatches(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        // processorCyclic is derived from processor
        const bool coupled =
            isA<coupledPolyPatch>(patch)
         && patch.type() != processorPolyPatch::typeName;

        if (coupled || isA<wedgePolyPatch>(patch))
        {
            FatalFileErrorInFunction(meshFile(mesh))
                << "Region " << mesh.name() << ": patch " << patch.name()
                << " is of type " << patch.type() << '.' << nl
                << "    Bodies have no wedge, cyclic or non-conformal"
                << " patches: join the mesh, or use symmetryPlane," << nl
                << "    or (between bodies) a contact interface."
                << exit(FatalIOError);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solutionNodes::collapse(const polyMesh& mesh)
{
    const pointField& points = mesh.points();

    labelList parent(identity(points.size()));

    for (const face& f : mesh.faces())
    {
        forAll(f, fp)
        {
            const label p = f[fp];
            const label q = f.nextLabel(fp);

            scalar all = 0;
            scalar along = 0;

            for (direction cmpt = 0; cmpt < 3; ++cmpt)
            {
                all += sqr(points[q][cmpt] - points[p][cmpt]);
            }

            for (label i = 0; i < nDim; ++i)
            {
                const label cmpt = directions[i];
                along += sqr(points[q][cmpt] - points[p][cmpt]);
            }

            const scalar across = max(all - along, scalar(0));

            if (along <= sqr(straightness)*across)
            {
                const label rootP = groupRoot(parent, p);
                const label rootQ = groupRoot(parent, q);

                // The lower one is the root, since order below is ascending
                parent[max(rootP, rootQ)] = min(rootP, rootQ);
            }
            else if (across > sqr(straightness)*along)
            {
                FatalFileErrorInFunction(meshFile(mesh))
                    << "Region " << mesh.name() << ": the edge from "
                    << points[p] << " to " << points[q]
                    << " is neither along nor across the empty direction"
                    << (nDim == 1 ? "s" : "") << '.' << nl
                    << "    A mesh with empty patches has to be one straight"
                    << " layer of cells along a coordinate axis." << nl
                    << "    From gmsh: Layers {1}; Recombine; in Extrude"
                    << exit(FatalIOError);
            }
        }
    }

    label nNodes = 0;
    forAll(parent, pointi)
    {
        const label root = groupRoot(parent, pointi);

        pointNode[pointi] = (root == pointi ? nNodes++ : pointNode[root]);
    }

    nodePoint.setSize(nNodes);
}


void Foam::solutionNodes::check(const polyMesh& mesh)
{
    const pointField& points = mesh.points();
    const label nNodes = nodePoint.size();
    const label nPointsOfNode = (nDim == 2 ? 2 : 4);

    // Bounding box of each node in the directions that are not solved
    bool isEmpty[3] = {true, true, true};
    for (label i = 0; i < nDim; ++i) isEmpty[directions[i]] = false;

    labelList nPoints(nNodes, Zero);
    List<point> lower(nNodes, point::uniform(GREAT));
    List<point> upper(nNodes, point::uniform(-GREAT));

    nodePoint = -1;

    forAll(points, pointi)
    {
        const label node = pointNode[pointi];
        const point& p = points[pointi];

        ++nPoints[node];

        bool first = (nodePoint[node] == -1);
        bool decided = first;

        for (direction cmpt = 0; cmpt < 3; ++cmpt)
        {
            if (isEmpty[cmpt])
            {
                lower[node][cmpt] = min(lower[node][cmpt], p[cmpt]);
                upper[node][cmpt] = max(upper[node][cmpt], p[cmpt]);

                if (!decided)
                {
                    const scalar other = points[nodePoint[node]][cmpt];
                    first = p[cmpt] < other;
                    decided = p[cmpt] != other;
                }
            }
        }

        if (first) nodePoint[node] = pointi;
    }

    scalar smallest = GREAT;
    scalar largest = -GREAT;

    forAll(nPoints, node)
    {
        if (nPoints[node] != nPointsOfNode)
        {
            FatalFileErrorInFunction(meshFile(mesh))
                << "Region " << mesh.name() << ": " << nPoints[node]
                << " points lie behind each other at "
                << points[nodePoint[node]] << ", where a " << nDim
                << "D mesh has " << nPointsOfNode << '.' << nl
                << "    A mesh with empty patches has to be exactly one cell"
                << " thick, and have empty patches on both sides."
                << nl << "    From gmsh: Layers {1}; Recombine; in Extrude"
                << exit(FatalIOError);
        }

        scalar extent = 1;
        for (direction cmpt = 0; cmpt < 3; ++cmpt)
        {
            if (isEmpty[cmpt]) extent *= upper[node][cmpt] - lower[node][cmpt];
        }

        smallest = min(smallest, extent);
        largest = max(largest, extent);
    }

    reduce(smallest, minOp<scalar>());
    reduce(largest, maxOp<scalar>());

    if (largest > 0)
    {
        if (largest - smallest > straightness*largest)
        {
            FatalFileErrorInFunction(meshFile(mesh))
                << "Region " << mesh.name() << ": the "
                << (nDim == 2 ? "thickness" : "cross-section")
                << " of the " << nDim << "D mesh is not constant, it is from "
                << smallest << " to " << largest << '.'
                << exit(FatalIOError);
        }

        thickness = 0.5*(smallest + largest);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solutionNodes::solutionNodes(const polyMesh& mesh)
:
    nDim(0),
    directions(label(-1)),
    handedness(1),
    pointNode(mesh.nPoints()),
    nodePoint(),
    thickness(1)
{
    checkPatches(mesh);

    const Vector<label>& solved = mesh.geometricD();

    for (direction cmpt = 0; cmpt < 3; ++cmpt)
    {
        if (solved[cmpt] == 1) directions[nDim++] = cmpt;
    }

    if (nDim == 0)
    {
        FatalFileErrorInFunction(meshFile(mesh))
            << "Region " << mesh.name() << ": empty patches take out all"
            << " three directions; they have to be normal to a coordinate axis."
            << exit(FatalIOError);
    }

    if (nDim == 3)
    {
        nodePoint.setSize(mesh.nPoints());

        forAll(pointNode, pointi)
        {
            pointNode[pointi] = pointi;
            nodePoint[pointi] = pointi;
        }
    }
    else
    {
        if (nDim == 2)
        {
            // x-y and y-z with the third direction are right-handed, x-z not
            handedness = (directions[1] - directions[0] == 1 ? 1 : -1);
        }

        collapse(mesh);
        check(mesh);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solutionNodes::renumber(const labelUList& newNode)
{
    forAll(pointNode, pointi)
    {
        pointNode[pointi] = newNode[pointNode[pointi]];
    }

    const labelList oldPoint(nodePoint);

    forAll(oldPoint, node)
    {
        nodePoint[newNode[node]] = oldPoint[node];
    }
}


void Foam::solutionNodes::positions(const polyMesh& mesh, scalarField& x) const
{
    const pointField& points = mesh.points();

    x.setSize(size()*nDim);

    forAll(nodePoint, node)
    {
        for (label i = 0; i < nDim; ++i)
        {
            x[node*nDim + i] = points[nodePoint[node]][directions[i]];
        }
    }
}


// ************************************************************************* //
