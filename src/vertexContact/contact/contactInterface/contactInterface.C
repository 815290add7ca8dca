/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactInterface.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "IStringStream.H"
#include "Pair.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::contactSide Foam::contactInterface::readSide
(
    const dictionary& dict,
    PtrList<solidBody>& bodies,
    const label which
)
{
    wordList valid({"sides", "law"});
    valid.append(contactPairing::keywords());
    dictionaryCheck::onlyKeywords(dict, valid);

    const List<Pair<word>> sides(dict.get<List<Pair<word>>>("sides"));

    if (sides.size() != 2)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'sides' has " << sides.size() << " entries: it needs "
            << "two, each a region and a patch, as in "
            << "((bar1 right) (bar2 left))" << exit(FatalIOError);
    }
    if (sides[0] == sides[1])
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'sides' names the same side twice: " << sides[0]
            << ". The two sides of an interface must differ"
            << exit(FatalIOError);
    }

    wordList names(bodies.size());
    forAll(bodies, i)
    {
        names[i] = bodies[i].name();
        if (names[i] == sides[which].first())
        {
            const word& patch = sides[which].second();
            return contactSide
            {
                &bodies[i], bodies[i].contactPatch(dict, "sides", patch), patch
            };
        }
    }

    FatalIOErrorInFunction(dict)
        << "Keyword 'sides': there is no region '" << sides[which].first()
        << "'." << nl << "Regions: " << dictionaryCheck::listed(names).c_str()
        << exit(FatalIOError);

    return contactSide();
}


Foam::contactInterface::answerMessage Foam::contactInterface::noAnswer()
{
    answerMessage none(scalar(0));
    none[7] = GREAT;
    return none;
}


