/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    vertexContactUnitTests

Description
    Catch2 driver that owns OpenFOAM's argList and a Time on a scratch case.

Usage
    \verbatim
        vertexContactUnitTests [Catch2 options] [--junit FILE] \
            [--- OpenFOAM options]
        mpirun -np N vertexContactUnitTests -parallel [...]
    \endverbatim

    FatalError and FatalIOError are thrown as exceptions. In parallel only the
    master reports (failed assertions of other ranks go to standard error at
    once), and all ranks agree on the exit code. --junit writes one entry for
    each test case, merged over the ranks.

\*---------------------------------------------------------------------------*/

#define CATCH_CONFIG_RUNNER             // version 2
#define CATCH_AMALGAMATED_CUSTOM_MAIN   // version 3
#include "testEnvironment.H"

#if __has_include(<catch2/catch_all.hpp>)
    // Linked: libCatch2
#elif __has_include(<catch2/catch_amalgamated.cpp>)
    #include <catch2/catch_amalgamated.cpp>
#elif __has_include(<catch_amalgamated.cpp>)
    #include <catch_amalgamated.cpp>
#endif

#include "dictionary.H"
#include "IStringStream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"

#include <cstdlib>
#include <fstream>
#include <iostream>

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

struct Result
{
    std::string name;
    Foam::label failed;
};

std::vector<Result> results;
Foam::argList* argsPtr = nullptr;
Foam::Time* timePtr = nullptr;
int exitCode = 0;

#if VC_CATCH2 == 2
typedef Catch::TestEventListenerBase ListenerBase;
#else
typedef Catch::EventListenerBase ListenerBase;
#endif


//- Notes the outcome of each test case, shows other ranks' failures
struct Listener
:
    public ListenerBase
{
    using ListenerBase::ListenerBase;

    void testCaseStarting(const Catch::TestCaseInfo& info) override
    {
        // Counts as failed if it does not come to its end
        results.push_back({info.name, 1});
    }

    void testCaseEnded(const Catch::TestCaseStats& stats) override
    {
        results.back().failed = (stats.totals.testCases.failed ? 1 : 0);
    }

    #if VC_CATCH2 == 2
    bool assertionEnded(const Catch::AssertionStats& stats) override
    {
        show(stats.assertionResult);
        return false;
    }
    #else
    void assertionEnded(const Catch::AssertionStats& stats) override
    {
        show(stats.assertionResult);
    }
    #endif

    static void show(const Catch::AssertionResult& result)
    {
        if (!result.isOk() && !Foam::Pstream::master())
        {
            std::ostringstream text;
            text<< "[rank " << Foam::Pstream::myProcNo() << "] "
                << result.getSourceInfo() << ": FAILED in '"
                << results.back().name << "': ";
            if (result.hasExpression())
            {
                text<< result.getExpression() << ", i.e. "
                    << result.getExpandedExpression() << ' ';
            }
            text<< result.getMessage() << '\n';
            std::cerr<< text.str() << std::flush;
        }
    }
};


//- Limit what the user selected to the tests meant for this kind of run: those
//  tagged for it, and those not tagged for the other one
void select(std::vector<std::string>& specs, const bool parallel)
{
    const std::string wanted(parallel ? "[parallel]" : "[serial]");
    const std::string other(parallel ? "~[serial]" : "~[parallel]");

    // Arguments are joined by 'and', commas mean 'or'. Tags go first: what
    // follows a name would be taken for a part of it.
    std::string tags, names;
    for (const std::string& spec : specs)
    {
        const bool isTag = !spec.find('[') || !spec.find("~[");
        (isTag ? tags : names) += spec;
    }
    const std::string all(tags + names);

    std::string selected;
    for (std::size_t begin = 0; begin <= all.size(); )
    {
        const std::size_t end = std::min(all.find(',', begin), all.size());
        const std::string one(all, begin, end - begin);
        selected += (begin ? "," : "") + wanted + one + "," + other + one;
        begin = end + 1;
    }
    specs.assign(1, selected);
}


std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text)
    {
        switch (c)
        {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '"': out += "&quot;"; break;
            default:  out += c;
        }
    }
    return out;
}


void writeJunit(const std::string& file, const Foam::label nFailed)
{
    const int nProcs = Foam::Pstream::parRun() ? Foam::Pstream::nProcs() : 1;

    std::ofstream os(file + ".part");
    os  << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        << "<testsuite name=\"unit-" << nProcs << "\" tests=\""
        << results.size() << "\" failures=\"" << nFailed << "\">\n";
    for (const Result& result : results)
    {
        os  << "<testcase classname=\"unit.np" << nProcs << "\" name=\""
            << escaped(result.name) << "\">";
        if (result.failed)
        {
            os  << "<failure message=\"failed on " << result.failed << " of "
                << nProcs << " ranks\"/>";
        }
        os  << "</testcase>\n";
    }
    os  << "</testsuite>\n</testsuites>\n";
    os.close();
    if (!os || std::rename((file + ".part").c_str(), file.c_str()))
    {
        std::cerr<< "cannot write " << file << std::endl;
        exitCode = 1;
    }
}


