#!/usr/bin/env bash
# Grades one submission. The folders are PrairieLearn's.
set -uo pipefail
grade=${GRADE:-/grade}
lab=${LAB:-/lab}
mkdir -p "$grade/results"
echo '{"gradable": false, "format_errors": ["The grader did not start. This says nothing about your answer."]}' >"$grade/results/results.json"
"$lab/raylab" grade @NN@ --submission "$grade/student" --format prairielearn -o "$grade/results/results.json"
exit 0
