// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/operation.h"

#include <array>

namespace isoscope {

namespace {

struct OperationFacts {
    std::string_view name;
    int arity;
};

constexpr std::array<OperationFacts, operationCount> facts{{
    {"constant", 0},      {"variable", 0},  {"parameter", 0}, {"negate", 1},     {"abs", 1},
    {"square", 1},        {"sqrt", 1},      {"exp", 1},       {"ln", 1},         {"log", 1},
    {"sin", 1},           {"cos", 1},       {"tan", 1},       {"asin", 1},       {"acos", 1},
    {"atan", 1},          {"sinh", 1},      {"cosh", 1},      {"tanh", 1},       {"asinh", 1},
    {"acosh", 1},         {"atanh", 1},     {"floor", 1},     {"ceil", 1},       {"int", 1},
    {"add", 2},           {"subtract", 2},  {"multiply", 2},  {"divide", 2},     {"pow", 2},
    {"atan2", 2},         {"mod", 2},       {"div", 2},       {"min", 2},        {"max", 2},
    {"equal", 2},         {"not-equal", 2}, {"less", 2},      {"less-equal", 2}, {"greater", 2},
    {"greater-equal", 2}, {"and", 2},       {"or", 2},        {"select3", 3},    {"select4", 4},
    {"noise", 4},         {"noise-x", 3},   {"noise-y", 3},   {"noise-z", 3},    {"crackle", 3},
    {"sum", -1},          {"prod", -1},
}};

}  // namespace

std::string_view name(Operation operation) { return facts[static_cast<int>(operation)].name; }

int arity(Operation operation) { return facts[static_cast<int>(operation)].arity; }

}  // namespace isoscope
