/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "HenckyVonMises.H"
#include "plasticFlow.H"
#include "dictionaryCheck.H"
#include "addToRunTimeSelectionTable.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(HenckyVonMises, 0);
    addListedModel(materialModel, HenckyVonMises);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

using namespace Foam::plasticFlow;


void Foam::HenckyVonMises::readHeating(const dictionary& dict)
{
    using namespace dictionaryCheck;

    const bool softens = curve_ == curve::JohnsonCook && JohnsonCook_.m > 0;
    if (!dict.found("adiabaticHeating"))
    {
        if (softens)
        {
            FatalIOErrorInFunction(dict.subDict("JohnsonCook"))
                << "Keyword 'm' " << JohnsonCook_.m << " needs the temperature "
                << "of the material, and nothing computes it." << nl
                << "Add adiabaticHeating { cp <specific heat>; } to the "
                << "material" << exit(FatalIOError);
        }
        return;
    }

    const dictionary& heating = subDict(dict, "adiabaticHeating", "cp 385;");
    const keywordList described(heatingKeywords());
    onlyKeywords(heating, described);
    const scalar beta = readOptional(heating, described, "beta", dimless);
    const scalar c =
        readNumber(heating, "cp", sqr(dimVelocity)/dimTemperature);
    T0_ = readOptional(heating, described, "T0", dimTemperature);
    require(beta >= 0 && beta <= 1, heating, "beta", beta, "from 0 to 1");
    require(c > 0, heating, "cp", c, "positive");
    require(T0_ > 0, heating, "T0", T0_, "positive");
    heatPerWork_ = beta/(weightRho()*c);

    if (softens)
    {
        const dictionary& law = dict.subDict("JohnsonCook");
        const bool given = law.found("Troom");
        if (!given) JohnsonCook_.Troom = T0_;
        require
        (
            JohnsonCook_.Tmelt > T0_, law, "Tmelt", JohnsonCook_.Tmelt,
            given
          ? "above T0 of adiabaticHeating: melted metal has no yield stress"
          : "above Troom, which is T0 unless it is given"
        );
        thermalJohnsonCook_ = hardening::thermalJohnsonCook(JohnsonCook_);
        curve_ = curve::thermalJohnsonCook;
    }
}


template<int D, bool stretched, class Hardening>
void Foam::HenckyVonMises::stressLoop
(
    const Hardening& yield,
    const conservedState& s,
    scalar* __restrict P,
    scalar* __restrict SigmaJ,
    const label stride,
    const label first,
    const label end
) const
{
    const scalar twoMu = 2*mu(), threeMu = 3*mu();

    const auto atNode = [&](const label i, const trialState<D>& trial)
    {
        const SolidTensor<D> F = loadF<D>(s.F.cdata(), i);
        const SolidTensor<D> G = cofactor(F);
        const scalar detF = determinant(F, G);
        const SolidTensor<D> H =
            s.solvesH ? loadH<D>(F, s.H.cdata(), i) : G;
        const scalar J = s.solvesJ ? s.J[i] : detF;

        const flowState flow(trial, yield, s, i, threeMu);
        if (s.keepsFlow)
        {
            s.flow.increment[i] = flow.increment;
            if (flow.increment > 0)
            {
                s.flow.work[i] = perMesh<stretched>(flow.work, i);
                scalar* flown = s.flow.Cpi.data() + i*s.strideCpi;
                if constexpr (stretched)
                {
                    const SolidTensor<D> natural =
                        naturalF<D, true>(initial(), s, i);
                    storeCpi(flown, flownCpi(trial, flow.shrink, natural));
                }
                else
                {
                    storeCpi(flown, flownCpi(trial, flow.shrink, G, detF));
                }
            }
        }

        // Kirchhoff stress, and P = tau F^-T + SigmaJ H. With an initial
        // stretch so, too: (F F0)^-T F0^T = F^-T, and the same with H
        scalar tau[3];
        for (int k = 0; k < 3; ++k)
        {
            tau[k] =
                perMesh<stretched>(flow.shrink*twoMu*trial.deviator[k], i);
        }
        const SolidTensor<D> T = trial.b.compose(tau);
        const scalar naturalJ = stretched ? J*initial().J(i) : J;
        const scalar SJ = kappa()*safeLog(naturalJ)/naturalJ;
        const scalar perDetF = 1/detF;
        for (int a = 0; a < D; ++a)
        {
            for (int j = 0; j < D; ++j)
            {
                scalar sum = 0;
                for (int k = 0; k < D; ++k) sum += T(a, k)*G(k, j);
                P[i*stride + j*D + a] = perDetF*sum + SJ*H(a, j);
            }
        }
        if (SigmaJ) SigmaJ[i*stride] = SJ;
    };
    forTrialStates<D, stretched>(initial(), s, mu(), first, end, atNode);
}


Foam::scalar Foam::HenckyVonMises::hourglassShare
(
    const conservedState& s,
    const label node
) const
{
    const scalar flown =
        3*mu()*min(plasticStrain(s, node), s.epsilonPEq[node]);
    const scalar y = yieldStress(s.epsilonPEq[node]);
    const scalar elastic =
        flown > 0 ? (flown < y ? 1 - flown/y : scalar(0)) : scalar(1);
    return tangentShare_ + (1 - tangentShare_)*elastic;
}


