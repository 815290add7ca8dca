/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyInterface.H"
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


void Foam::bodyInterface::resize()
{
    const List<contactOverlap>& overlaps = pairing_->overlaps();
    setExchange();

    if (minus_.body->variational())
    {
        setKernel();
        return;
    }
    closed_.setSize(overlaps.size(), false);
    problems_.setSize(overlaps.size());

    if (twoWay_)
    {
        // Covered shares, by corner
        scalarField minus(minus_.body->corners(minus_.patchi).size(), Zero);
        List<scalar> plus(pairing_->nSlots(), Zero);
        for (const contactOverlap& o : overlaps)
        {
            minus[o.minus.corner[0]] += o.minus.share;
            plus[o.plus.corner[0]] += o.plus.share;
        }
        exchange_.toCorners(plus, scalar(0));
        exchange_.toSlots(plus);

        perMinusCovered_.setSize(overlaps.size());
        perPlusCovered_.setSize(overlaps.size());
        forAll(overlaps, o)
        {
            const contactOverlap& over = overlaps[o];
            perMinusCovered_[o] = 1/minus[over.minus.corner[0]];
            perPlusCovered_[o] = 1/plus[over.plus.corner[0]];
        }
    }
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
    closed_.setSize(minusCorners_.size(), false);
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
        exchange_.toSlots(plus);
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


void Foam::bodyInterface::send()
{
    const cornerStates& P = plus_.body->corners(plus_.patchi);
    const labelList& corners = pairing_->plusCorners();
    sent_.setSize(corners.size());
    forAll(corners, i)
    {
        const label k = corners[i];
        plusState& s = sent_[i];
        static_cast<surfacePlace&>(s) = contactSurface::place(plus_, k);
        s.v = P.v[k];
        s.t = P.t[k];
        s.waveFactor = P.waveFactor[k];
    }
    exchange_.toSlots(sent_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyInterface::bodyInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<solidBody>& bodies
)
:
    bodyInterface
    (
        name, dict, readSide(dict, bodies, 0), readSide(dict, bodies, 1)
    )
{}


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
    twoWay_(contactPairing::readTwoWay(dict)),
    pairing_(contactPairing::New(dict, minus_, plus_))
{
    if (twoWay_ && minus_.body->variational())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'transfer': twoWay needs 'preset paper' in "
            << "controlDict. Valid transfers with other presets: "
            << "(conservative)" << exit(FatalIOError);
    }
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
    resize();
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
    resize();
    if (!pairing_->active()) forget();
    return true;
}


void Foam::bodyInterface::setExchange()
{
    const contactPairing* pairing = &*pairing_;
    exchange_.set(UList<const contactPairing*>(&pairing, 1));
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
    resize();
    if (!pairing_->active()) forget();
}


void Foam::bodyInterface::forOpposite(const visitor& visit) const
{
    if (!pairing_->active() || !minus_.body->variational()) return;

    scalar minus = 0, plus = 0;
    for (const contactOverlap& o : pairing_->overlaps())
    {
        minus += o.minus.area;
        plus += o.plus.area;
    }
    visit(minus_, minusCorners_, minus);
    visit(plus_, pairing_->plusCorners(), plus);
}


void Foam::bodyInterface::remember()
{
    const bool variational = minus_.body->variational();
    const List<contactOverlap>& overlaps = pairing_->overlaps();
    const bodyContact& contact = minus_.body->contact();
    const labelList& node = minus_.geometry().cornerNode;
    forAll(closed_, i)
    {
        const label corner =
            variational ? minusCorners_[i] : overlaps[i].minus.corner[0];
        closed_[i] = contact.touches(node[corner]);
    }
}


void Foam::bodyInterface::solve(const bool firstStage)
{
    if (!pairing_->active())
    {
        return;
    }

    if (minus_.body->variational())
    {
        bodyInterface* pair = this;
        exchangeForces(UList<bodyInterface*>(&pair, 1), exchange_, firstStage);
        return;
    }
    statistics_ = statistics();
    send();

    cornerStates& M = minus_.body->corners(minus_.patchi);
    cornerStates& P = plus_.body->corners(plus_.patchi);

    // The Riemann problem of each overlap, per current area
    const List<contactOverlap>& overlaps = pairing_->overlaps();

    forAll(problems_, o)
    {
        const contactOverlap& over = overlaps[o];
        contactLaw::problem& p = problems_[o];

        const plusState plus(scalarRecord::mean(over.plus, sent_));
        const surfacePlace minus(contactSurface::place(minus_, over.minus));
        const overlapState at(over, minus, plus);

        p.minus = M.sideOf
        (
            over.minus(M.v), over.minus(M.t), over.minus(M.waveFactor),
            minus.stretch
        );
        p.plus = P.sideOf(plus.v, -plus.t, plus.waveFactor, plus.stretch);
        p.area = at.area;
        p.n = at.n;
        p.gap = at.gap;
        setTouching(p, at.opposed, closed_[o], over.depth);
        lose
        (
            closed_[o] && at.opposed, minus_, over.minus.corner[0], p.gap,
            lostDepth*over.depth, over.depth
        );
    }

    solveProblems();

    // Forces and velocities to both sides
    answers_.setSize(pairing_->nSlots());
    answers_ = fluxAnswer();

    forAll(problems_, o)
    {
        const contactOverlap& over = overlaps[o];
        const contactLaw::problem& p = problems_[o];

        scalar minusForce = p.area, plusForce = p.area;
        scalar minusArea = over.minus.area, plusArea = over.plus.area;
        if (twoWay_)
        {
            minusArea *= perMinusCovered_[o];
            plusArea *= perPlusCovered_[o];
            minusForce = minusArea*over.minus(M.stretch);
            plusForce =
                plusArea*scalarRecord::mean(over.plus, sent_).stretch;
        }

        count(p, over.width, over.depth, minusForce, plusForce);
        statistics_.frictionPower += minusForce*slipPower(p);

        const contactLaw::problem q(fromPlus(p));
        const contactAnswer toMinus(answer(p, minusForce));
        const contactAnswer toPlus(answer(q, plusForce));

        setState(minus_, over.minus.corner[0], toMinus, firstStage);
        contactAnswer& own = answers_[over.plus.corner[0]];
        own += toPlus;

        if (p.result.state == acousticRiemann::status::open) continue;

        const vector minusChange(minusArea*velocityChange(p));
        const vector plusChange(plusArea*velocityChange(q));
        for (label j = 0; j < over.minus.size; ++j)
        {
            const scalar share = over.minus.flux[j];
            addFlux
            (
                M, over.minus.corner[j], share*toMinus.force, share*minusChange
            );
        }
        for (label j = 0; j < over.plus.size; ++j)
        {
            const scalar share = over.plus.flux[j];
            fluxAnswer& f = answers_[over.plus.corner[j]];
            f.tractionFlux += share*toPlus.force;
            f.velocityFlux += share*plusChange;
        }
    }

    exchange_.toCorners(answers_, fluxAnswer());
    const labelList& corners = pairing_->plusCorners();
    forAll(corners, c)
    {
        const fluxAnswer& told = answers_[c];
        setState(plus_, corners[c], told, firstStage);
        addFlux(P, corners[c], told.tractionFlux, told.velocityFlux);
    }
}


void Foam::bodyInterface::report(Ostream& os) const
{
    os  << "Interface " << name() << ": " << minus_.body->name() << ' '
        << minus_.patchName << " - " << plus_.body->name() << ' '
        << plus_.patchName << ", pairing " << pairing_->type()
        << (twoWay_ ? ", transfer twoWay" : "") << ", law " << law_->type()
        << nl;
}


// ************************************************************************* //
