/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "paperObstacleInterface.H"
#include "paperContact.H"
#include "contactOverlap.H"
#include "solidBody.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::paperObstacleInterface::findForces()
{
    const cornerStates& M = side_.body->corners(side_.patchi);
    const scalarField& depth = side_.body->surface(side_.patchi).depth;

    forAll(planes_, i)
    {
        const label k = planes_[i].corner;
        contactLaw::problem& p = problems_[i];

        p.minus = M.sideOf(M.v[k], M.t[k], M.waveFactor[k], M.stretch[k]);
        p.area = M.geometry.cornerArea[k]*M.stretch[k];
        setObstacle(i, p);

        // As against a mirror image, which has half of the gap
        p.touching =
            law().bonded()
         || paperContact::touches
            (
                p, contactOverlaps::face(M.n[k], p.n), closed_[i], closingGap,
                0.5*depth[k]
            );
        checkPassed(closed_[i], side_, k, p.gap, depth[k], depth[k]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::paperObstacleInterface::solve()
{
    if (planes_.empty()) return;

    cornerStates& M = side_.body->corners(side_.patchi);
    const scalarField& depth = side_.body->surface(side_.patchi).depth;
    solveProblems();

    forAll(planes_, i)
    {
        const label k = planes_[i].corner;
        const contactLaw::problem& p = problems_[i];
        count(p, width_[k], depth[k], p.area, p.area);
        statistics_.frictionPower += p.area*paperContact::slipPower(p);
        const contactAnswer told(answer(p, p.area));
        setState(side_, k, told);
        if (p.result.state != acousticRiemann::status::open)
        {
            paperContact::addFlux
            (
                M, k, told.force,
                M.geometry.cornerArea[k]*paperContact::velocityChange(p)
            );
        }
    }
}


// ************************************************************************* //
