// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include "widgets/studies/study_panel.h"

namespace isoscope {

/// The panels below the picture, in the order of their tabs. A new one is a row of study_panels.cpp: layout,
/// menu, help, and what every panel is told follow from it.
class StudyPanels {
  public:
    /// One panel, by the id that is stored, the title of its tab and the text of What's This.
    struct Entry {
        const char* id;  ///< of its place in a stored layout
        QString title;
        QString help;
        StudyPanel* panel;
    };

    /// Makes all panels; they have no parent yet.
    StudyPanels();

    /// All panels, in the order of their tabs.
    const QList<Entry>& entries() const { return entries_; }
    /// The one of this class; there is one of each.
    template <class Panel>
    Panel* get() const {
        for (const Entry& entry : entries_)
            if (auto* panel = qobject_cast<Panel*>(entry.panel)) return panel;
        return nullptr;
    }

  private:
    QList<Entry> entries_;
};

}  // namespace isoscope
