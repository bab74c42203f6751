#!/bin/sh
# Makes the six sky pictures: fetches the CC0 panorama and hands it to osgwatersky.
# usage: convert_sky.sh OSGWATERSKY_PROGRAM OUTPUT_DIRECTORY
set -eu

if [ $# -ne 2 ]
then
    echo "usage: convert_sky.sh OSGWATERSKY_PROGRAM OUTPUT_DIRECTORY" >&2
    exit 1
fi
program=$(realpath "$1")
output=$(realpath "$2")
package=@pmndrs/assets@1.7.0

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
npm pack --silent "$package" > /dev/null
tar -xzf pmndrs-assets-*.tgz package/hdri/sky.exr.js
# The module is one line: export default 'data:application/exr;base64,...'
sed -n "s/.*base64,\([^']*\)'.*/\1/p" package/hdri/sky.exr.js | base64 -d > sky.exr
"$program" sky.exr "$output"
