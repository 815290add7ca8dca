/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactPairing.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "rankExchange.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(contactPairing, 0);
    defineRunTimeSelectionTable(contactPairing, dictionary);
    defineModelKeywords(contactPairing);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Values of the keyword transfer
const Foam::wordList transfers({"conservative", "twoWay"});

Foam::label numberOfCorners(const Foam::contactSide& side)
{
    return side.geometry().nCorners();
}

Foam::labelList ranksOf(const Foam::globalIndex& corners)
{
    Foam::DynamicList<Foam::label> ranks;
    for (Foam::label rank = 0; rank < Foam::Pstream::nProcs(); ++rank)
    {
        if (corners.localSize(rank)) ranks.append(rank);
    }
    return Foam::labelList(ranks);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::contactPairing::holds(const labelList& ranks)
{
    return findIndex(ranks, Pstream::myProcNo()) >= 0;
}


bool Foam::contactPairing::joint() const
{
    const label me = Pstream::myProcNo();
    const auto others = [&](const labelList& ranks)
    {
        return ranks.size() > 1 || (ranks.size() == 1 && ranks[0] != me);
    };
    const bool minus = holds(minusRanks_), plus = holds(plusRanks_);
    return (minus && others(plusRanks_)) || (plus && others(minusRanks_));
}


void Foam::contactPairing::takeOverlaps(DynamicList<contactOverlap>& overlaps)
{
    const label firstMinus = minusCorners_.toGlobal(0);

    // Plus corners that this rank needs, each once: the slots
    labelList slotOf(plusCorners_.size());
    const labelList slots
    (
        contactOverlaps::usedCorners(overlaps, &contactOverlap::plus, slotOf)
    );
    for (contactOverlap& o : overlaps)
    {
        for (label j = 0; j < o.minus.size; ++j)
        {
            o.minus.corner[j] -= firstMinus;
        }
        for (label j = 0; j < o.plus.size; ++j)
        {
            o.plus.corner[j] = slotOf[o.plus.corner[j]];
        }
    }

    map_.clear();
    if (joint())
    {
        askFor(slots);
    }
    else
    {
        sent_ = slots;
        const label firstPlus = plusCorners_.offset(Pstream::myProcNo());
        for (label& k : sent_) k -= firstPlus;
    }
    overlaps_.transfer(overlaps);
}


void Foam::contactPairing::setOverlaps(DynamicList<contactOverlap>& overlaps)
{
    takeOverlaps(overlaps);
    setNearest(returnReduce(nearest(), minOp<scalar>()));
}


void Foam::contactPairing::askFor(const labelList& slots)
{
    const label nProcs = Pstream::nProcs();

    // From whom what; the numbers of each rank follow each other
    labelListList construct(nProcs), wanted(nProcs);
    for (label proc = 0, i = 0; proc < nProcs; ++proc)
    {
        const label end =
            plusCorners_.offset(proc) + plusCorners_.localSize(proc);
        const label start = i;
        while (i < slots.size() && slots[i] < end) ++i;
        construct[proc] = identity(i - start, start);
        wanted[proc].setSize(i - start);
        forAll(wanted[proc], k)
        {
            wanted[proc][k] =
                slots[start + k] - plusCorners_.offset(proc);
        }
    }

    // The minus side asks the plus side
    labelList to, from;
    if (holds(minusRanks_)) to = plusRanks_;
    if (holds(plusRanks_)) from = minusRanks_;
    labelListList questions(to.size()), received;
    forAll(to, i) questions[i] = wanted[to[i]];
    rankExchange::lists(to, questions, from, received);
    labelListList asked(nProcs);
    forAll(from, i) asked[from[i]].transfer(received[i]);

    labelHashSet corners;
    for (const labelList& some : asked) corners.insert(some);
    sent_ = corners.sortedToc();
    for (labelList& some : asked)
    {
        for (label& k : some)
        {
            k = label
            (
                std::lower_bound(sent_.begin(), sent_.end(), k)
              - sent_.begin()
            );
        }
    }
    map_.reset
    (
        new mapDistribute
        (
            slots.size(), std::move(asked), std::move(construct)
        )
    );
}


Foam::vector Foam::contactPairing::gapDirection(const dictionary& dict) const
{
    // Area vector over the area: zero for closed surfaces
    const auto meanNormal = [](const contactSide& side)
    {
        const scalar area = gSum(side.geometry().cornerArea);
        return side.body->dual().areaVector(side.geometry())/max(area, VSMALL);
    };
    vector direction(Zero);
    if (dict.found("direction"))
    {
        direction =
            minus_.body->dual().projected(dict.get<vector>("direction"));
        if (mag(direction) < SMALL)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'direction' has no component in the directions of "
                << "the mesh" << exit(FatalIOError);
        }
        return direction/mag(direction);
    }
    const vector Sm(meanNormal(minus_)), Sp(meanNormal(plus_));
    if (min(mag(Sm), mag(Sp)) > noDirection)
    {
        direction = Sm/mag(Sm) - Sp/mag(Sp);
    }
    if (mag(direction) < opposes)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'direction': the mean normals of the sides "
            << minus_.body->name() << ' ' << minus_.patchName << " and "
            << plus_.body->name() << ' ' << plus_.patchName
            << " do not oppose each other." << nl
            << "Give the direction of the gap, from the first side to the "
            << "second, or choose 'pairing nearestFace'" << exit(FatalIOError);
    }
    return direction/mag(direction);
}


