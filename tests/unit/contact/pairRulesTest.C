/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Rules of pairs of many surfaces: the same as with a value for each pair, and
    a table that does not grow with the number of surfaces.

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"
#include "pairRules.H"
#include "DynamicList.H"
#include <random>

using namespace Foam;

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

namespace
{

//- Each n-th surface, from a first one on
labelList eachOf(const label size, const label n, const label first = 0)
{
    DynamicList<label> some;
    for (label i = first; i < size; i += n) some.append(i);
    return labelList(some);
}

//- The same rules, with a value for each pair
struct oneByOne
{
    const labelList rigid;
    const boolList fixed;
    const bool self;
    labelListList rule;

    label size() const { return rigid.size(); }

    oneByOne
    (
        const labelUList& rigid,
        const UList<bool>& fixed,
        const bool self
    )
    :
        rigid(rigid),
        fixed(fixed),
        self(self),
        rule(rigid.size(), labelList(rigid.size(), -1))
    {}

    bool may(const label i, const label j) const
    {
        return
            !(fixed[i] && fixed[j]) && (i != j || self)
         && (rigid[i] < 0 || rigid[i] != rigid[j]);
    }

    void set(const label i, const label j, const label value)
    {
        rule[i][j] = rule[j][i] = value;
    }

    void allow(const labelUList& a, const labelUList& b)
    {
        for (const label i : a)
        {
            for (const label j : b)
            {
                if (may(i, j)) set(i, j, 0);
            }
        }
    }

    labelPair give(const labelUList& a, const labelUList& b, const label value)
    {
        for (const label i : a)
        {
            for (const label j : b)
            {
                if (rule[i][j] > 0 && rule[i][j] != value)
                {
                    return labelPair(i, j);
                }
            }
        }
        for (const label i : a)
        {
            for (const label j : b)
            {
                if (rule[i][j] == 0) set(i, j, value);
            }
        }
        return labelPair(-1, -1);
    }

    void exclude(const labelUList& a, const labelUList& b)
    {
        for (const label i : a)
        {
            for (const label j : b) set(i, j, -1);
        }
    }

    label nPairs() const
    {
        label n = 0;
        for (label i = 0; i < size(); ++i)
        {
            for (label j = 0; j <= i; ++j) n += (rule[i][j] >= 0);
        }
        return n;
    }
};

//- Choices that are the same in each run
struct choices
{
    std::mt19937 engine;

    label below(const label n) { return label(engine() % n); }

