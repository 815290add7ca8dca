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

//- An expression as it is written, except for blanks
std::string text(const expression& e)
{
    const std::string quote(e.name.isPattern() ? "\"" : "");
    if (e.leaf) return quote + e.name + quote;
    std::string all;
    for (const expression& part : e.list) all += text(part) + ' ';
    return '(' + all + ')';
}

//- A set in a list of pairs: a name alone is a region with all its surfaces
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
                << "Keyword '" << e.keyword() << "' is not a dictionary "
                << "with 'sides' and a 'law'" << exit(FatalIOError);
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
                << "Keyword 'pairs' is neither a dictionary nor a list whose "
                << "entries have two sets and a law, as in "
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
    for (const pairEntry& pair : pairs) contactLaw::dictIn(pair.dict);
    return pairs;
}

//- The keyword that names the surfaces
word chosenBy(const dictionary& dict)
{
    return word(dict.found("sides") ? "sides" : "surfaces");
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::generalInterface::indexOf(const contactSide& side) const
{
    const auto known = numbers_.find({side.body, side.patchi});
    return known == numbers_.end() ? -1 : known->second;
}


Foam::labelList Foam::generalInterface::indicesOf
(
    const UList<contactSide>& sides
) const
{
    DynamicList<label> indices(sides.size());
    for (const contactSide& side : sides)
    {
        const label i = indexOf(side);
        if (i >= 0) indices.append(i);
    }
    return labelList(indices);
}


void Foam::generalInterface::refuseTwoLaws
(
    const dictionary& dict,
    const word& keyword,
    const labelPair& pair,
    const word& first,
    const word& second
) const
{
    const contactSide& a = surfaces_[min(pair.first(), pair.second())];
    const contactSide& b = surfaces_[max(pair.first(), pair.second())];
    FatalIOErrorInFunction(dict)
        << "Keyword '" << keyword << "': the pair "
        << surfaceSelection::name(a).c_str() << " and "
        << surfaceSelection::name(b).c_str()
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
        part->add("law", contactLaw::dictIn(lawDict));
        if (contactLaw::New(contactLaw::dictIn(lawDict))->bonded())
        {
            FatalIOErrorInFunction(lawDict)
                << "Keyword 'law': tied is not valid here. Tied surfaces need "
                << "an interface of their own, with two sides"
                << exit(FatalIOError);
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
            << "Keyword 'surfaces': there must be exactly one of (surfaces "
            << "sides)" << exit(FatalIOError);
    }

    readSurfaces(dict, bodies);
    readPairLaws(dict, bodies);
    readExclude(dict, bodies);
    leavePairs(dict, others);

    const boolList meets(rule_.meets());
    forAll(meets, i)
    {
        if (!meets[i])
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '"
                << (dict.found("exclude") ? word("exclude") : chosenBy(dict))
                << "': no surface is left that "
                << surfaceSelection::name(surfaces_[i]).c_str()
                << " may touch. A surface that touches nothing needs the type "
                << "'tractionFree' in pointU." << nl
                << "Surfaces of type 'contact': "
                << surfaceSelection::listed
                   (
                       surfaceSelection::all(bodies)
                   ).c_str()
                << exit(FatalIOError);
        }
    }
}


void Foam::generalInterface::readSurfaces
(
    const dictionary& dict,
    PtrList<solidBody>& bodies
)
{
    DynamicList<contactSide> all;
    const auto take = [&](const UList<contactSide>& some)
    {
        for (const contactSide& s : some)
        {
            if (numbers_.emplace(std::make_pair(s.body, s.patchi), all.size())
                .second)
            {
                all.append(s);
            }
        }
    };
    FixedList<List<contactSide>, 2> sets;
    if (dict.found("surfaces"))
    {
        const expression e(surfaceSelection::read(dict, "surfaces"));
        sets[0] =
            e.leaf && e.name == "all"
          ? surfaceSelection::all(bodies)
          : surfaceSelection::select(dict, "surfaces", e, bodies);
        sets[1] = sets[0];
    }
    else
    {
        sets = readSets
        (
            dict, "sides", surfaceSelection::read(dict, "sides"), bodies
        );
    }
    for (const List<contactSide>& some : sets) take(some);
    surfaces_ = all;

    // Exclude pairs that no force can move relative to each other
    std::map<const solidBody*, label> rigidBodies;
    labelList rigid(surfaces_.size(), -1);
    boolList fixed;
    fixed.setSize(surfaces_.size(), false);
    forAll(surfaces_, i)
    {
        const solidBody& body = *surfaces_[i].body;
        fixed[i] = body.immovable();
        if (body.rigid())
        {
            rigid[i] =
                rigidBodies.emplace(&body, label(rigidBodies.size()))
               .first->second;
        }
    }
    rule_ = pairRules
    (
        rigid,
        fixed,
        dictionaryCheck::readOptional<bool>(dict, keywords(), "self")
    );
    rule_.allow(indicesOf(sets[0]), indicesOf(sets[1]));
}


