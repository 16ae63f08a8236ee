import numpy as np
import pytest

import scanfuse


@pytest.mark.parametrize("ending", ["mcap", "csv", "jsonl"])
def test_written_tracks_read_back(tmp_path, drive, results, ending):
    path = tmp_path / f"tracks.{ending}"
    with scanfuse.TrackWriter(path) as writer:
        for result, scan in zip(results, drive[1]):
            writer.write(result, scan.scan)
        assert not path.exists()
    back = scanfuse.to_columns(scanfuse.read_tracks(path))
    ids = scanfuse.to_columns(results)["track_id"]
    assert np.array_equal(back["track_id"], ids)


def test_an_exception_leaves_no_file(tmp_path, results):
    path = tmp_path / "tracks.csv"
    with pytest.raises(KeyboardInterrupt):
        with scanfuse.TrackWriter(path) as writer:
            writer.write(results[0])
            raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(scanfuse.Error, match="closed"):
        writer.write(results[0])


def test_a_recording_is_an_iterator_of_posed_scans(tmp_path, drive, results):
    path = tmp_path / "run.mcap"
    with scanfuse.TrackWriter(path) as writer:
        for result, scan in zip(results, drive[1]):
            writer.write(result, scan.scan)
    recording = scanfuse.Recording(path)
    assert recording.format == "mcap"
    scans = list(recording)
    assert len(scans) == len(drive[1])
    assert np.allclose(scans[7].scan.xyz, drive[1][7].scan.xyz, atol=1e-4)


def test_truth_and_detections_read_back(tmp_path, drive, results):
    truth = [frame.truth for frame in drive[0]]
    scanfuse.write_truth(tmp_path / "truth.csv", truth)
    back = scanfuse.read_truth(tmp_path / "truth.csv")
    assert [len(f.objects) for f in back] == [len(f.objects) for f in truth if f.objects]
    frames = [scanfuse.DetectionFrame(r.stamp_s, r.frame, r.detections) for r in results]
    scanfuse.write_detections(tmp_path / "detections.csv", frames)
    again = scanfuse.read_detections(tmp_path / "detections.csv")
    assert sum(len(f.detections) for f in again) == sum(len(r.detections) for r in results)


def test_errors_have_the_text_of_the_command_line(tmp_path):
    with pytest.raises(scanfuse.Error, match="no such file"):
        scanfuse.Recording(tmp_path / "absent.mcap")
    broken = tmp_path / "broken.mcap"
    broken.write_bytes(b"nothing of the kind")
    with pytest.raises(ValueError, match="broken.mcap"):
        scanfuse.Recording(broken)
    with pytest.raises(scanfuse.Error, match="csv"):
        scanfuse.TrackWriter(tmp_path / "tracks.doc")
