/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyFields.H"
#include "solidBody.H"
#include "writtenTimes.H"
#include "Time.H"
#include "pointFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type, class NodeFunction>
void Foam::bodyFields::writeField
(
    const word& name,
    const dimensionSet& dims,
    const NodeFunction& valueOfNode
) const
{
    GeometricField<Type, pointPatchField, pointMesh> field
    (
        IOobject
        (
            name, body_.mesh().time().timeName(), body_.mesh(),
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        pointMesh::New(body_.mesh()),
        dimensioned<Type>(name, dims, Zero)
    );

    const medianDual& dual = body_.dual();
    List<Type> values(dual.nNodes());
    forAll(values, a)
    {
        values[a] = valueOfNode(a);
    }
    Field<Type>& points = field.primitiveFieldRef();
    forAll(points, i)
    {
        points[i] = values[dual.pointNode()[i]];
    }
    field.write();
    writtenTimes::check(field);
}


template<class Use>
void Foam::bodyFields::visitFields(const Use& use) const
{
    const vertexData& data = body_.data();
    const conservedState& s = data.state;
    const materialModel& material = body_.material();
    const label d = body_.dual().nDim();
    const FixedList<label, 3>& dir = body_.dual().directions();

    use
    (
        vector::zero, "lm", dimDensity*dimVelocity,
        [&](const label a) { return body_.expand(s.lm.cdata() + a*d); }
    );
    if (const scalarField* acceleration = body_.acceleration())
    {
        use
        (
            vector::zero, "acceleration", dimAcceleration,
            [=](const label a)
            {
                return body_.expand(acceleration->cdata() + a*d);
            }
        );
    }
    use
    (
        vector::zero, "pointD", dimLength,
        [&](const label a) { return body_.expand(s.disp.cdata() + a*d); }
    );
    use
    (
        tensor::zero, "F", dimless,
        [&](const label a) { return body_.deformationGradient(a); }
    );
    if (s.solvesH)
    {
        use
        (
            tensor::zero, "H", dimless,
            [&](const label a)
            {
                tensor H(Zero);
                if (d == 3)
                {
                    for (label k = 0; k < 9; ++k) H[k] = s.H[9*a + placeH(k)];
                }
                else
                {
                    const SolidTensor<2> G =
                        loadH<2>(loadF<2>(s.F.cdata(), a), s.H.cdata(), a);
                    for (label i = 0; i < 2; ++i)
                    {
                        for (label j = 0; j < 2; ++j)
                        {
                            H[3*dir[i] + dir[j]] = G(i, j);
                        }
                    }
                    H[4*(3 - dir[0] - dir[1])] = G.out;
                }
                return H;
            }
        );
    }
    if (s.solvesJ)
    {
        use
        (
            scalar(0), "J", dimless, [&](const label a) { return s.J[a]; }
        );
    }
    else if (data.variational && data.finiteStrain)
    {
        use
        (
            scalar(0), "J", dimless,
            [&](const label a) { return det(body_.deformationGradient(a)); }
        );
    }

    if (material.initial().on())
    {
        use
        (
            tensor::zero, "F0", dimless,
            [&](const label a)
            {
                return body_.inSpace(material.initial().value(a));
            }
        );
    }

    if (material.plastic())
    {
        use
        (
            symmTensor::zero, "CpInv", dimless,
            [&](const label a)
            {
                const scalar* p = s.Cpi.cdata() + a*s.strideCpi;
                tensor C(d < 3 ? p[s.strideCpi - 1]*tensor(tensor::I) : Zero);
                for (label i = 0; i < d; ++i)
                {
                    for (label j = i; j < d; ++j)
                    {
                        C[3*dir[i] + dir[j]] = C[3*dir[j] + dir[i]] = *p++;
                    }
                }
                return symm(C);
            }
        );
        use
        (
            scalar(0), "epsilonPEq", dimless,
            [&](const label a) { return s.epsilonPEq[a]; }
        );
        // Not its size, which is 0 where a processor has no node of the body
        if (s.keepsFlow && d > 1)
        {
            use
            (
                scalar(0), "hourglassShare", dimless,
                [&](const label a) { return s.hourglassShare[a]; }
            );
        }
        if (material.initialTemperature() > 0)
        {
            use
            (
                scalar(0), "pointT", dimTemperature,
                [&](const label a) { return s.temperature[a]; }
            );
        }
    }

    use
    (
        symmTensor::zero, "sigma", dimPressure,
        [&](const label a) { return body_.CauchyStress(a); }
    );
    use
    (
        scalar(0), "sigmaEq", dimPressure,
        [&](const label a)
        {
            return std::sqrt(1.5*magSqr(dev(body_.CauchyStress(a))));
        }
    );
    use
    (
        scalar(0), "pressure", dimPressure,
        [&](const label a) { return 0 - tr(body_.CauchyStress(a))/3; }
    );
}


template<class Use>
void Foam::bodyFields::visitContactFields(const Use& use) const
{
    const bodyContact& contact = body_.contact();
    if (contact.on())
    {
        // A node gets the sums over its corners on all processors
        vectorField force(contact.force);
        scalarField area(contact.area), gap(contact.gap);
        const nodeSharing& sharing = body_.dual().sharing();
        sharing.sum(reinterpret_cast<scalar*>(force.data()), 3);
        sharing.sum(area.data(), 1);
        sharing.min(gap.data(), 1);

        use
        (
            scalar(0), "contactStatus", dimless,
            [&](const label a) { return contact.status[a]; }
        );
        use
        (
            vector::zero, "contactTraction", dimPressure,
            [&](const label a)
            {
                return area[a] > 0 ? force[a]/area[a] : vector(Zero);
            }
        );
        use
        (
            scalar(0), "contactGap", dimLength,
            [&](const label a)
            {
                return gap[a] < bodyContact::far ? gap[a] : 0;
            }
        );
        if (contact.slide.on())
        {
            use
            (
                vector::zero, "contactSlide", dimLength,
                [&](const label a) { return contact.slide.ways()[a]; }
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyFields::write() const
{
    const auto one = [&]
    (
        const auto& zero,
        const word& name,
        const dimensionSet& dims,
        const auto& valueOfNode
    )
    {
        writeField<std::decay_t<decltype(zero)>>(name, dims, valueOfNode);
    };
    visitFields(one);
    visitContactFields(one);
}


Foam::wordList Foam::bodyFields::names() const
{
    DynamicList<word> all({word("pointU")});
    const auto one = [&]
    (
        const auto& zero,
        const word& name,
        const dimensionSet& dims,
        const auto& valueOfNode
    )
    {
        all.append(name);
    };
    visitFields(one);
    const bodyContact& contact = body_.contact();
    if (contact.on())
    {
        all.append({"contactStatus", "contactTraction", "contactGap"});
        if (contact.slide.on()) all.append("contactSlide");
    }
    return wordList(all);
}


Foam::nodalField Foam::bodyFields::field
(
    const word& name,
    const labelUList& nodes
) const
{
    nodalField result;
    const auto one = [&]
    (
        const auto& zero,
        const word& thisName,
        const dimensionSet& dims,
        const auto& valueOfNode
    )
    {
        typedef std::decay_t<decltype(zero)> Type;
        if (thisName != name) return;
        const label n = pTraits<Type>::nComponents;
        result.nComponents = n;
        result.dimensions.reset(dims);
        result.values.setSize(n*nodes.size());
        forAll(nodes, k)
        {
            const Type value(valueOfNode(nodes[k]));
            for (label c = 0; c < n; ++c)
            {
                result.values[n*k + c] = component(value, c);
            }
        }
    };

    if (name == "pointU")
    {
        one
        (
            vector::zero, name, dimVelocity,
            [&](const label a) { return body_.velocity(a); }
        );
    }
    else if (name.compare(0, 7, "contact") == 0)
    {
        visitContactFields(one);
    }
    else
    {
        visitFields(one);
    }
    return result;
}


// ************************************************************************* //
