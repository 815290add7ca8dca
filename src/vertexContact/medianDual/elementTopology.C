/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementTopology.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::elementTopology::elementTopology
(
    const label dim,
    const label n,
    const std::vector<vertices>& faceVertices,
    const std::vector<split>& allSplits
)
:
    nDim(dim),
    nVertices(n),
    faces(faceVertices),
    splits(allSplits),
    edges(0),
    splitEdges(0)
{
    if (nDim == 3)
    {
        for (const vertices& f : faces)
        {
            const label size = faceSize(f);

            for (label i = 0; i < size; ++i)
            {
                edges |= pairMask(f[i], f[(i + 1) % size]);
            }
        }
    }
    else
    {
        for (label i = 0; i < nVertices; ++i)
        {
            const label next = (i + 1) % nVertices;

            edges |= pairMask(i, next);
        }
    }

    for (const split& s : splits)
    {
        splitEdges |= edgesOf(s, nDim);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::elementTopology& Foam::elementTopology::of(const kind k)
{
    // Hexahedron: the two splits into five. Prism: the six that follow from
    // the orders of its three upright edges (the two cyclic choices of
    // diagonals allow no split).

    static const elementTopology topologies[nKinds] =
    {
        // segment
        {
            1,
            2,
            {},
            {
                {{{0, 1, -1, -1}}}
            }
        },

        // triangle
        {
            2,
            3,
            {},
            {
                {{{0, 1, 2, -1}}}
            }
        },

        // quadrilateral
        {
            2,
            4,
            {},
            {
                {{{0, 1, 2, -1}}, {{0, 2, 3, -1}}},
                {{{0, 1, 3, -1}}, {{1, 2, 3, -1}}}
            }
        },

        // tetrahedron
        {
            3,
            4,
            {
                {{0, 2, 1, -1}},
                {{0, 1, 3, -1}},
                {{1, 2, 3, -1}},
                {{2, 0, 3, -1}}
            },
            {
                {{{0, 1, 2, 3}}}
            }
        },

        // pyramid
        {
            3,
            5,
            {
                {{0, 3, 2, 1}},
                {{0, 1, 4, -1}},
                {{1, 2, 4, -1}},
                {{2, 3, 4, -1}},
                {{3, 0, 4, -1}}
            },
            {
                {{{0, 1, 2, 4}}, {{0, 2, 3, 4}}},
                {{{0, 1, 3, 4}}, {{1, 2, 3, 4}}}
            }
        },

        // prism
        {
            3,
            6,
            {
                {{0, 2, 1, -1}},
                {{3, 4, 5, -1}},
                {{0, 1, 4, 3}},
                {{1, 2, 5, 4}},
                {{2, 0, 3, 5}}
            },
            {
                {{{0, 1, 2, 5}}, {{0, 1, 5, 4}}, {{0, 3, 4, 5}}},
                {{{0, 2, 4, 1}}, {{0, 2, 5, 4}}, {{0, 3, 4, 5}}},
                {{{1, 0, 5, 2}}, {{1, 0, 3, 5}}, {{1, 4, 5, 3}}},
                {{{1, 2, 0, 3}}, {{1, 2, 3, 5}}, {{1, 4, 5, 3}}},
                {{{2, 0, 1, 4}}, {{2, 0, 4, 3}}, {{2, 5, 3, 4}}},
                {{{2, 1, 3, 0}}, {{2, 1, 4, 3}}, {{2, 5, 3, 4}}}
            }
        },

        // hexahedron
        {
            3,
            8,
            {
                {{0, 3, 2, 1}},
                {{4, 5, 6, 7}},
                {{0, 1, 5, 4}},
                {{1, 2, 6, 5}},
                {{2, 3, 7, 6}},
                {{3, 0, 4, 7}}
            },
            {
                {
                    {{1, 0, 5, 2}},
                    {{3, 0, 2, 7}},
                    {{4, 0, 7, 5}},
                    {{6, 2, 5, 7}},
                    {{0, 2, 7, 5}}
                },
                {
                    {{0, 1, 3, 4}},
                    {{2, 1, 6, 3}},
                    {{5, 1, 4, 6}},
                    {{7, 3, 6, 4}},
                    {{1, 3, 4, 6}}
                }
            }
        }
    };

    return topologies[k];
}


std::uint64_t Foam::elementTopology::edgesOf(const split& s, const label nDim)
{
    std::uint64_t mask = 0;

    for (const vertices& simplex : s)
    {
        for (label i = 0; i <= nDim; ++i)
        {
            for (label j = i + 1; j <= nDim; ++j)
            {
                mask |= pairMask(simplex[i], simplex[j]);
            }
        }
    }

    return mask;
}


// ************************************************************************* //
