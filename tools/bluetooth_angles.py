#!/usr/bin/env python3
"""Bluetooth angles of arrival (Girolami et al., Zenodo 7759557) as bearings of passive sensors.

    tools/bluetooth_angles.py BEACONS [--truth WAYPOINTS] -o FOLDER [--window-s 0.5]
                              [--sigma-deg 10 | --sigma-deg 6501:6,6502:13,6503:6,6504:13]

BEACONS: lines `t_ms,tag,rssi,azimuth_deg,elevation_deg,rssi2,channel,locator`. WAYPOINTS: lines
`t_ms,t_end_ms or NaN,x_cm,y_cm`; the person walks evenly from one to the next. Written into FOLDER:
bearings.csv, sensors.toml and, with WAYPOINTS, bearings.truth.csv. One scan a window, a locator's
bearing the median of its angles there; scans outside the waypoints' time are left out.

The locators' azimuth counts clockwise from where they face. Elevations are not used: they err by
as much as the room is high.
"""
import argparse
import math
import os
import statistics
import sys

# name: x_m, y_m, facing (degrees), in a room of 12 x 6 m
LOCATORS = {"6501": (0, 3, 0), "6502": (6, 0, 90), "6503": (12, 3, 180), "6504": (6, 6, -90)}


def fail(message):
    print(message, file=sys.stderr)
    sys.exit(2)


def rows(path, columns):
    """Lines with so many columns; others are counted, not guessed at."""
    skipped = 0
    with open(path, encoding="utf-8") as file:
        for line in file:
            cells = line.strip().split(",")
            if len(cells) == columns:
                yield cells
            elif line.strip():
                skipped += 1
    if skipped:
        print(f"{path}: {skipped} lines without {columns} columns skipped", file=sys.stderr)


def read_beacons(path, window_s):
    """{window: {locator: azimuth_rad}}"""
    angles = {}
    for t_ms, _tag, _rssi, azimuth, _elevation, _rssi2, _channel, locator in rows(path, 8):
        if locator in LOCATORS:
            window = angles.setdefault(int(int(t_ms) / 1000 / window_s), {})
            window.setdefault(locator, []).append(-math.radians(float(azimuth)))
    return {
        k: {name: statistics.median(values) for name, values in window.items()}
        for k, window in sorted(angles.items())
    }


def read_waypoints(path):
    points = []
    for t_ms, t_end_ms, x_cm, y_cm in rows(path, 4):
        place = (float(x_cm) / 100, float(y_cm) / 100)
        points.append((float(t_ms) / 1000, *place))
        if t_end_ms != "NaN":
            points.append((float(t_end_ms) / 1000, *place))
    return sorted(points)


def place_at(points, t):
    for (t0, x0, y0), (t1, x1, y1) in zip(points, points[1:]):
        if t0 <= t <= t1:
            part = (t - t0) / (t1 - t0) if t1 > t0 else 0
            return x0 + part * (x1 - x0), y0 + part * (y1 - y0)
    return None


def sigmas_of(text):
    """A figure for all, or one for each: 6501:6,6502:13"""
    if ":" not in text:
        return {name: float(text) for name in LOCATORS}
    given = dict(part.split(":") for part in text.split(","))
    return {name: float(given.get(name, 10)) for name in LOCATORS}


def write_sensors(path, sigmas):
    with open(path, "w", encoding="utf-8") as file:
        for name, (x, y, facing) in LOCATORS.items():
            file.write(
                f'[[sensor]]\nname = "{name}"\nposition_m = [{x}, {y}, 1.5]\n'
                f"orientation_rad = [{math.radians(facing):.6f}, 0, 0]\n"
                f"sigma_azimuth_rad = {math.radians(sigmas[name]):.6f}\n"
                "detection_probability = 0.98\nclutter_per_rad = 0.01\n"
                f"field_of_view_azimuth_rad = {math.pi:.6f}\n\n"
            )
        file.write("[scene]\nvolume_m = [[0, 12], [0, 6], [0, 3]]\nexpected_targets = 1\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("beacons")
    parser.add_argument("--truth", help="waypoints of the person")
    parser.add_argument("-o", "--out", required=True, help="folder to write into")
    parser.add_argument("--window-s", type=float, default=0.5)
    parser.add_argument("--sigma-deg", default="10")
    arguments = parser.parse_args()
    if not 0.01 <= arguments.window_s <= 60:
        fail("--window-s: 0.01 to 60")
    try:
        sigmas = sigmas_of(arguments.sigma_deg)
        scans = read_beacons(arguments.beacons, arguments.window_s)
        points = read_waypoints(arguments.truth) if arguments.truth else []
    except (OSError, ValueError) as error:
        fail(f"bluetooth_angles: {error}")
    if not scans:
        fail(f"{arguments.beacons}: no angles of locators {', '.join(LOCATORS)}")
    os.makedirs(arguments.out, exist_ok=True)
    write_sensors(os.path.join(arguments.out, "sensors.toml"), sigmas)
    bearings = ["scan,time_s,sensor,measurement,azimuth_rad,elevation_rad"]
    truth = ["frame,time_s,object_id,class,x_m,y_m"]
    for k, window in scans.items():
        t = (k + 0.5) * arguments.window_s
        place = place_at(points, t)
        if points and place is None:
            continue
        for name, azimuth in sorted(window.items()):
            bearings.append(f"{k},{t:.3f},{name},0,{azimuth:.6f},")
        if place is not None:
            truth.append(f"{k},{t:.3f},1,pedestrian,{place[0]:.3f},{place[1]:.3f}")
    for name, lines in (("bearings.csv", bearings), ("bearings.truth.csv", truth)):
        if len(lines) > 1:
            with open(os.path.join(arguments.out, name), "w", encoding="utf-8") as file:
                file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
