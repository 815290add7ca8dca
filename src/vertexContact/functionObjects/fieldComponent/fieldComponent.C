/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldComponent.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Names of the components of a field with that many
wordList componentNames(const label nComponents)
{
    switch (nComponents)
    {
        case 3: return wordList({"x", "y", "z"});
        case 6: return wordList({"xx", "xy", "xz", "yy", "yz", "zz"});
        case 9:
            return wordList
            ({
                "xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"
            });
    }
    return wordList();
}

string unitOf(const dimensionSet& dims)
{
    return
        dims == dimLength ? "m"
      : dims == dimVelocity ? "m/s"
      : dims == dimAcceleration ? "m/s2"
      : dims == dimPressure ? "Pa"
      : dims == dimDensity*dimVelocity ? "kg/m2/s"
      : dims == dimTemperature ? "K"
      : "-";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fieldComponent::fieldComponent
(
    const word& field,
    const label component,
    const word& componentName,
    const dimensionSet& dimensions
)
:
    field_(field),
    component_(component),
    componentName_(componentName),
    unit_(unitOf(dimensions))
{}


Foam::List<Foam::fieldComponent> Foam::fieldComponent::read
(
    const dictionary& dict,
    const word& keyword,
    const solidBody& body,
    const bool whole
)
{
    const wordList all(dict.get<wordList>(keyword));
    if (all.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' is (): it needs at least one "
            << "field. Those of region '" << body.name() << "': "
            << dictionaryCheck::listed(bodyFields(body).names()).c_str()
            << exit(FatalIOError);
    }
    DynamicList<fieldComponent> list;
    DynamicList<word> columns;
    for (const word& given : all)
    {
        const auto dot = given.find('.');
        const word name(given.substr(0, dot), false);
        const nodalField values(body.field(name, labelList()));
        if (!values.nComponents)
        {
            FatalIOErrorInFunction(dict)
                << "Keyword '" << keyword << "': region '" << body.name()
                << "' has no field '" << name << "'. Its fields: "
                << dictionaryCheck::listed(bodyFields(body).names()).c_str()
                << exit(FatalIOError);
        }

        wordList names(componentNames(values.nComponents));
        const auto add = [&](const label c, const word& component)
        {
            list.append(fieldComponent(name, c, component, values.dimensions));
            columns.append(word(list.last().name(), false));
        };
        if (dot != std::string::npos)
        {
            const word component(given.substr(dot + 1), false);
            names.append("mag");
            const label c = names.find(component);
            if (c < 0 || values.nComponents == 1)
            {
                FatalIOErrorInFunction(dict)
                    << "Keyword '" << keyword << "': '" << given
                    << "' is not a component of " << name << ". Valid: "
                    << (
                           values.nComponents == 1
                         ? string(name)
                         : dictionaryCheck::listed(names)
                       ).c_str()
                    << exit(FatalIOError);
            }
            add(c < names.size() - 1 ? c : magnitude, component);
        }
        else if (values.nComponents == 1)
        {
            add(0, word::null);
        }
        else if (whole)
        {
            add(magnitude, "mag");
        }
        else
        {
            forAll(names, c) add(c, names[c]);
        }
    }
    dictionaryCheck::requireOnce(dict, keyword, columns);
    return List<fieldComponent>(list);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::fieldComponent::name() const
{
    return
        componentName_.empty() ? string(field_)
      : string(field_ + '.' + componentName_);
}


Foam::scalar Foam::fieldComponent::value
(
    const nodalField& field,
    const label k
) const
{
    const label n = field.nComponents;
    const scalar* v = field.values.cdata() + n*k;
    if (component_ != magnitude) return v[component_];

    scalar sum = 0;
    for (label c = 0; c < n; ++c)
    {
        // A symmetric tensor stores each off-diagonal component once
        const bool twice = n == 6 && (c == 1 || c == 2 || c == 4);
        sum += (twice ? 2 : 1)*sqr(v[c]);
    }
    return std::sqrt(sum);
}


// ************************************************************************* //