void Foam::generalInterface::readPairLaws
(
    const dictionary& dict,
    PtrList<solidBody>& bodies
)
{
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
        pairSides_.append(text(pair.sides));
        const labelList a(indicesOf(sets[0])), b(indicesOf(sets[1]));
        const labelPair two(rule_.give(a, b, rules_.size() - 1));
        if (two.first() >= 0)
        {
            const label rule = rule_(two.first(), two.second());
            refuseTwoLaws(dict, "pairs", two, pairs[rule - 1].name, pair.name);
        }
        if (a.empty() || b.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'pairs': '" << pair.name << "' has no pair of the "
                << "surfaces in '" << chosenBy(dict)
                << "'. These surfaces are: "
                << surfaceSelection::listed(surfaces_).c_str()
                << exit(FatalIOError);
        }
    }
}


void Foam::generalInterface::readExclude
(
    const dictionary& dict,
    PtrList<solidBody>& bodies
)
{
    if (!dict.found("exclude")) return;
    const expression e(surfaceSelection::read(dict, "exclude"));

    // One pair, or a list of pairs
    if (e.leaf) readSets(dict, "exclude", e, bodies);
    const bool one =
        e.list.size() == 2 && e.list[0].surface() && e.list[1].surface();
    const List<expression> pairs(one ? List<expression>(1, e) : e.list);
    for (const expression& p : pairs)
    {
        const auto sets = readSets(dict, "exclude", p, bodies);
        rule_.exclude(indicesOf(sets[0]), indicesOf(sets[1]));
    }
}


