/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "deformableBody.H"
#include "elasticStrain.H"
#include "fileError.H"
#include "regionFiles.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Errors of F0 and CpInv with six digits: of components, and of the
//  determinant from one
constexpr Foam::scalar roundedStretch = 1e-6;
constexpr Foam::scalar roundedDeterminant = 1e-5;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::deformableBody::deformableBody()
:
    bodyForces_
    (
        bodyForce::readAll
        (
            regionFiles::bodyForces(mesh_), dual_, *material_
        )
    ),
    acceleration_
    (
        bodyForces_.size() ? dual_.nNodes()*dual_.nDim() : label(0), Zero
    ),
    stretchedWaves_
    (
        (options_.stretchedWaves || data_.variational)
     && material_->stretchesWaves()
    )
{
    if (symmetry_.active())
    {
        data_.mirrorArea = dual_.edgeArea();
        symmetry_.projectEdges(dual_, data_.mirrorArea);
    }
    if (material_->plastic())
    {
        data_.state.makePlastic();
        if (data_.variational) data_.state.keepFlow();
        const scalar T0 = material_->initialTemperature();
        if (T0 > 0) data_.state.makeHeated(T0);
    }
    if (stretchedWaves_)
    {
        data_.waveFactor.setSize(dual_.nNodes(), scalar(1));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::deformableBody::readKinematics
(
    const bool hasF,
    const bool hasDisplacement
)
{
    readDeformation(hasF, hasDisplacement);

    // A state that a run wrote, or that displacements have strained, is at its
    // yield stress, or beyond it by the flow of the first step
    if (material_->plastic()) readPlasticState(!hasF && !hasDisplacement);
}


bool Foam::deformableBody::isOwn(const word& name, const fileName& file) const
{
    return file != regionFiles::sharedField(name, mesh_);
}


Foam::symmTensor Foam::deformableBody::plasticPart
(
    const symmTensor& strain,
    const label node,
    const fileName& file
) const
{
    const label d = dual_.nDim();
    const FixedList<label, 3> dir(allDirections());
    const tensor full(strain);
    scalar other = d == 1 ? mag(full[4*dir[1]] - full[4*dir[2]]) : 0;
    for (label i = 0; i < 3; ++i)
    {
        for (label j = max(i + 1, d); j < 3; ++j)
        {
            other = max(other, mag(full[3*dir[i] + dir[j]]));
        }
    }
    if (other > roundedStretch)
    {
        FatalFileErrorInFunction(file)
            << "Keyword 'internalField': elasticStrain is " << strain << " at "
            << meshPoint(node) << ": directions that the mesh leaves out must "
            << "not be sheared, and in 1D both must have the same stretch"
            << exit(FatalIOError);
    }
    tensor F(deformationGradient(node));
    if (material_->initial().on())
    {
        F = F & inSpace(material_->initial().value(node));
    }
    return elasticStrain::plasticPart(F, strain);
}


void Foam::deformableBody::setElasticVolume(const symmTensorField& strain)
{
    const initialStretch& initial = material_->initial();
    tensorField F0(dual_.nNodes());
    scalar change = 0;
    forAll(F0, a)
    {
        const tensor given(initial.on() ? initial.value(a) : tensor::I);
        const scalar J = det(deformationGradient(a))*det(given);
        const scalar ratio = std::exp(tr(strain[a]))/J;
        F0[a] = std::cbrt(ratio)*given;
        change = max(change, mag(ratio - 1));
    }
    if (returnReduce(change, maxOp<scalar>()) > roundedStretch)
    {
        material_->setInitialStretch(initialStretch(F0, dual_.nDim()));
    }
}


void Foam::deformableBody::readPlasticState(const bool undeformed)
{
    conservedState& s = data_.state;
    const label d = dual_.nDim();
    const label n = dual_.nNodes();
    const FixedList<label, 3>& dir = dual_.directions();

    // Also where this processor has no node of the body
    fileName CFile;
    auto C = readIfPresent<symmTensor>("CpInv", dimless, &CFile);
    fileName elasticFile;
    auto elastic =
        readIfPresent<symmTensor>("elasticStrain", dimless, &elasticFile);

    // The region's own file has precedence over the case's
    const bool both = C.valid() && elastic.valid();
    const bool CIsOwn = isOwn("CpInv", CFile);
    const bool elasticIsOwn = isOwn("elasticStrain", elasticFile);
    if (both && CIsOwn && !elasticIsOwn) elastic.clear();
    if (both && elasticIsOwn && !CIsOwn) C.clear();
    if (C.valid() && elastic.valid())
    {
        FatalFileErrorInFunction(elasticFile)
            << "Field 'elasticStrain': the field CpInv is there, too, but each "
            << "of them determines the other. Give only one of them"
            << exit(FatalIOError);
    }
    if (elastic.valid() && data_.variational)
    {
        setElasticVolume(elastic());
    }
    const auto strain = readIfPresent<scalar>("epsilonPEq", dimless);
    if (material_->initialTemperature() > 0)
    {
        fileName file;
        const auto T = readIfPresent<scalar>("pointT", dimTemperature, &file);
        for (label a = 0; a < n && T.valid(); ++a)
        {
            s.temperature[a] = T()[a];
            if (!(s.temperature[a] > 0))
            {
                FatalFileErrorInFunction(file)
                    << "Keyword 'internalField': a temperature is "
                    << s.temperature[a] << " K: it must be positive"
                    << exit(FatalIOError);
            }
        }
    }

    const label out = d == 2 ? 3 - dir[0] - dir[1] : (dir[0] + 1) % 3;
    const auto store = [&](const label a, const symmTensor& CpInv)
    {
        const tensor full(CpInv);
        scalar* p = s.Cpi.data() + a*s.strideCpi;
        for (label i = 0; i < d; ++i)
        {
            for (label j = i; j < d; ++j) *p++ = full[3*dir[i] + dir[j]];
        }
        if (d < 3) *p = full[4*out];
    };
    for (label a = 0; a < n; ++a)
    {
        if (C.valid())
        {
            const symmTensor& given = C()[a];
            if
            (
                !(mag(det(given) - 1) <= roundedDeterminant)
             || !(given.xx() > 0)
             || !(given.xx()*given.yy() > sqr(given.xy()))
            )
            {
                FatalFileErrorInFunction(CFile)
                    << "Keyword 'internalField': CpInv is " << given << " at "
                    << meshPoint(a) << ", with the determinant "
                    << det(given) << ": it must be positive definite, with the "
                    << "determinant 1." << nl
                    << "Give a change of volume by the field F0"
                    << exit(FatalIOError);
            }
            store(a, given);
        }
        else if (elastic.valid())
        {
            store(a, plasticPart(elastic()[a], a, elasticFile));
        }
    }
    if (strain.valid()) s.epsilonPEq = strain();

    fileName shareFile;
    const auto share =
        readIfPresent<scalar>("hourglassShare", dimless, &shareFile);
    forAll(s.hourglassShare, a)
    {
        s.hourglassShare[a] =
            share.valid()
          ? share()[a]
          : material_->hourglassShare(s, a);
        if (!(s.hourglassShare[a] >= 0 && s.hourglassShare[a] <= 1))
        {
            FatalFileErrorInFunction(shareFile)
                << "Keyword 'internalField': hourglassShare is "
                << s.hourglassShare[a] << ": it must be from 0 to 1"
                << exit(FatalIOError);
        }
    }

    // The file, also where this processor has no node of the body
    const bool stretched = material_->initial().on();
    fileName file(elastic.valid() ? elasticFile : CFile);
    if (stretched && !elastic.valid())
    {
        readIfPresent<tensor>("F0", dimless, &file);
    }
    const bool strained = stretched || C.valid() || elastic.valid();
    for (label a = 0; a < n && undeformed && strained; ++a)
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
            << "yield stress. The von Mises stress (Kirchhoff) is "
            << stress.first() << " Pa at " << meshPoint(a)
            << ", and at most " << stress.second() << " Pa is valid." << nl
            << "Reduce "
            <<
            (
                elastic.valid() ? "elasticStrain"
              : stretched ? "the stretch F0"
              : "CpInv - I"
            )
            << ", or give earlier plastic flow by the field epsilonPEq"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::deformableBody::timeScale(const bool anew)
{
    if (waveSumIsConstant_) return constantTimeScale_;

    constantTimeScale_ = shortestTimeScale(anew);
    waveSumIsConstant_ = !data_.finiteStrain && !stretchedWaves_;
    return constantTimeScale_;
}


void Foam::deformableBody::commitPlasticity(bodyPowers& accounts)
{
    if (!material_->plastic()) return;
    conservedState& s = data_.state;
    accounts.plastic += material_->commit(s, ownedVolume_);

    // What has flowed resists less, and never more again: that would add energy
    forAll(s.hourglassShare, a)
    {
        if (!(s.flow.increment[a] > 0)) continue;
        const scalar before = s.hourglassShare[a];
        s.hourglassShare[a] = min(before, material_->hourglassShare(s, a));
        accounts.numericalDissipation +=
            ownedVolume_[a]*(before - s.hourglassShare[a])*s.flow.jumpEnergy[a];
    }
}


void Foam::deformableBody::scaleMass(const scalar factor, const scalar before)
{
    if (factor != before)
    {
        for (scalar& lm : data_.state.lm) lm *= factor/before;
    }
    if (factor == 1) return;

    material_->scaleMass(factor);
    data_.rho = material_->rho();
    data_.cp = material_->cp();
    data_.cs = material_->cs();
    forAll(corners_, patchi)
    {
        if (!corners_.set(patchi)) continue;
        corners_[patchi].zp = data_.rho*data_.cp;
        corners_[patchi].zs = data_.rho*data_.cs;
    }
}


std::size_t Foam::deformableBody::bytes() const
{
    return
        solidBody::bytes()
      + sizeof(scalar)*std::size_t(acceleration_.size());
}


void Foam::deformableBody::report(Ostream& os) const
{
    const auto onOff = [](const bool on) { return on ? "on" : "off"; };

    dual_.report(os);
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
    reportScheme(os);
    os  << ", gravity " << onOff(hasGravity())
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
    reportBytes(os);
}


// ************************************************************************* //
