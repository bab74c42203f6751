# Shared by demo.sh and test.sh: installs what is missing on Debian, and builds into build/.
# Sourced, not run.

set -euo pipefail

packages="
    g++ cmake ninja-build
    libopenscenegraph-dev libglm-dev libgl-dev libegl-dev libosmesa6-dev
    libgl1-mesa-dri libegl1 libegl-mesa0
    catch2 clang-format libembree-dev libbenchmark-dev nlohmann-json3-dev python3
"

say() { printf '== %s\n' "$*"; }

fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# Installs the Debian packages that are missing; does nothing where none is.
install_packages() {
    local missing="" package
    for package in $packages; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
            missing="$missing $package"
    done
    [ -n "$missing" ] || return 0

    command -v apt-get >/dev/null ||
        fail "expected a Debian system with apt-get, got none; these are needed:$missing"
    local sudo=""
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "expected root or sudo to install:$missing"
        sudo=sudo
    fi
    say "installing Debian packages:$missing"
    $sudo apt-get update -qq || fail "apt-get update failed"
    # shellcheck disable=SC2086
    $sudo env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends $missing >/dev/null ||
        fail "apt-get could not install:$missing"
}

# Builds a target in release mode; does nothing where it is up to date.
build() {
    if [ ! -f build/build.ninja ]; then
        say "configuring build/"
        cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null ||
            fail "cmake could not configure build/"
    fi
    say "building $1"
    cmake --build build --target "$1" || fail "the build failed"
}
