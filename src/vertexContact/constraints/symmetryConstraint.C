/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "symmetryConstraint.H"
#include <algorithm>
#include "solidTensor.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::symmetryConstraint::findKinks
(
    const medianDual& dual,
    const label patchi,
    const scalarField& areas
)
{
    const label d = nDim_;
    const dualPatch& patch = dual.patches()[patchi];
    forAll(patch.cornerNode, k)
    {
        const label a = patch.cornerNode[k];
        scalar along = 0, magSqrS = 0;
        for (label j = 0; j < d; ++j)
        {
            along += patch.cornerNormal[k*d + j]*areas[a*d + j];
            magSqrS += sqr(areas[a*d + j]);
        }
        const scalar cosine = along/std::sqrt(max(magSqrS, VSMALL));
        if (cosine < kinkCosine_)
        {
            kinkCosine_ = cosine;
            kinkedPatch_ = patchi;
            kink_ = dual.position(a);
        }
    }
}


void Foam::symmetryConstraint::findGroups()
{
    const label d = nDim_;
    group_ = identity(patch_.size());
    forAll(nodes_, i)
    {
        const label first = start_[i], end = start_[i + 1];
        for (label k = first; k < end; ++k)
        {
            for (label m = first; m < k; ++m)
            {
                scalar cosine = 0;
                for (label j = 0; j < d; ++j)
                {
                    cosine += given_[k*d + j]*given_[m*d + j];
                }
                if (mag(cosine) <= parallel) continue;

                // All of both groups are one
                const label one = min(group_[k], group_[m]);
                const label other = max(group_[k], group_[m]);
                for (label l = first; l <= k; ++l)
                {
                    if (group_[l] == other) group_[l] = one;
                }
            }
        }
    }
}


template<int D>
void Foam::symmetryConstraint::makeIsotropic
(
    scalar (&T)[D][D],
    const label first,
    const label end
) const
{
    // Most nodes have one
    if (end - first < 2) return;

    const auto along = [&](const label k)
    {
        const scalar* n = normals_.cdata() + k*D;
        scalar sum = 0;
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j) sum += n[i]*T[i][j]*n[j];
        }
        return sum;
    };
    for (label g = first; g < end; ++g)
    {
        scalar sum = 0;
        label size = 0;
        for (label k = g; k < end; ++k)
        {
            if (group_[k] != g) continue;
            sum += along(k);
            ++size;
        }
        if (size < 2) continue;

        for (label k = g; k < end; ++k)
        {
            if (group_[k] != g) continue;
            const scalar* n = normals_.cdata() + k*D;
            const scalar change = sum/size - along(k);
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j) T[i][j] += change*n[i]*n[j];
            }
        }
    }
}


void Foam::symmetryConstraint::symmetrise
(
    scalar* T,
    const label rank,
    const scalar* n
) const
{
    const label d = nDim_;
    const label size = rank == 1 ? d : d*d*d;

    scalar mirror[27];
    for (label k = 0; k < size; ++k) mirror[k] = T[k];

    // Reflect one index after the other: T_i -> T_i - 2 n_i n_k T_k
    for (label stride = 1; stride < size; stride *= d)
    {
        for (label k = 0; k < size; ++k)
        {
            if ((k/stride) % d != 0) continue;
            scalar along = 0;
            for (label i = 0; i < d; ++i) along += n[i]*mirror[k + i*stride];
            for (label i = 0; i < d; ++i)
            {
                mirror[k + i*stride] -= 2*n[i]*along;
            }
        }
    }
    // In 1D the loop above has no pass: each index changes the sign
    if (d == 1) mirror[0] = -T[0];

    for (label k = 0; k < size; ++k) T[k] = 0.5*(T[k] + mirror[k]);
}


