// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/line_difference.h"

#include <algorithm>
#include <QStringList>

namespace isoscope {

namespace {

using Kind = DifferenceLine::Kind;

constexpr int mostDifferences = 2000;

/// Ways of the search, kept to walk back: the farthest place on each diagonal after each step.
using Trace = std::vector<std::vector<int>>;

/// Empty when there are too many differences.
Trace search(const QStringList& a, const QStringList& b) {
    const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
    const int most = std::min(n + m, mostDifferences);
    Trace trace;
    std::vector<int> farthest(static_cast<std::size_t>(2 * most + 3), 0);
    const auto at = [&](int diagonal) -> int& {
        return farthest[static_cast<std::size_t>(diagonal + most + 1)];
    };
    for (int steps = 0; steps <= most; ++steps) {
        trace.push_back(
            {farthest.begin() + (most + 1 - steps - 1), farthest.begin() + (most + 1 + steps + 2)});
        for (int k = -steps; k <= steps; k += 2) {
            const bool down = k == -steps || (k != steps && at(k - 1) < at(k + 1));
            int x = down ? at(k + 1) : at(k - 1) + 1;
            while (x < n && x - k < m && a[x] == b[x - k]) ++x;
            at(k) = x;
            if (x >= n && x - k >= m) return trace;
        }
    }
    return {};
}

/// The kinds of the lines, from the first to the last.
std::vector<Kind> walkBack(const Trace& trace, int n, int m) {
    std::vector<Kind> kinds;
    int x = n, y = m;
    for (int steps = static_cast<int>(trace.size()) - 1; steps >= 0; --steps) {
        const std::vector<int>& before = trace[static_cast<std::size_t>(steps)];
        const auto at = [&](int diagonal) { return before[static_cast<std::size_t>(diagonal + steps + 1)]; };
        const int k = x - y;
        const bool down = k == -steps || (k != steps && at(k - 1) < at(k + 1));
        const int fromX = steps == 0 ? 0 : down ? at(k + 1) : at(k - 1);
        const int fromY = steps == 0 ? 0 : fromX - (down ? k + 1 : k - 1);
        for (; x > fromX && y > fromY; --x, --y) kinds.push_back(Kind::both);
        if (steps > 0) kinds.push_back(down ? Kind::onlySecond : Kind::onlyFirst);
        x = fromX;
        y = fromY;
    }
    std::reverse(kinds.begin(), kinds.end());
    return kinds;
}

}  // namespace

std::vector<DifferenceLine> lineDifference(const QString& first, const QString& second) {
    const QStringList a = first.split(u'\n'), b = second.split(u'\n');
    const auto [endA, endB] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const int same = static_cast<int>(endA - a.begin());
    const QStringList restA = a.mid(same), restB = b.mid(same);
    std::vector<Kind> kinds(static_cast<std::size_t>(same), Kind::both);
    const Trace trace = search(restA, restB);
    if (trace.empty()) {
        kinds.insert(kinds.end(), static_cast<std::size_t>(restA.size()), Kind::onlyFirst);
        kinds.insert(kinds.end(), static_cast<std::size_t>(restB.size()), Kind::onlySecond);
    } else {
        const std::vector<Kind> rest =
            walkBack(trace, static_cast<int>(restA.size()), static_cast<int>(restB.size()));
        kinds.insert(kinds.end(), rest.begin(), rest.end());
    }
    std::vector<DifferenceLine> lines;
    int i = 0, j = 0;
    for (const Kind kind : kinds) {
        const bool inFirst = kind != Kind::onlySecond, inSecond = kind != Kind::onlyFirst;
        const QString text = inFirst ? a[i] : b[j];
        i += inFirst;
        j += inSecond;
        lines.push_back({kind, text, inFirst ? i : 0, inSecond ? j : 0});
    }
    return lines;
}

}  // namespace isoscope