void Foam::contactInterface::apply
(
    const contactSide& side,
    const label corner,
    const answerMessage& answer,
    const bool newStatus
)
{
    cornerStates& c = side.body->corners(side.patchi);
    solidBody::contactOutput& out = side.body->contact();
    const label node = c.geometry.cornerNode[corner];

    out.gap[node] = min(out.gap[node], answer[7]);

    if (answer[8] > 0)
    {
        const vector force(answer[0], answer[1], answer[2]);
        c.tB[corner] += force/c.geometry.cornerArea[corner];
        c.vB[corner] += vector(answer[3], answer[4], answer[5]);
        c.released[corner] = false;
        out.force[node] += force;
        out.area[node] += answer[6];
        if (newStatus)
        {
            out.status[node] = max(out.status[node], answer[8]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactInterface::contactInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<solidBody>& bodies
)
:
    name_(name),
    minus_(readSide(dict, bodies, 0)),
    plus_(readSide(dict, bodies, 1)),
    pairing_(contactPairing::New(dict, minus_, plus_)),
    law_
    (
        contactLaw::New
        (
            dict.found("law")
          ? dict.subDict("law")
          : dictionary(IStringStream("type frictionless;")())
        )
    ),
    closed_(pairing_->minusCorner().size(), false),
    problems_(closed_.size()),
    gap_(closed_.size(), GREAT),
    sent_(plus_.body->corners(plus_.patchi).size()),
    answers_(sent_.size(), noAnswer()),
    impulse_(Zero),
    plusImpulse_(Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::contactInterface::remember()
{
    const dualPatch& patch =
        minus_.body->corners(minus_.patchi).geometry;
    const labelList& corner = pairing_->minusCorner();

    forAll(corner, o)
    {
        closed_[o] =
            minus_.body->contact().status[patch.cornerNode[corner[o]]] > 0.5;
    }
}


void Foam::contactInterface::solve(const bool firstStage)
{
    const cornerStates& M = minus_.body->corners(minus_.patchi);
    const cornerStates& P = plus_.body->corners(plus_.patchi);

    // States of the plus side to where the minus side is
    sent_.setSize(P.size());
    forAll(sent_, k)
    {
        cornerMessage& m = sent_[k];
        const vector x
        (
            plus_.body->position(P.geometry.cornerNode[k])
        );
        for (direction i = 0; i < 3; ++i)
        {
            m[i] = P.v[k][i];
            m[3 + i] = P.t[k][i];
            m[6 + i] = P.n[k][i];
            m[9 + i] = x[i];
        }
        m[12] = P.stretch[k];
        m[13] = P.geometry.cornerArea[k];
        m[14] = P.zp;
        m[15] = P.zs;
        m[16] = plus_.body->depth(plus_.patchi)[k];
    }
    if (pairing_->distributed())
    {
        pairing_->map().distribute(sent_);
    }
    answers_.setSize(sent_.size());
    answers_ = noAnswer();

    // The Riemann problem of each overlap, per current area
    const labelList& minusCorner = pairing_->minusCorner();
    const labelList& plusSlot = pairing_->plusSlot();
    const scalarField& minusShare = pairing_->minusShare();
    const scalarField& plusShare = pairing_->plusShare();
    const scalarField& minusDepth = minus_.body->depth(minus_.patchi);

    forAll(problems_, o)
    {
        const label k = minusCorner[o];
        const cornerMessage& m = sent_[plusSlot[o]];
        contactLaw::problem& p = problems_[o];

        const vector nPlus(m[6], m[7], m[8]);
        const vector x
        (
            minus_.body->position(M.geometry.cornerNode[k])
        );
        const scalar stretch = m[12];

        p.n = M.n[k] - nPlus;
        const scalar magN = mag(p.n);
        const bool opposed = magN > 1;
        p.n = opposed ? p.n/magN : M.n[k];

        p.minus.v = M.v[k];
        p.minus.t = M.t[k]/M.stretch[k];
        p.minus.zp = M.zp/M.stretch[k];
        p.minus.zs = M.zs/M.stretch[k];
        p.plus.v = vector(m[0], m[1], m[2]);
        p.plus.t = -vector(m[3], m[4], m[5])/stretch;
        p.plus.zp = m[14]/stretch;
        p.plus.zs = m[15]/stretch;

        p.area =
            0.5
           *(
                minusShare[o]*M.geometry.cornerArea[k]*M.stretch[k]
              + plusShare[o]*m[13]*stretch
            );

        gap_[o] = (vector(m[9], m[10], m[11]) - x) & p.n;
        const scalar h = min(minusDepth[k], m[16]);
        p.touching =
            law_->bonded()
         || (opposed && gap_[o] <= (closed_[o] ? openingGap : closingGap)*h);
    }

    law_->solve(problems_);

    // Forces and velocities to both sides
    statistics stats;
    forAll(problems_, o)
    {
        const label k = minusCorner[o];
        const label slot = plusSlot[o];
        const contactLaw::problem& p = problems_[o];
        const acousticRiemann::solution& s = p.result;

        answerMessage toMinus(noAnswer()), toPlus(noAnswer());
        toMinus[7] = toPlus[7] = gap_[o];
        if (p.touching && !law_->bonded())
        {
            stats.penetration = max(stats.penetration, -gap_[o]);
        }

        if (s.state == acousticRiemann::status::open)
        {
            ++stats.nOpen;
        }
        else
        {
            const bool slip = s.state == acousticRiemann::status::slip;
            const vector force(p.area*s.t);

            // A sliding surface keeps the tangential velocity of its nodes
            vector dMinus(s.vMinus - p.minus.v), dPlus(s.vPlus - p.plus.v);
            if (slip)
            {
                dMinus = (dMinus & p.n)*p.n;
                dPlus = (dPlus & p.n)*p.n;
            }

            for (direction i = 0; i < 3; ++i)
            {
                toMinus[i] = force[i];
                toPlus[i] = -force[i];
                toMinus[3 + i] = minusShare[o]*dMinus[i];
                toPlus[3 + i] = plusShare[o]*dPlus[i];
            }
            toMinus[6] = toPlus[6] = p.area;
            toMinus[8] = toPlus[8] = scalar(int(s.state));

            stats.force += force;
            stats.plusForce -= force;
            stats.area += p.area;
            stats.peakPressure = max(stats.peakPressure, -(s.t & p.n));
            ++(slip ? stats.nSlip : stats.nStick);
        }

        apply(minus_, k, toMinus, firstStage);

        answerMessage& a = answers_[slot];
        for (direction i = 0; i < 7; ++i) a[i] += toPlus[i];
        a[7] = min(a[7], toPlus[7]);
        a[8] = max(a[8], toPlus[8]);
    }

    if (pairing_->distributed())
    {
        // Assigns: a plus corner has one partner only (see matching)
        pairing_->map().reverseDistribute(P.size(), noAnswer(), answers_);
    }
    forAll(answers_, k)
    {
        apply(plus_, k, answers_[k], firstStage);
    }

    statistics_ = stats;
}


void Foam::contactInterface::accumulate(const scalar weightedDeltaT)
{
    impulse_ += weightedDeltaT*statistics_.force;
    plusImpulse_ += weightedDeltaT*statistics_.plusForce;
}


void Foam::contactInterface::setImpulse
(
    const vector& minus,
    const vector& plus
)
{
    impulse_ = minus;
    plusImpulse_ = plus;
}


void Foam::contactInterface::report(Ostream& os) const
{
    os  << "Interface " << name_ << ": " << minus_.body->name() << ' '
        << minus_.patchName << " - " << plus_.body->name() << ' '
        << plus_.patchName << ", pairing " << pairing_->type() << ", law "
        << law_->type() << nl;
}


// ************************************************************************* //
