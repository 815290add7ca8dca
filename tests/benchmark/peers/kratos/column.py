#!/usr/bin/env python3
"""The twisting column with Kratos: energies, and what a step costs. Runs with
the Python that ../install has made.

    column.py ELEMENTS [LAW]
"""

import resource
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]/"calculix"))

import KratosMultiphysics as KM
import KratosMultiphysics.StructuralMechanicsApplication as SMA
import numpy as np

from scenes import column

E, NU = 17e6, 0.3
# The integral over the column; Kratos has no strain energy of explicit runs,
# the kinetic one is of its nodal masses
PRINTED = 10


def body(scene, law):
    """The part of the model, with its first velocities."""
    model = KM.Model()
    part = model.CreateModelPart("column", 2)
    part.ProcessInfo.SetValue(KM.DOMAIN_SIZE, 3)
    for variable in (
            KM.DISPLACEMENT, KM.VELOCITY, KM.ACCELERATION, KM.REACTION,
            KM.FORCE_RESIDUAL, SMA.MIDDLE_VELOCITY, KM.VOLUME_ACCELERATION,
            SMA.NODAL_DISPLACEMENT_STIFFNESS, SMA.NODAL_INERTIA,
            SMA.MIDDLE_ANGULAR_VELOCITY, KM.NODAL_MASS,
            SMA.FRACTIONAL_ACCELERATION, KM.RESIDUAL_VECTOR,
            KM.NODAL_VAUX, KM.MOMENT_RESIDUAL):
        part.AddNodalSolutionStepVariable(variable)
    for i, place in enumerate(scene.mesh.points, 1):
        part.CreateNewNode(i, *place)
    rubber = part.GetProperties()[1]
    rubber.SetValue(KM.YOUNG_MODULUS, E)
    rubber.SetValue(KM.POISSON_RATIO, NU)
    rubber.SetValue(KM.DENSITY, scene.rho)
    rubber.SetValue(KM.CONSTITUTIVE_LAW,
                    KM.KratosGlobals.GetConstitutiveLaw(law).Clone())
    rubber.SetValue(SMA.RAYLEIGH_ALPHA, 0.)
    rubber.SetValue(SMA.RAYLEIGH_BETA, 0.)
    for i, corners in enumerate(scene.mesh.elements, 1):
        part.CreateNewElement("TotalLagrangianElement3D8N", i,
                              [int(c) + 1 for c in corners], rubber)
    KM.VariableUtils().AddDof(KM.DISPLACEMENT_X, KM.REACTION_X, part)
    KM.VariableUtils().AddDof(KM.DISPLACEMENT_Y, KM.REACTION_Y, part)
    KM.VariableUtils().AddDof(KM.DISPLACEMENT_Z, KM.REACTION_Z, part)
    for node, velocity in zip(part.Nodes, scene.velocity):
        for step in 0, 1:
            node.SetSolutionStepValue(KM.VELOCITY, step, list(velocity))
        node.SetSolutionStepValue(SMA.MIDDLE_VELOCITY, 0, list(velocity))
    for points, d in scene.fixed:
        direction = (KM.DISPLACEMENT_X, KM.DISPLACEMENT_Y,
                     KM.DISPLACEMENT_Z)[d]
        for p in points:
            part.Nodes[int(p) + 1].Fix(direction)
    return model, part


def main():
    KM.ParallelUtilities.SetNumThreads(1)
    scene = column(int(sys.argv[1]))
    law = sys.argv[2] if len(sys.argv) > 2 else "HyperElastic3DLaw"
    model, part = body(scene, law)
    scheme = SMA.ExplicitCentralDifferencesScheme(1., 0., 0.)
    solver = SMA.MechanicalExplicitStrategy(part, scheme, False, False, True)
    solver.SetEchoLevel(0)
    mass = scene.rho*scene.mesh.volumes()[0]

    def kinetic():
        v = np.array([node.GetSolutionStepValue(KM.VELOCITY)
                      for node in part.Nodes])
        return 0.5*mass @ (v**2).sum(1)

    steps = int(np.ceil(scene.end/scene.step))
    step, start, seconds = scene.end/steps, kinetic(), 0
    top = part.Nodes[scene.probes["probe"] + 1]
    solver.Initialize()
    for k in range(1, steps + 1):
        before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        part.CloneTimeStep(k*step)
        part.ProcessInfo[KM.STEP] = k
        part.ProcessInfo[KM.DELTA_TIME] = step
        solver.Solve()
        seconds += resource.getrusage(resource.RUSAGE_SELF).ru_utime - before
        if k % (steps//PRINTED) == 0:
            print(f"{k*step:.4f} kinetic {kinetic()/start:.4f} top",
                  *(f"{u:.4f}" for u in
                    top.GetSolutionStepValue(KM.DISPLACEMENT)), flush=True)
    nodes = len(scene.mesh.points)
    print(f"{nodes} nodes, {steps} steps, {seconds:.3g} s, "
          f"{1e6*seconds/steps/nodes:.3g} us per node and step")


if __name__ == "__main__":
    main()
