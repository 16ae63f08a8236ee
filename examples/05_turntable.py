"""Calibrate a 2D lidar on a turntable and measure in its cloud [Liu2023].

    build/release/scanfuse simulate turntable -o session --features-only --discs 1
    PYTHONPATH=build/release/python python3 examples/05_turntable.py session
"""

# %% The rig, from a session
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import scanfuse

session = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "session")
found = scanfuse.calibrate_turntable(session)
rig = found.rig
print(f"{found.positions_used} positions, rms {found.rms}, chi2 {found.chi2_per_dof:.3f}")
print("axis", rig.axis_direction, "through", rig.axis_point_m)
for warning in found.warnings:
    print("note:", warning)

# %% Its scans as one cloud, and the disc in it
cloud = scanfuse.assemble(session / "scan", rig)
disc = scanfuse.measure_disc(cloud, rig=rig)
print(f"{len(cloud)} points; disc {disc['diameter_m']!r} m at {disc['centre_m']}")

# %% How sure the axis is, and what the cloud looks like
sigmas = np.sqrt(np.diag(rig.covariance)[:2])
print(f"axis direction +- {np.degrees(np.linalg.norm(sigmas)):.4f} deg")
figure = plt.figure(figsize=(8, 6), layout="constrained")
axes = figure.add_subplot(projection="3d")
thin = cloud.xyz[:: max(1, len(cloud) // 20000)]
axes.scatter(thin[:, 0], thin[:, 2], -thin[:, 1], s=1, c=thin[:, 2], cmap="viridis")
axes.set_box_aspect(np.ptp(thin, axis=0)[[0, 2, 1]])
axes.set(xlabel="right, m", ylabel="ahead, m", zlabel="up, m")
figure.savefig("05_turntable.png", dpi=70)
