/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "generalInterface.H"
#include "contactSurface.H"
#include "pointTree.H"
#include "rankRows.H"
#include "solidBody.H"
#include "ListListOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::generalInterface::pairKey>
Foam::generalInterface::candidates
(
    const scalar time,
    const UList<contactSurface::bodyMotion>& motions
)
{
    // Until the next search each side moves by reach_ at most, and pairings
    // search up to twice that
    List<boundBox> boxes(surfaces_.size());
    contactSurface::bodyMotion mean{vector::zero, vector::zero};
    forAll(surfaces_, i)
    {
        // Positions in directions that are left out do not count
        const medianDual& dual = surfaces_[i].body->dual();
        const boundBox box(motions_[i].box());
        boxes[i] = boundBox
        (
            dual.projected(box.min()), dual.projected(box.max())
        );
        mean.velocity += motions[i].velocity/surfaces_.size();
        mean.displacement += motions[i].displacement/surfaces_.size();
    }
    contactSurface::joinOnAll(boxes);

    pointField centres(boxes.size());
    scalarField radius(boxes.size());
    forAll(boxes, i)
    {
        boxes[i] = contactSurface::grown(boxes[i], 2*reach_);
        centres[i] = boxes[i].midpoint();
        radius[i] = 0.5*boxes[i].mag();
        motions_[i].start(time, reach_, reach_, mean);
    }
    const autoPtr<pointTree> tree(newPointTree(centres, max(radius)));

    // Each surface finds those that are not larger than itself
    HashSet<pairKey, keyHash> near;
    forAll(boxes, i)
    {
        const treeBoundBox around(contactSurface::grown(boxes[i], radius[i]));
        for (const label j : tree->findBox(around))
        {
            if
            (
                radius[j] <= radius[i] && boxes[i].overlaps(boxes[j])
             && rule_(i, j) >= 0
            )
            {
                near.insert(rule_.key(i, j));
            }
        }
    }
    return near.sortedToc();
}


void Foam::generalInterface::join()
{
    DynamicList<bodyInterface*> acting(active_.size()), sticking(acting);
    for (const label i : active_)
    {
        bodyInterface& part = parts_[i];
        if (!part.concerned())
        {
            part.forget();
            continue;
        }
        acting.append(&part);
        if (part.law().sticks()) sticking.append(&part);
    }
    acting_.set(acting);
    sticking_.set(sticking);
}


void Foam::generalInterface::collect()
{
    statistics_ = statistics();
    for (const bodyInterface* part : acting_.pairs)
    {
        const statistics& s = part->stageStatistics();
        statistics_.force += s.force;
        statistics_.plusForce += s.plusForce;
        statistics_.gapForce += s.gapForce;
        statistics_.gapArea += s.gapArea;
        statistics_.frictionPower += s.frictionPower;
        statistics_.area += s.area;
        statistics_.peakPressure =
            max(statistics_.peakPressure, s.peakPressure);
        statistics_.penetration =
            max(statistics_.penetration, s.penetration);
        statistics_.relativePenetration =
            max(statistics_.relativePenetration, s.relativePenetration);
        statistics_.closing = max(statistics_.closing, s.closing);
        statistics_.nOpen += s.nOpen;
        statistics_.nStick += s.nStick;
        statistics_.nSlip += s.nSlip;
        if (passed_.empty() && part->passed().size()) passed_ = part->passed();
    }
}


Foam::word Foam::generalInterface::partName(const pairKey key) const
{
    const labelPair pair(rule_.pairOf(key));
    return word
    (
        name() + '.' + surfaceSelection::name(surfaces_[pair.first()]) + '-'
      + surfaceSelection::name(surfaces_[pair.second()])
    );
}


