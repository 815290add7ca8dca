/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepLimit.H"
#include "lanczos.H"
#include "edgeRows.H"
#include "solidTensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- M^-1/2 (f C + g K) M^-1/2, with C and K of variationalKernel.H. Vectors are
//  rows of four, tensors are D such rows, column by column
template<int D>
class stepOperator
{
    typedef std::ptrdiff_t index;
    typedef row<4> vec;

    static constexpr int sT = 4*D;

    // Private data

        const vertexData& d_;
        const variationalData& x_;
        const symmetryConstraint& symmetry_;
        const label* edge_;
        const label n_;
        scalar ofC_ = 0;
        scalar ofK_ = 0;
        labelList place_;

        //- Edges: area vector and its magnitude; reach and one over its
        //  length
        alignedScalars area_;
        alignedScalars reach_;

        //- Displacements; their gradients G; additional stress on G; and the
        //  stress that gives the forces
        alignedScalars w_;
        alignedScalars grad_;
        alignedScalars more_;
        alignedScalars stress_;


    // Private Member Functions

        static vec& column(alignedScalars& T, const index a, const int j)
        {
            return rowAt<4>(T.data() + a*sT + 4*j);
        }

        static scalar dot(const vec& u, const vec& v)
        {
            const vec p = u*v;
            return p[0] + p[1] + p[2] + p[3];
        }

        static void zero(alignedScalars& f)
        {
            std::fill(f.data(), f.data() + f.size(), scalar(0));
        }

        //- Call f(node, node, area, reach) for each edge, with 4th components
        template<class Function>
        void forEdges(const Function& f)
        {
            for (index e = 0; e < d_.dual.nEdges(); ++e)
            {
                f
                (
                    index(edge_[2*e]), index(edge_[2*e + 1]),
                    rowAt<4>(area_.data() + 4*e), rowAt<4>(reach_.data() + 4*e)
                );
            }
        }

        //- Call f(node, node, weight) for each pair of boundary nodes
        template<class Function>
        void forPairs(const Function& f)
        {
            for (index p = 0; p < x_.pairNodes.size()/2; ++p)
            {
                vec B{};
                for (int j = 0; j < D; ++j) B[j] = x_.pairArea[p*D + j];
                f
                (
                    index(x_.pairNodes[2*p]), index(x_.pairNodes[2*p + 1]), B
                );
            }
        }

        //- Complete sums over edges: per volume, at shared nodes and in
        //  mirrors
        void complete(alignedScalars& T)
        {
            for (index a = 0; a < n_; ++a)
            {
                for (int j = 0; j < D; ++j) column(T, a, j) *= x_.perV[a];
            }
            d_.dual.sharing().sum(T.data(), sT);
            if (symmetry_.active())
            {
                symmetry_.symmetrise(T.data(), sT, place_, 2);
            }
        }

        void gradients()
        {
            zero(grad_);
            forEdges([&]
            (
                const index a, const index b, const vec& C, const vec&
            )
            {
                const vec change =
                    0.5
                   *(rowAt<4>(w_.data() + 4*b) - rowAt<4>(w_.data() + 4*a));
                for (int j = 0; j < D; ++j)
                {
                    column(grad_, a, j) += C[j]*change;
                    column(grad_, b, j) += C[j]*change;
                }
            });
            forPairs([&](const index a, const index b, const vec& B)
            {
                const vec change =
                    rowAt<4>(w_.data() + 4*b) - rowAt<4>(w_.data() + 4*a);
                for (int j = 0; j < D; ++j)
                {
                    column(grad_, a, j) += B[j]*change;
                    column(grad_, b, j) -= B[j]*change;
                }
            });
            complete(grad_);
        }

