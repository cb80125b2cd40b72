// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/parse_context.h"

#include <algorithm>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

bool sayTheSame(const Diagnostic& a, const Diagnostic& b) {
    return a.id == b.id && a.range == b.range && a.message == b.message;
}

/// A message with its beginning and end alone where it is endless, as one that cites a name of a megabyte is.
std::string shortened(std::string message) {
    constexpr std::size_t most = 2000, beginning = 400, end = 200;
    if (message.size() <= most) return message;
    const auto isInside = [&](std::size_t at) { return (message[at] & 0xc0) == 0x80; };  // of a character
    std::size_t head = beginning, tail = message.size() - end;
    while (head > 0 && isInside(head)) --head;
    while (tail < message.size() && isInside(tail)) ++tail;
    return message.substr(0, head) + " ... " + message.substr(tail);
}

}  // namespace

std::unique_ptr<const ReadingLimits> limitsOf(const ParseOptions& options) {
    return std::make_unique<const ReadingLimits>(options.stop, options.secondsBudget, options.memoryBudget);
}

ParseContext::ParseContext(ParseOptions parseOptions) : ParseContext(parseOptions, limitsOf(parseOptions)) {}

ParseContext::ParseContext(ParseOptions parseOptions, std::unique_ptr<const ReadingLimits> begun)
    : options(std::move(parseOptions)), limits(std::move(begun)), noiseGenerator(options.noiseGenerator) {
    options.stop = limits->token();
    for (const auto& [name, value] : options.declarations) symbols.declare(name, {NumberValue{value}});
}

Diagnostic ParseContext::stopMessage(const SourceRange& range) const {
    const auto error = [&](const char* id, std::string message, const char* hint) {
        return Diagnostic{Severity::error, id, range, std::move(message), hint, {}};
    };
    switch (limits->reason()) {
        case ReadingLimits::Reason::time:
            return error("time-limit",
                         "Reading stops here: it has taken " + shortestNumber(options.secondsBudget) +
                             " seconds, the limit of time.",
                         "`--time-limit` of the command line allows more");
        case ReadingLimits::Reason::memory:
            return error("memory-limit",
                         "Reading stops here: the text asks for more than " +
                             std::to_string(options.memoryBudget / 1'000'000) + " MB of memory.",
                         "make fewer or smaller parts");
        default: return error("stopped", "Reading was stopped here.", "it begins anew when the text changes");
    }
}

bool ParseContext::keeps(const Diagnostic& diagnostic) const {
    return diagnostics.size() < options.diagnosticLimit && !isDropped(diagnostic);
}

bool ParseContext::isDropped(const Diagnostic& diagnostic) const {
    if (!complete && (diagnostic.severity == Severity::error || diagnostic.severity == Severity::warning))
        return true;
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [&](const Diagnostic& present) { return sayTheSame(present, diagnostic); });
}

void ParseContext::report(Diagnostic diagnostic) {
    diagnostic.message = shortened(std::move(diagnostic.message));
    diagnostic.hint = shortened(std::move(diagnostic.hint));
    if (isDropped(diagnostic)) return;
    if (diagnostic.reachedFrom.empty()) diagnostic.reachedFrom = reachedFrom(diagnostic.range);
    if (diagnostics.size() < options.diagnosticLimit) {
        diagnostics.push_back(std::move(diagnostic));
        return;
    }
    // An error must not hide behind the limit: the text would count as understood.
    const bool firstError = diagnostic.severity == Severity::error && !hasErrors(diagnostics);
    if (droppedDiagnostics == 0) diagnostics.push_back({Severity::note, "too-many-messages", {}, {}, {}, {}});
    if (firstError)
        diagnostics.insert(diagnostics.end() - 1, std::move(diagnostic));
    else
        ++droppedDiagnostics;
    diagnostics.back().message = std::to_string(droppedDiagnostics) + " further messages are not shown.";
}

void ParseContext::error(std::string id, const SourceRange& range, std::string message, std::string hint) {
    report({Severity::error, std::move(id), range, std::move(message), std::move(hint), {}});
}

void ParseContext::warning(std::string id, const SourceRange& range, std::string message, std::string hint) {
    report({Severity::warning, std::move(id), range, std::move(message), std::move(hint), {}});
}

void ParseContext::note(std::string id, const SourceRange& range, std::string message, std::string hint) {
    report({Severity::note, std::move(id), range, std::move(message), std::move(hint), {}});
}

void ParseContext::leftOut(const SourceRange& range, std::string what) {
    report({Severity::leftOut, "left-out", range, "`" + what + "` is not simulated.", {}, {}});
}

int ParseContext::addParameter(SceneParameter parameter) {
    parameter.slot = static_cast<int>(parameterTable.size());
    parameterTable.push_back(parameter.value);
    parameters.push_back(std::move(parameter));
    return static_cast<int>(parameters.size() - 1);
}

void ParseContext::markStructural(int parameter) {
    const auto index = static_cast<std::size_t>(parameter);
    if (parameter >= 0 && index < parameters.size()) parameters[index].slot = -1;
}

void ParseContext::markStructural(const Function& function) {
    if (!function.valid()) return;
    for (NodeId id = 0; id < function.graph->size(); ++id) {
        const Node& node = (*function.graph)[id];
        if (node.operation == Operation::sum || node.operation == Operation::product)
            markStructural(function.graph->loopBody(node.index));
        if (node.operation != Operation::parameter) continue;
        for (SceneParameter& parameter : parameters)
            if (parameter.slot == static_cast<int>(node.index)) parameter.slot = -1;
    }
}

void ParseContext::leaveCall() {
    // When several texts end at the same place the innermost is worth remembering.
    const bool partOfLast = finishedCalls_.size() > calls.size() &&
                            std::equal(calls.begin(), calls.end(), finishedCalls_.begin());
    if (!partOfLast) finishedCalls_ = calls;
    calls.pop_back();
}

std::vector<SourceRange> ParseContext::reachedFrom(const SourceRange& range) const {
    const auto depthAt = [&range](const std::vector<Call>& chain) {
        const auto contains = [&range](const Call& call) {
            return call.text.file == range.file && call.text.begin <= range.begin &&
                   range.end <= call.text.end;
        };
        return chain.rend() - std::find_if(chain.rbegin(), chain.rend(), contains);
    };
    std::vector<SourceRange> sites;
    const std::vector<Call>& chain = depthAt(calls) > 0 ? calls : finishedCalls_;
    for (auto i = depthAt(chain); i-- > 0;) sites.push_back(chain[static_cast<std::size_t>(i)].site);
    // Of a recursion without end, the last calls and the first one are worth telling.
    constexpr std::size_t siteLimit = 16;
    if (sites.size() > siteLimit) sites.erase(sites.begin() + siteLimit - 1, sites.end() - 1);
    return sites;
}

}  // namespace isoscope
