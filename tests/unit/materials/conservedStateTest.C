/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    conservedState holds what a scene requires, and nothing else.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "conservedState.H"
#include "tensors/fullTensor.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("arrays of the state", "[conservedState][serial]")
{
    const struct
    {
        label nDim;
        kinematicSet set;
        bool finiteStrain;
        label perNodeH, perNodeJ;
        bool solvesH;
    }
    expected[] =
    {
        {1, kinematicSet::F, true, 0, 0, false},
        {1, kinematicSet::FJ, true, 0, 1, false},
        {1, kinematicSet::FHJ, true, 0, 1, false},
        {2, kinematicSet::F, true, 0, 0, false},
        {2, kinematicSet::FJ, true, 0, 1, false},
        {2, kinematicSet::FHJ, true, 1, 1, true},
        {3, kinematicSet::F, true, 9, 0, false},
        {3, kinematicSet::FJ, true, 9, 1, false},
        {3, kinematicSet::FHJ, true, 9, 1, true},
        {1, kinematicSet::FHJ, false, 0, 0, false},
        {2, kinematicSet::FHJ, false, 0, 0, false},
        {3, kinematicSet::FHJ, false, 0, 0, false},
        {3, kinematicSet::F, false, 0, 0, false}
    };

    const label nNodes = 7;
    for (const auto& e : expected)
    {
        INFO
        (
            "D = " << e.nDim << ", " << conservedState::kinematicSetNames[e.set]
            << ", finite strain " << e.finiteStrain
        );
        const conservedState s(nNodes, e.nDim, e.set, e.finiteStrain);
        const label d = e.nDim;

        CHECK(s.nNodes == nNodes);
        CHECK(s.nDim == d);
        CHECK(s.lm.size() == nNodes*d);
        CHECK(s.disp.size() == nNodes*d);
        CHECK(s.F.size() == nNodes*d*d);
        CHECK(s.H.size() == nNodes*e.perNodeH + (e.perNodeH == 9 ? 1 : 0));
        CHECK(s.strideH == e.perNodeH);
        CHECK(s.J.size() == nNodes*e.perNodeJ);
        CHECK(s.solvesH == e.solvesH);
        CHECK(s.solvesJ == (e.perNodeJ == 1));
        CHECK
        (
            s.bytes()
         == (nNodes*(2*d + d*d + e.perNodeJ) + s.H.size())*sizeof(scalar)
        );

        // Undeformed and at rest
        CHECK(s.lm == scalarField(s.lm.size(), Zero));
        CHECK(s.disp == scalarField(s.disp.size(), Zero));
        CHECK(s.J == scalarField(s.J.size(), scalar(1)));
        for (label i = 0; i < s.F.size(); ++i)
        {
            const label k = i % (d*d);
            CHECK(s.F[i] == (k/d == k % d ? 1 : 0));
        }
        for (label i = 0; i < s.nNodes*s.strideH; ++i)
        {
            const label k = i % e.perNodeH;
            CHECK(s.H[i] == (e.perNodeH == 1 || k/3 == k % 3 ? 1 : 0));
        }
    }
}


TEST_CASE("names of the kinematic sets", "[conservedState][serial]")
{
    const auto& names = conservedState::kinematicSetNames;
    CHECK(names.size() == 3);
    CHECK(names["F"] == kinematicSet::F);
    CHECK(names["FJ"] == kinematicSet::FJ);
    CHECK(names["FHJ"] == kinematicSet::FHJ);
}


TEST_CASE
(
    "the cofactor in the plane is F's, to the last bit",
    "[conservedState][serial]"
)
{
    Random random(1);
    scalar F[2*4], H[2];
    for (label sample = 0; sample < 100; ++sample)
    {
        for (scalar& f : F) f = randomScalar(random);
        for (scalar& h : H) h = randomScalar(random);
        for (label node = 0; node < 2; ++node)
        {
            const scalar* f = F + 4*node;
            const auto F2 = loadF<2>(F, node);
            CHECK(F2.out == 1);
            for (int k = 0; k < 4; ++k) CHECK(F2.in[k] == f[k]);

            const scalar* const stored[] = {nullptr, H};
            for (const scalar* h : stored)
            {
                const auto H2 = loadH<2>(F2, h, node);
                CHECK(H2.in[0] == f[3]);
                CHECK(H2.in[1] == -f[2]);
                CHECK(H2.in[2] == -f[1]);
                CHECK(H2.in[3] == f[0]);
                if (h)
                {
                    CHECK(H2.out == h[node]);
                }
                else
                {
                    CHECK(mag(H2.out - (f[0]*f[3] - f[1]*f[2])) <= 1e-15);
                }
            }
        }
    }
}


TEST_CASE
(
    "the cofactor in one and three dimensions",
    "[conservedState][serial]"
)
{
    Random random(2);
    scalar F[2*9], H[2*9];
    for (scalar& f : F) f = randomScalar(random);
    for (scalar& h : H) h = randomScalar(random);

    for (label node = 0; node < 2; ++node)
    {
        const auto F3 = loadF<3>(F, node);
        const auto H3 = loadH<3>(F3, H, node);
        for (int k = 0; k < 9; ++k)
        {
            CHECK(F3.in[k] == F[9*node + k]);
            CHECK(H3.in[k] == H[9*node + 3*(k % 3) + k/3]);
        }

        const auto F1 = loadF<1>(F, node);
        const auto H1 = loadH<1>(F1, nullptr, node);
        CHECK(F1.in[0] == F[node]);
        CHECK(F1.out == 1);
        CHECK(H1.in[0] == 1);
        CHECK(H1.out == F[node]);
    }
}


// ************************************************************************* //
