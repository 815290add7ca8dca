/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The median dual on decomposed meshes is that of the whole mesh, and the
    exchange of nodal data completes sums, minima and maxima.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "dualChecks.H"
#include "meshFactory.H"
#include "patchRim.H"
#include "PstreamReduceOps.H"

#include <algorithm>
#include <functional>

using namespace Foam;

typedef medianDual::cellTreatment treatment;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- An edge by points of the whole mesh, with its area vector
struct edgeRecord
{
    label a;
    label b;
    scalar c[3];

    bool operator<(const edgeRecord& other) const
    {
        return a != other.a ? a < other.a : b < other.b;
    }
};


//- All edges of a dual on this rank, sorted
std::vector<edgeRecord> edges
(
    const medianDual& dual,
    const labelList& globalPoint
)
{
    std::vector<edgeRecord> result(dual.nEdges());
    const label d = dual.nDim();

    for (label e = 0; e < dual.nEdges(); ++e)
    {
        edgeRecord& record = result[e];
        record.a = globalPoint[dual.nodePoint()[dual.edgeNodes()[2*e]]];
        record.b = globalPoint[dual.nodePoint()[dual.edgeNodes()[2*e + 1]]];

        const bool forward = record.a < record.b;
        if (!forward)
        {
            std::swap(record.a, record.b);
        }

        for (label k = 0; k < 3; ++k)
        {
            record.c[k] =
                k < d ? (forward ? 1 : -1)*dual.edgeArea()[e*d + k] : 0;
        }
    }

    std::sort(result.begin(), result.end());

    return result;
}


//- The same from all ranks, on all ranks
std::vector<edgeRecord> allEdges(const std::vector<edgeRecord>& mine)
{
    List<List<scalar>> all(Pstream::nProcs());
    List<scalar>& flat = all[Pstream::myProcNo()];

    flat.setSize(5*label(mine.size()));
    label i = 0;
    for (const edgeRecord& record : mine)
    {
        flat[i++] = record.a;
        flat[i++] = record.b;
        flat[i++] = record.c[0];
        flat[i++] = record.c[1];
        flat[i++] = record.c[2];
    }

    Pstream::gatherList(all);
    Pstream::scatterList(all);

    std::vector<edgeRecord> result;
    for (const List<scalar>& values : all)
    {
        for (label j = 0; j < values.size(); j += 5)
        {
            result.push_back
            ({
                label(values[j]),
                label(values[j + 1]),
                {values[j + 2], values[j + 3], values[j + 4]}
            });
        }
    }

    std::sort(result.begin(), result.end());

    return result;
}


struct decomposition
{
    const char* name;
    std::function<label(label, label, label)> rankOf;
};


