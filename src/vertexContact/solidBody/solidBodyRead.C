/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What a region begins with: its material, and the fields of the start.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "regionFiles.H"
#include "rigidMaterial.H"
#include "dictionaryCheck.H"
#include "fileError.H"
#include "Time.H"
#include "pointFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Velocity that mirrors take at the start without a warning, by that of waves:
//  round-off
constexpr Foam::scalar largestRemoved = 1e-10;

//- Of F0 and CpInv with six digits: components, and by how much the determinant
//  is not one
constexpr Foam::scalar roundedStretch = 1e-6;
constexpr Foam::scalar roundedDeterminant = 1e-5;

} // End anonymous namespace


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
            << "': it is one of laws that deform." << nl
            << "Remove the field" << exit(FatalIOError);
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
                << meshPoint(a) << ": " << wrong
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

        const label out = d == 2 ? 3 - dir[0] - dir[1] : 0;
        for (label a = 0; a < n; ++a)
        {
            findKinematics(a);
            if (H.valid())
            {
                const tensor& given = H().primitiveField()[point[a]];
                if (d == 2) s.H[a] = given[4*out];
                for (label k = 0; d == 3 && k < 9; ++k)
                {
                    s.H[9*a + placeH(k)] = given[k];
                }
            }
            if (J.valid()) s.J[a] = J().primitiveField()[point[a]];
        }
    }
    else if (D.valid())
    {
        deformationFromDisplacement();
    }

    // What a run has written, and what displacements have strained, is at its
    // yield stress, or beyond it by what the first step flows
    if (material_->plastic()) readPlasticState(!F.valid() && !D.valid());

    const scalar removed = returnReduce
    (
        symmetry_.project(s.lm.data(), d), maxOp<scalar>()
    );
    if (removed > largestRemoved*data_.rho*data_.cp)
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


void Foam::solidBody::readPlasticState(const bool undeformed)
{
    conservedState& s = data_.state;
    const label d = dual_.nDim();
    const label n = dual_.nNodes();
    const FixedList<label, 3>& dir = dual_.directions();
    const labelList& point = dual_.nodePoint();

    // Also where this processor has no node of the body
    fileName CFile;
    const auto C = readIfPresent<symmTensor>("CpInv", dimless, &CFile);
    const auto strain = readIfPresent<scalar>("epsilonPEq", dimless);
    if (material_->initialTemperature() > 0)
    {
        fileName file;
        const auto T = readIfPresent<scalar>("pointT", dimTemperature, &file);
        for (label a = 0; a < n && T.valid(); ++a)
        {
            s.temperature[a] = T().primitiveField()[point[a]];
            if (!(s.temperature[a] > 0))
            {
                FatalFileErrorInFunction(file)
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
            const symmTensor& given = C().primitiveField()[point[a]];
            if
            (
                !(mag(det(given) - 1) <= roundedDeterminant)
             || !(given.xx() > 0)
             || !(given.xx()*given.yy() > sqr(given.xy()))
            )
            {
                FatalFileErrorInFunction(CFile)
                    << "Keyword 'internalField': CpInv is " << given << " at "
                    << mesh_.points()[point[a]] << ", with the determinant "
                    << det(given) << ": it must be positive definite, with the "
                    << "determinant 1." << nl
                    << "Give changes of the volume by the field F0"
                    << exit(FatalIOError);
            }
            const tensor full(given);
            scalar* p = s.Cpi.data() + a*s.strideCpi;
            for (label i = 0; i < d; ++i)
            {
                for (label j = i; j < d; ++j) *p++ = full[3*dir[i] + dir[j]];
            }
            if (d < 3) *p = full[4*out];
        }
        if (strain.valid())
        {
            s.epsilonPEq[a] = strain().primitiveField()[point[a]];
        }
    }

    // The file, also where this processor has no node of the body
    fileName file(CFile);
    const bool stretched = material_->initial().on();
    if (stretched) readIfPresent<tensor>("F0", dimless, &file);
    for (label a = 0; a < n && undeformed && (stretched || C.valid()); ++a)
    {
        const Pair<scalar> stress(material_->yieldState(s, a));
        if
        (
            stress.first() - stress.second()
         <= roundedStretch*3*material_->mu()
        )
        {
            continue;
        }
        FatalFileErrorInFunction(file)
            << "Keyword 'internalField': the stress at the start is beyond the "
            << "yield stress: that of von Mises (Kirchhoff) is "
            << stress.first() << " Pa at " << mesh_.points()[point[a]]
            << ", at most " << stress.second() << " Pa are valid." << nl
            << "Give less of " << (stretched ? "the stretch F0" : "CpInv - I")
            << ", or earlier flow by the field epsilonPEq"
            << exit(FatalIOError);
    }
}


void Foam::solidBody::deformationFromDisplacement()
{
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
        findKinematics(a);
    }
}


void Foam::solidBody::findKinematics(const label node)
{
    conservedState& s = data_.state;
    withDirections(s.nDim, [&](auto D)
    {
        const SolidTensor<D.value> F = loadF<D.value>(s.F.cdata(), node);
        const SolidTensor<D.value> H = cofactor(F);
        const scalar J = determinant(F, H);
        for (label k = 0; D.value == 3 && k < s.strideH; ++k)
        {
            s.H[9*node + placeH(k)] = H.in[k];
        }
        if (D.value == 2 && s.solvesH) s.H[node] = J;
        if (s.solvesJ) s.J[node] = J;
    });
}


// ************************************************************************* //
