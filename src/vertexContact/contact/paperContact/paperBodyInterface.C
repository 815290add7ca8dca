/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "paperBodyInterface.H"
#include "paperContact.H"
#include "solidBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::paperBodyInterface::setCovered()
{
    // By corner
    const List<contactOverlap>& overlaps = pairing_->overlaps();
    scalarField minus(minus_.body->corners(minus_.patchi).size(), Zero);
    List<scalar> plus(pairing_->nSlots(), Zero);
    for (const contactOverlap& o : overlaps)
    {
        minus[o.minus.corner[0]] += o.minus.share;
        plus[o.plus.corner[0]] += o.plus.share;
    }
    alone_.exchange.toCorners(plus, scalar(0));
    alone_.exchange.toSlots(plus);

    perMinusCovered_.setSize(overlaps.size());
    perPlusCovered_.setSize(overlaps.size());
    forAll(overlaps, o)
    {
        const contactOverlap& over = overlaps[o];
        perMinusCovered_[o] = 1/minus[over.minus.corner[0]];
        perPlusCovered_[o] = 1/plus[over.plus.corner[0]];
    }
}


void Foam::paperBodyInterface::send()
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
    alone_.exchange.toSlots(sent_);
}


void Foam::paperBodyInterface::setProblems()
{
    const cornerStates& M = minus_.body->corners(minus_.patchi);
    const cornerStates& P = plus_.body->corners(plus_.patchi);
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
        p.touching =
            law().bonded()
         || paperContact::touches
            (
                p, at.opposed, closed_[o], closingGap, over.depth
            );
        checkPassed
        (
            closed_[o] && at.opposed, minus_, minusCorners_[o], p.gap,
            passedDepth*over.depth, over.depth
        );
    }
}


void Foam::paperBodyInterface::addFluxes()
{
    cornerStates& M = minus_.body->corners(minus_.patchi);
    cornerStates& P = plus_.body->corners(plus_.patchi);
    const List<contactOverlap>& overlaps = pairing_->overlaps();

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
        statistics_.frictionPower += minusForce*paperContact::slipPower(p);

        const contactLaw::problem q(paperContact::fromPlus(p));
        const contactAnswer toMinus(answer(p, minusForce));
        const contactAnswer toPlus(answer(q, plusForce));

        setState(minus_, minusCorners_[o], toMinus);
        contactAnswer& own = answers_[over.plus.corner[0]];
        own += toPlus;

        if (p.result.state == acousticRiemann::status::open) continue;

        const vector minusChange(minusArea*paperContact::velocityChange(p));
        const vector plusChange(plusArea*paperContact::velocityChange(q));
        for (label j = 0; j < over.minus.size; ++j)
        {
            const scalar share = over.minus.flux[j];
            paperContact::addFlux
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

    alone_.exchange.toCorners(answers_, fluxAnswer());
    const labelList& corners = pairing_->plusCorners();
    forAll(corners, c)
    {
        const fluxAnswer& told = answers_[c];
        setState(plus_, corners[c], told);
        paperContact::addFlux
        (
            P, corners[c], told.tractionFlux, told.velocityFlux
        );
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::paperBodyInterface::setOverlaps()
{
    const List<contactOverlap>& overlaps = pairing_->overlaps();
    alone_.set(List<bodyInterface*>(1, this));
    minusCorners_.setSize(overlaps.size());
    forAll(overlaps, o) minusCorners_[o] = overlaps[o].minus.corner[0];
    closed_.setSize(overlaps.size(), false);
    problems_.setSize(overlaps.size());
    if (twoWay_) setCovered();
}


Foam::string Foam::paperBodyInterface::transfer() const
{
    return twoWay_ ? ", transfer twoWay" : "";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::paperBodyInterface::paperBodyInterface
(
    const word& name,
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
:
    bodyInterface(name, dict, minus, plus),
    twoWay_(contactPairing::readTwoWay(dict))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::paperBodyInterface::remember()
{
    const bodyContact& contact = minus_.body->contact();
    const labelList& node = minus_.geometry().cornerNode;
    forAll(closed_, i) closed_[i] = contact.touches(node[minusCorners_[i]]);
}


void Foam::paperBodyInterface::solve()
{
    if (!pairing_->active()) return;

    statistics_ = statistics();
    send();
    setProblems();
    solveProblems();
    addFluxes();
}


// ************************************************************************* //
