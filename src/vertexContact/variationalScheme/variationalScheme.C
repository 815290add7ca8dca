/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "variationalScheme.H"
#include "edgeBlocks.H"
#include "lanczos.H"
#include "passTimes.H"
#include "stepLimit.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- 1 - M between square roots of the volumes, so that it is symmetric: an
//  operator for lanczos
class removedShare
{
    // Private data

        const medianDual& dual_;
        variationalData& x_;


public:

    static constexpr label nComponents = 1;

    // Constructors

        removedShare(const medianDual& dual, variationalData& x)
        :
            dual_(dual),
            x_(x)
        {}


    // Member Functions

        void constrain(scalarField&) const {}

        scalar product(const scalarField& u, const scalarField& v) const
        {
            scalar sum = 0;
            forAll(u, a)
            {
                if (dual_.sharing().owned()[a]) sum += u[a]*v[a];
            }
            return returnReduce(sum, sumOp<scalar>());
        }

        void apply(const scalarField& u, scalarField& y) const
        {
            const auto& volume = dual_.nodeVolume();
            forAll(u, a) x_.jacobian[a] = u[a]/std::sqrt(volume[a]);
            x_.smooth(dual_);
            forAll(y, a) y[a] = -std::sqrt(volume[a])*x_.average[a];
        }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::variationalScheme::completeTensors
(
    scalar* data,
    const label stride,
    const label columnStride,
    const label offset,
    const label first,
    const label end
) const
{
    const label d = dual_.nDim();
    FixedList<label, 9> place;
    for (label i = 0; i < d; ++i)
    {
        for (label j = 0; j < d; ++j)
        {
            place[i*d + j] = offset + j*columnStride + i;
        }
    }
    symmetry_.symmetriseTensors
    (
        data, stride, labelUList(place.begin(), d*d),
        x_.lateNodes[first], x_.lateNodes[end - 1] + 1
    );
}


void Foam::variationalScheme::boundFrequencies()
{
    const label d = dual_.nDim();
    const label n = dual_.nNodes();

    scalarField sums(n*(d + 1));
    kernel_->boundColumns(sums);
    dual_.sharing().sum(sums.data(), d + 1);
    kernel_->boundRows(sums, x_.geometricBound);
    dual_.sharing().sum(x_.geometricBound.data(), d*(d + 1)/2);
    const scalar largest =
        returnReduce(kernel_->largestBound(), maxOp<scalar>());

    for (label e = 0; e < 2*dual_.nEdges(); ++e)
    {
        x_.perEdges[dual_.edgeNodes()[e]] += 1;
    }
    dual_.sharing().sum(x_.perEdges.data(), 1);
    for (scalar& n : x_.perEdges) n = 1/n;

    if (x_.smoothed) findFilter();

    // In uniaxial strain there is no shear
    if (d > 1) x_.jumpModulus = ofShearModulus*material_.mu();

    // Round the operator's result to two digits: its last bits depend on the
    // number of processors
    const stepLimit limit(data_, x_, symmetry_);
    const scalar ratio = limit.squaredFrequency()/(sqr(data_.cp)*largest);
    x_.boundRatio =
        std::ceil(hundredths*ratio*(1 - lanczos::roundOff))/hundredths;
    largestFrequency_ = data_.cp*std::sqrt(x_.boundRatio*largest);

    // The state is still undeformed
    const scalar bound = returnReduce(boundOfStep(), minOp<scalar>());
    x_.stepRatio =
        std::floor(hundredths*limit.step()/bound*(1 + lanczos::roundOff))
       /hundredths;
}


void Foam::variationalScheme::smoothJacobian()
{
    const auto removed = [&]
    {
        // w (1 - M)
        x_.smooth(dual_);
        for (scalar& r : x_.average) r *= -x_.filter;
    };
    x_.unsmoothed = x_.jacobian;
    removed();
    for (label power = 1; power < smoothingPower; ++power)
    {
        x_.jacobian = x_.average;
        removed();
    }
    forAll(x_.jacobian, a) x_.jacobian[a] = x_.unsmoothed[a] - x_.average[a];
}


void Foam::variationalScheme::findFilter()
{
    removedShare removed(dual_, x_);
    const scalar largest = lanczos::largestOf(removed, data_, lanczos::steps);

    // With equal cells it may be whole hundredths, but for round-off
    x_.filter =
        hundredths/std::ceil(hundredths*largest*(1 - lanczos::roundOff));
}


void Foam::variationalScheme::start()
{
    for (edgePass& pass : passes_) pass = edgePass(-1);
    stressed_ = 0;
    nextRun_ = earlyRuns_.size();
    nBad_ = passTimes::timed(passTimes::velocities, [&]
    {
        return collected_ ? nBadCollected_ : kernel_->collect();
    });
    collected_ = false;
}


void Foam::variationalScheme::goOn(const label p, const label end)
{
    edgePass& pass = passes_[p];
    const label firstLate = pass.late;
    pass.end = end;
    if (p == fluxes) findStressBefore(passes_[corrections].complete);
    run(p, pass);

    // Nodes that wait only for mirrors are complete with the last edge, too
    if (p < forces) completeLate(p, firstLate, pass.late, false);
}


void Foam::variationalScheme::run(const label p, edgePass& pass)
{
    typedef passTimes times;
    switch (p)
    {
        case gradients:
        {
            nBad_ += times::timed(times::gradients, [&]
            {
                return kernel_->gradients(pass);
            });
            break;
        }
        case corrections:
        {
            nBad_ += times::timed(times::corrections, [&]
            {
                return kernel_->correct(pass);
            });
            break;
        }
        case fluxes:
        {
            times::timed(times::fluxes, [&] { kernel_->fluxes(pass); });
            break;
        }
        default:
        {
            times::timed(times::forces, [&] { kernel_->forces(pass); });
        }
    }
}


template<class GoOn>
void Foam::variationalScheme::follow
(
    const edgePass* passes,
    const label last,
    const GoOn& goOn
) const
{
    bool further = true;
    while (further)
    {
        further = false;
        for (label p = gradients; p <= last; ++p)
        {
            const label now = passes[p].end;
            const label end =
                p == gradients
              ? min(max(now, label(0)) + tile, dual_.nEdges())
              : edgeBlocks::mayGo
                (
                    dual_, x_.toMeet, now, passes[p - 1].complete
                );
            if (end > now)
            {
                goOn(p, end);
                further = true;
            }
        }
    }
}


void Foam::variationalScheme::sweep(const label last)
{
    follow
    (
        passes_, last,
        [&](const label p, const label end) { goOn(p, end); }
    );
}


void Foam::variationalScheme::findStressBefore(const label end)
{
    // Leaves out the early ones, if they have their stress
    while (stressed_ < end)
    {
        const bool more = nextRun_ < earlyRuns_.size();
        if (more && earlyRuns_[nextRun_].first() == stressed_)
        {
            stressed_ = earlyRuns_[nextRun_++].second();
            continue;
        }
        const label stop =
            more ? min(end, earlyRuns_[nextRun_].first()) : end;
        findStress(stressed_, stop);
        stressed_ = stop;
    }
}


void Foam::variationalScheme::findEarlyStress()
{
    for (const labelPair& run : earlyRuns_)
    {
        findStress(run.first(), run.second());
    }
    nextRun_ = 0;
    if (!x_.early.any()) findStressBefore(dual_.nNodes());
}


void Foam::variationalScheme::findStress(const label first, const label end)
{
    passTimes::timed(passTimes::stress, [&]
    {
        material_.stressOf
        (
            data_.state,
            data_.W.data() + data_.offsetP(),
            data_.nSJ ? data_.W.data() + data_.offsetSJ() : nullptr,
            data_.strideW,
            first,
            end
        );
    });
    if (wavesAnew_)
    {
        passTimes::timed(passTimes::waveSpeeds, [&]
        {
            material_.waveFactorsOf
            (
                data_.state, data_.waveFactor, first, end
            );
        });
    }
}


Foam::label Foam::variationalScheme::mostBetween() const
{
    edgePass passes[nPasses] =
        {edgePass(-1), edgePass(-1), edgePass(-1), edgePass(-1)};
    label most = 0;
    follow
    (
        passes, fluxes,
        [&](const label p, const label end)
        {
            passes[p].end = end;
            passes[p].complete = edgeBlocks::nodesBefore(dual_, end);
            most = max(most, passes[corrections].end - passes[fluxes].end);
        }
    );
    return most;
}


void Foam::variationalScheme::completeLate
(
    const label p,
    const label first,
    const label end,
    const bool early
)
{
    for (label i = first; i < end;)
    {
        label next = i;
        while
        (
            next < end
         && x_.early.completes(p, x_.lateNodes[next]) == early
        )
        {
            ++next;
        }
        if (next > i) completeLate(p, i, next);
        i = next + 1;
    }
}


void Foam::variationalScheme::completeLate
(
    const label p,
    const label first,
    const label end
)
{
    const label d = dual_.nDim();
    const label sA = variationalLayout::strideColumn(d);
    const auto complete = [&](alignedScalars& data, const label offset)
    {
        if (!symmetry_.active()) return;
        completeTensors(data.data(), d*sA, sA, offset, first, end);
    };
    typedef passTimes times;
    if (p == gradients)
    {
        nBad_ += times::timed(times::inverses, [&]
        {
            complete(x_.grad, 0);
            complete(x_.grad, variationalLayout::second(d));
            return kernel_->deform(first, end);
        });
    }
    else if (p == corrections)
    {
        nBad_ += times::timed(times::kinematics, [&]
        {
            if (x_.beta > 0) complete(x_.adjoint, 0);
            if (d > 1)
            {
                complete
                (
                    x_.adjoint, variationalLayout::atJump(d, x_.beta > 0)
                );
            }
            return kernel_->kinematics(first, end);
        });
    }
    else
    {
        times::timed(times::adjoint, [&]
        {
            complete(x_.adjoint, 0);
            complete(x_.adjoint, variationalLayout::second(d));
            kernel_->stresses(first, end);
        });
    }
}


void Foam::variationalScheme::completeShared(const label p)
{
    if (!dual_.sharing().active()) return;
    if (x_.early.any())
    {
        edgePass pass;
        pass.early = true;
        run(p, pass);
    }
    else
    {
        passes_[p].end = dual_.nEdges();
        run(p, passes_[p]);
    }

    const label d = dual_.nDim();
    const label sA = variationalLayout::strideColumn(d);
    const label sS = variationalLayout::strideSensor(d);
    passTimes::timed(passTimes::processors, [&]
    {
        const nodeSharing& sharing = dual_.sharing();
        if (p == gradients)
        {
            sharing.sum(x_.grad.data(), d*sA);
        }
        else if (p == fluxes)
        {
            sharing.sum(x_.adjoint.data(), d*sA);
        }
        else if (d > 1 || x_.beta > 0)
        {
            sharing.sum({{x_.adjoint.data(), d*sA}, {x_.sensor.data(), sS}});
        }
        else
        {
            sharing.sum(x_.sensor.data(), sS);
        }
    });
    completeLate(p, 0, x_.lateNodes.size(), x_.early.any());
}


void Foam::variationalScheme::findJacobian()
{
    passTimes::timed(passTimes::volume, [&]
    {
        smoothJacobian();
        data_.state.J = x_.jacobian;
    });
}


void Foam::variationalScheme::smoothPressure()
{
    // S SigmaJ acts in place of the SigmaJ of the smoothed J
    passTimes::timed(passTimes::volume, [&]
    {
        forAll(x_.jacobian, a)
        {
            x_.jacobian[a] = data_.W[a*data_.strideW + data_.offsetSJ()];
        }
        smoothJacobian();
        kernel_->addPressure();
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::variationalScheme::variationalScheme
(
    vertexData& data,
    const materialModel& material,
    const symmetryConstraint& symmetry,
    const schemeOptions& options,
    const labelList& mirrorPatches
)
:
    data_(data),
    dual_(data.dual),
    material_(material),
    symmetry_(symmetry),
    x_
    (
        data, options.correction, options.dissipation,
        options.frontDissipation, data.state.solvesJ
    ),
    kernel_(variationalKernel::New(data_, x_))
{
    for (const dualPatch& patch : dual_.patches())
    {
        if (!mirrorPatches.found(patch.patchIndex))
        {
            x_.addPairs(patch);
        }
    }
    x_.joinPairs(dual_);
    labelHashSet late(dual_.sharing().sharedNodes());
    late.insert(symmetry_.nodes());
    x_.setLate(late.sortedToc(), dual_.nDim());
    const bool shares = dual_.sharing().active();
    if (shares)
    {
        // If most edges are early, it is better to do all of them in order
        earlyEdges early
        (
            dual_, x_.pairNodes, dual_.sharing().sharedNodes(), x_.lateNodes
        );
        if (2*nLanes*early.blocks(gradients).size() < dual_.nEdges())
        {
            x_.early = std::move(early);
        }
        DynamicList<labelPair> runs;
        for (const label a : x_.early.reached(earlyEdges::fluxes))
        {
            if (runs.empty() || runs.last().second() != a)
            {
                runs.append(labelPair(a, a));
            }
            ++runs.last().second();
        }
        earlyRuns_.transfer(runs);
    }
    if (!x_.smoothed && (x_.early.any() || !shares))
    {
        x_.keepMotion(mostBetween(), dual_.nDim());
    }
    boundFrequencies();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::variationalScheme::deform()
{
    start();
    completeShared(gradients);
    completeShared(corrections);
    sweep(corrections);
    if (x_.smoothed) findJacobian();
    return nBad_;
}


Foam::label Foam::variationalScheme::computeForces(const bool wavesAnew)
{
    start();
    wavesAnew_ = wavesAnew;
    if (wavesAnew) data_.waveFactor.setSize(dual_.nNodes());
    completeShared(gradients);
    completeShared(corrections);
    if (x_.smoothed)
    {
        // All nodes wait for each other
        sweep(corrections);
        findJacobian();
        findStressBefore(dual_.nNodes());
        smoothPressure();
    }
    else if (dual_.sharing().active())
    {
        findEarlyStress();
    }
    completeShared(fluxes);
    sweep(forces);
    return nBad_;
}


Foam::scalar Foam::variationalScheme::boundOfStep()
{
    kernel_->sumWaves();
    dual_.sharing().sum
    (
        x_.waves().data(), variationalLayout::strideWaves(dual_.nDim())
    );
    return kernel_->timeScale();
}


Foam::scalar Foam::variationalScheme::timeScale(const bool anew)
{
    if (anew) bound_ = boundOfStep();
    if (!data_.finiteStrain) return bound_;

    // No edge loses more than a third of its length in a step, since the bound
    // is from the stiffness at the start of the step
    return min(bound_, closingTime());
}


Foam::label Foam::variationalScheme::closingNode() const
{
    const label d = dual_.nDim();
    const auto& X = dual_.nodePosition();
    scalar fastest = 0;
    label node = -1;
    for (label e = 0; e < dual_.nEdges(); ++e)
    {
        const label a = dual_.edgeNodes()[2*e], b = dual_.edgeNodes()[2*e + 1];
        scalar xx = VSMALL, xv = 0;
        for (label i = 0; i < d; ++i)
        {
            const label ai = a*d + i, bi = b*d + i;
            const scalar x =
                X[bi] + data_.state.disp[bi] - X[ai] - data_.state.disp[ai];
            xx += sqr(x);
            xv += x*(data_.state.lm[bi] - data_.state.lm[ai]);
        }
        if (-xv/xx > fastest)
        {
            fastest = -xv/xx;
            node = a;
        }
    }
    return node;
}


void Foam::variationalScheme::move(const scalar deltaT, const scalar half)
{
    nBadCollected_ = kernel_->move(deltaT, half);
    collected_ = true;
}


void Foam::variationalScheme::scaleMass(const scalar factor)
{
    largestFrequency_ /= std::sqrt(factor);
}


// ************************************************************************* //
