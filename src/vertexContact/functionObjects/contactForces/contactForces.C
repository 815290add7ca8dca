/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactForces.H"
#include "dictionaryCheck.H"
#include "rankRows.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidFunctionObject(contactForces)


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;
using Foam::vector;

//- Forces on both sides of a pair, for the filter [N]
struct pairForces
{
    vector minus, plus;
};

//- Values of a pair that are summed over the processors
struct pairSums
{
    vector force, impulse, plusForce, plusImpulse;
    scalar area, nOpen, nStick, nSlip, gapArea, gapForce, friction;

    //- Magnitudes of the impulses, which may cancel between processors
    scalar turnover;
};

//- Values of which the largest over the processors counts
struct pairPeaks
{
    scalar pressure, penetration, relativePenetration;
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::functionObjects::contactForces::keyOf
(
    const contactInterface& contact,
    const contactInterface::pairState& pair
)
{
    return word
    (
        contact.name() + ' ' + pair.names.first() + ' '
      + pair.names.second(),
        false
    );
}


void Foam::functionObjects::contactForces::filter()
{
    if (!filter_.valid() || filteredStep_ == runTime_.timeIndex()) return;
    filteredStep_ = runTime_.timeIndex();
    const scalar since = runTime_.value() - filteredTime_;
    filteredTime_ = runTime_.value();

    // One reduction for all
    List<List<contactInterface::pairState>> pairs(files_.size());
    label n = 0;
    forAll(pairs, i)
    {
        pairs[i] = solids_.interfaces()[i].pairStates();
        n += pairs[i].size();
    }
    List<pairForces> forces(n);
    label next = 0;
    for (const auto& list : pairs)
    {
        for (const contactInterface::pairState& pair : list)
        {
            const contactInterface::statistics none;
            const auto& s = pair.stage ? *pair.stage : none;
            forces[next++] = {s.force, s.plusForce};
        }
    }
    combineRows(forces, plusEqOp<scalar>());
    if (!Pstream::master()) return;

    next = 0;
    forAll(pairs, i)
    {
        for (const contactInterface::pairState& pair : pairs[i])
        {
            const pairForces& its = forces[next++];
            const word key(keyOf(solids_.interfaces()[i], pair));
            if (mag(its.minus) + mag(its.plus) > 0 || filtered_.found(key))
            {
                FixedList<lowPass::state, 2>& s = filtered_(key);
                filter_->advance(s[0], its.minus, since);
                filter_->advance(s[1], its.plus, since);
            }
        }
    }
}


void Foam::functionObjects::contactForces::writeRecord(Ostream& os)
{
    filter();
    const wordList keys(filtered_.sortedToc());
    os  << "    pairs (";
    for (const word& key : keys)
    {
        os  << " \"" << key.c_str() << '"';
    }
    os  << ");" << nl << "    states (";
    for (const word& key : keys)
    {
        for (const lowPass::state& s : filtered_[key])
        {
            os  << ' ' << s.input << ' ' << s.value << ' ' << s.rate;
        }
    }
    os  << ");" << nl;
}


void Foam::functionObjects::contactForces::readRecord()
{
    const dictionary record(solids_.records().of(name()));
    if (!Pstream::master() || !record.found("pairs")) return;

    const List<string> pairs(record.get<List<string>>("pairs"));
    const List<vector> states(record.get<List<vector>>("states"));
    label i = 0;
    for (const string& key : pairs)
    {
        for (lowPass::state& s : filtered_(word(key, false)))
        {
            s.input = states[i++];
            s.value = states[i++];
            s.rate = states[i++];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::contactForces::contactForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    solidFunctionObject(name, runTime, dict),
    files_(solids_.interfaces().size()),
    impulses_(files_.size())
{
    checkKeywords(dict, keywords());

    if (dict.found("filterFrequency"))
    {
        const scalar frequency = dictionaryCheck::readNumber
        (
            dict, "filterFrequency", dimless/dimTime
        );
        dictionaryCheck::require
        (
            frequency > 0, dict, "filterFrequency", frequency, "positive"
        );
        const label nPoles = dictionaryCheck::readOptional<label>
        (
            dict, keywords(), "filterPoles"
        );
        dictionaryCheck::require
        (
            nPoles == 1 || nPoles == 2, dict, "filterPoles", nPoles, "1 or 2"
        );
        filter_.reset(new lowPass(frequency, nPoles));
        filteredStep_ = runTime_.timeIndex();
        filteredTime_ = runTime_.value();
        readRecord();
        solids_.records().keep(name, [this](Ostream& os) { writeRecord(os); });
    }
    else if (dict.found("filterPoles"))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'filterPoles' needs a 'filterFrequency' [Hz]"
            << exit(FatalIOError);
    }

    forAll(files_, i)
    {
        const contactInterface& contact = solids_.interfaces()[i];
        autoPtr<OFstream> file(openFile(contact.name() + ".dat"));

        if (Pstream::master())
        {
            OFstream& os = *file;
            if (filter_.valid())
            {
                os  << "# filteredF: behind a causal low-pass filter, cut-off "
                    << filter_->frequency() << " Hz, poles "
                    << filter_->nPoles() << endl;
            }
            os  << "# Time[s]" << (contact.many() ? " minus plus" : "");
            const Pair<string> sides(contact.sideNames());
            for (const string* side : {&sides.first(), &sides.second()})
            {
                writeHeads
                (
                    os, *side,
                    {
                        "Fx[N]", "Fy[N]", "Fz[N]",
                        "Ix[N.s]", "Iy[N.s]", "Iz[N.s]"
                    }
                );
            }
            os  << " area[m2] peakPressure[Pa] penetration[m]"
                << " relativePenetration[-] open stick slip"
                << " gapArea[m2] gapForce[N] frictionDissipation[J]";
            if (filter_.valid())
            {
                for (const string* side : {&sides.first(), &sides.second()})
                {
                    writeHeads
                    (
                        os, *side,
                        {"filteredFx[N]", "filteredFy[N]", "filteredFz[N]"}
                    );
                }
            }
            os  << endl;
            files_.set(i, file.ptr());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::functionObjects::contactForces::keywords()
{
    return
    {
        {
            "filterFrequency", "Hz", "no filter",
            "cut-off of a low-pass filter; adds columns of filtered forces"
        },
        {"filterPoles", "-", "2", "number of poles of the filter, 1 or 2"}
    };
}


bool Foam::functionObjects::contactForces::execute()
{
    filter();
    return true;
}


bool Foam::functionObjects::contactForces::writeRow()
{
    filter();
    forAll(files_, i)
    {
        const contactInterface& contact = solids_.interfaces()[i];
        const List<contactInterface::pairState> pairs(contact.pairStates());

        // Two reductions for all pairs
        List<pairSums> sums(pairs.size());
        List<pairPeaks> peaks(pairs.size());
        forAll(pairs, j)
        {
            const contactInterface::statistics none;
            const auto& s = pairs[j].stage ? *pairs[j].stage : none;
            const auto& account = *pairs[j].sums;
            sums[j] =
            {
                s.force, account.impulse, s.plusForce, account.plusImpulse,
                s.area, scalar(s.nOpen), scalar(s.nStick), scalar(s.nSlip),
                s.gapArea, s.gapForce, account.friction,
                mag(account.impulse) + mag(account.plusImpulse)
            };
            peaks[j] = {s.peakPressure, s.penetration, s.relativePenetration};
        }
        combineRows(sums, plusEqOp<scalar>());
        combineRows(peaks, maxEqOp<scalar>());
        if (!Pstream::master()) continue;

        OFstream& os = files_[i];
        forAll(pairs, j)
        {
            const pairSums& s = sums[j];
            const pairPeaks& most = peaks[j];
            const word key(keyOf(contact, pairs[j]));
            const auto known = filtered_.cfind(key);
            if (contact.many())
            {
                // Pairs that touch, or have touched since the last row
                const bool touches = s.nStick + s.nSlip > 0;
                scalar& last = impulses_[i](key);
                const bool touched = s.turnover != last;
                last = s.turnover;
                if (!touches && !touched && !known.good()) continue;
            }

            os  << runTime_.value();
            if (contact.many())
            {
                os  << ' ' << pairs[j].names.first().c_str()
                    << ' ' << pairs[j].names.second().c_str();
            }
            appendNumbers
            (
                os, s.force, s.impulse, s.plusForce, s.plusImpulse, s.area,
                most.pressure, most.penetration, most.relativePenetration
            );
            for (const scalar n : {s.nOpen, s.nStick, s.nSlip})
            {
                os  << ' ' << label(n);
            }
            appendNumbers(os, s.gapArea, s.gapForce, s.friction);
            if (filter_.valid())
            {
                for (label side = 0; side < 2; ++side)
                {
                    appendNumbers
                    (
                        os, known.good() ? (*known)[side].value : vector::zero
                    );
                }
            }
            os  << endl;
        }
    }

    return true;
}


// ************************************************************************* //
