/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkInterfaces.H"
#include "obstacleInterface.H"
#include "contactSurface.H"
#include "solidBody.H"
#include "HashSet.H"

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

void Foam::checkInterface
(
    const obstacleInterface& contact,
    const contactLimits& limits,
    contactReport& report,
    contactLines& lines
)
{
    typedef contactReport table;

    const contactSide side(contact.sides()[0]);
    const cornerStates& corners = side.body->corners(side.patchi);
    const dualPatch& patch = corners.geometry;
    const scalarField& depth = side.body->surface(side.patchi).depth;
    const label n = patch.nCorners();

    const labelHashSet near(contact.nearCorners());

    const septernion& pose = contact.motion().pose();
    pointField X;
    List<pointIndexHit> hits;
    vectorField normals;
    contact.findNearest(X, hits, normals);

    label nHit = 0, nNear = 0, nFacing = 0, nTurned = 0, nBehind = 0;
    scalar leastGap = GREAT, greatestGap = -GREAT, gapArea = 0, area = 0;
    scalar penetration = 0;

    lines.setNames({"area", "gap", "near", "facing", "rank"});

    forAll(X, k)
    {
        if (!hits[k].hit())
        {
            continue;
        }
        ++nHit;
        const point x(pose.transformPoint(X[k]));
        const point nearest(pose.transformPoint(hits[k].hitPoint()));
        const vector normal(pose.r().transform(normals[k]));
        const scalar gap = (x - nearest) & normal;
        const scalar a = patch.cornerArea[k]*corners.stretch[k];

        const bool isNear = near.found(k);

        // The normals oppose each other
        const scalar opposed = -(corners.n[k] & normal);
        const bool faces = opposed > contactOverlaps::leastFacing;

        leastGap = min(leastGap, gap);
        greatestGap = max(greatestGap, gap);
        gapArea += gap*a;
        area += a;
        nBehind += (gap < -depth[k]);
        if (isNear)
        {
            ++nNear;
            nFacing += faces;
            nTurned += (opposed < -contactOverlaps::leastFacing);
            if (faces && gap < 0)
            {
                penetration = max(penetration, -gap/contact.width()[k]);
            }
        }
        lines.append
        (
            x, nearest,
            {
                a, gap, scalar(isNear), scalar(faces),
                scalar(Pstream::myProcNo())
            }
        );
    }

    const label nCorners = returnReduce(n, sumOp<label>());
    for (label* count : {&nHit, &nNear, &nFacing, &nTurned, &nBehind})
    {
        reduce(*count, sumOp<label>());
    }
    reduce(leastGap, minOp<scalar>());
    reduce(greatestGap, maxOp<scalar>());
    reduce(gapArea, sumOp<scalar>());
    reduce(area, sumOp<scalar>());
    reduce(penetration, maxOp<scalar>());

    // The table
    const auto row = [&](const char* name, const auto& value)
    {
        report.row(name, {table::text(value)});
    };
    report.head(1);
    row("Faces", returnReduce(patch.nFaces(), sumOp<label>()));
    row("Corners", nCorners);
    row("Corners close to the obstacle", nNear);
    row("  that face it", nFacing);
    row("Corners behind it by a cell or more", nBehind);
    if (nHit)
    {
        row("Least gap [m]", leastGap);
        row("Mean gap [m]", gapArea/area);
        row("Greatest gap [m]", greatestGap);
        row("Penetration / face width", penetration);
    }

    // The checks
    report.check
    (
        nHit == nCorners,
        table::text(nCorners - nHit)
      + " corners have no nearest point on the obstacle"
    );
    report.check
    (
        2*nBehind <= nHit && (nFacing > 0 || nTurned == 0),
        "The normals of the obstacle point away from " + report.side(0)
      + ": they must point towards the body"
    );
    report.check
    (
        contact.law().bonded() || penetration <= limits.maxPenetration,
        "The obstacle is penetrated by " + table::text(penetration)
      + " face widths, more than " + table::text(limits.maxPenetration)
    );
}


// ************************************************************************* //
