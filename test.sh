#!/usr/bin/env bash
# Installs what is needed (Debian), builds, and runs every test.

cd "$(dirname "$0")"
. .ci/setup.sh

install_packages
build all

say "testing"
cd build
exec ctest --output-on-failure -j "$(nproc)"
