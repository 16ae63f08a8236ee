#!/bin/sh
# Runs the tool over every recording in DATA that its formats cover and prints one row for each:
#   tools/try_recordings.sh TOOL DATA [KITTI_BIN_FOLDER]
# A row fails when `info --json` or `track` crashes, hangs, writes nan or inf, or ends with another
# exit code than expected. Exit code 1 when any row failed.
tool=$1 data=$2 kitti=$3
[ -x "$tool" ] && [ -d "$data" ] || { echo "usage: $0 TOOL DATA [KITTI_BIN_FOLDER]" >&2; exit 2; }
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
failed=0

# one NAME EXPECTED_CODES INPUT [OPTION...]
one() {
  name=$1 expected=$2 input=$3
  shift 3
  timeout 60 "$tool" info --json "$input" >"$work/info.json" 2>"$work/info.err"
  info=$?
  timeout 120 "$tool" track "$input" "$@" --json -o "$work/t.csv" -o "$work/t.mcap" \
    -o "$work/t.jsonl" --detections "$work/d.csv" >"$work/track.json" 2>"$work/track.err"
  code=$?
  verdict=ok
  case " $expected " in *" $code "*) ;; *) verdict="FAILED: exit $code" ;; esac
  case " 0 2 3 " in *" $info "*) ;; *) verdict="FAILED: info exit $info" ;; esac
  if grep -qiwE '[-+]?(nan|inf|infinity)' "$work"/t.csv "$work"/t.jsonl "$work"/d.csv \
    "$work"/track.json "$work"/info.json 2>/dev/null; then
    verdict="FAILED: nan or inf written"
  fi
  [ "$verdict" = ok ] || failed=1
  value() { sed -n "s/^ *\"$1\": *\([-0-9.e]*\),*$/\1/p" "$work/track.json" | head -1; }
  printf '%-52s %4s %4s %6s %8s %9s  %s %s\n' "$name" "$info" "$code" "$(value scans)" \
    "$(value confirmed_tracks)" "$(value median)" "$verdict" "$(head -c 160 "$work/track.err" | head -1)"
  rm -f "$work"/t.* "$work"/d.*
}

printf '%-52s %4s %4s %6s %8s %9s\n' recording info code scans tracks median_s
for bag in "$data"/datmo/*.bag; do
  one "${bag#"$data"/}" 0 "$bag" --ego-topic /ego_pose --mount -0.12,0,0 --preset vehicle-model
done
for bag in "$data"/people/*.bag; do one "${bag#"$data"/}" "0 3" "$bag"; done
for zip in "$data"/people/*.zip; do one "${zip#"$data"/}" 2 "$zip"; done
for file in "$data"/formats/mcap_laserscan/*.mcap; do one "${file#"$data"/}" 0 "$file"; done
for file in "$data"/formats/obstacle_detector/resources/*.bag; do one "${file#"$data"/}" "0 3" "$file"; done
find "$data/formats/scan_tools" -name '*.bag' | sort | while read -r bag; do echo "$bag"; done >"$work/list"
while read -r bag; do one "${bag#"$data"/}" "0 2 3" "$bag"; done <"$work/list"
find "$data/formats/rosbag2" \( -name '*.db3' -o -name '*.mcap' \) | sort >"$work/list"
while read -r bag; do one "${bag#"$data"/formats/}" 2 "$bag"; done <"$work/list"
find "$data/formats/mcap_conformance" -name '*.mcap' | sort >"$work/list"
while read -r bag; do one "${bag#"$data"/formats/}" "2 3" "$bag"; done <"$work/list"
for log in "$data"/formats/carmen_ple/carmen/*.log.gz; do one "${log#"$data"/}" "0 3" "$log"; done
road="$data/road/kitti_seq0000"
one road/scans_4layer.points.csv.xz 0 "$road/scans_4layer.points.csv.xz" --ego "$road/ego.csv"
[ -z "$kitti" ] || one "road/velodyne .bin" 0 "$kitti" --ego "$road/ego.csv"
exit $failed
