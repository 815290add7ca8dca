/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Checks of user input, and what their messages say.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "dictionaryCheck.H"
#include "dimensionSets.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::dictionaryCheck;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

dictionary dictFrom(const std::string& text, const char* name = "system/aDict")
{
    IStringStream is(text);
    dictionary dict(is);
    dict.name() = name;
    return dict;
}


//- The call fails with all these words in its message
template<class Function>
void refused
(
    const Function& call,
    const std::initializer_list<const char*>& words
)
{
    const string message(errorMessage(call));
    INFO(message);
    CHECK_FALSE(message.empty());
    for (const char* word : words)
    {
        INFO("expected: " << word);
        CHECK(message.find(word) != std::string::npos);
    }
}


enum class colour { red, green };

const Enum<colour> colourNames
({
    { colour::red, "red" },
    { colour::green, "green" }
});

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("nearest word", "[dictionaryCheck][serial]")
{
    const wordList valid({"pairing", "law", "sides", "transfer"});
    CHECK(nearest("pairing", valid) == "pairing");
    CHECK(nearest("paring", valid) == "pairing");       // deleted
    CHECK(nearest("ppairing", valid) == "pairing");     // inserted
    CHECK(nearest("pairimg", valid) == "pairing");      // substituted
    CHECK(nearest("ride", valid) == "sides");           // substituted, deleted
    CHECK(nearest("lawn", valid) == "law");
    CHECK(nearest("", valid) == "");
    CHECK(nearest("zqx", valid) == "");                 // nothing like it
    CHECK(nearest("tranfsers", valid) == "transfer");

    // In doubt, the first
    CHECK(nearest("ac", wordList({"ab", "ad"})) == "ab");
    CHECK(nearest("x", wordList()) == "");
}


TEST_CASE("only known keywords", "[dictionaryCheck][serial]")
{
    const wordList valid({"pairing", "law"});
    const auto check = [&](const std::string& text)
    {
        onlyKeywords(dictFrom(text), valid);
    };

    CHECK(errorMessage([&]{ check(""); }) == "");
    CHECK(errorMessage([&]{ check("law a; pairing b;"); }) == "");
    CHECK(errorMessage([&]{ check("law { anything inside; }"); }) == "");
    CHECK(errorMessage([&]{ check("FoamFile { class c; } law a;"); }) == "");

    refused
    (
        [&]{ check("law a; paring b;"); },
        {"system/aDict", "'paring'", "'pairing'", "Valid keywords", "law"}
    );
    refused([&]{ check("Law { }"); }, {"'Law'", "'law'"});
    refused([&]{ check("\".*\" a;"); }, {".*"});
}


TEST_CASE("numbers", "[dictionaryCheck][serial]")
{
    const auto read = [](const std::string& text, const dimensionSet& dims)
    {
        return readNumber(dictFrom(text), "height", dims);
    };

    CHECK(read("height 2;", dimLength) == 2);
    CHECK(read("height -1.5e-3;", dimLength) == -1.5e-3);
    CHECK(read("height [0 1 0 0 0 0 0] 3;", dimLength) == 3);
    CHECK(read("height [m] 4;", dimLength) == 4);
    CHECK(read("height [] 5;", dimless) == 5);
    CHECK(read("h 7; height $h;", dimLength) == 7);

    refused
    (
        [&]{ read("hight 2;", dimLength); },
        {"system/aDict", "'height'", "missing", "[0 1 0 0 0 0 0]"}
    );
    refused
    (
        [&]{ read("height [0 0 1 0 0 0 0] 2;", dimLength); },
        {"height", "[0 1 0 0 0 0 0]", "[0 0 1 0 0 0 0]"}
    );
    for (const char* value : {"nan", "inf", "tall", "[0 1 0 0 0 0 0] nan"})
    {
        refused
        (
            [&]{ read(std::string("height ") + value + ";", dimLength); },
            {"system/aDict", "'height'", "not a finite number"}
        );
    }
    for (const char* value : {"-nan", "-inf", "(1 2)", "1 2", ""})
    {
        refused
        (
            [&]{ read(std::string("height ") + value + ";", dimLength); },
            {"height"}
        );
    }
}


TEST_CASE("optional numbers", "[dictionaryCheck][serial]")
{
    const dictionary dict(dictFrom("a 2; b [0 1 0 0 0 0 0] 2; c nan;"));
    CHECK(readNumberOrDefault(dict, "a", dimless, 3) == 2);
    CHECK(readNumberOrDefault(dict, "missing", dimless, 3) == 3);
    refused([&]{ readNumberOrDefault(dict, "b", dimless, 3); }, {"b"});
    refused([&]{ readNumberOrDefault(dict, "c", dimless, 3); }, {"'c'"});
}


TEST_CASE("rules", "[dictionaryCheck][serial]")
{
    const dictionary dict(dictFrom(""));
    CHECK
    (
        errorMessage([&]{ require(true, dict, "height", 1, "positive"); }) == ""
    );
    refused
    (
        [&]{ require(false, dict, "height", -1.5, "positive"); },
        {"system/aDict", "'height'", "-1.5", "must be positive"}
    );
}


TEST_CASE("names of models", "[dictionaryCheck][serial]")
{
    const dictionary dict(dictFrom(""));
    refused
    (
        [&]
        {
            unknownModel
            (
                dict, "law", "Colomb",
                wordList({"tied", "Coulomb", "frictionless"})
            );
        },
        {
            "system/aDict", "'law'", "'Colomb'", "Did you mean 'Coulomb'?",
            "(Coulomb frictionless tied)"
        }
    );
}


TEST_CASE("names out of a fixed set", "[dictionaryCheck][serial]")
{
    const dictionary dict(dictFrom("front green; back rod; side (1 2);"));
    const auto read = [&](const word& keyword)
    {
        return readEnum(colourNames, dict, keyword, colour::red);
    };
    CHECK(read("front") == colour::green);
    CHECK(read("missing") == colour::red);
    refused
    (
        [&]{ read("back"); },
        {"system/aDict", "'back'", "'rod'", "'red'", "green"}
    );
    refused([&]{ read("side"); }, {"side"});
}


TEST_CASE("errors in a sub-dictionary name it", "[dictionaryCheck][serial]")
{
    const dictionary dict(dictFrom("bars { law { k 1; } }"));
    refused
    (
        [&]
        {
            onlyKeywords
            (
                dict.subDict("bars").subDict("law"), wordList({"frictionCoeff"})
            );
        },
        {"bars", "law", "'k'", "(frictionCoeff)"}
    );
}


// ************************************************************************* //
