/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Slow loading of a solidSystem: scaled masses, damping, and relaxation.

\*---------------------------------------------------------------------------*/

#include "solidSystem.H"
#include "regionSettings.H"
#include "variationalBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidSystem::readSlowLoading(const dictionary& record)
{
    const dictionary& control = runTime_.controlDict();
    massScaling_.reset(new massScaling(control, record, bodies_));

    const List<const dictionary*> settings
    (
        regionSettings::read
        (
            control, "damping", bodies_, massDamping::keywords()
        )
    );
    damped_ = settings.size();
    const bool relaxes = control.found("relaxation");
    if ((damped_ || relaxes) && !integrator_.leapfrog())
    {
        FatalIOErrorInFunction(control)
            << "Keyword '" << (damped_ ? "damping" : "relaxation")
            << "' does not work with preset " << preset::names[preset_.name]
            << " (timeIntegrator "
            << timeIntegrator::names[integrator_.type()]
            << "). Valid integrators for it: (leapfrog)"
            << exit(FatalIOError);
    }
    forAll(settings, i)
    {
        // Bodies with settings deform, and use the leapfrog: see above
        if (!settings[i]) continue;
        dynamic_cast<variationalBody&>(bodies_[i]).setDamping(*settings[i]);
    }

    if (!relaxes) return;
    if (subCycling_.active())
    {
        FatalIOErrorInFunction(control)
            << "Keyword 'relaxation' does not work with subCycling, because "
            << "stopped bodies begin again with a common step. 'subCycling' "
            << "must be no" << exit(FatalIOError);
    }
    relaxation_.reset(new kineticRelaxation(control));
    relaxation_->read(record.subOrEmptyDict("relaxation"));
}


void Foam::solidSystem::relax(const scalar time)
{
    scalar kinetic = 0;
    for (const leapfrogBody& body : leaping_)
    {
        kinetic += body.freeKineticEnergy();
    }
    reduce(kinetic, sumOp<scalar>());
    if (!relaxation_->atPeak(time, kinetic)) return;

    // Accounts belong to the momenta, energies to this time, half a step later
    // (bodyEnergies). So balance both before and after the stop
    const auto book = [&](const scalar sign)
    {
        if (accounts_.on()) accounts_.addStop(sign);
    };
    book(1);
    for (leapfrogBody& body : leaping_) body.stop();
    evaluateForces(time, false);

    leapfrogBody::forceBalance all;
    scalar held = 0;
    for (leapfrogBody& body : leaping_)
    {
        const leapfrogBody::forceBalance its(body.balance());
        all.unbalanced += its.unbalanced;
        all.loads += its.loads;
        held += body.heldKineticEnergy();
    }
    relaxation_->setBalance(all, returnReduce(held, sumOp<scalar>()));

    for (leapfrogBody& body : leaping_) body.startFromRest();
    book(-1);
}


// ************************************************************************* //
