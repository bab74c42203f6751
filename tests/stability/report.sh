#!/usr/bin/env bash
# Installs what is needed (Debian), builds, searches for the full battery of rays, tries every
# mutant, has pictures drawn, and makes docs/stability.md: about half an hour on two cores.

cd "$(dirname "$0")/../.."
. .ci/setup.sh

install_packages
build all

mkdir -p docs/stability
say "ten million rays"
build/bin/test_battery "[.full]"
cp build/test-output/battery.json docs/stability/

say "mutants"
tests/mutants/run.py

say "pictures"
tests/stability/pictures.py

tests/stability/make_report.py
