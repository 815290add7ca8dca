/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactForces.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(contactForces, 0);
    addSolidFunctionObject(contactForces);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::contactForces::contactForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    solidFunctionObject(name, runTime, dict),
    files_(solids_.interfaces().size())
{
    checkKeywords(dict, keywords());

    forAll(files_, i)
    {
        const contactInterface& contact = solids_.interfaces()[i];
        autoPtr<OFstream> file(openFile(contact.name() + ".dat"));

        if (Pstream::master())
        {
            OFstream& os = *file;
            os  << "# Time[s]" << (contact.many() ? " minus plus" : "");
            const Pair<string> sides(contact.sideNames());
            for (const string* side : {&sides.first(), &sides.second()})
            {
                const string label(*side + ':');
                for (const char* c : {"Fx[N]", "Fy[N]", "Fz[N]"})
                {
                    os  << ' ' << label.c_str() << c;
                }
                for (const char* c : {"Ix[N.s]", "Iy[N.s]", "Iz[N.s]"})
                {
                    os  << ' ' << label.c_str() << c;
                }
            }
            os  << " area[m2] peakPressure[Pa] penetration[m]"
                << " relativePenetration[-] open stick slip"
                << " gapArea[m2] gapForce[N] frictionDissipation[J]" << endl;
            files_.set(i, file.ptr());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::contactForces::write()
{
    forAll(solids_.interfaces(), i)
    for (const contactInterface& contact : solids_.interfaces()[i].parts())
    {
        const bool many = solids_.interfaces()[i].many();
        const contactInterface::statistics& mine = contact.stageStatistics();

        const contactInterface::account sums(contact.sums().total());
        const vector values[4] =
        {
            returnReduce(mine.force, sumOp<vector>()),
            sums.impulse,
            returnReduce(mine.plusForce, sumOp<vector>()),
            sums.plusImpulse
        };
        const scalar area = returnReduce(mine.area, sumOp<scalar>());
        const scalar peak = returnReduce(mine.peakPressure, maxOp<scalar>());
        const scalar deepest =
            returnReduce(mine.penetration, maxOp<scalar>());
        const scalar relative =
            returnReduce(mine.relativePenetration, maxOp<scalar>());
        const scalar gapArea = returnReduce(mine.gapArea, sumOp<scalar>());
        const scalar gapForce = returnReduce(mine.gapForce, sumOp<scalar>());
        const label nOpen = returnReduce(mine.nOpen, sumOp<label>());
        const label nStick = returnReduce(mine.nStick, sumOp<label>());
        const label nSlip = returnReduce(mine.nSlip, sumOp<label>());

        // Of many surfaces, the pairs that touch
        if (Pstream::master() && (!many || nStick + nSlip > 0))
        {
            OFstream& os = files_[i];
            os  << runTime_.value();
            if (many)
            {
                const Pair<string> sides(contact.sideNames());
                os  << ' ' << sides.first().c_str()
                    << ' ' << sides.second().c_str();
            }
            for (const vector& v : values)
            {
                os  << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
            }
            os  << ' ' << area << ' ' << peak << ' ' << deepest
                << ' ' << relative << ' ' << nOpen << ' ' << nStick << ' '
                << nSlip << ' ' << gapArea << ' ' << gapForce << ' '
                << sums.friction << endl;
        }
    }

    return true;
}


// ************************************************************************* //
