"""Distances to a surface of triangles, and points lifted onto it along z."""
import numpy as np
from scipy.spatial import cKDTree


def patches_of(mesh, pieces=3):
    """Triangles that follow a shell mesh: a quad is a bilinear patch, cut into `pieces` x `pieces` quads of two
    triangles; neither diagonal of a warped quad is preferred."""
    corners = mesh.points[mesh.quads]
    u, v = np.meshgrid(np.linspace(0, 1, pieces + 1), np.linspace(0, 1, pieces + 1), indexing="ij")
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=-1)
    grid = np.einsum("ijc,qcx->qijx", weights, corners)
    a, b, c, d = grid[:, :-1, :-1], grid[:, 1:, :-1], grid[:, 1:, 1:], grid[:, :-1, 1:]
    cut = [np.stack(t, axis=3).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))]
    return np.concatenate(cut + [mesh.points[mesh.triangles].reshape(-1, 3, 3)])


def nearest_on_triangles(points, triangles):
    """Distance of points[i] from triangles[i]: over the inside along the normal, else the nearest side."""
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    size = np.linalg.norm(normal, axis=1)
    normal /= np.maximum(size, 1e-300)[:, None]
    height = np.einsum("ij,ij->i", points - triangles[:, 0], normal)
    over, to_side = size > 0, np.full(len(points), np.inf)
    for i in range(3):
        start, side = triangles[:, i], triangles[:, (i + 1) % 3] - triangles[:, i]
        arm = points - start
        over &= np.einsum("ij,ij->i", np.cross(side, arm), normal) >= 0
        along = np.einsum("ij,ij->i", arm, side) / np.maximum(np.einsum("ij,ij->i", side, side), 1e-300)
        rest = arm - np.clip(along, 0, 1)[:, None] * side
        to_side = np.minimum(to_side, np.linalg.norm(rest, axis=1))
    return np.where(over, np.abs(height), to_side)


class Surface:
    """Triangles, found by their centres. A triangle cannot be nearer than its centre less its radius, so a search is
    over when the next centre is farther than the best found plus the largest radius; long triangles are halved first."""

    def __init__(self, triangles, largest=3.0):
        self.triangles = halved(np.asarray(triangles, float), largest)
        self.centres = self.triangles.mean(axis=1)
        self.radius = np.linalg.norm(self.triangles - self.centres[:, None], axis=2).max()
        self.tree = cKDTree(self.centres)

    def distances(self, points, first=12):
        """Distance of every point from the surface, exact."""
        points = np.asarray(points, float)
        best, open_points, count = np.full(len(points), np.inf), np.arange(len(points)), first
        while len(open_points):
            count = min(count, len(self.centres))
            reach, near = self.tree.query(points[open_points], k=count)
            reach, near = reach.reshape(-1, count), near.reshape(-1, count)
            for column in near.T:
                best[open_points] = np.minimum(
                    best[open_points], nearest_on_triangles(points[open_points], self.triangles[column]))
            if count == len(self.centres):
                break
            open_points = open_points[reach[:, -1] < best[open_points] + self.radius]
            count *= 4
        return best


def halved(triangles, largest):
    """The triangles cut across their longest side until none is longer than `largest`."""
    done = []
    while len(triangles):
        length = np.linalg.norm(triangles - np.roll(triangles, -1, axis=1), axis=2)
        long = length.max(axis=1) > largest
        done.append(triangles[~long])
        triangles, longest = triangles[long], length[long].argmax(axis=1)
        row = np.arange(len(triangles))
        a, b, c = (triangles[row, (longest + i) % 3] for i in range(3))
        middle = (a + b) / 2
        triangles = np.concatenate([np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)])
    return np.concatenate(done)


def heights(surface, plan):
    """z of the surface over plan points (n, 2), nan where there is none: the triangle over which a point lies."""
    flat = surface.triangles[:, :, :2]
    u, v = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    usable = np.flatnonzero(np.abs(area) > 1e-9)
    centres = flat.mean(axis=1)
    _, near = cKDTree(centres[usable]).query(plan, k=min(40, len(usable)))
    z = np.full(len(plan), np.nan)
    for column in usable[near.reshape(len(plan), -1)].T:
        arm = plan - flat[column, 0]
        s = (arm[:, 0] * v[column, 1] - arm[:, 1] * v[column, 0]) / area[column]
        t = (u[column, 0] * arm[:, 1] - u[column, 1] * arm[:, 0]) / area[column]
        hit = np.isnan(z) & (s >= -1e-6) & (t >= -1e-6) & (s + t <= 1 + 1e-6)
        corners = surface.triangles[column, :, 2]
        z[hit] = (corners[:, 0] + s * (corners[:, 1] - corners[:, 0]) + t * (corners[:, 2] - corners[:, 0]))[hit]
    return z
