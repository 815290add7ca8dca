/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Extremes and sums over a whole body.

\*---------------------------------------------------------------------------*/

#include "deformableBody.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::deformableBody::findNodeWithin(const scalar timeScale) const
{
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        if (timeScaleOf(a) <= timeScale) return a;
    }
    return -1;
}


Foam::scalar Foam::deformableBody::largestGradient() const
{
    scalar largest = 0;
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        // Include the initial stretch, to first order in small strains
        tensor gradient(deformationGradient(a) - tensor::I);
        if (material_->initial().on())
        {
            gradient += inSpace(material_->initial().value(a)) - tensor::I;
        }
        largest = max(largest, magSqr(gradient));
    }
    return std::sqrt(largest);
}


Foam::label Foam::deformableBody::findBadNode() const
{
    const label d = dual_.nDim();
    for (label a = 0; a < dual_.nNodes(); ++a)
    {
        for (label i = 0; i < d; ++i)
        {
            if (!std::isfinite(data_.state.lm[a*d + i])) return a;
        }
        if (data_.finiteStrain)
        {
            const scalar* F = data_.state.F.cdata();
            const scalar detF =
                d == 1 ? determinant(loadF<1>(F, a))
              : d == 2 ? determinant(loadF<2>(F, a))
              : determinant(loadF<3>(F, a));
            if (!(detF > 0)) return a;
            if (data_.state.solvesJ && !(data_.state.J[a] > 0)) return a;
        }
        else
        {
            for (label k = 0; k < d*d; ++k)
            {
                if (!(mag(data_.state.F[a*d*d + k]) < largestLinearF)) return a;
            }
        }
    }
    return -1;
}


Foam::scalar Foam::deformableBody::kineticEnergy() const
{
    scalar sum = 0;
    withDirections(dual_.nDim(), [&](auto D)
    {
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            scalar vv = 0;
            for (int i = 0; i < D.value; ++i) vv += sqr(velocity(a, i));
            sum += ownedVolume_[a]*vv;
        }
    });
    return 0.5*data_.rho*sum;
}


Foam::scalar Foam::deformableBody::strainEnergy() const
{
    return material_->strainEnergy(data_.state, ownedVolume_);
}


Foam::scalar Foam::deformableBody::mass() const
{
    return data_.rho*sum(ownedVolume_);
}


Foam::vector Foam::deformableBody::linearMomentum() const
{
    scalar sum[3] = {};
    withDirections(dual_.nDim(), [&](auto D)
    {
        const scalar* p = data_.state.lm.cdata();
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            for (int i = 0; i < D.value; ++i)
            {
                sum[i] += ownedVolume_[a]*p[a*D.value + i];
            }
        }
    });
    return expand(sum);
}


Foam::vector Foam::deformableBody::angularMomentum() const
{
    // x_i p_j - x_j p_i. A component is constant if neither of its directions
    // is solved
    tensor sum(Zero);
    withDirections(dual_.nDim(), [&](auto D)
    {
        constexpr int d = D.value;
        const scalar* X = dual_.nodePosition().cdata();
        const scalar* u = data_.state.disp.cdata();
        const scalar* p = data_.state.lm.cdata();
        scalar L[d][d] = {};
        for (label a = 0; a < dual_.nNodes(); ++a)
        {
            scalar x[d];
            for (int i = 0; i < d; ++i) x[i] = X[a*d + i] + u[a*d + i];
            for (int i = 0; i < d; ++i)
            {
                for (int j = i + 1; j < d; ++j)
                {
                    L[i][j] +=
                        ownedVolume_[a]*(x[i]*p[a*d + j] - x[j]*p[a*d + i]);
                }
            }
        }
        const FixedList<label, 3>& dir = dual_.directions();
        for (int i = 0; i < d; ++i)
        {
            for (int j = i + 1; j < d; ++j)
            {
                sum[3*dir[i] + dir[j]] = L[i][j];
                sum[3*dir[j] + dir[i]] = -L[i][j];
            }
        }
    });
    return vector(sum.yz(), sum.zx(), sum.xy());
}


// ************************************************************************* //
