/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "generalInterface.H"
#include "obstacleInterface.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "rankRows.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::contactInterface::account Foam::contactInterface::account::total() const
{
    List<account> one(1, *this);
    total(one);
    return one[0];
}


void Foam::contactInterface::account::total(List<account>& sums)
{
    if (Pstream::parRun()) combineRowsOnAll(sums, plusEqOp<scalar>());
}


void Foam::contactInterface::account::write(Ostream& os) const
{
    os  << "    impulse " << impulse << ';' << nl
        << "    plusImpulse " << plusImpulse << ';' << nl
        << "    friction " << friction << ';' << nl
        << "    taken " << taken << ';' << nl
        << "    startsInside " << startsInside << ';' << nl;
}


Foam::contactInterface::account Foam::contactInterface::account::read
(
    const dictionary& record
)
{
    account sums;
    if (Pstream::master())
    {
        sums.impulse = record.get<vector>("impulse");
        sums.plusImpulse = record.get<vector>("plusImpulse");
        sums.friction = record.getOrDefault<scalar>("friction", 0);
        sums.taken = record.getOrDefault<scalar>("taken", 0);
        sums.startsInside = record.getOrDefault<scalar>("startsInside", 0);
    }
    return sums;
}


void Foam::contactInterface::rememberSlide
(
    const contactLaw& law,
    const contactSide& side
)
{
    if (law.sticks() && side.body->variational()) side.body->rememberSlide();
}


Foam::scalar Foam::contactInterface::kept(const contactLaw::problem& p)
{
    using namespace acousticRiemann;

    if (p.result.state == status::open) return 0;
    const vector remembered(tangential(p.tGap, p.n));

    // Zero also if its square is not a number any more: in long slip the slide
    // falls by some share in each step
    const scalar length = mag(remembered);
    if (p.result.state == status::stick || length == 0) return 1;

    // The largest share s <= 1 with |other + s remembered| = limit
    const vector other
    (
        tangential(stickTraction(p.minus, p.plus, p.n), p.n) - remembered
    );
    const scalar limit = mag(tangential(p.result.t, p.n));
    const scalar along = other & (remembered/length);
    const scalar root = sqr(along) - magSqr(other) + sqr(limit);
    const scalar share = root > 0 ? (sqrt(root) - along)/length : 0;
    return max(scalar(0), min(scalar(1), share));
}


Foam::slideMemory::sums Foam::contactInterface::slideBy
(
    const contactLaw::problem& p,
    const vector& way,
    const scalar deltaT
)
{
    using namespace acousticRiemann;

    slideMemory::sums s;
    s.area = max(p.area, scalar(0));
    s.kept = s.area*kept(p);
    if (p.result.state == status::stick)
    {
        s.way = s.area*deltaT*tangential(way, p.n);
    }
    return s;
}


bool Foam::contactInterface::pushes(const solidBody& body) const
{
    return body.variational() && !law_->bonded();
}


void Foam::contactInterface::ask
(
    DynamicList<push>& all,
    const solidBody& body
) const
{
    push p(asked_);
    p.taken = account_.taken;
    p.inside =
        account_.startsInside + (body.lastStep() > 0 ? 0 : asked_.inside);
    all.append(p);
}


Foam::scalar Foam::contactInterface::shareOf(const push& all)
{
    // The same sums as after a restart from here
    account_.taken = Pstream::master() ? all.taken : 0;
    account_.startsInside = Pstream::master() && all.inside > 0 ? 1 : 0;
    return all.share();
}


Foam::contactAnswer Foam::contactInterface::answer
(
    const contactLaw::problem& p,
    const scalar area
)
{
    contactAnswer a;
    a.gap = p.gap;
    if (p.result.state != acousticRiemann::status::open)
    {
        a.force = area*p.result.t;
        a.area = area;
        a.status = int(p.result.state);
    }
    return a;
}


void Foam::contactInterface::tellPassed
(
    const contactSide& side,
    const label corner,
    const scalar penetration,
    const scalar depth
)
{
    if (passed_.size() || law_->bonded())
    {
        return;
    }
    const solidBody& body = *side.body;
    OStringStream os;
    os  << "interface " << name_ << ", region " << body.name() << ", patch "
        << side.patchName << ", "
        << body.whereIs(side.geometry().cornerNode[corner]).c_str()
        << ", is " << penetration << " m inside, and its cell is " << depth
        << " m thick";
    passed_ = os.str();
}


