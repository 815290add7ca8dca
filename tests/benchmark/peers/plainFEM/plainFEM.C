/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Textbook explicit finite elements for the cases of tests/benchmark/trade.
    README.md says what it does.

\*---------------------------------------------------------------------------*/

#include "cases.H"

#include <cstdlib>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

const char* usage =
    "plainFEM CASE ELEMENTS [-co C] [-viscosity B] [-samples N] [-out FILE]\n"
    "plainFEM verify\n"
    "    CASE        similar dissimilar rings incompressible nonMatching\n"
    "                taylor\n"
    "    ELEMENTS    along a bar, over the ring, the width, the radius (even)\n"
    "    -co         part of the largest stable step (0.9)\n"
    "    -viscosity  linear bulk viscosity (0.06)\n"
    "    -samples    rows of the table of histories (400, bars 4000)\n"
    "    -out        file of the table (standard output)\n";

[[noreturn]] void wrong(const std::string& what)
{
    throw std::runtime_error(what);
}

//- A number above least
double number(const std::string& what, const std::string& text, double least)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end || !(value > least) || value > 1e6)
    {
        wrong(what + " '" + text + "' is no number that it can be");
    }
    return value;
}

int integer(const std::string& what, const std::string& text)
{
    const double value = number(what, text, 0);
    if (value != int(value)) wrong(what + " '" + text + "' is not whole");
    return int(value);
}

plainFEM::settings parsed(const std::vector<std::string>& given)
{
    plainFEM::settings s;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < given.size(); ++i)
    {
        const std::string& key = given[i];
        if (key[0] != '-')
        {
            words.push_back(key);
            continue;
        }
        if (key != "-co" && key != "-viscosity" && key != "-samples"
         && key != "-out")
        {
            wrong("no option " + key);
        }
        if (++i == given.size()) wrong(key + " needs a value");
        if (key == "-co") s.co = number(key, given[i], 0);
        if (key == "-viscosity") s.viscosity = number(key, given[i], -1e-300);
        if (key == "-samples") s.samples = integer(key, given[i]);
        if (key == "-out") s.out = given[i];
    }
    if (words.size() != 2) wrong("it takes a case and a number of elements");
    s.name = words[0];
    s.elements = integer("ELEMENTS", words[1]);
    return s;
}

} // End namespace


// * * * * * * * * * * * * * * * * * * Main  * * * * * * * * * * * * * * * * //

int main(int argc, char** argv)
try
{
    const std::vector<std::string> given(argv + 1, argv + argc);
    if (given == std::vector<std::string>{"-h"})
    {
        std::fputs(usage, stdout);
        return 0;
    }
    if (given == std::vector<std::string>{"verify"})
    {
        return plainFEM::verify() ? 0 : 1;
    }
    plainFEM::runCase(parsed(given));
    return 0;
}
catch (const std::exception& error)
{
    std::fprintf(stderr, "plainFEM: %s (-h for help)\n", error.what());
    return 1;
}

// ************************************************************************* //
