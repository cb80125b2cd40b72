// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/edit_journal.h"

#include <algorithm>
#include <QDataStream>
#include <QIODevice>
#include <utility>

namespace isoscope {

namespace {

constexpr quint32 magic = 0x49534a31;  // "ISJ1": another form gets another number

/// Makes `next` a part of `last` where both touch: a drag rewrites one number many times.
bool merge(EditJournal::Replacement& last, const EditJournal::Replacement& next) {
    const qint64 from = next.begin - last.begin;
    if (from < 0 || from + next.removed.size() > last.inserted.size()) return false;
    last.inserted.replace(from, next.removed.size(), next.inserted);
    return true;
}

qsizetype sizeOf(const EditJournal::Step& step) {
    qsizetype bytes = step.record.size();
    for (const auto& part : step.text) bytes += part.removed.size() + part.inserted.size();
    return bytes;
}

}  // namespace

void EditJournal::clear() {
    steps_.clear();
    done_ = saved_ = 0;
}

void EditJournal::change(qint64 at, const QByteArray& text, bool inserted, bool begins) {
    const Replacement change = inserted ? Replacement{at, {}, text} : Replacement{at, text, {}};
    if (begins || done_ == 0 || !steps_[static_cast<std::size_t>(done_ - 1)].kind.isEmpty()) add({});
    if (saved_ >= done_) saved_ = -1;
    std::vector<Replacement>& parts = steps_.back().text;
    if (parts.empty() || !merge(parts.back(), change)) parts.push_back(change);
}

void EditJournal::add(Step step) {
    steps_.resize(static_cast<std::size_t>(done_));
    if (saved_ > done_) saved_ = -1;
    steps_.push_back(std::move(step));
    ++done_;
}

void EditJournal::undone() { done_ = std::max(0, done_ - 1); }

void EditJournal::redone() { done_ = std::min(done_ + 1, static_cast<int>(steps_.size())); }

std::optional<QByteArray> EditJournal::textAfter(int count, QByteArray text) const {
    if (count < 0 || count > done_) return {};
    for (int i = done_ - 1; i >= count; --i) {
        const std::vector<Replacement>& parts = steps_[static_cast<std::size_t>(i)].text;
        for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
            const qsizetype size = part->inserted.size();
            if (part->begin < 0 || part->begin + size > text.size() ||
                QByteArrayView(text).sliced(part->begin, size) != part->inserted)
                return {};
            text.replace(part->begin, size, part->removed);
        }
    }
    return text;
}

QByteArray EditJournal::packed() const {
    // From the end: the last steps are those that somebody takes back.
    std::size_t first = steps_.size();
    qsizetype bytes = 0;
    while (first > 0 && steps_.size() - first < mostSteps) {
        bytes += sizeOf(steps_[first - 1]);
        if (bytes > mostBytes) break;
        --first;
    }
    const auto left = static_cast<int>(first);
    if (left > done_) return {};
    QByteArray result;
    QDataStream stream(&result, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_0);
    stream << magic << qint32(steps_.size() - first) << qint32(done_ - left)
           << qint32(saved_ < left ? -1 : saved_ - left);
    for (std::size_t i = first; i < steps_.size(); ++i) {
        const Step& step = steps_[i];
        stream << step.kind << step.record << step.joined << qint32(step.text.size());
        for (const Replacement& part : step.text) stream << part.begin << part.removed << part.inserted;
    }
    return result;
}

std::optional<EditJournal> EditJournal::unpacked(const QByteArray& bytes) {
    QDataStream stream(bytes);
    stream.setVersion(QDataStream::Qt_6_0);
    quint32 first = 0;
    qint32 count = 0, done = 0, saved = 0;
    stream >> first >> count >> done >> saved;
    if (stream.status() != QDataStream::Ok || first != magic || count < 0 || count > mostSteps || done < 0 ||
        done > count || saved > count)
        return {};
    EditJournal journal;
    for (qint32 i = 0; i < count; ++i) {
        Step step;
        qint32 parts = 0;
        stream >> step.kind >> step.record >> step.joined >> parts;
        for (qint32 k = 0; k < parts && stream.status() == QDataStream::Ok; ++k) {
            Replacement part;
            stream >> part.begin >> part.removed >> part.inserted;
            step.text.push_back(std::move(part));
        }
        if (stream.status() != QDataStream::Ok) return {};
        journal.steps_.push_back(std::move(step));
    }
    if (!stream.atEnd()) return {};
    journal.done_ = done;
    journal.saved_ = std::max(saved, qint32(-1));
    return journal;
}

}  // namespace isoscope
