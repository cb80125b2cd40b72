// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QList>
#include <QString>

#include "widgets/studies/study_panel.h"

namespace isoscope {

class Actions;
class Docks;
class ParameterPanel;
class ProblemsPanel;
class QuickFixer;
class SceneEditor;
class SceneRepairer;
class SceneSession;
class SettingWriter;
class StudyPanels;
class Viewport;

/// What a panel can be connected with, beside what all panels are told; all of it outlives the panels.
struct StudyLinks {
    const Actions* actions;
    Viewport* viewport;
    Docks* docks;
    SettingWriter* settings;
    ParameterPanel* parameters;
    SceneSession* session;
    SceneEditor* editor;
    QuickFixer* fixer;
    SceneRepairer* repairer;
    ProblemsPanel* problems;
    const StudyPanels* panels;  ///< the other ones
};

/// The panels below the picture, in the order of their tabs. A new one is a row of study_panels.cpp: layout,
/// menu, help, what every panel is told, and what it is connected with follow from it.
class StudyPanels {
  public:
    /// One panel.
    struct Entry {
        const char* id;  ///< of its place in a stored layout
        QString title;   ///< of its tab
        QString help;    ///< what What's This says
        StudyPanel* panel;
        std::function<void(const StudyLinks&)> connect;  ///< empty where what all are told is enough
        bool closed = false;  ///< at first: the row of tabs has to fit a small window
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
