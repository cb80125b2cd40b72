// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/tape_lookup.h"

namespace isoscope {

void TapeLookup::Questions::clear() {
    for (std::vector<double>& column : arguments) column.clear();
    numbers.clear();
}

void TapeLookup::ask(const std::shared_ptr<const Tape>& tape, std::span<const double> arguments,
                     std::size_t number) {
    Questions& questions = questions_[tape.get()];
    if (!questions.evaluator) {
        questions.evaluator = std::make_unique<PointEvaluator>(tape, parameters_);
        questions.arguments.resize(static_cast<std::size_t>(tape->argumentCount()));
        questions.results.resize(tape->results().size());
    }
    for (std::size_t k = 0; k < questions.arguments.size(); ++k)
        questions.arguments[k].push_back(arguments[k]);
    questions.numbers.push_back(number);
}

void TapeLookup::evaluate(Questions& questions) {
    const std::size_t count = questions.numbers.size();
    std::vector<const double*> arguments;
    for (const std::vector<double>& column : questions.arguments) arguments.push_back(column.data());
    std::vector<double*> results;
    for (std::vector<double>& column : questions.results) {
        if (column.size() < count) column.resize(count);
        results.push_back(column.data());
    }
    questions.evaluator->evaluateAll(arguments, count, results);
}

}  // namespace isoscope
