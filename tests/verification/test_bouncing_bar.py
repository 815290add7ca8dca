"""An elastic bar that falls on a rigid plane and bounces: the two exact
solutions of D. Doyen, A. Ern, S. Piperno, Time-integration schemes for the
finite element dynamic Signorini problem, SIAM J. Sci. Comput. 33 (2011)."""

import numpy as np

from vertexContactTests.caseTools import DEFAULT
from vertexContactTests.smallCases import Body, SmallCase

# As in the paper: c = 30 m/s; a wave travels up and down in 2/3 s
LENGTH, RHO, E, HEIGHT = 10, 1, 900, 5
C = np.sqrt(E/RHO)
BACK = 2*LENGTH/C
PLANE = {"type": "plane", "planeType": "pointAndNormal",
         "pointAndNormalDict": {"point": (0, 0, 0), "normal": (1, 0, 0)}}


def bar(folder, n, endTime, speed=0, gravity=0, **control):
    """A bar above the plane x = 0."""
    body = Body(cells=(n,), name="bar", start=(HEIGHT, 0, 0),
                size=(LENGTH, 1, 1), velocity=(-speed, 0, 0),
                material={"type": "linearElastic", "rho": RHO, "E": E,
                          "nu": 0}, sides={"left": "contact"})
    return SmallCase(
        folder, body, endTime, gravity=(-gravity, 0, 0), interfaces={
            "ground": {"side": ("bar", "left"), "obstacle": PLANE,
                       "law": {"type": "frictionless"}}},
        functions=("contactForces",), preset=DEFAULT,
        probes={"foot": ("bar", (HEIGHT, 0, 0))}, control=control).run()


def meanError(t, a, b):
    return np.trapezoid(abs(a - b), t)


def test_pressure_is_that_of_a_wave(tmp_path, figures):
    """Without gravity the pressure is v sqrt(E rho), that of a wave, while the
    wave travels up and down. Then the bar leaves with its initial speed."""
    speed = 10
    start = HEIGHT/speed
    errors, lost = [], []
    for n in 50, 100, 200, 400:
        case = bar(tmp_path/str(n), n, 2.5, speed)
        contact = case.contact("ground")
        t, pressure = contact["Time"], -contact["obstacle:Fx"]
        exact = speed*np.sqrt(E*RHO)*((t > start) & (t < start + BACK))
        errors.append(meanError(t, pressure, exact)
                      / (speed*np.sqrt(E*RHO)*BACK))
        lost.append(1 - case.totalEnergy[-1]/case.totalEnergy[0])
        v = case.momentumOf("bar")[-1, 0]/(RHO*LENGTH)
    with figures("bar against a plane, 50 to 400 elements") as f:
        f.falling("mean error of the contact force", errors)
        f.atMost("on the finest", errors[-1], 0.02)
        f.falling("energy lost", lost)
        f.atMost("on the finest", lost[-1], 0.01)
        f.within("velocity afterwards / before", v/speed, 1, 0.01)


def exactFoot(t, gravity, speed, impacts):
    """Position of the foot. Flights alternate with contacts of duration BACK.
    Every second impact leaves the bar undeformed. The others leave it with the
    stress of its own weight, whose waves travel back and forth a whole number
    of times until the next impact. They add a displacement of the foot in
    flight."""
    x = np.zeros_like(t)
    first = speed/gravity
    fall = t < first
    x[fall] = HEIGHT - 0.5*gravity*t[fall]**2
    for i in range(impacts):
        start = first + i*(BACK + 2*speed/gravity) + BACK
        s = t - start
        flies = (s >= 0) & (s < 2*speed/gravity)
        x[flies] = (speed*s - 0.5*gravity*s**2)[flies]
        if i % 2 == 0:
            # The pressure in the bar as it leaves is rho c g (BACK - 2 x/c).
            # The part that arrives at the foot gives it the velocity -g (BACK
            # - 2 u)
            u = np.mod(s, BACK)
            swing = gravity*(BACK*u - u**2)
            x[flies] -= swing[flies]
    return x


def test_ten_bounces_lose_nothing(tmp_path, figures):
    """Ten impacts under gravity. Each begins when the waves have just come
    back, so that no energy goes into vibrations. Contact dissipates 0.25 % per
    impact on 200 elements, which shortens the next flights. So positions are
    compared over the first four."""
    gravity, speed, impacts = 10, 10, 10
    T = speed/gravity + impacts*(BACK + 2*speed/gravity)
    errors, lost = [], []
    for n in 50, 100, 200:
        case = bar(tmp_path/str(n), n, T, gravity=gravity)
        t, D = case.probe("foot", "pointD")
        x = HEIGHT + D[:, 0]
        few = t < T*4/impacts
        errors.append(meanError(t[few], x[few], exactFoot(
            t[few], gravity, speed, impacts))/(HEIGHT*T*4/impacts))
        E = case.energies
        lost.append((E["total:externalWork"] - case.totalEnergy)[-1]
                    / (RHO*LENGTH*gravity*HEIGHT))
    with figures("bar that bounces ten times, 50 to 200 elements") as f:
        f.falling("mean error of the place of the foot", errors)
        f.atMost("on the finest", errors[-1], 0.02)
        f.falling("energy lost", lost)
        f.atMost("on the finest", lost[-1], 0.1)
