/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkInterfaces.H"
#include "bodyInterface.H"
#include "solidBody.H"
#include "boundBox.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- State of a corner, to be sent to other ranks
struct cornerState
:
    public surfacePlace
{
    scalar one;
    vector linear;      //!< value of a linear field
};

//- Sums over the overlaps of a corner
struct cornerSum
{
    scalar share = 0;               //!< covered share of its area
    scalar judged = 0;              //!< the part of it that is checked
    vector force = vector::zero;    //!< force of a unit pressure
    scalar area = 0;                //!< area for that force

    void operator+=(const cornerSum& more)
    {
        share += more.share;
        judged += more.judged;
        force += more.force;
        area += more.area;
    }
};

template<class T>
T total(const T& mine)
{
    return returnReduce(mine, sumOp<T>());
}

scalar least(const scalar mine)
{
    return returnReduce(mine, minOp<scalar>());
}

scalar greatest(const scalar mine)
{
    return returnReduce(mine, maxOp<scalar>());
}

//- Largest error of a sum of weights from 1
scalar sumError(const FixedList<scalar, 4>& weights, const label size)
{
    scalar sum = 0;
    for (label j = 0; j < size; ++j) sum += weights[j];
    return mag(sum - 1);
}


//- Results of one side over all processors
struct sideSums
{
    const contactSide side;
    const cornerStates& corners;

    label nFaces = 0;
    label nCorners = 0;
    label nWithout = 0;
    label nPartly = 0;
    scalar area = 0;
    scalar covered = 0;
    scalar leastSum = GREAT;
    scalar greatestSum = 0;
    scalar judgedSum = 0;

    //- Overlaps: current area and its first moment about the middle
    scalar currentArea = 0;
    vector areaMoment = vector::zero;

    //- Largest errors of the sums of weights
    scalar valueError = 0;
    scalar fluxError = 0;

    //- Unit pressure: force and moment on the nodes; least and greatest
    //  traction at corners of covered faces
    vector force = vector::zero;
    vector moment = vector::zero;
    scalar leastTraction = GREAT;
    scalar greatestTraction = -GREAT;

    explicit sideSums(const contactSide& s)
    :
        side(s),
        corners(s.body->corners(s.patchi))
    {}

    point position(const label corner) const
    {
        return contactSurface::place(side, corner).x;
    }

    void addWeights(const contactStencil& s)
    {
        covered += s.area;
        valueError = max(valueError, sumError(s.value, s.size));
        fluxError = max(fluxError, sumError(s.flux, s.size));
    }

    //- Take the sums of the corners of this rank and complete all results
    void finish(const List<cornerSum>& got, const point& middle)
    {
        const dualPatch& patch = corners.geometry;
        nFaces = total(patch.nFaces());
        nCorners = total(patch.nCorners());
        area = total(sum(patch.cornerArea));

        for (label f = 0; f < patch.nFaces(); ++f)
        {
            const label start = patch.faceStart[f];
            const label n = patch.faceStart[f + 1] - start;
            const scalar* s = patch.weights.cdata() + patch.weightStart[f];

            bool whole = true;
            for (label k = start; k < start + n; ++k)
            {
                const scalar share = got[k].share;
                nWithout += (share < 1e-6);
                nPartly += (share >= 1e-6 && share < 1 - 1e-6);
                whole = whole && share >= 1 - 1e-6;
                if (share >= 1e-6) leastSum = min(leastSum, share);
                greatestSum = max(greatestSum, share);
                judgedSum = max(judgedSum, got[k].judged);
            }
            for (label j = 0; j < n; ++j)
            {
                const label k = start + j;
                for (label a = 0; a < n; ++a)
                {
                    const vector Fa
                    (
                        s[a*n + j]/patch.cornerArea[k]*got[k].force
                    );
                    force += Fa;
                    moment += (position(start + a) - middle) ^ Fa;
                }
                if (whole)
                {
                    const scalar t =
                        got[k].area/(patch.cornerArea[k]*corners.stretch[k]);
                    leastTraction = min(leastTraction, t);
                    greatestTraction = max(greatestTraction, t);
                }
            }
        }

        nWithout = total(nWithout);
        nPartly = total(nPartly);
        covered = total(covered);
        leastSum = least(leastSum);
        greatestSum = greatest(greatestSum);
        judgedSum = greatest(judgedSum);
        currentArea = total(currentArea);
        areaMoment = total(areaMoment);
        valueError = greatest(valueError);
        fluxError = greatest(fluxError);
        force = total(force);
        moment = total(moment);
        leastTraction = least(leastTraction);
        greatestTraction = greatest(greatestTraction);
    }
};


