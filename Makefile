# SPDX-License-Identifier: GPL-3.0-or-later
# The commands of the README. Each installs what a bare Debian 12 lacks (as root, or through sudo).
BUILD := build
JOBS := $(shell nproc)
# Tests wait for other programs and for windows in a quarter of their time.
TEST_JOBS := $(shell expr $(JOBS) \* 3 / 2)
CONFIGURE := -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release
# How far a build is: "[42% of 480 steps, 95 s]".
export NINJA_STATUS := [%p of %t steps, %e s] 

.PHONY: run build test tests with-tests check soak fuzz bench scene-table package portable dependencies test-dependencies clean

run: build
	@tools/run $(BUILD)

# The two programs and nothing else.
build: dependencies
	@test -f $(BUILD)/build.ninja || cmake $(CONFIGURE) -DISOSCOPE_TESTS=OFF
	@cmake --build $(BUILD) -j $(JOBS) --target isoscope isoscope-cli

with-tests: test-dependencies
	@cmake $(CONFIGURE) -DISOSCOPE_TESTS=ON

tests: with-tests
	@cmake --build $(BUILD) -j $(JOBS)

test: tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(TEST_JOBS)

# Without a compiler: format, pages, and clang-tidy over what differs from origin/main (BASE=... for another commit).
check:
	@tools/check-format
	@tools/check-docs
	@test -f $(BUILD)/compile_commands.json || cmake $(CONFIGURE)
	@tools/lint --build $(BUILD) $(BASE)

dependencies:
	@tools/install-dependencies programs

test-dependencies:
	@tools/install-dependencies

# A minute of random use of the real window; enclosures at 10^8 points of random graphs.
soak: tests
	ISOSCOPE_SOAK_SECONDS=60 ctest --test-dir $(BUILD) --output-on-failure -R '^app_soak$$' --timeout 300
	ISOSCOPE_SOUNDNESS_POINTS=1e8 ISOSCOPE_SEED=$$(date +%s) QTEST_FUNCTION_TIMEOUT=7200000 ctest --test-dir $(BUILD) --verbose -R '^evaluate_soundness$$' --timeout 7200

# Two minutes of clang's libFuzzer for each reader of texts and files of others (SECONDS=... for others).
SECONDS ?= 120
fuzz: test-dependencies
	@cmake --preset fuzz
	@cmake --build --preset fuzz -j $(JOBS)
	@tools/fuzz build-fuzz $(SECONDS)

bench: with-tests
	@cmake --build $(BUILD) -j $(JOBS) --target isoscope-cli kernel_bench
	@tools/bench $(BUILD)
	$(BUILD)/kernel_bench

# Our pictures of the scenes that come with POV-Ray beside its own: some ten minutes.
scene-table: test-dependencies build
	@tools/compare-scenes $(BUILD)

package: build
	@cmake --build $(BUILD) -j $(JOBS) --target package_pages
	@tools/package $(BUILD)

# An archive with all libraries, and an AppImage, for other distributions.
portable: test-dependencies build
	@cmake --build $(BUILD) -j $(JOBS) --target package_pages
	@tools/portable $(BUILD)

clean:
	rm -rf $(BUILD)