std::vector<decomposition> decompositions()
{
    const label n = Pstream::nProcs();

    return
    {
        {"slabs in x", [n](label i, label, label) { return i % n; }},
        {"slabs in y", [n](label, label j, label) { return min(j, n - 1); }},
        {
            "blocks",
            [n](label i, label j, label k)
            {
                return ((i > 2) + 2*(j > 1) + 4*(k > 1)) % n;
            }
        },
        {
            "checkerboard",
            [n](label i, label j, label k) { return (i + j + k) % n; }
        },
        {
            "scattered",
            [n](label i, label j, label k)
            {
                return ((i*7 + j*13 + k*29)*37 % 101) % n;
            }
        },
        {
            "last rank without cells",
            [n](label i, label j, label)
            {
                return n > 1 ? (i + 2*j) % (n - 1) : 0;
            }
        },
        {
            "cells inside on another rank",
            [n](label i, label j, label k)
            {
                return (i == 2 && j == 2 && (k == 0 || k == 2)) ? n - 1 : 0;
            }
        }
    };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("decomposed dual is that of the whole mesh", "[medianDual][parallel]")
{
    const treatment treatments[] =
    {
        treatment::simplicial, treatment::simplicialSingle, treatment::native
    };

    for (const label nDim : {1, 2, 3})
    for
    (
        const meshFactory::cellKind kind :
        {meshFactory::hexes, meshFactory::prisms, meshFactory::mixed}
    )
    for (const decomposition& parts : decompositions())
    for (const treatment t : treatments)
    {
        if
        (
            (nDim == 1 && kind != meshFactory::hexes)
         || (nDim == 2 && kind == meshFactory::mixed)
        )
        {
            continue;
        }

        INFO(nDim << "D cells " << kind << ", " << parts.name << ", "
            << medianDual::cellTreatmentNames[t]);

        meshFactory::block block;
        block.n = {{6, nDim > 1 ? 5 : 1, nDim > 2 ? 4 : 1}};
        block.isEmpty = {{false, nDim < 2, nDim < 3}};
        block.cells = kind;
        block.distortion = 0.15;

        const meshFactory::result whole(meshFactory::make(testTime(), block));
        const medianDual serial(*whole.mesh, t);

        block.rankOf = parts.rankOf;
        const meshFactory::result part(meshFactory::make(testTime(), block));
        const medianDual dual(*part.mesh, t);

        CHECK(dual.nDim() == nDim);
        CHECK(dual.thickness() == Approx(serial.thickness()));
        CHECK(dualChecks::consistent(dual));
        CHECK(dualChecks::gap(dual) < 1e-13);
        CHECK(dualChecks::weightError(dual) < 1e-13);
        CHECK(!serial.sharing().active());

        // Nodes
        const scalarField g(dualChecks::gradient(dual));
        const scalarField gSerial(dualChecks::gradient(serial));

        labelList wholeNode(whole.mesh->nPoints());
        forAll(wholeNode, pointi)
        {
            wholeNode[whole.globalPoint[pointi]] = serial.pointNode()[pointi];
        }

        scalar worstVolume = 0;
        scalar worstGradient = 0;
        for (label node = 0; node < dual.nNodes(); ++node)
        {
            const label other =
                wholeNode[part.globalPoint[dual.nodePoint()[node]]];

            worstVolume =
                max
                (
                    worstVolume,
                    mag(dual.nodeVolume()[node]/serial.nodeVolume()[other] - 1)
                );

            for (label i = 0; i < nDim*nDim; ++i)
            {
                worstGradient =
                    max
                    (
                        worstGradient,
                        mag
                        (
                            g[node*nDim*nDim + i]
                          - gSerial[other*nDim*nDim + i]
                        )
                    );
            }
        }

        CHECK(worstVolume < 1e-13);
        CHECK(worstGradient < 1e-12);

        CHECK
        (
            returnReduce
            (
                label(dual.sharing().owned().count()),
                sumOp<label>()
            )
         == serial.nNodes()
        );

        // Edges: each of them once, and complete
        const std::vector<edgeRecord> expected
        (
            edges(serial, whole.globalPoint)
        );
        const std::vector<edgeRecord> found
        (
            allEdges(edges(dual, part.globalPoint))
        );

        CHECK(found.size() == expected.size());

        label nWrong = 0;
        scalar worstArea = 0;
        for
        (
            std::size_t e = 0;
            e < std::min(found.size(), expected.size());
            ++e
        )
        {
            if (found[e].a != expected[e].a || found[e].b != expected[e].b)
            {
                ++nWrong;
            }
            for (label k = 0; k < 3; ++k)
            {
                worstArea =
                    max(worstArea, mag(found[e].c[k] - expected[e].c[k]));
            }
        }

        CHECK(nWrong == 0);
        CHECK(worstArea < 1e-14);

        // Corners, and those at the rim of a patch
        label nCorners = 0;
        label nSerialCorners = 0;
        label nRim = 0;
        label nSerialRim = 0;
        label nRimNodes = 0;
        label nSerialRimNodes = 0;
        forAll(serial.patches(), patchi)
        {
            const dualPatch& mine = dual.patches()[patchi];
            const dualPatch& its = serial.patches()[patchi];
            nCorners += mine.nCorners();
            nSerialCorners += its.nCorners();
            const boolList rim(patchRim::corners(*part.mesh, mine));
            for (const bool is : rim) nRim += is;
            for (const bool is : patchRim::nodes(*part.mesh, mine, rim))
            {
                nRimNodes += is;
            }
            const boolList all(patchRim::corners(*whole.mesh, its));
            for (const bool is : all) nSerialRim += is;
            for (const bool is : patchRim::nodes(*whole.mesh, its, all))
            {
                nSerialRimNodes += is;
            }
        }
        CHECK(returnReduce(nCorners, sumOp<label>()) == nSerialCorners);
        CHECK(returnReduce(nRim, sumOp<label>()) == nSerialRim);
        CHECK(returnReduce(nRimNodes, sumOp<label>()) == nSerialRimNodes);
        CHECK((nDim < 3) == (nSerialRimNodes == nSerialRim));

        // Around each side, whatever its faces are split into
        CHECK(nSerialRim == (nDim == 1 ? 0 : nDim == 2 ? 8 : 8*(6 + 5 + 4)));
    }
}


TEST_CASE("exchange of nodal data", "[nodeSharing][parallel]")
{
    for (const decomposition& parts : decompositions())
    {
        INFO(parts.name);

        meshFactory::block block;
        block.n = {{6, 5, 4}};
        block.rankOf = parts.rankOf;

        const meshFactory::result part(meshFactory::make(testTime(), block));
        const medianDual dual(*part.mesh, treatment::simplicial);
        const nodeSharing& sharing = dual.sharing();

        const label n = dual.nNodes();
        const label rank = Pstream::myProcNo();

        // What every rank has, by point of the whole mesh
        const label nGlobal = 7*6*5;
        List<List<scalar>> values(Pstream::nProcs());
        values[rank] = List<scalar>(nGlobal, scalar(-1));

        auto value = [](const label r, const label pointi)
        {
            // Sums of these depend on the order
            return 1 + 0.1*r + 1e-3*pointi/7.0 + (r == 1 ? 1e10 : 0);
        };

        for (label node = 0; node < n; ++node)
        {
            const label pointi = part.globalPoint[dual.nodePoint()[node]];
            values[rank][pointi] = value(rank, pointi);
        }

        Pstream::gatherList(values);
        Pstream::scatterList(values);

        scalarField one(n);
        scalarField two(2*n);
        scalarField low(n);
        scalarField high(n);

        for (label node = 0; node < n; ++node)
        {
            const label pointi = part.globalPoint[dual.nodePoint()[node]];

            one[node] = value(rank, pointi);
            two[2*node] = one[node];
            two[2*node + 1] = -2*one[node];
            low[node] = one[node];
            high[node] = one[node];
        }

        sharing.sum({{one.data(), 1}, {two.data(), 2}});
        sharing.min(low.data(), 1);
        sharing.max(high.data(), 1);

        bool sumExact = true;
        bool minExact = true;
        bool maxExact = true;
        bool owned = true;

        for (label node = 0; node < n; ++node)
        {
            const label pointi = part.globalPoint[dual.nodePoint()[node]];

            // To the last bit: in ascending order
            scalar sum = 0;
            scalar smallest = GREAT;
            scalar largest = -GREAT;
            label lowest = -1;

            forAll(values, r)
            {
                if (values[r][pointi] > 0)
                {
                    sum += values[r][pointi];
                    smallest = min(smallest, values[r][pointi]);
                    largest = max(largest, values[r][pointi]);
                    lowest = (lowest == -1 ? r : lowest);
                }
            }

            sumExact = sumExact && one[node] == sum;
            sumExact = sumExact && two[2*node] == sum;
            sumExact = sumExact && two[2*node + 1] == -2*sum;
            minExact = minExact && low[node] == smallest;
            maxExact = maxExact && high[node] == largest;
            owned = owned && sharing.owned().test(node) == (lowest == rank);
        }

        CHECK(sumExact);
        CHECK(minExact);
        CHECK(maxExact);
        CHECK(owned);

        // One id for each node, the same on all ranks
        labelList id(nGlobal, labelMax);
        for (label node = 0; node < n; ++node)
        {
            id[part.globalPoint[dual.nodePoint()[node]]] =
                sharing.globalNode()[node];
        }
        labelList lowest(id);
        Pstream::listCombineGather(lowest, minEqOp<label>());
        Pstream::listCombineScatter(lowest);

        bool same = true;
        for (label pointi = 0; pointi < nGlobal; ++pointi)
        {
            const bool held = (id[pointi] != labelMax);
            same = same && (!held || id[pointi] == lowest[pointi]);
        }
        CHECK(same);

        labelList sorted(lowest);
        std::sort(sorted.begin(), sorted.end());
        CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
    }
}


TEST_CASE("nothing is shared in a serial run", "[nodeSharing][serial]")
{
    meshFactory::block block;
    const meshFactory::result made(meshFactory::make(testTime(), block));
    const medianDual dual(*made.mesh, treatment::simplicial);

    CHECK(!dual.sharing().active());
    CHECK(label(dual.sharing().owned().count()) == dual.nNodes());

    scalarField values(dual.nNodes(), scalar(1));
    dual.sharing().sum(values.data(), 1);
    dual.sharing().min(values.data(), 1);
    CHECK(values[0] == 1);
}

// ************************************************************************* //