    labelList some(const label size, const label outOf)
    {
        DynamicList<label> set;
        for (label i = 0; i < size; ++i)
        {
            if (below(outOf) == 0) set.append(i);
        }
        return labelList(set);
    }
};

//- Compare all that can be asked
bool same(const pairRules& rules, const oneByOne& expected)
{
    const boolList meets(rules.meets());
    bool good = rules.nPairs() == expected.nPairs();
    for (label i = 0; i < expected.size(); ++i)
    {
        bool any = false;
        for (label j = 0; j < expected.size(); ++j)
        {
            good = good && rules(i, j) == expected.rule[i][j];
            any = any || expected.rule[i][j] >= 0;
        }
        good = good && meets[i] == any;
    }
    return good;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE
(
    "The table of rules grows with classes, not with surfaces",
    "[contact][serial]"
)
{
    for (const label n : {40, 4000, 400000})
    {
        pairRules rules
        (
            labelList(n, -1), List<bool>(n, false), true
        );
        const labelList all(identity(n));
        rules.allow(all, all);
        CHECK(rules.nClasses() == 1);

        // Sides of squares: left with right, and no top with a bottom
        const labelList left(eachOf(n, 4)), right(eachOf(n, 4, 1));
        rules.give(left, right, 1);
        rules.exclude(eachOf(n, 4, 2), eachOf(n, 4, 3));
        CHECK(rules.nClasses() == 4);

        // The same sets once more tell nothing apart
        rules.exclude(right, right);
        CHECK(rules.nClasses() == 4);

        // What surfaces of one body have for themselves is not in the table
        rules.takeAway(0, n - 1);
        CHECK(rules.nClasses() == 4);

        CHECK(rules(0, n - 3) == 1);
        CHECK(rules(n - 3, 1) == -1);
        CHECK(rules(n - 2, n - 1) == -1);
        CHECK(rules(0, n - 1) == -1);
        CHECK(rules(0, 3) == 0);
        const std::int64_t each = n/4;
        CHECK
        (
            rules.nPairs()
         == std::int64_t(n)*(n + 1)/2 - each*each - each*(each + 1)/2 - 1
        );
    }
}


TEST_CASE("Rigid bodies are no classes of their own", "[contact][serial]")
{
    const label n = 1000;
    labelList rigid(n);
    forAll(rigid, i) rigid[i] = i/5;
    pairRules rules(rigid, List<bool>(n, false), true);
    rules.allow(identity(n), identity(n));
    CHECK(rules.nClasses() == 1);
    CHECK(rules(0, 4) == -1);
    CHECK(rules(4, 5) == 0);
    CHECK(rules.nPairs() == n*(n + 1)/2 - n/5*15);
}


TEST_CASE("Keys of pairs are sorted as pairs are", "[contact][serial]")
{
    // More pairs than 32 bits count
    const label n = 100000;
    const pairRules rules(labelList(n, -1), List<bool>(n, false), true);
    CHECK(rules.key(7, 99999) == rules.key(99999, 7));
    CHECK(rules.key(7, 99999) < rules.key(8, 9));
    CHECK(rules.pairOf(rules.key(99999, 99998)) == labelPair(99998, 99999));
}


TEST_CASE
(
    "Rules by classes are those of each pair",
    "[contact][serial]"
)
{
    choices random;
    label nClashes = 0, nCommon = 0;
    for (label trial = 0; trial < 200; ++trial)
    {
        const label n = 1 + random.below(24);
        labelList rigid(n, -1);
        List<bool> fixed(n, false);
        const label bodies = 1 + random.below(8);
        for (label i = 0; i < n; ++i)
        {
            const label body = random.below(bodies);
            if (body % 3 == 0) rigid[i] = body;
            fixed[i] = body % 4 == 0;
        }
        const bool self = random.below(2);

        pairRules rules(rigid, fixed, self);
        oneByOne expected(rigid, fixed, self);
        const auto both = [&](const auto& f)
        {
            const labelList a(random.some(n, 2)), b(random.some(n, 2));
            f(a, b);
        };
        both([&](const labelList& a, const labelList& b)
        {
            // A set may have a surface twice
            labelList twice(a);
            twice.append(a);
            rules.allow(twice, b);
            expected.allow(a, b);
        });
        for (label rule = 1; rule < 4; ++rule)
        {
            both([&](const labelList& a, const labelList& b)
            {
                const labelPair clash(expected.give(a, b, rule));
                CHECK(rules.give(a, b, rule) == clash);
                nClashes += (clash.first() >= 0);
            });
        }
        if (random.below(2))
        {
            both([&](const labelList& a, const labelList& b)
            {
                rules.exclude(a, b);
                expected.exclude(a, b);
            });
        }
        CHECK(same(rules, expected));

        // Another one, of some of the surfaces in another order
        labelList theirs(n, -1);
        DynamicList<label> here;
        for (label i = n - 1; i >= 0; --i)
        {
            if (random.below(2))
            {
                theirs[i] = here.size();
                here.append(i);
            }
        }
        const label m = here.size();
        pairRules others(labelList(m, -1), List<bool>(m, false), true);
        if (m)
        {
            const labelList a(random.some(m, 3)), b(random.some(m, 3));
            others.allow(a, b);
            others.takeAway(0, random.below(m));
        }
        rules.takeAway(0, n - 1);
        expected.set(0, n - 1, -1);
        labelPair first(-1, -1);
        for (label i = 0; i < m && first.first() < 0; ++i)
        {
            for (label j = 0; j < m && first.first() < 0; ++j)
            {
                if
                (
                    others(i, j) >= 0 && expected.rule[here[i]][here[j]] >= 0
                )
                {
                    first = labelPair(here[i], here[j]);
                }
            }
        }
        CHECK(rules.common(others, theirs) == first);
        nCommon += (first.first() >= 0);
        CHECK(rules.nPairs() == expected.nPairs());
    }
    CHECK(nClashes > 10);
    CHECK(nCommon > 10);
    CHECK(nCommon < 190);
}


// ************************************************************************* //
