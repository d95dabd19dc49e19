#!/usr/bin/env bash
# Installs the Debian packages of the lists that are missing.
#   install_packages.sh LIST...     for example apt-packages.txt; one package a line, # begins a comment; a second word
#                                   is a program that makes the package needless where it is on the path
set -euo pipefail
cd "$(dirname "$0")/.."

missing=()
while read -r package program; do
  [[ -z $package || $package == \#* ]] && continue
  [[ -n $program ]] && command -v "$program" > /dev/null && continue
  [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
done < <(cat "$@")
[[ ${#missing[@]} -eq 0 ]] && exit 0

fail() {
  echo "cannot install the packages ${missing[*]}: $1" >&2
  exit 1
}

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo >/dev/null || fail "neither root nor sudo"
  as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
echo "installing ${missing[*]}"
"${as_root[@]}" apt-get -qq update || fail "apt-get update failed"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install --yes --no-install-recommends "${missing[@]}" \
  >/dev/null || fail "apt-get install failed"
