"""Glazunov's grid for Gough's platform as one would scan it with NumPy: all orientations of a point at once, the cheap limits first, the
distances of what is left. See README.md. Argument: the step of the grid [m], 0.1 where there is none."""

import sys
import time

import numpy as np

step = float(sys.argv[1]) if len(sys.argv) > 1 else 0.1
deg = np.pi / 180
middles = np.repeat(np.array([-150, -30, 90]) * deg, 2)
sides = np.tile([-1, 1], 3)


def ring(radius, angles):
    return radius * np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)


a = ring(0.3, middles + sides * 10.6 * deg)
b = ring(0.2, middles + sides * (60 - 15.2) * deg)
turns = np.arange(-6, 7) * 10 * deg
alpha, beta, gamma = (x.ravel() for x in np.meshgrid(turns, turns, turns, indexing="ij"))
ca, sa, cb, sb, cc, sc = np.cos(alpha), np.sin(alpha), np.cos(beta), np.sin(beta), np.cos(gamma), np.sin(gamma)
# By turns about z, x and y, as the mechanism has them.
rotations = np.stack([np.stack([ca * cc - sa * sb * sc, -sa * cb, ca * sc + sa * sb * cc], -1),
                      np.stack([sa * cc + ca * sb * sc, ca * cb, sa * sc - ca * sb * cc], -1),
                      np.stack([-cb * sc, sb, cb * cc], -1)], 1)
pairs = [(i, j) for i in range(6) for j in range(i + 1, 6)]


def apart(p, d, q, e):
    """Whether segments p + s d, q + t e are 0.1 m apart or more."""
    dot = lambda u, v: np.einsum("...i,...i->...", u, v)
    r = p - q
    aa, bb, ee, c, f = dot(d, d), dot(d, e), dot(e, e), dot(d, r), dot(e, r)
    s = np.clip((bb * f - c * ee) / np.maximum(aa * ee - bb * bb, 1e-12 * aa * ee), 0, 1)
    t = np.clip((bb * s + f) / ee, 0, 1)
    s = np.clip((bb * t - c) / aa, 0, 1)
    w = r + s[..., None] * d - t[..., None] * e
    return dot(w, w) >= 0.01 - 1e-12


def scan(platform, normal, values, heights):
    accepted = poses = 0
    for x in values:
        for y in values:
            for z in heights:
                v = np.array([x, y, z]) + platform - a
                squared = np.einsum("oli,oli->ol", v, v)
                up = np.einsum("oli,oi->ol", v, normal)
                good = ((squared >= 0.76**2 - 1e-12) & (squared <= 1.41**2 + 1e-12) & (v[..., 2] >= 0) & (up >= 0)
                        & (v[..., 2]**2 >= 0.25 * squared - 1e-12) & (up**2 >= 0.25 * squared - 1e-12)).all(axis=1)
                poses += len(good)
                legs = v[good]
                for i, j in pairs:
                    if len(legs) == 0:
                        break
                    legs = legs[apart(a[i], legs[:, i], a[j], legs[:, j])]
                accepted += len(legs)
    return poses, accepted


n = round(3.2 / step) + 1
grid = -1.6 + step * np.arange(n)
heights = step * np.arange(1, round(1.6 / step) + 2)
# The platform's joints and normal at every orientation, once for all points.
platform = np.einsum("oij,lj->oli", rotations, b)
normal = rotations[:, :, 2]
start = time.perf_counter()
poses, accepted = scan(platform, normal, grid, heights)
seconds = time.perf_counter() - start
print(f"gough by NumPy {np.__version__}: {1e-6 * poses:.1f} million poses in {seconds:.2f} s, {1e-6 * poses / seconds:.1f} Mposes/s, "
      f"{accepted} accepted")
