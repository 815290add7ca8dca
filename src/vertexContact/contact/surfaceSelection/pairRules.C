/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pairRules.H"
#include "DynamicList.H"
#include <algorithm>
#include <map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pairRules::split(const labelUList& set)
{
    // How many of each class are in the set, each once
    boolList in;
    in.setSize(size(), false);
    labelList count(nClasses(), Zero);
    for (const label i : set)
    {
        if (!in[i]) ++count[class_[i]];
        in[i] = true;
    }

    // Those leave a class that has others, too, for one with the same rules
    labelList to(nClasses(), -1);
    forAll(count, c)
    {
        if (count[c] == 0 || count[c] == size_[c]) continue;
        to[c] = nClasses();
        size_[c] -= count[c];
        size_.push_back(count[c]);
        fixed_.push_back(fixed_[c]);
        for (auto& row : rule_) row.push_back(row[c]);
        rule_.push_back(std::vector<label>(rule_[c]));
    }
    for (const label i : set)
    {
        if (!in[i]) continue;
        in[i] = false;
        if (to[class_[i]] >= 0) class_[i] = to[class_[i]];
    }
}


Foam::labelList Foam::pairRules::classesOf(const labelUList& set) const
{
    boolList there;
    there.setSize(nClasses(), false);
    for (const label i : set) there[class_[i]] = true;
    DynamicList<label> classes;
    forAll(there, c)
    {
        if (there[c]) classes.append(c);
    }
    return labelList(classes);
}


template<class Function>
void Foam::pairRules::forClasses
(
    const labelUList& a,
    const labelUList& b,
    const Function& f
) const
{
    const labelList others(classesOf(b));
    for (const label p : classesOf(a))
    {
        for (const label q : others) f(p, q);
    }
}


Foam::labelListList Foam::pairRules::members() const
{
    labelListList all(nClasses());
    forAll(all, c) all[c].setSize(size_[c]);
    labelList n(nClasses(), Zero);
    forAll(class_, i) all[class_[i]][n[class_[i]]++] = i;
    return all;
}


template<class Function>
Foam::labelPair Foam::pairRules::firstOf
(
    const labelUList& a,
    const labelUList& b,
    const Function& f
)
{
    for (const label i : a)
    {
        for (const label j : b)
        {
            if (f(i, j)) return labelPair(i, j);
        }
    }
    return labelPair(-1, -1);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pairRules::pairRules
(
    const labelUList& rigid,
    const UList<bool>& fixed,
    const bool self
)
:
    class_(rigid.size(), Zero),
    rigid_(rigid),
    self_(self),
    size_(1, rigid.size()),
    fixed_(1, false),
    rule_(1, std::vector<label>(1, -1))
{
    DynamicList<label> still;
    forAll(fixed, i)
    {
        if (fixed[i]) still.append(i);
    }
    split(still);
    for (const label c : classesOf(still)) fixed_[c] = true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::int64_t Foam::pairRules::nPairs() const
{
    std::int64_t n = 0;
    for (label p = 0; p < nClasses(); ++p)
    {
        for (label q = 0; q <= p; ++q)
        {
            if (rule_[p][q] < 0) continue;
            n +=
                p == q
              ? std::int64_t(size_[p])*(size_[p] + 1)/2
              : std::int64_t(size_[p])*size_[q];
        }
    }

    // Less what the classes do not know
    std::map<label, DynamicList<label>> ofBody;
    const auto drop = [&](const label i, const label j)
    {
        n -= (rule_[class_[i]][class_[j]] >= 0);
    };
    forAll(rigid_, i)
    {
        if (rigid_[i] >= 0)
        {
            DynamicList<label>& some = ofBody[rigid_[i]];
            some.append(i);
            for (const label j : some) drop(i, j);
        }
        else if (!self_)
        {
            drop(i, i);
        }
    }
    for (const std::int64_t k : own_)
    {
        const labelPair pair(pairOf(k));
        n -= (anyRule(pair.first(), pair.second()) >= 0);
    }
    return n;
}


Foam::boolList Foam::pairRules::meets() const
{
    // All surfaces but a few meet the first that are looked at
    const labelListList all(members());
    boolList any;
    any.setSize(size(), false);
    forAll(all, p)
    {
        forAll(all, q)
        {
            if (rule_[p][q] < 0) continue;
            for (const label i : all[p])
            {
                if (any[i]) continue;
                for (const label j : all[q])
                {
                    any[i] = apart(i, j);
                    if (any[i]) break;
                }
            }
        }
    }
    return any;
}


void Foam::pairRules::allow(const labelUList& a, const labelUList& b)
{
    split(a);
    split(b);
    forClasses(a, b, [&](const label p, const label q)
    {
        if (!fixed_[p] || !fixed_[q]) set(p, q, 0);
    });
}


Foam::labelPair Foam::pairRules::give
(
    const labelUList& a,
    const labelUList& b,
    const label rule
)
{
    split(a);
    split(b);

    // Only if there are two such surfaces the pairs are looked at one by one
    const auto other = [&](const label r) { return r > 0 && r != rule; };
    const auto clashes = [&](const label i, const label j)
    {
        return other((*this)(i, j));
    };
    const labelPair none(-1, -1);
    labelListList all;
    bool two = false;
    forClasses(a, b, [&](const label p, const label q)
    {
        if (two || !other(rule_[p][q])) return;
        if (all.empty()) all = members();
        two = firstOf(all[p], all[q], clashes) != none;
    });
    if (two) return firstOf(a, b, clashes);

    forClasses(a, b, [&](const label p, const label q)
    {
        if (rule_[p][q] == 0) set(p, q, rule);
    });
    return none;
}


void Foam::pairRules::exclude(const labelUList& a, const labelUList& b)
{
    split(a);
    split(b);
    forClasses(a, b, [&](const label p, const label q) { set(p, q, -1); });
}


Foam::labelPair Foam::pairRules::common
(
    const pairRules& others,
    const labelUList& theirs
) const
{
    // Surfaces by their classes here and there
    std::map<std::pair<label, label>, DynamicList<label>> both;
    DynamicList<label> order;
    forAll(theirs, i)
    {
        if (theirs[i] < 0) continue;
        both[{class_[i], others.class_[theirs[i]]}].append(i);
        order.append(i);
    }
    std::sort(order.begin(), order.end(), [&](const label i, const label j)
    {
        return theirs[i] < theirs[j];
    });
    const auto joined = [&](const label i, const label j)
    {
        return (*this)(i, j) >= 0 && others(theirs[i], theirs[j]) >= 0;
    };
    const labelPair none(-1, -1);
    for (const auto& a : both)
    {
        for (const auto& b : both)
        {
            if
            (
                rule_[a.first.first][b.first.first] >= 0
             && others.rule_[a.first.second][b.first.second] >= 0
             && firstOf(a.second, b.second, joined) != none
            )
            {
                return firstOf(order, order, joined);
            }
        }
    }
    return none;
}


// ************************************************************************* //
