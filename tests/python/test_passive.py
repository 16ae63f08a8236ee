import numpy as np
import pytest

import scanfuse

PLACES = np.array([[0, 0, 0], [4000, 0, 0], [0, 4000, 0]], dtype=float)


def scene():
    sensors = [
        scanfuse.PassiveSensor(f"s{k}", place, sigma_azimuth_rad=0.002, sigma_elevation_rad=0.002,
                               detection_probability=0.95, clutter_density=0.1)
        for k, place in enumerate(PLACES)
    ]
    return scanfuse.PassiveScene(sensors, [[0, 4000], [0, 4000], [100, 2000]], 3)


def bearings(targets, scan=0, stamp_s=0.0, seed=0):
    noise = np.random.default_rng(seed)
    sensor, azimuth, elevation = [], [], []
    for k, place in enumerate(PLACES):
        for target in targets:
            ray = np.asarray(target) - place
            sensor.append(k)
            azimuth.append(np.arctan2(ray[1], ray[0]) + noise.normal(0, 0.002))
            elevation.append(np.arctan2(ray[2], np.hypot(ray[0], ray[1])) + noise.normal(0, 0.002))
    return scanfuse.BearingScan(sensor, azimuth, elevation, scan=scan, stamp_s=stamp_s)


def test_bearings_meet_where_the_targets_are():
    targets = np.array([[1000.0, 1500, 800], [2500, 900, 500], [1800, 2900, 1200]])
    found = scanfuse.associate(bearings(targets), scene())
    assert found.proved and found.gap < 1e-9
    assert len(found.fixes) == 3
    assert found.target_of_bearing.shape == (9,)
    for fix in found.fixes:
        error = targets - fix.position_m
        nis = np.min(np.einsum("ni,ij,nj->n", error, np.linalg.inv(fix.covariance_m2), error))
        assert nis < 20  # chi-square, 3 degrees of freedom: 1.7e-4


def test_the_tracker_keeps_its_numbers():
    tracker = scanfuse.PassiveTracker(scene())
    start, velocity = np.array([1000.0, 1500, 800]), np.array([40.0, -20, 0])
    for k in range(15):
        tracks = tracker.step(bearings([start + velocity * k], k, float(k), seed=k))
    (track,) = [t for t in tracks if t.confirmed]
    assert track.state[3:] == pytest.approx(velocity, abs=8)


def test_what_cannot_be_is_an_error():
    with pytest.raises(scanfuse.Error, match="two or more"):
        scanfuse.PassiveScene([scanfuse.PassiveSensor("a", [0, 0, 0])])
    with pytest.raises(scanfuse.Error, match="sensor 7"):
        scanfuse.associate(scanfuse.BearingScan([7], [0.1]), scene())
    with pytest.raises(scanfuse.Error, match="no angle"):
        scanfuse.BearingScan([0], [np.nan])
    with pytest.raises(scanfuse.Error, match="one shape"):
        scanfuse.BearingScan([0, 1], [0.1])
