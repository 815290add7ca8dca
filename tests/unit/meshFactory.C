/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFactory.H"
#include "DynamicList.H"
#include "processorPolyPatch.H"
#include "Time.H"

#include <algorithm>
#include <cstdint>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A number from -1 to 1 that depends on the arguments only
scalar randomNumber
(
    const std::array<label, 3>& where,
    const label component,
    const unsigned seed
)
{
    std::uint64_t h = 0x9e3779b97f4a7c15ull*(seed + 1);

    for (const label i : {where[0], where[1], where[2], component})
    {
        h ^= std::uint64_t(i + 1000);
        h *= 0xbf58476d1ce4e5b9ull;
        h ^= h >> 29;
        h *= 0x94d049bb133111ebull;
        h ^= h >> 32;
    }

    return scalar(h >> 11)/scalar(1ull << 52) - 1;
}


//- A point of the block by its doubled indices: odd ones are cell centres
class lattice
{
    const meshFactory::block& block_;

    std::map<std::array<label, 3>, label> labels_;

public:

    DynamicList<point> points;
    std::vector<std::array<label, 3>> indices;

    explicit lattice(const meshFactory::block& b)
    :
        block_(b)
    {}

    label operator()(const std::array<label, 3>& at)
    {
        const auto found = labels_.find(at);
        if (found != labels_.end())
        {
            return found->second;
        }

        // The same displacement all the way across the thickness
        std::array<label, 3> seedAt(at);
        for (direction c = 0; c < 3; ++c)
        {
            seedAt[c] = (block_.isEmpty[c] ? 0 : at[c]);
        }

        point p;
        for (direction c = 0; c < 3; ++c)
        {
            const label n = block_.n[c];
            const scalar size = (block_.upper[c] - block_.lower[c])/n;
            const bool fixed =
                block_.isEmpty[c]
             || (block_.keepBox && (at[c] == 0 || at[c] == 2*n));

            // Exactly the upper corner at the end
            p[c] =
                at[c] == 2*n
              ? block_.upper[c]
              : block_.lower[c] + 0.5*at[c]*size;

            if (!fixed)
            {
                p[c] +=
                    block_.distortion*size
                   *randomNumber(seedAt, c, block_.seed);
            }
        }

        const label pointi = points.size();
        points.append(block_.map ? block_.map(p) : p);
        indices.push_back(at);
        labels_[at] = pointi;

        return pointi;
    }
};


faceList makeFaces
(
    const labelUList& v,
    const std::vector<std::vector<label>>& local
)
{
    faceList faces(local.size());

    for (std::size_t facei = 0; facei < local.size(); ++facei)
    {
        face& f = faces[facei];
        f.setSize(local[facei].size());

        forAll(f, fp)
        {
            f[fp] = v[local[facei][fp]];
        }
    }

    return faces;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::faceList Foam::meshFactory::facesOf(const labelUList& v)
{
    switch (v.size())
    {
        case 4:
            return makeFaces(v, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});

        case 5:
            return makeFaces
            (
                v,
                {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}
            );

        case 6:
            return makeFaces
            (
                v,
                {
                    {0, 2, 1},
                    {3, 4, 5},
                    {0, 1, 4, 3},
                    {1, 2, 5, 4},
                    {2, 0, 3, 5}
                }
            );

        default:
            return makeFaces
            (
                v,
                {
                    {0, 3, 2, 1},
                    {4, 5, 6, 7},
                    {0, 1, 5, 4},
                    {1, 2, 6, 5},
                    {2, 3, 7, 6},
                    {3, 0, 4, 7}
                }
            );
    }
}


