# The two doors for a newcomer. Each installs what is missing, builds and runs; neither asks anything.
PROGRAM := build/release/apps/beadmesh/beadmesh
MAKE_PANEL := build/release/examples/make_example_panel

.PHONY: demo test random build program packages test-packages

demo: program
	@mkdir -p demo
	$(MAKE_PANEL) floor demo/floor.step
	$(PROGRAM) mesh demo/floor.step -o demo/floor.bdf --json demo/floor.json --report demo/floor.html; \
	  status=$$?; test $$status -le 1 || exit $$status
	$(PROGRAM) medial demo/floor.step --face 2 --svg demo/medial.svg
	@printf '%s\n' '' 'The results are in demo/:' \
	  '  floor.step   the panel' \
	  '  floor.bdf    the mesh, a Nastran deck with a property and sets per bead' \
	  '  floor.json   the bead table' \
	  '  medial.svg   the medial object of one bead' \
	  '' 'Open the report in a browser:' '  file://$(CURDIR)/demo/floor.html'

test: test-packages build
	ctest --preset release

# A thousand panels by chance (FIRST=1 COUNT=1000); those that break a hard rule are kept in random/.
FIRST := 1
COUNT := 1000
random: program
	python3 tests/cli/random_panels.py --first $(FIRST) --count $(COUNT) --jobs "$$(nproc)" --keep random

build: packages
	cmake --preset release
	cmake --build --preset release --parallel "$$(nproc)"

program: packages
	cmake --preset release
	cmake --build --preset release --parallel "$$(nproc)" --target beadmesh_app make_example_panel

packages:
	@scripts/install_packages.sh apt-packages.txt

test-packages:
	@scripts/install_packages.sh apt-packages.txt apt-packages-test.txt
