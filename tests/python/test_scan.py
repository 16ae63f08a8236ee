import gc

import numpy as np
import pytest

import scanfuse


def test_points_come_back_without_a_copy():
    points = np.array([[1, 2, 3], [4, 5, 6]], dtype=np.float32)
    scan = scanfuse.Scan(points, stamp_s=12.5, intensity=[7, 8], layer=[0, 1])
    assert np.array_equal(scan.xyz, points)
    assert np.shares_memory(scan.xyz, scan.returns)
    assert not scan.xyz.flags.writeable
    assert scan.returns["intensity"].tolist() == [7, 8]
    assert scan.returns["layer"].tolist() == [0, 1]
    assert scan.stamp_ns == 12_500_000_000


def test_an_array_outlives_its_scan():
    xyz = scanfuse.Scan([[1.0, 2.0], [3.0, 4.0]]).xyz
    gc.collect()
    assert xyz.tolist() == [[1, 2, 0], [3, 4, 0]]


def test_points_that_are_not_finite_are_dropped():
    scan = scanfuse.Scan([[1.0, 2.0], [np.nan, 0.0], [np.inf, 1.0]])
    assert len(scan) == 1


def test_an_empty_scan_has_empty_arrays():
    scan = scanfuse.Scan(np.zeros((0, 2)))
    assert scan.xyz.shape == (0, 3)
    assert len(scanfuse.Pipeline().step(scan).tracks) == 0


def test_ranges_are_beams_in_both_directions():
    ranges = [1.0, np.inf, 2.0, np.nan]
    left = scanfuse.Scan.from_ranges(ranges, angle_min_rad=0, angle_increment_rad=0.1)
    right = scanfuse.Scan.from_ranges(ranges, angle_min_rad=0, angle_increment_rad=-0.1)
    assert left.returns["beam"].tolist() == [0, 2]
    assert right.returns["beam"].tolist() == [3, 1]
    assert left.xyz[1] == pytest.approx([2 * np.cos(0.2), 2 * np.sin(0.2), 0], abs=1e-6)
    assert right.xyz[1] == pytest.approx([2 * np.cos(0.2), -2 * np.sin(0.2), 0], abs=1e-6)


@pytest.mark.parametrize("points", [[1.0, 2.0], [[1.0]], np.zeros((2, 4))])
def test_other_shapes_are_errors(points):
    with pytest.raises(scanfuse.Error, match="shape"):
        scanfuse.Scan(points)


def test_columns_of_another_length_are_errors():
    with pytest.raises(scanfuse.Error, match="3 values for 1 points"):
        scanfuse.Scan([[1.0, 2.0]], intensity=[1, 2, 3])


def test_poses_must_be_rigid():
    scan = scanfuse.Scan([[1.0, 2.0]])
    turned = np.diag([-1.0, -1, 1, 1])
    assert np.allclose(scanfuse.PosedScan(scan, world_from_ego=turned).world_from_ego, turned)
    for wrong in (np.diag([2.0, 1, 1, 1]), np.diag([-1.0, 1, 1, 1]), np.full((4, 4), np.nan)):
        with pytest.raises(scanfuse.Error, match="4 x 4"):
            scanfuse.PosedScan(scan, world_from_ego=wrong)
