# Sourced by the scripts beside it: sets up .venv in the checkout when it is missing or outdated.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
venv=$root/.venv
# Somebody else's Python settings must not decide what is imported.
unset PYTHONHOME PYTHONPATH

die() {
    printf '%s: %s\n' "$(basename "$0")" "$1" >&2
    exit "${2:-3}"
}

find_python() {
    local name
    for name in python3 python3.11 python3.12 python3.13 python3.14; do
        if "$name" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
            command -v "$name"
            return
        fi
    done
    die "no Python 3.11 or newer was found; on Debian or Ubuntu: sudo apt-get install python3 python3-venv"
}

# need PACKAGE PROGRAM...: one of the programs must be there.
need() {
    local package=$1 program
    shift
    for program in "$@"; do
        if command -v "$program" >/dev/null; then return; fi
    done
    die "$1 is not installed; on Debian or Ubuntu: sudo apt-get install $package"
}

# set_up run|dev: after this, .venv holds the package and what it (or its development) needs.
set_up() {
    local wanted
    wanted="$(sha256sum <"$root/pyproject.toml" | cut -c1-64) $root"
    if is_ready "$1" "$wanted"; then return; fi
    need util-linux flock
    exec 9>"$root/.venv.lock"
    flock 9
    # Another script may have finished it while this one waited.
    if ! is_ready "$1" "$wanted"; then install "$1" "$wanted"; fi
    exec 9>&-
}

is_ready() {
    if [ -f "$venv/ready-dev" ] && [ "$(<"$venv/ready-dev")" = "$2" ]; then return 0; fi
    [ "$1" = run ] && [ -f "$venv/ready-run" ] && [ "$(<"$venv/ready-run")" = "$2" ]
}

install() {
    local python extra=''
    if [ "$1" = dev ]; then extra='[dev]'; fi
    printf 'Setting up .venv (only now and when pyproject.toml changes; up to a minute) ...\n' >&2
    if ! "$venv/bin/python" -m pip --version >/dev/null 2>&1; then
        python=$(find_python) || exit
        "$python" -c 'import venv, ensurepip' 2>/dev/null ||
            die "$python has no venv; on Debian or Ubuntu: sudo apt-get install python3-venv"
        "$python" -m venv --clear "$venv" || die "$venv could not be created"
    fi
    rm -f "$venv/ready-run" "$venv/ready-dev"
    "$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-warn-script-location \
        --editable "$root$extra" ||
        die "pip could not install what pyproject.toml lists; its message is above (is there a network?)"
    printf '%s' "$2" >"$venv/ready-$1"
}
