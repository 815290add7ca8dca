/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "passTimes.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "scalarField.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

bool Foam::passTimes::wanted_ = false;
double Foam::passTimes::seconds_[nPasses] = {};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- In the order of passTimes::pass
const char* const names[] =
{
    "velocities", "gradients", "inverses", "corrections", "kinematics",
    "volume", "stress", "wave speeds", "boundaries", "fluxes", "adjoint",
    "forces", "update", "plasticity", "contact", "stable step", "processors"
};

static_assert
(
    sizeof(names)/sizeof(names[0]) == Foam::passTimes::nPasses,
    "a name of each pass"
);

//- Time for which the loop that measures the bandwidth is repeated [s]
constexpr double loopSeconds = 0.1;

//- Least share of a step with which a pass is listed
constexpr Foam::scalar leastShare = 5e-4;

} // End anonymous namespace


// * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * * //

Foam::scalar Foam::passTimes::bandwidth()
{
    // Larger than the caches
    constexpr label n = 1 << 22;
    typedef std::chrono::steady_clock clock;
    scalarField a(n, Zero), b(n, scalar(1)), c(n, scalar(2));
    const auto since = [](const clock::time_point& start)
    {
        return std::chrono::duration<double>(clock::now() - start).count();
    };
    double least = GREAT;
    const clock::time_point start = clock::now();
    do
    {
        const clock::time_point one = clock::now();
        for (label i = 0; i < n; ++i) a[i] = b[i] + 3*c[i];
        least = min(least, since(one));
        // Use the result, so that the loop is not optimised away
        b[0] = a[n - 1];
    }
    while (since(start) < loopSeconds);

    return 3*sizeof(scalar)*scalar(n)/least;
}


void Foam::passTimes::report
(
    OSstream& os,
    const scalar stepSeconds,
    const scalar nodeSteps,
    const scalar bytes
)
{
    const scalar perRank = 1.0/Pstream::nProcs();
    const scalar microseconds = 1e6/nodeSteps;
    os  << "Passes, in us per node and step, and in % of the time of the "
        << "steps:" << nl;
    const auto line = [&](const char* name, const scalar seconds)
    {
        os  << "    " << name << ": " << microseconds*seconds << ", "
            << std::round(1e3*seconds/stepSeconds)/10 << " %" << nl;
    };
    scalar rest = stepSeconds;
    for (int p = 0; p < nPasses; ++p)
    {
        const scalar mean =
            perRank*returnReduce(scalar(seconds_[p]), sumOp<scalar>());
        rest -= mean;
        if (mean > leastShare*stepSeconds) line(names[p], mean);
    }
    line("other", rest);

    // A step moves at least all that is stored, once
    const scalar moved = bytes*nodeSteps*perRank/stepSeconds;
    const scalar most =
        perRank*returnReduce(bandwidth(), sumOp<scalar>());
    os  << "Memory: if a step reads all stored data once, it moves "
        << 1e-9*moved << " GB/s on a core, " << moved/most
        << " of the bandwidth of a simple loop" << nl << nl;
}


// ************************************************************************* //
