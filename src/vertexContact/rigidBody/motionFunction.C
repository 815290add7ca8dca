/*---------------------------------------------------------------------------*\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "motionFunction.H"
#include "functionIntegral.H"
#include "dictionaryCheck.H"
#include "compat.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "HashTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const word nameKey("solidBodyMotionFunction");
const word rotating("rotatingMotion");
const word turningAxis("axisRotationMotion");
const word several("multiMotion");
const word driven("drivenLinearMotion");

//- Keywords that OpenFOAM's functions read
wordList coefficientsOf(const word& type)
{
    static const HashTable<wordList> all
    ({
        {"linearMotion", {"velocity"}},
        {rotating, {"origin", "axis", "omega", "omegaCoeffs"}},
        {turningAxis, {"origin", "radialVelocity"}},
        {
            "oscillatingLinearMotion",
            compat::oscillatingLinearMotionKeywords()
        },
        {"oscillatingRotatingMotion", {"origin", "amplitude", "omega"}},
        {"tabulated6DoFMotion", {"timeDataFileName", "CofG"}},
        {
            "SDA",
            {
                "CofG", "lamda", "rollAmax", "rollAmin", "heaveA", "swayA",
                "Q", "Tp", "Tpn", "dTi", "dTp"
            }
        }
    });
    const auto found = all.cfind(type);
    return found.found() ? *found : wordList();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::motionFunction::checkKeywords(const dictionary& coeffs) const
{
    const bool beside = &coeffs == &dict_;
    const wordList read(coefficientsOf(type_));
    if (!beside)
    {
        dictionaryCheck::onlyKeywords
        (
            dict_, wordList({nameKey, type_ + "Coeffs"})
        );
    }
    if (read.empty()) return;

    DynamicList<word> valid(read);
    if (beside)
    {
        valid.append(nameKey);
        valid.append(type_ + "Coeffs");
    }
    dictionaryCheck::onlyKeywords(coeffs, valid);
}


void Foam::motionFunction::readRotation(const dictionary& coeffs)
{
    origin_ = coeffs.get<point>("origin");
    axis_ = coeffs.get<vector>("axis");
    if (!(mag(axis_) > 0))
    {
        FatalIOErrorInFunction(coeffs)
            << "Keyword 'axis' is " << axis_ << ": it must not be zero"
            << exit(FatalIOError);
    }
    omega_ = dictionaryCheck::readFunction<scalar>("omega", coeffs);
    functionIntegral::check(coeffs, "omega", *omega_, "a function");
}


void Foam::motionFunction::readParts
(
    const dictionary& coeffs,
    const Time& time
)
{
    for (const entry& e : coeffs)
    {
        if (&coeffs == &dict_ && e.keyword() == nameKey) continue;
        if (!e.isDict())
        {
            FatalIOErrorInFunction(coeffs)
                << "Keyword '" << e.keyword() << "' of " << several
                << " is not a dictionary. Each entry must be a dictionary with "
                << "its own '" << nameKey << "'" << exit(FatalIOError);
        }
        parts_.append(new motionFunction(e.dict(), time));
    }
    if (parts_.empty())
    {
        FatalIOErrorInFunction(coeffs)
            << "Keyword '" << nameKey << "' is " << several
            << ", but it has no motion. Give dictionaries, each with its own "
            << "'" << nameKey << "'" << exit(FatalIOError);
    }
}


void Foam::motionFunction::readOther(const Time& time)
{
    clock_.reset
    (
        new Time
        (
            dictionary
            (
                IStringStream
                (
                    "startFrom startTime; startTime 0; endTime 1;"
                    "deltaT 1; writeControl timeStep; writeInterval 1;"
                )()
            ),
            time.rootPath(), time.caseName(),
            "system", "constant", false, false
        )
    );
    withPlace
    (
        "", [&]() { function_ = solidBodyMotionFunction::New(dict_, *clock_); }
    );
}


void Foam::motionFunction::withPlace
(
    const string& where,
    const std::function<void()>& f
) const
{
    dictionaryCheck::withPlace
    (
        dict_, "Keyword '" + nameKey + "' is " + type_ + where, f
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::motionFunction::motionFunction
(
    const dictionary& dict,
    const Time& time
)
:
    dict_(dict),
    type_(dict.get<word>(nameKey)),
    turnsFromZero_(type_ == turningAxis),
    origin_(Zero),
    axis_(Zero)
{
    if (type_ == driven)
    {
        FatalIOErrorInFunction(dict_)
            << "Keyword '" << nameKey << "' is " << type_ << ", which moves "
            << "by its velocity at each call. So it has no position at a given "
            << "time. Use linearMotion" << exit(FatalIOError);
    }

    // Found as OpenFOAM does
    const dictionary& coeffs = dict_.optionalSubDict(type_ + "Coeffs");
    checkKeywords(coeffs);
    if (type_ == rotating) readRotation(coeffs);
    else if (type_ == several) readParts(coeffs, time);
    else readOther(time);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::septernion Foam::motionFunction::poseAt(const scalar time)
{
    if (omega_.valid())
    {
        const scalar angle = functionIntegral::to(*omega_, time);
        return
            septernion(-origin_)*quaternion(axis_, angle)
           *septernion(origin_);
    }
    if (parts_.size())
    {
        septernion pose(parts_[0].poseAt(time));
        for (label i = 1; i < parts_.size(); ++i)
        {
            pose *= parts_[i].poseAt(time);
        }
        return pose;
    }
    if (turnsFromZero_ && time == 0) return septernion::I;
    clock_->setTime(time, 0);
    return function_->transformation();
}


void Foam::motionFunction::checkPose(const scalar time)
{
    for (motionFunction& part : parts_) part.checkPose(time);
    if (parts_.size()) return;

    OStringStream os;
    os  << ", which gives no position at time " << time << " s";
    withPlace(os.str(), [&]() { poseAt(time); });
}


// ************************************************************************* //
