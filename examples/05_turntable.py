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

# %% How sure the axis is, and the points on the disc
sigmas = np.sqrt(np.diag(rig.covariance)[:2])
print(f"axis direction +- {np.degrees(np.linalg.norm(sigmas)):.4f} deg")
near = cloud.xyz[np.linalg.norm(cloud.xyz - disc["centre_m"], axis=1) < 0.25]
right = np.cross([0, 1, 0], disc["normal"])
right /= np.linalg.norm(right)
axes_of_plane = np.stack([right, np.cross(right, disc["normal"])], axis=1)
flat = 1e3 * (near - disc["centre_m"]) @ axes_of_plane
figure, axes = plt.subplots(figsize=(7, 6), layout="constrained")
points = axes.scatter(*flat.T, s=2, c=near[:, 2], cmap="viridis")
radius = 1e3 * float(disc["diameter_m"]) / 2
axes.add_patch(plt.Circle((0, 0), radius, fill=False, color="red"))
axes.set(xlabel="in its plane, mm", ylabel="in its plane, mm", aspect="equal",
         title=f"disc of {2 * radius:.2f} +- {1e3 * disc['diameter_m'].sigma:.2f} mm")
figure.colorbar(points, label="distance ahead, m")
figure.savefig("05_turntable.png", dpi=70)
