/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "regionFiles.H"
#include "rigidMaterial.H"
#include "dictionaryCheck.H"
#include "fileError.H"
#include "writtenTimes.H"
#include "Time.H"
#include "pointFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::autoPtr
<
    Foam::GeometricField<Type, Foam::pointPatchField, Foam::pointMesh>
>
Foam::solidBody::readIfPresent
(
    const word& name,
    const dimensionSet& dims,
    fileName* from
) const
{
    typedef GeometricField<Type, pointPatchField, pointMesh> pointFieldType;

    IOobject io
    (
        name, time_.timeName(), mesh_,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );

    autoPtr<pointFieldType> field;
    fileName file(io.objectPath());
    if (dictionaryCheck::isThere<pointFieldType>(io))
    {
        field.reset(new pointFieldType(io, pointMesh::New(mesh_)));
    }
    else
    {
        file = regionFiles::sharedField(name, mesh_);
        if (file.empty()) return field;

        const dictionary dict(regionFiles::readShared(file));
        field.reset
        (
            new pointFieldType
            (
                IOobject
                (
                    name, time_.timeName(), mesh_,
                    IOobject::NO_READ, IOobject::NO_WRITE, false
                ),
                pointMesh::New(mesh_),
                dimensioned<Type>
                (
                    name, dict.get<dimensionSet>("dimensions"), Zero
                )
            )
        );
        field->primitiveFieldRef() =
            Field<Type>("internalField", dict, mesh_.nPoints());
    }
    if (from) *from = file;

    if (field->dimensions() != dims)
    {
        FatalFileErrorInFunction(file)
            << "Keyword 'dimensions' is " << field->dimensions()
            << ": it must be " << dims << exit(FatalIOError);
    }
    for (const Type& value : field->primitiveField())
    {
        for (direction c = 0; c < pTraits<Type>::nComponents; ++c)
        {
            if (!std::isfinite(component(value, c)))
            {
                FatalFileErrorInFunction(file)
                    << "Keyword 'internalField': a value is not finite"
                    << exit(FatalIOError);
            }
        }
    }
    return field;
}


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


Foam::autoPtr<Foam::materialModel> Foam::solidBody::readMaterial() const
{
    const dictionary dict(regionFiles::material(mesh_));
    autoPtr<materialModel> law;
    if (rigidMaterial::describedBy(dict))
    {
        law.reset(new rigidMaterial(rigidMass(dict, dual_).density));
    }
    else
    {
        law = materialModel::New(dict, options_.jacobian);
    }
    law->setInitialStretch(readInitialStretch(*law));
    return law;
}


Foam::initialStretch Foam::solidBody::readInitialStretch
(
    const materialModel& law
) const
{
    fileName file;
    const auto field = readIfPresent<tensor>("F0", dimless, &file);
    if (!field.valid()) return initialStretch();

    // That of the case is for the regions that can have it
    if
    (
        file == regionFiles::sharedField("F0", mesh_)
     && !law.takesInitialStretch()
    )
    {
        return initialStretch();
    }
    if (options_.scheme != schemeType::variational)
    {
        FatalFileErrorInFunction(file)
            << "The field F0, an initial stretch, does not go with the scheme "
            << "of preset paper" << exit(FatalIOError);
    }
    if (!law.takesInitialStretch())
    {
        FatalFileErrorInFunction(file)
            << "The field F0, an initial stretch, does not go with type "
            << law.type() << " of region '" << name_
            << "': it is one of elastic laws." << nl
            << (
                   law.plastic()
                 ? "Give the initial state of a plastic one by the field CpInv"
                 : "Remove the field"
               )
            << exit(FatalIOError);
    }

    const label d = dual_.nDim();
    const FixedList<label, 3> dir(allDirections());

    tensorField local(dual_.nNodes());
    forAll(local, a)
    {
        const tensor& F0 = field->primitiveField()[dual_.nodePoint()[a]];
        const char* wrong = det(F0) > 0 ? nullptr : "its determinant must be "
            "positive";
        for (label i = 0; i < 3; ++i)
        {
            for (label j = 0; j < 3; ++j)
            {
                local[a][3*i + j] = F0[3*dir[i] + dir[j]];
                if (i != j && max(i, j) >= d && local[a][3*i + j] != 0)
                {
                    wrong = "directions that are left out must not be sheared";
                }
            }
        }
        if (d == 1 && local[a].yy() != local[a].zz())
        {
            wrong = "both directions that are left out must have the same "
                "stretch";
        }
        if (wrong)
        {
            FatalFileErrorInFunction(file)
                << "Keyword 'internalField': F0 is " << F0 << " at "
                << mesh_.points()[dual_.nodePoint()[a]] << ": " << wrong
                << exit(FatalIOError);
        }
    }
    return initialStretch(local, d);
}


