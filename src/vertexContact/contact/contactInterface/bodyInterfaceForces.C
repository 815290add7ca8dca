/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Contact of two surfaces in the default scheme: states of both sides for the
    overlaps, the resulting forces, and the slide.

\*---------------------------------------------------------------------------*/

#include "bodyInterface.H"
#include "solidBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::bodyInterface::findStates
(
    const contactSide& side,
    const labelList& corners,
    List<surfaceState>& states
) const
{
    const solidBody& body = *side.body;
    const dualPatch& patch = side.geometry();
    const boolList& rim = body.surface(side.patchi).rimNode;
    const bool rigid = body.surface(side.patchi).nodeArea.empty();
    const bool holding = holds();
    const label d = body.dual().nDim();
    const scalar* disp = body.state().disp.cdata();

    states.setSize(corners.size());
    forAll(corners, i)
    {
        const label k = corners[i], node = patch.cornerNode[k];
        const vector area(body.currentArea(patch, k));
        surfaceState& s = states[i];
        s.x = body.dual().position(node) + body.expand(disp + node*d);
        s.v = body.contact().velocityWithout(node);
        s.stretch = mag(area);
        s.n = area/s.stretch;
        s.compliance =
            s.stretch
           *max
            (
                body.surfaceCompliance(side.patchi, k),
                holding ? body.holdCompliance(side.patchi, k) : scalar(0)
            );
        s.inner = rim.size() && rim[k] ? 0 : 1;
        s.shared = 0;

        // Within a surface all faces around have about the corner's normal
        s.around = rigid ? vector::zero : s.n;
        if (!rigid && s.inner < 0.5)
        {
            s.around =
                body.surfaceAround(side.patchi, k)
               /(s.stretch*body.surfaceArea(side.patchi, k));
        }
    }
}


template<class T>
void Foam::bodyInterface::toSlots
(
    group& g,
    sideValues<T> bodyInterface::* values
)
{
    g.exchange.toSlots<T>
    (
        [&](const label i) -> auto& { return (g.pairs[i]->*values).own; },
        [&](const label i) -> auto& { return (g.pairs[i]->*values).plus; }
    );
}


template<class T, class Function>
void Foam::bodyInterface::findValues
(
    group& g,
    sideValues<T> bodyInterface::* values,
    const Function& of
)
{
    const auto find = [&]
    (
        const contactSide& side,
        const labelList& corners,
        List<T>& its
    )
    {
        const solidBody& body = *side.body;
        const labelList& node = side.geometry().cornerNode;
        its.setSize(corners.size());
        forAll(corners, i) its[i] = of(body, node[corners[i]]);
    };
    for (bodyInterface* pair : g.pairs)
    {
        sideValues<T>& its = pair->*values;
        find(pair->minus_, pair->minusCorners_, its.minus);
        find(pair->plus_, pair->pairing_->plusCorners(), its.own);
    }
    toSlots(g, values);
}


