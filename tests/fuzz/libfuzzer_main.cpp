// SPDX-License-Identifier: GPL-3.0-or-later
// One program for each target, ISOSCOPE_FUZZ_TARGET being its number, driven by clang's libFuzzer.
#include <algorithm>
#include <cstring>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/scene_mutator.h"

using namespace isoscope::test;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzzTargets()[ISOSCOPE_FUZZ_TARGET].read({reinterpret_cast<const char*>(data), size});
    return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    std::mt19937_64 random(seed);
    const FuzzTarget& target = fuzzTargets()[ISOSCOPE_FUZZ_TARGET];
    static const std::vector<std::string> corpus = corpusOf(target);
    const std::string none;
    const auto anyInput = [&]() -> const std::string& {
        return corpus.empty() ? none : corpus[random() % corpus.size()];
    };
    // Whole files again and again: from nothing it takes ages to a font or a scene.
    constexpr unsigned fresh = 32;
    std::string input(reinterpret_cast<const char*>(data), size);
    const bool begins = size < 2 || random() % fresh == 0;
    if (begins) input = partOf(anyInput(), most, target.isText, random);
    if (!target.isText || random() % 4 == 0) {
        if (!begins) return LLVMFuzzerMutate(data, size, most);
        if (!target.isText) input = random() % 4 == 0 ? input : changedBytes(input, random);
    } else {
        input = changedTokens(input, anyInput(), random);
    }
    const std::size_t count = std::min(input.size(), most);
    std::memcpy(data, input.data(), count);
    return count;
}
