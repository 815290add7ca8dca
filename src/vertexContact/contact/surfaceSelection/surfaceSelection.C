/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceSelection.H"
#include "solidBody.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Read one expression; i is then the token behind it
surfaceSelection::expression readOne
(
    const dictionary& dict,
    const word& keyword,
    const UList<token>& tokens,
    label& i
)
{
    surfaceSelection::expression e;
    if (i < tokens.size() && (tokens[i].isWord() || tokens[i].isString()))
    {
        e.leaf = true;
        dictionaryCheck::withPlace
        (
            dict, "Keyword '" + keyword + "'", [&]()
            {
                e.name =
                    tokens[i].isWord()
                  ? wordRe(tokens[i].wordToken())
                  : wordRe(tokens[i].stringToken(), wordRe::DETECT);
            }
        );
        ++i;
        return e;
    }
    DynamicList<surfaceSelection::expression> list;
    if
    (
        i < tokens.size() && tokens[i].isPunctuation()
     && tokens[i].pToken() == token::BEGIN_LIST
    )
    {
        ++i;
        while
        (
            i < tokens.size()
         && !(
                tokens[i].isPunctuation()
             && tokens[i].pToken() == token::END_LIST
            )
        )
        {
            list.append(readOne(dict, keyword, tokens, i));
        }
        if (i < tokens.size())
        {
            ++i;
            e.list = list;
            return e;
        }
    }
    FatalIOErrorInFunction(dict)
        << "Keyword '" << keyword << "' is not a list of surfaces, as in "
        << "((bar1 right) (\"disc.*\" surface)): each is a region and a patch"
        << exit(FatalIOError);
    return e;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::surfaceSelection::expression Foam::surfaceSelection::parse
(
    const dictionary& dict,
    const word& keyword,
    const UList<token>& tokens
)
{
    label i = 0;
    const expression e(readOne(dict, keyword, tokens, i));
    if (i < tokens.size())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' has more than one list"
            << exit(FatalIOError);
    }
    return e;
}


Foam::surfaceSelection::expression Foam::surfaceSelection::read
(
    const dictionary& dict,
    const word& keyword
)
{
    const tokenList& tokens = dict.lookup(keyword);
    return parse(dict, keyword, tokens);
}


Foam::List<Foam::contactSide> Foam::surfaceSelection::select
(
    const dictionary& dict,
    const word& keyword,
    const expression& which,
    PtrList<solidBody>& bodies
)
{
    const auto one = [&](const expression& e)
    {
        return single
        (
            dict, keyword, Pair<word>(e.list[0].name, e.list[1].name), bodies
        );
    };
    if (which.leaf || which.list.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' must be all, or a list of "
            << "surfaces, as ((bar1 right) (\"disc.*\" surface)): each is a "
            << "region and a patch" << exit(FatalIOError);
    }
    if (which.literal()) return List<contactSide>(1, one(which));

    // Those of each entry, in the order of all
    const List<contactSide> known(all(bodies));
    boolList found(known.size(), false);
    const auto take = [&](const expression& e)
    {
        if (!e.surface())
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '" << keyword << "': a surface is a region and a "
                << "patch, as in (bar1 right) or (\"disc.*\" surface)"
                << exit(FatalIOError);
        }
        bool any = false;
        forAll(known, i)
        {
            const bool matches =
                e.list[0].name.match(known[i].body->name())
             && e.list[1].name.match(known[i].patchName);
            found[i] = found[i] || matches;
            any = any || matches;
        }
        if (!any && e.literal())
        {
            one(e);
        }
        if (!any)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '" << keyword << "': (" << e.list[0].name << ' '
                << e.list[1].name << ") matches no surface whose type in "
                << "pointU is 'contact'." << nl << "These surfaces are: "
                << listed(known).c_str() << exit(FatalIOError);
        }
    };
    if (which.surface())
    {
        take(which);
    }
    else
    {
        for (const expression& e : which.list) take(e);
    }

    DynamicList<contactSide> sides;
    forAll(known, i)
    {
        if (found[i]) sides.append(known[i]);
    }
    return List<contactSide>(sides);
}


Foam::contactSide Foam::surfaceSelection::single
(
    const dictionary& dict,
    const word& keyword,
    const Pair<word>& which,
    PtrList<solidBody>& bodies
)
{
    const word& region = which.first();
    const word& patch = which.second();
    for (solidBody& body : bodies)
    {
        if (body.name() == region)
        {
            return contactSide
            {
                &body, body.contactPatch(dict, keyword, patch), patch
            };
        }
    }
    wordList regions(bodies.size());
    forAll(bodies, i) regions[i] = bodies[i].name();
    FatalIOErrorInFunction(dict)
        << "Keyword '" << keyword << "': there is no region '" << region
        << "'." << nl << "Regions: "
        << dictionaryCheck::listed(regions).c_str() << exit(FatalIOError);
    return contactSide();
}


Foam::List<Foam::contactSide> Foam::surfaceSelection::all
(
    PtrList<solidBody>& bodies
)
{
    DynamicList<contactSide> sides;
    for (solidBody& body : bodies)
    {
        for (const label patchi : body.contactPatches())
        {
            sides.append
            (
                contactSide
                {
                    &body, patchi, body.mesh().boundaryMesh()[patchi].name()
                }
            );
        }
    }
    return List<contactSide>(sides);
}


Foam::string Foam::surfaceSelection::listed
(
    const UList<contactSide>& sides
)
{
    string text;
    for (const contactSide& s : sides)
    {
        if (text.size()) text += ' ';
        text += '(' + s.body->name() + ' ' + s.patchName + ')';
    }
    return text;
}


Foam::string Foam::surfaceSelection::name(const contactSide& side)
{
    return side.body->name() + '.' + side.patchName;
}


// ************************************************************************* //
