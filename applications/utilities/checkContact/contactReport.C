/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactReport.H"
#include <algorithm>
#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactReport::contactReport(const contactInterface& contact)
:
    sides_(contact.sideNames()),
    width_
    (
        2 + std::max
        (
            std::size_t(12), std::max(side(0).size(), side(1).size())
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::contactReport::text(const label value)
{
    return std::to_string(value);
}


std::string Foam::contactReport::text(const scalar value)
{
    std::ostringstream os;
    os  << value;
    return os.str();
}


std::string Foam::contactReport::text(const vector& value)
{
    return
        '(' + text(value.x()) + ' ' + text(value.y()) + ' ' + text(value.z())
      + ')';
}


void Foam::contactReport::head(const label nSides) const
{
    if (nSides == 1)
    {
        row("", {side(0)});
    }
    else
    {
        row("", {side(0), side(1)});
    }
}


void Foam::contactReport::row
(
    const char* name,
    std::initializer_list<std::string> values
) const
{
    std::string line("    ");
    line += name;
    line.resize(std::max(line.size(), std::size_t(38)), ' ');
    for (const std::string& value : values)
    {
        const std::size_t n = value.size();
        line += std::string(n + 2 < width_ ? width_ - n : 2, ' ') + value;
    }
    Info<< line.c_str() << nl;
}


void Foam::contactReport::check(const bool good, const std::string& message)
{
    if (!good)
    {
        ++nFailed_;
        Info<< "  ***" << message.c_str() << nl;
    }
}


// ************************************************************************* //
