#!/usr/bin/env bash
# Installs what is needed (Debian), builds, measures anew what docs/accuracy.md says (an hour and
# more on two cores), and makes the document.
# With --quick: some minutes, small pictures, into build/report, for trying.
#
# Measurements of a GPU stand beside them where they lie in docs/accuracy/gpu: configure another
# build with -DOSGWATERREFLECT_OFFSCREEN=egl, run its osgwaterbench with --output
# docs/accuracy/gpu, then make_report.py.

cd "$(dirname "$0")/../../.."
. .ci/setup.sh

report=applications/osgwaterbench/report
measured=build/report/accuracy # only complete results go on from here
experiments="table1 accuracy rivals borders scaling added"

case "$*" in
    "") options="" ;;
    --quick) options=--quick ;;
    *) fail "expected nothing or --quick, got $*" ;;
esac

packages="$packages python3 gnuplot-nox"
install_packages
build osgwaterbench

say "measuring"
rm -rf "$measured"
# shellcheck disable=SC2086
build/bin/osgwaterbench $experiments $options --output "$measured"

if [ -n "$options" ]; then
    "$report/make_report.py" "$measured" build/report/accuracy.md
else
    mkdir -p docs/accuracy
    cp "$measured"/*.json "$measured"/*.jpg docs/accuracy/
    "$report/make_report.py"
fi
