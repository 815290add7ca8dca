/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidAverages.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

makeSolidFunctionObject(solidAverages)


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::solidAverages::solidAverages
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    solidFunctionObject(name, runTime, dict),
    selections_(nodeSelection::read(dict, solids_.bodies())),
    fields_(selections_.size()),
    measures_(selections_.size())
{
    checkKeywords(dict, keywords());

    forAll(selections_, i)
    {
        const nodeSelection& selection = selections_[i];
        fields_[i] = fieldComponent::read
        (
            dict, "fields", selection.body(), false
        );
        measures_[i] = returnReduce
        (
            sum(selection.weights()), sumOp<scalar>()
        );
    }

    file_ = openFile("averages.dat");
    if (Pstream::master())
    {
        forAll(selections_, i)
        {
            *file_ << "# " << selections_[i].name().c_str() << ' '
                << measures_[i] << nl;
        }
        *file_ << "# Time[s]";
        forAll(fields_, i)
        {
            for (const fieldComponent& component : fields_[i])
            {
                *file_
                    << ' ' << selections_[i].name().c_str() << ':'
                    << component.name().c_str() << '['
                    << component.unit().c_str() << ']';
            }
        }
        *file_ << endl;
    }

    writeFirstRow();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::keywordList Foam::functionObjects::solidAverages::keywords()
{
    return
        keywordList
        {
            {
                "fields", "", "required",
                "names of written fields, or components such as pointD.x"
            }
        }
      + nodeSelection::keywords();
}


bool Foam::functionObjects::solidAverages::writeRow()
{
    DynamicList<scalar> sums;
    forAll(selections_, i)
    {
        const labelList& nodes = selections_[i].nodes();
        const scalarField& weights = selections_[i].weights();
        fieldComponent::visit
        (
            fields_[i], selections_[i].body(), nodes,
            [&](const fieldComponent& component, const auto& values)
            {
                scalar sum = 0;
                forAll(nodes, k)
                {
                    sum += weights[k]*component.value(values, k);
                }
                sums.append(sum/measures_[i]);
            }
        );
    }
    scalarList all(sums);
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    if (Pstream::master())
    {
        *file_ << runTime_.value();
        for (const scalar value : all) *file_ << ' ' << value;
        *file_ << endl;
    }
    return true;
}


// ************************************************************************* //
