/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The fields of a region as they are written and looked at, and what the log
    says of it.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "writtenTimes.H"
#include "Time.H"
#include "pointFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type, class NodeFunction>
void Foam::solidBody::writeField
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
            name, time_.timeName(), mesh_,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        pointMesh::New(mesh_),
        dimensioned<Type>(name, dims, Zero)
    );

    List<Type> values(dual_.nNodes());
    forAll(values, a)
    {
        values[a] = valueOfNode(a);
    }
    Field<Type>& points = field.primitiveFieldRef();
    forAll(points, i)
    {
        points[i] = values[dual_.pointNode()[i]];
    }
    field.write();
    writtenTimes::check(field);
}


template<class Use>
void Foam::solidBody::visitFields(const Use& use) const
{
    const conservedState& s = data_.state;
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();

    use
    (
        vector::zero, "lm", dimDensity*dimVelocity,
        [&](const label a) { return expand(s.lm.cdata() + a*d); }
    );
    if (scheme_.valid() && d > 1)
    {
        use
        (
            vector::zero, "acceleration", dimAcceleration,
            [&](const label a)
            {
                return expand(scheme_->acceleration().cdata() + a*d);
            }
        );
    }
    use
    (
        vector::zero, "pointD", dimLength,
        [&](const label a) { return expand(s.disp.cdata() + a*d); }
    );
    use
    (
        tensor::zero, "F", dimless,
        [&](const label a) { return deformationGradient(a); }
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
    else if (data_.variational && data_.finiteStrain)
    {
        use
        (
            scalar(0), "J", dimless,
            [&](const label a) { return det(deformationGradient(a)); }
        );
    }

    if (material_->initial().on())
    {
        use
        (
            tensor::zero, "F0", dimless,
            [&](const label a)
            {
                return inSpace(material_->initial().value(a));
            }
        );
    }

    if (material_->plastic())
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
        if (material_->initialTemperature() > 0)
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
        [&](const label a) { return CauchyStress(a); }
    );
    use
    (
        scalar(0), "sigmaEq", dimPressure,
        [&](const label a)
        {
            return std::sqrt(1.5*magSqr(dev(CauchyStress(a))));
        }
    );
    use
    (
        scalar(0), "pressure", dimPressure,
        [&](const label a) { return 0 - tr(CauchyStress(a))/3; }
    );
}


