// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/man_page.h"

#include <algorithm>
#include <cctype>

namespace isoscope {
namespace {

/// A hyphen would be set as a dash, a dot at the beginning of a line would be a request.
std::string escaped(std::string_view text) {
    std::string out;
    bool beginsLine = true;
    for (const char c : text) {
        if (beginsLine && (c == '.' || c == '\'')) out += "\\&";
        beginsLine = c == '\n';
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out;
}

std::string paragraphs(const std::string& text) {
    std::string out;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find("\n\n", at), text.size());
        if (at > 0) out += ".PP\n";
        out += escaped(text.substr(at, end - at)) + '\n';
        at = end + 2;
    }
    return out;
}

bool isMain(const std::string& title) {
    return std::ranges::none_of(title, [](unsigned char c) { return std::islower(c); });
}

}  // namespace

std::string toRoff(const ManPage& page) {
    std::string out = ".TH " + page.program + " 1 \"\" \"" + page.program + ' ' + page.version + "\"\n";
    std::ranges::transform(page.program, out.begin() + 4, [](unsigned char c) { return std::toupper(c); });
    out += ".SH NAME\n" + escaped(page.program) + " \\- " + escaped(page.summary) + '\n';
    out += ".SH SYNOPSIS\n.B " + escaped(page.program) + "\n" + escaped(page.synopsis) + '\n';
    for (const ManSection& section : page.sections) {
        out += (isMain(section.title) ? ".SH \"" : ".SS \"") + escaped(section.title) + "\"\n";
        out += paragraphs(section.text);
        for (const ManEntry& entry : section.entries)
            out += ".TP\n\\fB" + escaped(entry.term) + "\\fR\n" + escaped(entry.text) + '\n';
    }
    return out;
}

}  // namespace isoscope
