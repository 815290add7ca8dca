/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyInterface.H"
#include "solidBody.H"
#include "surfaceSelection.H"
#include "dictionaryCheck.H"
#include "bitSet.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sum, but the least gap and the largest status
struct combineAnswers
{
    template<class Answer>
    void operator()(Answer& a, const Answer& b) const
    {
        const scalar gap = min(a[7], b[7]), status = max(a[8], b[8]);
        forAll(a, i) a[i] += b[i];
        a[7] = gap;
        a[8] = status;
    }
};

} // End anonymous namespace


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


Foam::scalar Foam::bodyInterface::onMinus
(
    const scalar waySqr,
    const scalar minusTurns,
    const scalar plusTurns
)
{
    const scalar lengthsSqr = waySqr*max(minusTurns, plusTurns);
    return
        lengthsSqr < 4 ? 0.5
      : minusTurns > plusTurns ? 2/lengthsSqr
      : 1 - 2/lengthsSqr;
}


bool Foam::bodyInterface::readTwoWay(const dictionary& dict)
{
    const word transfer
    (
        dict.getOrDefault<word>("transfer", "conservative")
    );
    if (transfer != "conservative" && transfer != "twoWay")
    {
        dictionaryCheck::unknownModel
        (
            dict, "transfer", transfer, wordList({"conservative", "twoWay"})
        );
    }
    return transfer == "twoWay";
}


