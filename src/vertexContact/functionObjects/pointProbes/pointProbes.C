/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointProbes.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidFunctionObject(pointProbes)


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::functionObjects::pointProbes::values
(
    const word& field,
    const label node
) const
{
    const nodalField its(body_->field(field, labelList(1, node)));

    // Of the fields in fieldNames() only J may be none that is written
    return
        its.nComponents
      ? its.values
      : scalarField(1, det(body_->deformationGradient(node)));
}


Foam::wordList Foam::functionObjects::pointProbes::fieldNames()
{
    return wordList
    ({
        "pointU", "pointD", "lm", "F", "J", "sigma", "sigmaEq", "pressure"
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::pointProbes::pointProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    solidFunctionObject(name, runTime, dict),
    body_(nullptr),
    fields_(dict.get<wordList>("fields"))
{
    checkKeywords(dict, keywords());

    // The body
    wordList regions;
    for (const solidBody& body : solids_.bodies())
    {
        regions.append(body.name());
    }
    if (!dict.found("region") && regions.size() > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'region' is missing. Regions: "
            << dictionaryCheck::listed(regions).c_str() << exit(FatalIOError);
    }
    const word region(dict.getOrDefault<word>("region", regions[0]));
    const label bodyi = regions.find(region);
    if (bodyi < 0)
    {
        dictionaryCheck::unknownModel(dict, "region", region, regions);
    }
    body_ = &solids_.bodies()[bodyi];

    // The fields
    const wordList valid(fieldNames());
    if (fields_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'fields' is (): it needs at least one field. Valid: "
            << dictionaryCheck::listed(valid).c_str() << exit(FatalIOError);
    }
    for (const word& field : fields_)
    {
        if (!valid.found(field))
        {
            dictionaryCheck::unknownModel(dict, "fields", field, valid);
        }
    }
    // Each field has a file of its own
    dictionaryCheck::requireOnce(dict, "fields", fields_);

    // The nearest node; if several are equally near, the first by position. The
    // lowest rank that has it writes it
    const scalar asNear = 1 + 1e-6;
    const auto first = [](const point& a, const point& b)
    {
        return medianDual::before(a, b) ? a : b;
    };
    const pointField points(dict.get<pointField>("points"));
    if (points.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'points' is (): it needs at least one point, as "
            << "((0 0 0))"
            << exit(FatalIOError);
    }
    const medianDual& dual = body_->dual();
    nodes_.setSize(points.size(), -1);
    forAll(points, i)
    {
        const vector p(dual.projected(points[i]));
        const auto place = [&](const label a) { return dual.position(a); };
        scalar least = GREAT;
        for (label a = 0; a < dual.nNodes(); ++a)
        {
            least = min(least, mag(place(a) - p));
        }
        reduce(least, minOp<scalar>());
        label node = -1;
        for (label a = 0; a < dual.nNodes(); ++a)
        {
            if
            (
                mag(place(a) - p) <= asNear*least
             && (node < 0 || medianDual::before(place(a), place(node)))
            )
            {
                node = a;
            }
        }
        const point there = node < 0 ? point::uniform(GREAT) : place(node);
        const label rank = returnReduce
        (
            there == returnReduce(there, first)
          ? Pstream::myProcNo() : labelMax,
            minOp<label>()
        );
        if (Pstream::myProcNo() == rank) nodes_[i] = node;
        Info<< "pointProbes " << name << ": point " << points[i]
            << " is " << least << " m from the nearest node of region "
            << region << endl;
    }

    files_.setSize(fields_.size());
    forAll(fields_, f)
    {
        autoPtr<OFstream> file(openFile(fields_[f]));
        if (Pstream::master())
        {
            OFstream& os = *file;
            forAll(points, i)
            {
                os  << "# Probe " << i << ' ' << points[i] << nl;
            }
            os  << "# Probe";
            forAll(points, i) os << ' ' << i;
            os  << nl << "# Time" << endl;
            files_.set(f, file.ptr());
        }
    }

    writeFirstRow();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::functionObjects::pointProbes::keywords()
{
    return
    {
        {"region", "", "the only one", "region of the points"},
        {
            "points", "m", "required",
            "positions in the reference mesh; the nearest nodes are probed"
        },
        {
            "fields", "", "required",
            keywordList::oneOf(fieldNames(), "list of some of these")
        }
    };
}


bool Foam::functionObjects::pointProbes::writeRow()
{
    forAll(fields_, f)
    {
        List<scalarField> rows(nodes_.size());
        forAll(nodes_, i)
        {
            if (nodes_[i] >= 0) rows[i] = values(fields_[f], nodes_[i]);
        }
        if (Pstream::parRun())
        {
            List<List<scalarField>> all(Pstream::nProcs());
            all[Pstream::myProcNo()] = rows;
            Pstream::gatherList(all);
            for (const auto& ofRank : all)
            {
                forAll(ofRank, i)
                {
                    if (ofRank[i].size()) rows[i] = ofRank[i];
                }
            }
        }

        if (Pstream::master())
        {
            OFstream& os = files_[f];
            os  << runTime_.value();
            for (const scalarField& row : rows)
            {
                os  << ' ';
                if (row.size() > 1) os << '(';
                forAll(row, c) os << (c ? " " : "") << row[c];
                if (row.size() > 1) os << ')';
            }
            os  << endl;
        }
    }

    return true;
}


// ************************************************************************* //