        //- The stress of D w, times g
        void stresses()
        {
            if (x_.beta > 0)
            {
                zero(more_);
                forEdges([&]
                (
                    const index a, const index b, const vec& C, const vec& r
                )
                {
                    vec f{};
                    for (int j = 0; j < D; ++j)
                    {
                        f +=
                            (0.5*x_.beta*r[j])
                           *(column(grad_, a, j) - column(grad_, b, j));
                    }
                    for (int j = 0; j < D; ++j)
                    {
                        column(more_, a, j) += C[j]*f;
                        column(more_, b, j) -= C[j]*f;
                    }
                });
                complete(more_);
            }
            const scalar mu = ofK_*sqr(d_.cs);
            const scalar lambda = ofK_*sqr(d_.cp) - 2*mu;
            for (index a = 0; a < n_; ++a)
            {
                vec g[D];
                scalar trace = 0;
                for (int j = 0; j < D; ++j)
                {
                    g[j] = column(grad_, a, j);
                    if (x_.beta > 0) g[j] += column(more_, a, j);
                    trace += g[j][j];
                }
                for (int j = 0; j < D; ++j)
                {
                    vec P = mu*g[j];
                    for (int i = 0; i < D; ++i) P[i] += mu*g[i][j];
                    P[j] += lambda*trace;
                    column(stress_, a, j) = P;
                }
            }
        }


public:

    static constexpr label nComponents = 4;

    stepOperator
    (
        const vertexData& d,
        const variationalData& x,
        const symmetryConstraint& symmetry
    )
    :
        d_(d),
        x_(x),
        symmetry_(symmetry),
        edge_(d.dual.edgeNodes().cdata()),
        n_(d.nNodes()),
        place_(D*D),
        area_(4*d.dual.nEdges()),
        reach_(4*d.dual.nEdges()),
        w_(4*n_),
        grad_(sT*n_),
        more_(sT*n_),
        stress_(sT*n_)
    {
        for (int i = 0; i < D; ++i)
        {
            for (int j = 0; j < D; ++j) place_[i*D + j] = 4*j + i;
        }
        const scalar* X = d.dual.nodePosition().cdata();
        for (index e = 0; e < d.dual.nEdges(); ++e)
        {
            for (int j = 0; j < D; ++j)
            {
                area_[4*e + j] = d.edgeArea()[e*D + j];
                reach_[4*e + j] = X[edge_[2*e + 1]*D + j] - X[edge_[2*e]*D + j];
            }
            const vec C = rowAt<4>(area_.data() + 4*e);
            const vec way = rowAt<4>(reach_.data() + 4*e);
            area_[4*e + 3] = std::sqrt(dot(C, C) + VSMALL);
            reach_[4*e + 3] = 1/std::sqrt(dot(way, way));
        }
    }

    //- Set f and g
    void set(const scalar ofC, const scalar ofK)
    {
        ofC_ = ofC;
        ofK_ = ofK;
    }

    //- Remove components beyond D, and motion through mirrors
    void constrain(scalarField& u) const
    {
        for (index a = 0; a < n_; ++a)
        {
            for (int i = D; i < 4; ++i) u[4*a + i] = 0;
        }
        if (symmetry_.active()) symmetry_.project(u.data(), 4);
    }

