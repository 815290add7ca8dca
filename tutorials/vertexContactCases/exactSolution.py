"""Exact solution of the impact of two linear elastic bars, by characteristics.

In each bar the Riemann invariants

    r = v - sigma/z   is carried to the right (+X) with speed  c
    l = v + sigma/z   is carried to the left  (-X) with speed -c

with impedance z = rho c and c = sqrt(E/rho), so the solution everywhere
follows from what the two ends of each bar emit. An emitted invariant only
changes when an incoming one does, or when the bars meet or part: these events
are followed one by one, in order of time. There are

    free end       sigma = 0
    bars touching  equal v and sigma of both bars, as long as sigma < 0

and contact starts when the gap has closed. Everything is piecewise constant
(v, sigma) or piecewise linear (u) in time, and exact up to round-off.

As a program, prints the events and the states at the two meeting ends:

    python3 -m vertexContactCases.exactSolution [CASE] [END_TIME]
"""

import sys
from bisect import bisect_right
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True)
class Bar:
    """A stress-free bar from X = start to start + length, with this
    velocity."""

    start: float
    length: float
    E: float
    rho: float
    velocity: float

    @property
    def end(self):
        return self.start + self.length

    @property
    def c(self):
        return (self.E/self.rho)**0.5

    @property
    def z(self):
        return self.rho*self.c


class Steps:
    """A piecewise constant function of time, known from -infinity on."""

    def __init__(self, value):
        self.times = [-np.inf]
        self.values = [value]

    def append(self, time, value):
        if value != self.values[-1]:
            self.times.append(time)
            self.values.append(value)

    def last(self, time):
        """Value just after the given time (scalar)."""
        return self.values[bisect_right(self.times, time) - 1]

    def next(self, time):
        """First change after the given time, or infinity."""
        i = bisect_right(self.times, time)
        return self.times[i] if i < len(self.times) else np.inf

    def __call__(self, time):
        i = np.searchsorted(self.times, time, side="right") - 1
        return np.asarray(self.values)[i]

    def integral(self, time):
        """Integral from 0 to the given times (which may be negative)."""
        knots = np.concatenate(([0.0], self.times[1:]))
        areas = np.concatenate(([0.0], np.cumsum(
            np.diff(knots)*np.asarray(self.values[:-1]))))
        time = np.asarray(time, dtype=float)
        i = np.searchsorted(self.times, time, side="right") - 1
        return areas[i] + np.asarray(self.values)[i]*(time - knots[i])


