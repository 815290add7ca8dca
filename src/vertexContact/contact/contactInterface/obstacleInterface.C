/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "paperObstacleInterface.H"
#include "contactSurface.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "searchablePlane.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::autoPtr<Foam::searchableSurface>
Foam::obstacleInterface::readSurface
(
    const word& name,
    const dictionary& dict,
    const Time& time
)
{
    const dictionary& shape = dictionaryCheck::subDict
    (
        dict, "obstacle", "type sphere; centre (0 0 0); radius 1;"
    );
    const word type(shape.get<word>("type"));

    vertexContactLookupConstructor(searchableSurface, dict, type)

    if (!constructorFound)
    {
        dictionaryCheck::unknownModel
        (
            shape, "type", type,
            searchableSurface::dictConstructorTablePtr_->sortedToc()
        );
    }

    // Where OpenFOAM would divide by zero. New spheres may have three radii
    if (shape.found("radius") && shape.lookup("radius").size() == 1)
    {
        const scalar radius = shape.get<scalar>("radius");
        dictionaryCheck::require
        (
            radius > 0, shape, "radius", radius, "positive"
        );
    }
    if
    (
        shape.found("point1") && shape.found("point2")
     && shape.get<point>("point1") == shape.get<point>("point2")
    )
    {
        FatalIOErrorInFunction(shape)
            << "Keywords 'point1' and 'point2' are both "
            << shape.get<point>("point1") << ": they must differ"
            << exit(FatalIOError);
    }
    autoPtr<searchableSurface> surface;
    dictionaryCheck::withPlace
    (
        shape, "Keyword 'type' is " + type, [&]()
        {
            surface = constructorPtr
            (
                IOobject
                (
                    shape.getOrDefault<word>("file", name), time.constant(),
                    "triSurface", time, IOobject::MUST_READ, IOobject::NO_WRITE
                ),
                shape
            );
        }
    );
    if (cmptMax(surface->bounds().span()) <= 0)
    {
        FatalIOErrorInFunction(shape)
            << "Keyword 'obstacle': this " << type << " is a point, "
            << "its bounding box is " << surface->bounds()
            << exit(FatalIOError);
    }
    return surface;
}


Foam::scalar Foam::obstacleInterface::obstacleMoved() const
{
    scalar moved = 0;
    for (const point& x : reach_)
    {
        const point X(oldPose_.invTransformPoint(x));
        moved = max(moved, mag(motion_.pose().transformPoint(X) - x));
    }
    return moved;
}


void Foam::obstacleInterface::nearestTo
(
    const pointField& X,
    List<pointIndexHit>& hits,
    vectorField& normals
) const
{
    surface_->findNearest(X, scalarField(X.size(), sqr(GREAT)), hits);
    surface_->getNormal(hits, normals);

    // At an edge the surface returns the normal of one of its faces
    DynamicList<label> behind;
    forAll(X, i)
    {
        if (!hits[i].hit()) continue;
        const vector r(X[i] - hits[i].hitPoint());
        const scalar gap = r & normals[i];
        if (magSqr(r - gap*normals[i]) <= sqr(edgeRoundOff*leastWidth_))
        {
            continue;
        }
        if (gap > 0)
        {
            normals[i] = r/mag(r);
        }
        else
        {
            behind.append(i);
        }
    }

    // Points behind that face may be outside of a sharp edge
    if (behind.empty() || !surface_->hasVolumeType()) return;
    List<volumeType> sides;
    surface_->getVolumeType(pointField(X, behind), sides);
    forAll(behind, k)
    {
        const label i = behind[k];
        const vector r(X[i] - hits[i].hitPoint());
        if (sides[k] == volumeType::OUTSIDE) normals[i] = r/mag(r);
    }
}


