/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexKernelTemplate.H"

// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

namespace Foam
{

// Each dimension is compiled in a file of its own
extern template autoPtr<vertexKernel> newVertexKernel<1>(vertexData&);
extern template autoPtr<vertexKernel> newVertexKernel<2>(vertexData&);
extern template autoPtr<vertexKernel> newVertexKernel<3>(vertexData&);

}


Foam::autoPtr<Foam::vertexKernel> Foam::vertexKernel::New(vertexData& d)
{
    return withDirections(d.nDim(), [&](auto D)
    {
        return newVertexKernel<D.value>(d);
    });
}


// ************************************************************************* //