class TwoBarImpact:
    """The solution up to endTime for bars[0] (left) and bars[1] (right).

    events   list of (time, "contact" or "release")
    """

    def __init__(self, left, right, endTime):
        self.bars = (left, right)
        self.endTime = endTime
        self.events = []

        # The invariants that each bar emits: to the right from its left end,
        # and to the left from its right end
        self._r = [Steps(bar.velocity) for bar in self.bars]
        self._l = [Steps(bar.velocity) for bar in self.bars]

        self._march()

    @classmethod
    def fromCase(cls, case, endTime=None):
        """The bars of a case folder of this tutorial."""
        from foamlib import FoamFile

        case = Path(case)
        bars = []
        for region in "bar1", "bar2":
            mesh = FoamFile(case/"system"/region/"blockMeshDict")
            law = FoamFile(case/"constant"/region/"mechanicalProperties")
            start = FoamFile(case/"0.orig"/region/"pointU")
            if float(law["nu"]) != 0:
                raise ValueError(f"{law.path}: nu must be 0 for bars")
            bars.append(Bar(
                start=float(mesh["xMin"]),
                length=float(mesh["xMax"]) - float(mesh["xMin"]),
                E=float(law["E"]),
                rho=float(law["rho"]),
                velocity=float(start["internalField"][0])))
        if endTime is None:
            endTime = float(FoamFile(case/"system"/"controlDict")["endTime"])
        return cls(*bars, endTime)

    def _march(self):
        left, right = self.bars
        touching = False
        time, gap = 0.0, right.start - left.end
        small = 1e-12*max(bar.length for bar in self.bars)

        while time <= self.endTime:
            # Free outer ends reflect
            self._r[0].append(time, self._incomingLeft(0, time))
            self._l[1].append(time, self._incomingRight(1, time))

            # The ends that may touch
            r, l = self._incomingRight(0, time), self._incomingLeft(1, time)
            zl, zr = left.z, right.z
            sigma = zl*zr*(l - r)/(zl + zr)
            was = touching
            touching = gap <= small and sigma < -1e-12*max(zl, zr)*max(
                abs(r), abs(l), 1e-300)
            if touching:
                v = (zl*r + zr*l)/(zl + zr)
                self._l[0].append(time, 2*v - r)
                self._r[1].append(time, 2*v - l)
            else:
                self._l[0].append(time, r)
                self._r[1].append(time, l)
            if touching != was:
                self.events.append(
                    (time, "contact" if touching else "release"))

            # The next change at any end
            following = min(
                emitted.next(self._emission(bar, time)) + bar.length/bar.c
                for bar, ends in zip(self.bars, zip(self._r, self._l))
                for emitted in ends)
            opening = 0.0 if touching else l - r
            if opening < 0 and gap > small:
                following = min(following, time - gap/opening)
            if following == np.inf:
                break
            gap += opening*(following - time)
            time = following

    def _emission(self, bar, time):
        """The time when the invariant that arrives now was emitted. A change
        that is due up to round-off counts as arrived."""
        return time - bar.length/bar.c + 1e-13*self.endTime

    def _incomingRight(self, i, time):
        return self._r[i].last(self._emission(self.bars[i], time))

    def _incomingLeft(self, i, time):
        return self._l[i].last(self._emission(self.bars[i], time))

    def _delays(self, i, X, time):
        bar = self.bars[i]
        X, time = np.broadcast_arrays(
            np.asarray(X, dtype=float), np.asarray(time, dtype=float))
        return time - (X - bar.start)/bar.c, time - (bar.end - X)/bar.c

    def velocity(self, i, X, time):
        """v at coordinates X of bar i (0 or 1); at a jump, the value after
        it."""
        tr, tl = self._delays(i, X, time)
        return 0.5*(self._r[i](tr) + self._l[i](tl))

    def stress(self, i, X, time):
        tr, tl = self._delays(i, X, time)
        return 0.5*self.bars[i].z*(self._l[i](tl) - self._r[i](tr))

    def displacement(self, i, X, time):
        tr, tl = self._delays(i, X, time)
        t0r, t0l = self._delays(i, X, 0.0)
        r, l = self._r[i], self._l[i]
        return 0.5*(r.integral(tr) - r.integral(t0r)
                    + l.integral(tl) - l.integral(t0l))

    def energies(self, i, time):
        """Kinetic and strain energy of bar i per unit of cross-section."""
        bar = self.bars[i]
        kinetic, strain = np.empty(np.shape(time)), np.empty(np.shape(time))
        for k, t in enumerate(time):
            # Between the fronts everything is constant
            r = bar.start + bar.c*(t - np.asarray(self._r[i].times[1:]))
            l = bar.end - bar.c*(t - np.asarray(self._l[i].times[1:]))
            fronts = np.concatenate((r, l))
            inside = (fronts > bar.start) & (fronts < bar.end)
            X = np.unique(np.concatenate(
                ([bar.start, bar.end], fronts[inside])))
            mid, dX = 0.5*(X[1:] + X[:-1]), np.diff(X)
            kinetic[k] = np.sum(0.5*bar.rho*self.velocity(i, mid, t)**2*dX)
            strain[k] = np.sum(0.5/bar.E*self.stress(i, mid, t)**2*dX)
        return kinetic, strain

    def changes(self):
        """Times at which v or sigma change at one of the ends that touch."""
        times = {0.0}
        for i, bar in enumerate(self.bars):
            lag = bar.length/bar.c
            if i == 0:
                times |= {t + lag for t in self._r[0].times}
                times |= set(self._l[0].times)
            else:
                times |= {t + lag for t in self._l[1].times}
                times |= set(self._r[1].times)
        kept = []
        for t in sorted(times):
            if 0 <= t <= self.endTime and (
                    not kept or t - kept[-1] > 1e-9*self.endTime):
                kept.append(t)
        return kept


def main(case=".", endTime=None):
    exact = TwoBarImpact.fromCase(case, endTime and float(endTime))
    left, right = exact.bars
    for time, event in exact.events:
        print(f"{event} at {time:.6f} s")
    print("from [s]   v_A [m/s]   v_B [m/s]  sigma_A [Pa] sigma_B [Pa]")
    for t in exact.changes():
        after = t + 1e-9*exact.endTime
        print(f"{t:8.6f}  {exact.velocity(0, left.end, after):10.7f}"
              f"  {exact.velocity(1, right.start, after):10.7f}"
              f"  {exact.stress(0, left.end, after):12.7f}"
              f" {exact.stress(1, right.start, after):12.7f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
