/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Rows of named numbers over the processors, and at the end of a line.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "rankRows.H"
#include "ops.H"
#include "OStringStream.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * //

namespace
{

struct twoForces
{
    vector minus;
    scalar area;
    vector plus;
};

//- One row of each rank's own numbers, and one that is the same everywhere
List<twoForces> rowsOfRank()
{
    const scalar r = Pstream::myProcNo() + 1;
    List<twoForces> rows(2);
    rows[0] = {vector(r, 2*r, 3*r), 10*r, vector(-r, 0, r*r)};
    rows[1] = {vector(1, 1, 1), 1, vector(1, 1, 1)};
    return rows;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Test Cases  * * * * * * * * * * * * * * * //

TEST_CASE("Rows are summed number by number, whatever the ranks")
{
    List<twoForces> rows(rowsOfRank());
    combineRows(rows, plusEqOp<scalar>());
    scatterRows(rows);
    scalar sum = 0, squares = 0;
    for (label r = 1; r <= Pstream::nProcs(); ++r)
    {
        sum += r;
        squares += r*r;
    }
    CHECK(mag(rows[0].minus - sum*vector(1, 2, 3)) == 0);
    CHECK(rows[0].area == 10*sum);
    CHECK(mag(rows[0].plus - vector(-sum, 0, squares)) == 0);
    CHECK(rows[1].area == Pstream::nProcs());
}


TEST_CASE("The largest of each number counts, whatever the ranks")
{
    List<twoForces> rows(rowsOfRank());
    combineRows(rows, maxEqOp<scalar>());
    scatterRows(rows);
    const scalar n = Pstream::nProcs();
    CHECK(rows[0].minus.z() == 3*n);
    CHECK(rows[0].plus.x() == -1);
    CHECK(rows[0].plus.z() == n*n);

    List<twoForces> none;
    combineRows(none, maxEqOp<scalar>());
    CHECK(none.empty());
}


TEST_CASE("Numbers stand behind spaces, those of vectors apart")
{
    OStringStream os;
    os  << 1;
    appendNumbers(os, scalar(2), vector(3, 4, 5), scalar(6));
    CHECK(os.str() == "1 2 3 4 5 6");
}


// ************************************************************************* //
