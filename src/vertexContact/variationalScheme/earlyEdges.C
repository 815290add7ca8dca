/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "earlyEdges.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::earlyEdges::earlyEdges
(
    const medianDual& dual,
    const labelList& pairNodes,
    const labelList& sharedNodes,
    const labelList& lateNodes
)
:
    ofBlock_((dual.nEdges() + nLanes - 1)/nLanes, number(0)),
    ofNode_(dual.nNodes(), number(0))
{
    const labelList& edgeNodes = dual.edgeNodes();
    bitSet late(dual.nNodes());
    late.set(lateNodes);

    bitSet completed(dual.nNodes());
    completed.set(sharedNodes);
    for (label p = nPasses - 1; p >= 0; --p)
    {
        for (const label a : completed) ++ofNode_[a];

        bitSet reached(completed);
        DynamicList<label> blocks;
        forAll(ofBlock_, block)
        {
            const label first = block*nLanes;
            const label end = min(first + nLanes, dual.nEdges());
            bool needed = false;
            for (label i = 2*first; i < 2*end; ++i)
            {
                needed = needed || completed.test(edgeNodes[i]);
            }
            if (!needed) continue;
            blocks.append(first);
            ++ofBlock_[block];
            for (label i = 2*first; i < 2*end; ++i) reached.set(edgeNodes[i]);
        }
        blocks_[p].transfer(blocks);

        if (p == gradients)
        {
            DynamicList<label> pairs;
            for (label pair = 0; 2*pair < pairNodes.size(); ++pair)
            {
                const label a = pairNodes[2*pair], b = pairNodes[2*pair + 1];
                if (!completed.test(a) && !completed.test(b)) continue;
                pairs.append(pair);
                reached.set(a);
                reached.set(b);
            }
            pairs_.transfer(pairs);
        }
        reached_[p] = reached.sortedToc();
        completed -= late;
        nodes_[p] = completed.sortedToc();
        completed = reached;
    }
    for (const label a : completed) ++ofNode_[a];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::size_t Foam::earlyEdges::bytes() const
{
    std::size_t nLabels = pairs_.size();
    for (label p = 0; p < nPasses; ++p)
    {
        nLabels += blocks_[p].size() + nodes_[p].size() + reached_[p].size();
    }
    return
        sizeof(label)*nLabels
      + ofBlock_.size() + ofNode_.size();
}


// ************************************************************************* //
