/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "generalInterface.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "IStringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using surfaceSelection::expression;

//- Two sets of surfaces
FixedList<List<contactSide>, 2> readSets
(
    const dictionary& dict,
    const word& keyword,
    const expression& e,
    PtrList<solidBody>& bodies
)
{
    if (e.leaf || e.list.size() != 2 || e.surface())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' needs two sets of surfaces, as in "
            << "((bar1 right) (\"disc.*\" surface))" << exit(FatalIOError);
    }
    FixedList<List<contactSide>, 2> sets;
    forAll(sets, i)
    {
        sets[i] = surfaceSelection::select(dict, keyword, e.list[i], bodies);
    }
    return sets;
}

//- An entry of pairs
struct pairEntry
{
    word name;
    word keyword;       // of its sides
    expression sides;
    dictionary dict;
};

//- A set in a list of pairs: a name alone is a region, with all its surfaces
expression regionOrSurfaces(const expression& e)
{
    if (!e.leaf) return e;
    expression any;
    any.leaf = true;
    any.name = wordRe(".*", wordRe::REGEX);
    expression surface;
    surface.list = List<expression>({e, any});
    return surface;
}

//- Entries of pairs that are dictionaries of sides and a law
void readNamedPairs(const dictionary& dict, PtrList<pairEntry>& pairs)
{
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '" << e.keyword() << "' is not a dictionary, "
                << "of 'sides' and a 'law'" << exit(FatalIOError);
        }
        const dictionary& d = e.dict();
        dictionaryCheck::onlyKeywords(d, wordList({"sides", "law"}));
        pairs.append
        (
            new pairEntry
            {
                e.keyword(), "sides", surfaceSelection::read(d, "sides"), d
            }
        );
    }
}

//- Those of a list: two sets, and a dictionary with a law
void readListedPairs(const dictionary& dict, PtrList<pairEntry>& pairs)
{
    const auto require = [&](const bool good)
    {
        if (!good)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'pairs' is neither a dictionary nor a list of two "
                << "sets and a law each, as in "
                << "((\"steel.*\" \"rubber.*\") { law { ... } })"
                << exit(FatalIOError);
        }
    };

    ITstream is(dict.lookup("pairs"));
    const auto next = [&]()
    {
        require(is.nRemainingTokens() > 0);
        return token(is);
    };
    token t(next());
    require(t == token::BEGIN_LIST);
    for (t = next(); t != token::END_LIST; t = next())
    {
        DynamicList<token> tokens;
        for (; t != token::BEGIN_BLOCK; t = next()) tokens.append(t);
        is.putBack(t);
        const expression e(surfaceSelection::parse(dict, "pairs", tokens));
        require(e.list.size() == 2);
        expression sides;
        for (const expression& side : e.list)
        {
            sides.list.append(regionOrSurfaces(side));
        }
        const word name(Foam::name(pairs.size() + 1));
        const dictionary d("pairs." + name, dict, is);
        dictionaryCheck::onlyKeywords(d, wordList(1, word("law")));
        pairs.append(new pairEntry{name, "pairs", sides, d});
    }
    require(!is.nRemainingTokens());
}