Foam::keywordList Foam::contactPairing::directionKeywords()
{
    return
    {
        {
            "direction", "-", "mean normals",
            "vector along the gap, from the first side to the second"
        }
    };
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactPairing::contactPairing
(
    const contactSide& minus,
    const contactSide& plus
)
:
    minus_(minus),
    plus_(plus),
    minusCorners_(numberOfCorners(minus)),
    plusCorners_(numberOfCorners(plus)),
    minusRanks_(ranksOf(minusCorners_)),
    plusRanks_(ranksOf(plusCorners_))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::contactPairing::update
(
    const scalar time,
    const contactSurface::snapshot& minus,
    const contactSurface::snapshot& plus
)
{
    find(minus, plus);
    setNearest(returnReduce(nearest(), minOp<scalar>()));
    follow(time, minus, plus);
}


Foam::keywordList Foam::contactPairing::commonKeywords()
{
    return
    {
        {"sides", "", "required", "two surfaces, each a region and a patch"},
        {
            "pairing", "", "matching",
            "how opposite parts of the two sides are found"
        },
        {
            "transfer", "", "conservative",
            keywordList::oneOf
            (
                transfers,
                "one force per overlap of two faces; or the paper's mapping, "
                "only with preset paper"
            )
        },
        {"law", "", "frictionless", "dictionary of the contact law"}
    };
}


bool Foam::contactPairing::readTwoWay(const dictionary& dict)
{
    const word transfer
    (
        dictionaryCheck::readOptional<word>
        (
            dict, commonKeywords(), "transfer"
        )
    );
    if (!transfers.found(transfer))
    {
        dictionaryCheck::unknownModel(dict, "transfer", transfer, transfers);
    }
    return transfer == transfers[1];
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::contactPairing> Foam::contactPairing::New
(
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
{
    const word pairingType
    (
        dictionaryCheck::readOptional<word>(dict, commonKeywords(), "pairing")
    );

    findListedModel(contactPairing, dict, "pairing", pairingType)
    if (minus == plus && pairingType != "nearestFace")
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'sides' names the same side twice: "
            << minus.body->name() << ' ' << minus.patchName
            << ". Only 'pairing nearestFace' pairs a surface with itself"
            << exit(FatalIOError);
    }

    return constructorPtr(dict, minus, plus);
}


// ************************************************************************* //