const Foam::contactInterface::account&
Foam::generalInterface::sumsOf(const pairKey key) const
{
    const label i = findSortedIndex(keys_, key);
    return i >= 0 ? parts_[i].sums() : past_[key];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::generalInterface::generalInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<solidBody>& bodies,
    const UPtrList<contactInterface>& others
)
:
    contactInterface(name, dict),
    reach_(0)
{
    readRules(dict, bodies, others);

    motions_.setSize(surfaces_.size());
    forAll(surfaces_, i)
    {
        motions_.set(i, new surfaceMotion(surfaces_[i]));
        const contactSide& side = surfaces_[i];
        reach_ = max(reach_, side.body->surface(side.patchi).reach);
    }

    update(bodies[0].mesh().time().value(), true);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::Pair<Foam::string> Foam::generalInterface::sideNames() const
{
    return Pair<string>("minus", "plus");
}


Foam::UPtrList<const Foam::contactInterface>
Foam::generalInterface::parts() const
{
    UPtrList<const contactInterface> list(parts_.size());
    forAll(parts_, i) list.set(i, &parts_[i]);
    return list;
}


Foam::List<Foam::contactInterface::pairState>
Foam::generalInterface::pairStates() const
{
    // Pairs that have never had overlaps are left out
    DynamicList<pairState> states(past_.size());
    forAll(parts_, i)
    {
        if (!past_.found(keys_[i])) continue;
        const bodyInterface& part = parts_[i];
        states.append
        (
            pairState
            {
                part.sideNames(), &part.stageStatistics(), &part.sums()
            }
        );
    }
    for (const pairKey k : past_.sortedToc())
    {
        if (findSortedIndex(keys_, k) >= 0) continue;
        const labelPair pair(rule_.pairOf(k));
        const contactSide& a = surfaces_[pair.first()];
        const contactSide& b = surfaces_[pair.second()];
        states.append
        (
            pairState{bodyInterface::namesOf(a, b), nullptr, &past_[k]}
        );
    }
    return List<pairState>(states);
}


bool Foam::generalInterface::outdated(const scalar time)
{
    bool is = false;
    for (surfaceMotion& motion : motions_) is = motion.exceeded(time) || is;

    velocities_.setSize(surfaces_.size());
    forAll(surfaces_, i)
    {
        const contactSide& side = surfaces_[i];
        velocities_[i] = side.body->surfaceVelocities(side.patchi, time);
    }
    forAll(watched_, i)
    {
        watch& w = watched_[i];
        w.left -=
            (time - lastWatch_)
           *max
            (
                surfaceMotion::fastest(velocities_[w.sides.first()], w.frame),
                surfaceMotion::fastest(velocities_[w.sides.second()], w.frame)
            );
        if (w.left >= 0) continue;
        w.left = parts_[i].left(time);
        is = is || w.left < 0;
    }
    lastWatch_ = time;
    return is;
}


bool Foam::generalInterface::update(const scalar time, const bool all)
{
    const List<contactSurface::bodyMotion> motions
    (
        contactSurface::bodyMotions(surfaces_)
    );
    const auto commonOf = [&](const pairKey key)
    {
        const labelPair pair(rule_.pairOf(key));
        return contactSurface::bodyMotion::common
        (
            motions[pair.first()], motions[pair.second()]
        );
    };
    labelList moved(keys_.size(), label(3));
    bool search = all;
    if (!all)
    {
        for (surfaceMotion& motion : motions_)
        {
            motion.look(time);
            search = search || motion.left(bodyInterface::againAfter) < 0;
        }
        reduce(search, orOp<bool>());
        forAll(parts_, i)
        {
            moved[i] = parts_[i].moved(time, commonOf(keys_[i]));
        }
        combineOnAll(moved, [](label& a, const label b) { a |= b; });
    }

    // Without a search the near pairs stay the same
    List<pairKey> keys(keys_);
    if (search) keys = candidates(time, motions);

    boolList wasSummed;
    wasSummed.setSize(keys_.size(), false);
    for (const label i : summed_) wasSummed[i] = true;
    DynamicList<label> active, summed;
    watched_.setSize(keys.size());
    lastWatch_ = time;

    PtrList<bodyInterface> parts(keys.size());
    label old = 0;
    const auto take = [&](const label i, const bool kept)
    {
        bodyInterface& part = parts[i];
        watched_[i] =
        {
            part.pairing().left(),
            part.pairing().frame(),
            rule_.pairOf(keys[i])
        };
        const bool is = part.pairing().active();
        if (is)
        {
            active.append(i);
            past_.insert(keys[i], account());
        }
        if (is || kept) summed.append(i);
        // Its sums have not changed in this step yet
        if (is && !kept) part.keepSums();
    };

    // One snapshot for each surface that is paired again, and one exchange for
    // all pairings to find whether any rank has overlaps, or the least distance
    boolList isOld, again, kept, wanted;
    for (boolList* list : {&isOld, &again, &kept})
    {
        list->setSize(keys.size(), false);
    }
    scalarField nearest(keys.size(), GREAT);
    wanted.setSize(surfaces_.size(), false);
    forAll(keys, i)
    {
        while (old < keys_.size() && keys_[old] < keys[i]) ++old;
        if (old == keys_.size() || keys_[old] != keys[i]) continue;
        isOld[i] = true;
        parts.set(i, parts_.set(old, nullptr).ptr());
        kept[i] = wasSummed[old];
        again[i] =
            all || parts[i].again(time, moved[old], commonOf(keys[i]));
        if (!again[i]) continue;
        for (const label k : rule_.pairOf(keys[i])) wanted[k] = true;
    }
    labelList place(surfaces_.size(), -1);
    DynamicList<contactSide> sides;
    forAll(wanted, i)
    {
        if (!wanted[i]) continue;
        place[i] = sides.size();
        sides.append(surfaces_[i]);
    }
    PtrList<contactSurface::snapshot> now(contactSurface::snapshots(sides));
    DynamicList<labelPair> meet;
    forAll(keys, i)
    {
        if (!again[i]) continue;
        const labelPair pair(rule_.pairOf(keys[i]));
        meet.append(labelPair(place[pair.first()], place[pair.second()]));
    }
    contactSurface::findFaces(now, meet, 2*reach_);
    const auto minus = [&](const pairKey key)
        -> const contactSurface::snapshot&
    {
        return now[place[rule_.pairOf(key).first()]];
    };
    const auto plus = [&](const pairKey key)
        -> const contactSurface::snapshot&
    {
        return now[place[rule_.pairOf(key).second()]];
    };
    forAll(keys, i)
    {
        if (again[i]) parts[i].find(minus(keys[i]), plus(keys[i]));
    }
    forAll(keys, i)
    {
        if (again[i]) nearest[i] = parts[i].pairing().nearest();
    }
    combineOnAll(nearest, minEqOp<scalar>());
    forAll(keys, i)
    {
        if (again[i])
        {
            parts[i].follow
            (
                time, minus(keys[i]), plus(keys[i]), nearest[i]
            );
        }
        if (!isOld[i])
        {
            const labelPair pair(rule_.pairOf(keys[i]));
            parts.set
            (
                i,
                bodyInterface::New
                (
                    partName(keys[i]), ruleOf(keys[i]),
                    surfaces_[pair.first()], surfaces_[pair.second()]
                ).ptr()
            );
            if (past_.found(keys[i])) parts[i].setSums(past_[keys[i]]);
        }
        take(i, kept[i]);
    }
    forAll(parts_, i)
    {
        if (parts_.set(i) && past_.found(keys_[i]))
        {
            past_.set(keys_[i], parts_[i].sums());
        }
    }
    keys_.transfer(keys);
    parts_.transfer(parts);
    active_.transfer(active);
    summed_.transfer(summed);
    join();
    return meet.size() || isOld.find(false) >= 0;
}


void Foam::generalInterface::remember()
{
    for (bodyInterface* part : acting_.pairs) part->remember();
}


bool Foam::generalInterface::variational() const
{
    return surfaces_.size() && surfaces_[0].body->variational();
}


void Foam::generalInterface::forOpposite(const visitor& visit) const
{
    for (const label i : active_) parts_[i].forOpposite(visit);
}


void Foam::generalInterface::forHolding(const visitor& visit) const
{
    for (const label i : active_) parts_[i].forHolding(visit);
}


void Foam::generalInterface::find(const scalar)
{
    if (!variational()) return;
    sticking_.startSlides();
    acting_.findForces();
}


void Foam::generalInterface::askPushes(DynamicList<push>& all) const
{
    for (const label i : active_) parts_[i].askPushes(all);
}


void Foam::generalInterface::limitPushes
(
    const UList<push>& all,
    label& place
)
{
    for (const label i : active_) parts_[i].limitPushes(all, place);
}


void Foam::generalInterface::solve()
{
    if (variational())
    {
        acting_.exchangeForces();
    }
    else
    {
        for (bodyInterface* part : acting_.pairs) part->solve();
    }
    collect();
}


void Foam::generalInterface::correct()
{
    acting_.correctForces();
    collect();
}


void Foam::generalInterface::accumulate(const scalar weightedDeltaT)
{
    contactInterface::accumulate(weightedDeltaT);
    for (bodyInterface* part : acting_.pairs) part->accumulate(weightedDeltaT);
}


void Foam::generalInterface::slide(const scalar middle, const scalar deltaT)
{
    acting_.take(middle);
    const auto friction = [&]
    {
        scalar sum = 0;
        for (const bodyInterface* part : sticking_.pairs)
        {
            sum += part->sums().friction;
        }
        return sum;
    };
    const scalar before = friction();
    sticking_.slide(middle, deltaT);
    account_.friction += friction() - before;
}


void Foam::generalInterface::keepSums()
{
    contactInterface::keepSums();
    for (const label i : summed_) parts_[i].keepSums();
    summed_ = active_;
}


void Foam::generalInterface::restoreSums()
{
    contactInterface::restoreSums();
    for (const label i : summed_) parts_[i].restoreSums();
}


// ************************************************************************* //
