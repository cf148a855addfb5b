#!/usr/bin/env bash
# Grades one submission: grade.sh SUBMISSION FOLDER_FOR_RESULTS [options of `bvhgrade grade`]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# Which compiler, and where the cache is; install.sh wrote it.
# shellcheck disable=SC1091
source "$here/environment.sh"
# What the course chose: a list called `chosen`.
# shellcheck disable=SC1091
source "$here/settings.sh"
# Wherever this is called from: only what was installed decides which code Python runs.
# shellcheck disable=SC2086
unset ${!PYTHON@}
# shellcheck disable=SC2154
exec "$here/venv/bin/python" -I "$here/venv/bin/bvhgrade" grade "$1" -o "$2" "${chosen[@]}" "${@:3}"
