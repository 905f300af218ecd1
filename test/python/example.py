"""Two balls grow, merge, swirl and shrink, and are shown: the first session of the manual."""

import sys

import dsc
import numpy as np

centers = np.array([[-0.4, 0, 0], [0.4, 0, 0]])
film = dsc.Film("two balls")
c = dsc.Complex3.from_function(
    lambda p: (np.linalg.norm(p[:, None] - centers, axis=2).min(axis=1) < 0.3).astype(int),
    box=[(-1, -0.8, -0.8), (1, 0.8, 0.8)],
    edge=0.12,
)
for i in range(24):
    if i < 8:
        report = c.offset(0.02)
    elif i < 16:
        report = c.advect(lambda p, t: np.c_[-p[:, 1], p[:, 0], 0 * p[:, 2]] * p[:, 2:], 0.1 * i, 0.1)
    else:
        report = c.mean_curvature(0.002)
    film.add(c, 0.1 * i, report)
film.save(sys.argv[1] if len(sys.argv) > 1 else "two_balls.html")