//- The scratch case, with empty fvSchemes and fvSolution
Foam::fileName makeScratch()
{
    using namespace Foam;

    string name(getEnv("TMPDIR"));
    name = (name.empty() ? "/tmp" : name) + "/vertexContactUnitTests.XXXXXX";
    if (Pstream::master())
    {
        if (!::mkdtemp(&name[0]))
        {
            FatalErrorInFunction
                << "Cannot make a folder " << name << exit(FatalError);
        }

        mkDir(name + "/system");
        for (const char* dictName : {"fvSchemes", "fvSolution"})
        {
            std::ofstream os(name + "/system/" + dictName);
            os  << "FoamFile { version 2.0; format ascii; class dictionary; "
                << "object " << dictName << "; }\n";
            for
            (
                const char* entry :
                {
                    "ddt", "d2dt2", "grad", "div", "laplacian",
                    "interpolation", "snGrad"
                }
            )
            {
                os  << entry << "Schemes {}\n";
            }
        }
    }
    Pstream::scatter(name);

    if (Pstream::parRun())
    {
        mkDir(name + "/processor" + Foam::name(Pstream::myProcNo()));
    }
    return name;
}

} // End anonymous namespace


CATCH_REGISTER_LISTENER(Listener)

CATCH_TRANSLATE_EXCEPTION(const Foam::IOerror& err)
{
    return "FatalIOError: " + err.ioFileName() + ": " + err.message();
}

CATCH_TRANSLATE_EXCEPTION(const Foam::error& err)
{
    return "FatalError: " + err.message();
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::argList& Foam::testArgs()
{
    return *argsPtr;
}


Foam::Time& Foam::testTime()
{
    return *timePtr;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace Foam;

    // OpenFOAM ends parallel runs by exit(0), from a destructor
    std::atexit
    (
        []
        {
            if (exitCode)
            {
                std::cout<< std::flush;
                std::_Exit(exitCode);
            }
        }
    );

    std::string junit;
    std::vector<char*> catchArgs(1, argv[0]);
    std::vector<char*> foamArgs(1, argv[0]);
    bool forFoam = false;
    for (int argi = 1; argi < argc; ++argi)
    {
        const std::string arg(argv[argi]);
        if (arg == "---")
        {
            forFoam = true;
        }
        else if (arg == "--junit" && argi + 1 < argc)
        {
            junit = argv[++argi];
        }
        else if (forFoam || arg == "-parallel")
        {
            foamArgs.push_back(argv[argi]);
        }
        else
        {
            catchArgs.push_back(argv[argi]);
        }
    }

    ::unsetenv("FOAM_ABORT");  // would abort instead of throwing
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    int foamArgc = foamArgs.size();
    foamArgs.push_back(nullptr);
    char** foamArgv = foamArgs.data();
    argList args(foamArgc, foamArgv, false);
    argsPtr = &args;

    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    // Time on the scratch case
    const fileName scratch(makeScratch());
    setEnv("FOAM_CASE", scratch, true);
    setEnv("FOAM_CASENAME", scratch.name(), true);
    const fileName caseName
    (
        Pstream::parRun()
      ? scratch.name()/("processor" + Foam::name(Pstream::myProcNo()))
      : fileName(scratch.name())
    );
    IStringStream controls
    (
        "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;"
        "writeControl timeStep; writeInterval 1; writeFormat ascii;"
        "writePrecision 17; timePrecision 12; runTimeModifiable false;"
    );
    {
        Time runTime(dictionary(controls), scratch.path(), caseName);
        timePtr = &runTime;

        Catch::Session session;
        exitCode = session.applyCommandLine(catchArgs.size(), catchArgs.data());
        if (!exitCode)
        {
            select(session.configData().testsOrTags, Pstream::parRun());
            #if VC_CATCH2 == 3
            session.configData().allowZeroTests = true;
            #endif
            if (!Pstream::master())
            {
                #if VC_CATCH2 == 2
                session.configData().outputFilename = "/dev/null";
                #else
                session.configData().defaultOutputFilename = "/dev/null";
                #endif
            }
            exitCode = (session.run() ? 1 : 0);
        }
        timePtr = nullptr;
    }

    // Merge the ranks' results
    label nFailed = 0;
    const label nResults = results.size();
    if (returnReduce(nResults, maxOp<label>()) != nResults)
    {
        std::cerr<< "other tests here than on other ranks" << std::endl;
        exitCode = 1;
    }
    else
    {
        for (Result& result : results)
        {
            reduce(result.failed, sumOp<label>());
            nFailed += (result.failed ? 1 : 0);
        }
    }
    reduce(exitCode, maxOp<int>());

    if (Pstream::master())
    {
        Foam::rmDir(scratch);
        if (junit.size())
        {
            writeJunit(junit, nFailed);
        }
        if (Pstream::parRun())
        {
            std::cout<< "On all ranks: " << results.size() - nFailed
                << " test cases passed, " << nFailed << " failed" << std::endl;
            for (const Result& result : results)
            {
                if (result.failed)
                {
                    std::cout<< "    failed on " << result.failed
                        << " ranks: " << result.name << std::endl;
                }
            }
        }
    }

    return exitCode;
}


// ************************************************************************* //
