"""The tracker on detections of your own, and whether its covariance can be trusted.

    PYTHONPATH=build/release/python python3 examples/03_your_own_detector.py
"""

# %% A detector that errs by 0.2 m and misses one object of ten
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import scanfuse

noise = np.random.default_rng(1)
covariance = np.diag([0.2**2, 0.2**2, 0.05**2])


def detections_at(time_s):
    found = []
    for lane_m, speed in ((-1.75, 12.0), (1.75, 15.0)):
        if noise.random() < 0.9:
            x, y = noise.normal([speed * time_s, lane_m], 0.2)
            box = scanfuse.Box(x, y, noise.normal(0, 0.05), 4.4, 1.8)
            found.append(scanfuse.Detection(box, "vehicle", 0.9, covariance))
    return found


# %% Ten seconds of it
tracker = scanfuse.Tracker(scanfuse.Options("road-users"))
times = np.arange(0, 10, 0.1)
steps = [tracker.step(time_s, detections_at(time_s)) for time_s in times]
print(f"{len({track.id for tracks in steps for track in tracks})} tracks of two cars")

# %% The innovations: with a right covariance their squares follow chi-square of 2
nis = np.array([t.nis for tracks in steps for t in tracks if t.detection >= 0 and t.age_frames > 5])
print(f"mean NIS {nis.mean():.2f} (2 is right), below 5.99: {np.mean(nis < 5.99):.3f} (0.95)")

# %% The picture
figure, axes = plt.subplots(figsize=(9, 4), layout="constrained")
axes.hist(nis, bins=40, range=(0, 12), density=True, color="tab:blue", alpha=0.6, label="measured")
x = np.linspace(0, 12, 200)
axes.plot(x, np.exp(-x / 2) / 2, color="black", label="chi-square, 2 degrees of freedom")
axes.set(xlabel="NIS", ylabel="density")
axes.legend()
figure.savefig("03_your_own_detector.png", dpi=70)
