/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodeSharing.H"
#include "globalIndex.H"
#include "globalMeshData.H"
#include "mapDistribute.H"
#include "polyMesh.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <algorithm>
#include <limits>
#include <memory>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Operations, each with its neutral value

struct nodalSum
{
    static constexpr scalar neutral = 0;
    void operator()(scalar& x, const scalar y) const { x += y; }
};

struct nodalMin
{
    static constexpr scalar neutral = std::numeric_limits<scalar>::infinity();
    void operator()(scalar& x, const scalar y) const { if (y < x) x = y; }
};

struct nodalMax
{
    static constexpr scalar neutral = -std::numeric_limits<scalar>::infinity();
    void operator()(scalar& x, const scalar y) const { if (y > x) x = y; }
};

//- Union of two sets of ranks
struct uniteRanks
{
    void operator()(labelList& x, const labelUList& y) const
    {
        for (const label rank : y)
        {
            if (std::find(x.begin(), x.end(), rank) == x.end())
            {
                x.append(rank);
            }
        }
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CombineOp>
void Foam::nodeSharing::combine
(
    const nodalArray* arrays,
    const label nArrays,
    const CombineOp& cop
) const
{
    if (!active()) return;

    // Number of values per node in all arrays
    label width = 0;
    for (label i = 0; i < nArrays; ++i) width += arrays[i].second;

    std::size_t nValues = 0;
    for (const labelList& shared : sharedWith_)
    {
        nValues += std::size_t(shared.size())*width;
    }

    // Not initialised, since everything is written before it is read
    std::unique_ptr<scalar[]> sent(new scalar[nValues]);
    std::unique_ptr<scalar[]> received(new scalar[nValues]);

    // Calls f(values, stride) for the values of a node in each array
    const auto overArrays = [&](const label i, const auto& f)
    {
        const std::size_t node = sharedNodes_[i];
        for (label k = 0; k < nArrays; ++k)
        {
            const label stride = arrays[k].second;
            f(arrays[k].first + node*stride, stride);
        }
    };

    const label startOfRequests = UPstream::nRequests();

    std::size_t offset = 0;
    forAll(neighbours_, neighbouri)
    {
        const std::size_t n =
            std::size_t(sharedWith_[neighbouri].size())*width;

        UIPstream::read
        (
            UPstream::commsTypes::nonBlocking,
            neighbours_[neighbouri],
            reinterpret_cast<char*>(received.get() + offset),
            n*sizeof(scalar)
        );

        offset += n;
    }

    offset = 0;
    forAll(neighbours_, neighbouri)
    {
        const labelList& shared = sharedWith_[neighbouri];

        scalar* message = sent.get() + offset;
        for (const label i : shared)
        {
            overArrays(i, [&](const scalar* values, const label stride)
            {
                message = std::copy(values, values + stride, message);
            });
        }

        const std::size_t n = std::size_t(shared.size())*width;

        UOPstream::write
        (
            UPstream::commsTypes::nonBlocking,
            neighbours_[neighbouri],
            reinterpret_cast<const char*>(sent.get() + offset),
            n*sizeof(scalar)
        );

        offset += n;
    }

    UPstream::waitRequests(startOfRequests);

    // Two values may be combined in either order. More are combined in
    // ascending order of ranks on all of them
    const std::size_t nTotals = std::size_t(nMany_)*width;
    std::unique_ptr<scalar[]> total(new scalar[nTotals]);
    std::fill(total.get(), total.get() + nTotals, CombineOp::neutral);

    const scalar* message = received.get();

    for (label place = 0; place <= neighbours_.size(); ++place)
    {
        if (place == myPlace_ && nMany_)
        {
            forAll(sharedNodes_, i)
            {
                if (manyPlace_[i] < 0) continue;
                scalar* sum = total.get() + std::size_t(manyPlace_[i])*width;
                overArrays(i, [&](const scalar* values, const label stride)
                {
                    for (label k = 0; k < stride; ++k) cop(*sum++, values[k]);
                });
            }
        }

        if (place == neighbours_.size()) break;
        for (const label i : sharedWith_[place])
        {
            if (manyPlace_[i] < 0)
            {
                overArrays(i, [&](scalar* values, const label stride)
                {
                    for (label k = 0; k < stride; ++k)
                    {
                        cop(values[k], *message++);
                    }
                });
                continue;
            }
            scalar* sum = total.get() + std::size_t(manyPlace_[i])*width;
            for (label k = 0; k < width; ++k) cop(sum[k], *message++);
        }
    }

    if (!nMany_) return;
    forAll(sharedNodes_, i)
    {
        if (manyPlace_[i] < 0) continue;
        const scalar* sum = total.get() + std::size_t(manyPlace_[i])*width;
        overArrays(i, [&](scalar* values, const label stride)
        {
            std::copy(sum, sum + stride, values);
            sum += stride;
        });
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodeSharing::nodeSharing
(
    const polyMesh& mesh,
    const labelUList& pointNode,
    const label nNodes
)
:
    myPlace_(0),
    neighbours_(),
    sharedNodes_(),
    sharedWith_(),
    owned_(nNodes, true),
    globalNode_(identity(nNodes))
{
    if (!UPstream::parRun()) return;

    const label myRank = UPstream::myProcNo();

    // Points on processor faces: the ranks that have them, and their lowest
    // id, which belongs to the lowest rank
    const globalIndex numbering(nNodes);
    const globalMeshData& globalData = mesh.globalData();
    const labelList& coupledPoints = globalData.coupledPatch().meshPoints();

    labelListList ranks(coupledPoints.size(), labelList(1, myRank));
    labelList id(coupledPoints.size());

    forAll(coupledPoints, i)
    {
        id[i] = numbering.toGlobal(pointNode[coupledPoints[i]]);
    }

    globalMeshData::syncData
    (
        ranks,
        globalData.globalPointSlaves(),
        globalData.globalPointTransformedSlaves(),
        globalData.globalPointSlavesMap(),
        uniteRanks()
    );

    globalMeshData::syncData
    (
        id,
        globalData.globalPointSlaves(),
        globalData.globalPointTransformedSlaves(),
        globalData.globalPointSlavesMap(),
        minEqOp<label>()
    );

    // From points to nodes. A rank with one point of a node has all of them,
    // as meshes with empty directions are one cell thick
    globalNode_ = identity(nNodes, numbering.toGlobal(0));

    labelListList nodeRanks(nNodes);

    forAll(coupledPoints, i)
    {
        const label node = pointNode[coupledPoints[i]];

        uniteRanks()(nodeRanks[node], ranks[i]);
        globalNode_[node] = Foam::min(globalNode_[node], id[i]);
    }

    label nShared = 0;
    labelList nSharedWith(UPstream::nProcs(), Zero);

    forAll(nodeRanks, node)
    {
        if (nodeRanks[node].size() > 1)
        {
            ++nShared;

            for (const label rank : nodeRanks[node])
            {
                ++nSharedWith[rank];

                if (rank < myRank)
                {
                    owned_.unset(node);
                }
            }
        }
    }

    // Neighbours and their places among each other
    labelList place(nSharedWith.size(), label(-1));
    label nNeighbours = 0;

    forAll(nSharedWith, rank)
    {
        if (rank == myRank)
        {
            myPlace_ = nNeighbours;
        }
        else if (nSharedWith[rank])
        {
            place[rank] = nNeighbours++;
        }
    }

    neighbours_.setSize(nNeighbours);
    sharedWith_.setSize(nNeighbours);

    forAll(place, rank)
    {
        if (place[rank] != -1)
        {
            neighbours_[place[rank]] = rank;
            sharedWith_[place[rank]].setSize(nSharedWith[rank]);
        }
    }

    sharedNodes_.setSize(nShared);
    manyPlace_.setSize(nShared);
    labelList fill(nNeighbours, Zero);
    nShared = 0;

    forAll(nodeRanks, node)
    {
        if (nodeRanks[node].size() > 1)
        {
            for (const label rank : nodeRanks[node])
            {
                if (rank != myRank)
                {
                    const label placei = place[rank];
                    sharedWith_[placei][fill[placei]++] = nShared;
                }
            }

            manyPlace_[nShared] =
                nodeRanks[node].size() > 2 ? nMany_++ : label(-1);
            sharedNodes_[nShared++] = node;
        }
    }

    for (labelList& shared : sharedWith_)
    {
        std::sort
        (
            shared.begin(),
            shared.end(),
            [this](const label i, const label j)
            {
                return
                    globalNode_[sharedNodes_[i]]
                  < globalNode_[sharedNodes_[j]];
            }
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::size_t Foam::nodeSharing::bytes() const
{
    std::size_t nLabels =
        neighbours_.size() + sharedNodes_.size() + manyPlace_.size()
      + globalNode_.size();

    for (const labelList& shared : sharedWith_) nLabels += shared.size();

    return nLabels*sizeof(label) + owned_.size()/8;
}


void Foam::nodeSharing::sum(scalar* data, const label stride) const
{
    sum({{data, stride}});
}


void Foam::nodeSharing::min(scalar* data, const label stride) const
{
    const nodalArray array(data, stride);
    combine(&array, 1, nodalMin());
}


void Foam::nodeSharing::max(scalar* data, const label stride) const
{
    const nodalArray array(data, stride);
    combine(&array, 1, nodalMax());
}


void Foam::nodeSharing::sum(std::initializer_list<nodalArray> arrays) const
{
    combine(arrays.begin(), label(arrays.size()), nodalSum());
}


// ************************************************************************* //
