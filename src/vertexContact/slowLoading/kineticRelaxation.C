/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kineticRelaxation.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- A prescribed motion goes on while the kinetic energy of the held nodes is
//  above this share of the largest one of the free nodes
constexpr Foam::scalar heldMoves = 1e-6;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::kineticRelaxation::checked
(
    const dictionary& controlDict
)
{
    if (!controlDict.isDict("relaxation"))
    {
        FatalIOErrorInFunction(controlDict)
            << "Keyword 'relaxation' is not a dictionary. Its keywords: "
            << dictionaryCheck::listed(keywords().names()).c_str()
            << exit(FatalIOError);
    }
    const dictionary& dict = controlDict.subDict("relaxation");
    dictionaryCheck::onlyKeywords(dict, keywords());
    const word type(dict.get<word>("type"));
    if (type != "kinetic")
    {
        dictionaryCheck::unknownModel
        (
            dict, "type", type, wordList({"kinetic"})
        );
    }
    return dict;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::kineticRelaxation::kineticRelaxation(const dictionary& controlDict)
{
    const dictionary& dict = checked(controlDict);
    tolerance_ =
        dictionaryCheck::readOptional(dict, keywords(), "tolerance", dimless);
    dictionaryCheck::require
    (
        tolerance_ > 0, dict, "tolerance", tolerance_, "positive"
    );
    start_ = dictionaryCheck::readOptional(dict, keywords(), "start", dimTime);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::kineticRelaxation::keywords()
{
    return
    {
        {
            "type", "", "required",
            "kinetic: stops all free nodes at each peak of kinetic energy"
        },
        {
            "tolerance", "-", "0.001",
            "the run ends when out-of-balance forces / loads are below this"
        },
        {"start", "s", "0", "time from which nodes are stopped"}
    };
}


bool Foam::kineticRelaxation::atPeak(const scalar time, const scalar kinetic)
{
    ++since_;
    const bool falls = time > start_ && kinetic < last_ && since_ >= wait_;
    largest_ = max(largest_, kinetic);
    last_ = falls ? 0 : kinetic;
    return falls;
}


void Foam::kineticRelaxation::setBalance
(
    const leapfrogBody::forceBalance& b,
    const scalar held
)
{
    ++nPeaks_;
    since_ = 0;
    const scalar before = residual_;
    residual_ = b.loads > 0 ? b.unbalanced/b.loads : GREAT;
    const bool moves = held > heldMoves*largest_;
    done_ = residual_ < tolerance_ && !moves;
    wait_ =
        residual_ >= before && !moves ? 2*wait_ : max(label(1), wait_/2);
}


void Foam::kineticRelaxation::log(Ostream& os) const
{
    os  << "  peaks " << nPeaks_;
    if (nPeaks_ && residual_ < GREAT) os << "  residual " << residual_;
}


void Foam::kineticRelaxation::report(Ostream& os) const
{
    os  << "Relaxation: ";
    if (!nPeaks_)
    {
        os  << "the kinetic energy had no peak";
    }
    else if (residual_ < GREAT)
    {
        os  << "residual " << residual_ << " after " << nPeaks_ << " peaks, "
            << (done_ ? "below" : "the run ended before it was below")
            << " the tolerance " << tolerance_;
    }
    else
    {
        os  << nPeaks_ << " peaks, but no residual, because no loads act";
    }
    os  << nl << nl;
}


void Foam::kineticRelaxation::write(Ostream& os) const
{
    os  << "    lastKinetic " << last_ << ';' << nl
        << "    largestKinetic " << largest_ << ';' << nl
        << "    peaks " << nPeaks_ << ';' << nl
        << "    sinceStop " << since_ << ';' << nl
        << "    waitFor " << wait_ << ';' << nl
        << "    residual " << residual_ << ';' << nl;
}


void Foam::kineticRelaxation::read(const dictionary& record)
{
    last_ = record.getOrDefault<scalar>("lastKinetic", 0);
    largest_ = record.getOrDefault<scalar>("largestKinetic", 0);
    nPeaks_ = record.getOrDefault<label>("peaks", 0);
    residual_ = record.getOrDefault<scalar>("residual", GREAT);
    since_ = record.getOrDefault<label>("sinceStop", 0);
    wait_ = record.getOrDefault<label>("waitFor", 1);
}


// ************************************************************************* //
