/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidExtremes.H"
#include "dictionaryCheck.H"
#include "rankRows.H"

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
        const labelList& nodes = selections_[i].nodes();
        const auto look = [&](const fieldComponent& its, const auto& values)
        {
            extreme* const both = extremes_.data() + next;
            next += 2;
            label least = -1, most = -1;
            forAll(nodes, k)
            {
                const label a = nodes[k];
                const scalar value = its.value(values, k);
                // In the same step, the first node of those of equal value
                const auto first = [&](const label than)
                {
                    return
                        than >= 0
                     && medianDual::before
                        (
                            body.meshPoint(a), body.meshPoint(than)
                        );
                };
                scalar& low = both[0].value;
                if (value < low || (value == low && first(least)))
                {
                    low = value;
                    least = a;
                }
                scalar& high = both[1].value;
                if (value > high || (value == high && first(most)))
                {
                    high = value;
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
        fieldComponent::visit(fields_[i], body, nodes, look);
    }
}


Foam::scalarList Foam::functionObjects::solidExtremes::whole() const
{
    List<scalarList> all(Pstream::nProcs());
    scalarList& mine = all[Pstream::myProcNo()];
    List<extreme> here(extremes_);
    asNumbers(here, [&](const scalarList& numbers) { mine = numbers; });
    Pstream::gatherList(all);
    if (!Pstream::master()) return scalarList();

    scalarList best(mine);
    forAll(extremes_, i)
    {
        scalar* b = best.data() + extreme::width*i;
        for (const scalarList& ofRank : all)
        {
            const scalar* one = ofRank.cdata() + extreme::width*i;
            const auto place = [](const scalar* e)
            {
                return point(e[5], e[6], e[7]);
            };
            if
            (
                (i % 2 ? *one > *b : *one < *b)
             || (
                    *one == *b
                 && (
                        one[1] < b[1]
                     || (
                            one[1] == b[1]
                         && medianDual::before(place(one), place(b))
                        )
                    )
                )
            )
            {
                std::copy(one, one + extreme::width, b);
            }
        }
    }
    return best;
}


void Foam::functionObjects::solidExtremes::writeRecord(Ostream& os)
{
    observe();
    const scalarList all(whole());
    os  << "    extremes (";
    for (const scalar x : all) os << ' ' << x;
    os  << ");" << nl;
}


void Foam::functionObjects::solidExtremes::readRecord()
{
    const dictionary record(solids_.records().of(name()));
    if (!Pstream::master() || !record.found("extremes")) return;

    // The restarted run may ask for other fields or selections
    const scalarList all(record.get<scalarList>("extremes"));
    if (all.size() != extreme::width*extremes_.size()) return;
    asNumbers(extremes_, [&](scalarList& numbers) { numbers = all; });
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

    // At a restart its first row closes what the run before had begun
    if (everyStep_) readRecord();
    writeFirstRow();
    if (everyStep_)
    {
        solids_.records().keep(name, [this](Ostream& os) { writeRecord(os); });
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::functionObjects::solidExtremes::keywords()
{
    return
        keywordList
        {
            {
                "fields", "", "required",
                "names of written fields, or components such as pointD.x"
            },
            {
                "everyStep", "", "no",
                "yes: extremes over all steps since the previous row"
            }
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
    const scalarList all(whole());
    reset();
    if (!Pstream::master()) return true;

    *file_ << runTime_.value();
    for (const scalar x : all) *file_ << ' ' << x;
    *file_ << endl;
    return true;
}


// ************************************************************************* //
