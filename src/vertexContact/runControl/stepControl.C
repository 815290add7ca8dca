/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include "controlKeywords.H"
#include "dictionaryCheck.H"
#include "wholeSteps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Largest maxCo without a warning: the bound itself
constexpr Foam::scalar largestCo = 1;

//- Part of a step by which a time to be written may be missed
constexpr Foam::scalar reached = 1e-3;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepControl::stepControl(const Time& runTime, const preset& defaults)
:
    time_(runTime),
    presetCo_(defaults.maxCo)
{
    controlKeywords::check(time_);
    if (maxCo() > largestCo)
    {
        WarningInFunction
            << "maxCo is " << maxCo() << ": above " << largestCo
            << " steps may be unstable (tests/robustness/stability.md)."
            << endl;
    }
    if (dict().found("maxEnergyRise"))
    {
        dictionaryCheck::require
        (
            maxEnergyRise() > 0, dict(), "maxEnergyRise", maxEnergyRise(),
            "positive"
        );
    }
    dictionaryCheck::require
    (
        minDeltaT(0) >= 0, dict(), "minDeltaT", minDeltaT(0), "at least 0"
    );
    if (!adjusts())
    {
        const scalar deltaT = dict().get<scalar>("deltaT");
        dictionaryCheck::require
        (
            deltaT > 0, dict(), "deltaT", deltaT, "positive"
        );
    }
    maxDeltaT();
    logInterval();
    if (dict().found("writeInterval"))
    {
        // With OpenFOAM's other controls, too, nothing would be written
        const scalar interval = dict().get<scalar>("writeInterval");
        dictionaryCheck::require
        (
            interval > 0, dict(), "writeInterval", interval, "positive"
        );
    }
    dictionaryCheck::require
    (
        contactIterations() > 0, dict(), "contactIterations",
        contactIterations(), "a positive integer"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::stepControl::maxCo() const
{
    const scalar maxCo = dict().getOrDefault("maxCo", presetCo_);
    dictionaryCheck::require(maxCo > 0, dict(), "maxCo", maxCo, "positive");
    return maxCo;
}


Foam::label Foam::stepControl::logInterval() const
{
    const label steps =
        dict().getOrDefault("logInterval", label(logIntervalDefault));
    dictionaryCheck::require
    (
        steps > 0, dict(), "logInterval", steps, "positive"
    );
    return steps;
}


Foam::scalar Foam::stepControl::maxDeltaT() const
{
    const scalar most = dict().getOrDefault("maxDeltaT", scalar(GREAT));
    dictionaryCheck::require(most > 0, dict(), "maxDeltaT", most, "positive");
    return most;
}


bool Foam::stepControl::logs(const label steps, const scalar time) const
{
    const bool last =
        time > time_.endTime().value() - 0.5*time_.deltaTValue();
    return last || steps % logInterval() == 0;
}


Foam::scalar Foam::stepControl::fittedInterval() const
{
    const word writeControl
    (
        dict().getOrDefault<word>("writeControl", "timeStep")
    );
    return
        writeControl == "adjustableRunTime" || writeControl == "adjustable"
      ? dict().get<scalar>("writeInterval")
      : GREAT;
}


Foam::scalar Foam::stepControl::nextFitted
(
    const scalar now,
    const scalar deltaT
) const
{
    scalar next = time_.endTime().value();
    const scalar interval = fittedInterval();
    if (interval < GREAT)
    {
        // Times are multiples of the interval, counted from the start of the
        // run as Time does; from zero where both are the same, so that a
        // restarted run takes the same steps to the last bit
        const scalar start = time_.startTime().value();
        const scalar offset =
            mag(start/interval - std::round(start/interval))
          < wholeSteps::roundOff
          ? 0 : start;
        const scalar slack =
            min(scalar(wholeSteps::roundOff), reached*deltaT/interval);
        const scalar k = std::floor((now - offset)/interval + slack) + 1;
        next = min(next, offset + k*interval);
    }
    return next;
}


Foam::scalar Foam::stepControl::fitted(const scalar bound) const
{
    const scalar deltaT = min(bound, maxDeltaT());
    const scalar now = time_.value();
    const scalar remaining = nextFitted(now, deltaT) - now;
    if (remaining <= 0) return deltaT;
    return remaining/max(scalar(1), wholeSteps::atLeast(remaining/deltaT));
}


Foam::scalar Foam::stepControl::stepsToEnd(const scalar deltaT) const
{
    const scalar now = time_.value();
    const scalar end = time_.endTime().value();
    if (!adjusts())
    {
        // As Time::run() ends
        return max(scalar(0), std::ceil((end - now)/deltaT - 0.5));
    }

    // Each interval between write times has steps of its own
    const auto steps = [=](const scalar interval)
    {
        return
            interval > 0
          ? max(scalar(0), wholeSteps::atLeast(interval/deltaT))
          : scalar(0);
    };
    const scalar next = nextFitted(now, deltaT);
    const scalar interval = fittedInterval();
    const scalar whole = wholeSteps::within((end - next)/interval);
    return
        steps(next - now) + whole*steps(interval)
      + steps(end - next - whole*interval);
}


// ************************************************************************* //
