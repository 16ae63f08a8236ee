"""Which bearings of several passive sensors belong to one target, and where it is [Lu2015].

    PYTHONPATH=build/release/python python3 examples/04_bearings_of_passive_sensors.py
"""

# %% Four direction finders, six targets, some false alarms
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import scanfuse

noise = np.random.default_rng(2)
places = np.array([[0, 0, 0], [6000, 0, 0], [6000, 6000, 0], [0, 6000, 0]], dtype=float)
targets = np.column_stack([noise.uniform(1000, 5000, (6, 2)), noise.uniform(300, 1500, 6)])
scene = scanfuse.PassiveScene(
    [scanfuse.PassiveSensor(f"finder {k + 1}", place, sigma_azimuth_rad=0.003,
                            sigma_elevation_rad=0.003, detection_probability=0.9,
                            clutter_density=0.3) for k, place in enumerate(places)],
    volume_m=[[0, 6000], [0, 6000], [0, 2000]], expected_targets=6)

sensor, azimuth, elevation = [], [], []
for k, place in enumerate(places):
    rays = targets[noise.random(len(targets)) < 0.9] - place
    false = noise.poisson(1)
    sensor += [k] * (len(rays) + false)
    azimuth += list(np.arctan2(rays[:, 1], rays[:, 0]) + noise.normal(0, 0.003, len(rays)))
    elevation += list(np.arctan2(rays[:, 2], np.hypot(rays[:, 0], rays[:, 1])) +
                      noise.normal(0, 0.003, len(rays)))
    azimuth += list(noise.uniform(-np.pi, np.pi, false))
    elevation += list(noise.uniform(0, 0.5, false))

# %% The association, with its certificate
found = scanfuse.associate(scanfuse.BearingScan(sensor, azimuth, elevation), scene)
print(f"{len(sensor)} bearings, {len(found.fixes)} targets, gap {found.gap:.1e},",
      "proved" if found.proved else "not proved")
for fix in found.fixes:
    error = np.min(np.linalg.norm(targets - fix.position_m, axis=1))
    sigma = np.sqrt(np.trace(fix.covariance_m2))
    print(f"  target {fix.target}: {error:5.1f} m off, stated {sigma:5.1f} m,",
          f"exists with {fix.existence_probability:.3f}")

# %% The picture
figure, axes = plt.subplots(figsize=(7, 7), layout="constrained")
for k, (owner, angle, target) in enumerate(zip(sensor, azimuth, found.target_of_bearing)):
    ray = places[owner, :2] + np.outer([0, 9000], [np.cos(angle), np.sin(angle)])
    axes.plot(ray[:, 0], ray[:, 1], linewidth=0.7, color="0.8" if target < 0 else f"C{target % 10}")
axes.scatter(places[:, 0], places[:, 1], marker="^", color="black", label="sensors")
axes.scatter(targets[:, 0], targets[:, 1], marker="x", color="black", label="truth")
axes.set(xlabel="x, m", ylabel="y, m", aspect="equal", xlim=(-300, 6300), ylim=(-300, 6300))
axes.legend(loc="upper right")
figure.savefig("04_bearings_of_passive_sensors.png", dpi=70)
