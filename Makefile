# SPDX-License-Identifier: GPL-3.0-or-later
# The commands of the README. Each installs what a bare Debian 12 lacks (as root, or through sudo).
BUILD := build
JOBS := $(shell nproc)

.PHONY: run test soak build bench scene-table package dependencies configure clean

run: build
	@tools/run $(BUILD)

test: build
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

build: configure
	cmake --build $(BUILD) -j $(JOBS)

configure: dependencies
	@test -f $(BUILD)/build.ninja || cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release

dependencies:
	@tools/install-dependencies

# A minute of random use of the real window; enclosures at 10^8 points of random graphs.
soak: build
	ISOSCOPE_SOAK_SECONDS=60 ctest --test-dir $(BUILD) --output-on-failure -R '^app_soak$$' --timeout 300
	ISOSCOPE_SOUNDNESS_POINTS=1e8 ISOSCOPE_SEED=$$(date +%s) QTEST_FUNCTION_TIMEOUT=7200000 ctest --test-dir $(BUILD) --verbose -R '^evaluate_soundness$$' --timeout 7200

bench: build
	@tools/bench $(BUILD)
	cmake --build $(BUILD) -j $(JOBS) --target kernel_bench
	$(BUILD)/kernel_bench

# Our pictures of the scenes that come with POV-Ray beside its own: some ten minutes.
scene-table: build
	@tools/compare-scenes $(BUILD)

package: build
	cd $(BUILD) && cpack

clean:
	rm -rf $(BUILD)
