/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "directionConstraint.H"
#include "prescribedMotion.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::directionConstraint::directionConstraint
(
    const medianDual& dual,
    const symmetryConstraint& mirrors,
    const UList<condition>& conditions,
    const labelList& fixed
)
:
    nDim_(dual.nDim()),
    start_(1, label(0)),
    conditions_(conditions)
{
    if (conditions.empty()) return;

    // Conditions of each node, also on ranks that have none of its faces there
    const label nConditions = conditions.size();
    scalarField holds(dual.nNodes()*nConditions, Zero);
    forAll(conditions, c)
    {
        for (const label a : dual.patches()[conditions[c].patch].cornerNode)
        {
            holds[a*nConditions + c] = 1;
        }
    }
    dual.sharing().max(holds.data(), nConditions);
    for (const label a : fixed)
    {
        for (label c = 0; c < nConditions; ++c) holds[a*nConditions + c] = 0;
    }

    const label d = nDim_;
    DynamicList<label> nodes, start, patch, condition;
    DynamicList<scalar> normals, given;
    start.append(0);

    const auto add = [&](const scalar* n, const label patchi, const label c)
    {
        scalar e[3];
        for (label j = 0; j < d; ++j) e[j] = n[j];
        const label first = start.last()*d;
        if (!symmetryConstraint::makeOrthogonal(d, e, normals, first)) return;
        for (label j = 0; j < d; ++j)
        {
            normals.append(e[j]);
            given.append(n[j]);
        }
        patch.append(patchi);
        condition.append(c);
    };

    for (label a = 0; a < dual.nNodes(); ++a)
    {
        bool any = false;
        for (label c = 0; c < nConditions; ++c)
        {
            any = any || holds[a*nConditions + c] > 0.5;
        }
        if (!any) continue;

        mirrors.visit
        (
            a, [&](const label patchi, const scalar* n) { add(n, patchi, -1); }
        );
        for (label c = 0; c < nConditions; ++c)
        {
            if (holds[a*nConditions + c] < 0.5) continue;
            for (const vector& direction : conditions[c].motion->directions())
            {
                scalar n[3];
                for (label j = 0; j < d; ++j)
                {
                    n[j] = direction[dual.directions()[j]];
                }
                add(n, conditions[c].patch, c);
            }
        }
        nodes.append(a);
        start.append(patch.size());
    }

    nodes_.transfer(nodes);
    start_.transfer(start);
    patch_.transfer(patch);
    condition_.transfer(condition);
    normals_ = scalarField(normals);
    given_ = scalarField(given);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::directionConstraint::impose
(
    scalar* lm,
    const scalar* disp,
    const scalarField& values,
    const scalar rho,
    const scalar deltaT
) const
{
    const label d = nDim_;
    forAll(nodes_, i)
    {
        scalar* p = lm + nodes_[i]*d;
        const scalar* u = disp + nodes_[i]*d;
        scalar along[3];
        const label first = start_[i];
        for (label k = first; k < start_[i + 1]; ++k)
        {
            const scalar* e = normals_.cdata() + k*d;
            const scalar* n = given_.cdata() + k*d;
            const label c = condition_[k];

            scalar value = 0, ne = 0;
            for (label j = 0; j < d; ++j)
            {
                ne += n[j]*e[j];
                if (c >= 0)
                {
                    value +=
                        n[j]
                       *(
                            conditions_[c].motion->ofDisplacement()
                          ? (values[c*d + j] - u[j])/deltaT
                          : values[c*d + j]
                        );
                }
            }
            for (label m = first; m < k; ++m)
            {
                scalar cosine = 0;
                for (label j = 0; j < d; ++j) cosine += n[j]*normals_[m*d + j];
                value -= cosine*along[m - first];
            }
            along[k - first] = value/ne;

            scalar now = 0;
            for (label j = 0; j < d; ++j) now += e[j]*p[j];
            for (label j = 0; j < d; ++j)
            {
                p[j] += (rho*along[k - first] - now)*e[j];
            }
        }
    }
}


// ************************************************************************* //