void Foam::solidBody::readState()
{
    conservedState& s = data_.state;
    const label d = dual_.nDim();
    const label n = dual_.nNodes();
    const FixedList<label, 3>& dir = dual_.directions();
    const labelList& point = dual_.nodePoint();

    if (pointU_.dimensions() != dimVelocity)
    {
        FatalFileErrorInFunction(pointUFile_)
            << "Keyword 'dimensions' is " << pointU_.dimensions()
            << ": it must be " << dimVelocity << exit(FatalIOError);
    }
    for (const vector& v : pointU_.primitiveField())
    {
        if (!(std::isfinite(v.x() + v.y() + v.z())))
        {
            FatalFileErrorInFunction(pointUFile_)
                << "Keyword 'internalField': a value is not finite"
                << exit(FatalIOError);
        }
    }

    const auto lm =
        readIfPresent<vector>("lm", dimDensity*dimVelocity);
    const auto D = readIfPresent<vector>("pointD", dimLength);
    const auto F = readIfPresent<tensor>("F", dimless);

    for (label a = 0; a < n; ++a)
    {
        for (label i = 0; i < d; ++i)
        {
            s.lm[a*d + i] =
                lm.valid()
              ? lm().primitiveField()[point[a]][dir[i]]
              : data_.rho*pointU_.primitiveField()[point[a]][dir[i]];
            if (D.valid())
            {
                s.disp[a*d + i] = D().primitiveField()[point[a]][dir[i]];
            }
            if (F.valid())
            {
                for (label j = 0; j < d; ++j)
                {
                    s.F[(a*d + i)*d + j] =
                        F().primitiveField()[point[a]][3*dir[i] + dir[j]];
                }
            }
        }
    }

    if (data_.variational && !rigid_.valid())
    {
        // Also where this processor has no node of the body
        if (d > 1)
        {
            const auto rush =
                readIfPresent<vector>("acceleration", dimAcceleration);
            for (label a = 0; a < n && rush.valid(); ++a)
            {
                for (label i = 0; i < d; ++i)
                {
                    scheme_->acceleration()[a*d + i] =
                        rush().primitiveField()[point[a]][dir[i]];
                }
            }
        }
        nBad_ = scheme_->deform();
    }
    else if (rigid_.valid())
    {
        // fitRigid() makes it of where the nodes are
    }
    else if (F.valid())
    {
        const auto H =
            s.solvesH
          ? readIfPresent<tensor>("H", dimless)
          : autoPtr<pointTensorField>();
        const auto J =
            s.solvesJ
          ? readIfPresent<scalar>("J", dimless)
          : autoPtr<pointScalarField>();

        for (label a = 0; a < n; ++a)
        {
            const scalar* Fs = s.F.cdata();
            if (s.solvesH && d == 3)
            {
                const SolidTensor<3> G = cofactor(loadF<3>(Fs, a));
                for (label k = 0; k < 9; ++k)
                {
                    s.H[9*a + placeH(k)] =
                        H.valid() ? H().primitiveField()[point[a]][k]
                      : G.in[k];
                }
            }
            else if (s.solvesH)
            {
                const label out = 3 - dir[0] - dir[1];
                s.H[a] =
                    H.valid() ? H().primitiveField()[point[a]][4*out]
                  : determinant(loadF<2>(Fs, a));
            }
            if (s.solvesJ)
            {
                s.J[a] =
                    J.valid() ? J().primitiveField()[point[a]]
                  : d == 1 ? determinant(loadF<1>(Fs, a))
                  : d == 2 ? determinant(loadF<2>(Fs, a))
                  : determinant(loadF<3>(Fs, a));
            }
        }
    }
    else if (D.valid())
    {
        deformationFromDisplacement();
    }

    if (material_->plastic())
    {
        const auto C = readIfPresent<symmTensor>("CpInv", dimless);
        const auto strain = readIfPresent<scalar>("epsilonPEq", dimless);
        if (material_->initialTemperature() > 0)
        {
            // Also where this processor has no node of the body
            const auto T = readIfPresent<scalar>("pointT", dimTemperature);
            for (label a = 0; a < n && T.valid(); ++a)
            {
                s.temperature[a] = T().primitiveField()[point[a]];
                if (!(s.temperature[a] > 0))
                {
                    FatalFileErrorInFunction(T().objectPath())
                        << "Keyword 'internalField': a temperature is "
                        << s.temperature[a] << " K, it must be positive"
                        << exit(FatalIOError);
                }
            }
        }
        const label out = d == 2 ? 3 - dir[0] - dir[1] : (dir[0] + 1) % 3;
        for (label a = 0; a < n; ++a)
        {
            if (C.valid())
            {
                const tensor full(C().primitiveField()[point[a]]);
                scalar* p = s.Cpi.data() + a*s.strideCpi;
                for (label i = 0; i < d; ++i)
                {
                    for (label j = i; j < d; ++j)
                    {
                        *p++ = full[3*dir[i] + dir[j]];
                    }
                }
                if (d < 3) *p = full[4*out];
            }
            if (strain.valid())
            {
                s.epsilonPEq[a] = strain().primitiveField()[point[a]];
            }
        }
    }

    const scalar removed = returnReduce
    (
        symmetry_.project(s.lm.data(), d), maxOp<scalar>()
    );
    if (removed > 1e-10*data_.rho*data_.cp)
    {
        WarningInFunction
            << "Region " << name_ << ": an initial velocity of up to "
            << removed/data_.rho << " m/s normal to a symmetry plane was "
            << "removed" << endl;
    }
    if (data_.variational) checkStart();

    if (contact_.on())
    {
        const auto status = readIfPresent<scalar>("contactStatus", dimless);
        if (status.valid())
        {
            for (label a = 0; a < n; ++a)
            {
                contact_.status[a] = status().primitiveField()[point[a]];
            }
        }
    }
}


