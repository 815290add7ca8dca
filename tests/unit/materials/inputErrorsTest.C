/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Errors in mechanicalProperties: the message names the keyword.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "materialPoint.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

//- Checks that the dictionary is refused, with all these words in the message
void refused
(
    const std::string& text,
    const std::initializer_list<const char*>& words
)
{
    const string message(errorMessage([&]{ materialFrom(text); }));
    INFO(text << " -> " << message);
    CHECK_FALSE(message.empty());
    for (const char* word : words)
    {
        INFO("expected: " << word);
        CHECK(message.find(word) != std::string::npos);
    }
}


void accepted(const std::string& text)
{
    CHECK(errorMessage([&]{ materialFrom(text); }) == "");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("material input that is right", "[materials][serial]")
{
    accepted("type linearElastic; rho 1; E 1; nu 0.3;");
    accepted("type neoHookean; rho 1e-3; mu 1e9; kappa 1e12;");
    accepted("type neoHookean; rho 1; E 1; nu -0.99;");
    accepted("type neoHookean; rho 1; mu 1; lambda -0.6;");
    accepted("type MooneyRivlin; rho 1; mu 1; lambda 1; xi 0;");
    accepted
    (
        "type neoHookean; rho [1 -3 0 0 0 0 0] 8930;"
        "E [1 -1 -2 0 0 0 0] 5.85e8; nu [0 0 0 0 0 0 0] 0.495;"
    );
    accepted
    (
        "FoamFile { version 2.0; format ascii; class dictionary; object o; }"
        "type neoHookean; rho 1; E 1; nu 0.3;"
    );

    const auto model
    (
        materialFrom
        (
            "type linearElastic; rho [1 -3 0 0 0 0 0] 8930;"
            "mu [1 -1 -2 0 0 0 0] 3; kappa 5;"
        )
    );
    CHECK(model->type() == "linearElastic");
    CHECK(model->rho() == 8930);
    CHECK(model->mu() == 3);
    CHECK(model->kappa() == 5);
}


TEST_CASE("unknown keywords and laws", "[materials][serial]")
{
    refused
    (
        "type neoHookean; rho 1; E 1; nu 0.3; kapa 1;",
        {"kapa", "kappa", "rho", "lambda"}
    );
    refused("type neoHookean; rho 1; E 1; Nu 0.3;", {"'Nu'", "'nu'"});
    refused("type neoHookean; rho 1; E 1; nu 0.3; xi 0;", {"'xi'"});
    refused
    (
        "type MooneyRivlin; rho 1; E 1; nu 0.3; xsi 0;", {"'xsi'", "'xi'"}
    );
    refused
    (
        "type neoHokean; rho 1; E 1; nu 0.3;",
        {
            "type", "'neoHokean'", "'neoHookean'",
            "linearElastic", "MooneyRivlin"
        }
    );
    refused("rho 1; E 1; nu 0.3;", {"type"});
}


TEST_CASE("elastic constants come in one pair", "[materials][serial]")
{
    refused
    (
        "type neoHookean; rho 1; E 1; nu 0.3; mu 1; kappa 1;",
        {"E", "nu", "mu", "kappa", "exactly one"}
    );
    for
    (
        const char* given :
        {
            "", "E 1;", "nu 0.3;", "E 1; mu 1;", "kappa 1; lambda 1;",
            "nu 0.3; kappa 1;", "mu 1; kappa 1; lambda 1;"
        }
    )
    {
        refused
        (
            std::string("type neoHookean; rho 1; ") + given,
            {"exactly one", "(E nu)", "(mu lambda)", "(mu kappa)"}
        );
    }
}


TEST_CASE("values out of range", "[materials][serial]")
{
    const auto out = [](const std::string& entries, const char* keyword)
    {
        refused("type MooneyRivlin; " + entries, {keyword});
    };
    out("rho 0; E 1; nu 0.3; xi 0;", "'rho'");
    out("rho -1; E 1; nu 0.3; xi 0;", "'rho'");
    out("rho 1; E 0; nu 0.3; xi 0;", "'E'");
    out("rho 1; E -1; nu 0.3; xi 0;", "'E'");
    out("rho 1; E 1; nu 0.5; xi 0;", "'nu'");
    out("rho 1; E 1; nu 0.7; xi 0;", "'nu'");
    out("rho 1; E 1; nu -1; xi 0;", "'nu'");
    out("rho 1; mu 0; kappa 1; xi 0;", "'mu'");
    out("rho 1; mu -1; kappa 1; xi 0;", "'mu'");
    out("rho 1; mu -1; lambda 1; xi 0;", "'mu'");
    out("rho 1; mu -2; lambda 1; xi 0;", "'mu'");
    out("rho 1; mu 1; kappa 0; xi 0;", "'kappa'");
    out("rho 1; mu 1; kappa -1; xi 0;", "'kappa'");
    out("rho 1; mu 1; lambda -0.7; xi 0;", "'lambda'");
    out("rho 1; mu 1; kappa 1; xi -0.1;", "'xi'");
    // xi < mu/(3 sqrt(3)) = 0.19245
    out("rho 1; mu 1; kappa 1; xi 0.1925;", "'xi'");
    accepted("type MooneyRivlin; rho 1; mu 1; kappa 1; xi 0.1924;");
}


TEST_CASE("missing values", "[materials][serial]")
{
    refused("type neoHookean; E 1; nu 0.3;", {"'rho'", "[1 -3 0 0 0 0 0]"});
    refused
    (
        "type MooneyRivlin; rho 1; E 1; nu 0.3;",
        {"'xi'", "[1 -1 -2 0 0 0 0]"}
    );
    refused("type neoHookean; rho; E 1; nu 0.3;", {"rho"});
}


TEST_CASE("wrong dimensions", "[materials][serial]")
{
    refused
    (
        "type neoHookean; rho [1 -1 -2 0 0 0 0] 100; E 1; nu 0.3;",
        {"rho", "[1 -3 0 0 0 0 0]", "[1 -1 -2 0 0 0 0]"}
    );
    refused("type neoHookean; rho 1; E [1 -3 0 0 0 0 0] 1; nu 0.3;", {"E"});
    refused("type neoHookean; rho 1; E 1; nu [1 0 0 0 0 0 0] 0.3;", {"nu"});
}


TEST_CASE("what is not a finite number", "[materials][serial]")
{
    for (const char* value : {"nan", "-nan", "inf", "-inf", "steel"})
    {
        refused
        (
            std::string("type neoHookean; rho ") + value + "; E 1; nu 0.3;",
            {"'rho'", "not a finite number"}
        );
        refused
        (
            std::string("type MooneyRivlin; rho 1; E 1; nu 0.3; xi ") + value
          + ";",
            {"'xi'", "not a finite number"}
        );
    }
    refused("type neoHookean; rho (1 2 3); E 1; nu 0.3;", {"rho"});
    refused("type neoHookean; rho 1 2; E 1; nu 0.3;", {"rho"});
}


// ************************************************************************* //
