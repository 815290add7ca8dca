/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactExchange.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::contactExchange::allow(const label width)
{
    for (neighbour& n : neighbours_)
    {
        if (n.corners.size() < width*n.nCorners)
        {
            n.corners.setSize(width*n.nCorners);
        }
        if (n.slots.size() < width*n.nSlots) n.slots.setSize(width*n.nSlots);
    }
}


void Foam::contactExchange::exchange(const label width, const bool back)
{
    const label start = UPstream::nRequests();
    for (neighbour& n : neighbours_)
    {
        SubList<scalar> in
        (
            back ? n.corners : n.slots,
            width*(back ? n.nCorners : n.nSlots)
        );
        rankExchange::startReceive(n.rank, in);
    }
    for (const neighbour& n : neighbours_)
    {
        const SubList<scalar> out
        (
            back ? n.slots : n.corners,
            width*(back ? n.nSlots : n.nCorners)
        );
        rankExchange::startSend(n.rank, out);
    }
    UPstream::waitRequests(start);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::contactExchange::set(const UList<const contactPairing*>& pairings)
{
    pairings_ = pairings;
    DynamicList<neighbour> all;
    for (label rank = 0; rank < UPstream::nProcs(); ++rank)
    {
        if (rank == UPstream::myProcNo()) continue;
        neighbour n;
        n.rank = rank;
        for (const contactPairing* pairing : pairings_)
        {
            const mapDistribute* map = pairing->map();
            if (!map) continue;
            n.nCorners += map->subMap()[rank].size();
            n.nSlots += map->constructMap()[rank].size();
        }
        if (n.nCorners + n.nSlots == 0) continue;
        all.append(n);
    }
    neighbours_.transfer(all);
}


// ************************************************************************* //
