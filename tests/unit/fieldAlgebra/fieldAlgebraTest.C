/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Expressions of OpenFOAM's fields that reuse a temporary write into one of
    their operands. The field loops of old releases declare their pointers
    __restrict__, and GCC 12 then makes wrong code of them from -O2 on:
    etc/compileOptions takes the word away, and this guards it. Whether the
    code is wrong depends on the other options, too (seen without
    -march=native), so the option itself is looked for as well.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "Random.H"
#include "tensorField.H"
#include "symmTensorField.H"
#include "vectorField.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

const scalar tol = 1e-14;


template<class Type>
Field<Type> randomField(Random& random, const label size)
{
    Field<Type> f(size);
    for (Type& value : f)
    {
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            setComponent(value, d) = 2*random.sample01<scalar>() - 1;
        }
    }
    return f;
}


//- Largest difference from the values that one element at a time gives
template<class Type, class Function>
scalar maxDiff(const Field<Type>& f, const Function& expected)
{
    scalar diff = 0;
    forAll(f, i)
    {
        const Type value = expected(i);
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            diff = max(diff, mag(component(f[i], d) - component(value, d)));
        }
    }
    return diff;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("compiled without __restrict__", "[fieldAlgebra][serial]")
{
    #ifdef __restrict__
    const bool removed = true;
    #else
    const bool removed = false;
    #endif
    CHECK(removed);
}


TEST_CASE("expressions that reuse a tensor field", "[fieldAlgebra][serial]")
{
    for (const label size : {1, 7, 64, 1000})
    {
        INFO("size " << size);
        Random random(size);
        const tensorField T(randomField<tensor>(random, size));
        const tensorField S(randomField<tensor>(random, size));
        const symmTensorField A(randomField<symmTensor>(random, size));
        const vectorField v(randomField<vector>(random, size));
        const scalarField s(randomField<scalar>(random, size));

        CHECK
        (
            maxDiff
            (
                tensorField((2.0*T) & T),
                [&](label i) { return (2.0*T[i]) & T[i]; }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                tensorField(T & (2.0*T)),
                [&](label i) { return T[i] & (2.0*T[i]); }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                tensorField((2.0*T) & (3.0*S)),
                [&](label i) { return (2.0*T[i]) & (3.0*S[i]); }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                tensorField(T & (T - S)),
                [&](label i) { return T[i] & (T[i] - S[i]); }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                tensorField((T + S) & T),
                [&](label i) { return (T[i] + S[i]) & T[i]; }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                tensorField((s*T) & S),
                [&](label i) { return (s[i]*T[i]) & S[i]; }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                tensorField(A & (2.0*T)),
                [&](label i) { return A[i] & (2.0*T[i]); }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                tensorField((2.0*T) & A),
                [&](label i) { return (2.0*T[i]) & A[i]; }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                vectorField(T & (2.0*v)),
                [&](label i) { return T[i] & (2.0*v[i]); }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                vectorField((v - 2.0*v) & T),
                [&](label i) { return (v[i] - 2.0*v[i]) & T[i]; }
            ) <= tol
        );
    }
}


TEST_CASE("expressions that reuse a vector field", "[fieldAlgebra][serial]")
{
    for (const label size : {1, 7, 64, 1000})
    {
        INFO("size " << size);
        Random random(size);
        const vectorField v(randomField<vector>(random, size));
        const vectorField w(randomField<vector>(random, size));
        const tensorField T(randomField<tensor>(random, size));

        CHECK
        (
            maxDiff
            (
                vectorField((2.0*v) ^ w),
                [&](label i) { return (2.0*v[i]) ^ w[i]; }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                vectorField(v ^ (w - v)),
                [&](label i) { return v[i] ^ (w[i] - v[i]); }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                vectorField(T & (v - w)),
                [&](label i) { return T[i] & (v[i] - w[i]); }
            ) <= tol
        );
        CHECK
        (
            maxDiff
            (
                vectorField((T & v) - (v & w)*v),
                [&](label i) { return (T[i] & v[i]) - (v[i] & w[i])*v[i]; }
            ) <= tol
        );
    }
}


// ************************************************************************* //
