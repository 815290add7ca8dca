/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexData.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vertexData::vertexData
(
    const medianDual& dual,
    const kinematicSet kinematics,
    const bool finiteStrain,
    const reconstructionType reconstruction,
    const limiterType limiter,
    const scalar rho,
    const scalar cp,
    const scalar cs
)
:
    dual(dual),
    finiteStrain(finiteStrain),
    reconstruction(reconstruction),
    limiter(limiter),
    rho(rho),
    cp(cp),
    cs(cs),
    state(dual.nNodes(), dual.nDim(), kinematics, finiteStrain),
    old(state),
    nSJ(state.solvesJ ? 1 : 0),
    nW(dual.nDim() + nSJ + dual.nDim()*dual.nDim()),
    nR
    (
        reconstruction == reconstructionType::none ? 0
      : reconstruction == reconstructionType::linear ? dual.nDim() + nSJ
      : nW
    ),
    W(dual.nNodes()*nW, Zero),
    grad(dual.nNodes()*nR*dual.nDim(), Zero),
    rateLm(dual.nNodes()*dual.nDim(), Zero),
    rateF(dual.nNodes()*dual.nDim()*dual.nDim(), Zero),
    rateJ(dual.nNodes()*nSJ, Zero),
    waveSum(dual.nNodes(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::size_t Foam::vertexData::bytes() const
{
    return
        state.bytes() + old.bytes()
      + sizeof(scalar)
       *std::size_t
        (
            mirrorArea.size() + W.size() + grad.size() + rateLm.size()
          + rateF.size() + rateJ.size() + waveSum.size()
        );
}


// ************************************************************************* //
