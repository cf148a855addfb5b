#!/usr/bin/env bash
# Installs the grader into the folder of this file, on a Debian or Ubuntu that may be bare. What the
# system has is used; what it lacks is installed, as root or by sudo. At the end the model solution is
# graded: it proves that grading works here, and fills the cache with what no submission changes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# A host may call this from within a student's files. Nothing of theirs may be taken for a part of
# Python: hence another folder, and -I in each call.
cd "$here"
# shellcheck disable=SC2086
unset ${!PYTHON@}

die() {
    printf 'bvhgrade: %s\n' "$1" >&2
    exit 1
}

python_found() {
    local name
    for name in python3 python3.11 python3.12 python3.13 python3.14; do
        if "$name" -I -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
            command -v "$name"
            return
        fi
    done
    return 1
}

compiler_found() {
    local name version
    for name in g++ g++-12 g++-13 g++-14 g++-15; do
        version=$("$name" -dumpversion 2>/dev/null | cut -d. -f1) || continue
        if [[ $version =~ ^[0-9]+$ ]] && [ "$version" -ge 12 ]; then
            command -v "$name"
            return
        fi
    done
    return 1
}

# apt_install PACKAGE...: the first call reads the lists of packages.
apt_install() {
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
    if [ -z "${lists_read:-}" ]; then
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
        lists_read=yes
    fi
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "$@"
}

missing=()
if ! command -v cmake >/dev/null; then missing+=(cmake); fi
if ! command -v make >/dev/null; then missing+=(make); fi
if ! command -v bwrap >/dev/null; then missing+=(bubblewrap); fi
# Boxes run the system's own Python, which all users can read.
if [ ! -x /usr/bin/python3 ]; then missing+=(python3); fi
if [ ${#missing[@]} -gt 0 ]; then apt_install "${missing[@]}"; fi
if ! compiler_found >/dev/null; then apt_install g++; fi
# Ubuntu 22.04: its g++ is 11, and its python3 is 3.10.
compiler_found >/dev/null || apt_install g++-12
python_found >/dev/null || apt_install python3 python3-venv
python_found >/dev/null || apt_install python3.11 python3.11-venv
compiler=$(compiler_found) || die 'there is no g++ 12 or newer in this image; choose a newer one'
python=$(python_found) || die 'there is no Python 3.11 or newer in this image; choose a newer one'

printf 'export CXX=%q\nexport BVHGRADE_CACHE=%q\n' "$compiler" "$here/cache" >"$here/environment.sh"
# shellcheck disable=SC1091
source "$here/environment.sh"

"$python" -I -m venv --clear "$here/venv"
sources=()
# Wheels that were packed (`--wheels`) are enough: then no network is needed.
if compgen -G "$here/wheels/numpy-*.whl" >/dev/null; then sources=(--no-index --find-links "$here/wheels"); fi
"$here/venv/bin/python" -I -m pip install --quiet --disable-pip-version-check --no-cache-dir \
    "${sources[@]}" --constraint "$here/constraints.txt" "$here"/wheels/bvhgrade-*.whl

"$here/venv/bin/python" -I "$here/venv/bin/bvhgrade" doctor
trial=$(mktemp -d)
reference=$("$here/venv/bin/python" -I -c 'from grader.resources import reference_source; print(reference_source())')
"$here/grade.sh" "$reference" "$trial" --quiet || die 'the model solution could not be graded; see above'
"$here/venv/bin/python" -I - "$trial/result.json" <<'END' || die 'the model solution loses points here; see above'
import json
import sys

with open(sys.argv[1]) as file:
    result = json.load(file)
for check in result["checks"]:
    if check["verdict"] != "pass":
        print(check["id"], check["verdict"], check["message"])
sys.exit(result["score"] is None or result["score"] < result["max_score"])
END
rm -rf "$trial"