void Foam::solidBody::deformationFromDisplacement()
{
    if (data_.variational)
    {
        if (scheme_.valid()) scheme_->deform();
        return;
    }

    // The gradient of the displacement in place of the velocity
    conservedState& s = data_.state;
    const label d = dual_.nDim();
    data_.W = Zero;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        for (label i = 0; i < d; ++i)
        {
            data_.W[a*data_.strideW + i] = s.disp[a*d + i];
        }
    }
    computeGradients(true);

    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        const scalar* grad = data_.grad.cdata() + a*d*data_.strideG;
        for (label i = 0; i < d; ++i)
        {
            for (label j = 0; j < d; ++j)
            {
                s.F[(a*d + i)*d + j] += grad[j*data_.strideG + i];
            }
        }

        const scalar* F = s.F.cdata();
        if (d == 3)
        {
            const SolidTensor<3> H = cofactor(loadF<3>(F, a));
            for (label k = 0; k < s.strideH; ++k)
            {
                s.H[9*a + placeH(k)] = H.in[k];
            }
            if (s.solvesJ) s.J[a] = determinant(loadF<3>(F, a), H);
        }
        else if (d == 2)
        {
            if (s.solvesH) s.H[a] = determinant(loadF<2>(F, a));
            if (s.solvesJ) s.J[a] = determinant(loadF<2>(F, a));
        }
        else if (s.solvesJ)
        {
            s.J[a] = determinant(loadF<1>(F, a));
        }
    }
}


template<class Use>
void Foam::solidBody::visitFields(const Use& use) const
{
    const conservedState& s = data_.state;
    const label d = dual_.nDim();
    const FixedList<label, 3>& dir = dual_.directions();

    use
    (
        vector::zero,
        "lm", dimDensity*dimVelocity,
        [&](const label a) { return expand(s.lm.cdata() + a*d); }
    );
    if (scheme_.valid() && d > 1)
    {
        use
        (
            vector::zero,
            "acceleration", dimAcceleration,
            [&](const label a)
            {
                return expand(scheme_->acceleration().cdata() + a*d);
            }
        );
    }
    use
    (
        vector::zero,
        "pointD", dimLength,
        [&](const label a) { return expand(s.disp.cdata() + a*d); }
    );
    use
    (
        tensor::zero,
        "F", dimless,
        [&](const label a) { return deformationGradient(a); }
    );
    if (s.solvesH)
    {
        use
        (
            tensor::zero,
            "H", dimless,
            [&](const label a)
            {
                tensor H(Zero);
                if (d == 3)
                {
                    for (label k = 0; k < 9; ++k)
                    {
                        H[k] = s.H[9*a + placeH(k)];
                    }
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
            scalar(0),
            "J", dimless, [&](const label a) { return s.J[a]; }
        );
    }
    else if (data_.variational && data_.finiteStrain)
    {
        use
        (
            scalar(0),
            "J", dimless,
            [&](const label a) { return det(deformationGradient(a)); }
        );
    }

    if (material_->initial().on())
    {
        use
        (
            tensor::zero,
            "F0", dimless,
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
            symmTensor::zero,
            "CpInv", dimless,
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
            scalar(0),
            "epsilonPEq", dimless,
            [&](const label a) { return s.epsilonPEq[a]; }
        );
        if (material_->initialTemperature() > 0)
        {
            use
            (
                scalar(0),
                "pointT", dimTemperature,
                [&](const label a) { return s.temperature[a]; }
            );
        }
    }

    use
    (
        symmTensor::zero,
        "sigma", dimPressure,
        [&](const label a) { return CauchyStress(a); }
    );
    use
    (
        scalar(0),
        "sigmaEq", dimPressure,
        [&](const label a)
        {
            return std::sqrt(1.5*magSqr(dev(CauchyStress(a))));
        }
    );
    use
    (
        scalar(0),
        "pressure", dimPressure,
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
            scalar(0),
            "contactStatus", dimless,
            [&](const label a) { return contact_.status[a]; }
        );
        use
        (
            vector::zero,
            "contactTraction", dimPressure,
            [&](const label a)
            {
                return area[a] > 0 ? force[a]/area[a] : vector(Zero);
            }
        );
        use
        (
            scalar(0),
            "contactGap", dimLength,
            [&](const label a) { return gap[a] < 0.1*GREAT ? gap[a] : 0; }
        );
        if (contact_.slide.on())
        {
            use
            (
                vector::zero,
                "contactSlide", dimLength,
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
