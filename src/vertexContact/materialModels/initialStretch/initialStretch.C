/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "initialStretch.H"
#include "principalValues.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::initialStretch::initialStretch
(
    const tensorField& F0,
    const label nDim
)
:
    nDim_(nDim),
    data_(F0.size()*(nDim*nDim + 3), Zero)
{
    withDirections(nDim, [&](auto directions)
    {
        constexpr int D = directions.value;
        forAll(F0, a)
        {
            scalar* p = data_.data() + a*stride();
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j) p[D*i + j] = F0[a][3*i + j];
            }
            // In 3D nothing asks for it
            p[D*D] = D < 3 ? F0[a].zz() : 1;

            const SolidTensor<D> F = load<D>(a);
            const scalar J0 = determinant(F);
            SolidTensor<D> C;
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    C(i, j) = 0;
                    for (int k = 0; k < D; ++k) C(i, j) += F(k, i)*F(k, j);
                }
            }
            C.out = sqr(F.out);
            const principalValues<D> principal(C);
            scalar largest = 0;
            for (int i = 0; i < D; ++i)
            {
                largest = max(largest, principal.value[i]);
            }
            p[D*D + 1] = J0;
            p[D*D + 2] = std::sqrt(max(largest/J0, J0));
        }
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tensor Foam::initialStretch::value(const label node) const
{
    const scalar* p = data_.cdata() + node*stride();
    tensor F0(Zero);
    for (label i = 0; i < 3; ++i)
    {
        for (label j = 0; j < 3; ++j)
        {
            F0[3*i + j] =
                i < nDim_ && j < nDim_ ? p[nDim_*i + j]
              : i == j ? p[nDim_*nDim_]
              : 0;
        }
    }
    return F0;
}


// ************************************************************************* //