template<int nNodes>
void Foam::bodyInterface::findNear()
{
    typedef overlapKernel<nNodes> kernelType;
    const kernelType& kernel = std::get<kernelType>(kernels_);
    std::vector<nearBlock<nNodes>>& all = nearBlocks<nNodes>();

    const solidBody& body = *minus_.body;
    const cornerStates& M = body.corners(minus_.patchi);
    const cornerStates& P = plus_.body->corners(plus_.patchi);
    const scalar deltaT = body.contact().step();
    const bool bonded = law().bonded();
    const bool sticks = law().sticks();
    const scalar impedance = contactLayer::joint(M.zp, P.zp);
    const scalar minusGives = body.contact().gives();
    const scalar plusGives = plus_.body->contact().gives();
    const bool alike = minusGives == plusGives;

    // Store the gap at both corners of an overlap
    const auto tellGap = [&]
    (
        const typename kernelType::block& b,
        const int l,
        const scalar gap
    )
    {
        scalar& minus = toMinus_[b.minus.slot[0][l]].gap;
        scalar& plus = toPlus_[b.plus.slot[0][l]].gap;
        minus = min(minus, gap);
        plus = min(plus, gap);
    };

    typename kernelType::levers lever;
    typename kernelType::place at;
    asked_ = push();
    all.clear();
    for (label i = 0; i < kernel.size(); ++i)
    {
        const typename kernelType::block& b = kernel[i];
        kernel.find
        (
            b, states_.minus.cdata(), states_.plus.cdata(), deltaT, impedance,
            bonded, lever, at
        );
        for (int l = 0; l < b.size; ++l)
        {
            if (at.near[l]) continue;
            ++statistics_.nOpen;
            tellGap(b, l, at.distance[l]);
        }
        if (!at.any()) continue;

        all.emplace_back();
        nearBlock<nNodes>& near = all.back();
        near.block = i;
        near.lever = lever;
        for (int l = 0; l < b.size; ++l)
        {
            if (!at.near[l]) continue;
            near.lane[near.size] = l;
            near.whole[near.size] = at.paired[l]*at.whole[l];
            contactLaw::problem& p = near.problems[near.size++];
            vector normal, shift(Zero);
            for (direction c = 0; c < 3; ++c)
            {
                p.n[c] = at.n[c][l];
                p.minus.v[c] = at.minusV[c][l];
                p.plus.v[c] = at.plusV[c][l];
                normal[c] = at.centroidNormal[c][l];
                if (bonded) shift[c] = at.shift[c][l];
            }
            const label slot = b.minus.slot[0][l];
            if (sticks)
            {
                // The slide seen from the plus side has the other sign
                shift = acousticRiemann::tangential
                (
                    0.5
                   *(slides_.minus[slot] - slides_.plus[b.plus.slot[0][l]]),
                    normal
                );
            }
            p.gap = at.gap[l];
            p.minus.zp = M.zp;
            p.minus.zs = M.zs;
            p.plus.zp = P.zp;
            p.plus.zs = P.zs;
            p.area = at.paired[l]*at.area[l];
            const scalar gives =
                alike
              ? minusGives
              : plusGives
              + at.minusPerMass[l]/at.perMass[l]*(minusGives - plusGives);
            contactLayer(at.perMass[l]).set
            (
                p, true, bonded, shift, deltaT, gives
            );
            countClosing(p, b.depth[l]);
            if (!bonded) askPush(p, b.depth[l], deltaT);
            tellGap(b, l, p.gap);
        }
    }

    // Sides of one body do not overlap at the start
    if (minus_.body == plus_.body) asked_.inside = 0;
}


template<int nNodes>
void Foam::bodyInterface::limitNear(const scalar share)
{
    for (nearBlock<nNodes>& near : nearBlocks<nNodes>())
    {
        for (label k = 0; k < near.size; ++k)
        {
            contactLaw::problem& p = near.problems[k];
            if (p.gap < 0) contactLayer::limit(p, share);
        }
    }
}


template<int nNodes>
void Foam::bodyInterface::correctNear()
{
    const auto& kernel = std::get<overlapKernel<nNodes>>(kernels_);
    const bool bonded = law().bonded();
    for (nearBlock<nNodes>& near : nearBlocks<nNodes>())
    {
        const auto& b = kernel[near.block];
        const auto minus = near.velocity
        (
            near.lever.minus, b.minus,
            [&](const label s) -> const vector& { return velocities_.minus[s]; }
        );
        const auto plus = near.velocity
        (
            near.lever.plus, b.plus,
            [&](const label s) -> const vector& { return velocities_.plus[s]; }
        );
        for (label k = 0; k < near.size; ++k)
        {
            contactLaw::problem& p = near.problems[k];
            for (direction c = 0; c < 3; ++c)
            {
                p.minus.v[c] = minus[c][near.lane[k]];
                p.plus.v[c] = plus[c][near.lane[k]];
            }
            contactLayer::correct(p, bonded);
        }
    }
}


