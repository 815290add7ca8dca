/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidExtremes.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidFunctionObject(solidExtremes)


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::solidExtremes::reset()
{
    forAll(extremes_, i)
    {
        extremes_[i] = extreme{i % 2 ? -GREAT : GREAT};
    }
}


void Foam::functionObjects::solidExtremes::observe()
{
    if (seen_ == runTime_.timeIndex()) return;
    seen_ = runTime_.timeIndex();

    label next = 0;
    forAll(selections_, i)
    {
        const solidBody& body = selections_[i].body();
        const auto look = [&](const fieldComponent& its, const auto& values)
        {
            extreme* const both = extremes_.data() + next;
            next += 2;
            label least = -1, most = -1;
            for (const label a : selections_[i].nodes())
            {
                const scalar value = its.value(values, a);
                if (value < both[0].value)
                {
                    both[0].value = value;
                    least = a;
                }
                if (value > both[1].value)
                {
                    both[1].value = value;
                    most = a;
                }
            }
            for (label side = 0; side < 2; ++side)
            {
                const label a = side ? most : least;
                if (a < 0) continue;
                both[side].time = runTime_.value();
                both[side].position = body.position(a);
                both[side].reference = body.meshPoint(a);
            }
        };
        fieldComponent::visit(fields_[i], body, look);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::solidExtremes::solidExtremes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    solidFunctionObject(name, runTime, dict),
    selections_(nodeSelection::read(dict, solids_.bodies())),
    fields_(selections_.size()),
    everyStep_
    (
        dictionaryCheck::readOptional<bool>(dict, keywords(), "everyStep")
    )
{
    checkKeywords(dict, keywords());

    label n = 0;
    forAll(fields_, i)
    {
        fields_[i] = fieldComponent::read
        (
            dict, "fields", selections_[i].body(), true
        );
        n += fields_[i].size();
    }
    extremes_.setSize(2*n);
    reset();

    file_ = openFile("extremes.dat");
    if (Pstream::master())
    {
        *file_ << "# Time[s]";
        forAll(fields_, i)
        {
            for (const fieldComponent& component : fields_[i])
            {
                for (const char* side : {"min", "max"})
                {
                    const string label
                    (
                        selections_[i].name() + ':' + component.name() + ':'
                      + side
                    );
                    *file_
                        << ' ' << label.c_str() << '['
                        << component.unit().c_str() << ']';
                    writeHeads
                    (
                        *file_, label,
                        {
                            "time[s]", "x[m]", "y[m]", "z[m]", "X[m]", "Y[m]",
                            "Z[m]"
                        }
                    );
                }
            }
        }
        *file_ << endl;
    }

    writeFirstRow();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::functionObjects::solidExtremes::keywords()
{
    return
        keywordList
        {
            {
                "fields", "", "required",
                "fields that are written, or components as pointD.x"
            },
            {"everyStep", "", "no", "extremes of all steps since the last row"}
        }
      + nodeSelection::keywords();
}


bool Foam::functionObjects::solidExtremes::execute()
{
    if (everyStep_) observe();
    return true;
}


bool Foam::functionObjects::solidExtremes::writeRow()
{
    observe();

    // 8 numbers each
    constexpr label width = 8;
    List<scalarList> all(Pstream::nProcs());
    scalarList& mine = all[Pstream::myProcNo()];
    mine.setSize(width*extremes_.size());
    scalar* p = mine.data();
    for (const extreme& e : extremes_)
    {
        *p++ = e.value;
        *p++ = e.time;
        for (const scalar x : e.position) *p++ = x;
        for (const scalar x : e.reference) *p++ = x;
    }
    Pstream::gatherList(all);
    reset();
    if (!Pstream::master()) return true;

    *file_ << runTime_.value();
    forAll(extremes_, i)
    {
        const scalar* best = nullptr;
        for (const scalarList& ofRank : all)
        {
            const scalar* one = ofRank.cdata() + width*i;
            if (!best || (i % 2 ? *one > *best : *one < *best)) best = one;
        }
        for (label c = 0; c < width; ++c) *file_ << ' ' << best[c];
    }
    *file_ << endl;
    return true;
}


// ************************************************************************* //