//- Box of the current corners of a side, over all processors
boundBox boxOf(const sideSums& side)
{
    boundBox box(boundBox::invertedBox);
    for (label k = 0; k < side.corners.size(); ++k)
    {
        box.add(side.position(k));
    }
    reduce(box.min(), minOp<vector>());
    reduce(box.max(), maxOp<vector>());
    return box;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

void Foam::checkInterface
(
    const bodyInterface& contact,
    const contactLimits& limits,
    contactReport& report,
    contactLines& lines
)
{
    typedef contactReport table;

    const contactPairing& pairing = contact.pairing();
    const List<contactOverlap>& overlaps = pairing.overlaps();
    const bool tied = contact.law().bonded();
    const List<contactSide> sides(contact.sides());
    sideSums M(sides[0]), P(sides[1]);

    const boundBox box(boxOf(M)), plusBox(boxOf(P));
    const point middle(box.midpoint());

    const label nOverlaps = total(overlaps.size());
    scalar width = 0;
    for (const contactOverlap& o : overlaps) width += o.width;
    width = total(width)/max(nOverlaps, label(1));
    const scalar perWidth = 1/max(width, VSMALL);
    const scalar extent = max(box.mag(), max(width, VSMALL));

    // A linear field that changes by one per mean width in each direction
    const auto linear = [&](const point& x)
    {
        return vector(vector::one + perWidth*(x - middle));
    };

    // Send the plus corners to the ranks of the minus side
    const labelList& near = pairing.plusCorners();
    List<cornerState> plus(near.size());
    forAll(plus, c)
    {
        static_cast<surfacePlace&>(plus[c]) =
            contactSurface::place(P.side, near[c]);
        plus[c].one = 1;
        plus[c].linear = linear(plus[c].x);
    }
    contactExchange exchange;
    const contactPairing* only = &pairing;
    exchange.set(UList<const contactPairing*>(&only, 1));
    exchange.toSlots(plus);

    List<cornerSum> toMinus(M.corners.size(), cornerSum());
    List<cornerSum> toPlus(pairing.nSlots(), cornerSum());

    scalar leastGap = GREAT, greatestGap = -GREAT, gapArea = 0;
    scalar opposedArea = 0, penetration = 0, magForce = 0;
    scalar constantError = 0, ownError = 0, acrossError = 0, offset = 0;
    label nNear = 0, nNotOpposed = 0;

    lines.setNames
    (
        {"area", "gap", "minusShare", "plusShare", "offset", "rank"}
    );

    // For edges that cross, the direction normal to both
    const auto across = [&](const contactOverlap& o)
    {
        if (o.normal.crossing <= 0) return vector(vector::zero);
        const auto ends = [](const contactStencil& s, const label edge)
        {
            return labelPair(s.corner[edge], s.corner[(edge + 1) % s.size]);
        };
        const labelPair m(ends(o.minus, o.normal.minusEdge));
        const labelPair p(ends(o.plus, o.normal.plusEdge));
        const vector d(M.position(m.second()) - M.position(m.first()));
        const vector e(plus[p.second()].x - plus[p.first()].x);
        return (d ^ e)/(mag(d)*mag(e));
    };

    for (const contactOverlap& o : overlaps)
    {
        // Both sides at the centroid
        const surfacePlace a(contactSurface::place(M.side, o.minus));
        const cornerState b(scalarRecord::mean(o.plus, plus));
        const overlapState at(o, a, b, across(o));
        const scalar area = at.area, gap = at.gap;
        const vector& n = at.n;

        // Gap and offset. Overlaps that do not face each other cannot touch
        const vector between(M.side.body->dual().projected(b.x - a.x));
        const scalar relativeOffset = mag(between - gap*n)/o.width;
        const vector& u = b.linear;
        if (at.opposed)
        {
            const vector jump(u - linear(a.x));
            acrossError = max(acrossError, mag(jump - (jump & n)*n));
            leastGap = min(leastGap, gap);
            greatestGap = max(greatestGap, gap);
            opposedArea += area;
            gapArea += gap*area;
            penetration = max(penetration, gap < 0 ? -gap/o.width : 0);
            if (mag(gap) <= o.width)
            {
                ++nNear;
                offset = max(offset, relativeOffset);
            }
        }
        else
        {
            ++nNotOpposed;
        }

        // Weights, and areas as if the gap were closed
        M.addWeights(o.minus);
        P.addWeights(o.plus);
        M.currentArea += at.minusArea;
        P.currentArea += at.plusArea;
        M.areaMoment += at.minusArea*(a.x - middle);
        P.areaMoment += at.plusArea*(b.x - gap*n - middle);

        // Transfer of a constant and of a linear field
        constantError = max(constantError, mag(b.one - 1));
        ownError = max(ownError, mag(u - linear(b.x)));

        // Forces of a unit pressure
        magForce += area;
        const bool judged =
            !contact.moves() || gap <= contactLimits::closeGap*o.width;
        cornerSum& minusSum = toMinus[o.minus.corner[0]];
        cornerSum& plusSum = toPlus[o.plus.corner[0]];
        minusSum.share += o.minus.share;
        plusSum.share += o.plus.share;
        if (judged)
        {
            minusSum.judged += o.minus.share;
            plusSum.judged += o.plus.share;
        }
        const auto spread = [&]
        (
            List<cornerSum>& to,
            const contactStencil& s,
            const scalar sign
        )
        {
            for (label j = 0; j < s.size; ++j)
            {
                cornerSum& c = to[s.corner[j]];
                const scalar part = s.flux[j]*area;
                c.force += sign*part*n;
                c.area += part;
            }
        };
        spread(toMinus, o.minus, -1);
        spread(toPlus, o.plus, 1);

        lines.append
        (
            a.x, b.x,
            {
                area, gap, o.minus.share, o.plus.share, relativeOffset,
                scalar(Pstream::myProcNo())
            }
        );
    }

    exchange.toCorners(toPlus, cornerSum());
    List<cornerSum> toAllPlus(P.corners.size(), cornerSum());
    forAll(near, c) toAllPlus[near[c]] = toPlus[c];
    M.finish(toMinus, middle);
    P.finish(toAllPlus, middle);

    leastGap = least(leastGap);
    greatestGap = greatest(greatestGap);
    penetration = greatest(penetration);
    constantError = greatest(constantError);
    ownError = greatest(ownError);
    acrossError = greatest(acrossError);
    offset = greatest(offset);
    nNear = total(nNear);
    nNotOpposed = total(nNotOpposed);
    magForce = total(magForce);
    gapArea = total(gapArea);
    opposedArea = total(opposedArea);

    // The table
    const auto row = [&](const char* name, const auto& m, const auto& p)
    {
        report.row(name, {table::text(m), table::text(p)});
    };
    const auto single = [&](const char* name, const auto& value)
    {
        report.row(name, {table::text(value)});
    };

    report.head(2);
    row("Faces", M.nFaces, P.nFaces);
    row("Corners", M.nCorners, P.nCorners);
    row("Corners without partner", M.nWithout, P.nWithout);
    row("Corners partly covered", M.nPartly, P.nPartly);
    row("Area [m2]", M.area, P.area);
    row("Coverage", M.covered/M.area, P.covered/P.area);
    if (nOverlaps)
    {
        row("Least sum of weights (of covered)", M.leastSum, P.leastSum);
        row("Greatest sum of weights", M.greatestSum, P.greatestSum);
        if (contact.moves())
        {
            row("  of overlaps about to touch", M.judgedSum, P.judgedSum);
        }
    }
    single("Overlaps", nOverlaps);

    if (nOverlaps == 0)
    {
        // The bodies have not met yet, or are too deep inside each other
        report.row
        (
            "Boxes of the sides",
            {box.overlaps(plusBox) ? "overlap" : "are apart"}
        );
    }
    else
    {
        const scalar maxArea = max(M.currentArea, P.currentArea);
        row("Current area of overlaps [m2]", M.currentArea, P.currentArea);
        single
        (
            "  difference, relative",
            mag(M.currentArea - P.currentArea)/maxArea
        );
        single("First moment of them [m3] (1)", M.areaMoment);
        single("", P.areaMoment);
        single
        (
            "  difference, relative (1)",
            mag(M.areaMoment - P.areaMoment)/(maxArea*extent)
        );

        if (nNotOpposed)
        {
            single("Overlaps with unopposed normals", nNotOpposed);
        }
        if (nNotOpposed < nOverlaps)
        {
            single("Least gap [m]", leastGap);
            single("Mean gap [m]", gapArea/opposedArea);
            single("Greatest gap [m]", greatestGap);
            single("Penetration / face width", penetration);
            single("Overlaps closer than a face width", nNear);
            if (nNear)
            {
                single("  tangential offset / face width", offset);
            }
        }

        single("Transfer of a constant, error", constantError);
        single("Transfer of a linear field (2)", ownError);
        single("  at the other side's point", acrossError);
        row("Sum of value weights, error", M.valueError, P.valueError);
        row("Sum of flux weights, error", M.fluxError, P.fluxError);

        single
        (
            "Force balance of unit pressure",
            mag(M.force + P.force)/magForce
        );
        single
        (
            "Moment balance (1)",
            mag(M.moment + P.moment)/(magForce*extent)
        );
        if (max(M.greatestTraction, P.greatestTraction) > 0)
        {
            const auto range = [](const sideSums& s)
            {
                return
                    s.greatestTraction < 0 ? std::string("-")
                  : table::text
                    (
                        max(mag(s.leastTraction - 1), s.greatestTraction - 1)
                    );
            };
            report.row
            (
                "Traction of covered faces, error", {range(M), range(P)}
            );
        }
        Info<< "    (1) about " << middle << "; relative to the extent "
            << extent << " m" << nl
            << "    (2) tangential part; relative to the change of the field "
            << "over a mean face width " << width << " m" << nl;
    }

    // The checks. Each comparison also fails for a value that is not a number
    for (const sideSums* s : {&M, &P})
    {
        const std::string& name = report.side(s == &M ? 0 : 1);
        const scalar coverage = s->covered/s->area;
        report.check
        (
            coverage >= limits.minCoverage*(1 - 1e-9),
            "Coverage of " + name + " is " + table::text(coverage)
          + ", less than " + table::text(limits.minCoverage)
        );
        report.check
        (
            s->judgedSum <= contactLimits::maxWeightSum,
            "Overlaps of " + name + " overlap each other: sum of weights "
          + table::text(s->judgedSum) + " > "
          + table::text(scalar(contactLimits::maxWeightSum))
        );
        report.check
        (
            s->fluxError <= contactLimits::maxTransferError,
            "Flux weights of " + name + " do not sum up to 1: error "
          + table::text(s->fluxError)
        );
    }
    constantError = max(constantError, max(M.valueError, P.valueError));
    report.check
    (
        constantError <= contactLimits::maxTransferError,
        "A constant field is not transferred exactly: error "
      + table::text(constantError)
    );
    const scalar forceDefect =
        mag(M.force + P.force)/max(magForce, VSMALL);
    report.check
    (
        forceDefect <= contactLimits::maxForceDefect,
        "Forces on both sides do not balance: relative defect "
      + table::text(forceDefect)
    );
    report.check
    (
        tied || penetration <= limits.maxPenetration,
        "The sides penetrate each other by " + table::text(penetration)
      + " face widths, more than " + table::text(limits.maxPenetration)
    );
    report.check
    (
        offset <= contactLimits::maxOffset,
        "Paired points are " + table::text(offset)
      + " face widths apart along the surface"
      + (
            contact.moves()
          ? "" : ": the bodies have slid, or the surfaces do not fit when "
            "the gap is closed. 'pairing nearestFace' pairs sliding bodies "
            "again"
        )
    );
}


// ************************************************************************* //
