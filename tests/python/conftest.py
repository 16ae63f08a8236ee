import itertools
import os

import pytest

import scanfuse


@pytest.fixture(scope="session")
def drive():
    """The first 60 frames of a simulated road with two cars, and what takes its scans."""
    simulation = scanfuse.Simulation("lu2018-1", seed=3)
    frames = list(itertools.islice(simulation, 60))
    return frames, [simulation.posed(frame) for frame in frames]


@pytest.fixture(scope="session")
def results(drive):
    chain = scanfuse.Pipeline("vehicle-pag")
    return [chain.step(scan) for scan in drive[1]]


@pytest.fixture(scope="session")
def tool():
    """The command line tool of the same build."""
    return os.environ.get("SCANFUSE_TOOL", "scanfuse")
