#!/usr/bin/env bash
# Installs the Debian packages of the named groups (build, test, python, bench) that are missing.
# Works as root and as a user with sudo; does nothing, quickly, when all are there.
set -euo pipefail

build="g++ cmake ninja-build ccache mold libeigen3-dev libfmt-dev libexpected-dev libcli11-dev
  libtomlplusplus-dev nlohmann-json3-dev libembree-dev libzstd-dev liblz4-dev zlib1g-dev libbz2-dev
  liblzma-dev libsqlite3-dev libgeographiclib-dev libceres-dev libpng-dev libjpeg62-turbo-dev
  libopencv-calib3d-dev libboost-dev cyclonedds-dev"
test="libgtest-dev libgmock-dev librapidcheck-dev clang-19 clang-tidy-19 clang-format-19
  libclang-rt-19-dev python3 python3-numpy python3-rosbag git chromium nodejs npm
  coinor-libcbc-dev pkg-config libfastrtps-dev libfastcdr-dev python3-pytest python3-pandas python3-matplotlib"
python="pybind11-dev python3-dev python3-numpy"
bench="libbenchmark-dev"
[ -z "${SCANFUSE_PEERS:-}" ] || bench+=" libpcl-dev"  # big; only to compare with

wanted=""
for group in "$@"; do
  case "$group" in
    build) wanted+=" $build" ;;
    test) wanted+=" $test" ;;
    python) wanted+=" $python" ;;
    bench) wanted+=" $bench" ;;
    *) echo "install_packages: no group '$group' (build, test, python, bench)" >&2; exit 2 ;;
  esac
done

missing=""
for package in $wanted; do
  case "$package" in
    nodejs) command -v node > /dev/null && continue ;;
    npm) command -v npm > /dev/null && continue ;;  # comes with other builds of node
  esac
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null)" = installed ] ||
    missing+=" $package"
done
[ -n "$missing" ] || exit 0

sudo=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || { echo "install as root:$missing" >&2; exit 2; }
  sudo=sudo
fi
echo "installing:$missing"
$sudo apt-get update -qq
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
  $missing > /dev/null
