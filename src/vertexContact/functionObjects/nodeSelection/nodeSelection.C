/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodeSelection.H"
#include "dictionaryCheck.H"
#include "emptyPolyPatch.H"
#include "pointSet.H"
#include "processorPolyPatch.H"
#include "token.H"
#include "wordRes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const wordList kinds({"cellZone", "faceZone", "patch", "pointSet"});

//- One name or expression, or a list of them
wordRes readNames(const dictionary& dict, const word& keyword)
{
    ITstream& is = dict.lookup(keyword);
    const token first(is);
    is.putBack(first);

    // From an error without a place OpenFOAM makes a warning, and the run goes
    // on without the function object
    List<wordRe> names;
    dictionaryCheck::withPlace
    (
        dict, "Keyword '" + keyword + "'", [&]()
        {
            if (first.isWord() || first.isString())
            {
                names = List<wordRe>(1, wordRe(is));
            }
            else
            {
                is >> names;
            }
        }
    );
    return wordRes(names);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nodeSelection::setNodes(const scalarField& weights)
{
    DynamicList<label> nodes;
    DynamicList<scalar> chosen;
    forAll(weights, a)
    {
        if (weights[a] > 0)
        {
            nodes.append(a);
            chosen.append(weights[a]);
        }
    }
    nodes_ = nodes;
    weights_ = scalarField(chosen);
}


Foam::scalarField Foam::nodeSelection::ofFaces(const labelUList& faces) const
{
    const polyMesh& mesh = body_->mesh();
    const medianDual& dual = body_->dual();
    const pointField& points = mesh.points();

    scalarField weights(dual.nNodes(), Zero);
    for (const label facei : faces)
    {
        // A face between two ranks counts on the lower one
        const label patchi =
            mesh.isInternalFace(facei)
          ? -1 : mesh.boundaryMesh().whichPatch(facei);
        if (patchi >= 0)
        {
            const polyPatch& pp = mesh.boundaryMesh()[patchi];
            const auto* coupled = dynamic_cast<const processorPolyPatch*>(&pp);
            if (isA<emptyPolyPatch>(pp) || (coupled && !coupled->owner()))
            {
                continue;
            }
        }

        // The share of a corner is the quadrilateral of the corner, the middles
        // of its two edges, and the centre of the face
        const face& f = mesh.faces()[facei];
        point centre(Zero);
        for (const label p : f) centre += points[p]/f.size();
        forAll(f, i)
        {
            const point& x = points[f[i]];
            const vector next(0.5*(points[f.nextLabel(i)] - x));
            const vector last(0.5*(points[f.prevLabel(i)] - x));
            const vector inside(centre - x);
            weights[dual.pointNode()[f[i]]] +=
                0.5*(mag(next ^ inside) + mag(inside ^ last))
               /dual.thickness();
        }
    }
    return weights;
}


Foam::scalarField Foam::nodeSelection::ofSet
(
    const word& kind,
    const word& name
) const
{
    const polyMesh& mesh = body_->mesh();
    const medianDual& dual = body_->dual();

    if (kind == "cellZone")
    {
        const label zonei = mesh.cellZones().findZoneID(name);
        if (zonei < 0) return scalarField();
        scalarField weights(dual.nNodes(), Zero);
        for (const label celli : mesh.cellZones()[zonei])
        {
            const cell& c = mesh.cells()[celli];
            const labelList corners(c.labels(mesh.faces()));
            const scalar share =
                c.mag(mesh.points(), mesh.faces())
               /(corners.size()*dual.thickness());
            for (const label p : corners) weights[dual.pointNode()[p]] += share;
        }
        return weights;
    }
    if (kind == "faceZone")
    {
        const label zonei = mesh.faceZones().findZoneID(name);
        return
            zonei < 0 ? scalarField() : ofFaces(mesh.faceZones()[zonei]);
    }
    if (kind == "patch")
    {
        const label patchi = mesh.boundaryMesh().findPatchID(name);
        if (patchi < 0) return scalarField();
        const polyPatch& pp = mesh.boundaryMesh()[patchi];
        return ofFaces(labelList(identity(pp.size(), pp.start())));
    }

    const pointSet set(mesh, name, IOobject::READ_IF_PRESENT);
    scalarField weights(dual.nNodes(), Zero);
    for (const label p : set.toc())
    {
        const label a = dual.pointNode()[p];
        if (dual.sharing().owned()[a]) weights[a] = dual.nodeVolume()[a];
    }
    return weights;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodeSelection::nodeSelection(const solidBody& body)
:
    body_(&body),
    name_(body.name())
{
    setNodes(body.dual().ownedVolume());
}


Foam::nodeSelection::nodeSelection
(
    const solidBody& body,
    const word& kind,
    const word& name
)
:
    body_(&body),
    name_(body.name() + '.' + name)
{
    setNodes(ofSet(kind, name));
}


Foam::List<Foam::nodeSelection> Foam::nodeSelection::read
(
    const dictionary& dict,
    const PtrList<solidBody>& bodies
)
{
    DynamicList<const solidBody*> chosen;
    wordList names;
    const bool every = !dict.found("region");
    const wordRes regions(every ? wordRes() : readNames(dict, "region"));
    for (const solidBody& body : bodies)
    {
        names.append(body.name());
        if (every || regions.match(body.name())) chosen.append(&body);
    }
    if (!every && regions.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'region' is (): it needs at least one name. Regions: "
            << dictionaryCheck::listed(names).c_str() << exit(FatalIOError);
    }
    for (const wordRe& region : regions)
    {
        bool some = false;
        for (const word& name : names) some = some || region.match(name);
        if (!some)
        {
            dictionaryCheck::unknownModel
            (
                dict, "region", word(region, false), names
            );
        }
    }

    word kind;
    for (const word& k : kinds)
    {
        if (!dict.found(k)) continue;
        if (kind.size())
        {
            FatalIOErrorInFunction(dict)
                << "Keywords '" << kind << "' and '" << k
                << "': give only one of them" << exit(FatalIOError);
        }
        kind = k;
    }

    DynamicList<nodeSelection> selections;
    if (kind.empty())
    {
        for (const solidBody* body : chosen)
        {
            selections.append(nodeSelection(*body));
        }
        return List<nodeSelection>(selections);
    }
    const word name(dict.get<word>(kind));
    for (const solidBody* body : chosen)
    {
        const nodeSelection selection(*body, kind, name);
        if (returnReduce(selection.nodes().size(), sumOp<label>()))
        {
            selections.append(selection);
        }
    }
    if (selections.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << kind << "': no node is in a " << kind << " '"
            << name << "' of these regions:";
        for (const solidBody* body : chosen)
        {
            const polyMesh& mesh = body->mesh();
            FatalIOError<< ' ' << body->name();
            if (kind == "pointSet") continue;
            FatalIOError
                << " has "
                << dictionaryCheck::listed
                   (
                       kind == "cellZone" ? mesh.cellZones().names()
                     : kind == "faceZone" ? mesh.faceZones().names()
                     : mesh.boundaryMesh().names()
                   ).c_str();
        }
        FatalIOError<< exit(FatalIOError);
    }
    return List<nodeSelection>(selections);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::nodeSelection::keywords()
{
    return
    {
        {"region", "", "all", "region, regular expression, or a list of them"},
        {"cellZone", "", "all nodes", "only the nodes of its cells"},
        {"faceZone", "", "all nodes", "only the nodes of its faces"},
        {"patch", "", "all nodes", "only the nodes of its faces"},
        {"pointSet", "", "all nodes", "only the nodes at its points"}
    };
}


// ************************************************************************* //
