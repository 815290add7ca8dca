/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepRatios.H"
#include "dictionaryCheck.H"
#include "wholeSteps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepRatios::stepRatios
(
    const dictionary& controlDict,
    const scalarField& nodes
)
:
    active_(wanted(controlDict)),
    allowed_
    (
        dictionaryCheck::readOptional<label>
        (
            controlDict, keywords(), "maxSubCycles"
        )
    ),
    nodes_(nodes),
    recent_(nodes.size())
{
    dictionaryCheck::require
    (
        allowed_ > 0, controlDict, "maxSubCycles", allowed_, "positive"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::stepRatios::wanted(const dictionary& controlDict)
{
    return dictionaryCheck::readOptional<bool>
    (
        controlDict, keywords(), "subCycling"
    );
}


Foam::keywordList Foam::stepRatios::keywords()
{
    return
    {
        {"subCycling", "", "no", "yes: each region has a time step of its own"},
        {
            "maxSubCycles", "-", "64",
            "largest number of steps of a region in a common step"
        }
    };
}


Foam::stepRatios::ratios Foam::stepRatios::of
(
    const scalar common,
    const scalarField& stable
) const
{
    const auto needed = [&](const scalar step)
    {
        return max(label(1), label(wholeSteps::atLeast(common/step)));
    };

    const label least = needed(min(stable));
    ratios best;
    for (label most = least; most <= least + least/perMore; ++most)
    {
        ratios r;
        r.most = most;
        r.steps.setSize(stable.size());
        forAll(stable, i)
        {
            // What is rigid takes the shortest: it has no blocks
            label n = nodes_[i] > 0 ? min(needed(stable[i]), most) : most;
            while (most % n) ++n;
            r.steps[i] = n;
            r.evaluations += n*nodes_[i];
        }
        if (best.steps.empty() || r.evaluations < best.evaluations) best = r;
    }
    return best;
}


Foam::scalar Foam::stepRatios::cost
(
    const scalar common,
    const scalarField& stable
) const
{
    return
        of(common, stable).evaluations/common*min(stable)
       /max(sum(nodes_), VSMALL);
}


Foam::scalar Foam::stepRatios::commonStep
(
    const scalarField& stable,
    const scalar longest
) const
{
    const scalar most =
        min(longest, min(max(stable), allowed_*min(stable)));
    scalar best = most, least = cost(most, stable);
    for (const scalar step : stable)
    {
        for (label n = 1; n <= tried; ++n)
        {
            if (n*step >= most) continue;
            const scalar its = cost(n*step, stable);
            if (its < (1 - alike)*least)
            {
                best = n*step;
                least = its;
            }
        }
    }
    return best;
}


Foam::scalarField Foam::stepRatios::least(const scalarField& stable)
{
    scalarField steps(stable.size());
    forAll(stable, i) steps[i] = recent_[i].of(stable[i]);
    return steps;
}


// ************************************************************************* //