void Foam::contactInterface::countClosing
(
    const contactLaw::problem& p,
    const scalar depth
)
{
    if (p.touching && !law_->bonded())
    {
        statistics_.closing = max
        (
            statistics_.closing, ((p.minus.v - p.plus.v) & p.n)/depth
        );
    }
}


void Foam::contactInterface::count
(
    const contactLaw::problem& p,
    const scalar width,
    const scalar depth,
    const scalar minusArea,
    const scalar plusArea
)
{
    statistics& s = statistics_;

    if (p.touching && !law_->bonded() && p.gap < 0)
    {
        s.penetration = max(s.penetration, -p.gap);
        s.relativePenetration = max(s.relativePenetration, -p.gap/width);
    }
    if (p.result.state == acousticRiemann::status::open)
    {
        ++s.nOpen;
        return;
    }
    s.force += minusArea*p.result.t;
    s.plusForce -= plusArea*p.result.t;
    s.area += p.area;
    s.peakPressure = max(s.peakPressure, -(p.result.t & p.n));
    if (p.gap > closingGap*depth && !law_->bonded())
    {
        s.gapForce -= minusArea*(p.result.t & p.n);
        s.gapArea += p.area;
    }
    ++(p.result.state == acousticRiemann::status::slip ? s.nSlip : s.nStick);
}


void Foam::contactInterface::setState
(
    const contactSide& side,
    const label corner,
    const contactAnswer& answer
)
{
    cornerStates& c = side.body->corners(side.patchi);
    bodyContact& out = side.body->contact();
    const label node = c.geometry.cornerNode[corner];

    out.gap[node] = min(out.gap[node], answer.gap);
    if (answer.status > 0)
    {
        out.force[node] += answer.force;
        out.area[node] += answer.area;
        out.status[node] = max(out.status[node], answer.status);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactInterface::contactInterface
(
    const word& name,
    const dictionary& dict
)
:
    name_(name),
    dictName_(name),
    law_(contactLaw::ofInterface(dict))
{}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

void Foam::contactInterface::append
(
    const word& name,
    const dictionary& dict,
    PtrList<solidBody>& bodies,
    PtrList<contactInterface>& interfaces
)
{
    const label first = interfaces.size();
    if (dict.found("obstacle") || dict.found("side"))
    {
        dictionaryCheck::onlyKeywords(dict, obstacleInterface::keywords());
        const surfaceSelection::expression which
        (
            surfaceSelection::read(dict, "side")
        );
        for
        (
            const contactSide& side
          : surfaceSelection::select(dict, "side", which, bodies)
        )
        {
            const word its
            (
                which.literal() ? name
              : word(name + '.' + surfaceSelection::name(side))
            );
            interfaces.append(obstacleInterface::New(its, dict, side).ptr());
        }
    }
    else if (generalInterface::describedBy(dict))
    {
        UPtrList<contactInterface> others(first);
        forAll(others, i) others.set(i, &interfaces[i]);
        interfaces.append(new generalInterface(name, dict, bodies, others));
    }
    else
    {
        interfaces.append(bodyInterface::New(name, dict, bodies).ptr());
    }
    for (label i = first; i < interfaces.size(); ++i)
    {
        interfaces[i].setDictName(name);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::contactInterface::readLaw(const dictionary& dict)
{
    autoPtr<contactLaw> law(contactLaw::ofInterface(dict));
    if (law->bonded() != law_->bonded())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'law': " << law_->type() << " cannot be changed to "
            << law->type() << " while the run goes on, because only one of "
            << "them ties the surfaces" << exit(FatalIOError);
    }
    law_ = std::move(law);
    const List<contactSide> both(sides());
    for (const contactSide& side : both) rememberSlide(*law_, side);
}


void Foam::contactInterface::accumulate(const scalar weightedDeltaT)
{
    account_.impulse += weightedDeltaT*statistics_.force;
    account_.plusImpulse += weightedDeltaT*statistics_.plusForce;
    account_.friction += weightedDeltaT*statistics_.frictionPower;
}


void Foam::contactInterface::writeRecord(Ostream& os) const
{
    account_.total().write(os);
}


void Foam::contactInterface::readRecord(const dictionary& record)
{
    account_ = account::read(record);
}


// ************************************************************************* //
