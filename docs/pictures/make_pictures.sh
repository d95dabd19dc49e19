#!/bin/sh
# Draws the pictures of the documentation anew, by the program itself, from the example panels.
# Usage, after `make build`: docs/pictures/make_pictures.sh [BUILD_FOLDER]      default: build/release
# Needs rsvg-convert (Debian: librsvg2-bin); for the report node, chromium and `npm ci`; for the pictures of decks and inputs
# the packages of apt-packages-test.txt.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:-$here/../../build/release}" && pwd)
beadmesh=$build/apps/beadmesh/beadmesh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# mesh NAME PANEL OPTION...: the picture NAME.svg of a meshed example panel. Status 1 still has a picture.
mesh() {
  name=$1 panel=$2
  shift 2
  "$beadmesh" mesh "$panel.step" -o "$name.bdf" --report "$name.svg" "$@" || [ $? -eq 1 ]
}

# png NAME WIDTH: NAME.svg into the folder of the pictures.
png() { rsvg-convert --background-color white -w "$2" "$1.svg" -o "$here/$1.png"; }

# crop FROM TO "X Y WIDTH HEIGHT": a part of FROM.svg as TO.svg.
crop() { sed -E "1s/viewBox=\"[^\"]*\" width=\"[^\"]*\" height=\"[^\"]*\"/viewBox=\"$3\"/" "$1.svg" > "$2.svg"; }

for panel in basic curved floor; do "$build/examples/make_example_panel" $panel $panel.step; done

mesh floor floor
png floor 1200

"$beadmesh" mesh floor.step -o floor.bdf --report floor.html || [ $? -eq 1 ]
node "$here/make_report_pictures.mjs" floor.html "$here"

mesh basic basic
crop basic i_bead "70 165 580 140" && png i_bead 1100
crop basic t_bead "80 405 680 400" && png t_bead 1100
crop basic ring_bead "850 550 510 510" && png ring_bead 700
crop basic sheet "90 760 780 405" && png sheet 1100

# Stages one by one: samples and triangles of a T with soft ends and a hole, a sheet before and after clean-up.
awk 'BEGIN {
  pi = atan2(0, -1); printf "POLYGON((0 0"
  for (i = 0; i <= 30; ++i) { a = -pi / 2 + pi * i / 30; printf ", %.6f %.6f", 88 + 24 * cos(a), 12 + 12 * sin(a) }
  printf ", 66 24, 66 40"
  for (i = 1; i < 30; ++i) { a = pi * i / 30; printf ", %.6f %.6f", 56 + 10 * cos(a), 40 + 16 * sin(a) }
  printf ", 46 40, 46 24, 0 24), ("
  for (i = 0; i < 36; ++i) { a = -2 * pi * i / 36; printf "%s%.6f %.6f", i ? ", " : "", 22 + 8 * cos(a), 12 + 8 * sin(a) }
  print "))"
}' > tee.wkt
"$build/examples/draw_stage" triangulation tee.wkt triangulation.svg && png triangulation 1100
"$build/examples/draw_stage" cleanup topological_cleanup.svg && png topological_cleanup 1200

# python SCRIPT ARGUMENT...: a picture by Debian's Python and the package of the build.
python() { script=$1; shift; PYTHONPATH=$build/python /usr/bin/python3 -B "$here/$script" "$@"; }
"$beadmesh" mesh basic.step -o basic.inp
python draw_deck.py basic.inp 3 "$here/deck.png"
"$beadmesh" mesh basic.step -o facets.stl --size 4 --min-edge 1.5
python draw_inputs.py facets facets.stl "$here/facetted_input.png"

"$build/examples/make_example_panel" filleted filleted.step
"$build/examples/vary_panel" filleted.step solid.step --thickness 1.2
python draw_inputs.py solid solid.step "$here/cad_input.png"
mesh filleted filleted
png filleted 1200
"$beadmesh" beads filleted.step --debug-svg grouping.svg
png grouping 1200

mesh coarse basic --preset nvh
crop coarse i_bead_coarse "70 165 580 140" && png i_bead_coarse 1100

# Every shape of bead on a panel of its own.
mkdir -p "$here/shapes"
for shape in straight tapered arc S wavy L J U G T Y X H F trident comb curved-comb ladder tree \
  circle oval rectangle eccentric corrugated; do
  "$build/examples/make_example_panel" shapes $shape.step $shape.json --width 16 --height 5 --only $shape
  mesh $shape $shape
  png $shape 460 && mv "$here/$shape.png" "$here/shapes/"
done

"$beadmesh" medial floor.step --face 2 --svg comb_medial.svg
png comb_medial 1200
"$beadmesh" medial basic.step --face 1 --svg sheet_medial.svg
png sheet_medial 1200
printf 'POLYGON((0 0, 100 0, 100 20, 70 20, 70 60, 50 60, 50 20, 0 20), (10 6, 30 6, 30 14, 10 14))' > corners.wkt
"$beadmesh" medial corners.wkt --feet --svg corners_medial.svg
png corners_medial 1200

# outline NAME FILE WIDTH OPTION...: the medial object of an example outline.
outline() {
  name=$1 file=$2 width=$3
  shift 3
  "$build/examples/make_example_outline" "$name" "$file"
  picture=$(printf '%s' "$name" | tr - _)_medial
  "$beadmesh" medial "$file" --svg "$picture.svg" "$@"
  png "$picture" "$width"
}
outline spiral-bowl spiral-bowl.step 1000
outline gasket gasket.wkt 1200
outline circuit-board circuit-board.wkt 1300
outline door door.step 1300

# A tube with a hole, cut open: facets as an STL file.
awk 'BEGIN {
  n = 72; rows = 24; r = 20; pi = atan2(0, -1); print "solid tube"
  for (j = 0; j < rows; ++j) for (i = 0; i < n; ++i) {
    if (i >= 20 && i < 34 && j >= 9 && j < 17) continue
    triangle(i, j, i + 1, j, i + 1, j + 1); triangle(i, j, i + 1, j + 1, i, j + 1)
  }
  print "endsolid tube"
}
function vertex(i, j) { i %= n; printf "vertex %.9f %.9f %.9f\n", r * cos(2 * pi * i / n), r * sin(2 * pi * i / n), 60 * j / rows }
function triangle(a, b, c, d, e, f) {
  print "facet normal 0 0 0\nouter loop"; vertex(a, b); vertex(c, d); vertex(e, f); print "endloop\nendfacet"
}' > tube.stl
"$beadmesh" medial tube.stl --svg tube_medial.svg
png tube_medial 900
