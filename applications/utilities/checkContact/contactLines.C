/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactLines.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::contactLines::setNames(const wordList& names)
{
    if (names.size() > maxValues)
    {
        FatalErrorInFunction
            << names.size() << " values a line: at most " << maxValues
            << exit(FatalError);
    }
    names_ = names;
}


void Foam::contactLines::append
(
    const point& from,
    const point& to,
    std::initializer_list<scalar> values
)
{
    line l(scalar(0));
    for (direction i = 0; i < 3; ++i)
    {
        l[i] = from[i];
        l[3 + i] = to[i];
    }
    label k = 6;
    for (const scalar value : values) l[k++] = value;
    lines_.append(l);
}


void Foam::contactLines::write(const fileName& file) const
{
    List<List<line>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = List<line>(lines_);
    Pstream::gatherList(all);
    if (!Pstream::master())
    {
        return;
    }

    label n = 0;
    for (const List<line>& lines : all) n += lines.size();

    mkDir(file.path());
    OFstream os(file);
    os.precision(12);

    os  << "# vtk DataFile Version 2.0" << nl
        << "checkContact" << nl
        << "ASCII" << nl
        << "DATASET POLYDATA" << nl
        << "POINTS " << 2*n << " double" << nl;
    for (const List<line>& lines : all)
    {
        for (const line& l : lines)
        {
            os  << l[0] << ' ' << l[1] << ' ' << l[2] << nl
                << l[3] << ' ' << l[4] << ' ' << l[5] << nl;
        }
    }
    os  << "VERTICES " << n << ' ' << 2*n << nl;
    for (label i = 0; i < n; ++i)
    {
        os  << "1 " << 2*i << nl;
    }
    os  << "LINES " << n << ' ' << 3*n << nl;
    for (label i = 0; i < n; ++i)
    {
        os  << "2 " << 2*i << ' ' << 2*i + 1 << nl;
    }
    os  << "CELL_DATA " << 2*n << nl
        << "FIELD checkContact " << names_.size() << nl;
    forAll(names_, i)
    {
        os  << names_[i] << " 1 " << 2*n << " double" << nl;
        for (label again = 0; again < 2; ++again)
        {
            for (const List<line>& lines : all)
            {
                for (const line& l : lines)
                {
                    os  << l[6 + i] << nl;
                }
            }
        }
    }
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
    Info<< "    Written: " << file << nl;
}


// ************************************************************************* //
