import subprocess

import numpy as np
import pytest

import scanfuse


@pytest.fixture(scope="module")
def session(tmp_path_factory, tool):
    folder = tmp_path_factory.mktemp("rig") / "session"
    subprocess.run([tool, "simulate", "turntable", "-o", folder, "--seed", "5", "--features-only", "--discs", "1"],
                   check=True, capture_output=True)
    return folder


def test_from_a_session_to_a_measured_cloud(session, tmp_path):
    found = scanfuse.calibrate_turntable(session)
    assert found.converged and found.positions_used > 60
    assert np.linalg.norm(found.rig.axis_direction) == pytest.approx(1)
    assert np.linalg.norm(found.rig.pose(0.3)[:3, 3] - found.rig.pose(0)[:3, 3]) > 0
    found.rig.write(tmp_path / "rig.toml")
    rig = scanfuse.read_rig(tmp_path / "rig.toml")
    cloud = scanfuse.assemble(session / "scan", rig)
    assert cloud.xyz.shape == (len(cloud), 3) and np.isfinite(cloud.xyz).all()
    cloud.write(tmp_path / "cloud.ply")
    assert len(scanfuse.read_cloud(tmp_path / "cloud.ply")) == len(cloud)
    disc = scanfuse.measure_disc(cloud, rig=rig)
    assert float(disc["diameter_m"]) == pytest.approx(0.140, abs=0.001)


def test_a_folder_that_is_no_session_is_an_error(tmp_path):
    with pytest.raises(scanfuse.Error, match="session.toml"):
        scanfuse.calibrate_turntable(tmp_path)
