import pathlib
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("script", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_an_example_runs_and_draws(script, tool, tmp_path):
    pytest.importorskip("matplotlib")
    if "turntable" in script.stem:
        subprocess.run([tool, "simulate", "turntable", "-o", tmp_path / "session", "--features-only",
                        "--discs", "1"], check=True, capture_output=True)
    run = subprocess.run([sys.executable, "-B", script], cwd=tmp_path, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout.strip()
    assert (tmp_path / f"{script.stem}.png").stat().st_size > 5000
