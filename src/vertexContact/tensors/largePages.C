/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "largePages.H"
#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::takeLargePages(void* begin, const std::size_t bytes)
{
#if defined(MADV_HUGEPAGE)
    // Size on most processors
    constexpr std::size_t large = 1 << 21;
    if (bytes < large) return;

    const std::uintptr_t page = ::sysconf(_SC_PAGESIZE);
    const std::uintptr_t at = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t first = (at + page - 1)/page*page;

    // Only advice: if it is refused, nothing but the time changes
    void* advised = reinterpret_cast<void*>(first);
    ::madvise(advised, at + bytes - first, MADV_HUGEPAGE);
#endif
}


// ************************************************************************* //
