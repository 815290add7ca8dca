/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conservedState.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::kinematicSet>
Foam::conservedState::kinematicSetNames
({
    { kinematicSet::F, "F" },
    { kinematicSet::FJ, "FJ" },
    { kinematicSet::FHJ, "FHJ" },
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::conservedState::conservedState
(
    const label nNodes,
    const label nDim,
    const kinematicSet set,
    const bool finiteStrain
)
:
    nNodes(nNodes),
    nDim(nDim),
    solvesH(finiteStrain && set == kinematicSet::FHJ && nDim > 1),
    solvesJ(finiteStrain && set != kinematicSet::F),
    strideH(!finiteStrain ? 0 : nDim == 3 ? 9 : solvesH ? 1 : 0),
    lm(nNodes*nDim, Zero),
    disp(nNodes*nDim, Zero),
    F(nNodes*nDim*nDim, Zero),
    // One entry more, since the last column is read as a whole row
    H(nNodes*strideH + (strideH == 9 ? 1 : 0), Zero),
    J(solvesJ ? nNodes : 0, scalar(1))
{
    const label dd = nDim*nDim;
    for (label i = 0; i < nNodes; ++i)
    {
        for (label k = 0; k < dd; k += nDim + 1)
        {
            F[i*dd + k] = 1;
        }
        for (label k = 0; k < strideH; k += 4)
        {
            H[i*strideH + k] = 1;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::conservedState::makePlastic()
{
    strideCpi = nDim == 3 ? 6 : 2*nDim;
    Cpi.setSize(nNodes*strideCpi, Zero);
    epsilonPEq.setSize(nNodes, Zero);
    for (label i = 0; i < nNodes; ++i)
    {
        scalar* C = Cpi.data() + i*strideCpi;
        for (label a = 0, k = 0; a < nDim; ++a)
        {
            C[k] = 1;
            k += nDim - a;
        }
        if (nDim < 3) C[strideCpi - 1] = 1;
    }
}


void Foam::conservedState::keepFlow()
{
    keepsFlow = true;
    flow.increment.setSize(nNodes, Zero);
    flow.work.setSize(nNodes, Zero);
    flow.Cpi.setSize(Cpi.size(), Zero);
    if (nDim < 2) return;
    hourglassShare.setSize(nNodes, scalar(1));
    flow.jumpEnergy.setSize(nNodes, Zero);
}


void Foam::conservedState::makeHeated(const scalar T)
{
    temperature.setSize(nNodes);
    temperature = T;
}


void Foam::conservedState::assignSolved(const conservedState& other)
{
    lm = other.lm;
    disp = other.disp;
    F = other.F;
    if (solvesH) H = other.H;
    J = other.J;
}


void Foam::conservedState::assignPlastic(const conservedState& other)
{
    Cpi = other.Cpi;
    epsilonPEq = other.epsilonPEq;
    temperature = other.temperature;
    hourglassShare = other.hourglassShare;
}


void Foam::conservedState::exchangeMomentum(conservedState& other)
{
    lm.swap(other.lm);
}


void Foam::conservedState::exchangeKinematics(conservedState& other)
{
    disp.swap(other.disp);
    F.swap(other.F);
    if (solvesH) H.swap(other.H);
    J.swap(other.J);
}


std::size_t Foam::conservedState::bytes() const
{
    return
        sizeof(scalar)
       *std::size_t
        (
            lm.size() + disp.size() + F.size() + H.size() + J.size()
          + Cpi.size() + epsilonPEq.size() + temperature.size()
          + flow.increment.size() + flow.work.size() + flow.Cpi.size()
          + hourglassShare.size() + flow.jumpEnergy.size()
        );
}


// ************************************************************************* //
