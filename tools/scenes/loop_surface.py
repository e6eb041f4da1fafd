# SPDX-License-Identifier: Apache-2.0
"""Loop's subdivision surface of a closed triangle mesh, and what must hold of a mesh worth keeping.

Points are (x, y, z) tuples, triangles (a, b, c) tuples of indices, outward by the right-hand rule.
"""
import math


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def blend(terms):
    """The sum of weight times point."""
    return tuple(sum(w * p[k] for w, p in terms) for k in range(3))


def neighbours(points, triangles):
    around = [set() for _ in points]
    for a, b, c in triangles:
        around[a] |= {b, c}
        around[b] |= {a, c}
        around[c] |= {a, b}
    return [sorted(ring) for ring in around]


def beta(valence):
    """The weight of each neighbour in pbrt's form of Loop's rule."""
    return 3 / 16 if valence == 3 else 3 / (8 * valence)


def smooth(points, triangles, weight):
    """Every point moved towards its neighbours, each of which has weight(valence)."""
    moved = []
    for point, ring in zip(points, neighbours(points, triangles)):
        w = weight(len(ring))
        moved.append(blend([(1 - len(ring) * w, point)] + [(w, points[i]) for i in ring]))
    return moved


def subdivide(points, triangles):
    """One level of Loop's subdivision; every edge must have two triangles."""
    opposite = {}
    for t in triangles:
        for k in range(3):
            opposite[t[k], t[(k + 1) % 3]] = t[(k + 2) % 3]
    fresh, index = smooth(points, triangles, beta), {}
    for (a, b), c in opposite.items():
        if a < b:
            d = opposite[b, a]
            index[a, b] = index[b, a] = len(fresh)
            fresh.append(blend([(3 / 8, points[a]), (3 / 8, points[b]),
                                (1 / 8, points[c]), (1 / 8, points[d])]))
    finer = []
    for a, b, c in triangles:
        ab, bc, ca = index[a, b], index[b, c], index[c, a]
        finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return fresh, finer


def limit_surface(points, triangles, levels):
    """What pbrt's loopsubdiv renders: so many levels, then every point moved to the limit."""
    for _ in range(levels):
        points, triangles = subdivide(points, triangles)
    return smooth(points, triangles, lambda n: 1 / (n + 3 / (8 * beta(n)))), triangles


def volume(points, triangles):
    return sum(dot(points[a], cross(points[b], points[c])) for a, b, c in triangles) / 6


def smallest_angle(points, triangles):
    """The sharpest corner of any triangle, in degrees."""
    least = math.pi
    for t in triangles:
        for k in range(3):
            u = subtract(points[t[(k + 1) % 3]], points[t[k]])
            v = subtract(points[t[(k + 2) % 3]], points[t[k]])
            n = cross(u, v)
            least = min(least, math.atan2(math.sqrt(dot(n, n)), dot(u, v)))
    return math.degrees(least)


def is_watertight(triangles):
    """Each directed edge occurs once, and its reverse occurs too."""
    edges = [(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)]
    once = set(edges)
    return len(once) == len(edges) and all((b, a) in once for a, b in edges)


def pierces(p, q, a, b, c):
    """Whether the segment pq crosses the triangle abc."""
    u, v, w = subtract(b, a), subtract(c, a), subtract(p, q)
    n = cross(u, v)
    d = dot(w, n)
    if d == 0:
        return False
    e = subtract(p, a)
    f = cross(e, w)
    t, s, r = dot(e, n) / d, -dot(v, f) / d, dot(u, f) / d
    return 0 <= t <= 1 and s >= 0 and r >= 0 and s + r <= 1


def crossings(points, triangles):
    """Pairs of triangles without a common corner that cut each other."""
    boxes, cells = [], {}
    size = 3 * max(abs(x - y) for a, b, _ in triangles for x, y in zip(points[a], points[b]))
    for i, t in enumerate(triangles):
        corners = [points[k] for k in t]
        low, high = tuple(map(min, *corners)), tuple(map(max, *corners))
        boxes.append((low, high))
        spans = [range(int(l // size), int(h // size) + 1) for l, h in zip(low, high)]
        for cell in ((x, y, z) for x in spans[0] for y in spans[1] for z in spans[2]):
            cells.setdefault(cell, []).append(i)
    found = set()
    for members in cells.values():
        for place, i in enumerate(members):
            (lx, ly, lz), (hx, hy, hz) = boxes[i]
            for j in members[place + 1:]:
                (mx, my, mz), (kx, ky, kz) = boxes[j]
                if lx > kx or mx > hx or ly > ky or my > hy or lz > kz or mz > hz:
                    continue
                s, t = triangles[i], triangles[j]
                if set(s) & set(t) or (i, j) in found:
                    continue
                p, q = [points[k] for k in s], [points[k] for k in t]
                if any(pierces(p[k], p[k - 1], *q) or pierces(q[k], q[k - 1], *p)
                       for k in range(3)):
                    found.add((i, j))
    return found
