/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controlKeywords.H"
#include "dictionaryCheck.H"
#include "dictionaryText.H"
#include "preset.H"
#include "stepControl.H"
#include "stepRatios.H"
#include "massScaling.H"
#include "massDamping.H"
#include "kineticRelaxation.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Letters within which a keyword is taken for a misspelt one where it may be
//  a variable of a file that was not seen, or of one that others include, too
constexpr label close = 2;

//- Those that OpenFOAM itself reads here, in all releases from v1912 on
const wordList& others()
{
    static const wordList names
    ({
        "FoamFile", "application", "libs", "functions", "startFrom",
        "startTime", "stopAt", "endTime", "deltaT", "writeControl",
        "writeInterval", "writeFrequency", "purgeWrite", "writeFormat",
        "writeVersion", "writePrecision", "writeCompression", "timeFormat",
        "timePrecision", "graphFormat", "runTimeModifiable", "profiling",
        "cacheTemporaryObjects", "DebugSwitches", "InfoSwitches",
        "OptimisationSwitches", "DimensionedConstants", "DimensionSets"
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
    {"minDeltaT", kind::number}, {"maxDeltaT", kind::number},
    {"maxEnergyRise", kind::number},
    {"logInterval", kind::number}, {"subCycling", kind::onOff},
    {"maxSubCycles", kind::number}, {"contactIterations", kind::number},
    {"massScaling", kind::dict}, {"damping", kind::dict},
    {"relaxation", kind::dict}
};

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
                   c.type == kind::dict ? "one, as -listControls prints"
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
                    "set of defaults, from fast to accurate; or the paper's"
                )
            }
        })
      + balanced.keywords()
      + keywordList
        ({
            {
                "adjustTimeStep", "",
                stepControl::adjustTimeStepDefault ? "yes" : "no",
                "yes: step from maxCo and the stable step; no: step deltaT"
            },
            {
                "maxDeltaT", "s", "none",
                "upper limit of the step, with adjustTimeStep yes"
            },
            {
                "minDeltaT", "s", "1e-6 of the first",
                "a stable step below this ends the run with an error"
            },
            {
                "maxEnergyRise", "-", "none",
                "a rise of energy above this share of its largest value ends "
                "the run with an error"
            },
            {
                "logInterval", "-", Foam::name(stepControl::logIntervalDefault),
                "number of steps between two log lines"
            }
        })
      + stepRatios::keywords()
      + keywordList
        ({
            {
                "contactIterations", "-",
                Foam::name(stepControl::contactIterationsDefault),
                "number of contact solutions per step; use 2 where a contact "
                "is only some faces wide"
            },
            {
                "massScaling", "", "none",
                "added mass for longer steps: dictionary of the regions"
            }
        })
      + massScaling::keywords().within("massScaling/<region>")
      + keywordList
        ({
            {
                "damping", "", "none",
                "mass-proportional damping: dictionary of the regions"
            }
        })
      + massDamping::keywords().within("damping/<region>")
      + keywordList
        ({
            {
                "relaxation", "", "none",
                "dictionary; if given, the run seeks the static state and ends "
                "there"
            }
        })
      + kineticRelaxation::keywords().within("relaxation");
}


void Foam::controlKeywords::check(const Time& runTime)
{
    const dictionary& dict = runTime.controlDict();
    const wordList ours(keywords().names());
    wordList known(ours);
    known.append(others());
    const dictionaryText text
    (
        runTime.globalPath()/runTime.system()/"controlDict"
    );
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();
        if (key.isPattern() || known.found(key)) continue;
        if (key[0] == '_' || text.uses(key)) continue;

        const bool anyOther = text.complete() && text.names(key);
        if (anyOther || dictionaryCheck::within(key, known, close).size())
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword '" << key << "'."
                << dictionaryCheck::proposal(key, known).c_str() << nl
                << "Keywords of vertexContact here: "
                << dictionaryCheck::listed(ours).c_str() << nl
                << "An entry of your own is valid if this file uses it as $"
                << key << ", or if its name begins with _"
                << exit(FatalIOError);
        }
    }
    for (const control& c : types) checkType(dict, c);
}


// ************************************************************************* //
