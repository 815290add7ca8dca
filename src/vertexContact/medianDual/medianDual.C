/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "medianDual.H"
#include "dualElements.H"
#include "DynamicList.H"
#include "nativeDual.H"
#include "nodeGraph.H"
#include "polyMesh.H"
#include "sharedEdges.H"
#include "simplexDecomposition.H"
#include "solutionNodes.H"
#include "meshFile.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::medianDual::cellTreatment>
Foam::medianDual::cellTreatmentNames
({
    { cellTreatment::simplicial, "simplicial" },
    { cellTreatment::simplicialSingle, "simplicialSingle" },
    { cellTreatment::native, "native" }
});


// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace Foam
{
    // Edges with less than this share of the faces of their dual cells have
    // only round-off, and no normal
    static const scalar noArea = 1e-14;

    // The mesh's own order is kept unless renumbering reduces the mean distance
    // of neighbours below this share: at equal distance a structured order
    // streams better
    static const scalar worthRenumbering = 0.9;

    // Distance from nodes that processors share, in edges, from which on passes
    // do no edges before all others (earlyEdges): three passes, each of which
    // adds the nodes of an edge and of its block
    static const label earlyDistance = 6;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Graph of the nodes that edges of elements connect
static nodeGraph elementGraph
(
    const label nNodes,
    const dualElements& elements,
    const simplexDecomposition& decomposition,
    const bool native
)
{
    return nodeGraph
    (
        nNodes,
        [&](const auto& edge)
        {
            for (label elementi = 0; elementi < elements.size(); ++elementi)
            {
                const elementTopology& topology = elements.topology(elementi);
                const label* nodes = elements.nodes(elementi);

                std::uint64_t rest =
                    native
                  ? topology.edges
                  : decomposition.edges(topology, nodes);

                for (; rest; rest &= rest - 1)
                {
                    const label pair = elementDual::firstPair(rest);
                    edge(nodes[pair/8], nodes[pair%8]);
                }
            }
        }
    );
}


//- Sum volumes of nodes and area vectors of edges on this rank. FatalIOError
//  if elements are inverted
static void addElements
(
    const polyMesh& mesh,
    const label nDim,
    const dualElements& elements,
    const simplexDecomposition& decomposition,
    const bool native,
    const nodeGraph& graph,
    const scalarField& x,
    scalarField& volume,
    scalarField& area
)
{
    label firstInverted = -1;
    label nInverted = 0;

    elementDual dual;

    for (label elementi = 0; elementi < elements.size(); ++elementi)
    {
        const elementTopology& topology = elements.topology(elementi);
        const label* nodes = elements.nodes(elementi);

        // Positions relative to the first vertex: less round-off far from the
        // origin
        scalar elementX[24];
        for (label i = 0; i < topology.nVertices; ++i)
        {
            for (label k = 0; k < nDim; ++k)
            {
                elementX[i*nDim + k] =
                    x[nodes[i]*nDim + k] - x[nodes[0]*nDim + k];
            }
        }

        if (!decomposition.calculate(topology, nodes, elementX, dual))
        {
            if (!nInverted++) firstInverted = elementi;
            continue;
        }

        if (native)
        {
            nativeDual::calculate(topology, elementX, dual);
        }

        for (label i = 0; i < topology.nVertices; ++i)
        {
            volume[nodes[i]] += dual.volume[i];
        }

        for (std::uint64_t rest = dual.edges; rest; rest &= rest - 1)
        {
            const label pair = elementDual::firstPair(rest);
            const label a = nodes[pair/8];
            const label b = nodes[pair%8];
            const scalar* c = dual.area[pair];

            if (a < b)
            {
                scalar* sum = area.data() + graph.find(a, b)*nDim;
                for (label k = 0; k < nDim; ++k) sum[k] += c[k];
            }
            else
            {
                scalar* sum = area.data() + graph.find(b, a)*nDim;
                for (label k = 0; k < nDim; ++k) sum[k] -= c[k];
            }
        }
    }

    if (nInverted)
    {
        FatalFileErrorInFunction(meshFile(mesh))
            << "Region " << mesh.name() << ": cell " << firstInverted
            << " at " << mesh.cellCentres()[firstInverted]
            << " is inverted or has no volume";

        if (nInverted > 1)
        {
            FatalIOError<< ", as are " << nInverted - 1 << " others";
        }

        FatalIOError
            << ":" << nl
            << "    it has no split into simplices with positive volumes"
            <<
            (
                decomposition.single()
              ? " towards its first vertex (cells simplicial has more splits)"
              : ""
            )
            << ". checkMesh may tell more."
            << exit(FatalIOError);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::medianDual::medianDual(const polyMesh& mesh, const cellTreatment cells)
:
    mesh_(mesh),
    cells_(cells),
    nDim_(0),
    directions_(label(-1)),
    thickness_(1)
{
    const bool native = (cells == cellTreatment::native);

    solutionNodes nodes(mesh);

    nDim_ = nodes.nDim;
    directions_ = nodes.directions;
    thickness_ = nodes.thickness;

    nodes.positions(mesh, nodePosition_);

    dualElements elements(mesh, nodes);

    simplexDecomposition decomposition
    (
        cells == cellTreatment::simplicialSingle,
        nDim_,
        nodePosition_,
        elements
    );

    nodeGraph graph
    (
        elementGraph(nodes.size(), elements, decomposition, native)
    );

    {
        // Levels by the edges of the mesh are smaller than with diagonals
        const labelList newNode
        (
            elementGraph(nodes.size(), elements, decomposition, true)
           .bandCompression()
        );

        const auto renumber = [&](const labelList& newNode)
        {
            graph.renumber(newNode);
            decomposition.renumber(newNode);
            elements.renumber(newNode);
            nodes.renumber(newNode);
            nodes.positions(mesh, nodePosition_);
        };
        const scalar own = graph.span(identity(nodes.size()));
        if (graph.span(newNode) < worthRenumbering*own) renumber(newNode);
        if (UPstream::parRun())
        {
            const nodeSharing sharing(mesh, nodes.pointNode, nodes.size());
            if (sharing.active())
            {
                renumber(graph.gather(sharing.sharedNodes(), earlyDistance));
            }
        }
    }

    nodeVolume_.setSize(nodes.size(), Zero);
    scalarField area(graph.nEdges()*nDim_, Zero);

    addElements
    (
        mesh,
        nDim_,
        elements,
        decomposition,
        native,
        graph,
        nodePosition_,
        nodeVolume_,
        area
    );

    sharing_.reset
    (
        new nodeSharing(mesh, nodes.pointNode, nodes.size())
    );

    sharing_->sum(nodeVolume_.data(), 1);

    forAll(nodeVolume_, node)
    {
        if (!(nodeVolume_[node] > 0))
        {
            FatalFileErrorInFunction(meshFile(mesh))
                << "Region " << mesh.name() << ": point "
                << nodes.nodePoint[node] << " at "
                << mesh.points()[nodes.nodePoint[node]]
                << " has a dual cell of volume " << nodeVolume_[node] << '.'
                << nl
                << "    Either no cell uses the point, or the cells around it"
                << " are badly distorted."
                << exit(FatalIOError);
        }
    }

    // Keep only the edges of this rank whose area is not zero
    const bitSet held(sharedEdges::merge(sharing(), graph, nDim_, -1, area));
    DynamicList<label> edgeNodes(2*graph.nEdges());
    DynamicList<scalar> edgeArea(nDim_*graph.nEdges());

    for (label a = 0; a < graph.nNodes(); ++a)
    {
        for (label e = graph.start()[a]; e < graph.start()[a + 1]; ++e)
        {
            const label b = graph.upper()[e];
            const scalar* c = area.cdata() + e*nDim_;
            const scalar volume = min(nodeVolume_[a], nodeVolume_[b]);

            scalar magnitude = 0;
            for (label k = 0; k < nDim_; ++k)
            {
                magnitude = max(magnitude, mag(c[k]));
            }

            if
            (
                held.test(e)
             && magnitude > noArea*std::pow(volume, (nDim_ - 1.0)/nDim_)
            )
            {
                const scalar* const A = nodePosition_.cdata() + a*nDim_;
                const scalar* const B = nodePosition_.cdata() + b*nDim_;
                if (std::equal(A, A + nDim_, B))
                {
                    FatalFileErrorInFunction(meshFile(mesh))
                        << "Region " << mesh.name() << ": points "
                        << nodes.nodePoint[a] << " and " << nodes.nodePoint[b]
                        << " of a cell are both at "
                        << mesh.points()[nodes.nodePoint[a]]
                        << ": the edge between them has no length"
                        << exit(FatalIOError);
                }
                edgeNodes.append(a);
                edgeNodes.append(b);
                for (label k = 0; k < nDim_; ++k) edgeArea.append(c[k]);
            }
        }
    }

    edgeNodes_.transfer(edgeNodes);
    edgeArea_ = scalarField(edgeArea);

    dualPatch::calculate
    (
        mesh,
        nodes,
        nodePosition_,
        decomposition,
        native,
        patches_
    );

    pointNode_.transfer(nodes.pointNode);
    nodePoint_.transfer(nodes.nodePoint);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::medianDual::ownedVolume() const
{
    scalarField volume(nodeVolume_);
    forAll(volume, a)
    {
        if (!sharing_->owned()[a]) volume[a] = 0;
    }
    return volume;
}


Foam::vector Foam::medianDual::areaVector(const dualPatch& patch) const
{
    vector sum(Zero);
    forAll(patch.cornerArea, k)
    {
        sum += patch.cornerArea[k]*cornerNormal(patch, k);
    }
    return returnReduce(sum, sumOp<vector>());
}


std::size_t Foam::medianDual::bytes() const
{
    std::size_t total =
        sizeof(label)
       *(
            std::size_t(pointNode_.size())
          + nodePoint_.size()
          + edgeNodes_.size()
        )
      + sizeof(scalar)
       *(
            std::size_t(nodePosition_.size())
          + nodeVolume_.size()
          + edgeArea_.size()
        )
      + sharing_->bytes();

    for (const dualPatch& patch : patches_) total += patch.bytes();

    return total;
}


void Foam::medianDual::report(Ostream& os) const
{
    // Not labels, since numbers of bytes exceed them
    scalar nodes = sharing_->owned().count();
    scalar edges = nEdges();
    scalar memory = bytes();

    reduce(nodes, sumOp<scalar>());
    reduce(edges, sumOp<scalar>());
    reduce(memory, sumOp<scalar>());

    os  << "    dual mesh: " << nDim_ << "D, cells "
        << cellTreatmentNames[cells_] << ", "
        << std::int64_t(nodes) << " nodes, "
        << std::int64_t(edges) << " edges, "
        << std::int64_t(memory/max(nodes, scalar(1)) + 0.5)
        << " bytes per node" << endl;
}


// ************************************************************************* //
