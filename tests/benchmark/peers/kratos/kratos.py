#!/usr/bin/env python3
"""The twisting column and the Taylor bar with Kratos: where a probe goes, and
what a step costs. Runs with the Python that ../install has made.

    kratos.py column|taylor ELEMENTS
"""

import sys
import time

import KratosMultiphysics as KM
import KratosMultiphysics.ConstitutiveLawsApplication as CLA
import KratosMultiphysics.StructuralMechanicsApplication as SMA
import numpy as np

from vertexContactTests.peers.scenes import SCENES

PRINTED = 20
POINTS = 6      # HARDENING_CURVE: a curve given by points


def rubber(properties):
    """Compressible neo-Hookean law; its volumetric energy differs from
    ours."""
    properties.SetValue(KM.YOUNG_MODULUS, 17e6)
    properties.SetValue(KM.POISSON_RATIO, 0.3)
    return "HyperElastic3DLaw"


def copper(properties):
    """Finite plastic strains with the hardening up to a strain of 10. Beyond
    the points the material would soften; a large fracture energy prevents
    this."""
    stress, strain = KM.Vector(2), KM.Vector(2)
    stress[0], stress[1] = 0.4e9, 1.4e9
    strain[0], strain[1] = 0, 10
    for variable, value in (
            (KM.YOUNG_MODULUS, 117e9), (KM.POISSON_RATIO, 0.35),
            (KM.YIELD_STRESS, 0.4e9), (KM.FRACTURE_ENERGY, 1e10),
            (CLA.HARDENING_CURVE, POINTS),
            (CLA.EQUIVALENT_STRESS_VECTOR_PLASTICITY_POINT_CURVE, stress),
            (CLA.PLASTIC_STRAIN_VECTOR_PLASTICITY_POINT_CURVE, strain)):
        properties.SetValue(variable, value)
    return "FiniteStrainIsotropicPlasticity3DVonMisesVonMises"


MATERIALS = {"column": rubber, "taylor": copper}


def body(scene, part, material):
    """Nodes, elements and initial velocities."""
    part.ProcessInfo.SetValue(KM.DOMAIN_SIZE, 3)
    for variable in (
            KM.DISPLACEMENT, KM.VELOCITY, KM.ACCELERATION, KM.REACTION,
            KM.FORCE_RESIDUAL, KM.MOMENT_RESIDUAL, KM.RESIDUAL_VECTOR,
            KM.VOLUME_ACCELERATION, KM.NODAL_MASS, SMA.NODAL_INERTIA,
            SMA.NODAL_DISPLACEMENT_STIFFNESS, SMA.MIDDLE_VELOCITY,
            SMA.MIDDLE_ANGULAR_VELOCITY, SMA.FRACTIONAL_ACCELERATION):
        part.AddNodalSolutionStepVariable(variable)
    for i, place in enumerate(scene.mesh.points, 1):
        part.CreateNewNode(i, *place)
    properties = part.GetProperties()[1]
    law = KM.KratosGlobals.GetConstitutiveLaw(material(properties)).Clone()
    properties.SetValue(KM.CONSTITUTIVE_LAW, law)
    properties.SetValue(KM.DENSITY, scene.rho)
    properties.SetValue(SMA.RAYLEIGH_ALPHA, 0.)
    properties.SetValue(SMA.RAYLEIGH_BETA, 0.)
    for i, corners in enumerate(scene.mesh.elements, 1):
        part.CreateNewElement("TotalLagrangianElement3D8N", i,
                              [int(c) + 1 for c in corners], properties)
    directions = tuple(zip(
        (KM.DISPLACEMENT_X, KM.DISPLACEMENT_Y, KM.DISPLACEMENT_Z),
        (KM.REACTION_X, KM.REACTION_Y, KM.REACTION_Z)))
    for displacement, reaction in directions:
        KM.VariableUtils().AddDof(displacement, reaction, part)
    # Otherwise fixed nodes keep their velocity
    moving = scene.velocity.copy()
    for points, d in scene.fixed:
        moving[points, d] = 0
        for p in points:
            part.Nodes[int(p) + 1].Fix(directions[d][0])
    for node, velocity in zip(part.Nodes, moving):
        for step in 0, 1:
            node.SetSolutionStepValue(KM.VELOCITY, step, list(velocity))
        node.SetSolutionStepValue(SMA.MIDDLE_VELOCITY, 0, list(velocity))


def main():
    name, elements = sys.argv[1], int(sys.argv[2])
    scene = SCENES[name](elements)
    KM.ParallelUtilities.SetNumThreads(1)
    model = KM.Model()
    part = model.CreateModelPart(name, 2)
    body(scene, part, MATERIALS[name])
    solver = SMA.MechanicalExplicitStrategy(
        part, SMA.ExplicitCentralDifferencesScheme(1., 0., 0.), False, False,
        True)
    solver.SetEchoLevel(0)
    solver.Initialize()
    steps = PRINTED*int(np.ceil(scene.end/scene.step/PRINTED))
    step, seconds = scene.end/steps, 0
    for k in range(1, steps + 1):
        before = time.process_time()
        part.CloneTimeStep(k*step)
        part.ProcessInfo[KM.STEP] = k
        part.ProcessInfo[KM.DELTA_TIME] = step
        solver.Solve()
        seconds += time.process_time() - before
        if k % (steps//PRINTED) == 0:
            print(f"{k*step:.5g}", *(
                f"{which} " + " ".join(
                    f"{u:.6g}" for u in part.Nodes[
                        node + 1].GetSolutionStepValue(KM.DISPLACEMENT))
                for which, node in scene.probes.items()), flush=True)
    nodes = len(scene.mesh.points)
    print(f"{nodes} nodes, {steps} steps, {seconds:.3g} s, "
          f"{1e6*seconds/steps/nodes:.3g} us per node and step")


if __name__ == "__main__":
    main()
