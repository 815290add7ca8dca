/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    placeRegions

Description
    Assigns each region as a whole to one rank, before decomposePar. Otherwise
    many small bodies are cut into pieces of a few cells, and each step waits
    for several messages per body. With whole regions only contact needs
    messages.

    Neighbouring regions get the same rank. All ranks get about equally many
    cells, but at least one region. The centres of the regions, with their
    numbers of cells, are divided in the directions x, y and z in turn, like
    OpenFOAM's method hierarchical. (That method divides by zero if a rank has
    nothing, as with as many ranks as regions.) \c n is that of
    hierarchicalCoeffs in system/decomposeParDict; without it the regions are
    sliced across their longest extent.

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
#include "dictionaryCheck.H"
#include "systemChecks.H"
#include <algorithm>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Distribute regions to n[axis] groups of ranks by their centres in that
//  direction, then each group in the next directions.
//  \param regions  at least as many as ranks
//  \param first  first rank of the groups
void divide
(
    const labelList& regions,
    const label axis,
    const Vector<label>& n,
    const label first,
    const pointField& centres,
    const scalarField& cells,
    labelList& ranks
)
{
    if (axis == label(vector::nComponents))
    {
        for (const label region : regions) ranks[region] = first;
        return;
    }
    label ranksOfGroup = 1;
    for (label d = axis + 1; d < label(vector::nComponents); ++d)
    {
        ranksOfGroup *= n[d];
    }
    labelList sorted(regions);
    const auto isBefore = [&](const label a, const label b)
    {
        return centres[a][axis] < centres[b][axis];
    };
    std::stable_sort(sorted.begin(), sorted.end(), isBefore);
    scalar total = 0, before = 0;
    for (const label region : sorted) total += cells[region];

    label next = 0;
    for (label group = 0; group < n[axis]; ++group)
    {
        // Add regions until the groups so far have their share of the cells.
        // This group and the following ones need a region for each rank
        const label last = n[axis] - 1;
        const label least = next + ranksOfGroup;
        const label most = sorted.size() - (last - group)*ranksOfGroup;
        label end = next;
        while
        (
            end < most
         && (
                end < least || group == last
             || before + 0.5*cells[sorted[end]]
              < total*(group + 1)/n[axis]
            )
        )
        {
            before += cells[sorted[end]];
            ++end;
        }
        divide
        (
            labelList(SubList<label>(sorted, end - next, next)), axis + 1,
            n, first + group*ranksOfGroup, centres, cells, ranks
        );
        next = end;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Assigns each region as a whole to one rank, for decomposePar with "
        "'method manual'"
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
            << "Keyword 'method' is " << method << ": it must be manual, with "
            << "which decomposePar reads the file that placeRegions writes"
            << exit(FatalIOError);
    }
    const fileName file
    (
        dictionaryCheck::subDict
        (
            control, "manualCoeffs", "dataFile \"ranks\";"
        ).get<fileName>("dataFile")
    );
    if (file.empty() || file != file.name())
    {
        FatalIOErrorInFunction(control.subDict("manualCoeffs"))
            << "Keyword 'dataFile' is " << file << ": it must be the name of a "
            << "file in the folder of each region, without '/'"
            << exit(FatalIOError);
    }
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

    const vector span(boundBox(centres).span());
    Vector<label> n(1, 1, 1);
    n[findMax(span)] = nRanks;
    const dictionary coeffs(control.subOrEmptyDict("hierarchicalCoeffs"));
    coeffs.readIfPresent("n", n);
    if (cmptProduct(n) != nRanks || cmptMin(n) < 1)
    {
        FatalIOErrorInFunction(coeffs)
            << "Keyword 'n' is " << n << ": it must be three positive numbers "
            << "whose product is numberOfSubdomains, " << nRanks
            << exit(FatalIOError);
    }
    labelList ranks(names.size(), Zero);
    divide(identity(names.size()), 0, n, 0, centres, cells, ranks);

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