Foam::meshFactory::result Foam::meshFactory::make
(
    const Time& runTime,
    const block& what
)
{
    cellsByFaces all;
    DynamicList<label> rank;
    lattice at(what);

    label axis = 2;
    for (label c = 0; c < 3; ++c)
    {
        axis = (what.isEmpty[c] ? c : axis);
    }

    // Bases and tops of a hexahedron along each axis
    static const label columns[3][8] =
    {
        {0, 3, 7, 4, 1, 2, 6, 5},
        {0, 4, 5, 1, 3, 7, 6, 2},
        {0, 1, 2, 3, 4, 5, 6, 7}
    };

    std::array<label, 3> ijk;

    for (ijk[2] = 0; ijk[2] < what.n[2]; ++ijk[2])
    for (ijk[1] = 0; ijk[1] < what.n[1]; ++ijk[1])
    for (ijk[0] = 0; ijk[0] < what.n[0]; ++ijk[0])
    {
        const label i = 2*ijk[0];
        const label j = 2*ijk[1];
        const label k = 2*ijk[2];

        const labelList hex
        ({
            at({{i, j, k}}),
            at({{i + 2, j, k}}),
            at({{i + 2, j + 2, k}}),
            at({{i, j + 2, k}}),
            at({{i, j, k + 2}}),
            at({{i + 2, j, k + 2}}),
            at({{i + 2, j + 2, k + 2}}),
            at({{i, j + 2, k + 2}})
        });

        const label here =
            what.rankOf ? what.rankOf(ijk[0], ijk[1], ijk[2]) : -1;

        auto add = [&](const labelList& vertices)
        {
            all.cells.push_back(facesOf(vertices));
            rank.append(here);
        };

        // One choice for each column along the axis
        std::array<label, 3> column(ijk);
        column[axis] = 0;
        const scalar dice = randomNumber(column, 3, what.seed);

        cellKind kind = what.cells;
        if (kind == mixed)
        {
            kind =
                dice > 0.2 ? prisms : (ijk[axis] % 2 == 0 ? hexes : pyramids);
        }

        if (kind == hexes)
        {
            add(hex);
        }
        else if (kind == prisms)
        {
            const label* v = columns[axis];
            const label d = (dice > 0.6 || (dice > -0.5 && dice < 0) ? 1 : 0);
            const label q0 = d, q1 = d + 1, q2 = d + 2, q3 = (d + 3) % 4;

            add
            ({
                hex[v[q0]], hex[v[q1]], hex[v[q2]],
                hex[v[4 + q0]], hex[v[4 + q1]], hex[v[4 + q2]]
            });
            add
            ({
                hex[v[q0]], hex[v[q2]], hex[v[q3]],
                hex[v[4 + q0]], hex[v[4 + q2]], hex[v[4 + q3]]
            });
        }
        else if (kind == pyramids)
        {
            const label centre = at({{i + 1, j + 1, k + 1}});

            for (const face& f : facesOf(hex))
            {
                bool boundary = false;
                for (label c = 0; c < 3; ++c)
                {
                    for (const label side : {label(0), 2*what.n[c]})
                    {
                        bool on = true;
                        for (const label pointi : f)
                        {
                            on = on && at.indices[pointi][c] == side;
                        }
                        boundary = boundary || on;
                    }
                }

                // Inwards
                if (boundary && what.cells == mixed)
                {
                    add({f[0], f[3], f[2], centre});
                    add({f[0], f[2], f[1], centre});
                }
                else
                {
                    add({f[3], f[2], f[1], f[0], centre});
                }
            }
        }
        else
        {
            // From the first to the last vertex along three edges
            static const label paths[6][4] =
            {
                {0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}
            };

            for (const label* p : paths)
            {
                add({hex[p[0]], hex[p[1]], hex[p[2]], hex[p[3]]});
            }
        }
    }

    all.points.setSize(at.points.size());
    forAll(all.points, pointi)
    {
        all.points[pointi] = at.points[pointi];
    }

    all.rank = rank;
    all.name = what.name;
    all.patchNames = {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};
    all.patchTypes.setSize(6);
    for (label patchi = 0; patchi < 6; ++patchi)
    {
        all.patchTypes[patchi] = (what.isEmpty[patchi/2] ? "empty" : "patch");
    }

    all.patchOf = [&](const face& f)
    {
        for (label patchi = 0; patchi < 6; ++patchi)
        {
            const label c = patchi/2;
            const label side = (patchi % 2 ? 2*what.n[c] : 0);

            bool on = true;
            for (const label pointi : f)
            {
                on = on && at.indices[pointi][c] == side;
            }

            if (on)
            {
                return patchi;
            }
        }

        FatalErrorInFunction
            << "Face " << f << " fits to no other" << abort(FatalError);

        return label(-1);
    };

    return make(runTime, all);
}


