#!/bin/sh
# sh reports/run.sh [SCENARIO] [FOLDER]: builds pmreport and makes a report. Without arguments, the one of the 4SPS-SPR manipulator, into
# build/report. A scenario by bare name is one of 4sps-spr's: "figure2".
set -eu
here=$(pwd)
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh

absolute() { case $1 in /*) echo "$1" ;; *) echo "$here/$1" ;; esac; }
scenario=plugins/4sps-spr/figure2.toml
case ${1-} in
  '') ;;
  */* | *.toml) scenario=$(absolute "$1") ;;
  *) scenario=plugins/4sps-spr/$1.toml ;;
esac
folder=build/report
[ -z "${2-}" ] || folder=$(absolute "$2")

# shellcheck disable=SC2086  # a list of words
install_packages $program_packages
# A first report should come soon: the program and the plugin that the scenario uses, and no builds of it for newer processors. Where there
# are some, they are kept up to date.
[ -f build/build.ninja ] || cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DPMREPORT_TESTS=OFF -DPMREPORT_LEVELS= -DCMAKE_UNITY_BUILD=ON
mechanism=$(sed -n 's/^ *use *= *"\([a-z0-9-]*\)".*/\1/p' "$scenario" 2>/dev/null | head -n 1)
if [ -f "plugins/$mechanism/mechanism.cpp" ]; then plugins=plugin-$mechanism; else plugins=plugins/all; fi
cmake --build build --parallel "$(nproc)" --target pmreport "$plugins"

build/bin/pmreport "$scenario" --out "$folder" && status=0 || status=$?
[ ! -f "$folder/report.html" ] || echo "The report: $folder/report.html and $folder/report.pdf"
exit "$status"
