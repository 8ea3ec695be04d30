#!/usr/bin/env bash
# Gradescope runs this once, as root, when it makes the image. The lab's program is built for Debian 12, which Gradescope does not
# offer, so it gets a Debian of its own below /debian.
set -euo pipefail
source=${AUTOGRADER:-/autograder}/source
apt-get update
apt-get install -y debootstrap
debootstrap --variant=minbase --include="$(paste -sd, "$source/lab/packages.txt")" bookworm /debian
cp -r "$source/lab" /debian/lab
# Students' programs run as another user and may not read the grader.
chmod -R go= "$source"
