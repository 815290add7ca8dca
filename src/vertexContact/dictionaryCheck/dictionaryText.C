/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dictionaryText.H"
#include "IFstream.H"
#include "etcFiles.H"
#include "OSspecific.H"
#include <cctype>
#include <regex>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A text without C++ comments; what is in quotes is kept
std::string withoutComments(const std::string& text)
{
    std::string rest;
    bool quoted = false;
    for (size_t i = 0; i < text.size(); ++i)
    {
        if (quoted)
        {
            rest += text[i];
            if (text[i] == '\\' && i + 1 < text.size()) rest += text[++i];
            else if (text[i] == '"' || text[i] == '\n') quoted = false;
        }
        else if (text.compare(i, 2, "//") == 0)
        {
            i = std::min(text.find('\n', i), text.size());
            rest += '\n';
        }
        else if (text.compare(i, 2, "/*") == 0)
        {
            i = std::min(text.find("*/", i + 2), text.size() - 2) + 1;
            rest += ' ';
        }
        else
        {
            quoted = text[i] == '"';
            rest += text[i];
        }
    }
    return rest;
}


//- The text has this name where 'before' accepts its position, and not as the
//  beginning of a longer name
template<class Before>
bool stands
(
    const std::string& text,
    const std::string& name,
    const Before& before
)
{
    for
    (
        size_t i = text.find(name);
        i != std::string::npos;
        i = text.find(name, i + 1)
    )
    {
        const size_t end = i + name.size();
        const unsigned char next = end < text.size() ? text[end] : ' ';
        if (!std::isalnum(next) && next != '_' && before(i)) return true;
    }
    return false;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::dictionaryText::read(const fileName& file)
{
    if (!isFile(file)) return std::string();
    IFstream is(file);
    seen_.insert(file);
    std::stringstream text;
    text<< is.stdStream().rdbuf();
    all_ += text.str() + '\n';
    return withoutComments(text.str());
}


void Foam::dictionaryText::include
(
    const std::string& text,
    const fileName& folder
)
{
    static const std::regex directive
    (
        "#(s?include|includeIfPresent|s?includeEtc)[ \t]+\"([^\"\n]*)\""
    );
    for
    (
        std::sregex_iterator i(text.begin(), text.end(), directive), end;
        i != end;
        ++i
    )
    {
        const std::string kind((*i)[1]);
        fileName file((*i)[2].str());
        const bool variable = file.find('$') != std::string::npos;
        file.expand(true);
        if (kind.find("Etc") != std::string::npos)
        {
            file = findEtcFile(file);
        }
        else if (!file.isAbsolute())
        {
            file = folder/file;
        }
        if (seen_.found(file)) continue;
        const std::string more(file.empty() ? std::string() : read(file));
        if (seen_.found(file))
        {
            include(more, file.path());
        }
        else
        {
            // A file that may be absent is not missing, unless its name has
            // variables, which only OpenFOAM can replace
            const bool optional = kind[0] == 's' || kind == "includeIfPresent";
            complete_ = complete_ && optional && !variable;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dictionaryText::dictionaryText(const fileName& file)
:
    own_(read(file))
{
    include(own_, file.path());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dictionaryText::names(const word& name) const
{
    return stands(own_, name, [&](const size_t i)
    {
        return
            i == 0
         || std::isspace(static_cast<unsigned char>(own_[i - 1]))
         || own_[i - 1] == ';'
         || own_[i - 1] == '}';
    });
}


bool Foam::dictionaryText::uses(const word& name) const
{
    // $name, ${name}, also with a scope
    const bool variable = stands(all_, name, [&](const size_t i)
    {
        const size_t sign =
            i == 0 ? std::string::npos
          : all_.find_last_not_of("{:.^/!", i - 1);
        return sign != std::string::npos && all_[sign] == '$';
    });
    if (variable) return true;

    const std::string quoted('"' + name + '"');
    for
    (
        size_t i = all_.find("#{");
        i != std::string::npos;
        i = all_.find("#{", i + 2)
    )
    {
        const size_t end = std::min(all_.find("#}", i), all_.size());
        if (all_.substr(i, end - i).find(quoted) != std::string::npos)
        {
            return true;
        }
    }
    return false;
}


// ************************************************************************* //
