"""Bounds on the bearing capacity of a smooth strip on two layers of clay, by linear programming (Sloan 1988, 1989).

    two_layers.py [--cells N] [--sides P] RATIO DEPTH ...

RATIO is the strength of the lower layer over that of the upper one, DEPTH that of its top over the width of the footing B.
Prints lower and upper bounds of N = F/(B s_u1), the reference of benchmark B11. The upper one is from a velocity field, continuous and
linear in triangles, whose dissipation is that of a polygon around the yield circle: rigorous. The lower one is from a stress field, linear in
triangles and in equilibrium, that nowhere violates a polygon inside the circle: rigorous for soil that ends where the model does, 2 B from
the axis and 1.5 B deep. Half of the problem is solved, smooth on the axis and rough on the other sides.
Python 3 with numpy and scipy; `--cells 16 --sides 24` takes some two minutes for a case.
"""
import argparse
import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

WIDTH, DEPTH = 2.0, 1.5  # of the half model [B]


def mesh(cells):
    """Points and triangles: squares of B/cells, each cut into four by its diagonals."""
    nx, nz = int(round(WIDTH * cells)), int(round(DEPTH * cells))
    h = 1.0 / cells
    corner = lambda i, j: j * (nx + 1) + i
    points = [(i * h, -j * h) for j in range(nz + 1) for i in range(nx + 1)]
    triangles = []
    for j in range(nz):
        for i in range(nx):
            points.append(((i + 0.5) * h, -(j + 0.5) * h))
            m = len(points) - 1
            a, b, c, d = corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j), corner(i, j)
            triangles += [(a, b, m), (b, c, m), (c, d, m), (d, a, m)]
    return np.array(points), np.array(triangles)


def strength(points, triangles, ratio, depth):
    return np.where(points[triangles].mean(axis=1)[:, 1] > -depth, 1.0, ratio)


def gradients(points, triangles):
    p = points[triangles]
    x, z = p[:, :, 0], p[:, :, 1]
    b = np.stack([z[:, 1] - z[:, 2], z[:, 2] - z[:, 0], z[:, 0] - z[:, 1]], axis=1)
    c = np.stack([x[:, 2] - x[:, 1], x[:, 0] - x[:, 2], x[:, 1] - x[:, 0]], axis=1)
    area = 0.5 * (x[:, 0] * b[:, 0] + x[:, 1] * b[:, 1] + x[:, 2] * b[:, 2])
    return b / (2 * area[:, None]), c / (2 * area[:, None]), area


class Rows:
    """Rows of a sparse matrix."""

    def __init__(self):
        self.i, self.j, self.v, self.n = [], [], [], 0

    def add(self, columns, values):
        self.i += [self.n] * len(columns)
        self.j += list(columns)
        self.v += list(values)
        self.n += 1

    def matrix(self, columns):
        return coo_matrix((self.v, (self.i, self.j)), shape=(self.n, columns)).tocsr()


def upper(cells, sides, ratio, depth):
    points, triangles = mesh(cells)
    s, (gx, gz, area) = strength(points, triangles, ratio, depth), gradients(points, triangles)
    n, t = len(points), len(triangles)
    angles = 2 * np.pi * np.arange(sides) / sides
    rows = Rows()
    for e, corners in enumerate(triangles):
        vx, vz = 2 * corners, 2 * corners + 1
        multipliers = 2 * n + e * sides + np.arange(sides)
        # strain rates: e_x = sum l cos a, e_z = -e_x, g_xz = sum 2 l sin a
        rows.add([*vx, *multipliers], [*gx[e], *(-np.cos(angles))])
        rows.add([*vz, *multipliers], [*gz[e], *np.cos(angles)])
        rows.add([*vx, *vz, *multipliers], [*gz[e], *gx[e], *(-2 * np.sin(angles))])
    bounds = [(None, None)] * (2 * n) + [(0, None)] * (t * sides)
    tiny = 1e-9
    for k, (x, z) in enumerate(points):
        if x < tiny:
            bounds[2 * k] = (0, 0)
        if x > WIDTH - tiny or z < -DEPTH + tiny:
            bounds[2 * k] = bounds[2 * k + 1] = (0, 0)
        if z > -tiny and x < 0.5 + tiny:
            bounds[2 * k + 1] = (-1, -1)
    # (s_x - s_z) cos a + 2 t sin a <= 2 s / cos(pi/sides): a polygon around the circle
    cost = np.concatenate([np.zeros(2 * n), np.repeat(2 * s * area / np.cos(np.pi / sides), sides)])
    found = linprog(cost, A_eq=rows.matrix(2 * n + t * sides), b_eq=np.zeros(rows.n), bounds=bounds, method="highs-ipm")
    return found.fun / 0.5


