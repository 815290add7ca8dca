/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dictionaryCheck.H"
#include "dimensionedScalar.H"
#include "IStringStream.H"
#include "Time.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::label editDistance(const std::string& a, const std::string& b)
{
    const Foam::label n = b.size();
    Foam::List<Foam::label> row(n + 1);
    for (Foam::label j = 0; j <= n; ++j) row[j] = j;

    for (size_t i = 1; i <= a.size(); ++i)
    {
        Foam::label diagonal = row[0];
        row[0] = i;
        for (Foam::label j = 1; j <= n; ++j)
        {
            const Foam::label substituted =
                diagonal + (a[i-1] == b[j-1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j-1] + 1, substituted});
        }
    }

    return row[n];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::word Foam::dictionaryCheck::nearest
(
    const word& given,
    const UList<word>& valid
)
{
    word best;
    label bestDistance = labelMax;
    for (const word& w : valid)
    {
        const label d = editDistance(given, w);
        if (d < bestDistance)
        {
            bestDistance = d;
            best = w;
        }
    }
    // If more than half of the letters differ a proposal would be a guess
    return bestDistance <= label(given.size())/2 ? best : word();
}


Foam::word Foam::dictionaryCheck::within
(
    const word& given,
    const UList<word>& valid,
    const label letters
)
{
    const word best(nearest(given, valid));
    return
        best.size() && editDistance(given, best) <= letters ? best : word();
}


Foam::string Foam::dictionaryCheck::proposal
(
    const word& given,
    const UList<word>& valid
)
{
    const word best(nearest(given, valid));
    return best.empty() ? string() : string(" Did you mean '" + best + "'?");
}


Foam::string Foam::dictionaryCheck::listed(const UList<word>& words)
{
    string text("(");
    forAll(words, i)
    {
        text += (i ? " " : "") + words[i];
    }
    return text + ")";
}


void Foam::dictionaryCheck::onlyKeywords
(
    const dictionary& dict,
    const UList<word>& valid
)
{
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();
        if (key == "FoamFile" || valid.found(key)) continue;

        FatalIOErrorInFunction(dict)
            << "Unknown keyword '" << key << "'."
            << proposal(key, valid).c_str() << nl
            << "Valid keywords: " << listed(valid).c_str()
            << exit(FatalIOError);
    }
}


void Foam::dictionaryCheck::onlyKeywords
(
    const dictionary& dict,
    const keywordList& valid
)
{
    onlyKeywords(dict, valid.names());
}


Foam::scalar Foam::dictionaryCheck::readNumber
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims
)
{
    if (!dict.found(keyword))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' is missing; its unit is " << dims
            << exit(FatalIOError);
    }

    // OpenFOAM would take a word for the name of a dimensioned type
    const ITstream& tokens = dict.lookup(keyword);
    if (tokens.size() && !tokens.last().isNumber())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' is " << tokens.last()
            << ", which is not a finite number" << exit(FatalIOError);
    }

    // Reads [dimensions] where present and compares them
    const scalar number = compat::readDimensioned(dict, keyword, dims);

    if (!std::isfinite(number))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' is " << number
            << ", which is not a finite number" << exit(FatalIOError);
    }

    if (mag(number) > largestNumber)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' is " << number
            << ", which is too large; the units are m, kg, s and K"
            << exit(FatalIOError);
    }

    return number;
}


Foam::scalar Foam::dictionaryCheck::readNumberOrDefault
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims,
    const scalar deflt
)
{
    return dict.found(keyword) ? readNumber(dict, keyword, dims) : deflt;
}


Foam::dictionary Foam::dictionaryCheck::defaultOf
(
    const keywordList& described,
    const word& keyword
)
{
    for (const keywordList::keyword& k : described.all)
    {
        if (k.name == keyword)
        {
            return dictionary(IStringStream(k.name + ' ' + k.deflt + ';')());
        }
    }
    FatalErrorInFunction
        << "Keyword '" << keyword << "' is not in keywords()"
        << abort(FatalError);
    return dictionary();
}


Foam::scalar Foam::dictionaryCheck::readOptional
(
    const dictionary& dict,
    const keywordList& described,
    const word& keyword,
    const dimensionSet& dims
)
{
    const scalar deflt = defaultOf(described, keyword).get<scalar>(keyword);
    return readNumberOrDefault(dict, keyword, dims, deflt);
}


void Foam::dictionaryCheck::require
(
    const bool condition,
    const dictionary& dict,
    const word& keyword,
    const scalar value,
    const char* rule
)
{
    if (!condition)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' is " << value << ": it must be "
            << rule << exit(FatalIOError);
    }
}


void Foam::dictionaryCheck::requireOnce
(
    const dictionary& dict,
    const word& keyword,
    const UList<word>& given
)
{
    wordHashSet known;
    for (const word& w : given)
    {
        if (!known.insert(w))
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '" << keyword << "' has '" << w << "' twice"
                << exit(FatalIOError);
        }
    }
}


void Foam::dictionaryCheck::warnLeftOut
(
    const string& where,
    const word& keyword,
    const vector& given,
    const vector& used
)
{
    if (mag(given - used) > SMALL*mag(given))
    {
        WarningInFunction
            << where.c_str() << ": keyword '" << keyword << "' is " << given
            << ", but the mesh solves only " << used << " of it" << endl;
    }
}


void Foam::dictionaryCheck::warnLeftOut
(
    const string& where,
    const word& keyword,
    const Time& runTime,
    const std::function<vector(scalar)>& given,
    const std::function<vector(const vector&)>& used
)
{
    vector first(given(runTime.value()));
    if (first == vector::zero) first = given(runTime.endTime().value());
    warnLeftOut(where, keyword, first, used(first));
}


const Foam::dictionary& Foam::dictionaryCheck::subDict
(
    const dictionary& dict,
    const word& keyword,
    const char* example
)
{
    if (!dict.isDict(keyword))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' is "
            << (dict.found(keyword) ? "not a dictionary" : "missing")
            << ". Example: " << keyword << " { " << example << " }"
            << exit(FatalIOError);
    }
    return dict.subDict(keyword);
}


void Foam::dictionaryCheck::withPlace
(
    const dictionary& dict,
    const string& what,
    const std::function<void()>& f
)
{
    const bool throws = FatalError.throwExceptions();
    string why;
    try
    {
        f();
    }
    catch (const Foam::IOerror&)
    {
        FatalError.throwExceptions(throws);
        throw;
    }
    catch (const Foam::error& e)
    {
        why = e.message();
    }
    FatalError.throwExceptions(throws);
    if (why.size())
    {
        FatalIOErrorInFunction(dict)
            << what.c_str() << ". OpenFOAM: " << why.c_str()
            << exit(FatalIOError);
    }
}


void Foam::dictionaryCheck::unknownModel
(
    const dictionary& dict,
    const word& keyword,
    const word& given,
    const UList<word>& valid
)
{
    wordList sorted(valid);
    Foam::sort(sorted);

    FatalIOErrorInFunction(dict)
        << "Keyword '" << keyword << "': unknown value '" << given << "'."
        << proposal(given, sorted).c_str() << nl
        << "Valid values: " << listed(sorted).c_str() << exit(FatalIOError);
}


// ************************************************************************* //
