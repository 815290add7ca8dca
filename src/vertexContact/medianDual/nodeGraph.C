/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodeGraph.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nodeGraph::sortUnique()
{
    label size = 0;
    label begin = 0;

    for (label node = 0; node < nNodes(); ++node)
    {
        const label end = start_[node + 1];

        std::sort(upper_.begin() + begin, upper_.begin() + end);

        const label first = size;
        for (label i = begin; i < end; ++i)
        {
            if (size == first || upper_[size - 1] != upper_[i])
            {
                upper_[size++] = upper_[i];
            }
        }

        begin = end;
        start_[node + 1] = size;
    }

    upper_.setSize(size);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::nodeGraph::find(const label a, const label b) const
{
    const label* first = upper_.cdata() + start_[a];
    const label* last = upper_.cdata() + start_[a + 1];
    const label* found = std::lower_bound(first, last, b);

    return found != last && *found == b ? label(found - upper_.cdata()) : -1;
}


Foam::scalar Foam::nodeGraph::span(const labelUList& newNode) const
{
    scalar sum = 0;

    for (label a = 0; a < nNodes(); ++a)
    {
        for (label i = start_[a]; i < start_[a + 1]; ++i)
        {
            sum += mag(newNode[upper_[i]] - newNode[a]);
        }
    }

    return sum/max(nEdges(), label(1));
}


Foam::labelList Foam::nodeGraph::bandCompression() const
{
    const label n = nNodes();

    // All neighbours of each node
    labelList offset(n + 1, Zero);
    for (label a = 0; a < n; ++a)
    {
        offset[a + 1] += start_[a + 1] - start_[a];

        for (label i = start_[a]; i < start_[a + 1]; ++i)
        {
            ++offset[upper_[i] + 1];
        }
    }

    for (label a = 0; a < n; ++a)
    {
        offset[a + 1] += offset[a];
    }

    labelList neighbours(offset[n]);
    {
        labelList fill(offset);

        for (label a = 0; a < n; ++a)
        {
            for (label i = start_[a]; i < start_[a + 1]; ++i)
            {
                neighbours[fill[a]++] = upper_[i];
                neighbours[fill[upper_[i]]++] = a;
            }
        }
    }

    auto lessConnected = [&](const label a, const label b)
    {
        const label degreeA = offset[a + 1] - offset[a];
        const label degreeB = offset[b + 1] - offset[b];

        return degreeA != degreeB ? degreeA < degreeB : a < b;
    };

    labelList candidates(identity(n));
    std::sort(candidates.begin(), candidates.end(), lessConnected);

    // Breadth-first search from a root, for the component of the root, into
    // order[begin ...]. Returns the end, the start of the last level and the
    // number of levels
    labelList order(n);
    labelList visit(n, label(-1));
    label nVisits = 0;

    struct levels
    {
        label end;
        label last;
        label number;
    };

    auto traverse = [&](const label root, const label begin, const bool sorted)
    {
        const label mark = nVisits++;

        levels result{begin + 1, begin, 0};
        order[begin] = root;
        visit[root] = mark;

        label levelEnd = begin + 1;
        for (label i = begin; i < result.end; ++i)
        {
            if (i == levelEnd)
            {
                result.last = i;
                levelEnd = result.end;
                ++result.number;
            }

            const label a = order[i];
            const label first = result.end;

            for (label j = offset[a]; j < offset[a + 1]; ++j)
            {
                const label b = neighbours[j];

                if (visit[b] != mark)
                {
                    visit[b] = mark;
                    order[result.end++] = b;
                }
            }

            if (sorted)
            {
                std::sort
                (
                    order.begin() + first,
                    order.begin() + result.end,
                    lessConnected
                );
            }
        }

        return result;
    };

    label begin = 0;
    for (const label candidate : candidates)
    {
        if (visit[candidate] != -1) continue;

        // Find a root far out: a node of the last level of the previous
        // attempt, as long as that increases the number of levels
        label root = candidate;
        levels current = traverse(root, begin, false);

        for (label attempt = 0; attempt < rootAttempts; ++attempt)
        {
            const label other =
                *std::min_element
                (
                    order.begin() + current.last,
                    order.begin() + current.end,
                    lessConnected
                );

            const levels next = traverse(other, begin, false);

            if (next.number <= current.number) break;

            root = other;
            current = next;
        }

        begin = traverse(root, begin, true).end;
    }

    labelList newNode(n);
    for (label i = 0; i < n; ++i) newNode[order[i]] = n - 1 - i;

    return newNode;
}


Foam::labelList Foam::nodeGraph::gather
(
    const labelUList& nodes,
    const label distance
) const
{
    const label n = nNodes();
    labelList away(n, distance);
    for (const label a : nodes) away[a] = 0;
    for (label d = 1; d < distance; ++d)
    {
        for (label a = 0; a < n; ++a)
        {
            for (label i = start_[a]; i < start_[a + 1]; ++i)
            {
                const label b = upper_[i];
                if (away[a] == d - 1) away[b] = min(away[b], d);
                else if (away[b] == d - 1) away[a] = min(away[a], d);
            }
        }
    }

    // Outwards and inwards in turn: nodes next to each other are at much the
    // same distance, also at the end of a window
    labelList order(identity(n));
    const label window = label(span(order)) + 1;
    label sign = 1;
    for (label first = 0; first < n; first += window, sign = -sign)
    {
        std::stable_sort
        (
            order.begin() + first,
            order.begin() + min(first + window, n),
            [&](const label a, const label b)
            {
                return sign*away[a] < sign*away[b];
            }
        );
    }
    labelList newNode(n);
    forAll(order, i) newNode[order[i]] = i;
    return newNode;
}


void Foam::nodeGraph::renumber(const labelUList& newNode)
{
    const label n = nNodes();

    const nodeGraph renumbered
    (
        n,
        [&](const auto& edge)
        {
            for (label a = 0; a < n; ++a)
            {
                for (label i = start_[a]; i < start_[a + 1]; ++i)
                {
                    edge(newNode[a], newNode[upper_[i]]);
                }
            }
        }
    );

    start_ = renumbered.start_;
    upper_ = renumbered.upper_;
}


// ************************************************************************* //
