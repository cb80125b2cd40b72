// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <QDataStream>
#include <QIODevice>
#include <QTimer>
#include <utility>

#include "widgets/editor/edit_history.h"
#include "widgets/numbers/undo_group.h"

namespace isoscope {

/// Enters the changes of a state beside the text (the view, the plane of the cross-section) into the editor's
/// history: a drag, or changes that follow one another closely, are one step. `State` has ==.
///
/// A change of the text may bring a new state with it: another camera in the text is another view. When such
/// a change is taken back the state that belonged to the earlier text returns, moved as it was.
template <typename State>
class StateHistory {
  public:
    /// How the state is read and set; none may be empty.
    struct Access {
        /// The present state, and setting it; what setting changes is not entered into the history.
        std::function<State()> state;
        std::function<void(const State&)> show;
        /// A mouse button or a slider is held: what comes belongs to the same step.
        std::function<bool()> dragging;
        /// For histories that are stored, as EditHistory::Step: a name, and the state as bytes and back. What
        /// bytes leave out is taken from the present state.
        QString kind = {};
        std::function<QByteArray(const State&)> pack = {};
        std::function<State(const QByteArray&)> unpack = {};
    };

    /// `history` must outlive this.
    StateHistory(EditHistory* history, Access access) : history_(history), access_(std::move(access)) {
        timer_.setSingleShot(true);
        timer_.setInterval(UndoGroup::pause);
        QObject::connect(&timer_, &QTimer::timeout, &timer_,
                         [this] { access_.dragging() ? timer_.start() : end(); });
        QObject::connect(history, &EditHistory::textEntered, &timer_, [this](int before) {
            ofTexts_.erase(ofTexts_.upper_bound(before), ofTexts_.end());
        });
        known_ = access_.state();
        if (access_.pack)
            history->setReviver(access_.kind, [this](const QByteArray& record) { return revived(record); });
    }

    /// The user changed the state; `joined`: a change of the text did, of whose step this is a part.
    void changed(bool joined = false) {
        if (showing_) return;
        const State now = access_.state();
        if (now == known_) return;
        if (!joined && record_ && serial_ == history_->serial()) {
            record_->after = now;
        } else {
            record_ = std::make_shared<Record>(Record{known_, now});
            enter(record_, joined);
            serial_ = history_->serial();
        }
        know(now);
        timer_.start();
    }

    /// The drag is over: the next change is another step.
    void end() {
        timer_.stop();
        record_.reset();
    }

    /// Another scene brought another state: no step.
    void replaced() {
        if (showing_) return;
        end();
        const auto of = ofTexts_.upper_bound(history_->textState());
        if (history_->textCameBack() && of != ofTexts_.begin() && !(std::prev(of)->second == access_.state()))
            return show(State(std::prev(of)->second));
        know(access_.state());
    }

    /// A new document.
    void reset() {
        end();
        ofTexts_.clear();
        known_ = access_.state();
    }

  private:
    struct Record {
        State before, after;
    };

    void enter(const std::shared_ptr<Record>& record, bool joined) {
        EditHistory::Step step{[this, record] { show(record->before); },
                               [this, record] { show(record->after); }, joined};
        if (access_.pack) {
            step.kind = access_.kind;
            step.record = [this, record] {
                QByteArray bytes;
                QDataStream stream(&bytes, QIODevice::WriteOnly);
                stream << access_.pack(record->before) << access_.pack(record->after);
                return bytes;
            };
        }
        history_->add(std::move(step));
    }

    EditHistory::Step revived(const QByteArray& record) {
        QByteArray before, after;
        QDataStream stream(record);
        stream >> before >> after;
        return {[this, before] { show(access_.unpack(before)); },
                [this, after] { show(access_.unpack(after)); }, false, access_.kind,
                [record] { return record; }};
    }

    void show(const State& state) {
        end();
        showing_ = true;
        access_.show(state);
        showing_ = false;
        know(access_.state());
    }

    void know(const State& state) {
        known_ = state;
        ofTexts_[history_->textState()] = state;
    }

    EditHistory* history_;
    Access access_;
    QTimer timer_;
    State known_;                     ///< as the history has it
    std::shared_ptr<Record> record_;  ///< of the step that is still growing
    quint64 serial_ = 0;              ///< of the history when it was last on top
    std::map<int, State> ofTexts_;    ///< the last state of a text, from this one up to the next entry
    bool showing_ = false;
};

}  // namespace isoscope
