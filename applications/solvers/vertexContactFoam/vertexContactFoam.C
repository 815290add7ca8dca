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
    \verbatim
        blockMesh -region bar1 && blockMesh -region bar2
        vertexContactFoam
        mpirun -np 2 vertexContactFoam -parallel
    \endverbatim

    See solidSystem for the files that are read.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "solidSystem.H"
#include "writtenTimes.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Explicit large-strain contact dynamics of deformable bodies"
    );

    #include "setRootCase.H"
    writtenTimes::setAsideIncomplete(args);
    #include "createTime.H"

    solidSystem solids(runTime);
    solids.report(Info);

    while (runTime.run())
    {
        // Rates of the state that is known, and the step they allow
        solids.startStep();

        ++runTime;

        solids.finishStep();
        solids.log();

        solids.write();
    }

    solids.reportCost(Info);
    runTime.printExecutionTime(Info);
    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
