/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    checkContact

Group
    grpPreProcessingUtilities

Description
    Checks the pairing of all contact interfaces, before a run or of a result.
    Reads a case as vertexContactFoam does, prints which parts are opposite each
    other and how accurately values and forces are transferred, and fails what a
    run would suffer from.

    For general contact it checks the pairs of surfaces with parts opposite each
    other.

    Writes postProcessing/checkContact/\<time\>/\<interface\>.vtk: a vertex on
    the first side and a line to the other for each overlap, or for each corner
    opposite an obstacle, with the results there as cell data.

Usage
    \b checkContact [OPTION]

      - \par -latestTime, -time \<ranges\>, -noZero
        The times to check. Default: the time from which a run would start.

      - \par -minCoverage \<fraction\>
        Least covered fraction of the area of each side (default 0: no check,
        since bodies may be apart, and sides larger than the contact).

      - \par -maxPenetration \<fraction\>
        Largest penetration, by the width of the faces (default 0.05).

      - \par -noVtk
        Do not write VTK files.

    Between bodies a check fails if
    \table
        Coverage of a side           | < minCoverage
        Sum of weights of a corner   | > 1.01: pressure counts twice there (1)
        Transfer of a constant       | error > 1e-10
        Flux weights of an overlap   | sum off 1 by more than 1e-10
        Forces on both sides         | sum > 1e-10 of one of them
        Penetration                  | > maxPenetration, unless tied
        Tangential offset (2)        | > 0.5: not what is opposite
    \endtable
    (1) nearestFace: of the overlaps whose gap is below 0.05 face widths, since
    curved surfaces cover each other once only where they touch.
    (2) distance of the joined points along the surface, over the face width,
    where the gap is less than the width. The pairings of the reference
    configuration (matching, AMI) do not follow bodies that slide.

    Matching or AMI surfaces without any overlap are an error when the case is
    read.

    With obstacles a check fails if
    \table
        Nearest points               | a corner has none
        Normals of the obstacle      | most corners lie behind it, or none <!--
                                   --> of those close to it faces it
        Penetration                  | > maxPenetration
    \endtable

    The exit code is 0 if all is well, else 1.

    The table also has values that are not checked: the areas of the overlaps
    and their first moments on both sides, the transfer of a linear field, the
    moment balance of a unit pressure, and the resulting traction where a corner
    is fully covered. In 2D and 1D areas are per thickness and cross-section.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "timeSelector.H"
#include "Time.H"
#include "solidSystem.H"
#include "bodyInterface.H"
#include "obstacleInterface.H"
#include "checkInterfaces.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Checks the pairing of contact interfaces"
    );
    timeSelector::addOptions(false, false);
    argList::addOption
    (
        "minCoverage",
        "fraction",
        "Least covered fraction of the area of each side (default: 0)"
    );
    argList::addOption
    (
        "maxPenetration",
        "fraction",
        "Largest penetration, in face widths (default: 0.05)"
    );
    argList::addBoolOption
    (
        "noVtk",
        "Do not write VTK files"
    );

    #include "setRootCase.H"
    #include "createTime.H"

    contactLimits limits;
    limits.minCoverage =
        args.getOrDefault<scalar>("minCoverage", limits.minCoverage);
    limits.maxPenetration =
        args.getOrDefault<scalar>("maxPenetration", limits.maxPenetration);
    if (!(limits.minCoverage >= 0 && limits.minCoverage <= 1))
    {
        FatalErrorInFunction
            << "Option -minCoverage is " << limits.minCoverage
            << ": it must be from 0 to 1" << exit(FatalError);
    }
    if (!(limits.maxPenetration >= 0))
    {
        FatalErrorInFunction
            << "Option -maxPenetration is " << limits.maxPenetration
            << ": it must be at least 0" << exit(FatalError);
    }
    const bool vtk = !args.found("noVtk");

    const instantList times(timeSelector::selectIfPresent(runTime, args));

    label nFailed = 0;
    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << nl << endl;

        const solidSystem solids(runTime);
        const fileName folder
        (
            runTime.globalPath()/"postProcessing"/"checkContact"
           /runTime.timeName()
        );

        // Find current normals and stretches, as the solver's first stage does
        for (const contactInterface& contact : solids.interfaces())
        {
            for (const contactSide& side : contact.sides())
            {
                side.body->prepare(runTime.value());
                side.body->findCorners(side.patchi);
            }
        }

        label nFailedNow = 0;
        for (const contactInterface& all : solids.interfaces())
        {
            if (all.many()) all.report(Info);
        }
        label nApart = 0;
        for (const contactInterface& all : solids.interfaces())
        for (const contactInterface& contact : all.parts())
        {
            const auto* bodies = dynamic_cast<const bodyInterface*>(&contact);
            if (all.many() && bodies && !bodies->pairing().active())
            {
                ++nApart;
                continue;
            }
            contact.report(Info);
            contactReport report(contact);
            contactLines lines;

            const auto* obstacle =
                dynamic_cast<const obstacleInterface*>(&contact);
            if (bodies)
            {
                checkInterface(*bodies, limits, report, lines);
            }
            else if (obstacle)
            {
                checkInterface(*obstacle, limits, report, lines);
            }
            if (vtk)
            {
                lines.write(folder/contact.name() + ".vtk");
            }
            nFailedNow += report.nFailed();
            Info<< endl;
        }

        if (nApart)
        {
            Info<< nApart << " more pairs of surfaces are near each other, "
                << "but none of their faces are opposite." << nl << endl;
        }
        if (solids.interfaces().empty())
        {
            Info<< "No contact interfaces." << nl << endl;
        }
        if (nFailedNow)
        {
            Info<< "Failed " << nFailedNow << " contact checks." << nl << endl;
        }
        else
        {
            Info<< "Contact OK." << nl << endl;
        }
        nFailed += nFailedNow;
    }

    Info<< "End" << nl << endl;

    if (nFailed)
    {
        // Return an exit code: the destructor of argList would end the program
        // with 0. Faster ranks must not stop the master while it is writing
        returnReduce(nFailed, maxOp<label>());
        Pstream::exit(1);
    }
    return 0;
}


// ************************************************************************* //
