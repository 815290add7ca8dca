/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stopSignals.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const int Foam::stopSignals::signals[] = {SIGUSR1, SIGUSR2, SIGTERM};

const Foam::stopSignals::request Foam::stopSignals::requests[] =
    {write, writeAndEnd, writeAndEnd};

volatile std::sig_atomic_t Foam::stopSignals::latest_ = nothing;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::stopSignals::note(int signal)
{
    for (int i = 0; i < nSignals; ++i)
    {
        if (signal == signals[i] && requests[i] > latest_)
        {
            latest_ = requests[i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stopSignals::stopSignals()
{
    latest_ = nothing;

    struct sigaction action = {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (int i = 0; i < nSignals; ++i)
    {
        sigaction(signals[i], nullptr, &old_[i]);
        if (old_[i].sa_handler != SIG_IGN)
        {
            sigaction(signals[i], &action, nullptr);
        }
    }
}


Foam::stopSignals::~stopSignals()
{
    for (int i = 0; i < nSignals; ++i)
    {
        sigaction(signals[i], &old_[i], nullptr);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::stopSignals::request Foam::stopSignals::take()
{
    const request asked = request(int(latest_));
    if (asked != nothing) latest_ = nothing;
    return asked;
}


// ************************************************************************* //
