#!/usr/bin/env python3
"""Writes prince_ruperts_drop.msh and prince_ruperts_drop_strains.csv beside this file: a drop of glass along x with its
head at the origin and a thin tail, and the strain without stress of each tetrahedron.

Glass that is quenched in water solidifies from its surface inward. The later it did, the more it would still contract:
the strain grows with the power EXPONENT of the distance from the axis, over the radius there. In a sphere this gives the
stress -SURFACE_STRESS at the surface, and 2/EXPONENT of it as hydrostatic tension in the middle.
"""
import math
import pathlib

HEAD, LENGTH, TAIL = 6e-3, 50e-3, 1.5e-3  # radius of the head, length, radius of the tail's end [m]
SQUARES, LAYERS = 4, 24  # across, along
SURFACE_STRESS, EXPONENT = 300e6, 4  # [Pa]
YOUNG_MODULUS, POISSON_RATIO = 70e9, 0.22
STRAIN = SURFACE_STRESS * (1 - POISSON_RATIO) / YOUNG_MODULUS * (EXPONENT + 3) / EXPONENT

# Paths along the edges of a cube from its first corner to the opposite one: six tetrahedra that match their neighbors'.
PATHS = [(1, 3), (1, 5), (2, 3), (2, 6), (4, 5), (4, 6)]


def radius(x):
    """Returns the radius of the drop [m] at a distance from the tip of its head [m]."""
    if x < HEAD:
        return math.sqrt(x * (2 * HEAD - x))
    along = (x - HEAD) / (LENGTH - HEAD)
    return TAIL + (HEAD - TAIL) * math.exp(-10 * along * along)


def place(i, j, k):
    """Returns a node of the lattice [m] and its distance from the axis over the drop's radius: 0..1."""
    a, b = 2 * i / SQUARES - 1, 2 * j / SQUARES - 1
    share, turn = max(abs(a), abs(b)), math.atan2(b, a)
    along = k / LAYERS
    # The head's tip is a flat spot of half its radius: the lattice ends there in a disc.
    x = HEAD * (1 - math.cos(math.pi / 6)) + along ** 1.2 * (LENGTH - HEAD * (1 - math.cos(math.pi / 6)))
    r = share * radius(x)
    return (x, r * math.cos(turn), r * math.sin(turn)), share


def lattice():
    """Returns the nodes by their place in the lattice, and the tetrahedra by nodes."""
    nodes = {(i, j, k): place(i, j, k) for k in range(LAYERS + 1) for j in range(SQUARES + 1) for i in range(SQUARES + 1)}
    index = {key: n for n, key in enumerate(nodes)}
    tets = []
    for k in range(LAYERS):
        for j in range(SQUARES):
            for i in range(SQUARES):
                # The paths lead outward, or they would cut off flat corners at the surface.
                flip = (i < SQUARES // 2) + 2 * (j < SQUARES // 2)
                corner = lambda c: index[i + ((c ^ flip) & 1), j + ((c ^ flip) >> 1 & 1), k + (c >> 2 & 1)]
                tets += [[corner(c) for c in (0, a, b, 7)] for a, b in PATHS]
    return list(nodes.values()), tets


def volume(points):
    a, b, c = ([p - o for p, o in zip(point, points[0])] for point in points[1:])
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6


def main():
    nodes, tets = lattice()
    for tet in tets:
        if volume([nodes[n][0] for n in tet]) < 0:
            tet[2], tet[3] = tet[3], tet[2]
    folder = pathlib.Path(__file__).parent
    with open(folder / 'prince_ruperts_drop.msh', 'w', encoding='utf-8') as file:
        file.write('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n' % len(nodes))
        for n, (point, _) in enumerate(nodes):
            file.write('%d %s\n' % (n + 1, ' '.join('%.5g' % x for x in point)))
        file.write('$EndNodes\n$Elements\n%d\n' % len(tets))
        for t, tet in enumerate(tets):
            file.write('%d 4 0 %s\n' % (t + 1, ' '.join(str(n + 1) for n in tet)))
        file.write('$EndElements\n')
    with open(folder / 'prince_ruperts_drop_strains.csv', 'w', encoding='utf-8') as file:
        for tet in tets:
            strain = '%.4g' % (STRAIN * sum(nodes[n][1] ** EXPONENT for n in tet) / 4)
            file.write('%s,%s,%s,0,0,0\n' % (strain, strain, strain))


if __name__ == '__main__':
    main()
