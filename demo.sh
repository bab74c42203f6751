#!/usr/bin/env bash
# Installs what is needed (Debian), builds, and shows the lake: in a window where there is a display,
# else as pictures of the calm and the moving lake.

cd "$(dirname "$0")"
. .ci/setup.sh

install_packages
build osgwaterviewer

if [ -n "${DISPLAY:-}" ]; then
    say "the lake; h shows the keys, Escape ends"
    exec build/bin/osgwaterviewer --waves 0.1
fi

say "no display: rendering pictures"
mkdir -p build/demo
build/bin/osgwaterviewer --offscreen build/demo/lake-calm.png --size 1280x720
build/bin/osgwaterviewer --offscreen build/demo/lake-moving.png --size 1280x720 --waves 0.1 --time 3
say "look at $PWD/build/demo/lake-calm.png and $PWD/build/demo/lake-moving.png"
