# The best of a grid of placements of four fingers on a polygon, by plain enumeration in NumPy.
#
# Takes the path of a JSON file: the number of places per edge, and outlines with the inward normals
# and stiffnesses of their edges. Writes JSON to standard output: the version, and of each outline
# the best quality, the number of placements and the time.

import itertools
import json
import sys
import time

import numpy

# Combinations that are evaluated at once: as many as the caches hold.
BLOCK = 64

# A force below this part of the largest one does not push: it may be rounding.
LEAST_FORCE = 1e-12


def best(outline, places):
    """The largest min(sigma_min, mu_eq) of the placements that close, and how many there are."""
    corners = numpy.array(outline["corners"])
    corners = corners - corners.mean(axis=0)
    normals, stiffness = numpy.array(outline["normals"]), numpy.array(outline["stiffness"])
    along = numpy.linspace(0.0, 1.0, places)
    sides = numpy.roll(corners, -1, axis=0) - corners
    points = corners[:, None, :] + along[None, :, None] * sides[:, None, :]
    moments = cross(points, normals[:, None, :])
    edges = range(len(corners))
    combinations = numpy.array(list(itertools.combinations_with_replacement(edges, 4)))
    spots = numpy.array(list(itertools.product(range(places), repeat=4)))
    found = 0.0
    for start in range(0, len(combinations), BLOCK):
        block = combinations[start : start + BLOCK]
        # By combination, placement and finger.
        gamma = moments[block[:, None, :], spots[None, :, :]]
        found = max(found, best_of_block(normals[block], stiffness[block], gamma, corners))
    return found, len(combinations) * len(spots)


def best_of_block(n, k, gamma, corners):
    which, spot = numpy.nonzero(closes(n, gamma))
    if len(which) == 0:
        return 0.0
    gamma = gamma[which, spot]
    # Row i: J n_i, so that the normal of finger i through d has the moment (J n_i) . d.
    a = numpy.stack([n[..., 1], -n[..., 0]], axis=-1)
    translation = numpy.einsum("cf,cfx,cfy->cxy", k, a, a)
    regular = numpy.linalg.det(translation) > 0.0
    inverse = numpy.zeros_like(translation)
    inverse[regular] = numpy.linalg.inv(translation[regular])
    sigma_min = numpy.linalg.eigvalsh(translation)[:, 0]
    shares = numpy.einsum("cxy,cf,cfy->cfx", inverse, k, a)
    d = numpy.einsum("pfx,pf->px", shares[which], gamma)
    mu = (k[which] * (gamma - numpy.einsum("pfx,px->pf", a[which], d)) ** 2).sum(axis=1)
    square = ((d[:, None, :] - corners[None, :, :]) ** 2).sum(axis=2).max(axis=1)
    return float(numpy.minimum(sigma_min[which], mu / square).max())


def closes(n, gamma):
    """Whether forces that all push balance: the null vector of the wrenches has one sign."""
    turn = cross(n[:, :, None, :], n[:, None, :, :])

    def volume(i, j, k):
        by = turn[:, None]
        wedge = gamma[..., i] * by[..., j, k] - gamma[..., j] * by[..., i, k]
        return wedge + gamma[..., k] * by[..., i, j]

    forces = [volume(1, 2, 3), -volume(0, 2, 3), volume(0, 1, 3), -volume(0, 1, 2)]
    low = numpy.minimum(numpy.minimum(forces[0], forces[1]), numpy.minimum(forces[2], forces[3]))
    high = numpy.maximum(numpy.maximum(forces[0], forces[1]), numpy.maximum(forces[2], forces[3]))
    return (low > LEAST_FORCE * high) | (high < LEAST_FORCE * low)


def cross(p, q):
    return p[..., 0] * q[..., 1] - p[..., 1] * q[..., 0]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        task = json.load(file)
    answers = []
    for outline in task["outlines"]:
        start = time.perf_counter()
        quality, placements = best(outline, task["places"])
        seconds = time.perf_counter() - start
        answers.append({"quality": quality, "placements": placements, "seconds": seconds})
        done = f"NumPy: {len(answers)} of {len(task['outlines'])} outlines"
        print(done, file=sys.stderr, flush=True)
    json.dump({"version": numpy.__version__, "answers": answers}, sys.stdout)


main()