template<class Use>
void Foam::solidBody::visitContactFields(const Use& use) const
{
    if (contact_.on())
    {
        // Corners of other processors add to the nodes of this one
        vectorField force(contact_.force);
        scalarField area(contact_.area), gap(contact_.gap);
        dual_.sharing().sum
        (
            reinterpret_cast<scalar*>(force.data()), 3
        );
        dual_.sharing().sum(area.data(), 1);
        dual_.sharing().min(gap.data(), 1);

        use
        (
            scalar(0), "contactStatus", dimless,
            [&](const label a) { return contact_.status[a]; }
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
        if (contact_.slide.on())
        {
            use
            (
                vector::zero, "contactSlide", dimLength,
                [&](const label a) { return contact_.slide.ways()[a]; }
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidBody::write()
{
    placeAll();

    // Velocity, with its boundary conditions
    {
        vectorField& U = pointU_.primitiveFieldRef();
        forAll(U, i)
        {
            const label a = dual_.pointNode()[i];
            for (label k = 0; k < dual_.nDim(); ++k)
            {
                U[i][dual_.directions()[k]] = velocity(a, k);
            }
        }
        pointU_.instance() = time_.timeName();
        pointU_.write();
        writtenTimes::check(pointU_);
    }

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


Foam::wordList Foam::solidBody::fieldNames() const
{
    DynamicList<word> names({word("pointU")});
    const auto one = [&]
    (
        const auto& zero,
        const word& name,
        const dimensionSet& dims,
        const auto& valueOfNode
    )
    {
        names.append(name);
    };
    visitFields(one);
    if (contact_.on())
    {
        names.append({"contactStatus", "contactTraction", "contactGap"});
        if (contact_.slide.on()) names.append("contactSlide");
    }
    return wordList(names);
}


Foam::solidBody::nodalField Foam::solidBody::field(const word& name) const
{
    placeAll();
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
        result.values.setSize(n*dual_.nNodes());
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            const Type value(valueOfNode(a));
            for (label c = 0; c < n; ++c)
            {
                result.values[n*a + c] = component(value, c);
            }
        }
    };

    if (name == "pointU")
    {
        one
        (
            vector::zero, name, dimVelocity,
            [&](const label a)
            {
                vector v(Zero);
                for (label k = 0; k < dual_.nDim(); ++k)
                {
                    v[dual_.directions()[k]] = velocity(a, k);
                }
                return v;
            }
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


std::size_t Foam::solidBody::bytes() const
{
    return
        data_.bytes() + dual_.bytes() + (scheme_.valid() ? scheme_->bytes() : 0)
      + contact_.bytes()
      + sizeof(scalar)
       *std::size_t
        (
            acceleration_.size() + externalForce_.size() + work_.size()
        );
}


void Foam::solidBody::reportPaper(Ostream& os) const
{
    const label d = dual_.nDim();
    const conservedState& s = data_.state;
    const auto onOff = [](const bool on) { return on ? "on" : "off"; };

    os  << ", reconstruction "
        << schemeOptions::reconstructionNames[options_.reconstruction]
        << ", limiter " << schemeOptions::limiterNames[options_.limiter]
        << nl
        << "    kinematics "
        << conservedState::kinematicSetNames
           [
               !s.solvesJ ? kinematicSet::F
             : s.solvesH || d == 1 ? options_.kinematics
             : kinematicSet::FJ
           ]
        << (data_.finiteStrain ? "" : " (small strains need no more)")
        << ", jacobian "
        << (
               data_.finiteStrain
             ? materialModel::jacobianFormNames[options_.jacobian]
             : word("none")
           )
        << nl
        << "    stored per node: momentum " << d << ", displacement " << d
        << ", F " << d*d << ", H " << s.strideH << ", J "
        << label(s.solvesJ) << ", stress " << d*d + data_.nSJ
        << " components" << nl
        << "    H solved " << onOff(s.solvesH)
        << ", J solved " << onOff(s.solvesJ)
        << ", gradients " << onOff
           (
               data_.reconstruction != reconstructionType::none
           )
        << ", limiter " << onOff(options_.limiter != limiterType::none)
        << ", dissipation " << options_.dissipation
        << ", waves " << (stretchedWaves_ ? "stretched" : "linear");
}


void Foam::solidBody::report(Ostream& os) const
{
    const label d = dual_.nDim();
    const conservedState& s = data_.state;
    const label nNodes = returnReduce(dual_.nNodes(), sumOp<label>());
    const scalar allBytes = returnReduce(scalar(bytes()), sumOp<scalar>());
    const auto onOff = [](const bool on) { return on ? "on" : "off"; };

    dual_.report(os);
    if (rigid_.valid())
    {
        rigid_->report(os);
        os  << nl << "    gravity "
            << onOff(mag(max(gravity_)) + mag(min(gravity_)) > 0)
            << ", contact " << onOff(contact_.on()) << nl << "    "
            << label(allBytes/max(nNodes, label(1))) << " bytes per node"
            << nl;
        return;
    }
    os  << "    material " << material_->type()
        << ", rho " << material_->rho() << " kg/m3";
    if (massFactor() != 1)
    {
        os  << " (" << material_->weightRho() << " times " << massFactor()
            << ", massScaling)";
    }
    os  << ", cp " << material_->cp()
        << " m/s, cs " << material_->cs() << " m/s" << nl
        << "    cells " << medianDual::cellTreatmentNames[options_.cells];
    if (data_.variational)
    {
        os  << ", variational scheme, correction " << options_.correction
            << nl
            << "    volume " << schemeOptions::volumeNames[options_.volume]
            << ": Poisson's ratio " << PoissonsRatio(*material_)
            << ", Jacobian " << (s.solvesJ ? "smoothed" : "of each node")
            << " (smoothed from " << smoothedFrom << " on)" << nl
            << "    stored per node: momentum " << d << ", displacement " << d
            << ", F " << d*d << ", stress " << d*d + data_.nSJ
            << " components" << nl
            << "    largest frequency " << scheme_->largestFrequency()
            << " 1/s (undeformed), dissipation " << options_.dissipation
            << " to " << options_.frontDissipation;
    }
    else
    {
        reportPaper(os);
    }
    os  << ", gravity " << onOff(mag(max(gravity_)) + mag(min(gravity_)) > 0)
        << ", body forces";
    for (const bodyForce& force : bodyForces_)
    {
        os  << ' ' << force.name() << " (" << force.type() << ')';
    }
    os  << (bodyForces_.empty() ? " off" : "")
        << ", contact " << onOff(contact_.on())
        << ", plasticity " << onOff(material_->plastic());
    if (damping_.valid()) os << ", damping on";
    if (material_->initial().on()) os << ", initial stretch on";
    if (material_->plastic())
    {
        os  << ", adiabatic heating "
            << onOff(material_->initialTemperature() > 0);
    }
    os  << nl
        << "    " << label(allBytes/max(nNodes, label(1)))
        << " bytes per node" << nl;
}


// ************************************************************************* //