template<int D>
void Foam::symmetryConstraint::symmetriseTensors
(
    scalar* data,
    const label stride,
    const labelUList& place,
    const label first,
    const label end
) const
{
    for (label a = first; a < end; ++a)
    {
        scalar* p = data + nodes_[a]*stride;
        scalar T[D][D];
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j) T[i][j] = p[place[i*D + j]];
        }
        for (label k = start_[a]; k < start_[a + 1]; ++k)
        {
            // The mean of T and (I - 2 n n) T (I - 2 n n)
            const scalar* n = normals_.cdata() + k*D;
            scalar Tn[D] = {}, nT[D] = {}, nTn = 0;
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    Tn[i] += T[i][j]*n[j];
                    nT[j] += n[i]*T[i][j];
                }
            }
            for (int i = 0; i < D; ++i) nTn += n[i]*Tn[i];
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    T[i][j] +=
                        2*nTn*n[i]*n[j] - n[i]*nT[j] - Tn[i]*n[j];
                }
            }
        }
        makeIsotropic<D>(T, start_[a], start_[a + 1]);
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j) p[place[i*D + j]] = T[i][j];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::symmetryConstraint::symmetryConstraint
(
    const medianDual& dual,
    const labelList& patchIDs
)
:
    nDim_(dual.nDim())
{
    if (patchIDs.empty())
    {
        start_ = labelList(1, label(0));
        return;
    }

    // Area vector of each mirror at each node
    const label d = nDim_;
    List<scalarField> areas(patchIDs.size());
    forAll(patchIDs, i)
    {
        const dualPatch& patch = dual.patches()[patchIDs[i]];
        areas[i].setSize(dual.nNodes()*d, Zero);
        patch.addAreas(areas[i]);
        dual.sharing().sum(areas[i].data(), d);
        findKinks(dual, patchIDs[i], areas[i]);
    }

    DynamicList<label> nodes, start, patch;
    DynamicList<scalar> normals, given;
    start.append(0);

    for (label a = 0; a < dual.nNodes(); ++a)
    {
        const label first = normals.size();
        forAll(patchIDs, i)
        {
            FixedList<scalar, 3> n(Zero);
            scalar magS = 0;
            for (label j = 0; j < d; ++j) magS += sqr(areas[i][a*d + j]);
            magS = std::sqrt(magS);
            if (magS < VSMALL) continue;
            for (label j = 0; j < d; ++j) n[j] = areas[i][a*d + j]/magS;
            const FixedList<scalar, 3> its(n);

            // Orthogonal to those before; parallel ones add nothing
            if (makeOrthogonal(d, n.data(), normals, first))
            {
                for (label j = 0; j < d; ++j)
                {
                    normals.append(n[j]);
                    given.append(its[j]);
                }
                patch.append(patchIDs[i]);
            }
        }
        if (normals.size() > first)
        {
            nodes.append(a);
            start.append(normals.size()/d);
        }
    }

    nodes_.transfer(nodes);
    start_.transfer(start);
    normals_ = scalarField(normals);
    given_ = scalarField(given);
    patch_.transfer(patch);
    findGroups();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::symmetryConstraint::kinked(point& at) const
{
    const scalar least = returnReduce(kinkCosine_, minOp<scalar>());
    if (least > leastOfOne) return -1;

    // That of the first rank that has it
    const label rank = returnReduce
    (
        kinkCosine_ > least ? Pstream::nProcs() : Pstream::myProcNo(),
        minOp<label>()
    );
    const bool mine = rank == Pstream::myProcNo();
    at = returnReduce(mine ? kink_ : point(point::zero), sumOp<point>());
    return returnReduce(mine ? kinkedPatch_ : label(-1), maxOp<label>());
}


void Foam::symmetryConstraint::projectEdges
(
    const medianDual& dual,
    scalarField& area
) const
{
    const label d = nDim_;
    labelList place(dual.nNodes(), -1);
    forAll(nodes_, i)
    {
        place[nodes_[i]] = i;
    }

    const scalar* X = dual.nodePosition().cdata();
    for (label e = 0; e < dual.nEdges(); ++e)
    {
        const label a = dual.edgeNodes()[2*e], b = dual.edgeNodes()[2*e + 1];
        if (place[a] < 0 || place[b] < 0) continue;

        scalar rr = 0;
        for (label j = 0; j < d; ++j) rr += sqr(X[b*d + j] - X[a*d + j]);

        // Normals of the mirrors that it is in, made orthogonal
        DynamicList<scalar, 9> in;
        for (label k = start_[place[a]]; k < start_[place[a] + 1]; ++k)
        {
            // In the mirror of a: normal to it, with the same normal at b
            const scalar* n = given_.cdata() + k*d;
            scalar along = 0;
            for (label j = 0; j < d; ++j)
            {
                along += n[j]*(X[b*d + j] - X[a*d + j]);
            }
            bool shared = false;
            for (label m = start_[place[b]]; m < start_[place[b] + 1]; ++m)
            {
                scalar cosine = 0;
                for (label j = 0; j < d; ++j) cosine += n[j]*given_[m*d + j];
                shared = shared || mag(cosine) > 1 - oneMirror;
            }
            if (!shared || sqr(along) >= inMirror*rr) continue;

            FixedList<scalar, 3> its(Zero);
            for (label j = 0; j < d; ++j) its[j] = n[j];
            if (makeOrthogonal(d, its.data(), in, 0))
            {
                for (label j = 0; j < d; ++j) in.append(its[j]);
            }
        }
        for (label k = 0; k < in.size(); k += d)
        {
            scalar areaN = 0;
            for (label j = 0; j < d; ++j) areaN += in[k + j]*area[e*d + j];
            for (label j = 0; j < d; ++j) area[e*d + j] -= areaN*in[k + j];
        }
    }
}


Foam::scalar Foam::symmetryConstraint::project
(
    scalar* data,
    const label stride
) const
{
    const label d = nDim_;
    scalar removed = 0;

    forAll(nodes_, i)
    {
        scalar* p = data + nodes_[i]*stride;
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            const scalar* n = normals_.cdata() + k*d;
            scalar along = 0;
            for (label j = 0; j < d; ++j) along += n[j]*p[j];
            for (label j = 0; j < d; ++j) p[j] -= along*n[j];
            removed = max(removed, mag(along));
        }
    }

    return removed;
}


void Foam::symmetryConstraint::symmetriseTensors
(
    scalar* data,
    const label stride,
    const labelUList& place,
    const label firstNode,
    const label endNode
) const
{
    const auto placeOf = [this](const label node)
    {
        return label
        (
            std::lower_bound(nodes_.begin(), nodes_.end(), node)
          - nodes_.begin()
        );
    };
    withDirections(nDim_, [&](auto D)
    {
        symmetriseTensors<D.value>
        (
            data, stride, place, placeOf(firstNode), placeOf(endNode)
        );
    });
}


void Foam::symmetryConstraint::symmetrise
(
    scalar* data,
    const label stride,
    const labelUList& place,
    const label rank
) const
{
    if (rank == 2)
    {
        symmetriseTensors(data, stride, place, 0, labelMax);
        return;
    }
    const label n = place.size();
    FixedList<scalar, 27> T;

    forAll(nodes_, i)
    {
        scalar* p = data + nodes_[i]*stride;
        for (label c = 0; c < n; ++c) T[c] = p[place[c]];
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            symmetrise(T.data(), rank, normals_.cdata() + k*nDim_);
        }
        for (label c = 0; c < n; ++c) p[place[c]] = T[c];
    }
}


// ************************************************************************* //
