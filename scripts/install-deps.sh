#!/usr/bin/env bash
# Installs the missing Debian packages that hyalite needs; returns at once if none is missing.
set -euo pipefail

usage() {
    cat <<'END'
usage: scripts/install-deps.sh [render|test|fuzz|lint]

  render   packages to build and run hyalite (the default)
  test     those of `render`, and those of the tests
  fuzz     those of `render`, and those of scripts/fuzz.sh
  lint     those of `test`, and those of scripts/lint.sh

Runs on Debian 12 and 13, as root or with sudo. On Debian 12 Mesa and Catch2 come from the backports suite; its source
entry is made from the machine's own Debian entry (see docs/setup.md for the reasons).
END
}

fail() {
    printf 'install-deps.sh: %s\n' "$@" >&2
    exit 1
}

# cpp-httplib and CodeMirror: the server and the editor of `hyalite live`.
# glslang-tools: glslang's CMake package requires its programs.
render=(cmake ninja-build g++ libvulkan-dev glslang-dev glslang-tools spirv-tools libspirv-cross-c-shared-dev libglm-dev
    libstb-dev libopenexr-dev zlib1g-dev libyaml-cpp-dev libcli11-dev nlohmann-json3-dev libnanoflann-dev
    mesa-vulkan-drivers pkg-config libcpp-httplib-dev libjs-codemirror)
# clang-format 19: the only version in both Debian 12 and 13, so that both format alike.
# A browser, its driver and a font test the program's pages. libembree-dev: the ray tracer that `hyalite bench` compares
# with.
test=(catch2 vulkan-validationlayers python3 python3-jsonschema python3-yaml shellcheck clang-format-19 chromium
    chromium-driver python3-selenium fonts-dejavu-core libembree-dev)
# libclang-rt-dev: the sanitizers and the fuzzer of clang's version, which clang itself only recommends.
fuzz=(clang libclang-rt-dev python3)
lint=(clang clang-tidy)
# Minimum versions: lavapipe before Mesa 25 renders wrong pixels; the tests need Catch2 v3.
declare -A atLeast=([mesa-vulkan-drivers]=25 [catch2]=3)

case ${1:-render} in
render) wanted=("${render[@]}") ;;
test) wanted=("${render[@]}" "${test[@]}") ;;
fuzz) wanted=("${render[@]}" "${fuzz[@]}") ;;
lint) wanted=("${render[@]}" "${test[@]}" "${lint[@]}") ;;
-h | --help) usage && exit ;;
*) usage >&2 && exit 2 ;;
esac

# Sets `missing` to the packages of `wanted` that are not installed or too old.
missing=()
findMissing() {
    declare -A installed=()
    local package status version minimum
    while read -r package status version; do
        if [[ $status == installed ]]; then installed[$package]=$version; fi
    done < <(dpkg-query -W -f='${Package} ${db:Status-Status} ${Version}\n' "${wanted[@]}" 2>/dev/null)
    missing=()
    for package in "${wanted[@]}"; do
        version=${installed[$package]:-}
        minimum=${atLeast[$package]:-}
        if [[ -z $version ]] || { [[ -n $minimum ]] && dpkg --compare-versions "$version" lt "$minimum"; }; then
            missing+=("$package")
        fi
    done
}

apt() {
    "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@"
}

updated=1
update() {
    apt update -o APT::Update::Error-Mode=any >&2 || updated=0
}

# Prints one line per index that apt reads: origin, label, suite and address.
indexes() {
    # shellcheck disable=SC2016  # apt-get expands these names
    apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(RELEASE)|$(REPO_URI)' 'Identifier: Packages'
}

# Makes the source entry of the codename's backports suite from the entry of Debian's own archive, which its signed
# release file tells from third parties. Sets `entry`, `entryFile` and `madeFrom`; `entry` is empty if there is none.
makeBackportsEntry() {
    local codename=$1 uri format suffix
    entry=
    while IFS= read -r uri; do
        for madeFrom in /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources; do
            if [[ ! -f $madeFrom ]]; then continue; fi
            format=one-line suffix=list
            if [[ $madeFrom == *.sources ]]; then format=deb822 suffix=sources; fi
            entryFile=/etc/apt/sources.list.d/hyalite-backports.$suffix
            entry=$(awk -v uri="$uri" -v codename="$codename" -v format="$format" \
                -f "$here/backports_entry.awk" "$madeFrom")
            if [[ -n $entry ]]; then return; fi
        done
    done < <(indexes | awk -F '|' -v codename="$codename" \
        '$1 == "Debian" && $2 == "Debian" && $3 == codename { print $4 }' | sort -u)
}

# Adds the codename's backports suite to apt's sources, unless it is there already.
addBackports() {
    local codename=$1 entry entryFile madeFrom
    if indexes | grep -q "|$codename-backports|"; then return; fi
    makeBackportsEntry "$codename"
    if [[ -z $entry ]]; then
        if ((!updated)); then fail "apt-get update failed (see above): no network?"; fi
        fail "no source entry of Debian's main archive with suite '$codename' in /etc/apt/sources.list or" \
            "/etc/apt/sources.list.d: add one, or one with suite '$codename-backports'"
    fi
    "${asRoot[@]}" tee "$entryFile" <<<"$entry" >/dev/null
    update
    # The origin is known once the suite's release file is downloaded.
    if ! indexes | grep -q "^Debian Backports|.*|$codename-backports|"; then
        "${asRoot[@]}" rm -f "$entryFile"
        fail "the mirror in $madeFrom does not give '$codename-backports' (see above)"
    fi
    echo "install-deps.sh: added $entryFile, made from $madeFrom" >&2
}

# Installs `missing` on Debian release $1.
installMissing() {
    local package chosen=() failed=0
    update
    if [[ $1 == 12 && " ${missing[*]} " =~ ' '(mesa-vulkan-drivers|catch2)' ' ]]; then addBackports bookworm; fi
    for package in "${missing[@]}"; do
        if [[ $1 == 12 && -n ${atLeast[$package]:-} ]]; then package+=/bookworm-backports; fi
        chosen+=("$package")
    done
    apt install --yes --no-install-recommends "${chosen[@]}" 2>&1 >/dev/null | sed -n '1,12p' >&2 || failed=1
    findMissing
    if ((failed || ${#missing[@]})); then
        if ((!updated)); then fail "apt-get update failed (see above): no network?"; fi
        fail "apt-get could not install what is needed (see above); missing: ${missing[*]:-nothing}"
    fi
}

here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")

distribution=unknown
if [[ -r /etc/os-release ]]; then
    # shellcheck source=/dev/null
    distribution=$(. /etc/os-release && echo "${ID:-unknown} ${VERSION_ID:-}")
fi
if [[ $distribution != debian\ 1[23] ]]; then
    fail "only Debian 12 and 13 are known here, not '$distribution'" \
        "install the equivalents of: ${wanted[*]} (Mesa 25 or newer, Catch2 3)" \
        "then: cmake --preset release && cmake --build --preset release"
fi

findMissing
if ((${#missing[@]} == 0)); then exit; fi

asRoot=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
        fail "missing: ${missing[*]}" \
            "not root, and there is no sudo: run 'scripts/install-deps.sh ${1:-render}' as root"
    fi
    asRoot=(sudo)
fi
echo "install-deps.sh: installing ${missing[*]}" >&2
installMissing "${distribution#debian }"
