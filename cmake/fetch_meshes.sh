#!/usr/bin/env bash
# usage: cmake/fetch_meshes.sh DEST
# Fetches scanned meshes from Debian's package libcgal-demo into the folder DEST, without root and without installing
# anything; all of them or none. Exits 1 with one line on stderr where it cannot.
set -euo pipefail

[ $# = 1 ] || { echo "usage: fetch_meshes.sh DEST" >&2; exit 2; }
dest=$1
package=libcgal-demo
meshes=(  # the package's name:raylab's name
  refined_elephant:elephant elephant:elephant_coarse bunny00:bunny armadillo:armadillo ChineseDragon-10kv:dragon
)

fail() { echo "fetch_meshes: $1" >&2; exit 1; }

for tool in apt-get dpkg-deb tar; do
  command -v "$tool" >/dev/null || fail "no $tool here: the meshes come with a Debian package"
done
mkdir -p "$(dirname "$dest")" 2>/dev/null || fail "cannot make the folder of $dest"
work=$(mktemp -d "$dest.XXXXXX" 2>/dev/null) || fail "cannot write beside $dest"
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/archives/partial" "$work/whole"
work=$(cd "$work" && pwd)

# The machine's package lists are used; where they are missing or stale, lists are fetched into the work folder.
own_lists=(-o "Dir::State::lists=$work/lists" -o "Dir::Cache=$work" -o "Dir::Cache::archives=$work/archives")
download() { (cd "$work" && apt-get -qq "$@" download "$package") >"$work/log" 2>&1; }
download || { apt-get -qq "${own_lists[@]}" update >"$work/log" 2>&1 && download "${own_lists[@]}"; } ||
  fail "cannot download $package: $(grep -v '^W:' "$work/log" | tail -n 1)"

dpkg-deb -x "$work"/*.deb "$work/package" 2>/dev/null || fail "$package is damaged"
data=$(find "$work/package" -name data.tar.gz -print -quit)
[ -n "$data" ] || fail "$package holds no data.tar.gz"
for mesh in "${meshes[@]}"; do
  tar -xzOf "$data" "data/meshes/${mesh%%:*}.off" >"$work/whole/${mesh##*:}.off" 2>/dev/null ||
    fail "$package holds no mesh ${mesh%%:*}.off"
done
chmod 755 "$work/whole"
rm -rf "$dest"
mv -T "$work/whole" "$dest"
