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

      - \par -listMaterials, -listContactLaws, -listPairings,
        -listBoundaryConditions, -listBodyForces, -listSchemes, -listPresets,
        -listIntegrators, -listFunctionObjects
        List what may be written in a case, with units, defaults and meaning,
        and end. No case is needed (modelLists).

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
#include "modelLists.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Explicit large-strain contact dynamics of deformable bodies.\n"
        "Reads system/controlDict, constant/regionProperties, "
        "constant/contactProperties, constant/g, and of each region "
        "constant/<region>/polyMesh, mechanicalProperties and bodyForces, "
        "system/<region>/fvSchemes and 0/<region>/pointU.\n"
        "The options -list... say what may be written there; the README of "
        "vertexContact and the headers of its classes say more."
    );
    modelLists::addOptions();

    #include "setRootCase.H"

    if (modelLists::write(args, Info))
    {
        return 0;
    }

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