template<int nNodes>
void Foam::bodyInterface::releasePulls()
{
    typedef overlapKernel<nNodes> kernelType;
    const kernelType& kernel = std::get<kernelType>(kernels_);
    const auto acting = [&](const auto& visit)
    {
        for (nearBlock<nNodes>& near : nearBlocks<nNodes>())
        {
            const typename kernelType::block& b = kernel[near.block];
            for (label k = 0; k < near.size; ++k)
            {
                contactLaw::problem& p = near.problems[k];
                if (p.result.state == acousticRiemann::status::open) continue;
                const int l = near.lane[k];
                visit(p, b.minus.slot[0][l], b.plus.slot[0][l]);
            }
        }
    };

    bool pulls = false;
    acting([&](const contactLaw::problem& p, label, label)
    {
        pulls = pulls || p.area < 0;
    });
    if (!pulls) return;

    minusPressed_.setSize(toMinus_.size());
    plusPressed_.setSize(toPlus_.size());
    minusPressed_ = Zero;
    plusPressed_ = Zero;
    acting([&](const contactLaw::problem& p, const label m, const label s)
    {
        minusPressed_[m] += p.area*p.result.t;
        plusPressed_[s] += p.area*p.result.t;
    });
    acting([&](contactLaw::problem& p, const label m, const label s)
    {
        const bool pressed =
            (minusPressed_[m] & p.n) < 0 || (plusPressed_[s] & p.n) < 0
         || states_.plus[s].shared > 0.5;
        if (p.area < 0 && !pressed)
        {
            p.result.state = acousticRiemann::status::open;
            p.result.t = Zero;
        }
    });
}


template<int nNodes>
void Foam::bodyInterface::solveNear()
{
    typedef overlapKernel<nNodes> kernelType;
    const kernelType& kernel = std::get<kernelType>(kernels_);
    nodeAnswer* toMinus = toMinus_.data();
    nodeAnswer* toPlus = toPlus_.data();

    for (nearBlock<nNodes>& near : nearBlocks<nNodes>())
    {
        UList<contactLaw::problem> problems(near.problems, near.size);
        law_->solve(problems);
    }
    releasePulls<nNodes>();

    for (nearBlock<nNodes>& near : nearBlocks<nNodes>())
    {
        const typename kernelType::block& b = kernel[near.block];
        typename kernelType::vectorType force;
        bool acts[nLanes];
        for (int l = 0; l < nLanes; ++l)
        {
            acts[l] = false;
            for (int c = 0; c < 3; ++c) force[c][l] = 0;
        }
        for (label k = 0; k < near.size; ++k)
        {
            const contactLaw::problem& p = near.problems[k];
            const int l = near.lane[k];
            count(p, b.width[l], b.depth[l], p.area, p.area);
            if (p.result.state == acousticRiemann::status::open) continue;

            acts[l] = true;
            // An overlap that has lost its area, or found as much again, has
            // left its place: its gap is not that of the surfaces any more
            const scalar change = p.area/near.whole[k];
            checkPassed
            (
                change > 0 && change < 2, minus_,
                minusCorners_[b.minus.slot[0][l]], p.gap,
                passedDepth*b.depth[l], b.depth[l]
            );
            contactAnswer told(answer(p, p.area));
            for (int c = 0; c < 3; ++c)
            {
                force[c][l] = near.whole[k]*p.result.t[c];
            }
            contactAnswer& minus = toMinus[b.minus.slot[0][l]];
            contactAnswer& plus = toPlus[b.plus.slot[0][l]];
            minus += told;
            told.force = -told.force;
            plus += told;
        }
        kernel.act(b, near.lever, force, acts, toMinus, toPlus);
    }
}


void Foam::bodyInterface::startForces()
{
    statistics_ = statistics();
    findStates(minus_, minusCorners_, states_.minus);
    findStates(plus_, pairing_->plusCorners(), states_.own);
    forAll(states_.own, i) states_.own[i].shared = sharedCorners_[i];
}


