"""One scan through the chain, stage by stage.

    PYTHONPATH=build/release/python python3 examples/02_stage_by_stage.py
"""

# %% A scan, and the options of all stages
import itertools

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import scanfuse

simulation = scanfuse.Simulation("road-users", seed=4)
frame = next(itertools.islice(simulation, 30, None))
options = scanfuse.Options("road-users")

# %% To one point a bearing, to clusters, to outlines, to detections
flat = scanfuse.flatten(frame.scan, options, simulation.ego_from_sensor)
labels = scanfuse.segment(flat, options)
outlines = scanfuse.outline(flat, labels, options)
detections = scanfuse.classify(outlines, options)
print(f"{len(frame.scan)} returns, {len(flat)} points, {labels.max() + 1} clusters,",
      f"{len(outlines)} outlines, {len(detections)} detections")

# %% The same cut by another method
for method in ("pag", "breakpoint", "adaptive", "euclidean"):
    options.segment.method = method
    print(f"{method:>12}: {scanfuse.segment(flat, options).max() + 1} clusters")

# %% The picture
figure, axes = plt.subplots(figsize=(9, 6), layout="constrained")
axes.scatter(flat.xy[:, 0], flat.xy[:, 1], s=6, c=labels % 20, cmap="tab20")
for detection in detections:
    corners = detection.box.corners_m
    ring = [*range(4), 0]
    axes.plot(corners[ring, 0], corners[ring, 1], color="black", linewidth=1)
    axes.annotate(f"{detection.object_class} {detection.score:.2f}", corners[0], fontsize=8)
axes.set(xlabel="x, m", ylabel="y, m", aspect="equal", xlim=(-5, 60), ylim=(-20, 20))
figure.savefig("02_stage_by_stage.png", dpi=70)
