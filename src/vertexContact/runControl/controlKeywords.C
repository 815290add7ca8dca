/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controlKeywords.H"
#include "dictionaryCheck.H"
#include "preset.H"
#include "stepRatios.H"
#include "massScaling.H"
#include "massDamping.H"
#include "kineticRelaxation.H"
#include "Time.H"
#include "IFstream.H"
#include "Switch.H"
#include <regex>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Letters within which a keyword is taken for a misspelt one of ours
constexpr label close = 2;

//- Those of OpenFOAM and its programs
const wordList& others()
{
    static const wordList names
    ({
        "FoamFile", "application", "libs", "functions", "startFrom",
        "startTime", "beginTime", "stopAt", "endTime", "deltaT",
        "adjustTimeStep", "maxDeltaT", "maxDi", "maxAlphaCo", "writeControl",
        "writeInterval", "secondaryWriteControl", "secondaryWriteInterval",
        "purgeWrite", "writeFormat", "writeVersion", "writePrecision",
        "writeCompression", "timeFormat", "timePrecision", "graphFormat",
        "runTimeModifiable", "profiling", "cacheTemporaryObjects",
        "DebugSwitches", "InfoSwitches", "OptimisationSwitches",
        "DimensionedConstants", "DimensionSets", "Documentation"
    });
    return names;
}

enum class kind { number, text, onOff, dict };

struct control
{
    const char* name;
    kind type;
};

//- What the values of ours are
const control types[] =
{
    {"preset", kind::text}, {"maxCo", kind::number},
    {"timeIntegrator", kind::text}, {"adjustTimeStep", kind::onOff},
    {"minDeltaT", kind::number}, {"maxEnergyRise", kind::number},
    {"logInterval", kind::number}, {"subCycling", kind::onOff},
    {"maxSubCycles", kind::number}, {"contactIterations", kind::number},
    {"massScaling", kind::dict}, {"damping", kind::dict},
    {"relaxation", kind::dict}
};

//- A keyword of the file is used in it as a variable. The text, since a
//  dictionary that was read has its variables replaced
bool isVariable(const Time& runTime, const word& name)
{
    IFstream is(runTime.globalPath()/runTime.system()/"controlDict");
    if (!is.good()) return false;
    std::stringstream text;
    text<< is.stdStream().rdbuf();
    return std::regex_search
    (
        text.str(), std::regex("\\$[{:.^]*" + name + "\\b")
    );
}

void checkType(const dictionary& dict, const control& c)
{
    const word name(c.name);
    if (!dict.found(name)) return;
    if ((c.type == kind::dict) != dict.isDict(name))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << name << "' is "
            << (c.type == kind::dict ? "not a dictionary" : "a dictionary")
            << ": it must be "
            << (
                   c.type == kind::dict ? "one, as in its class's header"
                 : c.type == kind::number ? "a number"
                 : c.type == kind::onOff ? "yes or no" : "a word"
               )
            << exit(FatalIOError);
    }
    if (c.type == kind::dict) return;

    const ITstream& tokens = dict.lookup(name);
    const bool one = tokens.size() == 1;
    const token t(one ? tokens.first() : token());
    if
    (
        !one
     || (c.type == kind::number && !t.isNumber())
     || (c.type == kind::text && !t.isWord())
     || (
            c.type == kind::onOff && !t.isNumber()
         && !(
                t.isWord()
             && wordList
                ({
                    "yes", "no", "on", "off", "true", "false", "y", "n", "t",
                    "f", "none", "any"
                }).found(t.wordToken())
            )
        )
    )
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << name << "' is";
        for (const token& each : tokens) FatalIOError<< ' ' << each;
        FatalIOError
            << ": it must be "
            << (
                   c.type == kind::number ? "a number"
                 : c.type == kind::onOff ? "yes or no" : "a word"
               )
            << exit(FatalIOError);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::controlKeywords::keywords()
{
    const preset balanced(preset::kind::balanced);
    return
        keywordList
        ({
            {
                "preset", "", preset::names[balanced.name],
                keywordList::oneOf
                (
                    preset::names.toc(),
                    "options that trade speed for accuracy"
                )
            }
        })
      + balanced.keywords()
      + keywordList
        ({
            {
                "adjustTimeStep", "", "yes",
                "step from the state; no: deltaT"
            },
            {
                "minDeltaT", "s", "1e-6 of the first",
                "stable step that ends the run"
            },
            {
                "maxEnergyRise", "-", "none", "rise of energy that ends the run"
            },
            {"logInterval", "-", "100", "steps from log line to log line"}
        })
      + stepRatios::keywords()
      + keywordList
        ({
            {
                "contactIterations", "-", "1",
                "times that contact is solved in a step; 2 where it is only "
                "some faces wide"
            },
            {
                "massScaling", "", "none",
                "more mass for longer steps: a dictionary by region"
            }
        })
      + massScaling::keywords().within("massScaling/<region>")
      + keywordList
        ({
            {
                "damping", "", "none",
                "mass-proportional: a dictionary by region"
            }
        })
      + massDamping::keywords().within("damping/<region>")
      + keywordList
        ({
            {
                "relaxation", "", "none",
                "to the static state: a dictionary"
            }
        })
      + kineticRelaxation::keywords().within("relaxation");
}


void Foam::controlKeywords::check(const Time& runTime)
{
    const dictionary& dict = runTime.controlDict();
    const wordList ours(keywords().names());
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();
        if (key.isPattern() || ours.found(key) || others().found(key)) continue;

        const word nearest(dictionaryCheck::within(key, ours, close));
        if (nearest.size() && !isVariable(runTime, key))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword '" << key << "'. Did you mean '" << nearest
                << "'?" << nl << "Keywords of vertexContact here: "
                << dictionaryCheck::listed(ours).c_str() << nl
                << "A variable of yours is one that the file uses by $" << key
                << exit(FatalIOError);
        }
    }
    for (const control& c : types) checkType(dict, c);
}


// ************************************************************************* //
