// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/slider_note.h"

#include <charconv>
#include <cmath>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// Reads a note sign by sign; each function leaves the place where it was unless it succeeds.
class NoteReader {
  public:
    explicit NoteReader(std::string_view text) : text_(text) {}

    std::size_t place() const { return at_; }

    bool sign(char wanted) {
        const std::size_t at = behindBlanks();
        if (at >= text_.size() || text_[at] != wanted) return false;
        at_ = at + 1;
        return true;
    }
    bool word(std::string_view wanted) {
        const std::size_t at = behindBlanks();
        if (text_.substr(at, wanted.size()) != wanted) return false;
        const std::size_t end = at + wanted.size();
        if (end < text_.size() && !isBlank(text_[end]) && text_[end] != ']') return false;
        at_ = end;
        return true;
    }
    template <class Number>
    bool number(Number& value) {
        std::size_t at = behindBlanks();
        if (at < text_.size() && text_[at] == '+') ++at;
        const auto [end, error] = std::from_chars(text_.data() + at, text_.data() + text_.size(), value);
        if (error != std::errc()) return false;
        at_ = static_cast<std::size_t>(end - text_.data());
        return true;
    }

  private:
    std::size_t behindBlanks() const {
        std::size_t at = at_;
        while (at < text_.size() && isBlank(text_[at])) ++at;
        return at;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

struct ReadNote {
    SliderNote note;
    std::size_t length = 0;
};

std::optional<ReadNote> readNote(std::string_view text) {
    NoteReader reader(text);
    SliderNote note;
    if (!reader.sign('[') || !reader.number(note.minimum) || !reader.sign(':') ||
        !reader.number(note.maximum))
        return std::nullopt;
    if (reader.sign(':') && !(reader.number(note.step) && note.step > 0)) return std::nullopt;
    while (!reader.sign(']')) {
        if (reader.word("log"))
            note.logarithmic = true;
        else if (reader.word("locked"))
            note.locked = true;
        else if (!reader.word("decimals") || !reader.number(note.decimals) || note.decimals < 0)
            return std::nullopt;
    }
    if (!isUsable(note)) return std::nullopt;
    return ReadNote{note, reader.place()};
}

/// What follows a number on its line, by byte offsets of the text.
struct NotePlace {
    std::size_t codeEnd;           ///< behind the number and its closing signs
    std::size_t comment;           ///< the `//`, or the line's end without one
    std::size_t words;             ///< first byte of the comment that is no blank
    std::size_t lineEnd;           ///< before the line break
    std::optional<ReadNote> note;  ///< at `words`
};

std::optional<NotePlace> notePlace(std::string_view text, std::size_t numberEnd) {
    if (numberEnd > text.size()) return std::nullopt;
    constexpr std::string_view closing = ";,)}>", lineBreak = "\r\n";
    const auto isOneOf = [](std::string_view signs, char c) {
        return signs.find(c) != std::string_view::npos;
    };
    std::size_t codeEnd = numberEnd, at = numberEnd;
    for (; at < text.size() && (isBlank(text[at]) || isOneOf(closing, text[at])); ++at)
        if (!isBlank(text[at])) codeEnd = at + 1;
    if (at >= text.size() || isOneOf(lineBreak, text[at])) return NotePlace{codeEnd, at, at, at, {}};
    if (text.substr(at, 2) != "//") return std::nullopt;
    // The line is looked through behind a comment's beginning only: else a long one with a thousand numbers
    // would be, a thousand times.
    const std::string_view line = text.substr(0, text.find_first_of(lineBreak, at));
    NotePlace place{codeEnd, at, at, line.size(), {}};
    at += 2;
    while (at < line.size() && isBlank(line[at])) ++at;
    place.words = at;
    place.note = readNote(line.substr(at));
    return place;
}

TextEdit edit(std::size_t begin, std::size_t end, std::string text) {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), std::move(text)};
}

TextEdit removal(std::string_view text, const NotePlace& place) {
    std::size_t end = place.words + place.note->length;
    while (end < place.lineEnd && isBlank(text[end])) ++end;
    return end == place.lineEnd ? edit(place.codeEnd, end, {}) : edit(place.words, end, {});
}

}  // namespace

bool isUsable(const SliderNote& note) {
    if (!std::isfinite(note.minimum) || !std::isfinite(note.maximum) || !(note.minimum < note.maximum))
        return false;
    if (!(note.step >= 0) || note.step > note.maximum - note.minimum) return false;
    return note.decimals >= -1 && note.decimals <= mostDecimals && (!note.logarithmic || note.minimum > 0);
}

std::optional<SliderNote> readSliderNote(std::string_view text) {
    const std::optional<ReadNote> read = readNote(text);
    return read ? std::optional(read->note) : std::nullopt;
}

std::optional<SliderNoteMistake> sliderNoteMistake(std::string_view text, std::size_t numberEnd) {
    const std::optional<NotePlace> place = notePlace(text, numberEnd);
    if (!place || place->note) return std::nullopt;
    const std::string_view words = text.substr(place->words, place->lineEnd - place->words);
    NoteReader reader(words);
    double low = 0, high = 0;
    if (!reader.sign('[') || !reader.number(low) || !reader.sign(':') || !reader.number(high))
        return std::nullopt;
    const std::size_t close = words.find(']');
    SliderNoteMistake mistake{place->words, place->lineEnd, {}};
    if (close == std::string_view::npos) {
        mistake.reason = "Its `]` is missing.";
        return mistake;
    }
    mistake.end = place->words + close + 1;
    const std::string_view options = words.substr(reader.place(), close - reader.place());
    if (!(low < high) || !std::isfinite(low) || !std::isfinite(high))
        mistake.reason = "Its lower end must be less than the upper one.";
    else if (options.find("log") != std::string_view::npos && low <= 0)
        mistake.reason = "A logarithmic slider has a lower end above 0.";
    else
        mistake.reason = "A step above 0 that fits between the ends, `log`, `decimals` with 0 to " +
                         std::to_string(mostDecimals) + ", and `locked` may follow the range.";
    return mistake;
}

std::string toText(const SliderNote& note) {
    std::string text = "[" + shortestNumber(note.minimum) + ":" + shortestNumber(note.maximum);
    if (note.step > 0) text += ":" + shortestNumber(note.step);
    if (note.logarithmic) text += " log";
    if (note.decimals >= 0) text += " decimals " + std::to_string(note.decimals);
    if (note.locked) text += " locked";
    return text + "]";
}

std::optional<SliderNote> sliderNoteBehind(std::string_view text, std::size_t numberEnd) {
    const std::optional<NotePlace> place = notePlace(text, numberEnd);
    return place && place->note ? std::optional(place->note->note) : std::nullopt;
}

std::optional<TextEdit> sliderNoteEdit(std::string_view text, std::size_t numberEnd,
                                       const std::optional<SliderNote>& note) {
    const std::optional<NotePlace> place = notePlace(text, numberEnd);
    if (!place) return std::nullopt;
    if (!note) return place->note ? std::optional(removal(text, *place)) : std::nullopt;
    if (place->note) return edit(place->words, place->words + place->note->length, toText(*note));
    if (place->comment == place->lineEnd)
        return edit(place->codeEnd, place->codeEnd, "  // " + toText(*note));
    const bool empty = place->words == place->lineEnd;
    const bool joined = place->words == place->comment + 2;  // no blank behind the `//`
    return edit(place->words, place->words, (joined ? " " : "") + toText(*note) + (empty ? "" : " "));
}

}  // namespace isoscope
