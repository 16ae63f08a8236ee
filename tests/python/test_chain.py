import threading

import numpy as np
import pytest

import scanfuse


def test_the_pipeline_follows_the_cars(drive, results):
    truth = [frame.truth for frame in drive[0]]
    road = scanfuse.EvaluateOptions(min_visible_points=3, region_y0_m=-2, region_y1_m=5.4)
    score = scanfuse.evaluate(results, truth, road)
    assert score["frames"] == 60
    assert score["clear"]["MOTA"] > 0.8
    assert score["rmse"]["position_m"] < 0.5


def test_stages_one_by_one_give_what_the_pipeline_gives(drive):
    options = scanfuse.Options("vehicle-pag")
    scan = drive[1][20]
    flat = scanfuse.flatten(scan.scan, options, scan.ego_from_sensor)
    assert np.shares_memory(flat.xy, flat.points)
    assert np.all(np.diff(flat.points["bearing_rad"]) >= 0)
    labels = scanfuse.segment(flat, options)
    assert labels.shape == (len(flat),) and labels.max() > 3
    outlines = scanfuse.outline(flat, labels, options)
    assert sum(outline.points for outline in outlines) == np.count_nonzero(labels >= 0)
    detections = scanfuse.classify(outlines, options)
    chain = scanfuse.Pipeline(options)
    expected = chain.step(scanfuse.PosedScan(scan.scan, ego_from_sensor=scan.ego_from_sensor))
    assert len(detections) == len(expected.detections) > 0


def test_labels_of_another_length_are_errors(drive):
    flat = scanfuse.flatten(drive[1][0].scan)
    with pytest.raises(scanfuse.Error, match="labels for"):
        scanfuse.outline(flat, [0, 1])


def test_the_tracker_takes_detections_of_any_detector():
    tracker = scanfuse.Tracker(scanfuse.Options("road-users"))
    for k in range(30):
        box = scanfuse.Box(10 + 0.5 * k, 2, 0, 4.4, 1.8)
        tracks = tracker.step(0.1 * k, [scanfuse.Detection(box, "vehicle", 0.9)])
    (track,) = [t for t in tracks if t.status == "confirmed"]
    assert track.velocity_m_per_s == pytest.approx([5, 0], abs=0.5)
    assert track.position_m == pytest.approx([24.5, 2], abs=0.5)
    assert np.all(np.linalg.eigvalsh(track.covariance) > 0)


def test_an_unknown_class_is_an_error():
    with pytest.raises(scanfuse.Error, match="pedestrian"):
        scanfuse.Detection(scanfuse.Box(), "pedestrain")


def test_the_same_scans_give_the_same_tracks_in_any_thread(drive, results):
    found = {}

    def run(name):
        chain = scanfuse.Pipeline("vehicle-pag")
        found[name] = scanfuse.to_columns([chain.step(scan) for scan in drive[1]])

    threads = [threading.Thread(target=run, args=(name,)) for name in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for columns in found.values():
        for name, values in scanfuse.to_columns(results).items():
            assert np.array_equal(columns[name], values), name


def test_tracks_are_a_data_frame(results):
    pandas = pytest.importorskip("pandas")
    frame = scanfuse.to_dataframe(results)
    assert isinstance(frame, pandas.DataFrame)
    assert len(frame) == sum(len(result.tracks) for result in results)
    confirmed = frame[frame.status == "confirmed"]
    assert set(confirmed["class"]) == {"vehicle"}
    assert scanfuse.to_dataframe([]).columns.tolist() == frame.columns.tolist()


def test_assignments_are_the_cheapest():
    cost = np.array([[4.0, 1, 3], [2, 0, 5], [3, 2, 2]])
    assert scanfuse.assign(cost).tolist() == [1, 0, 2]
    assert scanfuse.assign(np.full((2, 2), np.inf)).tolist() == [-1, -1]
