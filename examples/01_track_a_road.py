"""Track a road and score it.

Simulates a road with two cars as an ibeo LUX sees it (or reads a recording), tracks it, scores the tracks against the
truth, and draws what was found.

    PYTHONPATH=build/release/python python3 examples/01_track_a_road.py [RECORDING]
"""

# %% Scans: a recording, or simulated ones with their truth
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import scanfuse

truth = []
if len(sys.argv) > 1:
    scans = scanfuse.Recording(sys.argv[1])
else:
    simulation = scanfuse.Simulation("lu2018-2", seed=7)
    frames = list(simulation)
    scans = [simulation.posed(frame) for frame in frames]
    truth = [frame.truth for frame in frames]

# %% The chain, scan by scan
chain = scanfuse.Pipeline("vehicle-pag")
results = [chain.step(scan) for scan in scans]
print(f"{len(results)} scans, {sum(len(r.detections) for r in results)} detections")

# %% How good it is
if truth:
    options = scanfuse.EvaluateOptions(min_visible_points=3, region_y0_m=-2, region_y1_m=5.4)
    score = scanfuse.evaluate(results, truth, options)
    print(f"MOTA {score['clear']['MOTA']:.3f}, {score['clear']['IDSW']} switches,",
          f"position {score['rmse']['position_m']:.2f} m")

# %% What it looks like
tracks = scanfuse.to_columns(results)
shown = tracks["status"] == "confirmed"
figure, (above, below) = plt.subplots(2, 1, figsize=(9, 6), layout="constrained")
for track_id in sorted(set(tracks["track_id"][shown])):
    of = shown & (tracks["track_id"] == track_id)
    above.plot(tracks["x_m"][of], tracks["y_m"][of], label=f"track {track_id}")
    below.plot(tracks["time_s"][of] - tracks["time_s"][0], tracks["speed_m_per_s"][of])
above.set(xlabel="x, m", ylabel="y, m", title="where the tracks went")
above.legend(loc="upper left", ncols=6, fontsize="small")
below.set(xlabel="time, s", ylabel="speed, m/s")
figure.savefig("01_track_a_road.png", dpi=70)
