/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runWarnings.H"
#include "foldedCells.H"
#include "solidSystem.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Largest |F - I| at which a law of small strains may be chosen, and the one
//  up to which it is as good as others
constexpr scalar leavesSmall = 0.05;
constexpr scalar staysSmall = 0.005;

//- Gain, as a share of the energy, that causes a warning
constexpr scalar gains = 0.01;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::runWarnings::checkDeformations
(
    const PtrList<solidBody>& bodies
)
{
    forAll(bodies, i)
    {
        scalar& largest = largestGradient_[i];
        const bool warned = largest > leavesSmall;
        largest = max(largest, bodies[i].largestGradient());
        if (bodies[i].data().finiteStrain || warned) continue;
        reduce(largest, maxOp<scalar>());
        if (largest > leavesSmall)
        {
            WarningInFunction
                << "Region " << bodies[i].name() << ": |F - I| has reached "
                << largest << ", but " << bodies[i].material().type()
                << " is a law of small strains and rotations. Its stress is "
                << "then wrong by about as much." << nl
                << "    neoHookean is a law of large strains; "
                << "tests/benchmark/features.md has its cost per step." << endl;
        }
    }
}


void Foam::runWarnings::checkCells(const PtrList<solidBody>& bodies)
{
    forAll(bodies, i)
    {
        const solidBody& body = bodies[i];
        if (folded_[i] || body.rigid()) continue;
        const labelList& node = body.dual().pointNode();
        pointField x(node.size());
        forAll(x, p)
        {
            x[p] = body.mesh().points()[p]
              + body.position(node[p]) - body.meshPoint(node[p]);
        }
        const labelList folds(foldedCells(body.mesh(), x));
        const label all = returnReduce(folds.size(), sumOp<label>());
        if (!all) continue;

        folded_[i] = true;
        const string where = solidSystem::firstOf
        (
            folds.empty() ? string() : body.whereIs(node[folds[0]])
        );
        WarningInFunction
            << "Region " << body.name() << ": at time "
            << body.mesh().time().timeName() << ' ' << all << " of "
            << returnReduce(body.mesh().nCells(), sumOp<label>())
            << " cells are folded: edges at a corner have changed their "
            << "orientation, at first at the " << where.c_str() << '.' << nl
            << "    Stresses are wrong there. Likely cures: a finer mesh, or "
            << "round edges of what presses there; a new mesh of the deformed "
            << "body, with mapState." << endl;
    }
}


void Foam::runWarnings::checkEnergies
(
    const PtrList<solidBody>& bodies,
    const List<bodyEnergies>& all
)
{
    forAll(bodies, i)
    {
        const bodyEnergies& e = all[i];
        const scalar share =
            -e.numericalDissipation/max(e.total(), e.roundOff);
        if (!warnedOfGain_ && share > gains)
        {
            warnedOfGain_ = true;
            WarningInFunction
                << "Region " << bodies[i].name() << " has gained "
                << 100*share << " % of its energy from the fluxes, which "
                << "should only dissipate (numericalDissipation < 0)." << nl
                << "    Likely cures: "
                << (
                       bodies[i].variational()
                     ? "a smaller maxCo."
                     : "'reconstruction linear', which does not gain energy; "
                       "more than three cells across the body."
                   )
                << endl;
        }
    }

    const bodyEnergies& e = all.last();
    const scalar own = e.kept() - e.externalWork;
    for (label i = 0; i < 2; ++i)
    {
        const scalar now = i ? own - e.contactWork : own;
        least_[i] = min(least_[i], now);
        rise_[i] = max(rise_[i], now - least_[i]);
    }
    largest_ = max(largest_, max(e.total(), e.roundOff));
    roundOff_ = e.roundOff;
    given_ = max(given_, e.contactGain);
    unbalanced_ = max
    (
        unbalanced_,
        mag(e.balance)
       /(
            e.total() + mag(e.numericalDissipation) + e.plasticDissipation
          + e.dampingDissipation + e.relaxationDissipation
          + e.roundOff/gains + VSMALL
        )
    );
}


void Foam::runWarnings::reportGain() const
{
    // The first rise ignores the work of moving obstacles. The second counts
    // energy that contact stores and returns as a rise. Take the smaller one
    const scalar rise = min(rise_[0], rise_[1]);
    const scalar least = gains*largest_ + roundOff_;
    if (!warnedOfGain_ && rise > least)
    {
        WarningInFunction
            << "The energy has risen by " << 100*rise/largest_
            << " % of its largest value, without work." << nl
            << "    Likely cures: a finer mesh, a smaller maxCo; with constant "
            << "loads another law than 'tied'." << nl
            << "    'maxEnergyRise' in controlDict ends a run when the energy "
            << "rises."
            << endl;
    }
    else if (unbalanced_ > gains)
    {
        WarningInFunction
            << "The energies do not balance: " << 100*unbalanced_
            << " % of them is not accounted for ('balance' in the log)." << nl
            << "    Likely cures: a smaller maxCo, or 'preset balanced' "
            << "instead of 'fast'; a finer mesh." << nl
            << "    A restart with another mass, material or scheme also "
            << "changes the energy." << endl;
    }
    if (given_ > least)
    {
        WarningInFunction
            << "Contact has given the bodies " << 100*given_/largest_
            << " % of their largest energy, although no obstacle moves." << nl
            << "    Likely causes: surfaces that were inside each other at the "
            << "start (checkContact); a mesh that is too coarse where edges "
            << "or corners meet." << nl
            << "    'maxEnergyRise' in controlDict ends a run when the energy "
            << "rises." << endl;
    }
}


void Foam::runWarnings::reportLaws
(
    const PtrList<solidBody>& bodies,
    Ostream& os
) const
{
    forAll(bodies, i)
    {
        const solidBody& body = bodies[i];
        if (!body.data().finiteStrain || body.rigid()) continue;
        if (body.material().plastic())
        {
            const scalar flow = returnReduce
            (
                max(body.state().epsilonPEq), maxOp<scalar>()
            );
            if (flow == 0)
            {
                os  << "Region " << body.name() << " has not yielded: a step "
                    << "with neoHookean takes less time than a step with "
                    << body.material().type() << nl << nl;
            }
            continue;
        }
        const scalar largest =
            returnReduce(largestGradient_[i], maxOp<scalar>());
        if (largest < staysSmall)
        {
            os  << "Region " << body.name() << ": |F - I| stayed below "
                << largest << " at all log lines. linearElastic, whose "
                << "stress differs by about as much, takes less time than "
                << body.material().type() << nl << nl;
        }
    }
}


// ************************************************************************* //