void Foam::obstacleInterface::findCurved()
{
    curved_.clear();
    searchOf_.clear();
    searched_.clear();
    const medianDual& dual = side_.body->dual();
    const label d = dual.nDim();

    // Allowed motion of corner and obstacle together, in any direction
    const scalar reach = 2*allowed_*Foam::sqrt(scalar(d));

    pointField probes(2*d*planes_.size());
    label n = 0;
    for (const plane& its : planes_)
    {
        const point X(placeOf(its.corner));
        for (label i = 0; i < d; ++i)
        {
            vector e(Zero);
            e[dual.directions()[i]] = reach;
            e = motion_.pose().r().invTransform(e);
            probes[n++] = X + e;
            probes[n++] = X - e;
        }
    }
    List<pointIndexHit> hits;
    surface_->findNearest
    (
        probes, scalarField(probes.size(), sqr(GREAT)), hits
    );
    n = 0;
    Map<label> searchOfNode;
    forAll(planes_, k)
    {
        bool leaves = false;
        for (label i = 0; i < 2*d; ++i, ++n)
        {
            if (!hits[n].hit()) continue;
            const scalar gap = mag((probes[n] - planes_[k].x) & planes_[k].n);
            leaves =
                leaves
             || mag(mag(probes[n] - hits[n].hitPoint()) - gap)
              > edgeRoundOff*leastWidth_;
        }
        if (!leaves) continue;

        const label corner = planes_[k].corner;
        const label node = side_.geometry().cornerNode[corner];
        if (searchOfNode.insert(node, searched_.size()))
        {
            searched_.append(corner);
        }
        curved_.append(k);
        searchOf_.append(searchOfNode[node]);
    }
}


void Foam::obstacleInterface::followCurved()
{
    if (curved_.empty()) return;

    pointField X(searched_.size());
    forAll(X, i) X[i] = placeOf(searched_[i]);
    List<pointIndexHit> hits;
    vectorField normals;
    nearestTo(X, hits, normals);
    forAll(curved_, k)
    {
        const label i = searchOf_[k];
        if (!hits[i].hit()) continue;
        plane& its = planes_[curved_[k]];
        its.x = hits[i].hitPoint();
        its.n = normals[i];
    }
}


Foam::point Foam::obstacleInterface::placeOf(const label corner) const
{
    const solidBody& body = *side_.body;
    const label node = side_.geometry().cornerNode[corner];
    return motion_.pose().invTransformPoint
    (
        body.dual().projected(body.position(node)) + middle_
    );
}


Foam::scalar Foam::obstacleInterface::complianceAlong
(
    const label k,
    const vector& n,
    const scalar cosine,
    const scalar stretch,
    scalar& area
) const
{
    const solidBody& body = *side_.body;
    const scalar alone = body.surfaceCompliance(side_.patchi, k);
    const vector around(body.surfaceAround(side_.patchi, k));
    if (around == vector::zero) return stretch*alone;

    area *= cosine;
    return alone*max(around & n, area)/body.surfaceArea(side_.patchi, k);
}


void Foam::obstacleInterface::findForces()
{
    solidBody& body = *side_.body;
    const cornerStates& M = body.corners(side_.patchi);
    const scalarField& depth = body.surface(side_.patchi).depth;
    const scalar deltaT = body.contact().step();
    const bool remembers = this->remembers();

    forAll(planes_, i)
    {
        const label k = planes_[i].corner;
        const label node = M.geometry.cornerNode[k];
        contactLaw::problem& p = problems_[i];
        const vector area(body.currentArea(M.geometry, k));
        const scalar stretch = mag(area);

        p.minus.v = body.contact().velocityWithout(node);
        p.minus.zp = M.zp;
        p.minus.zs = M.zs;
        p.area = stretch*M.geometry.cornerArea[k];
        setObstacle(i, p);

        const bool facing = contactOverlaps::face(area, p.n);
        const scalar seen = facing ? area & p.n : stretch;
        const scalar pressed =
            facing
          ? complianceAlong(k, p.n, seen/stretch, stretch, p.area)
          : stretch*body.surfaceCompliance(side_.patchi, k);
        const contactLayer layer
        (
            remembers
          ? max(pressed, seen*body.holdCompliance(side_.patchi, k))
          : pressed
        );
        layer.set
        (
            p, facing, law().bonded(),
            remembers
          ? acousticRiemann::tangential(body.slide(node), p.n)
          : vector::zero,
            deltaT, body.contact().gives()
        );
        countClosing(p, depth[k]);
        if (!law().bonded()) askPush(p, depth[k], deltaT);
        checkPassed(closed_[i], side_, k, p.gap, depth[k], depth[k]);
    }
}


