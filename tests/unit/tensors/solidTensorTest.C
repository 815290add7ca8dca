/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    SolidTensor in one, two and three dimensions against index notation.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "fullTensor.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

const label nSamples = 200;
const scalar tol = 1e-14;   // components below 2.2, at most 27 products


template<int D>
void checkCross()
{
    INFO("D = " << D);
    Random random(1 + D);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const auto A = randomTensor<D>(random);
        const auto B = randomTensor<D>(random);
        const auto C = randomTensor<D>(random);
        const scalar a = randomScalar(random), b = randomScalar(random);

        const fullTensor full(cross(fullTensor(A), fullTensor(B)));
        CHECK(maxDiff(fullTensor(cross(A, B)), full) <= tol);
        CHECK(maxDiff(cross(A, B), cross(B, A)) <= tol);
        CHECK
        (
            maxDiff
            (
                cross(combine(a, A, b, B), C),
                combine(a, cross(A, C), b, cross(B, C))
            ) <= tol
        );

        // (A x B) : C does not depend on the order
        const scalar ABC = ddot(cross(A, B), C);
        CHECK(mag(ABC - ddot(cross(B, C), A)) <= 5*tol);
        CHECK(mag(ABC - ddot(cross(C, A), B)) <= 5*tol);
    }
}


template<int D>
void cofactorAndDeterminant()
{
    INFO("D = " << D);
    Random random(11 + D);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const auto A = randomTensor<D>(random);
        const auto cofA = cofactor(A);
        const scalar d = determinant(A);

        CHECK(maxDiff(fullTensor(cofA), cofactor(fullTensor(A))) <= tol);
        CHECK(mag(d - determinant(fullTensor(A))) <= tol);
        CHECK(mag(determinant(A, cofA) - d) <= tol);

        // Also after embedding: cof(A) A^T = det(A) I
        const fullTensor product
        (
            dotTransposed(fullTensor(cofA), fullTensor(A))
        );
        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j)
            {
                CHECK(mag(product.c[i][j] - (i == j ? d : 0)) <= tol);
            }
        }

        CHECK(mag(ddot(cofA, A) - 3*d) <= 3*tol);
        CHECK(maxDiff(cross(A, A), combine(2, cofA, 0, A)) <= tol);
    }
}


//- Both are polynomials, hence these expansions are exact
template<int D>
void derivatives()
{
    INFO("D = " << D);
    Random random(21 + D);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const auto A = randomTensor<D>(random);
        const auto B = randomTensor<D>(random);
        const auto plus = combine(1, A, 1, B);
        const auto minus = combine(1, A, -1, B);

        // d det(A) : B = cof(A) : B
        CHECK
        (
            mag
            (
                0.5*(determinant(plus) - determinant(minus))
              - determinant(B) - ddot(cofactor(A), B)
            ) <= 10*tol
        );
        CHECK
        (
            mag
            (
                determinant(plus) - determinant(A) - determinant(B)
              - ddot(cofactor(A), B) - ddot(A, cofactor(B))
            ) <= 10*tol
        );

        // d cof(A) : B = A x B
        CHECK
        (
            maxDiff
            (
                combine(0.5, cofactor(plus), -0.5, cofactor(minus)),
                cross(A, B)
            ) <= 2*tol
        );
    }
}


template<int D>
void products()
{
    INFO("D = " << D);
    Random random(31 + D);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const auto A = randomTensor<D>(random);
        const auto B = randomTensor<D>(random);
        const scalar a = randomScalar(random), b = randomScalar(random);
        const fullTensor fullA(A), fullB(B);

        CHECK(mag(ddot(A, B) - ddot(fullA, fullB)) <= tol);
        CHECK
        (
            mag(trace(A) - (fullA.c[0][0] + fullA.c[1][1] + fullA.c[2][2]))
         <= tol
        );
        CHECK
        (
            maxDiff
            (
                fullTensor(combine(a, A, b, B)),
                combine(a, fullA, b, fullB)
            ) <= tol
        );

        SolidVector<D> n, m;
        scalar nm = 0;
        for (int i = 0; i < D; ++i)
        {
            n[i] = randomScalar(random);
            m[i] = randomScalar(random);
            nm += n[i]*m[i];
        }
        CHECK(mag(dot(n, m) - nm) <= tol);
        const SolidVector<D> An(dot(A, n));
        for (int i = 0; i < D; ++i)
        {
            scalar sum = 0;
            for (int j = 0; j < D; ++j) sum += fullA.c[i][j]*n[j];
            CHECK(mag(An[i] - sum) <= tol);
        }
    }
}


template<int D>
void storage()
{
    INFO("D = " << D);
    scalar flat[2*D*D];
    for (int k = 0; k < 2*D*D; ++k) flat[k] = k + 1;

    const auto A = SolidTensor<D>::load(flat + D*D, 7);
    for (int i = 0; i < D; ++i)
    {
        for (int j = 0; j < D; ++j)
        {
            CHECK(A(i, j) == D*D + i*D + j + 1);
        }
    }
    CHECK(A.out == 7);

    const auto v = SolidVector<D>::load(flat + D);
    for (int i = 0; i < D; ++i) CHECK(v[i] == D + i + 1);

    const auto I = SolidTensor<D>::identity();
    CHECK(maxDiff(fullTensor(I), fullTensor(tensor::I)) == 0);
    CHECK(trace(I) == 3);
    CHECK(ddot(I, I) == 3);
    CHECK(determinant(I) == 1);
    CHECK(maxDiff(cofactor(I), I) == 0);
    CHECK(maxDiff(cross(I, I), combine(2, I, 0, I)) == 0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("tensor cross product", "[tensors][serial]")
{
    checkCross<1>();
    checkCross<2>();
    checkCross<3>();
}


TEST_CASE("cofactor and determinant", "[tensors][serial]")
{
    cofactorAndDeterminant<1>();
    cofactorAndDeterminant<2>();
    cofactorAndDeterminant<3>();
}


TEST_CASE("derivatives of cofactor and determinant", "[tensors][serial]")
{
    derivatives<1>();
    derivatives<2>();
    derivatives<3>();
}


TEST_CASE("contractions and traces", "[tensors][serial]")
{
    products<1>();
    products<2>();
    products<3>();
}


TEST_CASE("tensors from flat arrays, identity", "[tensors][serial]")
{
    storage<1>();
    storage<2>();
    storage<3>();
}


TEST_CASE("a rotation is its own cofactor", "[tensors][serial]")
{
    Random random(41);
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const scalar angle = randomScalar(random, 4);
        const tensor R(rotation(randomNormal(random), angle));
        const auto Q = SolidTensor<3>::load(R.cdata(), 0);
        CHECK(determinant(Q) == Approx(1).epsilon(1e-14));
        CHECK(maxDiff(cofactor(Q), Q) <= tol);

        const scalar c = Foam::cos(angle), s = Foam::sin(angle);
        const scalar plane[] = {c, -s, s, c};
        const auto Q2 = SolidTensor<2>::load(plane, 1);
        CHECK(determinant(Q2) == Approx(1).epsilon(1e-14));
        CHECK(maxDiff(cofactor(Q2), Q2) <= tol);
    }
}


// ************************************************************************* //
