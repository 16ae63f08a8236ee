#!/usr/bin/env python3
"""Fails when a room includes a room it may not know, or a public header shows a hidden library."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
STAGES = {"preprocess", "segment", "shape", "classify", "estimate", "associate", "track",
          "triangulate", "evaluate", "calibrate", "camera", "drivers", "simulate", "io", "report"}
LOW = {"core", "geometry", "types"}
MAY_USE = {
    "core": set(),
    "geometry": {"core"},
    "types": {"core", "geometry"},
    **{stage: set(LOW) for stage in STAGES},
    "pipeline": LOW | STAGES,
    "serve": LOW | STAGES | {"pipeline"},
}
# The written exceptions.
MAY_USE["track"] |= {"estimate", "associate"}
MAY_USE["triangulate"] |= {"estimate", "associate"}
MAY_USE["simulate"] |= {"estimate", "shape"}
MAY_USE["calibrate"] |= {"estimate", "shape"}
PUBLIC_LIBRARIES = ("Eigen/", "tl/expected.hpp", "fmt/")

problems = []
for path in sorted((ROOT / "scanfuse").rglob("*.[ch]pp")):
    room = path.relative_to(ROOT / "scanfuse").parts[0]
    if room not in MAY_USE:
        problems.append(f"{path.relative_to(ROOT)}: room '{room}' has no place in the layers")
        continue
    for number, line in enumerate(path.read_text().splitlines(), 1):
        include = re.match(r'#include [<"]([^>"]+)[>"]', line)
        if not include:
            continue
        target = include.group(1)
        where = f"{path.relative_to(ROOT)}:{number}"
        if target.startswith("scanfuse/"):
            other = target.split("/")[1]
            if other != room and other not in MAY_USE[room]:
                problems.append(f"{where}: room '{room}' may not include room '{other}'")
        elif path.suffix == ".hpp" and "/" in target and not target.startswith(PUBLIC_LIBRARIES):
            problems.append(f"{where}: a public header shows {target}")

for path in sorted(ROOT.glob("scanfuse/**/*.[ch]pp")) + sorted(ROOT.glob("apps/**/*.[ch]pp")):
    lines = len(path.read_text().splitlines())
    if lines > 400:
        problems.append(f"{path.relative_to(ROOT)}: {lines} lines; split past 400")

# Every [Key] of a comment that looks like a source must stand in the bibliography.
bibliography = (ROOT / "docs/references.bib").read_text()
keys = set(re.findall(r"@\w+\{([^,]+),", bibliography))
for path in sorted(ROOT.glob("scanfuse/**/*.[ch]pp")):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        for key in re.findall(r"\[([A-Z][A-Za-z]+\d{4}|Guo)[,\]]", line):
            if key not in keys:
                problems.append(f"{path.relative_to(ROOT)}:{number}: [{key}] is not in docs/references.bib")

print("\n".join(problems) or "layers, lengths and citations are fine")
sys.exit(bool(problems))
