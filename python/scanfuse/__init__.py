"""Tracks from raw scans and bearings, with uncertainty: numpy in, numpy out.

    import scanfuse

    chain = scanfuse.Pipeline("road-users")
    for scan in scanfuse.Recording("drive.mcap"):
        for track in chain.step(scan).tracks:
            print(track.id, track.object_class, track.position_m, track.velocity_m_per_s)

Units are SI, angles radians, frames right-handed (x forward, y left, z up). What goes wrong is a
`scanfuse.Error` (a ValueError) with the text that the command line prints.
"""

from ._scanfuse import *  # noqa: F401,F403
from ._scanfuse import Error, __version__  # noqa: F401
from .tables import to_columns, to_dataframe  # noqa: F401
