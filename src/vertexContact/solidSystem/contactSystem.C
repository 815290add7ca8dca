/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactSystem.H"
#include "variationalScheme.H"
#include "solidBody.H"
#include "dictionaryCheck.H"
#include "generalInterface.H"
#include "OStringStream.H"
#include "rankRows.H"
#include "stopwatch.H"
#include "systemChecks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::contactSystem::dictionaries() const
{
    const dictionary& dict = properties_();
    dictionaryCheck::onlyKeywords(dict, wordList({"interfaces"}));
    const dictionary& list = dictionaryCheck::subDict
    (
        dict, "interfaces", "all { surfaces all; }"
    );
    for (const entry& e : list)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(list)
                << "Keyword '" << e.keyword()
                << "' is not a dictionary. An interface must be one"
                << exit(FatalIOError);
        }
    }
    return list;
}


void Foam::contactSystem::findHolding()
{
    holding_.setSize(bodies_.size(), false);
    for (const contactInterface& contact : interfaces_)
    {
        if (!contact.holds()) continue;
        const List<contactSide> sides(contact.sides());
        for (const contactSide& side : sides)
        {
            forAll(bodies_, i)
            {
                holding_[i] = holding_[i] || side.body == &bodies_[i];
            }
        }
    }
}


void Foam::contactSystem::setHolding()
{
    if (!holding_.found(true)) return;

    List<List<boolList>> corners(bodies_.size());
    forAll(bodies_, i)
    {
        corners[i].setSize(bodies_[i].mesh().boundaryMesh().size());
    }
    const contactInterface::visitor visit = [&]
    (
        const contactSide& side,
        const labelUList& some,
        const scalar
    )
    {
        forAll(bodies_, i)
        {
            if (side.body != &bodies_[i]) continue;
            boolList& its = corners[i][side.patchi];
            its.setSize(side.geometry().nCorners(), false);
            for (const label k : some) its[k] = true;
        }
    };
    for (const contactInterface& contact : interfaces_)
    {
        contact.forHolding(visit);
    }
    forAll(bodies_, i)
    {
        if (holding_[i]) bodies_[i].setHolding(corners[i]);
    }
}


void Foam::contactSystem::setOpposite()
{
    for (solidBody& body : bodies_)
    {
        if (!body.rigid() || body.immovable()) continue;

        List<boolList> corners(body.mesh().boundaryMesh().size());
        scalar all = 0;
        const contactInterface::visitor visit = [&]
        (
            const contactSide& side,
            const labelUList& some,
            const scalar area
        )
        {
            if (side.body != &body) return;
            boolList& its = corners[side.patchi];
            if (its.empty())
            {
                its.setSize(side.geometry().nCorners(), false);
            }
            for (const label k : some) its[k] = true;
            all += area;
        };
        for (const contactInterface& contact : interfaces_)
        {
            contact.forOpposite(visit);
        }
        body.setOpposite(corners, all);
    }
}


void Foam::contactSystem::findThickness()
{
    // The paper's scheme does not need it
    if (leaping_.empty()) return;

    scalar most = 0;
    for (const solidBody& body : bodies_)
    {
        most = max(most, body.deepestContact());
    }
    reduce(most, maxOp<scalar>());
    for (solidBody& body : bodies_) body.findThickness(most);
}


void Foam::contactSystem::findUnopposed()
{
    // The paper's interfaces do not tell what is opposite
    if (leaping_.empty()) return;

    unopposed_.clear();

    // Nodes that were pressed, and are deep inside
    List<labelList> inside(bodies_.size());
    bool any = false;
    forAll(bodies_, i)
    {
        inside[i] = bodies_[i].pressedInside(contactInterface::deepInside);
        any = any || inside[i].size();
    }
    if (!returnReduce(any, orOp<bool>())) return;

    List<scalarField> opposite(bodies_.size());
    forAll(bodies_, i) opposite[i].setSize(bodies_[i].dual().nNodes(), Zero);
    const contactInterface::visitor visit = [&]
    (
        const contactSide& side,
        const labelUList& corners,
        const scalar
    )
    {
        const labelList& node = side.geometry().cornerNode;
        forAll(bodies_, i)
        {
            if (side.body != &bodies_[i]) continue;
            for (const label k : corners) opposite[i][node[k]] = 1;
        }
    };
    for (const contactInterface& contact : interfaces_)
    {
        contact.forOpposite(visit);
    }
    forAll(bodies_, i)
    {
        bodies_[i].dual().sharing().sum(opposite[i].data(), 1);
        for (const label a : inside[i])
        {
            if (opposite[i][a] > 0 || unopposed_.size()) continue;
            OStringStream os;
            os  << "region " << bodies_[i].name() << ", "
                << bodies_[i].whereIs(a).c_str() << ", was pressed, "
                << -bodies_[i].contact().gap[a]
                << " m inside, and has nothing opposite any more";
            unopposed_ = os.str();
        }
    }
}


