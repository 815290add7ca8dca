/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactForces.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidFunctionObject(contactForces)


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Numbers of a pair that are added up over the processors, and of which the
//  largest counts
constexpr Foam::label nSums = 20;
constexpr Foam::label nPeaks = 3;

void put(Foam::scalar*& p, const Foam::vector& v)
{
    for (const Foam::scalar c : v) *p++ = c;
}

void put(Foam::scalar*& p, const Foam::scalar value)
{
    *p++ = value;
}

Foam::vector take(const Foam::scalar*& p)
{
    const Foam::vector v(p[0], p[1], p[2]);
    p += 3;
    return v;
}

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

    // One reduction for all
    List<List<contactInterface::pairState>> pairs(files_.size());
    label n = 0;
    forAll(pairs, i)
    {
        pairs[i] = solids_.interfaces()[i].pairStates();
        n += pairs[i].size();
    }
    scalarList forces(6*n, scalar(0));
    scalar* f = forces.data();
    for (const auto& list : pairs)
    {
        for (const contactInterface::pairState& pair : list)
        {
            put(f, pair.stage ? pair.stage->force : vector::zero);
            put(f, pair.stage ? pair.stage->plusForce : vector::zero);
        }
    }
    Pstream::listCombineGather(forces, plusEqOp<scalar>());
    if (!Pstream::master()) return;

    const scalar* g = forces.cdata();
    forAll(pairs, i)
    {
        for (const contactInterface::pairState& pair : pairs[i])
        {
            const vector force(take(g)), plusForce(take(g));
            const word key(keyOf(solids_.interfaces()[i], pair));
            if (mag(force) + mag(plusForce) > 0 || filtered_.found(key))
            {
                FixedList<lowPass::state, 2>& s = filtered_(key);
                filter_->advance(s[0], force, runTime_.deltaTValue());
                filter_->advance(s[1], plusForce, runTime_.deltaTValue());
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
    const dictionary record(solids_.functionRecord(name()));
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
        readRecord();
        solids_.keepRecord(name, [this](Ostream& os) { writeRecord(os); });
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
            "cut-off of the filtered force"
        },
        {"filterPoles", "-", "2", "1 or 2"}
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
        scalarList sums(nSums*pairs.size(), scalar(0));
        scalarList peaks(nPeaks*pairs.size(), scalar(0));
        scalar* p = sums.data();
        scalar* peak = peaks.data();
        for (const contactInterface::pairState& pair : pairs)
        {
            const contactInterface::statistics none;
            const auto& s = pair.stage ? *pair.stage : none;
            put(p, s.force);
            put(p, pair.sums->impulse);
            put(p, s.plusForce);
            put(p, pair.sums->plusImpulse);
            put(p, s.area);
            put(p, s.nOpen);
            put(p, s.nStick);
            put(p, s.nSlip);
            put(p, s.gapArea);
            put(p, s.gapForce);
            put(p, pair.sums->friction);

            // Whatever its sign, on each processor
            put(p, mag(pair.sums->impulse) + mag(pair.sums->plusImpulse));
            put(peak, s.peakPressure);
            put(peak, s.penetration);
            put(peak, s.relativePenetration);
        }
        Pstream::listCombineGather(sums, plusEqOp<scalar>());
        Pstream::listCombineGather(peaks, maxEqOp<scalar>());
        if (!Pstream::master()) continue;

        OFstream& os = files_[i];
        forAll(pairs, j)
        {
            const scalar* s = sums.cdata() + nSums*j;
            const scalar* most = peaks.cdata() + nPeaks*j;
            const word key(keyOf(contact, pairs[j]));
            const auto known = filtered_.cfind(key);
            if (contact.many())
            {
                // Those that touch, or have since the last row
                const bool touches = s[14] + s[15] > 0;
                scalar& last = impulses_[i](key);
                const bool touched = s[19] != last;
                last = s[19];
                if (!touches && !touched && !known.good()) continue;
            }

            os  << runTime_.value();
            if (contact.many())
            {
                os  << ' ' << pairs[j].names.first().c_str()
                    << ' ' << pairs[j].names.second().c_str();
            }
            for (label c = 0; c < 13; ++c) os << ' ' << s[c];
            for (label c = 0; c < nPeaks; ++c) os << ' ' << most[c];
            for (label c = 13; c < 16; ++c) os << ' ' << label(s[c]);
            for (label c = 16; c < 19; ++c) os << ' ' << s[c];
            if (filter_.valid())
            {
                for (label side = 0; side < 2; ++side)
                {
                    const vector y
                    (
                        known.good() ? (*known)[side].value : vector::zero
                    );
                    os  << ' ' << y.x() << ' ' << y.y() << ' ' << y.z();
                }
            }
            os  << endl;
        }
    }

    return true;
}


// ************************************************************************* //
