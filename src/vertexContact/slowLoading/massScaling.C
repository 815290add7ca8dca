/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "massScaling.H"
#include "regionSettings.H"
#include "dictionaryCheck.H"
#include "bodiesOfKind.H"
#include "variationalBody.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scalar readFactor(const dictionary& dict, solidBody& body)
{
    using namespace dictionaryCheck;
    if (dict.found("factor") == dict.found("step"))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'massScaling': region '" << body.name() << "' must "
            << "have exactly one of (factor step)" << exit(FatalIOError);
    }
    if (dict.found("factor"))
    {
        const scalar factor = readNumber(dict, "factor", dimless);
        require(factor >= 1, dict, "factor", factor, "at least 1");
        return factor;
    }
    const scalar step = readNumber(dict, "step", dimTime);
    require(step > 0, dict, "step", step, "positive");
    auto* its = dynamic_cast<variationalBody*>(&body);
    if (!its)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'step' does not work with preset paper. Valid keyword "
            << "with this preset: factor" << exit(FatalIOError);
    }
    return max(scalar(1), sqr(step/its->undeformedTimeScale()));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::massScaling::massScaling
(
    const dictionary& controlDict,
    const dictionary& record,
    PtrList<solidBody>& bodies
)
{
    const List<const dictionary*> settings
    (
        regionSettings::read(controlDict, "massScaling", bodies, keywords())
    );
    UPtrList<deformableBody> deform(bodiesOfKind<deformableBody>(bodies));
    scalarField mass(bodies.size(), Zero);
    forAll(bodies, i)
    {
        if (settings.empty() || !deform.set(i)) continue;
        mass[i] = returnReduce(bodies[i].mass(), sumOp<scalar>());
    }
    forAll(bodies, i)
    {
        if (!deform.set(i)) continue;
        deformableBody& body = deform[i];

        // Momenta of an earlier run belong to the mass of that run
        const bool scaled = settings.size() && settings[i];
        const scalar factor = scaled ? readFactor(*settings[i], body) : 1;
        body.scaleMass
        (
            factor,
            record.subOrEmptyDict(body.recordName())
                .getOrDefault<scalar>("massFactor", 1)
        );
        if (!scaled) continue;

        const dictionary& dict = *settings[i];
        added a;
        a.body = i;
        a.mass = (factor - 1)*mass[i];
        a.ofAll = a.mass/sum(mass);
        const scalar limit =
            dictionaryCheck::readOptional(dict, keywords(), "limit", dimless);
        dictionaryCheck::require
        (
            limit >= 0, dict, "limit", limit, "at least 0"
        );
        const bool force =
            dictionaryCheck::readOptional<bool>(dict, keywords(), "force");
        if (a.ofAll > limit && !force)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'massScaling': region '" << body.name()
                << "' with the factor " << factor << " adds " << a.mass
                << " kg, " << 100*a.ofAll << " % of the mass of all regions "
                << "that deform. At most 'limit', " << 100*limit << " %, is "
                << "valid without 'force yes'" << exit(FatalIOError);
        }
        regions_.append(a);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::massScaling::keywords()
{
    return
    {
        {"factor", "-", "or step", "factor of the mass, at least 1"},
        {
            "step", "s", "or factor",
            "mass is added until the undeformed region has this stable step "
            "(at Co 1)"
        },
        {
            "limit", "-", "0.05",
            "largest added mass, as a share of the mass of all regions that "
            "deform"
        },
        {"force", "", "no", "yes: mass above the limit is no error"}
    };
}


void Foam::massScaling::report
(
    const PtrList<solidBody>& bodies,
    Ostream& os
) const
{
    for (const added& a : regions_)
    {
        const scalar factor = bodies[a.body].massFactor();
        os  << "Mass scaling: region " << bodies[a.body].name() << " moves as "
            << "if it had " << factor << " times its mass: " << a.mass
            << " kg added, " << 100*(factor - 1) << " % of its own, "
            << 100*a.ofAll << " % of all. Momentum and kinetic energy are "
            << "those of the scaled mass, the weight is that of the true mass"
            << nl;
    }
}


// ************************************************************************* //
