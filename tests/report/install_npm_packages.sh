#!/bin/sh
# Brings what package-lock.json names into node_modules, unless it is there already.
set -eu
stamp=node_modules/.installed
cmp -s package-lock.json "$stamp" && exit 0
npm ci --no-audit --no-fund || {
  echo "the npm registry cannot be reached, or does not hold what package-lock.json names: no test of the viewer runs" >&2
  exit 1
}
cp package-lock.json "$stamp"