void Foam::bodyInterface::group::set(const UList<bodyInterface*>& all)
{
    pairs = all;
    List<const contactPairing*> pairings(pairs.size());
    forAll(pairs, i) pairings[i] = &pairs[i]->pairing();
    exchange.set(pairings);
}


void Foam::bodyInterface::group::startSlides()
{
    findValues
    (
        *this, &bodyInterface::slides_,
        [](const solidBody& body, const label node) { return body.slide(node); }
    );
}


void Foam::bodyInterface::group::exchangeForces()
{
    for (bodyInterface* pair : pairs)
    {
        pair->withNodes([&](auto N) { pair->solveNear<N.value>(); });
    }
    exchange.toCorners<nodeAnswer>
    (
        [&](const label i) -> auto& { return pairs[i]->toPlus_; },
        [&](const label i) -> auto& { return pairs[i]->toOwn_; },
        nodeAnswer()
    );
    for (bodyInterface* pair : pairs)
    {
        const bodyInterface& p = *pair;
        tell(p.minus_, p.minusCorners_, p.toMinus_);
        tell(p.plus_, p.pairing_->plusCorners(), p.toOwn_);
    }
}


void Foam::bodyInterface::startAnswers()
{
    toMinus_.setSize(minusCorners_.size());
    toPlus_.setSize(pairing_->nSlots());
    toMinus_ = nodeAnswer();
    toPlus_ = nodeAnswer();
}


void Foam::bodyInterface::group::findForces()
{
    for (bodyInterface* pair : pairs) pair->startForces();
    toSlots(*this, &bodyInterface::states_);
    for (bodyInterface* pair : pairs)
    {
        pair->startAnswers();
        pair->withNodes([&](auto N) { pair->findNear<N.value>(); });
        pair->found_ = pair->statistics_;
    }
}


void Foam::bodyInterface::find(const scalar)
{
    forget();
    if (!pairing_->active()) return;

    if (law().sticks()) alone_.startSlides();
    alone_.findForces();
}


void Foam::bodyInterface::askPushes(DynamicList<push>& all) const
{
    if (pairing_->active() && pushes(*minus_.body)) ask(all, *minus_.body);
}


void Foam::bodyInterface::limitPushes(const UList<push>& all, label& place)
{
    if (!pairing_->active() || !pushes(*minus_.body)) return;

    const scalar share = shareOf(all[place++]);
    if (share < 1)
    {
        withNodes([&](auto N) { limitNear<N.value>(share); });
    }
}


void Foam::bodyInterface::group::correctForces()
{
    findValues
    (
        *this, &bodyInterface::velocities_,
        [](const solidBody& body, const label node)
        {
            return body.contact().velocityWith(node);
        }
    );
    for (bodyInterface* pair : pairs)
    {
        pair->startAnswers();
        pair->withNodes([&](auto N) { pair->correctNear<N.value>(); });
        pair->statistics_ = pair->found_;
    }
    exchangeForces();
}


void Foam::bodyInterface::correct()
{
    if (pairing_->active()) alone_.correctForces();
}


void Foam::bodyInterface::tell
(
    const contactSide& side,
    const labelList& corners,
    const UList<nodeAnswer>& answers
)
{
    solidBody& body = *side.body;
    const labelList& cornerNode = side.geometry().cornerNode;
    forAll(corners, i)
    {
        const label k = corners[i];
        setState(side, k, answers[i]);
        body.contact().add(cornerNode[k], answers[i].nodeForce);
    }
}


Foam::scalar Foam::bodyInterface::taken
(
    const contactSide& side,
    const labelList& corners,
    const UList<nodeAnswer>& told,
    const scalar middle,
    blockWork& works
)
{
    const solidBody& body = *side.body;
    const labelList& node = side.geometry().cornerNode;
    const scalar counted = works.start(body, corners.size());
    forAll(corners, i)
    {
        works.add(body, i, node[corners[i]], middle*told[i].nodeForce);
    }
    const auto nodeOf = [&](const label i) { return node[corners[i]]; };
    return counted - works.find(body, nodeOf);
}


