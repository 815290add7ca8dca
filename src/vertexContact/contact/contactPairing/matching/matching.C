/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "matching.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "globalIndex.H"
#include "pointTree.H"
#include "HashSet.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeContactPairing(matching)


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::contactPairings::matching::facing
(
    const contactSide& side,
    const vector& direction
)
{
    const dualPatch& patch = side.geometry();
    DynamicList<label> corners(patch.nCorners());
    for (label k = 0; k < patch.nCorners(); ++k)
    {
        const vector N(side.body->dual().cornerNormal(patch, k));
        if ((N & direction) > facesGap) corners.append(k);
    }
    return labelList(corners);
}


void Foam::contactPairings::matching::identify
(
    const contactSide& side,
    const labelList& corners,
    const vector& direction,
    vectorField& place,
    scalarField& size
)
{
    const dualPatch& patch = side.geometry();
    vectorField allPlaces(patch.nCorners());
    scalarField allSizes(patch.nCorners());

    const auto X = [&](const label k)
    {
        const vector x(side.body->dual().position(patch.cornerNode[k]));
        return vector(x - (x & direction)*direction);
    };

    patch.forFaces([&](const dualPatch::face& f)
    {
        const label start = f.start, end = f.start + f.size;
        vector centre(Zero);
        for (label k = start; k < end; ++k) centre += X(k)/(end - start);

        for (label k = start; k < end; ++k)
        {
            allPlaces[k] = (1 - inward)*X(k) + inward*centre;
            allSizes[k] =
                end - start > 1
              ? mag(X(k) - centre)
              : side.body->surface(side.patchi).depth[k];
        }
    });

    place = vectorField(allPlaces, corners);
    size = scalarField(allSizes, corners);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactPairings::matching::matching
(
    const dictionary& dict,
    const contactSide& minus,
    const contactSide& plus
)
:
    contactPairing(minus, plus)
{
    dictionaryCheck::onlyKeywords(dict, commonKeywords() + keywords());
    const vector direction(gapDirection(dict));

    // Corners of both sides in the plane across the gap
    vectorField placeMinus, placePlus;
    scalarField sizeMinus, sizePlus;
    labelList cornersMinus(facing(minus, direction));
    labelList cornersPlus(facing(plus, -direction));
    identify(minus, cornersMinus, direction, placeMinus, sizeMinus);
    identify(plus, cornersPlus, direction, placePlus, sizePlus);

    labelList globalPlus(cornersPlus);
    for (label& k : globalPlus)
    {
        k = plusCorners_.toGlobal(k);
    }
    const labelList allGlobal(gathered(globalPlus));
    const pointField allPlus(gathered(placePlus));
    const scalarField allSizes(gathered(sizePlus));

    DynamicList<label> corners, partners;
    if (allPlus.size() && placeMinus.size())
    {
        const autoPtr<pointTree> tree(newPointTree(allPlus, max(sizeMinus)));
        forAll(placeMinus, k)
        {
            // In 1D faces have no size
            const scalar within = coincidence*sizeMinus[k];
            const pointIndexHit hit
            (
                tree->findNearest(placeMinus[k], sqr(within))
            );
            if
            (
                hit.hit()
             && (
                    minus.body->dual().nDim() == 1
                 || mag(allSizes[hit.index()] - sizeMinus[k]) <= within
                )
            )
            {
                corners.append(cornersMinus[k]);
                partners.append(allGlobal[hit.index()]);
            }
        }
    }

    // Pairs are one to one
    const labelList allPartners(gathered(labelList(partners)));
    labelHashSet taken(2*allPartners.size());
    for (const label partner : allPartners)
    {
        if (!taken.insert(partner))
        {
            FatalIOErrorInFunction(dict)
                << "Keyword 'pairing': several corners of "
                << minus.body->name() << ' ' << minus.patchName
                << " coincide with the same corner of " << plus.body->name()
                << ' ' << plus.patchName << " when projected along "
                << direction << '.' << nl
                << "'pairing matching' needs surfaces that a line along this "
                << "direction meets only once"
                << exit(FatalIOError);
        }
    }

    const label nPaired =
        returnReduce(corners.size(), sumOp<label>());
    const label nMinus =
        returnReduce(placeMinus.size(), sumOp<label>());

    Info<< "    matching: " << nPaired << " of " << nMinus << " and "
        << allPlus.size() << " corners coincide along " << direction
        << endl;

    if (nPaired == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'pairing': no corner of " << minus.body->name()
            << ' ' << minus.patchName << " coincides with a corner of "
            << plus.body->name() << ' ' << plus.patchName
            << " when projected along " << direction << '.' << nl
            << "The two surface meshes do not match: 'pairing matching' "
            << "needs the same mesh on both sides" << exit(FatalIOError);
    }

    const auto area = [](const contactSide& side)
    {
        return side.geometry().cornerArea;
    };
    const auto depth = [](const contactSide& side)
    {
        return side.body->surface(side.patchi).depth;
    };
    const scalarField areaMinus(area(minus)), depthMinus(depth(minus));
    const scalarField areaPlus(gathered(area(plus)));
    const scalarField depthPlus(gathered(depth(plus)));
    const scalar power = 1.0/max(label(1), minus.body->dual().nDim() - 1);

    DynamicList<contactOverlap> overlaps(corners.size());
    forAll(corners, o)
    {
        const label k = corners[o], partner = partners[o];
        contactOverlap overlap;
        overlap.minus =
            contactOverlaps::whole(minusCorners_.toGlobal(k), areaMinus[k]);
        overlap.plus = contactOverlaps::whole(partner, areaPlus[partner]);
        overlap.depth = min(depthMinus[k], depthPlus[partner]);
        overlap.width =
            minus.body->dual().nDim() == 1
          ? overlap.depth
          : 2*std::pow(0.5*(areaMinus[k] + areaPlus[partner]), power);
        overlaps.append(overlap);
    }
    setOverlaps(overlaps);
}


// ************************************************************************* //