    void apply(const scalarField& u, scalarField& y)
    {
        for (index a = 0; a < n_; ++a)
        {
            rowAt<4>(w_.data() + 4*a) =
                std::sqrt(x_.perV[a])*rowAt<4>(u.cdata() + 4*a);
        }
        gradients();
        stresses();

        // Jumps of positions and velocities: their forces, and their action on
        // G, from which they were reconstructed; with that of the corrections
        y = Zero;
        zero(more_);
        const scalar wave = 0.5*ofC_*x_.frontEpsilon;
        const scalar jumpModulus = ofK_*x_.jumpModulus/d_.rho;
        forEdges([&]
        (
            const index a, const index b, const vec& C, const vec& r
        )
        {
            vec change{}, difference{};
            for (int j = 0; j < D; ++j)
            {
                const vec ga = column(grad_, a, j), gb = column(grad_, b, j);
                change += (0.5*r[j])*(ga + gb);
                difference +=
                    (0.5*x_.beta*C[j])
                   *(column(stress_, a, j) - column(stress_, b, j));
            }
            const vec jump =
                rowAt<4>(w_.data() + 4*b) - rowAt<4>(w_.data() + 4*a) - change;

            // Jumps of velocities keep the stretching
            const vec c = threeOf(C), way = threeOf(r);
            const scalar magC = C[3], perLength2 = sqr(r[3]);
            const vec left = jump + (dot(change, way)*perLength2)*way;
            const vec s =
                (wave*d_.cs*magC)*left
              + (wave*(d_.cp - d_.cs)*dot(left, c)/magC)*c;
            // As edgeStiffness()
            const vec elastic = (jumpModulus*magC*r[3])*jump;
            rowAt<4>(y.data() + 4*a) -= s + elastic;
            rowAt<4>(y.data() + 4*b) += s + elastic;

            const vec both =
                -0.5*(s - (dot(s, way)*perLength2)*way + elastic);
            for (int j = 0; j < D; ++j)
            {
                vec& Ta = column(more_, a, j);
                vec& Tb = column(more_, b, j);
                Ta += r[j]*(both + difference);
                Tb += r[j]*(both - difference);
            }
        });
        complete(more_);
        for (index k = 0; k < sT*n_; k += 4)
        {
            rowAt<4>(stress_.data() + k) += rowAt<4>(more_.data() + k);
        }

        // The adjoint of G gives the forces
        forEdges([&]
        (
            const index a, const index b, const vec& C, const vec&
        )
        {
            vec f{};
            for (int j = 0; j < D; ++j)
            {
                f +=
                    (0.5*C[j])
                   *(column(stress_, a, j) + column(stress_, b, j));
            }
            rowAt<4>(y.data() + 4*a) -= f;
            rowAt<4>(y.data() + 4*b) += f;
        });
        forPairs([&](const index a, const index b, const vec& B)
        {
            vec f{};
            for (int j = 0; j < D; ++j)
            {
                f += B[j]*(column(stress_, a, j) - column(stress_, b, j));
            }
            rowAt<4>(y.data() + 4*a) -= f;
            rowAt<4>(y.data() + 4*b) += f;
        });
        d_.dual.sharing().sum(y.data(), 4);
        constrain(y);
        for (index a = 0; a < n_; ++a)
        {
            rowAt<4>(y.data() + 4*a) *= std::sqrt(x_.perV[a]);
        }
    }

    //- Scalar product over all nodes
    scalar product(const scalarField& u, const scalarField& v) const
    {
        scalar sum = 0;
        for (index a = 0; a < n_; ++a)
        {
            if (d_.dual.sharing().owned()[a])
            {
                sum += dot
                (
                    rowAt<4>(u.cdata() + 4*a), rowAt<4>(v.cdata() + 4*a)
                );
            }
        }
        return returnReduce(sum, sumOp<scalar>());
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepLimit::stepLimit
(
    const vertexData& d,
    const variationalData& x,
    const symmetryConstraint& symmetry
)
{
    withDirections(d.nDim(), [&](auto D)
    {
        stepOperator<D.value> L(d, x, symmetry);
        const auto largest = [&](const scalar f, const scalar g, const label n)
        {
            L.set(f, g);
            return lanczos::largestOf(L, d, n);
        };
        squaredFrequency_ = largest(0, 1, lanczos::steps);

        // The largest eigenvalue over tau is convex in tau, and grows no faster
        // than K's share. So a stable step gives a longer one that is stable,
        // and an unstable step gives a shorter one
        const scalar slope = 0.25*squaredFrequency_;
        const auto next = [&](const scalar tau, const label n)
        {
            const scalar perTau = largest(0.5, 0.25*tau, n);
            if (perTau*tau >= 1) return 1/perTau;
            const scalar b = 0.5*(perTau - slope*tau);
            return 1/(b + std::sqrt(sqr(b) + slope));
        };

        // The first result is only the start of the second, longer iteration
        step_ = next
        (
            next(0.5/std::sqrt(slope), lanczos::steps/2), lanczos::steps
        );
    });
}


// ************************************************************************* //
