# The best placement on one combination of four edges as a nonconvex program, solved by SCIP.
#
# Takes the path of a JSON file: the limits of time and gap, and combinations: an outline with the
# inward normals and stiffnesses of its edges, and the numbers of four of them. Writes JSON to
# standard output: the version, and of each combination objective, bound, status and time.

import json
import sys
import time

import numpy
import pyscipopt

# How far a constraint may be missed, in units where the outline has the size 1: a tenth of the gap.
FEASIBILITY = 1e-7


def program(case, limits):
    """The equivalent stiffness mu_eq = t, to be maximized; lengths in units of the outline."""
    corners = numpy.array(case["corners"])
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
    unit = numpy.abs(corners - middle).max()
    corners = (corners - middle) / unit
    edges = case["edges"]
    ends = numpy.stack([corners, numpy.roll(corners, -1, axis=0)], axis=1)[edges]
    normals = numpy.array(case["normals"])[edges]
    stiffness = numpy.array(case["stiffness"])[edges]
    # Row i: J n_i, so that the normal of finger i through d has the moment (J n_i) . d.
    turned = numpy.column_stack([normals[:, 1], -normals[:, 0]])
    moments = numpy.sort(numpy.einsum("ijx,ix->ij", ends, turned), axis=1)

    model = pyscipopt.Model()
    model.hideOutput()
    model.setParam("limits/time", limits["seconds"])
    model.setParam("limits/gap", limits["gap"])
    model.setParam("numerics/feastol", FEASIBILITY)
    gamma = [model.addVar(lb=low, ub=high) for low, high in moments.tolist()]
    force = [model.addVar(lb=0, ub=1) for _ in range(4)]
    box = center_box(turned, stiffness, moments)
    d = [model.addVar(lb=low, ub=high) for low, high in box.tolist()]
    t = model.addVar(lb=0)
    k, n, a = stiffness.tolist(), normals.tolist(), turned.tolist()

    # The fingers push, and their forces balance.
    fingers = range(4)
    model.addCons(pyscipopt.quicksum(force) == 1)
    for axis in range(2):
        model.addCons(pyscipopt.quicksum(force[i] * n[i][axis] for i in fingers) == 0)
    model.addCons(pyscipopt.quicksum(force[i] * gamma[i] for i in fingers) == 0)
    # The center of compliance.
    arm = [gamma[i] - a[i][0] * d[0] - a[i][1] * d[1] for i in fingers]
    for axis in range(2):
        model.addCons(pyscipopt.quicksum(k[i] * a[i][axis] * arm[i] for i in fingers) == 0)
    # The rotational stiffness about it, and the square of its reach. As variables of their own they
    # halve the time: each product then stands in one constraint only.
    rotation, square = model.addVar(lb=0), model.addVar(lb=0)
    model.addCons(rotation == pyscipopt.quicksum(k[i] * arm[i] * arm[i] for i in fingers))
    for x, y in corners.tolist():
        model.addCons((d[0] - x) * (d[0] - x) + (d[1] - y) * (d[1] - y) <= square)
    model.addCons(t * square <= rotation)
    model.setObjective(t, "maximize")
    return model


def center_box(turned, stiffness, moments):
    """Where the center of compliance can be: it is linear in the moments."""
    weighted = turned * stiffness[:, None]
    shares = numpy.linalg.solve(turned.T @ weighted, weighted.T)
    ends = shares[:, :, None] * moments[None, :, :]
    return numpy.column_stack([ends.min(axis=2).sum(axis=1), ends.max(axis=2).sum(axis=1)])


def solved(case, limits):
    model = program(case, limits)
    start = time.perf_counter()
    model.optimize()
    seconds = time.perf_counter() - start
    found = model.getObjVal() if model.getNSols() > 0 else None
    bound = model.getDualbound()
    return {
        "objective": found,
        "bound": bound if abs(bound) < model.infinity() else None,
        "status": model.getStatus(),
        "seconds": seconds,
    }


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        task = json.load(file)
    answers = []
    for case in task["cases"]:
        answers.append(solved(case, task["limits"]))
        done = f"SCIP: {len(answers)} of {len(task['cases'])} combinations"
        print(done, file=sys.stderr, flush=True)
    scip = pyscipopt.Model()
    version = [scip.getMajorVersion(), scip.getMinorVersion(), scip.getTechVersion()]
    json.dump({"version": ".".join(map(str, version)), "answers": answers}, sys.stdout)


main()
