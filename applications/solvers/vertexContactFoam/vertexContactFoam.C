/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Application
    vertexContactFoam

Group
    grpStressAnalysisSolvers

Description
    Explicit large-strain contact dynamics of deformable bodies: vertex-centred
    finite volumes in linear momentum and deformation gradient, cofactor and
    Jacobian, with an acoustic Riemann solver for fluxes and contact.

Usage
    \b vertexContactFoam [OPTION]

      - \par -dry-run
        Read everything, make the first step as a run does, report memory, step,
        number of steps and about how long a run takes, and end. Nothing is
        written into the case, and no time is renamed. The time of a step is
        measured over one second of trial steps. The estimate is too low where
        bodies that are still apart will touch, where deformation shortens the
        steps, and by the time to write. For coarse tutorials: the rings took
        1.12 times the estimate with 1.01 times the steps; the Taylor bar, which
        ends with much shorter steps, 2.7 times the estimate (1.6 times that for
        a step that goes on falling) with 2.5 times the steps; two bars, whose
        number of steps is exact, 1.3 s instead of 0.8.

      - \par -listMaterials, -listStartFields, -listContactLaws,
        -listPairings, -listBoundaryConditions, -listBodyForces, -listSchemes,
        -listControls, -listPresets, -listIntegrators, -listFunctionObjects
        List what may be written in a case, with units, defaults and meaning,
        and end. No case is needed (modelLists).

    \verbatim
        blockMesh -region bar1 && blockMesh -region bar2
        vertexContactFoam -dry-run
        vertexContactFoam
        mpirun -np 2 vertexContactFoam -parallel
    \endverbatim

    See solidSystem for the files that are read.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "dryRun.H"
#include "solidSystem.H"
#include "writtenTimes.H"
#include "modelLists.H"
#include "passTimes.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Explicit large-strain contact dynamics of deformable bodies.\n"
        "Reads system/controlDict, constant/regionProperties, "
        "constant/contactProperties and constant/g. For each region it reads "
        "constant/<region>/polyMesh, mechanicalProperties and bodyForces, "
        "system/<region>/fvSchemes and 0/<region>/pointU. Regions can share "
        "files instead of the last four: constant/solidProperties and "
        "bodyForces, system/fvSchemes and 0/pointU.\n"
        "The options -list... print the keywords of these files; "
        "tutorials/reference and the headers of the classes explain them."
    );
    argList::addBoolOption
    (
        "dry-run",
        "Read the case and report what is modelled, memory, step, number of "
        "steps and estimated run time; write nothing"
    );
    argList::addBoolOption
    (
        "profile",
        "End the log with the time of each pass of a step, and with the share "
        "of the memory bandwidth that the steps use"
    );
    modelLists::addOptions();

    #include "setRootCase.H"

    if (modelLists::write(args, Info))
    {
        return 0;
    }

    if (args.found("profile"))
    {
        passTimes::want();
    }

    const bool dry = args.found("dry-run");
    word start;
    if (dry)
    {
        start = writtenTimes::latestComplete(args);
    }
    else
    {
        writtenTimes::setAsideIncomplete(args);
    }

    #include "createTime.H"
    if (start.size())
    {
        runTime.setTime(instant(readScalar(start), start), 0);
    }

    solidSystem solids(runTime);
    solids.report(Info);

    if (dry)
    {
        dryRun(solids, runTime, Info);
        Info<< "End" << nl << endl;
        return 0;
    }

    if (!runTime.run())
    {
        Info<< "No steps: the run is at " << runTime.timeName()
            << " s, and endTime is " << runTime.endTime().value() << " s"
            << nl << endl;
    }
    while (runTime.run())
    {
        // Rates of the current state, and the stable step
        solids.startStep();

        ++runTime;

        solids.finishStep();
        solids.log();

        solids.writeIfDue();
    }

    solids.reportCost(Info);
    runTime.printExecutionTime(Info);
    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
