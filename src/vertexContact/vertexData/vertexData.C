/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexData.H"
#include "variationalLayout.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vertexData::vertexData
(
    const medianDual& dual,
    const schemeOptions& options,
    const kinematicSet kinematics,
    const bool finiteStrain,
    const scalar rho,
    const scalar cp,
    const scalar cs
)
:
    dual(dual),
    variational(options.scheme == schemeType::variational),
    finiteStrain(finiteStrain),
    reconstruction
    (
        variational ? reconstructionType::none : options.reconstruction
    ),
    limiter(options.limiter),
    dissipation(options.dissipation),
    rho(rho),
    cp(cp),
    cs(cs),
    state(dual.nNodes(), dual.nDim(), kinematics, finiteStrain),
    old(state),
    nSJ(state.solvesJ ? 1 : 0),
    nW
    (
        variational
      ? variationalLayout::nW(dual.nDim(), nSJ)
      : paperLayout::nW(dual.nDim(), nSJ)
    ),
    strideW(paddedStride(nW)),
    nG(paperLayout::nG(dual.nDim(), nSJ, reconstruction)),
    strideG(paddedStride(nG)),
    strideRates
    (
        variational
      ? variationalLayout::strideRates(dual.nDim())
      : paddedStride(paperLayout::nRates(dual.nDim(), nSJ, reconstruction))
    ),
    W(dual.nNodes()*strideW),
    grad(variational ? 0 : dual.nNodes()*strideG*dual.nDim()),
    rates(dual.nNodes()*strideRates)
{
    if (!old.solvesH)
    {
        old.H.clear();
    }
    if (variational)
    {
        // The kernel forms it where needed
        state.H.clear();
        state.strideH = old.strideH = 0;
        old.F.clear();
        old.J.clear();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::size_t Foam::vertexData::bytes() const
{
    return
        state.bytes() + old.bytes()
      + sizeof(scalar)
       *std::size_t
        (
            mirrorArea.size() + waveFactor.size() + W.size() + grad.size()
          + rates.size()
        );
}


// ************************************************************************* //
