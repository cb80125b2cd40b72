// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/written_work.h"

namespace isoscope {

void WrittenWork::add(const WrittenWork& other, double times) {
    products += times * other.products;
    quotients += times * other.quotients;
    sums += times * other.sums;
    for (const auto& [name, count] : other.calls) calls[name] += times * count;
    declaredCalls += times * other.declaredCalls;
    compiledCalls += times * other.compiledCalls;
}

}  // namespace isoscope
