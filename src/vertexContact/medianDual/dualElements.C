/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dualElements.H"
#include "polyMesh.H"
#include "solutionNodes.H"
#include "meshFile.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dualElements::add3D
(
    const label celli,
    const UList<labelList>& faces
)
{
    label nTri = 0;
    label nQuad = 0;

    forAll(faces, facei)
    {
        nTri += (faces[facei].size() == 3);
        nQuad += (faces[facei].size() == 4);
    }

    if (nTri + nQuad != faces.size()) return false;

    elementTopology::kind kind = elementTopology::nKinds;
    label baseSize = 3;

    if (nTri == 4 && nQuad == 0)
    {
        kind = elementTopology::tetrahedron;
    }
    else if (nTri == 4 && nQuad == 1)
    {
        kind = elementTopology::pyramid;
        baseSize = 4;
    }
    else if (nTri == 2 && nQuad == 3)
    {
        kind = elementTopology::prism;
    }
    else if (nTri == 0 && nQuad == 6)
    {
        kind = elementTopology::hexahedron;
        baseSize = 4;
    }
    else
    {
        return false;
    }

    label basei = 0;
    while (faces[basei].size() != baseSize)
    {
        ++basei;
    }

    // The base inwards, and what is above each of its edges: every other face
    // with this edge has it in the same sense as the inward base
    label v[8];
    label upper[4][2];
    for (label i = 0; i < baseSize; ++i) v[i] = faces[basei][baseSize - 1 - i];

    for (label i = 0; i < baseSize; ++i)
    {
        const label p = v[i];
        const label q = v[(i + 1) % baseSize];
        bool found = false;

        forAll(faces, facei)
        {
            const labelList& f = faces[facei];

            forAll(f, fp)
            {
                if (f[fp] == p && f[f.fcIndex(fp)] == q)
                {
                    if (found) return false;
                    found = true;

                    upper[i][0] = f[f.rcIndex(fp)];
                    upper[i][1] = f[f.fcIndex(f.fcIndex(fp))];
                }
            }
        }

        if (!found) return false;
    }

    // Both sides have to agree on what is above a vertex
    for (label i = 0; i < baseSize; ++i)
    {
        const label previous = (i + baseSize - 1) % baseSize;

        if (upper[i][0] != upper[previous][1]) return false;
    }

    const elementTopology& topology = elementTopology::of(kind);

    if (topology.nVertices == baseSize + 1)
    {
        v[baseSize] = upper[0][0];

        for (label i = 1; i < baseSize; ++i)
        {
            if (upper[i][0] != v[baseSize]) return false;
        }
    }
    else
    {
        for (label i = 0; i < baseSize; ++i)
        {
            v[baseSize + i] = upper[i][0];
        }
    }

    for (label i = 0; i < topology.nVertices; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (v[i] == v[j]) return false;
        }
    }

    kinds_[celli] = kind;
    for (label i = 0; i < topology.nVertices; ++i)
    {
        vertices_.append(v[i]);
    }

    return true;
}


bool Foam::dualElements::add2D
(
    const label celli,
    const UList<labelList>& faces,
    const solutionNodes& nodes
)
{
    label basei = -1;
    label nBases = 0;

    forAll(faces, facei)
    {
        const labelList& f = faces[facei];
        label nLow = 0;

        forAll(f, fp)
        {
            nLow += (nodes.nodePoint[nodes.pointNode[f[fp]]] == f[fp]);
        }

        if (nLow == f.size())
        {
            basei = facei;
            ++nBases;
        }
        else if (nLow != 0 && (nLow != 2 || f.size() != 4))
        {
            return false;
        }
    }

    if (nBases != 1) return false;

    const labelList& base = faces[basei];
    const label n = base.size();

    if (faces.size() != n + 2 || (n != 3 && n != 4)) return false;

    kinds_[celli] =
    (
        n == 3 ? elementTopology::triangle : elementTopology::quadrilateral
    );

    // The base faces against the empty direction
    const bool reverse = (nodes.handedness > 0);

    for (label i = 0; i < n; ++i)
    {
        vertices_.append(nodes.pointNode[base[reverse ? n - 1 - i : i]]);
    }

    return true;
}


bool Foam::dualElements::add1D
(
    const polyMesh& mesh,
    const label celli,
    const UList<labelList>& faces,
    const solutionNodes& nodes
)
{
    label end[2] = {-1, -1};
    label endFace = -1;
    label nEnds = 0;

    forAll(faces, facei)
    {
        const labelList& f = faces[facei];
        const label node = nodes.pointNode[f[0]];
        bool isEnd = (f.size() == 4);

        for (label fp = 1; isEnd && fp < f.size(); ++fp)
        {
            isEnd = (nodes.pointNode[f[fp]] == node);
        }

        if (isEnd)
        {
            if (nEnds == 2) return false;
            end[nEnds++] = node;
            endFace = facei;
        }
    }

    if (nEnds != 2 || end[0] == end[1] || faces.size() != 6) return false;

    // The second end is the one that faces the positive direction
    const vector outward = face(faces[endFace]).areaNormal(mesh.points());

    if (outward[nodes.directions[0]] < 0)
    {
        Swap(end[0], end[1]);
    }

    kinds_[celli] = elementTopology::segment;
    vertices_.append(end[0]);
    vertices_.append(end[1]);

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dualElements::dualElements
(
    const polyMesh& mesh,
    const solutionNodes& nodes
)
:
    kinds_(mesh.nCells()),
    start_(mesh.nCells() + 1),
    vertices_(mesh.nCells()*(nodes.nDim == 3 ? 8 : 2*nodes.nDim))
{
    List<labelList> outward;

    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        start_[celli] = vertices_.size();

        // solidBody::releaseMeshTables frees the table of the cells
        labelList cellFaces(mesh.cells()[celli]);
        Foam::sort(cellFaces);
        outward.setSize(cellFaces.size());

        forAll(outward, i)
        {
            const label facei = cellFaces[i];
            const face& f = mesh.faces()[facei];
            const bool reverse = (mesh.faceOwner()[facei] != celli);

            outward[i].setSize(f.size());
            forAll(f, fp)
            {
                outward[i][fp] = f[reverse ? f.size() - 1 - fp : fp];
            }
        }

        const bool known =
        (
            nodes.nDim == 3 ? add3D(celli, outward)
          : nodes.nDim == 2 ? add2D(celli, outward, nodes)
          : add1D(mesh, celli, outward, nodes)
        );

        if (!known)
        {
            FatalFileErrorInFunction(meshFile(mesh))
                << "Region " << mesh.name() << ": cell " << celli << " at "
                << mesh.cellCentres()[celli] << ", with " << outward.size()
                << " faces, is no "
                <<
                (
                    nodes.nDim == 3
                  ? "tetrahedron, pyramid, prism or hexahedron"
                  : nodes.nDim == 2
                  ? "triangle or quadrilateral one cell thick"
                  : "segment (a hexahedron between its two neighbours)"
                )
                << '.' << nl
                << "    General polyhedra, degenerate hexahedra (wedges), and"
                << " cells that are refined on one side only" << nl
                << "    cannot be decomposed into simplices without new"
                << " vertices."
                << exit(FatalIOError);
        }
    }

    start_[mesh.nCells()] = vertices_.size();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dualElements::renumber(const labelUList& newNode)
{
    for (label& node : vertices_) node = newNode[node];
}


// ************************************************************************* //
