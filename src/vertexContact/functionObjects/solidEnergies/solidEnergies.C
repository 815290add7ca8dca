/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidEnergies.H"
#include "rankRows.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidFunctionObject(solidEnergies)


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::solidEnergies::solidEnergies
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    solidFunctionObject(name, runTime, dict)
{
    checkKeywords(dict, keywords());
    solids_.accountEnergies();

    energies_ = openFile("energies.dat");
    momentum_ = openFile("momentum.dat");

    if (Pstream::master())
    {
        wordList owners;
        for (const solidBody& body : solids_.bodies())
        {
            owners.append(body.name());
        }
        owners.append("total");

        *energies_ << "# Time[s]";
        *momentum_ << "# Time[s]";
        for (const word& owner : owners)
        {
            writeHeads
            (
                *energies_, owner,
                {
                    "kinetic[J]", "swing[J]", "strain[J]",
                    "plasticDissipation[J]", "numericalDissipation[J]",
                    "externalWork[J]", "contactWork[J]", "balance[J]"
                }
            );
            if (solids_.damped())
            {
                writeHeads(*energies_, owner, {"dampingDissipation[J]"});
            }
            if (solids_.relaxes())
            {
                writeHeads(*energies_, owner, {"relaxationDissipation[J]"});
            }
            writeHeads
            (
                *momentum_, owner,
                {
                    "px[kg.m/s]", "py[kg.m/s]", "pz[kg.m/s]",
                    "Lx[kg.m2/s]", "Ly[kg.m2/s]", "Lz[kg.m2/s]"
                }
            );
        }
        *energies_ << " total:frictionDissipation[J]" << endl;
        *momentum_ << endl;
    }

    writeFirstRow();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::solidEnergies::writeRow()
{
    const List<bodyEnergies> all(solids_.computeEnergies());

    vector totalP(Zero), totalL(Zero);
    List<vector> p(solids_.bodies().size()), L(p);
    forAll(p, i)
    {
        p[i] = returnReduce
        (
            solids_.bodies()[i].linearMomentum(), sumOp<vector>()
        );
        L[i] = returnReduce
        (
            solids_.bodies()[i].angularMomentum(), sumOp<vector>()
        );
        totalP += p[i];
        totalL += L[i];
    }
    p.append(totalP);
    L.append(totalL);

    if (Pstream::master())
    {
        *energies_ << runTime_.value();
        for (const auto& e : all)
        {
            appendNumbers
            (
                *energies_, e.kinetic, e.swing, e.strain, e.plasticDissipation,
                e.numericalDissipation, e.externalWork, e.contactWork, e.balance
            );
            if (solids_.damped()) *energies_ << ' ' << e.dampingDissipation;
            if (solids_.relaxes())
            {
                *energies_ << ' ' << e.relaxationDissipation;
            }
        }
        *energies_ << ' ' << all.last().frictionDissipation << endl;

        *momentum_ << runTime_.value();
        forAll(p, i) appendNumbers(*momentum_, p[i], L[i]);
        *momentum_ << endl;
    }

    return true;
}


// ************************************************************************* //
