/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What a body writes and reports.

\*---------------------------------------------------------------------------*/

#include "solidBody.H"
#include "writtenTimes.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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

    bodyFields(*this).write();
}


Foam::nodalField Foam::solidBody::field(const word& name) const
{
    placeAll();
    return bodyFields(*this).field(name);
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
