"""Results as tables."""

import numpy as np

_COLUMNS = (
    ("frame", np.int64),
    ("time_s", np.float64),
    ("track_id", np.int64),
    ("class", object),
    ("class_probability", np.float64),
    ("status", object),
    ("x_m", np.float64),
    ("y_m", np.float64),
    ("heading_rad", np.float64),
    ("length_m", np.float64),
    ("width_m", np.float64),
    ("vx_m_per_s", np.float64),
    ("vy_m_per_s", np.float64),
    ("speed_m_per_s", np.float64),
    ("moving_probability", np.float64),
    ("var_x_m2", np.float64),
    ("var_y_m2", np.float64),
    ("cov_xy_m2", np.float64),
    ("var_vx_m2_per_s2", np.float64),
    ("var_vy_m2_per_s2", np.float64),
    ("nis", np.float64),
    ("age_frames", np.int64),
    ("missed_frames", np.int64),
)


def _row(result, track):
    box, state, covariance = track.box, track.state, track.covariance
    return (
        result.frame,
        result.stamp_s,
        track.id,
        track.object_class,
        track.class_probability,
        track.status,
        box.centre_m[0],
        box.centre_m[1],
        box.heading_rad,
        box.length_m,
        box.width_m,
        state[1],
        state[3],
        track.speed_m_per_s,
        track.moving_probability,
        covariance[0, 0],
        covariance[2, 2],
        covariance[0, 2],
        covariance[1, 1],
        covariance[3, 3],
        track.nis,
        track.age_frames,
        track.missed_frames,
    )


def to_columns(results):
    """The tracks of StepResults as a dict of numpy arrays, one row a track and scan."""
    rows = [_row(result, track) for result in results for track in result.tracks]
    values = zip(*rows) if rows else ([] for _ in _COLUMNS)
    return {name: np.array(column, dtype=kind) for (name, kind), column in zip(_COLUMNS, values)}


def to_dataframe(results):
    """The same as a pandas DataFrame; an ImportError where pandas is not installed."""
    import pandas

    return pandas.DataFrame(to_columns(results))
