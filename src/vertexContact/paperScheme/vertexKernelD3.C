/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexKernelTemplate.C"

// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

template Foam::autoPtr<Foam::vertexKernel>
Foam::newVertexKernel<3>(vertexData&);


// ************************************************************************* //
