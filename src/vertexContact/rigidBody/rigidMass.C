/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidMass.H"
#include "freeRotation.H"
#include "dictionaryCheck.H"
#include "dimensionSets.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Share of the largest principal moment by which it may exceed the sum of the
//  others. For a lamina it is the sum, written with six digits
constexpr scalar lamina = 1e-6;

//- Integrals over the cells of a mesh
struct moments
{
    scalar volume = 0;
    vector first = vector::zero;
    symmTensor second = symmTensor::zero;

    //- Add the tetrahedron of a, b, c and the origin: means of x and x x over
    //  it. Directions that are not solved have no squares: those of a thick
    //  mesh would hide the others
    void add
    (
        const medianDual& dual,
        const vector& a,
        const vector& b,
        const vector& c
    )
    {
        const auto square = [&](const vector& v)
        {
            return sqr(dual.projected(v));
        };
        const scalar V = ((a ^ b) & c)/6;
        const vector sum(a + b + c);
        volume += V;
        first += V/4*sum;
        second += V/20*(square(a) + square(b) + square(c) + square(sum));
    }
};

//- Integrals over all processors about a point. Collective
moments integrals(const medianDual& dual, const point& origin)
{
    const polyMesh& mesh = dual.mesh();
    moments m;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<processorPolyPatch>(pp)) continue;
        for (const face& f : pp)
        {
            vector middle(Zero);
            for (const label p : f) middle += mesh.points()[p] - origin;
            middle /= f.size();
            forAll(f, i)
            {
                m.add
                (
                    dual,
                    middle,
                    mesh.points()[f[i]] - origin,
                    mesh.points()[f.nextLabel(i)] - origin
                );
            }
        }
    }
    reduce(m.volume, sumOp<scalar>());
    reduce(m.first, sumOp<vector>());
    reduce(m.second, sumOp<symmTensor>());
    return m;
}

//- Inertia from the integrals of squares
symmTensor inertiaOf(const symmTensor& second)
{
    return tr(second)*symmTensor(symmTensor::I) - second;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidMass::rigidMass(const dictionary& dict, const medianDual& dual)
{
    using namespace dictionaryCheck;

    const polyMesh& mesh = dual.mesh();
    const label d = dual.nDim();
    const scalar volume =
        returnReduce(sum(dual.ownedVolume()), sumOp<scalar>());

    // About the middle of the mesh: the origin may be far away
    moments m(integrals(dual, mesh.bounds().midpoint()));
    const point middle(mesh.bounds().midpoint() + m.first/m.volume);
    m = integrals(dual, middle);
    centre = dual.projected(middle);

    if (dict.found("rho") == dict.found("mass"))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'mass': a rigid region needs exactly one of (mass "
            << "rho), but " << (dict.found("rho") ? "both are" : "none is")
            << " given"
            << exit(FatalIOError);
    }
    if (dict.found("mass"))
    {
        mass = readNumber(dict, "mass", dimMass);
        require(mass > 0, dict, "mass", mass, "positive");
        density = mass/volume;
    }
    else
    {
        density = readNumber(dict, "rho", dimDensity);
        require(density > 0, dict, "rho", density, "positive");
        mass = density*volume;
    }

    inertia = mass/m.volume*inertiaOf(m.second);
    if (dict.found("centreOfMass"))
    {
        centre = dual.projected(dict.get<point>("centreOfMass"));
    }
    if (dict.found("inertia"))
    {
        inertia = dict.get<symmTensor>("inertia");
        const vector moments
        (
            d == 3
          ? freeRotation(inertia).moments()
          : vector(0, 0, 0)
        );
        if
        (
            d == 3
         && !(
                moments.x() > 0
             && moments.x() + moments.y() > moments.z()*(1 - lamina)
            )
        )
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'inertia' is " << inertia
                << ": its principal moments " << moments
                << " have to be positive, and none larger than the sum of the "
                << "others" << exit(FatalIOError);
        }
    }
    else if (dict.found("centreOfMass"))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'centreOfMass' needs 'inertia' about this point"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensor Foam::rigidMass::about(const point& p) const
{
    return inertia + mass*inertiaOf(sqr(centre - p));
}


// ************************************************************************* //
