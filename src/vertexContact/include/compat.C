/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What older OpenFOAM releases lack, see compat.H

\*---------------------------------------------------------------------------*/

#include "compat.H"

#ifdef vertexContactOwnDigest

#include "OStringStream.H"
#include "SHA1.H"
#include "SHA1Digest.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

// With libstdc++ of GCC 14 (Debian 13, Ubuntu 24.04) the stream for hashes in
// libOpenFOAM refuses single characters: each case with functions ends with an
// error in IOstream "sha1". Repaired in v2112. This version hashes the same
// text. Programs that link this library find it first.
Foam::SHA1Digest Foam::dictionary::digest() const
{
    OStringStream os;
    for (const entry& e : *this)
    {
        os << e;
    }

    return SHA1(os.str()).digest();
}

#endif


// ************************************************************************* //