void Foam::generalInterface::leavePairs
(
    const dictionary& dict,
    const UPtrList<contactInterface>& others
)
{
    for (const contactInterface& other : others)
    {
        if (other.many())
        {
            const auto& many = dynamic_cast<const generalInterface&>(other);
            labelList theirs(surfaces_.size());
            forAll(theirs, i) theirs[i] = many.indexOf(surfaces_[i]);
            const labelPair two(rule_.common(many.rule_, theirs));
            if (two.first() >= 0)
            {
                refuseTwoLaws(dict, chosenBy(dict), two, other.name(), name());
            }
            continue;
        }
        const List<contactSide> sides(other.sides());
        for (const contactSide& a : sides)
        for (const contactSide& b : sides)
        {
            const label i = indexOf(a), j = indexOf(b);
            if (i >= 0 && j >= 0 && other.joins(a, b)) rule_.takeAway(i, j);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::generalInterface::keywords()
{
    return
    {
        {
            "surfaces", "", "or sides",
            "surfaces that may touch each other: all, or a list"
        },
        {
            "sides", "", "or surfaces",
            "two sets of surfaces; a surface may touch those of the other set"
        },
        {"self", "", "yes", "no: a surface does not touch itself"},
        {
            "exclude", "", "none",
            "surfaces that do not touch: a pair of sets, or a list of such "
            "pairs"
        },
        {
            "pairs", "", "none",
            "other laws for some pairs of surfaces: dictionaries, or a list"
        },
        {"pairing", "", "nearestFace", "no other pairing is valid here"},
        {
            "updateDistance", "-",
            Foam::name(surfaceMotion::usualDistance),
            "distance, in face widths, that a node may move along its surface "
            "before faces are paired again; at most "
          + Foam::name(surfaceMotion::largestDistance)
        },
        {
            "law", "", "frictionless",
            "dictionary of the contact law, which must not be tied"
        }
    };
}


bool Foam::generalInterface::joins
(
    const contactSide& a,
    const contactSide& b
) const
{
    const label i = indexOf(a), j = indexOf(b);
    return i >= 0 && j >= 0 && rule_(i, j) >= 0;
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


bool Foam::generalInterface::holds() const
{
    for (const dictionary& rule : rules_)
    {
        if (contactLaw::ofInterface(rule)->sticks()) return true;
    }
    return false;
}


void Foam::generalInterface::readLaw(const dictionary& dict)
{
    contactInterface::readLaw(dict);
    PtrList<dictionary> rules(rules_.size());
    rules.set(0, partDict(dict, dict).ptr());

    // The pairs may not change, but their order may
    const PtrList<pairEntry> pairs(readPairs(dict));
    bool same = pairs.size() == pairSides_.size();
    for (const pairEntry& pair : pairs)
    {
        const label rule = pairSides_.find(text(pair.sides)) + 1;
        same = same && rule > 0 && !rules.set(rule);
        if (same) rules.set(rule, partDict(dict, pair.dict).ptr());
    }
    if (!same)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'pairs': while the run goes on, only the laws and the "
            << "order of the pairs can change. The pairs must be "
            << pairSides_
            << exit(FatalIOError);
    }
    rules_.transfer(rules);
    forAll(parts_, i) parts_[i].readLaw(ruleOf(keys_[i]));
    join();
}


void Foam::generalInterface::writeRecord(Ostream& os) const
{
    contactInterface::writeRecord(os);

    // All pairs that have touched, the same on all ranks, in one exchange
    const List<pairKey> keys(past_.sortedToc());
    List<account> all(keys.size());
    forAll(keys, i) all[i] = sumsOf(keys[i]);
    account::total(all);
    os  << "    pairs" << nl << "    {" << nl;
    forAll(keys, i)
    {
        if (all[i].touched())
        {
            os  << "    \"" << partName(keys[i]) << "\"" << nl << "    {"
                << nl;
            all[i].write(os);
            os  << "    }" << nl;
        }
    }
    os  << "    }" << nl;
}


void Foam::generalInterface::readRecord(const dictionary& record)
{
    contactInterface::readRecord(record);

    // The name of a pair consists of those of its surfaces
    std::multimap<std::string, label> named;
    forAll(surfaces_, i)
    {
        named.emplace(surfaceSelection::name(surfaces_[i]), i);
    }
    const dictionary pairs(record.subOrEmptyDict("pairs"));
    for (const entry& e : pairs)
    {
        const account sums(account::read(e.dict()));
        const auto set = [&](const label i, const label j)
        {
            const pairKey k = rule_.key(i, j);
            if (i > j || rule_(i, j) < 0 || partName(k) != e.keyword()) return;
            past_.set(k, sums);
            const label part = findSortedIndex(keys_, k);
            if (part >= 0) parts_[part].setSums(sums);
        };
        const std::string& text = e.keyword();
        const std::size_t start = name().size() + 1;
        for
        (
            std::size_t dash = text.find('-', start);
            dash != std::string::npos;
            dash = text.find('-', dash + 1)
        )
        {
            const auto a = named.equal_range(text.substr(start, dash - start));
            const auto b = named.equal_range(text.substr(dash + 1));
            for (auto i = a.first; i != a.second; ++i)
            for (auto j = b.first; j != b.second; ++j)
            {
                set(i->second, j->second);
            }
        }
    }
}


void Foam::generalInterface::report(Ostream& os) const
{
    os  << "Interface " << name() << ": " << surfaces_.size()
        << " surfaces, " << rule_.nPairs() << " pairs may touch and "
        << parts_.size() << " are near, pairing nearestFace, law "
        << law_->type();
    if (rules_.size() > 1)
    {
        os  << ", other laws for pairs: " << rules_.size() - 1;
    }
    os  << nl;
}


// ************************************************************************* //
