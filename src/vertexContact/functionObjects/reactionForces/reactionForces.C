/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reactionForces.H"
#include "rankRows.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidFunctionObject(reactionForces)


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::functionObjects::reactionForces::nameOf
(
    const label bodyi,
    const label patchi
) const
{
    const solidBody& body = solids_.bodies()[bodyi];
    return
        body.rigid()
      ? body.name()
      : word
        (
            body.name() + '.' + body.mesh().boundaryMesh()[patchi].name(),
            false
        );
}


Foam::List<Foam::constraintReactions::patchReaction>
Foam::functionObjects::reactionForces::collect
(
    scalarList& times
) const
{
    DynamicList<constraintReactions::patchReaction> all;
    DynamicList<scalar> its;
    forAll(patches_, i)
    {
        const constraintReactions& reactions =
            *solids_.bodies()[i].reactions();
        for (const label patchi : patches_[i])
        {
            all.append(reactions.of(patchi));
            its.append(reactions.stepTime());
        }
    }
    times = its;
    List<constraintReactions::patchReaction> sums(all);
    combineRows(sums, plusEqOp<scalar>());
    return sums;
}


void Foam::functionObjects::reactionForces::writeRecord(Ostream& os) const
{
    scalarList times;
    List<constraintReactions::patchReaction> sums(collect(times));
    // Every rank writes a record
    scatterRows(sums);
    os  << "    patches (";
    forAll(patches_, i)
    {
        for (const label patchi : patches_[i])
        {
            os  << " \"" << nameOf(i, patchi).c_str() << '"';
        }
    }
    os  << ");" << nl << "    times (";
    for (const scalar t : times) os  << ' ' << t;
    os  << ");" << nl << "    sums (";
    for (const constraintReactions::patchReaction& r : sums)
    {
        appendNumbers(os, r.impulse, r.work, r.stepImpulse, r.stepTwist);
    }
    os  << ");" << nl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::reactionForces::reactionForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    solidFunctionObject(name, runTime, dict),
    patches_(solids_.bodies().size())
{
    checkKeywords(dict, keywords());

    label n = 0;
    forAll(patches_, i)
    {
        const solidBody& body = solids_.bodies()[i];
        if (!body.variational())
        {
            FatalIOErrorInFunction(dict)
                << "Function object '" << name << "' of type '" << type()
                << "' does not work with preset paper, whose boundary "
                << "conditions are fluxes" << exit(FatalIOError);
        }
        patches_[i] = body.reactingPatches();
        n += patches_[i].size();
    }
    if (n == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Function object '" << name << "' of type '" << type()
            << "': no patch holds nodes of a region that deforms, and no rigid "
            << "region is held. Valid types in pointU: (fixedDisplacement "
            << "fixedVelocity slip), and mirrors" << exit(FatalIOError);
    }

    solids_.accountReactions();
    const dictionary record(solids_.records().of(name));
    if (record.found("patches"))
    {
        const List<string> names(record.get<List<string>>("patches"));
        const scalarList times(record.get<scalarList>("times"));
        const scalarList sums(record.get<scalarList>("sums"));

        // Earlier releases wrote no twists
        const label stride = names.size() ? sums.size()/names.size() : 0;
        forAll(patches_, i)
        {
            for (const label patchi : patches_[i])
            {
                const label k = names.find(nameOf(i, patchi));
                if (k < 0) continue;
                const scalar* s = sums.cdata() + k*stride;
                constraintReactions::patchReaction r;
                if (Pstream::master())
                {
                    r.impulse = vector(s[0], s[1], s[2]);
                    r.work = s[3];
                    r.stepImpulse = vector(s[4], s[5], s[6]);
                    if (stride > 7) r.stepTwist = vector(s[7], s[8], s[9]);
                }
                solids_.continueReaction(i, patchi, r, times[k]);
            }
        }
    }
    solids_.records().keep(name, [this](Ostream& os) { writeRecord(os); });

    file_ = openFile("reactions.dat");
    if (Pstream::master())
    {
        OFstream& os = *file_;
        os  << "# Time[s]";
        forAll(patches_, i)
        {
            for (const label patchi : patches_[i])
            {
                const word patch(nameOf(i, patchi));
                writeHeads
                (
                    os, patch,
                    {
                        "Fx[N]", "Fy[N]", "Fz[N]",
                        "Ix[N.s]", "Iy[N.s]", "Iz[N.s]", "work[J]"
                    }
                );
                if (!solids_.bodies()[i].rigid()) continue;
                writeHeads(os, patch, {"Mx[N.m]", "My[N.m]", "Mz[N.m]"});
            }
        }
        os  << endl;
    }

    writeFirstRow();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::reactionForces::writeRow()
{
    scalarList times;
    const List<constraintReactions::patchReaction> sums(collect(times));
    if (Pstream::master())
    {
        *file_ << runTime_.value();
        label k = 0;
        forAll(patches_, i)
        {
            const bool rigid = solids_.bodies()[i].rigid();
            for (label p = 0; p < patches_[i].size(); ++p, ++k)
            {
                const constraintReactions::patchReaction& r = sums[k];
                const scalar perTime = times[k] > 0 ? 1/times[k] : 0;
                appendNumbers
                (
                    *file_, r.stepImpulse*perTime, r.impulse, r.work
                );
                if (rigid) appendNumbers(*file_, r.stepTwist*perTime);
            }
        }
        *file_ << endl;
    }
    return true;
}


// ************************************************************************* //
