/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "simplexDecomposition.H"
#include "dualElements.H"
#include "PstreamReduceOps.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace Foam
{
    // Coordinates that differ by less than this share of the shortest edge of
    // the mesh are equal in the order of nodes
    static const scalar placeTolerance = 1e-3;

    // Offset of rounding, a fraction at which a grid line is unlikely to be
    static const scalar placeOffset = 0.381966;

    // Volumes up to this share of the element (of the cube of its longest
    // extent) are round-off
    static const scalar splitRoundOff = 1e-10;
    static const scalar elementRoundOff = 1e-15;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Rounded coordinate: a whole number, but beyond the range of labels
static inline scalar rounded(const scalar x, const scalar step)
{
    return std::floor(x/step + placeOffset);
}


//- Outward area vectors opposite to the vertices of a simplex. Returns its
//  volume
static inline scalar simplexAreas
(
    const elementTopology::vertices& s,
    const scalar* x,
    const label nDim,
    scalar area[4][3]
)
{
    if (nDim == 3)
    {
        const scalar* x0 = x + 3*s[0];
        scalar e[4][3];

        for (label i = 1; i < 4; ++i)
        {
            const scalar* xi = x + 3*s[i];

            for (label k = 0; k < 3; ++k) e[i][k] = xi[k] - x0[k];
        }

        // Opposite to i: the cross product of the other two, outward
        for (label i = 1; i < 4; ++i)
        {
            const scalar* p = e[i == 3 ? 2 : i == 2 ? 1 : 3];
            const scalar* q = e[i == 3 ? 1 : i == 2 ? 3 : 2];

            elementDual::halfCross(p, q, area[i]);
        }

        for (label k = 0; k < 3; ++k)
        {
            area[0][k] = -(area[1][k] + area[2][k] + area[3][k]);
        }

        return
           -(area[3][0]*e[3][0] + area[3][1]*e[3][1] + area[3][2]*e[3][2])/3;
    }
    else if (nDim == 2)
    {
        const scalar* x0 = x + 2*s[0];
        const scalar* x1 = x + 2*s[1];
        const scalar* x2 = x + 2*s[2];

        area[0][0] = x2[1] - x1[1];
        area[0][1] = x1[0] - x2[0];
        area[1][0] = x0[1] - x2[1];
        area[1][1] = x2[0] - x0[0];
        area[2][0] = x1[1] - x0[1];
        area[2][1] = x0[0] - x1[0];

        return
            0.5
           *(
                (x1[0] - x0[0])*(x2[1] - x0[1])
              - (x1[1] - x0[1])*(x2[0] - x0[0])
            );
    }

    area[0][0] = 1;
    area[1][0] = -1;

    return x[s[1]] - x[s[0]];
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::simplexDecomposition::addSplit
(
    const elementTopology::split& split,
    const scalar* x,
    const scalar weight,
    elementDual& dual
) const
{
    const scalar areaFactor = weight/(nDim_*(nDim_ + 1));
    const scalar volumeFactor = weight/(nDim_ + 1);

    scalar smallest = GREAT;

    for (const elementTopology::vertices& s : split)
    {
        scalar area[4][3];
        const scalar volume = simplexAreas(s, x, nDim_, area);

        smallest = std::min(smallest, volume);

        for (label i = 0; i <= nDim_; ++i)
        {
            dual.volume[label(s[i])] += volumeFactor*volume;

            for (label j = i + 1; j <= nDim_; ++j)
            {
                scalar c[3];
                for (label k = 0; k < nDim_; ++k)
                {
                    c[k] = area[i][k] - area[j][k];
                }

                dual.add(s[i], s[j], c, nDim_, areaFactor);
            }
        }
    }

    return smallest;
}


void Foam::simplexDecomposition::singleSplit
(
    const elementTopology& topology,
    const label* nodes,
    elementTopology::split& split
) const
{
    typedef elementTopology::vertices vertices;
    typedef signed char vertex;

    split.clear();

    vertex first = 0;
    for (label i = 1; i < topology.nVertices; ++i)
    {
        if (place_[nodes[i]] < place_[nodes[label(first)]]) first = vertex(i);
    }

    if (topology.nDim == 2)
    {
        const label n = topology.nVertices;

        for (label i = 1; i < n - 1; ++i)
        {
            split.push_back
            (
                vertices
                {
                    {
                        first,
                        vertex((first + i) % n),
                        vertex((first + i + 1) % n),
                        -1
                    }
                }
            );
        }

        return;
    }

    for (const vertices& f : topology.faces)
    {
        const label n = elementTopology::faceSize(f);

        label start = 0;
        bool containsFirst = false;
        for (label i = 0; i < n; ++i)
        {
            containsFirst = containsFirst || f[i] == first;

            if (place_[nodes[label(f[i])]] < place_[nodes[label(f[start])]])
            {
                start = i;
            }
        }

        for (label i = 1; !containsFirst && i < n - 1; ++i)
        {
            split.push_back
            (
                vertices
                {
                    {
                        first,
                        f[start],
                        f[(start + i) % n],
                        f[(start + i + 1) % n]
                    }
                }
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::simplexDecomposition::simplexDecomposition
(
    const bool single,
    const label nDim,
    const scalarField& x,
    const dualElements& elements
)
:
    single_(single && nDim > 1),
    nDim_(nDim)
{
    if (!single_) return;

    scalar shortest = GREAT;

    for (label elementi = 0; elementi < elements.size(); ++elementi)
    {
        const label* nodes = elements.nodes(elementi);

        std::uint64_t rest = elements.topology(elementi).edges;
        for (; rest; rest &= rest - 1)
        {
            const label pair = elementDual::firstPair(rest);
            const scalar* xi = x.cdata() + nodes[pair/8]*nDim;
            const scalar* xj = x.cdata() + nodes[pair%8]*nDim;

            scalar lengthSqr = 0;
            for (label k = 0; k < nDim; ++k) lengthSqr += sqr(xj[k] - xi[k]);

            shortest = min(shortest, lengthSqr);
        }
    }

    reduce(shortest, minOp<scalar>());

    const scalar step = max(placeTolerance*std::sqrt(shortest), VSMALL);
    const label nNodes = x.size()/nDim;

    labelList order(identity(nNodes));

    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            const scalar* xa = x.cdata() + a*nDim;
            const scalar* xb = x.cdata() + b*nDim;

            for (label k = 0; k < nDim; ++k)
            {
                const scalar ra = rounded(xa[k], step);
                const scalar rb = rounded(xb[k], step);

                if (ra != rb) return ra < rb;
            }

            for (label k = 0; k < nDim; ++k)
            {
                if (xa[k] != xb[k]) return xa[k] < xb[k];
            }

            // Coincident nodes are never in the same valid element
            return a < b;
        }
    );

    place_.setSize(nNodes);
    forAll(order, i)
    {
        place_[order[i]] = i;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::uint64_t Foam::simplexDecomposition::edges
(
    const elementTopology& topology,
    const label* nodes
) const
{
    if (!single_) return topology.splitEdges;

    elementTopology::split split;
    singleSplit(topology, nodes, split);

    return elementTopology::edgesOf(split, nDim_);
}


bool Foam::simplexDecomposition::calculate
(
    const elementTopology& topology,
    const label* nodes,
    const scalar* x,
    elementDual& dual
) const
{
    // The best split decides whether the element is inverted
    scalar worst = -GREAT;

    if (single_)
    {
        elementTopology::split split;
        singleSplit(topology, nodes, split);

        dual.reset(elementTopology::edgesOf(split, nDim_));
        worst = addSplit(split, x, 1, dual);
    }
    else
    {
        dual.reset(topology.splitEdges);

        const scalar weight = 1.0/topology.splits.size();

        for (const elementTopology::split& split : topology.splits)
        {
            worst = std::max(worst, addSplit(split, x, weight, dual));
        }
    }

    scalar volume = 0;
    scalar extent = 0;

    for (label i = 0; i < topology.nVertices; ++i)
    {
        volume += dual.volume[i];

        for (label k = 0; k < nDim_; ++k)
        {
            extent = std::max(extent, std::abs(x[i*nDim_ + k] - x[k]));
        }
    }

    // Negated, so that values that are not finite are caught
    return
        volume > elementRoundOff*std::pow(extent, nDim_)
     && worst >= -splitRoundOff*volume;
}


Foam::label Foam::simplexDecomposition::diagonal(const label* faceNodes) const
{
    if (!single_) return -1;

    label first = 0;
    for (label i = 1; i < 4; ++i)
    {
        if (place_[faceNodes[i]] < place_[faceNodes[first]]) first = i;
    }

    return first;
}


void Foam::simplexDecomposition::renumber(const labelUList& newNode)
{
    const labelList oldPlace(place_);

    forAll(oldPlace, node)
    {
        place_[newNode[node]] = oldPlace[node];
    }
}


// ************************************************************************* //
