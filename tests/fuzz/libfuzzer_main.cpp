// SPDX-License-Identifier: GPL-3.0-or-later
// One program for each target, ISOSCOPE_FUZZ_TARGET being its number, driven by clang's libFuzzer.
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
    if (!fuzzTargets()[ISOSCOPE_FUZZ_TARGET].isText || random() % 4 == 0)
        return LLVMFuzzerMutate(data, size, most);
    static const std::vector<std::string> corpus = corpusOf(fuzzTargets()[ISOSCOPE_FUZZ_TARGET]);
    const std::string changed =
        changedTokens({reinterpret_cast<const char*>(data), size}, corpus[random() % corpus.size()], random);
    const std::size_t count = std::min(changed.size(), most);
    std::memcpy(data, changed.data(), count);
    return count;
}
