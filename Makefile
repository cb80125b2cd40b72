# SPDX-License-Identifier: GPL-3.0-or-later
# The commands of the README. Each installs what a bare Debian 12 lacks (as root, or through sudo).
BUILD := build
JOBS := $(shell nproc)

.PHONY: run test build bench package dependencies configure clean

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

bench: build
	@tools/bench $(BUILD)

package: build
	cd $(BUILD) && cpack

clean:
	rm -rf $(BUILD)
