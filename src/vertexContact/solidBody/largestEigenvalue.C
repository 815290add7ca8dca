/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "largestEigenvalue.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

class scalarLaplacian
{
    const vertexData& d_;
    const variationalData& x_;
    const symmetryConstraint& symmetry_;
    const label nDim_;
    const labelList& edge_;
    const scalar* area_;
    const scalarField& X_;
    const scalarField& V_;
    labelList place_;
    scalarField grad_;
    scalarField more_;
    scalarField plain_;
    const scalar perModulus_;

    void complete(scalarField& g) const
    {
        d_.dual.sharing().sum(g.data(), nDim_);
        if (symmetry_.active())
        {
            symmetry_.symmetrise(g.data(), nDim_, place_, 1);
        }
    }

    scalar r(const label e, const label j) const
    {
        return X_[edge_[2*e + 1]*nDim_ + j] - X_[edge_[2*e]*nDim_ + j];
    }

    scalar along(const label e, const scalarField& g) const
    {
        // (G_a - G_b).r
        const label a = edge_[2*e], b = edge_[2*e + 1];
        scalar sum = 0;
        for (label j = 0; j < nDim_; ++j)
        {
            sum += (g[a*nDim_ + j] - g[b*nDim_ + j])*r(e, j);
        }
        return sum;
    }


public:

    scalarLaplacian
    (
        const vertexData& d,
        const variationalData& x,
        const symmetryConstraint& symmetry
    )
    :
        d_(d),
        x_(x),
        symmetry_(symmetry),
        nDim_(d.nDim()),
        edge_(d.dual.edgeNodes()),
        area_(d.edgeArea()),
        X_(d.dual.nodePosition()),
        V_(d.dual.nodeVolume()),
        place_(identity(nDim_)),
        grad_(d.nNodes()*nDim_),
        more_(d.nNodes()*nDim_),
        plain_(d.nNodes()*nDim_),
        perModulus_(1/(d.rho*sqr(d.cp)))
    {}

    //- y = V^-1/2 L V^-1/2 u, of which the sum of squares is the plain one
    void apply(const scalarField& u, scalarField& y)
    {
        const label n = d_.nNodes();
        const label nEdges = d_.dual.nEdges();
        const label nPairs = x_.pairNodes.size()/2;
        scalarField w(n);
        for (label a = 0; a < n; ++a) w[a] = u[a]/std::sqrt(V_[a]);

        grad_ = Zero;
        const auto addPair = [&]
        (
            scalarField& g, const label p, const scalar change
        )
        {
            for (label j = 0; j < nDim_; ++j)
            {
                const scalar f = change*x_.pairArea[p*nDim_ + j];
                g[x_.pairNodes[2*p]*nDim_ + j] += f;
                g[x_.pairNodes[2*p + 1]*nDim_ + j] -= f;
            }
        };
        for (label e = 0; e < nEdges; ++e)
        {
            const label a = edge_[2*e], b = edge_[2*e + 1];
            for (label j = 0; j < nDim_; ++j)
            {
                const scalar f = 0.5*(w[b] - w[a])*area_[e*nDim_ + j];
                grad_[a*nDim_ + j] += f;
                grad_[b*nDim_ + j] += f;
            }
        }
        for (label p = 0; p < nPairs; ++p)
        {
            addPair
            (
                grad_, p, w[x_.pairNodes[2*p + 1]] - w[x_.pairNodes[2*p]]
            );
        }
        for (label k = 0; k < n*nDim_; ++k) grad_[k] /= V_[k/nDim_];
        complete(grad_);

        plain_ = grad_;

        // D, in the place of G; and as in the forces T = P + X/V
        if (x_.beta > 0)
        {
            more_ = Zero;
            for (label e = 0; e < nEdges; ++e)
            {
                const scalar f = 0.5*x_.beta*along(e, grad_);
                for (label j = 0; j < nDim_; ++j)
                {
                    more_[edge_[2*e]*nDim_ + j] += f*area_[e*nDim_ + j];
                    more_[edge_[2*e + 1]*nDim_ + j] -= f*area_[e*nDim_ + j];
                }
            }
            for (label k = 0; k < n*nDim_; ++k) more_[k] /= V_[k/nDim_];
            complete(more_);
            grad_ += more_;

            more_ = Zero;
            for (label e = 0; e < nEdges; ++e)
            {
                const label a = edge_[2*e], b = edge_[2*e + 1];
                scalar f = 0;
                for (label j = 0; j < nDim_; ++j)
                {
                    f +=
                        0.5*x_.beta*area_[e*nDim_ + j]
                       *(grad_[a*nDim_ + j] - grad_[b*nDim_ + j]);
                }
                for (label j = 0; j < nDim_; ++j)
                {
                    more_[a*nDim_ + j] += f*r(e, j);
                    more_[b*nDim_ + j] -= f*r(e, j);
                }
            }
            for (label k = 0; k < n*nDim_; ++k) more_[k] /= V_[k/nDim_];
            complete(more_);
            grad_ += more_;
        }

        // Jumps of the positions, and their adjoint
        y = Zero;
        more_ = Zero;
        for (label e = 0; e < nEdges; ++e)
        {
            const label a = edge_[2*e], b = edge_[2*e + 1];
            scalar jump = w[b] - w[a];
            for (label j = 0; j < nDim_; ++j)
            {
                jump -=
                    0.5*(plain_[a*nDim_ + j] + plain_[b*nDim_ + j])*r(e, j);
            }
            const scalar s = perModulus_*x_.jumpStiffness[e]*jump;
            y[a] -= s;
            y[b] += s;
            for (label j = 0; j < nDim_; ++j)
            {
                more_[a*nDim_ + j] -= 0.5*s*r(e, j);
                more_[b*nDim_ + j] -= 0.5*s*r(e, j);
            }
        }
        for (label k = 0; k < n*nDim_; ++k) more_[k] /= V_[k/nDim_];
        complete(more_);
        grad_ += more_;

        for (label e = 0; e < nEdges; ++e)
        {
            const label a = edge_[2*e], b = edge_[2*e + 1];
            scalar f = 0;
            for (label j = 0; j < nDim_; ++j)
            {
                f +=
                    0.5*area_[e*nDim_ + j]
                   *(grad_[a*nDim_ + j] + grad_[b*nDim_ + j]);
            }
            y[a] -= f;
            y[b] += f;
        }
        for (label p = 0; p < nPairs; ++p)
        {
            const label a = x_.pairNodes[2*p], b = x_.pairNodes[2*p + 1];
            scalar f = 0;
            for (label j = 0; j < nDim_; ++j)
            {
                f +=
                    x_.pairArea[p*nDim_ + j]
                   *(grad_[a*nDim_ + j] - grad_[b*nDim_ + j]);
            }
            y[a] -= f;
            y[b] += f;
        }
        d_.dual.sharing().sum(y.data(), 1);
        for (label a = 0; a < n; ++a) y[a] /= std::sqrt(V_[a]);
    }