void Foam::bodyInterface::resize()
{
    const List<contactOverlap>& overlaps = pairing_->overlaps();

    closed_.setSize(overlaps.size(), false);
    problems_.setSize(overlaps.size());
    near_.clear();
    if (minus_.body->variational())
    {
        levers_.setSize(overlaps.size());
        near_.reserve(overlaps.size());

        const label n = minus_.body->corners(minus_.patchi).size();
        minusPosition_.setSize(n);
        bitSet overlap(n);
        for (const contactOverlap& o : overlaps)
        {
            for (label j = 0; j < o.minus.size; ++j)
            {
                overlap.set(o.minus.corner[j]);
            }
        }
        minusCorners_ = overlap.sortedToc();
    }

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
        pairing_->toCorners(plus, plusEqOp<scalar>(), scalar(0));
        pairing_->toSlots(plus);

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


void Foam::bodyInterface::send()
{
    const solidBody& body = *plus_.body;
    const cornerStates& P = body.corners(plus_.patchi);
    const scalarField& depth = body.depth(plus_.patchi);
    const pointField& points = body.mesh().points();

    const labelList& corners = pairing_->plusCorners();
    sent_.setSize(corners.size());
    forAll(corners, i)
    {
        const label k = corners[i];
        cornerMessage& m = sent_[i];
        const label node = P.geometry.cornerNode[k];
        const vector x(body.position(node));
        const vector X(points[body.dual().nodePoint()[node]]);
        for (direction c = 0; c < 3; ++c)
        {
            m[c] = P.v[k][c];
            m[3 + c] = P.t[k][c];
            m[6 + c] = P.n[k][c];
            m[9 + c] = x[c];
            m[15 + c] = X[c];
        }
        m[12] = P.stretch[k];
        m[13] = P.waveFactor[k];
        m[14] = depth[k];
    }
    pairing_->toSlots(sent_);
}


template<class Vectors>
Foam::scalar Foam::bodyInterface::range
(
    const label size,
    const Vectors& of,
    const vector& n
)
{
    scalar least = of(0) & n, most = least;
    for (label j = 1; j < size; ++j)
    {
        const scalar along = of(j) & n;
        least = min(least, along);
        most = max(most, along);
    }
    return most - least;
}


bool Foam::bodyInterface::apart
(
    const contactOverlap& over,
    const cornerStates& M,
    const vector& n,
    const scalar gap,
    const scalar closing,
    const scalar time
) const
{
    if (gap <= max(closing, scalar(0))*time) return false;

    const FixedList<label, 4>& minus = over.minus.corner;
    const FixedList<label, 4>& plus = over.plus.corner;
    const auto received = [&](const label j, const label i)
    {
        const cornerMessage& c = sent_[plus[j]];
        return vector(c[i], c[i + 1], c[i + 2]);
    };
    const scalar left =
        gap
      - range
        (
            over.minus.size,
            [&](const label j) { return minusPosition_[minus[j]]; }, n
        )
      - range
        (
            over.plus.size,
            [&](const label j) { return received(j, 9); }, n
        );
    if (left <= max(closing, scalar(0))*time) return false;

    const scalar fastest =
        closing
      + range
        (
            over.minus.size, [&](const label j) { return M.v[minus[j]]; }, n
        )
      + range
        (
            over.plus.size, [&](const label j) { return received(j, 0); }, n
        );
    return left > fastest*time;
}


void Foam::bodyInterface::solveForces(const bool firstStage)
{
    solidBody& body = *minus_.body;
    cornerStates& M = body.corners(minus_.patchi);
    cornerStates& P = plus_.body->corners(plus_.patchi);
    const scalarField& depth = body.depth(minus_.patchi);
    const List<contactOverlap>& overlaps = pairing_->overlaps();
    const scalar deltaT = body.contactStep();
    const bool bonded = law().bonded();
    const bool sticks = law().sticks();
    const scalar minusRho = body.material().rho();
    const scalar plusRho = plus_.body->material().rho();

    for (const label k : minusCorners_)
    {
        minusPosition_[k] = body.position(M.geometry.cornerNode[k]);
    }
    answers_.setSize(pairing_->nSlots());
    answers_ = noPlusMessage();
    near_.clear();

    forAll(overlaps, o)
    {
        const contactOverlap& over = overlaps[o];

        // The plus side at the centroid
        vector v(Zero), nPlus(Zero), xPlus(Zero);
        scalar plusStretch = 0, plusDepth = 0;
        for (label j = 0; j < over.plus.size; ++j)
        {
            const scalar N = over.plus.value[j];
            const cornerMessage& c = sent_[over.plus.corner[j]];
            v += N*vector(c[0], c[1], c[2]);
            nPlus += N*vector(c[6], c[7], c[8]);
            xPlus += N*vector(c[9], c[10], c[11]);
            plusStretch += N*c[12];
            plusDepth += N*c[14];
        }
        const vector between(xPlus - over.minus(minusPosition_));
        vector n;
        const bool opposed =
            contactOverlaps::commonNormal(over.minus(M.n), nPlus, n);
        const scalar distance = between & n;
        const contactLayer layer
        (
            contactLayer::side{over.minus(depth), minusRho},
            contactLayer::side{plusDepth, plusRho}
        );
        if
        (
            !bonded
         && (
                !opposed
             || apart
                (
                    over, M, n, distance, (over.minus(M.v) - v) & n,
                    layer.closingTime(M.zp, P.zp, deltaT)
                )
            )
        )
        {
            ++statistics_.nOpen;
            answerMessage open(noAnswer());
            open[7] = distance;
            setState(minus_, over.minus.corner[0], open, firstStage);
            scalar& told = answers_[over.plus.corner[0]][7];
            told = min(told, distance);
            continue;
        }

        const label i = near_.size();
        near_.append(o);
        contactLaw::problem& p = problems_[i];
        p.n = n;
        p.gap = distance;

        // The reference gap lies along the normal
        vector shift(Zero);
        if (bonded)
        {
            const pointField& points = body.mesh().points();
            vector atFirst(Zero);
            for (label j = 0; j < over.plus.size; ++j)
            {
                const cornerMessage& c = sent_[over.plus.corner[j]];
                atFirst += over.plus.value[j]*vector(c[15], c[16], c[17]);
            }
            for (label j = 0; j < over.minus.size; ++j)
            {
                const label node =
                    M.geometry.cornerNode[over.minus.corner[j]];
                atFirst -=
                    over.minus.value[j]*points[body.dual().nodePoint()[node]];
            }
            shift = between - p.gap*p.n;
            p.gap -= mag(atFirst)*sign(atFirst & referenceNormal(over));
        }
        else if (sticks)
        {
            shift = acousticRiemann::tangential
            (
                body.slide(M.geometry.cornerNode[over.minus.corner[0]]), p.n
            );
        }

        const scalar minusStretch = over.minus(M.stretch);
        levers& lever = levers_[i];
        const scalar minusTurns = lever.minus.setFace
        (
            over.minus,
            [&](const label j)
            {
                return minusPosition_[over.minus.corner[j]];
            },
            p.n
        );
        const scalar plusTurns = lever.plus.setFace
        (
            over.plus,
            [&](const label j)
            {
                const cornerMessage& c = sent_[over.plus.corner[j]];
                return vector(c[9], c[10], c[11]);
            },
            p.n
        );
        // Where the forces of both sides act: across the gap nearer to the side
        // that they turn less
        const vector along(between - distance*p.n);
        const vector middle
        (
            onMinus(magSqr(along), minusTurns, plusTurns)*along
          + plusTurns/(minusTurns + plusTurns)*distance*p.n
        );
        const scalar below = lever.minus.setPoint(middle);
        const scalar above = lever.plus.setPoint(middle - between);
        // Of the surfaces there, not of the points that were paired
        if (!bonded) p.gap = below - above;

        p.minus.v = p.plus.v = vector::zero;
        vector nMinus(Zero);
        nPlus = vector::zero;
        for (label j = 0; j < over.minus.size; ++j)
        {
            const label k = over.minus.corner[j];
            p.minus.v += lever.minus.velocity(j, M.v[k]);
            nMinus += lever.minus.weight(j)*M.n[k];
        }
        for (label j = 0; j < over.plus.size; ++j)
        {
            const cornerMessage& c = sent_[over.plus.corner[j]];
            p.plus.v += lever.plus.velocity(j, vector(c[0], c[1], c[2]));
            nPlus += lever.plus.weight(j)*vector(c[6], c[7], c[8]);
        }
        if (opposed) contactOverlaps::commonNormal(nMinus, nPlus, p.n);
        p.minus.zp = M.zp;
        p.minus.zs = M.zs;
        p.plus.zp = P.zp;
        p.plus.zs = P.zs;
        p.area = 0.5*(over.minus.area + over.plus.area);

        layer.set
        (
            p, 0.5*(minusStretch + plusStretch), opposed, bonded, shift, deltaT
        );
        countClosing(p, over.depth);
        if (opposed && p.gap < -lostDepth*over.depth && closed_[o])
        {
            lose(minus_, over.minus.corner[0], -p.gap, over.depth);
        }
    }

    solveProblems(near_.size());

    forAll(near_, i)
    {
        const contactOverlap& over = overlaps[near_[i]];
        const contactLaw::problem& p = problems_[i];
        count(p, over.width, over.depth, p.area, p.area);

        const answerMessage toMinus(answer(p, p.area, over.minus.area));
        const answerMessage toPlus(plusAnswer(p, p.area, over.plus.area));
        setState(minus_, over.minus.corner[0], toMinus, firstStage);
        plusMessage told(noPlusMessage());
        forAll(toPlus, k) told[k] = toPlus[k];
        combineAnswers()(answers_[over.plus.corner[0]], told);
        if (p.result.state == acousticRiemann::status::open)
        {
            continue;
        }

        // The transpose of what interpolated the velocities
        const vector force(p.area*p.result.t);
        for (label j = 0; j < over.minus.size; ++j)
        {
            M.force[over.minus.corner[j]] += levers_[i].minus.force(j, force);
        }
        for (label j = 0; j < over.plus.size; ++j)
        {
            plusMessage& f = answers_[over.plus.corner[j]];
            const vector share(levers_[i].plus.force(j, force));
            for (direction c = 0; c < 3; ++c) f[9 + c] -= share[c];
        }
    }

    pairing_->toCorners(answers_, combineAnswers(), noPlusMessage());
    const labelList& corners = pairing_->plusCorners();
    forAll(corners, c)
    {
        const label k = corners[c];
        const plusMessage& f = answers_[c];
        answerMessage state;
        forAll(state, i) state[i] = f[i];
        setState(plus_, k, state, firstStage);
        P.force[k] += vector(f[9], f[10], f[11]);
    }
}


Foam::vector Foam::bodyInterface::referenceNormal
(
    const contactOverlap& over
) const
{
    const solidBody& body = *minus_.body;
    const dualPatch& patch = body.corners(minus_.patchi).geometry;
    return body.expand
    (
        patch.cornerNormal.cdata() + body.dual().nDim()*over.minus.corner[0]
    );
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
    twoWay_(readTwoWay(dict)),
    pairing_(contactPairing::New(dict, minus_, plus_))
{
    if (twoWay_ && minus_.body->variational())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'transfer': twoWay belongs to the paper's scheme, "
            << "'preset paper' in controlDict. Valid transfers: (conservative)"
            << exit(FatalIOError);
    }
    rememberSlide(law(), minus_);
    resize();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::contactSide> Foam::bodyInterface::sides() const
{
    return List<contactSide>({minus_, plus_});
}


Foam::Pair<Foam::string> Foam::bodyInterface::sideNames() const
{
    // A surface with itself: the part that is met has another name
    return Pair<string>
    (
        minus_.body->name() + '.' + minus_.patchName,
        plus_.body->name() + '.' + plus_.patchName
      + (minus_ == plus_ ? ".opposite" : "")
    );
}


void Foam::bodyInterface::update(const scalar time, const bool)
{
    pairing_->update(time);
    resize();
}


void Foam::bodyInterface::remember()
{
    const dualPatch& patch =
        minus_.body->corners(minus_.patchi).geometry;
    const scalarField& status = minus_.body->contact().status;
    const List<contactOverlap>& overlaps = pairing_->overlaps();

    forAll(overlaps, o)
    {
        const label corner = overlaps[o].minus.corner[0];
        closed_[o] = status[patch.cornerNode[corner]] > 0.5;
    }
}


void Foam::bodyInterface::solve(const scalar, const bool firstStage)
{
    statistics_ = statistics();
    if (!pairing_->active())
    {
        return;
    }

    send();
    if (minus_.body->variational())
    {
        solveForces(firstStage);
        return;
    }

    cornerStates& M = minus_.body->corners(minus_.patchi);
    cornerStates& P = plus_.body->corners(plus_.patchi);

    // The Riemann problem of each overlap, per current area
    const List<contactOverlap>& overlaps = pairing_->overlaps();

    forAll(problems_, o)
    {
        const contactOverlap& over = overlaps[o];
        contactLaw::problem& p = problems_[o];

        // The plus side at the centroid
        cornerMessage m(scalar(0));
        for (label j = 0; j < over.plus.size; ++j)
        {
            const cornerMessage& c = sent_[over.plus.corner[j]];
            forAll(m, i) m[i] += over.plus.value[j]*c[i];
        }

        // The minus side
        vector x(Zero);
        for (label j = 0; j < over.minus.size; ++j)
        {
            x +=
                over.minus.value[j]
               *minus_.body->position
                (
                    M.geometry.cornerNode[over.minus.corner[j]]
                );
        }
        const scalar minusStretch = over.minus(M.stretch);
        const scalar plusStretch = m[12];
        const scalar minusFactor = over.minus(M.waveFactor);
        const scalar plusFactor = m[13];

        p.minus.v = over.minus(M.v);
        p.minus.t = over.minus(M.t)/minusStretch;
        p.minus.zp = impedance(minusFactor*M.zp, minusStretch);
        p.minus.zs = impedance(minusFactor*M.zs, minusStretch);
        p.plus.v = vector(m[0], m[1], m[2]);
        p.plus.t = -vector(m[3], m[4], m[5])/plusStretch;
        p.plus.zp = impedance(plusFactor*P.zp, plusStretch);
        p.plus.zs = impedance(plusFactor*P.zs, plusStretch);

        p.area =
            0.5*(over.minus.area*minusStretch + over.plus.area*plusStretch);

        const bool opposed = contactOverlaps::commonNormal
        (
            over.minus(M.n), vector(m[6], m[7], m[8]), p.n
        );
        p.gap = (vector(m[9], m[10], m[11]) - x) & p.n;
        setTouching(p, opposed, closed_[o], over.depth);
        if (closed_[o] && opposed && p.gap < -lostDepth*over.depth)
        {
            lose(minus_, over.minus.corner[0], -p.gap, over.depth);
        }
    }

    solveProblems();

    // Forces and velocities to both sides
    answers_.setSize(pairing_->nSlots());
    answers_ = noPlusMessage();

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
            scalar plusStretch = 0;
            for (label j = 0; j < over.plus.size; ++j)
            {
                plusStretch +=
                    over.plus.value[j]*sent_[over.plus.corner[j]][12];
            }
            minusForce = minusArea*over.minus(M.stretch);
            plusForce = plusArea*plusStretch;
        }

        count(p, over.width, over.depth, minusForce, plusForce);
        statistics_.frictionPower += minusForce*slipPower(p);

        const answerMessage toMinus(answer(p, minusForce, minusArea));
        const answerMessage toPlus(plusAnswer(p, plusForce, plusArea));

        setState(minus_, over.minus.corner[0], toMinus, firstStage);
        plusMessage told(noPlusMessage());
        forAll(toPlus, i) told[i] = toPlus[i];
        combineAnswers()(answers_[over.plus.corner[0]], told);

        if (p.result.state != acousticRiemann::status::open)
        {
            for (label j = 0; j < over.minus.size; ++j)
            {
                addFlux(M, over.minus.corner[j], toMinus, over.minus.flux[j]);
            }
            for (label j = 0; j < over.plus.size; ++j)
            {
                plusMessage& f = answers_[over.plus.corner[j]];
                for (label i = 0; i < 6; ++i)
                {
                    f[9 + i] += over.plus.flux[j]*toPlus[i];
                }
            }
        }
    }

    pairing_->toCorners(answers_, combineAnswers(), noPlusMessage());
    const labelList& corners = pairing_->plusCorners();
    forAll(corners, c)
    {
        const label k = corners[c];
        answerMessage state, flux;
        forAll(state, i) state[i] = answers_[c][i];
        for (label i = 0; i < 6; ++i) flux[i] = answers_[c][9 + i];
        setState(plus_, k, state, firstStage);
        addFlux(P, k, flux, 1);
    }
}


