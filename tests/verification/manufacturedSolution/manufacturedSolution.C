/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
Class
    Foam::bodyForces::manufacturedSolution

Description
    The body force under which a neo-Hookean unit block follows, exactly, the
    large deformation

    \f[
        x_i = X_i + A_i \cos(\omega t) \sin(\pi X_i)
              \prod_{j \neq i} \cos(\pi X_j/2)
    \f]

    in one, two or three directions: b = a - DIV P(F)/rho. Sides X_i = 0 are
    planes of symmetry, sides X_i = 1 do not move.

    It is also an example of a body force in a library of its own: a class
    derived from bodyForce, which adds to the accelerations of all nodes in one
    call; a Make/files and a Make/options; 'wmake libso', and the library's
    name in the controlDict.

Usage
    In system/controlDict:
    \verbatim
        libs (vertexContact manufacturedSolution);
    \endverbatim
    In constant/\<region\>/bodyForces:
    \verbatim
        force
        {
            type      manufacturedSolution;
            amplitude (0.1 -0.08 0.06);     // A [m]
            omega     2;                    // [rad/s]
        }
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "bodyForce.H"
#include "dictionaryCheck.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace bodyForces
{

class manufacturedSolution
:
    public bodyForce
{
    // Private data

        const scalar rho_;
        const scalar mu_;
        const scalar kappa_;
        const vector amplitude_;
        const scalar omega_;


    // Private Member Functions

        static const dictionary& checked
        (
            const dictionary& dict,
            const materialModel& material
        )
        {
            dictionaryCheck::onlyKeywords(dict, keywords());
            if (material.type() != "neoHookean")
            {
                FatalIOErrorInFunction(dict)
                    << "Keyword 'type': manufacturedSolution is one of "
                    << "neoHookean, not of " << material.type()
                    << exit(FatalIOError);
            }
            return dict;
        }

        //- Derivative of P = s F + q H (10) along that of F
        template<int D>
        SolidTensor<D> stressChange
        (
            const SolidTensor<D>& F,
            const SolidTensor<D>& dF
        ) const
        {
            const SolidTensor<D> H = cofactor(F), dH = cross(F, dF);
            const scalar J = determinant(F, H), dJ = ddot(H, dF);
            const scalar FF = ddot(F, F), dFF = 2*ddot(F, dF);

            const scalar s = mu_/sqr(std::cbrt(J)), ds = -2*s*dJ/(3*J);
            const scalar q = kappa_*(J - 1) - s*FF/(3*J);
            const scalar dq =
                kappa_*dJ - (ds*FF + s*dFF - s*FF*dJ/J)/(3*J);

            return combine(1, combine(ds, F, s, dF), 1, combine(dq, H, q, dH));
        }

        template<int D>
        void addOfDim(const scalar time, scalarField& acceleration) const
        {
            const scalar pi = constant::mathematical::pi;
            const FixedList<label, 3>& dir = dual().directions();
            const vector amplitude(std::cos(omega_*time)*amplitude_);

            for (label a = 0; a < dual().nNodes(); ++a)
            {
                const scalar* X = dual().nodePosition().cdata() + a*D;

                // Factors sin(pi X) and cos(pi X/2) of each direction, with
                // their first and second derivatives
                scalar own[D][3], other[D][3];
                for (int m = 0; m < D; ++m)
                {
                    const scalar s = std::sin(0.5*pi*X[m]);
                    const scalar c = std::cos(0.5*pi*X[m]);
                    own[m][0] = 2*s*c;
                    own[m][1] = pi*(c*c - s*s);
                    own[m][2] = -sqr(pi)*own[m][0];
                    other[m][0] = c;
                    other[m][1] = -0.5*pi*s;
                    other[m][2] = -0.25*sqr(pi)*c;
                }

                // Displacement i, derived once for each of j and k below D
                const auto derivative = [&](const int i, int j, int k)
                {
                    scalar u = amplitude[dir[i]];
                    for (int m = 0; m < D; ++m)
                    {
                        const int order = (m == j) + (m == k);
                        u *= m == i ? own[m][order] : other[m][order];
                    }
                    return u;
                };

                SolidTensor<D> F = SolidTensor<D>::identity();
                for (int i = 0; i < D; ++i)
                {
                    for (int j = 0; j < D; ++j) F(i, j) += derivative(i, j, D);
                }

                for (int i = 0; i < D; ++i)
                {
                    acceleration[a*D + i] -=
                        sqr(omega_)*derivative(i, D, D);
                }
                for (int k = 0; k < D; ++k)
                {
                    SolidTensor<D> dF;
                    dF.out = 0;
                    for (int i = 0; i < D; ++i)
                    {
                        for (int j = 0; j < D; ++j)
                        {
                            dF(i, j) = derivative(i, j, k);
                        }
                    }
                    const SolidTensor<D> dP = stressChange(F, dF);
                    for (int i = 0; i < D; ++i)
                    {
                        acceleration[a*D + i] -= dP(i, k)/rho_;
                    }
                }
            }
        }


public:

    TypeName("manufacturedSolution");

    //- For the check and for vertexContactFoam -listBodyForces
    static keywordList keywords()
    {
        return
        {
            {"type", "", "required", "manufacturedSolution"},
            {"amplitude", "m", "required", "vector A"},
            {"omega", "rad/s", "required", "angular frequency"}
        };
    }

    manufacturedSolution
    (
        const dictionary& dict,
        const medianDual& dual,
        const materialModel& material
    )
    :
        bodyForce(checked(dict, material), dual),
        rho_(material.rho()),
        mu_(material.mu()),
        kappa_(material.kappa()),
        amplitude_(dict.get<vector>("amplitude")),
        omega_(dict.get<scalar>("omega"))
    {}

    virtual void add(const scalar time, scalarField& acceleration) const
    {
        switch (dual().nDim())
        {
            case 1: addOfDim<1>(time, acceleration); break;
            case 2: addOfDim<2>(time, acceleration); break;
            default: addOfDim<3>(time, acceleration); break;
        }
    }
};


defineTypeNameAndDebug(manufacturedSolution, 0);
addListedModel(bodyForce, manufacturedSolution);

} // End namespace bodyForces
} // End namespace Foam


// ************************************************************************* //
