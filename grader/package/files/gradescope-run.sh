#!/usr/bin/env bash
# Gradescope runs this for every submission. Without a results.json it says that the autograder failed:
# so a fault of the grader costs nobody a point, and the instructor can run it again.
set -uo pipefail
results=$(mktemp -d)
/autograder/source/bvhgrade/grade.sh /autograder/submission "$results" --format gradescope
status=$?
if [ -f "$results/gradescope/results.json" ]; then
    mkdir -p /autograder/results
    cp "$results/gradescope/results.json" /autograder/results/results.json
fi
rm -rf "$results"
exit "$status"