    //- Sum of products over all nodes
    scalar product(const scalarField& u, const scalarField& v) const
    {
        scalar sum = 0;
        forAll(u, a)
        {
            if (d_.dual.sharing().owned()[a]) sum += u[a]*v[a];
        }
        return returnReduce(sum, sumOp<scalar>());
    }
};

//- Largest eigenvalue of a symmetric tridiagonal matrix, by bisection: above
//  it all pivots of T - l are negative
scalar largestOfTridiagonal(const scalarList& diagonal, const scalarList& side)
{
    scalar low = 0, high = 0;
    forAll(diagonal, i)
    {
        low = max(low, diagonal[i]);
        high = max
        (
            high,
            diagonal[i] + (i ? side[i - 1] : 0)
          + (i + 1 < diagonal.size() ? side[i] : 0)
        );
    }
    for (label k = 0; k < 60; ++k)
    {
        const scalar l = 0.5*(low + high);
        scalar pivot = 1;
        bool above = true;
        forAll(diagonal, i)
        {
            pivot = diagonal[i] - l - (i ? sqr(side[i - 1])/pivot : 0);
            above = above && pivot < 0;
        }
        (above ? high : low) = l;
    }
    return high;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::largestEigenvalue
(
    const vertexData& d,
    const variationalData& x,
    const symmetryConstraint& symmetry
)
{
    // A fixed number: the end by a tolerance would depend on round-off
    constexpr label steps = 60;

    scalarLaplacian L(d, x, symmetry);
    const label n = d.nNodes(), nDim = d.nDim();

    // A start without symmetry, the same on all ranks that share a node
    scalarField u(n), last(n, Zero), y(n);
    forAll(u, a)
    {
        scalar phase = 0;
        for (label j = 0; j < nDim; ++j)
        {
            phase +=
                (j + 1)*17.3*d.dual.nodePosition()[a*nDim + j]
               /std::pow(d.dual.nodeVolume()[a], 1.0/nDim);
        }
        u[a] = std::sqrt(d.dual.nodeVolume()[a])*(0.3 + std::sin(phase));
    }
    u /= std::sqrt(L.product(u, u));

    scalarList diagonal, side;
    scalar latest = 0;
    for (label k = 0; k < steps; ++k)
    {
        L.apply(u, y);
        diagonal.append(L.product(u, y));
        latest = largestOfTridiagonal(diagonal, side);

        forAll(y, a)
        {
            y[a] -= diagonal.last()*u[a] + (k ? side.last()*last[a] : 0);
        }
        const scalar norm = std::sqrt(L.product(y, y));
        if (norm <= 1e-12*latest) break;
        side.append(norm);
        last = u;
        forAll(u, a) u[a] = y[a]/norm;
    }
    return latest;
}


// ************************************************************************* //