void Foam::obstacleInterface::setObstacle
(
    const label i,
    contactLaw::problem& p
) const
{
    const septernion& pose = motion_.pose();
    const plane& its = planes_[i];
    const point X(placeOf(its.corner));
    vector velocity(motion_.velocity(X));

    // Out of the body
    p.n = -pose.r().transform(its.n);
    p.gap = (X - its.x) & its.n;

    // Where the mesh leaves a direction out, the line in which it cuts the
    // plane; that goes aside with what is oblique and goes through the mesh
    const medianDual& dual = side_.body->dual();
    const vector within(dual.projected(p.n));
    const scalar cosine = mag(within);
    if (mag(p.n - within) > SMALL && cosine > parallel)
    {
        const vector across(velocity - dual.projected(velocity));
        velocity += (across & p.n)/sqr(cosine)*within;
        p.n = within/cosine;
        p.gap /= cosine;
    }
    p.plus = acousticRiemann::rigidSide(p.minus, velocity);
}


void Foam::obstacleInterface::correct()
{
    solidBody& body = *side_.body;
    const dualPatch& patch = side_.geometry();
    forAll(planes_, i)
    {
        const label k = planes_[i].corner;
        const contactLaw::problem& p = problems_[i];
        setState(side_, k, answer(p, p.area));
        if (p.result.state != acousticRiemann::status::open)
        {
            body.contact().add(patch.cornerNode[k], p.area*p.result.t);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::obstacleInterface::obstacleInterface
(
    const word& name,
    const dictionary& dict,
    const contactSide& side
)
:
    contactInterface(name, dict),
    side_(side),
    middle_
    (
        side_.body->mesh().bounds().midpoint()
      - side_.body->dual().projected(side_.body->mesh().bounds().midpoint())
    ),
    width_(side_.body->corners(side_.patchi).size(), Zero),
    surface_(readSurface(name, dict, side_.body->mesh().time())),
    motion_(dict, side_.body->mesh()),
    leastWidth_(GREAT),
    sideMotion_(side_),
    cut_(false),
    oldPose_(septernion::I)
{
    const dualPatch& patch = side_.geometry();
    const contactFaceList faces
    (
        contactSurface::faces(side_, globalIndex(patch.nCorners()))
    );
    forAll(faces, f)
    {
        leastWidth_ = min(leastWidth_, faces[f].width);
        for (label k = patch.faceStart[f]; k < patch.faceStart[f + 1]; ++k)
        {
            width_[k] = faces[f].width;
        }
    }
    reduce(leastWidth_, minOp<scalar>());
    cut_ = returnReduce(label(faces.size() > 0), sumOp<label>()) > 1;

    if (remembers() && side_.body->variational())
    {
        side_.body->rememberSlide();
    }

    if (side_.body->immovable())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'side': no force can move the rigid region '"
            << side_.body->name() << "' or an obstacle, so contact between "
            << "them would do nothing" << exit(FatalIOError);
    }
    if (isA<searchablePlane>(surface_()) && !motion_.moves())
    {
        const vector& n = refCast<const searchablePlane>(surface_()).normal();
        if (mag(side_.body->dual().projected(n)) <= parallel)
        {
            FatalIOErrorInFunction(dict.subDict("obstacle"))
                << "Keyword 'obstacle': the normal of this plane is " << n
                << ", which is normal to the mesh of region '"
                << side_.body->name() << "': they can never touch"
                << exit(FatalIOError);
        }
    }

    if (!side_.body->rigid())
    {
        motion_.setInterval
        (
            obstacleMotion::ofWave*leastWidth_/side_.body->material().cp()
        );
    }
    update(side_.body->mesh().time().value(), true);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::obstacleInterface> Foam::obstacleInterface::New
(
    const word& name,
    const dictionary& dict,
    const contactSide& side
)
{
    return autoPtr<obstacleInterface>
    (
        side.body->variational()
      ? new obstacleInterface(name, dict, side)
      : new paperObstacleInterface(name, dict, side)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::obstacleInterface::keywords()
{
    return
    {
        {"side", "", "required", "surface of the body: a region and a patch"},
        {
            "obstacle", "", "required",
            "dictionary of a searchableSurface, with its 'type'"
        },
        {"motion", "", "at rest", "dictionary with the keywords below"},
        {"law", "", "frictionless", "dictionary of the contact law"}
    };
}


Foam::List<Foam::contactSide> Foam::obstacleInterface::sides() const
{
    return List<contactSide>({side_});
}


Foam::Pair<Foam::string> Foam::obstacleInterface::sideNames() const
{
    return Pair<string>(side_.body->name() + '.' + side_.patchName, "obstacle");
}


Foam::labelList Foam::obstacleInterface::nearCorners() const
{
    labelList corners(planes_.size());
    forAll(planes_, i)
    {
        corners[i] = planes_[i].corner;
    }
    return corners;
}


void Foam::obstacleInterface::findNearest
(
    pointField& X,
    List<pointIndexHit>& hits,
    vectorField& normals
) const
{
    // Nodes are searched once for each corner; that is done rarely
    X.setSize(side_.geometry().nCorners());
    forAll(X, k) X[k] = placeOf(k);
    nearestTo(X, hits, normals);
}


bool Foam::obstacleInterface::outdated(const scalar time)
{
    if (sideMotion_.exceeded(time))
    {
        return true;
    }
    if (!motion_.moves())
    {
        return false;
    }
    motion_.setTime(time);
    return obstacleMoved() > allowed_;
}


bool Foam::obstacleInterface::update(const scalar time, const bool)
{
    const dualPatch& patch = side_.geometry();
    motion_.setTime(time);
    oldPose_ = motion_.pose();

    pointField x;
    List<pointIndexHit> hits;
    vectorField normals;
    findNearest(x, hits, normals);

    // Corners within one face width get a plane
    planes_.clear();
    scalar nearest = GREAT;
    const bodyContact& contact = side_.body->contact();
    const scalarField& depth = side_.body->surface(side_.patchi).depth;
    forAll(x, k)
    {
        if (hits[k].hit())
        {
            const scalar gap = (x[k] - hits[k].hitPoint()) & normals[k];
            nearest = min(nearest, mag(x[k] - hits[k].hitPoint()));
            // Points beside the rim of an open surface are not inside
            const scalar beside =
                mag(x[k] - hits[k].hitPoint() - gap*normals[k]);
            checkPassed
            (
                contact.touches(patch.cornerNode[k]) && beside <= depth[k],
                side_, k, gap, depth[k], depth[k]
            );
            if
            (
                gap <= leastWidth_ && gap >= -depth[k]
             && mag(x[k] - hits[k].hitPoint()) <= max(leastWidth_, depth[k])
            )
            {
                planes_.append
                (
                    plane{label(k), hits[k].hitPoint(), normals[k]}
                );
            }
        }
    }
    closed_.setSize(planes_.size(), false);
    problems_.setSize(planes_.size());
    if (cut_) reduce(nearest, minOp<scalar>());

    allowed_ =
        nearest > leastWidth_
      ? 0.5*(nearest - leastWidth_)
      + surfaceMotion::largestDistance*leastWidth_
      : surfaceMotion::usualDistance*leastWidth_;
    findCurved();
    const boundBox box(sideMotion_.box());
    reach_.clear();
    if (motion_.moves() && box.min().x() <= box.max().x())
    {
        reach_ = contactSurface::grown(box, allowed_).points();
    }
    sideMotion_.start
    (
        time, allowed_, allowed_, {vector::zero, vector::zero}
    );
    return true;
}


void Foam::obstacleInterface::forOpposite(const visitor& visit) const
{
    visit(side_, nearCorners(), 0);
}


void Foam::obstacleInterface::forHolding(const visitor& visit) const
{
    if (!holds()) return;

    DynamicList<label> facing;
    const quaternion& r = motion_.pose().r();
    for (const plane& its : planes_)
    {
        const vector area
        (
            side_.body->currentArea(side_.geometry(), its.corner)
        );
        if (contactOverlaps::face(area, -r.transform(its.n)))
        {
            facing.append(its.corner);
        }
    }
    visit(side_, facing, 0);
}


void Foam::obstacleInterface::remember()
{
    const bodyContact& contact = side_.body->contact();
    const labelList& node = side_.geometry().cornerNode;
    forAll(planes_, i) closed_[i] = contact.touches(node[planes_[i].corner]);
}


void Foam::obstacleInterface::find(const scalar time)
{
    statistics_ = statistics();
    asked_ = push();
    if (planes_.empty()) return;

    motion_.setTime(time);
    forceTime_ = time;
    followCurved();
    findForces();
}


void Foam::obstacleInterface::askPushes(DynamicList<push>& all) const
{
    if (pushes(*side_.body)) ask(all, *side_.body);
}


void Foam::obstacleInterface::limitPushes(const UList<push>& all, label& place)
{
    if (!pushes(*side_.body)) return;

    const scalar share = shareOf(all[place++]);
    if (share == 1) return;
    forAll(planes_, i)
    {
        if (problems_[i].gap < 0) contactLayer::limit(problems_[i], share);
    }
}


void Foam::obstacleInterface::solve()
{
    if (planes_.empty()) return;

    const scalarField& depth = side_.body->surface(side_.patchi).depth;
    solveProblems();
    forAll(planes_, i)
    {
        const label k = planes_[i].corner;
        const contactLaw::problem& p = problems_[i];
        count(p, width_[k], depth[k], p.area, p.area);
    }
    correct();
}


Foam::vector Foam::obstacleInterface::stepVelocity
(
    const label node,
    const septernion& begin,
    const septernion& end,
    const scalar deltaT
) const
{
    const solidBody& body = *side_.body;
    const point X
    (
        begin.invTransformPoint
        (
            body.position(node) - deltaT*body.stepVelocity(node)
        )
    );
    return (end.transformPoint(X) - begin.transformPoint(X))/deltaT;
}


void Foam::obstacleInterface::slide(const scalar middle, const scalar deltaT)
{
    solidBody& body = *side_.body;
    const bool remembers = this->remembers();
    const bool moves = remembers && motion_.moves() && deltaT > 0;
    septernion begin, end;
    if (moves)
    {
        begin = motion_.poseAt(forceTime_);
        end = motion_.poseAt(forceTime_ + deltaT);
    }
    const labelList& cornerNode = side_.geometry().cornerNode;
    account_.taken += work_.start(body, cornerNode.size());
    forAll(planes_, i)
    {
        const contactLaw::problem& p = problems_[i];
        if (p.result.state == acousticRiemann::status::open) continue;

        const label corner = planes_[i].corner;
        const label node = cornerNode[corner];
        const vector impulse(middle*p.area*p.result.t);
        work_.add(body, corner, node, impulse);
        account_.taken += impulse & p.plus.v;
        if (law().sticks())
        {
            sumFriction(p, p.plus.v - body.meanStepVelocity(node), middle);
        }
        if (!remembers) continue;

        const vector v
        (
            moves ? stepVelocity(node, begin, end, deltaT) : p.plus.v
        );
        body.contact().slide.add
        (
            node, slideBy(p, v - body.stepVelocity(node), deltaT)
        );
    }
    account_.taken -=
        work_.find(body, [&](const label i) { return cornerNode[i]; });
}


void Foam::obstacleInterface::report(Ostream& os) const
{
    os  << "Interface " << name() << ": " << side_.body->name() << ' '
        << side_.patchName << " - obstacle " << surface_->type()
        << (motion_.moves() ? ", moving" : "") << ", law " << law_->type()
        << nl;
}


// ************************************************************************* //
