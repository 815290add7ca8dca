/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "variationalBody.H"
#include "paperBody.H"
#include "rigidRegion.H"
#include "rigidMaterial.H"
#include "regionFiles.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::solidBody> Foam::solidBody::New
(
    const Time& runTime,
    const word& region,
    const schemeOptions& defaults
)
{
    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            IOobject(region, runTime.timeName(), runTime, IOobject::MUST_READ)
        )
    );
    const schemeOptions options(regionFiles::schemes(*mesh), defaults);

    autoPtr<solidBody> body;
    if (rigidMaterial::describedBy(regionFiles::material(*mesh)))
    {
        body.reset(new rigidRegion(mesh, options));
    }
    else if (options.scheme == schemeType::variational)
    {
        body.reset(new variationalBody(mesh, options));
    }
    else
    {
        body.reset(new paperBody(mesh, options));
    }
    return body;
}


// ************************************************************************* //
