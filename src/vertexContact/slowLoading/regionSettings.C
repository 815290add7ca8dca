/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionSettings.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<const Foam::dictionary*> Foam::regionSettings::read
(
    const dictionary& controlDict,
    const word& keyword,
    const PtrList<solidBody>& bodies,
    const keywordList& valid
)
{
    List<const dictionary*> settings;
    if (!controlDict.found(keyword)) return settings;
    if (!controlDict.isDict(keyword))
    {
        FatalIOErrorInFunction(controlDict)
            << "Keyword '" << keyword << "' is not a dictionary. It must hold "
            << "a dictionary for each region, or for the regions that a "
            << "regular expression in quotes matches, with the keywords "
            << dictionaryCheck::listed(valid.names()).c_str()
            << exit(FatalIOError);
    }
    DynamicList<word> regions;
    for (const solidBody& body : bodies)
    {
        if (!body.rigid()) regions.append(body.name());
    }
    const dictionary& all = controlDict.subDict(keyword);
    for (const entry& e : all)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(all)
                << "Keyword '" << e.keyword() << "' is not a dictionary. "
                << "The dictionary of a region has the keywords "
                << dictionaryCheck::listed(valid.names()).c_str()
                << exit(FatalIOError);
        }
        dictionaryCheck::onlyKeywords(e.dict(), valid);
        bool some = false;
        for (const word& region : regions)
        {
            some = some || e.keyword().match(region);
        }
        if (!some)
        {
            FatalIOErrorInFunction(all)
                << "Keyword '" << e.keyword() << "' is not a region that "
                << "deforms, and matches none. Regions that deform: "
                << dictionaryCheck::listed(regions).c_str()
                << exit(FatalIOError);
        }
    }

    settings.setSize(bodies.size(), nullptr);
    forAll(bodies, i)
    {
        if (!bodies[i].rigid()) settings[i] = all.findDict(bodies[i].name());
    }
    return settings;
}


// ************************************************************************* //
