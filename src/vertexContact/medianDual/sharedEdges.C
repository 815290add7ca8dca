/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharedEdges.H"
#include "DynamicList.H"
#include "nodeGraph.H"
#include "nodeSharing.H"
#include "PstreamBuffers.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::bitSet Foam::sharedEdges::merge
(
    const nodeSharing& sharing,
    const nodeGraph& graph,
    const label nDim,
    const scalar reversed,
    scalarField& area
)
{
    bitSet kept(graph.nEdges(), true);

    if (!UPstream::parRun()) return kept;

    const labelList& sharedNodes = sharing.sharedNodes();
    const labelList& globalNode = sharing.globalNode();
    const labelList& neighbours = sharing.neighbours();
    const label myRank = UPstream::myProcNo();

    // Neighbours of each shared node (their numbers, ascending)
    labelList sharedIndex(graph.nNodes(), label(-1));
    forAll(sharedNodes, i)
    {
        sharedIndex[sharedNodes[i]] = i;
    }

    List<DynamicList<label, 4>> nodeNeighbours(sharedNodes.size());
    forAll(neighbours, neighbouri)
    {
        for (const label i : sharing.sharedWith()[neighbouri])
        {
            nodeNeighbours[i].append(neighbouri);
        }
    }

    // Send every edge, from its lower to its higher global node, to all ranks
    // that have both nodes: any of them may have a part of it
    List<DynamicList<label>> ends(neighbours.size());
    List<DynamicList<scalar>> vectors(neighbours.size());

    for (const label a : sharedNodes)
    {
        const label end = graph.start()[a + 1];

        for (label edgei = graph.start()[a]; edgei < end; ++edgei)
        {
            const label b = graph.upper()[edgei];

            if (sharedIndex[b] == -1) continue;

            const bool forward = globalNode[a] < globalNode[b];
            const DynamicList<label, 4>& ofB = nodeNeighbours[sharedIndex[b]];

            for (const label neighbouri : nodeNeighbours[sharedIndex[a]])
            {
                if (std::find(ofB.begin(), ofB.end(), neighbouri) == ofB.end())
                {
                    continue;
                }

                ends[neighbouri].append(globalNode[forward ? a : b]);
                ends[neighbouri].append(globalNode[forward ? b : a]);

                for (label k = 0; k < nDim; ++k)
                {
                    const scalar c = area[edgei*nDim + k];
                    vectors[neighbouri].append(forward ? c : reversed*c);
                }
            }
        }
    }

    PstreamBuffers buffers(UPstream::commsTypes::nonBlocking);

    forAll(neighbours, neighbouri)
    {
        UOPstream toNeighbour(neighbours[neighbouri], buffers);

        toNeighbour
            << static_cast<const UList<label>&>(ends[neighbouri])
            << static_cast<const UList<scalar>&>(vectors[neighbouri]);
    }

    buffers.finishedSends();

    // The own part comes first, then the neighbours in ascending order. On the
    // lowest rank, where it matters, that is the order of the ranks
    forAll(neighbours, neighbouri)
    {
        UIPstream fromNeighbour(neighbours[neighbouri], buffers);

        const labelList receivedEnds(fromNeighbour);
        const List<scalar> received(fromNeighbour);

        const labelList& shared = sharing.sharedWith()[neighbouri];

        auto localNode = [&](const label id)
        {
            const label* found = std::lower_bound
            (
                shared.begin(),
                shared.end(),
                id,
                [&](const label i, const label value)
                {
                    return globalNode[sharedNodes[i]] < value;
                }
            );

            return sharedNodes[*found];
        };

        for (label i = 0; i < receivedEnds.size()/2; ++i)
        {
            const label a = localNode(receivedEnds[2*i]);
            const label b = localNode(receivedEnds[2*i + 1]);
            const label edgei = (a < b ? graph.find(a, b) : graph.find(b, a));

            if (edgei == -1) continue;

            if (neighbours[neighbouri] < myRank)
            {
                kept.unset(edgei);
            }

            for (label k = 0; k < nDim; ++k)
            {
                const scalar c = received[i*nDim + k];
                area[edgei*nDim + k] += (a < b ? c : reversed*c);
            }
        }
    }

    return kept;
}


// ************************************************************************* //
