#!/usr/bin/env bash
# PrairieLearn runs this for every submission, and reads the results only if it ends with status 0.
set -uo pipefail
results=$(mktemp -d)
mkdir -p /grade/results
/bvhgrade/grade.sh /grade/student "$results" --format prairielearn
if [ -f "$results/prairielearn/results.json" ]; then
    cp "$results/prairielearn/results.json" /grade/results/results.json
else
    printf '%s\n' '{"gradable": false, "message": "The grader failed; nothing is concluded about this submission."}' \
        >/grade/results/results.json
fi
rm -rf "$results"
exit 0
