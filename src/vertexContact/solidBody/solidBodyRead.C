/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What a region starts from: its material and its start fields.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "regionFiles.H"
#include "writtenTimes.H"
#include "rigidMaterial.H"
#include "dictionaryCheck.H"
#include "fileError.H"
#include "Time.H"
#include "pointFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Velocity over the wave speed, and displacement over the size of the mesh,
//  that may be removed at the start without a warning: round-off
constexpr Foam::scalar largestRemoved = 1e-10;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::autoPtr<Foam::Field<Type>> Foam::solidBody::readIfPresent
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
        if (file.empty()) return autoPtr<Field<Type>>();

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
    return autoPtr<Field<Type>>
    (
        new Field<Type>(field->primitiveField(), dual_.nodePoint())
    );
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

    // The case's field is only for the regions whose law can take it
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
            << "The field F0, an initial stretch, does not work with preset "
            << "paper" << exit(FatalIOError);
    }
    if (!law.takesInitialStretch())
    {
        FatalFileErrorInFunction(file)
            << "The field F0, an initial stretch, does not work with type "
            << law.type() << " of region '" << name_
            << "': the body must deform." << nl
            << "Remove the field" << exit(FatalIOError);
    }

    const label d = dual_.nDim();
    const FixedList<label, 3> dir(allDirections());

    tensorField local(dual_.nNodes());
    forAll(local, a)
    {
        const tensor& F0 = field()[a];
        const char* wrong = det(F0) > 0 ? nullptr : "its determinant must be "
            "positive";
        for (label i = 0; i < 3; ++i)
        {
            for (label j = 0; j < 3; ++j)
            {
                local[a][3*i + j] = F0[3*dir[i] + dir[j]];
                if (i != j && max(i, j) >= d && local[a][3*i + j] != 0)
                {
                    wrong = "directions that the mesh leaves out must not be "
                        "sheared";
                }
            }
        }
        if (d == 1 && local[a].yy() != local[a].zz())
        {
            wrong = "both directions that the mesh leaves out must have the "
                "same stretch";
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
    const FixedList<label, 3>& dir = dual_.directions();

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

    regionFiles::checkFields(mesh_, *material_);
    const auto lm =
        readIfPresent<vector>("lm", dimDensity*dimVelocity);
    const auto D = readIfPresent<vector>("pointD", dimLength);
    const auto F = readIfPresent<tensor>("F", dimless);
    IOobject record(writtenTimes::record(time_));
    if (!D.valid() && dictionaryCheck::isThere<IOdictionary>(record))
    {
        FatalFileErrorInFunction(pointUFile_.path()/"pointD")
            << "Region " << name_ << ": there is no pointD, although a run "
            << "wrote this time (uniform/solidSystem). Start from a time that "
            << "has pointD"
            << exit(FatalIOError);
    }
    const auto warnLost = [&]
    (
        const vectorField& given,
        const scalar scale,
        const char* what,
        const char* unit
    )
    {
        scalar lost = 0;
        for (const vector& v : given)
        {
            lost = max(lost, mag(v - dual_.projected(v)));
        }
        reduce(lost, maxOp<scalar>());
        if (lost > largestRemoved*scale)
        {
            WarningInFunction
                << "Region " << name_ << ": an initial " << what << " of up to "
                << lost << ' ' << unit
                << " in directions that the mesh does not solve was removed"
                << endl;
        }
    };
    warnLost(pointU_.primitiveField(), data_.cp, "velocity", "m/s");
    if (D.valid()) warnLost(D(), mesh_.bounds().mag(), "displacement", "m");

    const vectorField U(pointU_.primitiveField(), dual_.nodePoint());
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        for (label i = 0; i < d; ++i)
        {
            s.lm[a*d + i] =
                lm.valid() ? lm()[a][dir[i]] : data_.rho*U[a][dir[i]];
            if (D.valid()) s.disp[a*d + i] = D()[a][dir[i]];
            if (F.valid())
            {
                for (label j = 0; j < d; ++j)
                {
                    s.F[(a*d + i)*d + j] = F()[a][3*dir[i] + dir[j]];
                }
            }
        }
    }

    readKinematics(F.valid(), D.valid());

    vector edge(Zero);
    const label kinked = symmetry_.kinked(edge);
    if (kinked >= 0)
    {
        FatalFileErrorInFunction(pointUFile_)
            << "Keyword 'boundaryField': patch '"
            << mesh_.boundaryMesh()[kinked].name() << "' of the region '"
            << name_ << "' has the type '"
            << pointU_.boundaryField()[kinked].type()
            << "', which needs one normal at each node, but it has an edge at "
            << edge << ". Make a separate patch of each side of the edge"
            << exit(FatalIOError);
    }
    const auto given = s.lm;
    const scalar removed = returnReduce
    (
        symmetry_.project(s.lm.data(), d), maxOp<scalar>()
    );
    const bool roundOff = removed <= largestRemoved*data_.rho*data_.cp;
    // A run continues with its own round-off, to the last bit
    if (lm.valid() && roundOff) s.lm = given;
    if (!roundOff)
    {
        WarningInFunction
            << "Region " << name_ << ": an initial velocity of up to "
            << removed/data_.rho << " m/s normal to a symmetry plane was "
            << "removed" << endl;
    }
    if (contact_.on())
    {
        const auto status = readIfPresent<scalar>("contactStatus", dimless);
        if (status.valid()) contact_.status = status();
    }
}


namespace Foam
{

#define makeReadIfPresent(Type)                                               \
    template autoPtr<Field<Type>> solidBody::readIfPresent                    \
    (                                                                         \
        const word&, const dimensionSet&, fileName*                           \
    ) const;

makeReadIfPresent(scalar)
makeReadIfPresent(vector)
makeReadIfPresent(tensor)
makeReadIfPresent(symmTensor)

} // End namespace Foam


// ************************************************************************* //