Foam::meshFactory::result Foam::meshFactory::make
(
    const Time& runTime,
    const cellsByFaces& what
)
{
    static label nMade = 0;

    const label myRank = (Pstream::parRun() ? Pstream::myProcNo() : 0);

    struct side
    {
        label cell;
        face f;
    };

    // Faces by their points, each with one or two sides, in order of their
    // first appearance: the same on all ranks
    std::map<std::vector<label>, label> faceOf;
    std::vector<std::vector<side>> faces;

    for (std::size_t celli = 0; celli < what.cells.size(); ++celli)
    {
        for (const face& f : what.cells[celli])
        {
            std::vector<label> key(f.begin(), f.end());
            std::sort(key.begin(), key.end());

            const auto inserted = faceOf.emplace(key, label(faces.size()));
            if (inserted.second)
            {
                faces.emplace_back();
            }

            faces[inserted.first->second].push_back({label(celli), f});
        }
    }

    auto rankOf = [&](const label celli)
    {
        return
            what.rank.empty() || what.rank[celli] == -1
          ? myRank
          : what.rank[celli];
    };

    // Cells of this rank
    labelList localCell(label(what.cells.size()), label(-1));
    label nCells = 0;
    forAll(localCell, celli)
    {
        if (rankOf(celli) == myRank)
        {
            localCell[celli] = nCells++;
        }
    }

    // Faces by destination: internal (by owner, neighbour), patches, ranks
    typedef std::pair<side, label> localFace;   // seen from cell, neighbour
    std::vector<localFace> internal;
    std::vector<std::vector<side>> patches(what.patchNames.size());
    std::map<label, std::vector<side>> processors;

    for (const std::vector<side>& sides : faces)
    {
        if (sides.size() == 1)
        {
            if (localCell[sides[0].cell] != -1)
            {
                patches[what.patchOf(sides[0].f)].push_back(sides[0]);
            }
            continue;
        }

        const label local0 = localCell[sides[0].cell];
        const label local1 = localCell[sides[1].cell];

        if (local0 != -1 && local1 != -1)
        {
            const bool inOrder = local0 < local1;

            internal.push_back
            ({
                sides[inOrder ? 0 : 1],
                inOrder ? local1 : local0
            });
        }
        else if (local0 != -1)
        {
            processors[rankOf(sides[1].cell)].push_back(sides[0]);
        }
        else if (local1 != -1)
        {
            // Starting at the same point as on the other side
            processors[rankOf(sides[0].cell)].push_back
            (
                {sides[1].cell, sides[0].f.reverseFace()}
            );
        }
    }

    std::stable_sort
    (
        internal.begin(),
        internal.end(),
        [&](const localFace& a, const localFace& b)
        {
            const label ownerA = localCell[a.first.cell];
            const label ownerB = localCell[b.first.cell];

            return ownerA != ownerB ? ownerA < ownerB : a.second < b.second;
        }
    );

    DynamicList<face> localFaces;
    DynamicList<label> owner;
    labelList neighbour(label(internal.size()));
    labelList patchSize(what.patchNames.size());

    for (const localFace& f : internal)
    {
        neighbour[localFaces.size()] = f.second;
        localFaces.append(f.first.f);
        owner.append(localCell[f.first.cell]);
    }

    auto append = [&](const std::vector<side>& sides)
    {
        for (const side& s : sides)
        {
            localFaces.append(s.f);
            owner.append(localCell[s.cell]);
        }
    };

    forAll(patchSize, patchi)
    {
        patchSize[patchi] = patches[patchi].size();
        append(patches[patchi]);
    }

    for (const auto& processor : processors)
    {
        append(processor.second);
    }

    // Points in the order of the whole mesh
    result made;
    labelList localPoint(what.points.size(), label(-1));
    DynamicList<label> globalPoint;

    for (const face& f : localFaces)
    {
        for (const label pointi : f)
        {
            localPoint[pointi] = 0;
        }
    }

    forAll(localPoint, pointi)
    {
        if (localPoint[pointi] != -1)
        {
            localPoint[pointi] = globalPoint.size();
            globalPoint.append(pointi);
        }
    }

    pointField points(globalPoint.size());
    forAll(points, pointi)
    {
        points[pointi] = what.points[globalPoint[pointi]];
    }

    faceList meshFaces(localFaces.size());
    forAll(meshFaces, facei)
    {
        face& f = meshFaces[facei];
        f = localFaces[facei];
        forAll(f, fp)
        {
            f[fp] = localPoint[f[fp]];
        }
    }

    made.globalPoint = globalPoint;
    labelList meshOwner(owner);

    made.mesh.reset
    (
        new polyMesh
        (
            IOobject
            (
                what.name + Foam::name(nMade++),
                runTime.constant(),
                runTime,
                IOobject::NO_READ,
                IOobject::NO_WRITE
            ),
            std::move(points),
            std::move(meshFaces),
            std::move(meshOwner),
            std::move(neighbour)
        )
    );

    polyMesh& mesh = *made.mesh;

    List<polyPatch*> boundary(patchSize.size() + label(processors.size()));
    label start = internal.size();
    label patchi = 0;

    forAll(patchSize, i)
    {
        boundary[patchi] =
            polyPatch::New
            (
                what.patchTypes[i],
                what.patchNames[i],
                patchSize[i],
                start,
                patchi,
                mesh.boundaryMesh()
            ).ptr();

        start += patchSize[i];
        ++patchi;
    }

    for (const auto& processor : processors)
    {
        boundary[patchi] =
            new processorPolyPatch
            (
                label(processor.second.size()),
                start,
                patchi,
                mesh.boundaryMesh(),
                myRank,
                processor.first
            );

        start += processor.second.size();
        ++patchi;
    }

    mesh.addPatches(boundary);

    return made;
}


// ************************************************************************* //
