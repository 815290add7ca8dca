/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "energyAccounts.H"
#include "rankRows.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Entry of the record, and the members of the accounts and of the energies
struct accountEntry
{
    const char* name;
    scalar solidBody::powers::*value;
    scalar bodyEnergies::*energy;
};

#define accountOf(name, value)                                               \
    { #name, &solidBody::powers::value, &bodyEnergies::name }

constexpr accountEntry accountEntries[] =
{
    accountOf(numericalDissipation, numericalDissipation),
    accountOf(plasticDissipation, plastic),
    accountOf(externalWork, external),
    accountOf(contactWork, contact),
    accountOf(dampingDissipation, damping),
    accountOf(relaxationDissipation, relaxation),
    accountOf(startSwing, startSwing)
};

#undef accountOf

//- Round-off of the strain energy, over mass times wave speed squared
constexpr scalar roundOff = 1e-14;

//- Work of contact [J]. What fluxes of the paper's scheme dissipate at once is
//  not a gain
scalar netOf(const scalar contactWork, const scalar numericalDissipation)
{
    return contactWork - max(numericalDissipation, scalar(0));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::bodyEnergies::operator+=(const bodyEnergies& e)
{
    kinetic += e.kinetic;
    swing += e.swing;
    strain += e.strain;
    balance += e.balance;
    roundOff += e.roundOff;
    for (const accountEntry& a : accountEntries) this->*a.energy += e.*a.energy;
}


Foam::scalarList Foam::energyAccounts::sums() const
{
    scalarList all(nSums*bodies_.size(), scalar(0));
    forAll(bodies_, i)
    {
        // The leapfrog's accounts end half a step before the time of the state
        const solidBody& body = bodies_[i];
        solidBody::powers account(accounts_[i]);
        if (on_ && leaping_.size())
        {
            add
            (
                account, leaping_[i].presentPowers(), 0.5*body.lastStep()
            );
        }
        scalar* sum = all.data() + nSums*i;
        *sum++ = body.kineticEnergy();
        *sum++ = body.swing();
        *sum++ = body.strainEnergy();
        for (const accountEntry& a : accountEntries) *sum++ = account.*a.value;
    }
    combineOnAll(all, plusEqOp<scalar>());
    return all;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::energyAccounts::energyAccounts
(
    const PtrList<solidBody>& bodies,
    const UPtrList<leapfrogBody>& leaping
)
:
    bodies_(bodies),
    leaping_(leaping),
    accounts_(bodies.size()),
    old_(bodies.size()),
    initial_(bodies.size(), scalar(0)),
    roundOff_(bodies.size(), scalar(VSMALL))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::energyAccounts::begin()
{
    forAll(bodies_, i)
    {
        const solidBody& body = bodies_[i];
        if (body.rigid()) continue;
        roundOff_[i] =
            roundOff*returnReduce(body.mass(), sumOp<scalar>())
           *sqr(body.material().cp());
    }

    if (continued_) return;
    const scalarList all(sums());
    forAll(initial_, i)
    {
        const scalar* sum = all.cdata() + nSums*i;
        initial_[i] = sum[0] - sum[1] + sum[2];
    }
}


void Foam::energyAccounts::add
(
    solidBody::powers& account,
    const solidBody::powers& p,
    const scalar time
)
{
    account.numericalDissipation += time*p.numericalDissipation;
    account.external += time*p.external;
    account.contact += time*p.contact;
    account.damping += time*p.damping;
}


void Foam::energyAccounts::addStop(const scalar sign)
{
    forAll(leaping_, i)
    {
        const leapfrogBody& body = leaping_[i];
        add
        (
            accounts_[i], body.presentPowers(), sign*0.5*body.lastStep()
        );
        accounts_[i].relaxation +=
            sign*(body.kineticEnergy() - body.swing());
    }
}


Foam::List<Foam::bodyEnergies> Foam::energyAccounts::compute
(
    const PtrList<contactInterface>& interfaces
) const
{
    const scalarList sums(this->sums());
    List<bodyEnergies> all(bodies_.size() + 1);
    forAll(bodies_, i)
    {
        const scalar* sum = sums.cdata() + nSums*i;
        bodyEnergies& e = all[i];
        e.kinetic = *sum++;
        e.swing = *sum++;
        e.strain = *sum++;
        for (const accountEntry& a : accountEntries) e.*a.energy = *sum++;
        e.balance =
            e.kept() - initial_[i] + e.numericalDissipation
          + e.plasticDissipation + e.dampingDissipation
          + e.relaxationDissipation + e.startSwing - e.externalWork
          - e.contactWork;
        e.roundOff = roundOff_[i];
        all.last() += e;
    }
    bool obstacleMoves = false;
    for (const contactInterface& contact : interfaces)
    {
        all.last().frictionDissipation += contact.sums().friction;
        obstacleMoves = obstacleMoves || contact.driven();
    }
    bodyEnergies& whole = all.last();
    whole.contactGain =
        obstacleMoves ? 0
      : netOf(whole.contactWork, whole.numericalDissipation) - givenBefore_;
    reduce(all.last().frictionDissipation, sumOp<scalar>());
    return all;
}


Foam::scalar Foam::energyAccounts::rise(const bodyEnergies& all)
{
    const scalar own = all.kept() - all.externalWork - all.contactWork;
    least_ = min(least_, own);
    largest_ = max(largest_, max(all.total(), all.roundOff));
    return max(own - least_, all.contactGain);
}


void Foam::energyAccounts::read(const dictionary& record)
{
    // Accounts that were not kept cannot be continued
    continued_ = record.getOrDefault("energiesOn", false);
    for (const solidBody& body : bodies_)
    {
        continued_ = continued_ && record.found(body.recordName());
    }
    if (!continued_)
    {
        begin();
        return;
    }
    scalar contactWork = 0, numericalDissipation = 0;
    forAll(bodies_, i)
    {
        const dictionary& body = record.subDict(bodies_[i].recordName());
        initial_[i] = body.get<scalar>("initialEnergy");
        contactWork += body.getOrDefault<scalar>("contactWork", 0);
        numericalDissipation +=
            body.getOrDefault<scalar>("numericalDissipation", 0);
        if (Pstream::master())
        {
            for (const accountEntry& a : accountEntries)
            {
                accounts_[i].*a.value = body.getOrDefault<scalar>(a.name, 0);
            }
        }
    }
    givenBefore_ = max(netOf(contactWork, numericalDissipation), scalar(0));
}


void Foam::energyAccounts::write(const label i, Ostream& os) const
{
    os  << "    initialEnergy " << initial_[i] << ';' << nl;
    for (const accountEntry& a : accountEntries)
    {
        os  << "    " << a.name << ' '
            << returnReduce(accounts_[i].*a.value, sumOp<scalar>()) << ';'
            << nl;
    }
}


// ************************************************************************* //