void Foam::contactSystem::limitPushes()
{
    pushes_.clear();
    for (const contactInterface& contact : interfaces_)
    {
        contact.askPushes(pushes_);
    }
    if (Pstream::parRun()) combineRowsOnAll(pushes_, plusEqOp<scalar>());
    label place = 0;
    for (contactInterface& contact : interfaces_)
    {
        contact.limitPushes(pushes_, place);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::contactSystem::contactSystem
(
    PtrList<solidBody>& bodies,
    UPtrList<leapfrogBody>& leaping,
    const label iterations
)
:
    bodies_(bodies),
    leaping_(leaping),
    iterations_(iterations),
    oldStatus_(bodies.size()),
    oldSlide_(bodies.size()),
    firstStatus_(bodies.size())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::contactSystem::read(const Time& runTime)
{
    IOobject contactIO
    (
        "contactProperties", runTime.constant(), runTime,
        IOobject::MUST_READ_IF_MODIFIED, IOobject::NO_WRITE
    );
    if (dictionaryCheck::isThere<IOdictionary>(contactIO))
    {
        // OpenFOAM does not say which file has a broken expression
        dictionaryCheck::withPlace
        (
            dictionary(contactIO.objectPath()), "The file cannot be read",
            [&]() { properties_.reset(new watchedDictionary(contactIO)); }
        );
        const dictionary& list = dictionaries();
        findThickness();
        // General contact comes last: it leaves out pairs that have an
        // interface of their own
        for (const bool general : {false, true})
        {
            for (const entry& e : list)
            {
                if (generalInterface::describedBy(e.dict()) == general)
                {
                    contactInterface::append
                    (
                        e.keyword(), e.dict(), bodies_, interfaces_
                    );
                }
            }
        }
        systemChecks::sameSides(list, interfaces_);
    }
    systemChecks::contactPatches
    (
        contactIO.objectPath(), bodies_, interfaces_
    );
    findHolding();
    setHolding();
    setOpposite();
}


bool Foam::contactSystem::readModifiedLaws()
{
    if (!properties_.valid() || !properties_->changed) return false;
    const dictionary& list = dictionaries();
    for (contactInterface& contact : interfaces_)
    {
        contact.readLaw(list.subDict(contact.dictName()));
    }
    properties_->changed = false;
    findHolding();
    setHolding();
    return true;
}


bool Foam::contactSystem::moves() const
{
    for (const contactInterface& contact : interfaces_)
    {
        if (contact.moves()) return true;
    }
    return false;
}


void Foam::contactSystem::solve(const scalar time, const bool firstStage)
{
    // Gaps open and close by the status of the latest first stage
    const stopwatch watch(forceSeconds_);
    for (contactInterface& contact : interfaces_)
    {
        contact.remember();
    }
    forAll(bodies_, i)
    {
        scalarField& its = bodies_[i].contact().status;
        if (!firstStage) firstStatus_[i] = its;
        its = Zero;
    }
    for (contactInterface& contact : interfaces_)
    {
        contact.find(time);
    }
    limitPushes();
    for (contactInterface& contact : interfaces_)
    {
        contact.solve();
    }
    // In a step of zero length nothing touches
    const bool moves = bodies_.size() && bodies_[0].contact().step() > 0;
    for (label i = 1; moves && i < iterations_; ++i)
    {
        for (leapfrogBody& body : leaping_) body.updateContactVelocity();
        for (contactInterface& contact : interfaces_)
        {
            contact.correct();
        }
    }
    forAll(bodies_, i)
    {
        scalarField& its = bodies_[i].contact().status;
        if (!firstStage) its = firstStatus_[i];
        else if (its.size()) bodies_[i].dual().sharing().max(its.data(), 1);
    }
}


void Foam::contactSystem::pair(const scalar time, const bool all)
{
    const stopwatch watch(pairingSeconds_);
    bool found = false;
    for (contactInterface& contact : interfaces_)
    {
        if (contact.moves()) found = contact.update(time, all) || found;
    }
    nPairings_ += found;
    setHolding();
    setOpposite();
    if (found) findUnopposed();
}


void Foam::contactSystem::pairMoved(const scalar time)
{
    if (!moves()) return;

    label most = 0;
    {
        const stopwatch watch(pairingSeconds_);
        for (contactInterface& contact : interfaces_)
        {
            if (contact.moves() && contact.outdated(time))
            {
                most = 1;
            }
        }
        label nBad = 0;
        for (const solidBody& body : bodies_) nBad += body.nBad();
        if (nBad) most = 2;
        reduce(most, maxOp<label>());
    }
    if (most == 1) pair(time, false);
}


void Foam::contactSystem::askToPairAll()
{
    if (moves()) pairAgain_ = pairAll_ = true;
}


bool Foam::contactSystem::pairIfAsked(const scalar time)
{
    if (!pairAgain_) return false;

    pair(time, pairAll_);
    pairAgain_ = pairAll_ = false;
    return true;
}


Foam::contactSystem::findings Foam::contactSystem::look
(
    const scalar time,
    const bool pairings
)
{
    const stopwatch watch(pairingSeconds_);
    findings found;
    found.failure = unopposed_;
    for (contactInterface& contact : interfaces_)
    {
        if (found.failure.empty()) found.failure = contact.passed();
        if (pairings && contact.moves() && contact.outdated(time))
        {
            found.outdated = true;
        }
    }
    return found;
}


void Foam::contactSystem::accumulate(const scalar weightedDeltaT)
{
    for (contactInterface& contact : interfaces_)
    {
        contact.accumulate(weightedDeltaT);
    }
}


void Foam::contactSystem::slide(const scalar middle, const scalar deltaT)
{
    const stopwatch watch(forceSeconds_);
    for (contactInterface& contact : interfaces_)
    {
        contact.accumulate(middle);
        contact.slide(middle, deltaT);
    }
    for (solidBody& body : bodies_)
    {
        body.finishSlide();
    }
}


Foam::scalar Foam::contactSystem::closingTime() const
{
    scalar least = GREAT;
    for (const contactInterface& contact : interfaces_)
    {
        least = min
        (
            least,
            1
           /(
                variationalScheme::stepsToClose
               *contact.stageStatistics().closing + VSMALL
            )
        );
    }
    return least;
}


Foam::label Foam::contactSystem::nClosed() const
{
    label n = 0;
    for (const contactInterface& contact : interfaces_)
    {
        const auto& s = contact.stageStatistics();
        n += s.nStick + s.nSlip;
    }
    return returnReduce(n, sumOp<label>());
}


void Foam::contactSystem::keepStart()
{
    forAll(bodies_, i)
    {
        oldStatus_[i] = bodies_[i].contact().status;
        oldSlide_[i] = bodies_[i].contact().slide.ways();
    }
    for (contactInterface& contact : interfaces_)
    {
        contact.keepSums();
    }
}


void Foam::contactSystem::restoreStart()
{
    forAll(bodies_, i)
    {
        bodies_[i].contact().status = oldStatus_[i];
        // Memory that began in this step was empty at its start
        vectorField& ways = bodies_[i].contact().slide.ways();
        if (oldSlide_[i].size()) ways = oldSlide_[i];
        else ways = Zero;
    }
    for (contactInterface& contact : interfaces_)
    {
        contact.restoreSums();
    }
}


void Foam::contactSystem::writeRecord(Ostream& os) const
{
    for (const contactInterface& contact : interfaces_)
    {
        os  << "interface_" << contact.name() << nl << '{' << nl;
        contact.writeRecord(os);
        os  << '}' << nl;
    }
}


void Foam::contactSystem::readRecord(const dictionary& record)
{
    for (contactInterface& contact : interfaces_)
    {
        const word entry("interface_" + contact.name());
        if (record.found(entry)) contact.readRecord(record.subDict(entry));
    }
}


void Foam::contactSystem::report(Ostream& os) const
{
    for (const contactInterface& contact : interfaces_)
    {
        contact.report(os);
    }
    if (interfaces_.empty())
    {
        os  << "No contact interfaces" << nl;
    }
    else if (iterations_ > 1)
    {
        os  << "Contact is solved " << iterations_ << " times per step" << nl;
    }
}


void Foam::contactSystem::reportCost
(
    Ostream& os,
    const double stepSeconds
) const
{
    if (interfaces_.empty()) return;

    const scalar percent = 100/max(stepSeconds, VSMALL);
    os  << "Contact: " << percent*pairingSeconds_
        << " % of the time of the steps in " << nPairings_
        << " pairings, " << percent*forceSeconds_ << " % in contact forces"
        << nl << nl;
}


// ************************************************************************* //
