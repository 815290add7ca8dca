/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Rows of components, their transposition to lanes, and roots by Newton's
    method.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "fullTensor.H"
#include "edgeRows.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("lanes are transposed", "[lanes][serial]")
{
    lanes r[nLanes];
    for (int i = 0; i < nLanes; ++i)
    {
        for (int l = 0; l < nLanes; ++l) r[i][l] = 100*i + l;
    }
    transpose(r);
    for (int i = 0; i < nLanes; ++i)
    {
        for (int l = 0; l < nLanes; ++l) CHECK(r[i][l] == 100*l + i);
    }
}


TEST_CASE
(
    "inverses and inverse roots are exact to the last bits",
    "[lanes][serial]"
)
{
    // Mantissas and exponents of both parities, and thirds
    Random random(1);
    for (int exponent = -90; exponent <= 90; ++exponent)
    {
        for (int sample = 0; sample < 20; ++sample)
        {
            const scalar a =
                (1.5 + randomScalar(random, 0.5))*std::pow(2.0, exponent);
            const lanes square = inverseSquareRoot(uniform<lanes>(a));
            for (int l = 0; l < nLanes; ++l)
            {
                CHECK(mag(square[l]*std::sqrt(a) - 1) <= 1e-15);
            }
            CHECK(mag(inverseCubeRoot(a)*std::cbrt(a) - 1) <= 1e-15);

            const lanes inverse = reciprocal(uniform<lanes>(a));
            for (int l = 0; l < nLanes; ++l)
            {
                CHECK(mag(inverse[l]*a - 1) <= 1e-15);
            }
        }
    }

    // Areas of edges that are next to nothing
    const lanes tiny = inverseSquareRoot(uniform<lanes>(VSMALL));
    CHECK(mag(tiny[0]*std::sqrt(VSMALL) - 1) <= 1e-15);
    for (const scalar a : {VSMALL, 1e240})
    {
        CHECK(mag(reciprocal(uniform<lanes>(a))[0]*a - 1) <= 1e-15);
    }

    // Beyond the range of states: as the library's
    for (const scalar a : {1e-200, 1e200, -8.0})
    {
        CHECK(mag(inverseCubeRoot(a)*std::cbrt(a) - 1) <= 1e-15);
    }
}


TEST_CASE("pairs of rows are stored side by side", "[rows][serial]")
{
    scalar from[8], to[10];
    for (int k = 0; k < 8; ++k) from[k] = k + 1;
    to[0] = to[9] = 0;
    storePair(to + 1, rowAt<4>(from), rowAt<4>(from + 4));
    for (int k = 0; k < 8; ++k) CHECK(to[k + 1] == from[k]);
    CHECK(to[0] == 0);
    CHECK(to[9] == 0);
}


TEST_CASE("vectors of three in rows of four", "[rows][serial]")
{
    const row<4> a = {1, 2, 3, 100}, b = {-2, 5, 7, 200};
    CHECK(dotOfThree(a, b) == 29);
    const row<4> c = cross(a, b);
    CHECK(c[0] == -1);
    CHECK(c[1] == -13);
    CHECK(c[2] == 9);

    // Nothing beyond is read or written
    scalar from[3] = {4, 5, 6};
    const row<4> read = threeAt(from);
    CHECK(read[3] == 0);
    scalar to[4] = {0, 0, 0, -1};
    storeThree(to, read);
    for (int k = 0; k < 3; ++k) CHECK(to[k] == from[k]);
    CHECK(to[3] == -1);
}


TEST_CASE("columns of a tensor are stored row by row", "[rows][serial]")
{
    row<4> columns[3];
    for (int j = 0; j < 3; ++j)
    {
        for (int i = 0; i < 4; ++i) columns[j][i] = 10*i + j;
    }
    scalar byRows[10];
    byRows[9] = -1;
    storeRows(byRows, columns[0], columns[1], columns[2]);
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j) CHECK(byRows[3*i + j] == 10*i + j);
    }
    CHECK(byRows[9] == -1);
}


TEST_CASE("strides hold whole rows", "[rows][serial]")
{
    for (int n = 1; n <= 30; ++n)
    {
        INFO("n = " << n);
        const int stride = paddedStride(n);
        CHECK(stride >= n);
        CHECK(stride <= n + 3);
        CHECK(stride % strideWidth(stride) == 0);
        CHECK(rowWidth(n) <= max(4, n));
    }
    CHECK(strideWidth(paddedStride(13)) == 8);
    CHECK(strideWidth(paddedStride(4)) == 4);
    CHECK(strideWidth(paddedStride(2)) == 2);
}


TEST_CASE("aligned arrays start with a line of the cache", "[rows][serial]")
{
    for (const label size : {0, 1, 7, 8, 1000})
    {
        INFO("size " << size);
        alignedScalars a(size);
        CHECK(a.size() == size);
        for (label i = 0; i < size; ++i)
        {
            CHECK(a[i] == 0);
            a[i] = i;
        }
        if (size)
        {
            CHECK(reinterpret_cast<std::uintptr_t>(a.data()) % 64 == 0);

            // A row from the last one on may be read
            CHECK(rowAt<4>(a.cdata() + size - 1)[0] == size - 1);
        }
        a = Zero;
        for (label i = 0; i < size; ++i) CHECK(a[i] == 0);
    }
}


// ************************************************************************* //
