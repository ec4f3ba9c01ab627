# What the scripts share. To be sourced; leaves the caller in the project's root folder.
set -euo pipefail

# `scripts/SCRIPT --help` prints the comment at its beginning.
if [[ ${1-} == -h || ${1-} == --help ]]; then
    sed -n '2,${/^#/!q; s/^# \?//p}' "$0"
    exit
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export VVR_CONFIG= # what the scripts draw does not depend on this machine's config files

say() { printf '==> %s\n' "$*" >&2; }

die() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
    exit 1
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        die "'$*' needs root, and there is no sudo; run it as root, then start again"
    fi
}

apt_get() { DEBIAN_FRONTEND=noninteractive apt-get -q -o Dpkg::Use-Pty=0 "$@"; }

update_package_lists() {
    say "apt-get update"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q update >&2
}

# The packages of packages.txt that are not installed, one per line: those without a group, of the group run, and those
# of GROUP...
missing_packages() {
    local wanted
    wanted=$(sed 's/#.*//' scripts/packages.txt |
        awk -F': *' -v groups=" run $* " 'NF == 1 || index(groups, " " $1 " ") {print $NF}')
    # dpkg-query fails when it has never heard of a package, which is an answer too.
    # shellcheck disable=SC2086
    { dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null || true; } |
        awk '$2 == "installed" {print $1}' | sort -u | comm -13 - <(printf '%s\n' $wanted | sort -u)
}

# Installs what is missing to build and run vvr, and for GROUP...
install_packages() {
    command -v dpkg-query >/dev/null || die "this is not Debian; install what scripts/packages.txt lists, by your own means"
    local missing
    missing=$(missing_packages "$@")
    if [ -z "$missing" ]; then
        say "all packages are installed${*:+ (also for: $*)}"
        return
    fi
    say "installing" $missing "(one to three minutes where all are missing)"
    # shellcheck disable=SC2086
    if ! apt_get install --no-install-recommends --simulate $missing >/dev/null 2>&1; then
        update_package_lists
    fi
    # shellcheck disable=SC2086
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o Dpkg::Use-Pty=0 install -y --no-install-recommends $missing >&2
}

configured() { # PRESET
    [ -e "build/$1/build.ninja" ]
}

# Configures build/PRESET with OPTION...; what was configured before keeps its other options.
configure() { # PRESET OPTION...
    local preset=$1
    shift
    say "configuring build/$preset"
    cmake --preset "$preset" "$@" >&2
}

# With tests, also where scripts/demo configured it without. What checks sources needs the commands of each file.
configure_tests() { # PRESET
    local options=(-DVVR_TESTS=ON)
    [ "$1" = lint ] || configured "$1" || options+=(-DVVR_UNITY=ON)
    configured "$1" && grep -q '^VVR_TESTS:BOOL=ON' "build/$1/CMakeCache.txt" || configure "$1" "${options[@]}"
}

# Builds TARGET..., or everything that is configured.
build() { # PRESET TARGET...
    local preset=$1
    shift
    say "building build/$preset${*:+ ($*)}"
    cmake --build --preset "$preset" ${1:+--target "$@"} >&2
}

# One file out of Debian's opencv-doc, kept in .cache. Fails when the package can't be had.
fetch_vtest() {
    local clip=.cache/vtest.avi folder
    [ -s "$clip" ] && return
    command -v apt-get >/dev/null || return 1
    mkdir -p .cache
    say "fetching vtest.avi out of Debian's opencv-doc"
    folder=$(mktemp -d .cache/deb.XXXXXX)
    download_opencv_doc "$folder" || { update_package_lists && download_opencv_doc "$folder"; } || true
    if compgen -G "$folder/*.deb" >/dev/null &&
        dpkg-deb --fsys-tarfile "$folder"/*.deb |
            tar -xO ./usr/share/doc/opencv-doc/examples/data/vtest.avi >"$folder/vtest.avi"; then
        mv "$folder/vtest.avi" "$clip"
    fi
    rm -rf "$folder"
    [ -s "$clip" ]
}

download_opencv_doc() {
    (cd "$1" && apt_get -o APT::Sandbox::User=root download opencv-doc >/dev/null 2>&1)
}

# A scene made by a test program, for where there is no network.
generate_scene() {
    mkdir -p .cache
    [ -s .cache/left_bag.y4m ] && return
    build release vvr-scene
    build/release/tests/scene/vvr-scene left_bag .cache/part.y4m --frames 600
    mv .cache/part.y4m .cache/left_bag.y4m
}

# The name of the demo's clip, on stdout: real footage, else a generated scene.
demo_clip() {
    if fetch_vtest; then
        echo .cache/vtest.avi
    else
        say "opencv-doc can't be had here, so this uses a generated scene"
        generate_scene
        echo .cache/left_bag.y4m
    fi
}