PtrList<pairEntry> readPairs(const dictionary& dict)
{
    PtrList<pairEntry> pairs;
    if (dict.isDict("pairs"))
    {
        readNamedPairs(dict.subDict("pairs"), pairs);
    }
    else if (dict.found("pairs"))
    {
        readListedPairs(dict, pairs);
    }
    for (const pairEntry& pair : pairs) pair.dict.subDict("law");
    return pairs;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::generalInterface::indexOf(const contactSide& side) const
{
    forAll(surfaces_, i)
    {
        if (surfaces_[i] == side) return i;
    }
    return -1;
}


template<class Function>
void Foam::generalInterface::forPairs
(
    const List<contactSide>& a,
    const List<contactSide>& b,
    const Function& f
) const
{
    labelList others(b.size());
    forAll(b, j) others[j] = indexOf(b[j]);
    for (const contactSide& s : a)
    {
        const label i = indexOf(s);
        if (i < 0) continue;
        for (const label j : others)
        {
            if (j >= 0) f(key(i, j));
        }
    }
}


void Foam::generalInterface::refuseTwoLaws
(
    const dictionary& dict,
    const word& keyword,
    const label key,
    const word& first,
    const word& second
) const
{
    const label n = surfaces_.size();
    FatalIOErrorInFunction(dict)
        << "Keyword '" << keyword << "': the pair "
        << surfaceSelection::name(surfaces_[key/n]).c_str() << " and "
        << surfaceSelection::name(surfaces_[key % n]).c_str()
        << " has two laws, in '" << first << "' and in '" << second << '\''
        << exit(FatalIOError);
}


Foam::autoPtr<Foam::dictionary> Foam::generalInterface::partDict
(
    const dictionary& dict,
    const dictionary& lawDict
)
{
    autoPtr<dictionary> part(new dictionary(lawDict.name()));
    part->add("pairing", word("nearestFace"));
    if (dict.found("updateDistance"))
    {
        part->add("updateDistance", dict.get<scalar>("updateDistance"));
    }
    if (lawDict.found("law"))
    {
        part->add("law", lawDict.subDict("law"));
        if (contactLaw::New(lawDict.subDict("law"))->bonded())
        {
            FatalIOErrorInFunction(lawDict)
                << "Keyword 'law': what is tied needs an interface of its "
                << "own, with two sides" << exit(FatalIOError);
        }
    }
    return part;
}


void Foam::generalInterface::readRules
(
    const dictionary& dict,
    PtrList<solidBody>& bodies,
    const UPtrList<contactInterface>& others
)
{
    const keywordList described(keywords());
    dictionaryCheck::onlyKeywords(dict, described);
    const word pairing
    (
        dictionaryCheck::readOptional<word>(dict, described, "pairing")
    );
    if (pairing != "nearestFace")
    {
        dictionaryCheck::unknownModel
        (
            dict, "pairing", pairing, wordList(1, word("nearestFace"))
        );
    }
    if (dict.found("surfaces") == dict.found("sides"))
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'surfaces': there must be either that or 'sides'"
            << exit(FatalIOError);
    }

    // Who meets whom
    const bool self =
        dictionaryCheck::readOptional<bool>(dict, described, "self");
    const auto meet = [&](const label k)
    {
        const label n = surfaces_.size();
        const solidBody& a = *surfaces_[k/n].body;
        const solidBody& b = *surfaces_[k % n].body;
        // Nothing comes of contact between what no force moves apart
        if ((&a == &b && a.rigid()) || (a.immovable() && b.immovable())) return;
        if (self || k/n != k % n) rule_[k] = 0;
    };
    if (dict.found("surfaces"))
    {
        const expression e(surfaceSelection::read(dict, "surfaces"));
        surfaces_ =
            e.leaf && e.name == "all"
          ? surfaceSelection::all(bodies)
          : surfaceSelection::select(dict, "surfaces", e, bodies);
        rule_.setSize(surfaces_.size()*surfaces_.size(), label(-1));
        forPairs(surfaces_, surfaces_, meet);
    }
    else
    {
        const auto sets = readSets
        (
            dict, "sides", surfaceSelection::read(dict, "sides"), bodies
        );
        DynamicList<contactSide> both(sets[0]);
        for (const contactSide& s : sets[1])
        {
            bool there = false;
            for (const contactSide& t : sets[0]) there = there || s == t;
            if (!there) both.append(s);
        }
        surfaces_ = both;
        rule_.setSize(surfaces_.size()*surfaces_.size(), label(-1));
        forPairs(sets[0], sets[1], meet);
    }
    const label n = surfaces_.size();
    const word chosenBy(dict.found("sides") ? "sides" : "surfaces");

    rules_.setSize(1);
    rules_.set(0, partDict(dict, dict).ptr());
    const PtrList<pairEntry> pairs(readPairs(dict));
    for (const pairEntry& pair : pairs)
    {
        const auto sets = readSets
        (
            pair.dict, pair.keyword, pair.sides, bodies
        );
        rules_.append(partDict(dict, pair.dict).ptr());
        const label rule = rules_.size() - 1;
        bool any = false;
        forPairs(sets[0], sets[1], [&](const label k)
        {
            if (rule_[k] > 0 && rule_[k] != rule)
            {
                refuseTwoLaws
                (
                    dict, "pairs", k, pairs[rule_[k] - 1].name, pair.name
                );
            }
            if (rule_[k] == 0) rule_[k] = rule;
            any = true;
        });
        if (!any)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'pairs': '" << pair.name << "' has no pair of the "
                << "surfaces in '" << chosenBy << "'. These are: "
                << surfaceSelection::listed(surfaces_).c_str()
                << exit(FatalIOError);
        }
    }

    if (dict.found("exclude"))
    {
        const expression e(surfaceSelection::read(dict, "exclude"));

        // One pair, or a list of them
        if (e.leaf) readSets(dict, "exclude", e, bodies);
        const bool one =
            e.list.size() == 2 && e.list[0].surface() && e.list[1].surface();
        const List<expression> pairs
        (
            one ? List<expression>(1, e) : e.list
        );
        for (const expression& p : pairs)
        {
            const auto sets = readSets(dict, "exclude", p, bodies);
            forPairs(sets[0], sets[1], [&](const label k) { rule_[k] = -1; });
        }
    }

    // Pairs with an interface of their own
    boolList meets;
    meets.setSize(n, false);
    for (const contactInterface& other : others)
    {
        const List<contactSide> theirs(other.sides());
        forPairs(theirs, theirs, [&](const label k)
        {
            const label i = k/n, j = k % n;
            if (rule_[k] < 0 || !other.joins(surfaces_[i], surfaces_[j]))
            {
                return;
            }
            if (other.many())
            {
                refuseTwoLaws(dict, chosenBy, k, other.name(), name());
            }
            rule_[k] = -1;
            meets[i] = meets[j] = true;
        });
    }

    forAll(rule_, k)
    {
        if (rule_[k] >= 0) meets[k/n] = meets[k % n] = true;
    }
    forAll(meets, i)
    {
        if (!meets[i])
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '"
                << (dict.found("exclude") ? word("exclude") : chosenBy)
                << "': nothing is left that "
                << surfaceSelection::name(surfaces_[i]).c_str()
                << " may touch. Surfaces that touch nothing have the type "
                << "'tractionFree' in pointU." << nl << "These have 'contact': "
                << surfaceSelection::listed
                   (
                       surfaceSelection::all(bodies)
                   ).c_str()
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::generalInterface::keywords()
{
    return
    {
        {"surfaces", "", "or sides", "all, or a list of surfaces"},
        {"sides", "", "or surfaces", "two sets of surfaces"},
        {"self", "", "yes", "surfaces meet themselves"},
        {"exclude", "", "none", "a pair of sets, or a list of such pairs"},
        {"pairs", "", "none", "laws for some pairs: dictionaries, or a list"},
        {"pairing", "", "nearestFace", "no other"},
        {
            "updateDistance", "-",
            Foam::name(surfaceMotion::usualDistance),
            "face widths a node may move until they are paired again"
        },
        {"law", "", "frictionless", "dictionary of the contact law, not tied"}
    };
}


bool Foam::generalInterface::joins
(
    const contactSide& a,
    const contactSide& b
) const
{
    const label i = indexOf(a), j = indexOf(b);
    return i >= 0 && j >= 0 && rule_[key(i, j)] >= 0;
}


bool Foam::generalInterface::describedBy(const dictionary& dict)
{
    if (dict.found("surfaces")) return true;
    if (!dict.found("sides")) return false;
    const expression e(surfaceSelection::read(dict, "sides"));
    for (const expression& side : e.list)
    {
        if (!side.leaf && !side.literal() && side.list.size()) return true;
    }
    return false;
}


void Foam::generalInterface::readLaw(const dictionary& dict)
{
    contactInterface::readLaw(dict);
    rules_.set(0, partDict(dict, dict).ptr());
    const PtrList<pairEntry> pairs(readPairs(dict));
    for (label i = 0; i < pairs.size() && i + 1 < rules_.size(); ++i)
    {
        rules_.set(i + 1, partDict(dict, pairs[i].dict).ptr());
    }
    forAll(parts_, i) parts_[i].readLaw(rules_[rule_[keys_[i]]]);
    join();
}


void Foam::generalInterface::writeRecord(Ostream& os) const
{
    contactInterface::writeRecord(os);

    // Of all pairs that have touched: all ranks have the same
    Map<account> all(past_);
    forAll(parts_, i) all.set(keys_[i], parts_[i].sums());
    os  << "    pairs" << nl << "    {" << nl;
    for (const label k : all.sortedToc())
    {
        const account sums(all[k].total());
        if (sums.touched())
        {
            os  << "    \"" << partName(k) << "\"" << nl << "    {" << nl;
            sums.write(os);
            os  << "    }" << nl;
        }
    }
    os  << "    }" << nl;
}


void Foam::generalInterface::readRecord(const dictionary& record)
{
    contactInterface::readRecord(record);
    const dictionary& pairs = record.subOrEmptyDict("pairs");
    forAll(rule_, k)
    {
        if (rule_[k] < 0 || !pairs.found(partName(k), keyType::LITERAL))
        {
            continue;
        }
        const account sums
        (
            account::read(pairs.subDict(partName(k), keyType::LITERAL))
        );
        const label i = keys_.find(k);
        if (i >= 0)
        {
            parts_[i].setSums(sums);
        }
        else
        {
            past_.set(k, sums);
        }
    }
}


void Foam::generalInterface::report(Ostream& os) const
{
    label nPairs = 0;
    for (const label rule : rule_) nPairs += (rule >= 0);
    os  << "Interface " << name() << ": " << surfaces_.size()
        << " surfaces, of whose pairs " << nPairs << " may meet and "
        << parts_.size() << " are near, pairing nearestFace, law "
        << law_->type();
    if (rules_.size() > 1)
    {
        os  << ", " << rules_.size() - 1 << " other laws for pairs";
    }
    os  << nl;
}


// ************************************************************************* //
