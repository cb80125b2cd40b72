// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include "core/language/parse.h"
#include "core/study/gradient/gradient_study.h"

namespace isoscope::test {

/// A function body compiled; fails the running test when it has errors.
struct StudiedFunction {
    explicit StudiedFunction(const std::string& body) {
        const ParsedFunction parsed = parseFunction(body);
        if (!parsed.ok()) QFAIL(qPrintable("no function: " + QString::fromStdString(body)));
        function = parsed.value.function;
        parameters = parsed.parameterTable;
        tape = Tape::compile(function);
    }

    Function function;
    std::shared_ptr<const Tape> tape;
    std::vector<double> parameters;
};

}  // namespace isoscope::test
