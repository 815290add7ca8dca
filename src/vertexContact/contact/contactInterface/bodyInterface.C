/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "paperBodyInterface.H"
#include "solidBody.H"
#include "surfaceSelection.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::contactSide Foam::bodyInterface::readSide
(
    const dictionary& dict,
    PtrList<solidBody>& bodies,
    const label which
)
{
    const List<Pair<word>> sides(dict.get<List<Pair<word>>>("sides"));

    if (sides.size() != 2)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'sides' has " << sides.size() << " entries: it needs "
            << "two, each a region and a patch, as in "
            << "((bar1 right) (bar2 left))" << exit(FatalIOError);
    }
    return surfaceSelection::single(dict, "sides", sides[which], bodies);
}


void Foam::bodyInterface::setOverlaps()
{
    alone_.set(List<bodyInterface*>(1, this));
    setKernel();
}


void Foam::bodyInterface::findSharedCorners()
{
    sharedCorners_.setSize(pairing_->plusCorners().size());
    sharedCorners_ = false;
    if (!pairing_->map()) return;

    boolList asked(sharedCorners_);
    for (const labelList& some : pairing_->map()->subMap())
    {
        for (const label k : some)
        {
            sharedCorners_[k] = asked[k];
            asked[k] = true;
        }
    }
}


void Foam::bodyInterface::setKernel()
{
    const List<contactOverlap>& overlaps = pairing_->overlaps();
    const solidBody& body = *minus_.body;

    // Corners of the minus side with overlaps, and their indices among these
    labelList slots(minus_.geometry().nCorners());
    minusCorners_ =
        contactOverlaps::usedCorners(overlaps, &contactOverlap::minus, slots);
    if (!pairing_->active()) return;

    // Initial gaps of bonded surfaces, from positions of both sides
    pointField plus;
    scalarField firstGap;
    if (law().bonded())
    {
        firstGap.setSize(overlaps.size());
        const labelList& plusCorners = pairing_->plusCorners();
        const labelList& plusNode = plus_.geometry().cornerNode;
        plus.setSize(plusCorners.size());
        forAll(plus, i)
        {
            plus[i] = plus_.body->meshPoint(plusNode[plusCorners[i]]);
        }
        alone_.exchange.toSlots(plus);
    }

    const labelList& minusNode = minus_.geometry().cornerNode;
    nNodes_ = 1;
    forAll(overlaps, o)
    {
        const contactOverlap& over = overlaps[o];
        if (firstGap.size())
        {
            // The reference gap lies along the normal
            vector between(over.plus(plus));
            for (label j = 0; j < over.minus.size; ++j)
            {
                between -=
                    over.minus.value[j]
                   *body.meshPoint(minusNode[over.minus.corner[j]]);
            }
            between = body.dual().projected(between);
            const vector n
            (
                body.dual().cornerNormal
                (
                    minus_.geometry(), over.minus.corner[0]
                )
            );
            firstGap[o] = mag(between)*sign(between & n);
        }
        const label most = max(over.minus.size, over.plus.size);
        nNodes_ = max(nNodes_, most > 2 ? label(4) : most);
    }
    withNodes([&](auto N)
    {
        auto& kernel = std::get<overlapKernel<N.value>>(kernels_);
        kernel.set(overlaps, slots, firstGap);
        nearBlocks<N.value>().clear();
    });
    findSharedCorners();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyInterface::bodyInterface
(
    const word& name,
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
:
    contactInterface(name, dict),
    minus_(minus),
    plus_(plus),
    pairing_(contactPairing::New(dict, minus_, plus_))
{
    const auto refuse = [&](const char* why)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'sides': " << why << " (regions '"
            << minus_.body->name() << "' and '" << plus_.body->name()
            << "'), so contact between them would do nothing"
            << exit(FatalIOError);
    };
    if (minus_.body == plus_.body && minus_.body->rigid())
    {
        refuse("both sides belong to one rigid region");
    }
    if (minus_.body->immovable() && plus_.body->immovable())
    {
        refuse("no force can move either of the rigid regions");
    }
    for (const contactSide* side : {&minus_, &plus_})
    {
        rememberSlide(law(), *side);
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::bodyInterface> Foam::bodyInterface::New
(
    const word& name,
    const dictionary& dict,
    PtrList<solidBody>& bodies
)
{
    return New
    (
        name, dict, readSide(dict, bodies, 0), readSide(dict, bodies, 1)
    );
}


Foam::autoPtr<Foam::bodyInterface> Foam::bodyInterface::New
(
    const word& name,
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
{
    autoPtr<bodyInterface> pair;
    if (!minus.body->variational())
    {
        pair.reset(new paperBodyInterface(name, dict, minus, plus));
    }
    else if (contactPairing::readTwoWay(dict))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'transfer': twoWay needs 'preset paper' in "
            << "controlDict. Valid transfers with other presets: "
            << "(conservative)" << exit(FatalIOError);
    }
    else
    {
        pair.reset(new bodyInterface(name, dict, minus, plus));
    }
    pair->setOverlaps();
    return pair;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::contactSide> Foam::bodyInterface::sides() const
{
    return List<contactSide>({minus_, plus_});
}


Foam::Pair<Foam::string> Foam::bodyInterface::namesOf
(
    const contactSide& minus,
    const contactSide& plus
)
{
    // For a surface with itself the opposite part needs another name
    return Pair<string>
    (
        minus.body->name() + '.' + minus.patchName,
        plus.body->name() + '.' + plus.patchName
      + (minus == plus ? ".opposite" : "")
    );
}


bool Foam::bodyInterface::update(const scalar time, const bool all)
{
    const PtrList<contactSurface::snapshot> now
    (
        contactSurface::snapshots(sides())
    );
    if (!all)
    {
        const auto bodies =
            contactSurface::bodyMotion::common(now[0].motion, now[1].motion);
        const auto both = [](const label a, const label b) { return a | b; };
        const label moved = returnReduce(this->moved(time, bodies), both);
        if (!again(time, moved, bodies)) return false;
    }
    pairing_->update(time, now[0], now[1]);
    setOverlaps();
    if (!pairing_->active()) forget();
    return true;
}


void Foam::bodyInterface::find
(
    const contactSurface::snapshot& minus,
    const contactSurface::snapshot& plus
)
{
    pairing_->find(minus, plus);
}


void Foam::bodyInterface::follow
(
    const scalar time,
    const contactSurface::snapshot& minus,
    const contactSurface::snapshot& plus,
    const scalar nearest
)
{
    pairing_->setNearest(nearest);
    pairing_->follow(time, minus, plus);
    setOverlaps();
    if (!pairing_->active()) forget();
}


void Foam::bodyInterface::forOpposite(const visitor& visit) const
{
    if (!pairing_->active()) return;

    scalar minus = 0, plus = 0;
    for (const contactOverlap& o : pairing_->overlaps())
    {
        minus += o.minus.area;
        plus += o.plus.area;
    }
    visit(minus_, minusCorners_, minus);
    visit(plus_, pairing_->plusCorners(), plus);
}


void Foam::bodyInterface::solve()
{
    if (pairing_->active()) alone_.exchangeForces();
}


void Foam::bodyInterface::report(Ostream& os) const
{
    os  << "Interface " << name() << ": " << minus_.body->name() << ' '
        << minus_.patchName << " - " << plus_.body->name() << ' '
        << plus_.patchName << ", pairing " << pairing_->type()
        << transfer().c_str() << ", law " << law_->type() << nl;
}


// ************************************************************************* //
