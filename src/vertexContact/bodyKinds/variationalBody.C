/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "variationalBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::variationalBody::PoissonsRatio(const materialModel& material)
{
    const scalar mu = material.mu(), kappa = material.kappa();
    return (3*kappa - 2*mu)/(2*(3*kappa + mu));
}


Foam::kinematicSet Foam::variationalBody::kinematicsOf
(
    const schemeOptions& options,
    const materialModel& material
)
{
    // The ratio comes from the moduli, with round-off of either sign
    return
        options.volume == volumeTreatment::smoothed
     || (
            options.volume == volumeTreatment::automatic
         && PoissonsRatio(material) > smoothedFrom - ROOTSMALL
        )
      ? kinematicSet::FJ
      : kinematicSet::F;
}


void Foam::variationalBody::readDeformation(const bool, const bool)
{
    // Also where this processor has no node of the body
    const label d = dual_.nDim();
    if (d > 1)
    {
        const auto rush =
            readIfPresent<vector>("acceleration", dimAcceleration);
        for (label a = 0; a < dual_.nNodes() && rush.valid(); ++a)
        {
            for (label i = 0; i < d; ++i)
            {
                scheme_->acceleration()[a*d + i] =
                    rush()[a][dual_.directions()[i]];
            }
        }
    }
    nBad_ = scheme_->deform();
}


void Foam::variationalBody::reportScheme(Ostream& os) const
{
    const label d = dual_.nDim();
    os  << ", variational scheme, correction " << options_.correction
        << nl
        << "    volume " << schemeOptions::volumeNames[options_.volume]
        << ": Poisson's ratio " << PoissonsRatio(*material_)
        << ", Jacobian " << (data_.state.solvesJ ? "smoothed" : "of each node")
        << " (smoothed from " << smoothedFrom << " on)" << nl
        << "    stored per node: momentum " << d << ", displacement " << d
        << ", F " << d*d << ", stress " << d*d + data_.nSJ
        << " components" << nl
        << "    largest frequency " << scheme_->largestFrequency()
        << " 1/s (undeformed), dissipation " << options_.dissipation
        << " to " << options_.frontDissipation;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::variationalBody::variationalBody
(
    autoPtr<polyMesh>& mesh,
    const schemeOptions& options
)
:
    solidBody(mesh, options, kinematicsOf),
    scheme_
    (
        new variationalScheme
        (
            data_, *material_, symmetry_, options_, mirrorPatches_
        )
    )
{
    // The scheme has its own copy, in blocks
    dual_.forgetEdgeArea();
    data_.mirrorArea.clear();
    externalForce_.setSize(dual_.nNodes()*dual_.nDim(), Zero);
    work_.setSize(dual_.nNodes()*dual_.nDim(), Zero);
    findSurfaceNodes();
    if (contact_.on()) findCompliances();
    readState();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::variationalBody::restoreOld()
{
    if (reactions_.valid()) reactions_->restore();
    data_.state.lm = block_.valid() ? block_->lm : data_.old.lm;
    data_.state.disp = block_.valid() ? block_->disp : data_.old.disp;
    if (block_.valid()) scheme_->acceleration() = block_->acceleration;
    else scheme_->restoreAcceleration();
    lastStep_ = block_.valid() ? block_->lastStep : oldStep_;
    if (block_.valid()) block_->inside = false;
    scheme_->forget();
    data_.state.sinceCommit = 0;
    restorePlasticity();
}


Foam::label Foam::variationalBody::findNodeWithin(const scalar timeScale) const
{
    const label node = deformableBody::findNodeWithin(timeScale);
    const bool closes =
        data_.finiteStrain && scheme_->closingTime() <= timeScale;
    return node < 0 && closes ? scheme_->closingNode() : node;
}


Foam::scalar Foam::variationalBody::swing() const
{
    if (!evaluated_) return 0;
    scalar sum = 0;
    withDirections(dual_.nDim(), [&](auto D)
    {
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            const scalar* rate = data_.rates.cdata() + a*data_.strideRates;
            scalar power = 0;
            for (int i = 0; i < D.value; ++i)
            {
                power += rate[i]*(velocity(a, i) - middleVelocity(a, i));
            }
            sum += ownedVolume_[a]*power;
        }
    });
    return 0.25*lastStep_*sum;
}


Foam::scalar Foam::variationalBody::strainEnergy() const
{
    const scalar strained = deformableBody::strainEnergy();
    const conservedState& s = data_.state;
    if (s.hourglassShare.empty()) return strained + scheme_->jumpEnergy();

    // The shares have changed since, where the material has flowed
    scalar jumps = 0;
    forAll(s.hourglassShare, a)
    {
        jumps += ownedVolume_[a]*s.hourglassShare[a]*s.flow.jumpEnergy[a];
    }
    return strained + jumps;
}


std::size_t Foam::variationalBody::bytes() const
{
    return
        deformableBody::bytes() + scheme_->bytes()
      + sizeof(scalar)*std::size_t(externalForce_.size() + work_.size());
}


// ************************************************************************* //