void Foam::bodyInterface::slide(const scalar middle, const scalar deltaT)
{
    if (!law().sticks() || !pairing_->active()) return;

    solidBody& body = *minus_.body;
    const labelList& minusNode =
        body.corners(minus_.patchi).geometry.cornerNode;
    const labelList& plusNode =
        plus_.body->corners(plus_.patchi).geometry.cornerNode;
    const labelList& corners = pairing_->plusCorners();
    slid_.setSize(corners.size());
    forAll(corners, i)
    {
        const label node = plusNode[corners[i]];
        const vector v(plus_.body->stepVelocity(node));
        const vector mean(plus_.body->meanStepVelocity(node));
        for (direction c = 0; c < 3; ++c)
        {
            slid_[i][c] = v[c];
            slid_[i][3 + c] = mean[c];
        }
    }
    pairing_->toSlots(slid_);

    const List<contactOverlap>& overlaps = pairing_->overlaps();
    forAll(near_, i)
    {
        const contactLaw::problem& p = problems_[i];
        if (p.result.state == acousticRiemann::status::open) continue;

        const contactOverlap& over = overlaps[near_[i]];
        const levers& lever = levers_[i];
        vector way(Zero), mean(Zero);
        for (label j = 0; j < over.plus.size; ++j)
        {
            const slideMessage& m = slid_[over.plus.corner[j]];
            way += lever.plus.velocity(j, vector(m[0], m[1], m[2]));
            mean += lever.plus.velocity(j, vector(m[3], m[4], m[5]));
        }
        for (label j = 0; j < over.minus.size; ++j)
        {
            const label node = minusNode[over.minus.corner[j]];
            way -= lever.minus.velocity(j, body.stepVelocity(node));
            mean -= lever.minus.velocity(j, body.meanStepVelocity(node));
        }
        const bool stuck = p.result.state == acousticRiemann::status::stick;
        body.addSlide
        (
            minusNode[over.minus.corner[0]],
            p.area,
            stuck
          ? deltaT*acousticRiemann::tangential(way, p.n)
          : vector::zero,
            kept(p)
        );
        account_.friction +=
            middle*p.area
           *(acousticRiemann::tangential(p.result.t, p.n) & mean);
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
