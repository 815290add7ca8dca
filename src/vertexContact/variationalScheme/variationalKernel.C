/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "variationalKernelTemplate.H"
#include "edgeBlocks.H"
#include "nodeGraph.H"
#include "sharedEdges.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Number of scalars for n per edge, in whole blocks
Foam::label inBlocks(const Foam::vertexData& d, const Foam::label n)
{
    return
        n*Foam::nLanes*((d.dual.nEdges() + Foam::nLanes - 1)/Foam::nLanes);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::variationalData::variationalData
(
    const vertexData& d,
    const scalar beta,
    const scalar epsilon,
    const scalar frontEpsilon,
    const bool smoothed
)
:
    beta(beta),
    epsilon(epsilon),
    frontEpsilon(frontEpsilon),
    smoothed(smoothed),
    toMeet(edgeBlocks::toMeet(d.dual)),
    area(inBlocks(d, d.nDim())),
    reach(inBlocks(d, d.nDim())),
    motion(inBlocks(d, variationalLayout::motionOf(d.nDim()))),
    motionPlaces(toMeet.size()),
    U(d.nNodes()*variationalLayout::strideU(d.nDim())),
    grad(d.nNodes()*d.nDim()*variationalLayout::strideColumn(d.nDim())),
    inverse(d.finiteStrain && d.nDim() == 2 ? 4*d.nNodes() : 0, Zero),
    sensor(d.nNodes()*variationalLayout::strideSensor(d.nDim())),
    perEdges(d.nNodes(), Zero),
    perV(d.nNodes()),
    acceleration(d.nDim() > 1 ? d.nNodes()*d.nDim() : label(0), Zero),
    oldAcceleration(acceleration),
    adjoint(d.nNodes()*d.nDim()*variationalLayout::strideColumn(d.nDim())),
    smoothing(smoothed ? d.dual.nEdges() : 0, Zero),
    jacobian(smoothed ? d.nNodes() : 0, scalar(1)),
    average(smoothed ? d.nNodes() : 0, scalar(1)),
    unsmoothed(average),
    geometricBound(d.nNodes()*d.nDim()*(d.nDim() + 1)/2, Zero)
{
    const label nDim = d.nDim();
    forAll(motionPlaces, block) motionPlaces[block] = nLanes*block;
    for (label e = 0; e < d.dual.nEdges(); ++e)
    {
        const label lane = e % nLanes;
        for (label j = 0; j < nDim; ++j)
        {
            const scalar C = d.edgeArea()[e*nDim + j];
            const label a = d.dual.edgeNodes()[2*e];
            const label b = d.dual.edgeNodes()[2*e + 1];
            const scalar r =
                d.dual.nodePosition()[b*nDim + j]
              - d.dual.nodePosition()[a*nDim + j];
            area[(e - lane)*nDim + j*nLanes + lane] = C;
            reach[(e - lane)*nDim + j*nLanes + lane] = r;
            if (smoothed) smoothing[e] += 0.5/(nDim + 1)*C*r;
        }
    }
    // Fill up the last block with copies of the last edge, without an area
    for (label e = d.dual.nEdges(); e % nLanes; ++e)
    {
        const label last = (d.dual.nEdges() - 1) % nLanes;
        const label first = e - e % nLanes;
        for (label j = 0; j < nDim; ++j)
        {
            reach[first*nDim + j*nLanes + e % nLanes] =
                reach[first*nDim + j*nLanes + last];
        }
    }
    for (label a = 0; a < d.nNodes(); ++a)
    {
        perV[a] = 1/d.dual.nodeVolume()[a];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::variationalData::setLate(const labelList& nodes, const label nDim)
{
    lateNodes = nodes;
    lateJumps.setSize(nodes.size()*variationalLayout::strideJump(nDim), Zero);
}


void Foam::variationalData::keepMotion(const label nEdges, const label nDim)
{
    const label nBlocks = (nEdges + nLanes - 1)/nLanes;
    const label nEarly = early.blocks(earlyEdges::corrections).size();
    const label size =
        (nBlocks + nEarly)*nLanes*variationalLayout::motionOf(nDim);
    if (size >= motion.size()) return;
    motion.reset(size);
    label nFound = 0;
    forAll(motionPlaces, block)
    {
        const bool isEarly =
            nEarly && early.hasEdge(earlyEdges::corrections, block*nLanes);
        motionPlaces[block] =
            nLanes*(isEarly ? nBlocks + nFound++ : block % nBlocks);
    }
}


void Foam::variationalData::addPairs(const dualPatch& patch)
{
    const label nDim = patch.nDim;
    label pair = pairNodes.size()/2, nPairs = pair;
    patch.forFaces
    (
        [&](const dualPatch::face& f) { nPairs += f.size*(f.size - 1)/2; }
    );
    pairNodes.setSize(2*nPairs);
    pairArea.setSize(nDim*nPairs);

    patch.forFaces([&](const dualPatch::face& f)
    {
        const scalar* w = patch.weightVectors.cdata() + nDim*f.firstWeight;
        for (label p = 0; p < f.size; ++p)
        {
            for (label j = p + 1; j < f.size; ++j, ++pair)
            {
                const label a = patch.cornerNode[f.start + p];
                const label b = patch.cornerNode[f.start + j];
                pairNodes[2*pair] = min(a, b);
                pairNodes[2*pair + 1] = max(a, b);

                // Both nodes have the same weight of each other's value; each
                // one sees the difference
                for (label i = 0; i < nDim; ++i)
                {
                    pairArea[nDim*pair + i] = w[nDim*(p*f.size + j) + i];
                }
            }
        }
    });
}


void Foam::variationalData::joinPairs(const medianDual& dual)
{
    const label nDim = dual.nDim();
    const label n = pairNodes.size()/2;
    const nodeGraph graph(dual.nNodes(), [&](const auto& add)
    {
        for (label p = 0; p < n; ++p)
        {
            add(pairNodes[2*p], pairNodes[2*p + 1]);
        }
    });
    scalarField area(graph.nEdges()*nDim, Zero);
    for (label p = 0; p < n; ++p)
    {
        const label joined = graph.find(pairNodes[2*p], pairNodes[2*p + 1]);
        for (label i = 0; i < nDim; ++i)
        {
            area[joined*nDim + i] += pairArea[p*nDim + i];
        }
    }
    const bitSet kept
    (
        sharedEdges::merge(dual.sharing(), graph, nDim, 1, area)
    );

    label last = 0;
    for (label a = 0; a < graph.nNodes(); ++a)
    {
        for (label p = graph.start()[a]; p < graph.start()[a + 1]; ++p)
        {
            if (!kept.test(p)) continue;
            pairNodes[2*last] = a;
            pairNodes[2*last + 1] = graph.upper()[p];
            for (label i = 0; i < nDim; ++i)
            {
                pairArea[last*nDim + i] = area[p*nDim + i];
            }
            ++last;
        }
    }
    pairNodes.setSize(2*last);
    pairArea.setSize(last*nDim);
    edgeBlocks::meetPairs(toMeet, dual, pairNodes);
}


void Foam::variationalData::smooth(const medianDual& dual)
{
    average = Zero;
    label e = 0;
    for (label a = 0; a < dual.nNodes(); ++a)
    {
        scalar sum = average[a];
        for (; e < dual.nEdges() && dual.edgeNodes()[2*e] == a; ++e)
        {
            const label b = dual.edgeNodes()[2*e + 1];
            const scalar f = smoothing[e]*(jacobian[b] - jacobian[a]);
            sum += f;
            average[b] -= f;
        }
        average[a] = perV[a]*sum;
    }
    dual.sharing().sum(average.data(), 1);
}


std::size_t Foam::variationalData::bytes() const
{
    return
        early.bytes()
      + sizeof(label)
       *std::size_t(pairNodes.size() + toMeet.size() + motionPlaces.size())
      + sizeof(scalar)
       *std::size_t
        (
            pairArea.size() + reach.size() + motion.size()
          + U.size() + grad.size() + inverse.size()
          + area.size() + lateJumps.size()
          + sensor.size() + perEdges.size() + perV.size() + smoothing.size()
          + 2*acceleration.size() + adjoint.size() + jacobian.size()
          + average.size() + unsmoothed.size() + geometricBound.size()
        );
}


Foam::scalar Foam::largestSlope(const scalar beta)
{
    // d/dt sin t (1 + beta (1 - cos t)) = 0 is a quadratic equation for cos t:
    // (1 + beta) c - beta (2 c^2 - 1) = 0
    if (beta <= 0) return 1;
    const scalar c =
        (1 + beta - std::sqrt(sqr(1 + beta) + 8*sqr(beta)))/(4*beta);
    return std::sqrt(1 - c*c)*(1 + beta*(1 - c));
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

namespace Foam
{

// Each dimension is compiled in a file of its own
extern template autoPtr<variationalKernel>
newVariationalKernel<1>(vertexData&, variationalData&);
extern template autoPtr<variationalKernel>
newVariationalKernel<2>(vertexData&, variationalData&);
extern template autoPtr<variationalKernel>
newVariationalKernel<3>(vertexData&, variationalData&);

}


Foam::autoPtr<Foam::variationalKernel> Foam::variationalKernel::New
(
    vertexData& d,
    variationalData& x
)
{
    return withDirections(d.nDim(), [&](auto D)
    {
        return newVariationalKernel<D.value>(d, x);
    });
}


// ************************************************************************* //
