/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodeMessage.H"

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::string Foam::nodeMessage::here
(
    const PtrList<solidBody>& bodies,
    const std::function<label(const solidBody&)>& find
)
{
    for (const solidBody& body : bodies)
    {
        const label node = find(body);
        if (node >= 0)
        {
            return "region " + body.name() + ", " + body.whereIs(node);
        }
    }
    return string();
}


Foam::string Foam::nodeMessage::firstOf(const string& message)
{
    List<string> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = message;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    for (const string& s : all)
    {
        if (s.size()) return s;
    }
    return message;
}


// ************************************************************************* //
