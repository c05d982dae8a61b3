#!/usr/bin/env python3
"""Writes bear.obj beside this file: a bear on four flat feet, 1.9 m long, as a closed surface of triangles.

The bear is where a distance is negative: that to some balls and rods, blended so that they flow into each other. Its
surface is found by surface nets (Gibson 1998, "Constrained elastic surface nets"): a point in each cell of a lattice
that it passes through, in the middle of where it crosses the cell's edges, and a square around each edge that it crosses.
"""
import itertools
import math
import pathlib

CELL = 0.055  # of the lattice [m]
BLEND = 0.10  # how far parts flow into each other [m]
FEET = -0.75  # height of the flat soles [m]

# Middle and radii of ellipsoids [m]: trunk, head, snout, tail, ears.
BALLS = [((0, 0, -0.1), (0.42, 0.40, 0.66)), ((0, 0.36, 0.56), (0.34, 0.32, 0.32)), ((0, 0.25, 0.85), (0.19, 0.17, 0.2)),
         ((0, 0.2, -0.76), (0.13, 0.13, 0.13)), ((0.24, 0.66, 0.52), (0.15, 0.15, 0.12)), ((-0.24, 0.66, 0.52), (0.15, 0.15, 0.12))]
# Ends and radius of rods [m]: legs.
RODS = [((x, -0.1, z), (1.1 * x, -0.7, z), 0.18) for x in (0.24, -0.24) for z in (0.3, -0.46)]


def length(v):
    return math.sqrt(sum(x * x for x in v))


def to_ball(place, ball):
    """Returns about the distance of a place from an ellipsoid, negative inside [m]."""
    scaled = [(x - m) / r for x, m, r in zip(place, *ball)]
    away, steepness = length(scaled), length([s / r for s, r in zip(scaled, ball[1])])
    return away * (away - 1) / steepness if steepness > 0 else -min(ball[1])


def to_rod(place, rod):
    """Returns the distance of a place from a rod with round ends, negative inside [m]."""
    start, end, radius = rod
    along = [b - a for a, b in zip(start, end)]
    way = [x - a for x, a in zip(place, start)]
    share = sum(a * w for a, w in zip(along, way)) / sum(a * a for a in along)
    share = min(max(share, 0), 1)
    return length([w - share * a for a, w in zip(along, way)]) - radius


def blended(a, b):
    """Returns the least of two distances, less near places that are as far from both [m]."""
    share = max(BLEND - abs(a - b), 0) / BLEND
    return min(a, b) - share * share * BLEND / 4


def to_bear(place):
    """Returns about the distance of a place from the bear's surface, negative inside [m]."""
    distance = math.inf
    for part in [to_ball(place, ball) for ball in BALLS] + [to_rod(place, rod) for rod in RODS]:
        distance = blended(distance, part) if distance < math.inf else part
    return max(distance, FEET - place[1])


def surface_net(low, counts):
    """Returns the points [m] and squares of the surface on a lattice that begins at `low` and has so many nodes."""
    def corner(node):
        return [a + CELL * n for a, n in zip(low, node)]

    nodes = list(itertools.product(*map(range, counts)))
    distances = {node: to_bear(corner(node)) for node in nodes}
    points, point_of, squares = [], {}, []

    def crossings(cell):
        for axis, a, b in itertools.product(range(3), range(2), range(2)):
            start = list(cell)
            start[(axis + 1) % 3] += a
            start[(axis + 2) % 3] += b
            end = [n + (k == axis) for k, n in enumerate(start)]
            first, last = distances[tuple(start)], distances[tuple(end)]
            if (first < 0) != (last < 0):
                yield corner([n + (k == axis) * first / (first - last) for k, n in enumerate(start)])

    def point_in(cell):
        if cell not in point_of:
            point_of[cell] = len(points)
            crossed = list(crossings(cell))
            points.append([sum(x) / len(crossed) for x in zip(*crossed)])
        return point_of[cell]

    for node, axis in itertools.product(nodes, range(3)):
        other = tuple(n + (k == axis) for k, n in enumerate(node))
        if other not in distances or (distances[node] < 0) == (distances[other] < 0):
            continue
        u, v = (axis + 1) % 3, (axis + 2) % 3
        around = [tuple(n - (a if k == u else b if k == v else 0) for k, n in enumerate(node))
                  for a, b in ((1, 1), (0, 1), (0, 0), (1, 0))]
        square = [point_in(cell) for cell in around]
        squares.append(square if distances[node] < 0 else square[::-1])
    return points, squares


def triangles_of(points, squares):
    """Returns two triangles a square, parted along the shorter diagonal."""
    triangles = []
    for a, b, c, d in squares:
        if math.dist(points[a], points[c]) < math.dist(points[b], points[d]):
            triangles += [(a, b, c), (a, c, d)]
        else:
            triangles += [(b, c, d), (b, d, a)]
    return triangles


def check_closed(triangles):
    """Raises ValueError unless each edge has one triangle on either side."""
    edges = [(triangle[i], triangle[(i + 1) % 3]) for triangle in triangles for i in range(3)]
    known = set(edges)
    if len(known) != len(edges) or any((b, a) not in known for a, b in edges):
        raise ValueError("the surface is not closed: choose another CELL")


def main():
    points, squares = surface_net((-0.605, -0.87, -0.973), (24, 36, 40))
    triangles = triangles_of(points, squares)
    check_closed(triangles)
    lines = ["# A bear, 1.9 m long; made by make_bear.py."]
    lines += ["v %.5f %.5f %.5f" % tuple(point) for point in points]
    lines += ["f %d %d %d" % tuple(corner + 1 for corner in triangle) for triangle in triangles]
    pathlib.Path(__file__).with_name("bear.obj").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
