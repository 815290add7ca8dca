/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    placeRegions

Description
    Before decomposePar: gives each region as a whole to one rank. Many small
    bodies are cut into pieces of a few cells otherwise, and each step waits for
    several messages of each body. So ranks have messages of contact only.

    Regions that are near each other get the same rank, and all ranks about as
    many cells: the centres of the regions, with their numbers of cells, are
    divided by OpenFOAM's method hierarchical. Its \c n is that of
    hierarchicalCoeffs in system/decomposeParDict, or without it slices across
    the longest extent.

Usage
    \b placeRegions

    system/decomposeParDict:
    \verbatim
        numberOfSubdomains  4;
        method              manual;
        manualCoeffs        { dataFile "ranks"; }
        hierarchicalCoeffs  { n (2 2 1); }          // may be left out
    \endverbatim

    Writes constant/\<region\>/ranks, which method manual reads, and prints the
    cells of each rank.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "labelIOList.H"
#include "decompositionMethod.H"
#include "dictionaryCheck.H"
#include "systemChecks.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Gives each region as a whole to one rank, for decomposePar with "
        "method manual"
    );
    argList::noParallel();
    argList::noFunctionObjects();

    #include "setRootCase.H"
    #include "createTime.H"

    const IOdictionary control
    (
        IOobject
        (
            "decomposeParDict", runTime.system(), runTime,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    const word method(control.get<word>("method"));
    if (method != "manual")
    {
        FatalIOErrorInFunction(control)
            << "Keyword 'method' is " << method << ": decomposePar reads what "
            << "placeRegions writes with (manual)" << exit(FatalIOError);
    }
    const fileName file
    (
        control.subDict("manualCoeffs").get<fileName>("dataFile")
    );
    const label nRanks = control.get<label>("numberOfSubdomains");

    const wordList names(systemChecks::regionNames(runTime));
    if (nRanks < 1 || nRanks > names.size())
    {
        FatalIOErrorInFunction(control)
            << "Keyword 'numberOfSubdomains' is " << nRanks << ": it must be "
            << "at least 1 and at most the number of regions, " << names.size()
            << exit(FatalIOError);
    }

    PtrList<polyMesh> meshes(names.size());
    pointField centres(names.size());
    scalarField cells(names.size());
    forAll(names, i)
    {
        meshes.set
        (
            i,
            new polyMesh
            (
                IOobject
                (
                    names[i], runTime.timeName(), runTime, IOobject::MUST_READ
                )
            )
        );
        centres[i] = meshes[i].bounds().midpoint();
        cells[i] = meshes[i].nCells();
    }

    // A method of its own: that of the file is manual
    dictionary division;
    division.add("numberOfSubdomains", nRanks);
    division.add("method", "hierarchical");
    dictionary coeffs(control.subOrEmptyDict("hierarchicalCoeffs"));
    if (!coeffs.found("n"))
    {
        const vector span(boundBox(centres).span());
        Vector<label> n(1, 1, 1);
        n[findMax(span)] = nRanks;
        coeffs.add("n", n);
    }
    if (!coeffs.found("delta")) coeffs.add("delta", 0.001);
    if (!coeffs.found("order")) coeffs.add("order", word("xyz"));
    division.add("hierarchicalCoeffs", coeffs);

    const labelList ranks
    (
        nRanks == 1
      ? labelList(names.size(), Zero)
      : decompositionMethod::New(division)->decompose(centres, cells)
    );

    labelList nRegions(nRanks, Zero), nCells(nRanks, Zero);
    forAll(names, i)
    {
        labelIOList
        (
            IOobject
            (
                file, meshes[i].facesInstance(), meshes[i],
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            labelList(meshes[i].nCells(), ranks[i])
        ).write();
        ++nRegions[ranks[i]];
        nCells[ranks[i]] += meshes[i].nCells();
    }

    Info<< nl << names.size() << " regions" << nl;
    forAll(nRegions, rank)
    {
        Info<< "Rank " << rank << ": " << nRegions[rank] << " regions, "
            << nCells[rank] << " cells" << nl;
    }
    Info<< nl << "Wrote constant/<region>/" << file
        << " for decomposePar -allRegions" << nl << nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
