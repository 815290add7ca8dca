/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "keywordList.H"
#include "dictionaryCheck.H"
#include "DynamicList.H"
#include "Ostream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::keywordList::names() const
{
    DynamicList<word> words(all.size());
    for (const keyword& k : all)
    {
        if (k.within.empty()) words.append(k.name);
    }
    return wordList(words);
}


Foam::keywordList Foam::keywordList::within(const word& dict) const
{
    keywordList moved(*this);
    for (keyword& k : moved.all) k.within = dict;
    return moved;
}


Foam::string Foam::keywordList::oneOf
(
    const wordList& values,
    const string& meaning
)
{
    return dictionaryCheck::listed(values) + ' ' + meaning;
}


void Foam::keywordList::write(Ostream& os) const
{
    List<stringList> rows(all.size());
    forAll(all, i)
    {
        const keyword& k = all[i];
        rows[i] = stringList
        ({
            k.within.empty() ? string(k.name) : string(k.within + '/' + k.name),
            k.unit.empty() ? string() : string('[' + k.unit + ']'),
            k.deflt,
            k.meaning
        });
    }
    writeColumns(os, rows);
}


void Foam::keywordList::writeColumns
(
    Ostream& os,
    const List<stringList>& rows
)
{
    List<size_t> width;
    for (const stringList& row : rows)
    {
        width.setSize(row.size(), 0);
        forAll(row, i)
        {
            width[i] = max(width[i], row[i].size());
        }
    }
    for (const stringList& row : rows)
    {
        std::string line("  ");
        forAll(row, i)
        {
            line += "  " + row[i];
            if (i + 1 < row.size())
            {
                line.append(width[i] - row[i].size(), ' ');
            }
        }
        os  << line.c_str() << nl;
    }
}


// * * * * * * * * * * * * * * * Global Operators  * * * * * * * * * * * * * //

Foam::keywordList Foam::operator+(const keywordList& a, const keywordList& b)
{
    keywordList sum(a);
    sum.all.append(b.all);
    return sum;
}


// ************************************************************************* //
