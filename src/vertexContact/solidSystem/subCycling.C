/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "subCycling.H"
#include "bodyValues.H"
#include "bodiesOfKind.H"
#include "passTimes.H"
#include "rankRows.H"
#include "variationalBody.H"
#include "wholeSteps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::subCycling::solve
(
    const scalar time,
    const scalar deltaT,
    const scalarField& blocks,
    const scalarField& afters
)
{
    passTimes::timed(passTimes::contact, [&]
    {
        // All blocks are multiples; the shortest step is its own block. The
        // first common step has no earlier one to take a mean with
        const bool differ =
            last_.whole > 0 && wholeSteps::several(max(blocks), deltaT);
        forAll(bodies_, i)
        {
            const bool isLong = wholeSteps::several(blocks[i], deltaT);
            if (differ || isLong)
            {
                bodies_[i].contact().setBlock(deltaT, blocks[i]);
            }
            else
            {
                bodies_[i].contact().setStep(deltaT);
            }
            if (isLong) deforming_[i].placeSurface(afters[i]);
            bodies_[i].contact().clearAll();
        }
        contacts_.solve(time, true);
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::subCycling::subCycling
(
    const dictionary& controlDict,
    const stepControl& control,
    PtrList<solidBody>& bodies,
    UPtrList<leapfrogBody>& leaping,
    contactSystem& contacts,
    energyAccounts& accounts
)
:
    control_(control),
    bodies_(bodies),
    leaping_(leaping),
    deforming_(bodiesOfKind<variationalBody>(bodies)),
    contacts_(contacts),
    accounts_(accounts),
    ratios_(controlDict, countNodes(bodies))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::subCycling::countNodes
(
    const PtrList<solidBody>& bodies
)
{
    scalarField nodes(bodies.size(), Zero);
    forAll(bodies, i)
    {
        // No node of a rigid region is evaluated
        if (bodies[i].rigid()) continue;
        nodes[i] = returnReduce
        (
            scalar(bodies[i].dual().sharing().owned().count()), sumOp<scalar>()
        );
    }
    return nodes;
}


Foam::scalar Foam::subCycling::stableStep
(
    const scalarList& stable,
    boundWatch& bound
)
{
    const label n = bodies_.size();
    scalarList least(2*n + 1, scalar(GREAT));
    forAll(bodies_, i)
    {
        least[i] = stable[i];
        least[n + i] = -bodies_[i].fastestStretching();
    }
    // In a common step surfaces approach by no more than edges may shorten
    least[2*n] = contacts_.closingTime();
    combineOnAll(least, minEqOp<scalar>());

    bounds_.now.setSize(n);
    bounds_.longest = least[2*n];
    scalar fastestOfAll = 0;
    for (label i = 0; i < n; ++i)
    {
        bounds_.now[i] = least[i];
        const scalar fastest = -least[n + i];
        fastestOfAll = max(fastestOfAll, fastest);
        bounds_.longest = min
        (
            bounds_.longest,
            max(bounds_.now[i], stepRatios::strain/(fastest + VSMALL))
        );
    }
    bound.seen(fastestOfAll);
    return ratios_.commonStep(bounds_.now, bounds_.longest);
}


Foam::scalar Foam::subCycling::wantedStep(recentLeast& longest)
{
    bounds_.recent = ratios_.least(bounds_.now);

    // Forces act over the mean of two steps. After a longer step take a shorter
    // one whose mean with it is within the bound. So ratios stay as they are
    // while the step falls slowly: each change of a ratio causes an error. If
    // the step falls by a third or more at once, that does not matter
    const scalar bound =
        control_.maxCo()
       *ratios_.commonStep(bounds_.recent, longest.of(bounds_.longest));
    const scalar rest = 2*bound - last_.whole;
    return rest > 0.5*bound ? min(bound, rest) : bound;
}


Foam::scalar Foam::subCycling::Courant() const
{
    scalar most = 0;
    forAll(bounds_.now, i)
    {
        most = max(most, last_.whole/(steps_.steps[i]*bounds_.now[i]));
    }
    return most;
}


void Foam::subCycling::divide(const scalar deltaT)
{
    steps_ = ratios_.of
    (
        max(deltaT, 0.5*(last_.whole + deltaT)),
        control_.maxCo()*bounds_.recent
    );
}


void Foam::subCycling::evaluate
(
    const scalar time,
    const bool moved,
    const bool wavesAnew,
    const std::function<scalar()>& firstStep
)
{
    // The displacement of a body is half of its own step ahead of its momentum
    scalarField blocks(bodies_.size());
    forAll(bodies_, i)
    {
        blocks[i] = bodies_[i].lastStep();
        leaping_[i].evaluate
        (
            time - 0.5*(last_.whole - blocks[i]), wavesAnew
        );
    }
    if (moved) contacts_.pairMoved(time);
    for (leapfrogBody& body : leaping_)
    {
        body.keepFreeRates();
    }

    // As in solidSystem::evaluateForces
    const auto solveFor = [&](const scalar deltaT)
    {
        const scalarField afters(bodies_.size(), 0.5*last_.shortest);
        const auto inBlock = [&](const label i)
        {
            return
                deforming_.set(i)
             && wholeSteps::several(blocks[i], deltaT);
        };
        forAll(bodies_, i)
        {
            if (inBlock(i)) deforming_[i].startBlock();
        }
        solve
        (
            time - 0.5*(last_.whole - last_.shortest), deltaT, blocks, afters
        );
        forAll(bodies_, i)
        {
            if (inBlock(i)) deforming_[i].putSurfaceBack();
        }
    };
    solveFor(last_.shortest);
    if (last_.whole == 0 && contacts_.interfaces().size())
    {
        for (label i = 0; i < 2; ++i)
        {
            const scalar step = firstStep();
            const stepRatios::ratios r
            (
                ratios_.of(step, control_.maxCo()*bounds_.now)
            );
            forAll(blocks, k) blocks[k] = 0.5*step/r.steps[k];
            solveFor(0.5*step/r.most);
        }
    }
    for (leapfrogBody& body : leaping_)
    {
        body.addContactForces();
    }
}


Foam::label Foam::subCycling::leap
(
    const scalar start,
    const scalar deltaT
)
{
    const label n = bodies_.size();
    const scalar middle = 0.5*(last_.whole + deltaT);
    const label most = steps_.most;
    const scalar kick = middle/most;
    const scalar ahead = 0.5*last_.shortest;
    old_ = last_;

    // Short steps in a block, and how far the displacement is ahead after it
    labelList length(n);
    scalarField step(n), blocks(n), afters(n, ahead);
    forAll(bodies_, i)
    {
        length[i] = most/steps_.steps[i];
        blocks[i] = length[i]*kick;
        step[i] = steps_.steps[i] == 1 ? deltaT : blocks[i];
        leaping_[i].keepStart();
        leaping_[i].restoreFreeRates();
    }

    // Times of the displacements, counted from the instant of the momentum at
    // the start of the common step
    const auto timeOf = [&](const label i, const label j)
    {
        return
            start - 0.5*(old_.whole - bodies_[i].lastStep())
          + j*kick;
    };
    const auto leapOver = [&](const label i, const label j)
    {
        passTimes::timed(passTimes::update, [&]
        {
            leaping_[i].leap
            (
                timeOf(i, j),
                blocks[i] + 0.5*(step[i] - bodies_[i].lastStep()),
                blocks[i], step[i], accounts_.on(), accounts_[i]
            );
        });
    };

    label nBad = 0;
    for (label j = 0; j < most; ++j)
    {
        // The last common step has evaluated the first blocks, with contact
        forAll(bodies_, i)
        {
            const bool begins = j % length[i] == 0;
            if (begins && j)
            {
                leaping_[i].evaluate(timeOf(i, j), false);
                nBad += bodies_[i].nBad();
            }
            if (begins && length[i] > 1) deforming_[i].startBlock();
            if (length[i] > 1) afters[i] = ahead + (j % length[i])*kick;
        }
        if (j)
        {
            reduce(nBad, sumOp<label>());
            if (nBad) break;
            forAll(bodies_, i)
            {
                if (j % length[i]) continue;
                passTimes::timed
                (
                    passTimes::plasticity,
                    [&] { bodies_[i].commitPlasticity(accounts_[i]); }
                );
            }
            solve
            (
                start - 0.5*(old_.whole - old_.shortest) + j*kick,
                kick, blocks, afters
            );
        }

        forAll(bodies_, i)
        {
            if (length[i] > 1)
            {
                deforming_[i].addContactImpulse(kick, blocks[i]);
            }
            else
            {
                leaping_[i].addContactForces();
                leapOver(i, j);
            }
        }
        passTimes::timed(passTimes::contact, [&]
        {
            contacts_.slide(kick, most == 1 ? deltaT : kick);
        });
        forAll(bodies_, i)
        {
            if (length[i] > 1 && (j + 1) % length[i] == 0)
            {
                deforming_[i].endBlock();
                leapOver(i, j + 1 - length[i]);
            }
        }
    }
    last_ = {deltaT, most == 1 ? deltaT : kick};
    cost_.own += steps_.evaluations;
    cost_.one +=
        ratios_.nodes()*deltaT/(control_.maxCo()*min(bounds_.recent));
    return nBad;
}


void Foam::subCycling::read
(
    const dictionary& record,
    const dictionary& controlDict
)
{
    last_.whole = record.getOrDefault<scalar>("lastStep", 0);
    last_.shortest = record.getOrDefault<scalar>("shortStep", last_.whole);
    if (record.found("shortStep") && !active())
    {
        FatalIOErrorInFunction(controlDict)
            << "Keyword 'subCycling' is no, but the earlier run, which this "
            << "run continues, had subCycling: it must be yes. "
            << "'maxSubCycles 1' gives all regions one step."
            << exit(FatalIOError);
    }
}


void Foam::subCycling::write(Ostream& os) const
{
    if (active()) os << "shortStep " << last_.shortest << ';' << nl;
}


void Foam::subCycling::write(const label bodyi, Ostream& os) const
{
    if (!active()) return;
    os  << "    lastStep " << bodies_[bodyi].lastStep() << ';' << nl;
    ratios_.write(bodyi, os);
}


void Foam::subCycling::report
(
    const scalarField& stable,
    Ostream& os
) const
{
    if (active() && steps_.steps.size())
    {
        os  << "Steps of their own (subCycling), now:";
        writeBodyValues(os, bodies_, steps_.steps, "");
        os  << " in " << last_.whole << " s; so far " << cost_.own
            << " evaluations of nodes, " << cost_.own/max(cost_.one, VSMALL)
            << " of the " << cost_.one << " that one step for all needs"
            << nl;
        return;
    }
    const scalar common = ratios_.commonStep(stable, bounds_.longest);
    const stepRatios::ratios r(ratios_.of(common, stable));
    if (max(r.steps) == 1) return;

    os  << "With steps of their own (subCycling yes),";
    writeBodyValues(os, bodies_, r.steps, "");
    os  << " in " << common << " s times maxCo, nodes would be evaluated "
        << ratios_.cost(common, stable) << " times as often" << nl
        << "    A region has one step, even if only a few of its cells are "
        << "small or stiff. To give them a step of their own, make them a "
        << "region of their own, tied to the rest" << nl;
}


// ************************************************************************* //