template<int D, bool stretched, class Hardening>
Foam::scalar Foam::HenckyVonMises::commitLoop
(
    const Hardening& yield,
    conservedState& s,
    const scalarField& weight
) const
{
    const scalar threeMu = 3*mu();
    scalar dissipated = 0;
    const auto atNode = [&](const label i, const trialState<D>& trial)
    {
        const flowState flow(trial, yield, s, i, threeMu);
        if (flow.increment > 0)
        {
            storeCpi
            (
                s.Cpi.data() + i*s.strideCpi,
                flownCpi
                (
                    trial, flow.shrink,
                    naturalF<D, stretched>(initial(), s, i)
                )
            );
            dissipated += takeFlow
            (
                s, i, weight[i], flow.increment,
                perMesh<stretched>(flow.work, i)
            );
        }
    };
    forTrialStates<D, stretched>(initial(), s, mu(), 0, s.nNodes, atNode);
    return dissipated;
}


Foam::scalar Foam::HenckyVonMises::takeFlow
(
    conservedState& s,
    const label i,
    const scalar weight,
    const scalar increment,
    const scalar work
) const
{
    s.epsilonPEq[i] += increment;
    if (s.temperature.size()) s.temperature[i] += heatPerWork_*work;
    return weight*work;
}


Foam::scalar Foam::HenckyVonMises::takeKeptFlow
(
    conservedState& s,
    const scalarField& weight
) const
{
    const label n = s.strideCpi;
    scalar dissipated = 0;
    for (label i = 0; i < s.nNodes; ++i)
    {
        const scalar increment = s.flow.increment[i];
        if (increment > 0)
        {
            const scalar* C = s.flow.Cpi.cdata() + i*n;
            std::copy(C, C + n, s.Cpi.data() + i*n);
            dissipated +=
                takeFlow(s, i, weight[i], increment, s.flow.work[i]);
        }
    }
    return dissipated;
}


template<bool stretched>
inline Foam::scalar Foam::HenckyVonMises::perMesh
(
    const scalar natural,
    const label i
) const
{
    return stretched ? natural/initial().J(i) : natural;
}


template<bool stretched, int D>
inline Foam::scalar Foam::HenckyVonMises::naturalJ
(
    const conservedState& s,
    const label i
) const
{
    const scalar J =
        s.solvesJ ? s.J[i] : determinant(loadF<D>(s.F.cdata(), i));
    return stretched ? J*initial().J(i) : J;
}


template<int D, bool stretched, class TrialState>
Foam::scalar Foam::HenckyVonMises::energyOf
(
    const conservedState& s,
    const label i,
    const TrialState& trial
) const
{
    const scalar J = naturalJ<stretched, D>(s, i);
    scalar sum = 0;
    for (int k = 0; k < 3; ++k) sum += sqr(trial.deviator[k]);
    return perMesh<stretched>(mu()*sum + 0.5*kappa()*sqr(safeLog(J)), i);
}