def lower(cells, sides, ratio, depth):
    points, triangles = mesh(cells)
    s, (gx, gz, _) = strength(points, triangles, ratio, depth), gradients(points, triangles)
    t = len(triangles)
    at = lambda e, corner, component: 9 * e + 3 * corner + component  # s_x, s_z, t_xz
    rows, tiny = Rows(), 1e-9
    for e in range(t):
        rows.add([at(e, c, 0) for c in range(3)] + [at(e, c, 2) for c in range(3)], [*gx[e], *gz[e]])
        rows.add([at(e, c, 2) for c in range(3)] + [at(e, c, 1) for c in range(3)], [*gx[e], *gz[e]])
    edges = {}
    for e, corners in enumerate(triangles):
        for a in range(3):
            b = (a + 1) % 3
            edges.setdefault(tuple(sorted((corners[a], corners[b]))), []).append((e, a, b))
    objective = np.zeros(9 * t)
    for (p, q), sharing in edges.items():
        d = points[q] - points[p]
        nx, nz = d[1], -d[0]
        traction = lambda e, c: ([at(e, c, 0), at(e, c, 2)], [nx, nz], [at(e, c, 2), at(e, c, 1)], [nx, nz])
        corner = lambda e, a, b, point: a if triangles[e][a] == point else b
        for point in (p, q):
            sides_of = [traction(e, corner(e, a, b, point)) for e, a, b in sharing]
            if len(sides_of) == 2:
                (c1, v1, c2, v2), (d1, w1, d2, w2) = sides_of
                rows.add(c1 + d1, v1 + [-w for w in w1])
                rows.add(c2 + d2, v2 + [-w for w in w2])
                continue
            e, a, b = sharing[0]
            c = corner(e, a, b, point)
            on_axis = points[p][0] < tiny and points[q][0] < tiny
            on_top = points[p][1] > -tiny and points[q][1] > -tiny
            under = on_top and max(points[p][0], points[q][0]) < 0.5 + tiny
            if on_axis or on_top:
                rows.add([at(e, c, 2)], [1.0])
            if on_top and not under:
                rows.add([at(e, c, 1)], [1.0])
            if under:
                objective[at(e, c, 1)] += 0.5 * np.linalg.norm(d)
    limits = Rows()
    right = []
    for e in range(t):
        for c in range(3):
            for angle in 2 * np.pi * np.arange(sides) / sides:
                limits.add([at(e, c, 0), at(e, c, 1), at(e, c, 2)], [np.cos(angle), -np.cos(angle), 2 * np.sin(angle)])
                right.append(2 * s[e] * np.cos(np.pi / sides))
    found = linprog(objective, A_ub=limits.matrix(9 * t), b_ub=right, A_eq=rows.matrix(9 * t), b_eq=np.zeros(rows.n),
                    bounds=(None, None), method="highs-ipm")
    return -found.fun / 0.5


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", nargs="+", type=float)
    parser.add_argument("--cells", type=int, default=8)
    parser.add_argument("--sides", type=int, default=16)
    a = parser.parse_args()
    for ratio, depth in zip(a.case[::2], a.case[1::2]):
        low = lower(a.cells, a.sides, ratio, depth)
        high = upper(a.cells, a.sides, ratio, depth)
        print(f"s_u2/s_u1 = {ratio}, H/B = {depth}, B/h = {a.cells}: {low:.3f} to {high:.3f}", flush=True)
