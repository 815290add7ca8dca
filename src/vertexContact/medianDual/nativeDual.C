/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nativeDual.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Add a part c of the area vector from vertex p to vertex q of an element, and
//  the volumes below it: cones (triangles) with apexes at the two vertices
static inline void addPart
(
    const label p,
    const label q,
    const scalar* c,
    const scalar* x,
    const label nDim,
    elementDual& dual
)
{
    dual.add(p, q, c, nDim, 1);

    scalar volume = 0;
    for (label k = 0; k < nDim; ++k)
    {
        volume += c[k]*(x[q*nDim + k] - x[p*nDim + k]);
    }

    // The middle of the edge is half-way to both vertices
    volume /= 2*nDim;
    dual.volume[p] += volume;
    dual.volume[q] += volume;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::nativeDual::calculate
(
    const elementTopology& topology,
    const scalar* x,
    elementDual& dual
)
{
    const label nDim = topology.nDim;
    const label n = topology.nVertices;

    dual.reset(topology.edges);

    scalar centre[3] = {0, 0, 0};
    for (label i = 0; i < n; ++i)
    {
        for (label k = 0; k < nDim; ++k) centre[k] += x[i*nDim + k]/n;
    }

    if (nDim == 1)
    {
        const scalar c = 1;
        addPart(0, 1, &c, x, nDim, dual);
    }
    else if (nDim == 2)
    {
        for (label p = 0; p < n; ++p)
        {
            const label q = (p + 1) % n;

            // From the middle of the edge to the centre, turned clockwise
            const scalar c[2] =
            {
                centre[1] - 0.5*(x[2*p + 1] + x[2*q + 1]),
                0.5*(x[2*p] + x[2*q]) - centre[0]
            };

            addPart(p, q, c, x, nDim, dual);
        }
    }
    else
    {
        for (const elementTopology::vertices& f : topology.faces)
        {
            const label size = elementTopology::faceSize(f);

            scalar faceCentre[3] = {0, 0, 0};
            for (label i = 0; i < size; ++i)
            {
                for (label k = 0; k < 3; ++k)
                {
                    faceCentre[k] += x[3*f[i] + k]/size;
                }
            }

            for (label i = 0; i < size; ++i)
            {
                const label p = f[i];
                const label q = f[(i + 1) % size];

                // The triangle of middle, face centre and centre. The face is
                // outward, so the element is to the left of its edge
                scalar toFace[3];
                scalar toCentre[3];
                for (label k = 0; k < 3; ++k)
                {
                    const scalar middle = 0.5*(x[3*p + k] + x[3*q + k]);

                    toFace[k] = faceCentre[k] - middle;
                    toCentre[k] = centre[k] - middle;
                }

                scalar c[3];
                elementDual::halfCross(toCentre, toFace, c);

                addPart(p, q, c, x, 3, dual);
            }
        }
    }
}


void Foam::nativeDual::cornerArea
(
    const label n,
    const label corner,
    const scalar* x,
    scalar* area
)
{
    const scalar* p = x + 3*corner;
    const scalar* next = x + 3*((corner + 1) % n);
    const scalar* previous = x + 3*((corner + n - 1) % n);

    // A quadrilateral: half the product of its diagonals
    scalar toCentre[3];
    scalar across[3];

    for (label k = 0; k < 3; ++k)
    {
        toCentre[k] = -p[k];
        for (label i = 0; i < n; ++i) toCentre[k] += x[3*i + k]/n;

        across[k] = 0.5*(previous[k] - next[k]);
    }

    elementDual::halfCross(toCentre, across, area);
}


// ************************************************************************* //
