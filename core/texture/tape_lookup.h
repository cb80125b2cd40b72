// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/point_evaluator.h"
#include "core/shapes/trace_context.h"

namespace isoscope {

/// Values of tapes at many points: collects questions, and answers those to one tape together. Keeps scratch
/// memory: one object per thread.
class TapeLookup : public ShapeState {
  public:
    explicit TapeLookup(std::span<const double> parameters)
        : parameters_(parameters.begin(), parameters.end()) {}

    /// Asks for all results of a tape. There are as many arguments as it has; the answer bears `number`.
    void ask(const std::shared_ptr<const Tape>& tape, std::span<const double> arguments, std::size_t number);

    /// Calls visit(number, results) for every question since the last time, in no particular order; returns
    /// how many there were.
    template <class Visit>
    std::size_t answer(Visit visit) {
        std::size_t count = 0;
        for (auto& [tape, questions] : questions_) {
            if (questions.numbers.empty()) continue;
            evaluate(questions);
            std::vector<double> results(questions.results.size());
            for (std::size_t i = 0; i < questions.numbers.size(); ++i) {
                for (std::size_t r = 0; r < results.size(); ++r) results[r] = questions.results[r][i];
                visit(questions.numbers[i], std::span<const double>(results));
            }
            count += questions.numbers.size();
            questions.clear();
        }
        return count;
    }

  private:
    struct Questions {
        std::unique_ptr<PointEvaluator> evaluator;
        std::vector<std::vector<double>> arguments;  ///< one column each
        std::vector<std::vector<double>> results;
        std::vector<std::size_t> numbers;

        void clear();
    };

    static void evaluate(Questions& questions);

    std::vector<double> parameters_;
    std::map<const Tape*, Questions> questions_;
};

}  // namespace isoscope