template<int D, bool stretched>
Foam::tensor Foam::HenckyVonMises::CauchyOfDim
(
    const conservedState& s,
    const label i
) const
{
    // Committed states are elastic
    const trialState<D> trial(trialAt<D, stretched>(initial(), s, i, mu()));
    const scalar J = naturalJ<stretched, D>(s, i);
    scalar tau[3];
    for (int k = 0; k < 3; ++k)
    {
        tau[k] = 2*mu()*trial.deviator[k] + kappa()*safeLog(J);
    }
    const SolidTensor<D> T = trial.b.compose(tau);

    tensor sigma(Zero);
    for (int a = 0; a < 3; ++a)
    {
        for (int b = 0; b < 3; ++b)
        {
            sigma[3*a + b] =
                a < D && b < D ? T(a % D, b % D)/J : a == b ? T.out/J : 0;
        }
    }
    return sigma;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::HenckyVonMises::HenckyVonMises
(
    const dictionary& dict,
    const jacobianForm
)
:
    materialModel(dict, keywords())
{
    const label given =
        label(dict.found("tauY")) + label(dict.found("hardeningCurve"))
      + label(dict.found("JohnsonCook"));
    if (given != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'tauY': " << given << " descriptions of the yield "
            << "stress are given." << nl
            << "Give exactly one of (tauY hardeningCurve JohnsonCook)"
            << exit(FatalIOError);
    }
    if (dict.found("tauY"))
    {
        curve_ = curve::linear;
        linear_ = hardening::linear(dict);
    }
    else if (dict.found("JohnsonCook"))
    {
        curve_ = curve::JohnsonCook;
        JohnsonCook_ = hardening::JohnsonCook
        (
            dictionaryCheck::subDict
            (
                dict, "JohnsonCook", "A 9e7; B 2.9e8; n 0.31; C 0.025;"
            )
        );
    }
    else
    {
        curve_ = curve::table;
        table_ = hardening::table(dict);
    }
    if (curve_ != curve::linear && dict.found("Hardening"))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'Hardening' needs 'tauY', which is not given"
            << exit(FatalIOError);
    }
    readHeating(dict);
    const scalar slope = max(yieldStress(1) - yieldStress(0), scalar(0));
    tangentShare_ = slope/(3*mu() + slope);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::HenckyVonMises::keywords()
{
    const keywordList own
    ({
        {"tauY", "Pa", "one of three", "initial yield stress"},
        {
            "Hardening", "Pa", "0",
            "with tauY: slope of the yield stress over the equivalent plastic "
            "strain"
        },
        {
            "hardeningCurve", "Pa", "one of three",
            "yield stress as a Function1 of the equivalent plastic strain"
        },
        {"hardeningCurveCoeffs", "", "none", "coefficients of the Function1"},
        {
            "maxStrain", "-", "3",
            "last strain of a hardeningCurve that is not a table; constant "
            "beyond it"
        },
        {
            "JohnsonCook", "", "one of three",
            "dictionary; yield stress "
            "(A + B strain^n)(1 + C ln(rate/referenceRate))"
        },
        {
            "adiabaticHeating", "", "none",
            "dictionary; if given, plastic work heats the material (field "
            "pointT)"
        }
    });
    return
        own + hardening::JohnsonCook::keywords().within("JohnsonCook")
      + heatingKeywords().within("adiabaticHeating");
}


Foam::keywordList Foam::HenckyVonMises::heatingKeywords()
{
    return
    {
        {"beta", "-", "0.9", "share of the plastic work that becomes heat"},
        {"cp", "J/kg/K", "required", "specific heat, above 0"},
        {
            "T0", "K", "293.15",
            "initial temperature, unless the start time has pointT"
        }
    };
}


Foam::scalar Foam::HenckyVonMises::yieldStress(const scalar strain) const
{
    return withHardening([&](const auto& h) { return h.yield(strain); });
}


void Foam::HenckyVonMises::stressOf
(
    const conservedState& s,
    scalar* P,
    scalar* SigmaJ,
    const label stride,
    const label first,
    const label end
) const
{
    withHardening([&](const auto& h)
    {
        withScene(s, [&](auto D, auto stretched)
        {
            stressLoop<D.value, stretched.value>
            (
                h, s, P, SigmaJ, stride, first, end
            );
        });
    });
}


Foam::scalar Foam::HenckyVonMises::commit
(
    conservedState& s,
    const scalarField& weight
) const
{
    const scalar dissipated =
        s.keepsFlow
      ? takeKeptFlow(s, weight)
      : withHardening([&](const auto& h)
        {
            return withScene(s, [&](auto D, auto stretched)
            {
                return commitLoop<D.value, stretched.value>(h, s, weight);
            });
        });
    s.sinceCommit = 0;
    return dissipated;
}


Foam::scalar Foam::HenckyVonMises::strainEnergy
(
    const conservedState& s,
    const scalarField& volume
) const
{
    return withScene(s, [&](auto D, auto stretched)
    {
        constexpr bool is = stretched.value;
        scalar sum = 0;
        const auto atNode = [&](const label i, const auto& trial)
        {
            sum += volume[i]*energyOf<D.value, is>(s, i, trial);
        };
        forTrialStates<D.value, is>(initial(), s, mu(), 0, s.nNodes, atNode);
        return sum;
    });
}


Foam::tensor Foam::HenckyVonMises::CauchyStress
(
    const conservedState& s,
    const label node
) const
{
    return withScene(s, [&](auto D, auto stretched)
    {
        return CauchyOfDim<D.value, stretched.value>(s, node);
    });
}


void Foam::HenckyVonMises::waveFactorsOf
(
    const conservedState& s,
    scalarField& factor,
    const label first,
    const label end
) const
{
    const scalar undeformed = kappa() + 4*mu()/3;
    withScene(s, [&](auto directions, auto stretched)
    {
        constexpr int D = directions.value;
        constexpr bool is = stretched.value;
        const auto atNode = [&](const label i, const trialState<D>& trial)
        {
            const scalar J0 = is ? initial().J(i) : 1;
            const scalar J = naturalJ<is, D>(s, i);
            scalar least = GREAT;
            for (int k = 0; k < D; ++k)
            {
                least = min
                (
                    least, 2*mu()*trial.deviator[k] + kappa()*safeLog(J)
                );
            }
            // J0 times the square of the Jacobian from the mesh
            factor[i] = std::sqrt
            (
                max(scalar(1), (1 - least/undeformed)*J0/sqr(J))
            );
        };
        forTrialStates<D, is>(initial(), s, mu(), first, end, atNode);
    });
}


Foam::Pair<Foam::scalar> Foam::HenckyVonMises::yieldState
(
    const conservedState& s,
    const label node
) const
{
    return withScene(s, [&](auto D, auto stretched)
    {
        const scalar yield = withHardening([&](const auto& h)
        {
            return
                hardening::softening(h, s.temperature, node)
               *h.yield(s.epsilonPEq[node]);
        });
        return Pair<scalar>
        (
            trialAt<D.value, stretched.value>(initial(), s, node, mu()).q,
            yield
        );
    });
}


// ************************************************************************* //
