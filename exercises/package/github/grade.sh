#!/usr/bin/env bash
# Grades the repository's answer and hands the result to the reporter, as a step's output.
set -uo pipefail
cd "$(dirname "$0")"
folder=$(mktemp -d)
# The exercise's file alone: what else is in the repository is none of an answer.
cp -P lab/exercises/@FOLDER@/@SLOT@.cpp "$folder/"
[ ! -f @SLOT@.cpp ] || cp -P @SLOT@.cpp "$folder/"
./lab/raylab grade @NN@ --submission "$folder/@SLOT@.cpp" --format github -o "$folder/result.json"
echo "result=$(base64 -w0 "$folder/result.json")" >>"$GITHUB_OUTPUT"
rm -r "$folder"