template<int nNodes>
void Foam::bodyInterface::slideOverlaps
(
    const scalar middle,
    const scalar deltaT
)
{
    const auto& kernel = std::get<overlapKernel<nNodes>>(kernels_);
    const labelList& minusNode = minus_.geometry().cornerNode;
    slideMemory& memory = minus_.body->contact().slide;

    for (const nearBlock<nNodes>& near : nearBlocks<nNodes>())
    {
        bool any = false;
        for (label k = 0; k < near.size; ++k)
        {
            any =
                any
             || near.problems[k].result.state
             != acousticRiemann::status::open;
        }
        if (!any) continue;

        // Velocity of the plus side relative to the minus side, in the step and
        // as mean with the one before
        const auto& b = kernel[near.block];
        const auto slip = [&](vector stepVelocities::* which)
        {
            const auto of = [&](const List<stepVelocities>& steps)
            {
                return [&steps, which](const label s) -> const vector&
                {
                    return steps[s].*which;
                };
            };
            return
                near.velocity(near.lever.plus, b.plus, of(steps_.plus))
              - near.velocity(near.lever.minus, b.minus, of(steps_.minus));
        };
        const auto way = slip(&stepVelocities::last);
        const auto mean = slip(&stepVelocities::mean);

        for (label k = 0; k < near.size; ++k)
        {
            const contactLaw::problem& p = near.problems[k];
            if (p.result.state == acousticRiemann::status::open) continue;

            const int l = near.lane[k];
            sumFriction
            (
                p, vector(mean[0][l], mean[1][l], mean[2][l]), middle
            );
            slideMemory::sums slid
            (
                slideBy
                (
                    p, vector(way[0][l], way[1][l], way[2][l]), deltaT
                )
            );
            memory.add(minusNode[minusCorners_[b.minus.slot[0][l]]], slid);
            slid.way = -slid.way;
            toPlusSlide_[b.plus.slot[0][l]] += slid;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyInterface::slide(const scalar middle, const scalar deltaT)
{
    if (!pairing_->active()) return;

    alone_.take(middle);
    if (law().sticks()) alone_.slide(middle, deltaT);
}


void Foam::bodyInterface::group::take(const scalar middle)
{
    for (bodyInterface* pair : pairs)
    {
        bodyInterface& p = *pair;
        p.account_.taken +=
            taken
            (
                p.minus_, p.minusCorners_, p.toMinus_, middle, p.minusWork_
            )
          + taken
            (
                p.plus_, p.pairing_->plusCorners(), p.toOwn_, middle,
                p.plusWork_
            );
    }
}


void Foam::bodyInterface::group::slide
(
    const scalar middle,
    const scalar deltaT
)
{
    findValues
    (
        *this, &bodyInterface::steps_,
        [](const solidBody& body, const label node)
        {
            return stepVelocities
            {
                body.stepVelocity(node), body.meanStepVelocity(node)
            };
        }
    );
    for (bodyInterface* pair : pairs)
    {
        pair->toPlusSlide_.setSize(pair->pairing_->nSlots());
        pair->toPlusSlide_ = slideMemory::sums();
        pair->withNodes([&](auto N)
        {
            pair->slideOverlaps<N.value>(middle, deltaT);
        });
    }
    exchange.toCorners<slideMemory::sums>
    (
        [&](const label i) -> auto& { return pairs[i]->toPlusSlide_; },
        [&](const label i) -> auto& { return pairs[i]->toOwnSlide_; },
        slideMemory::sums()
    );
    for (bodyInterface* pair : pairs)
    {
        const contactSide& plus = pair->plus_;
        const labelList& corners = pair->pairing_->plusCorners();
        const labelList& plusNode = plus.geometry().cornerNode;
        slideMemory& memory = plus.body->contact().slide;
        forAll(corners, i)
        {
            memory.add(plusNode[corners[i]], pair->toOwnSlide_[i]);
        }
    }
}


// ************************************************************************* //
