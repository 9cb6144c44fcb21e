#!/usr/bin/env bash
# Proves the README's two commands on a bare Debian: makes a minimal root, clones HEAD into it, and runs them there.
set -euo pipefail
export LC_ALL=C # for a decimal point in the times below

usage() {
    cat <<'END'
usage: scripts/prove-setup.sh bookworm|trixie [install|render|test]

  install   only scripts/install-deps.sh and a CMake configure
  render    scripts/render.sh twice, with a small picture
  test      `render`, then scripts/test.sh (the default)

Needs root rights, debootstrap and git, on a Debian machine; the new root copies its mirror and network settings. The
root is in a temporary folder and is removed at the end. Uncommitted changes are not included.
END
}

fail() {
    echo "prove-setup.sh: $1" >&2
    exit 1
}

case ${1:-} in
bookworm | trixie) suite=$1 ;;
-h | --help) usage && exit ;;
*) usage >&2 && exit 2 ;;
esac
until=${2:-test}
case $until in install | render | test) ;; *) usage >&2 && exit 2 ;; esac

((EUID == 0)) || fail "run as root: it makes a root folder and enters it"
for tool in debootstrap git unshare; do
    command -v "$tool" >/dev/null || fail "no $tool: apt-get install $tool"
done

source=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
work=$(mktemp -d)
root=$work/$suite

# All mounts are in namespaces that end with their processes, so nothing should be mounted here when this runs. If
# something is, leave everything in place.
cleanUp() {
    if grep -q " $work/" /proc/self/mountinfo; then
        echo "prove-setup.sh: left $work in place: something is mounted in it" >&2
    else
        rm -rf --one-file-system "$work"
    fi
}
trap cleanUp EXIT

# Runs a command and records its time. A function run by this must itself end on a failed step.
timed() {
    local what=$1 start=$EPOCHREALTIME result=0
    shift
    "$@" || result=$?
    printf '[prove-setup %s] %-34s %7.1f s  exit %d\n' "$suite" "$what" \
        "$(awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }')" "$result" | tee -a "$work/times"
    return "$result"
}

makeRoot() {
    local mirror
    # shellcheck disable=SC2016  # apt-get expands these names
    mirror=$(apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(REPO_URI)' |
        awk -F '|' '$1 == "Debian" && $2 == "Debian" { print $3; exit }')
    [[ -n $mirror ]] || fail "apt knows no Debian mirror: run apt-get update"
    unshare --mount debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$work/debootstrap.log" ||
        { tail "$work/debootstrap.log" >&2 && fail "debootstrap failed"; }
    # Network settings such as proxies are specific to this machine: copy them into the new root.
    cp /etc/resolv.conf "$root/etc/resolv.conf" || return
    apt-config dump | grep '^Acquire::' | grep -Ev '^Acquire::(IndexTargets|Languages)' \
        >"$root/etc/apt/apt.conf.d/99network" || true
    git clone --quiet --no-local "$source" "$root/hyalite"
}

# Runs a command in the new root, with its own home folder and pseudo-terminals and none of this machine's environment.
inside() {
    # shellcheck disable=SC2016  # expanded by the inner shell
    unshare --mount --pid --fork --kill-child --mount-proc="$root/proc" bash -c '
        mkdir -p "$0/dev/pts" && mount -t devpts -o newinstance,ptmxmode=0666 devpts "$0/dev/pts" &&
            ln -sf pts/ptmx "$0/dev/ptmx" && exec chroot "$0" "$@"' "$root" \
        env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        bash -c 'cd && "$@"' inside "$@"
}

render() {
    inside /hyalite/scripts/render.sh --resolution 64x64 --passes 2 || return
    [[ -s $root/root/cornell-caustics.png ]] || fail "no picture was written"
    rm "$root/root/cornell-caustics.png"
}

timed 'make a bare root' makeRoot
if [[ $until == install ]]; then
    timed 'install-deps.sh test' inside /hyalite/scripts/install-deps.sh test
    timed 'install-deps.sh test, again' inside /hyalite/scripts/install-deps.sh test
    timed 'configure' inside cmake -S /hyalite -B /hyalite/build/release -G Ninja -DHYALITE_TESTS=ON
else
    timed 'render.sh, first' render
    timed 'render.sh, again' render
    if [[ $until == test ]]; then timed 'test.sh' inside /hyalite/scripts/test.sh; fi
fi
echo
cat "$work/times"
