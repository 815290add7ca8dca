/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Sums of dictionaries, by which OpenFOAM knows whether functions of the
    controlDict have changed: with newer C++ libraries, libOpenFOAM's own ends
    the program (compat.C).

\*---------------------------------------------------------------------------*/

#include "testEnvironment.H"

#include "dictionary.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "SHA1.H"
#include "SHA1Digest.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Sums of dictionaries", "[dictionaryDigest]")
{
    const dictionary dict(IStringStream("type forces; n 3; sub { on yes; }")());

    // Of the text of the entries
    OStringStream os;
    for (const entry& e : dict) os << e;
    CHECK(dict.digest() == SHA1(os.str()).digest());

    // Another one as soon as a character is another
    const dictionary other
    (
        IStringStream("type forces; n 4; sub { on yes; }")()
    );
    CHECK(dict.digest() != other.digest());
    CHECK(dict.digest() == dictionary(dict).digest());
}


// ************************************************************************* //
