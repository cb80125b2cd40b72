// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <QDialog>
#include <vector>

class QListWidget;

namespace isoscope {

/// The folders in which #include looks, besides the file's own; kept in the settings when accepted. Deletes
/// itself when closed.
class IncludeFoldersDialog : public QDialog {
    Q_OBJECT
  public:
    explicit IncludeFoldersDialog(QWidget* parent = nullptr);

    /// The stored folders, then those of an installed POV-Ray.
    static std::vector<std::filesystem::path> searchedPaths();

  public slots:
    void accept() override;

  private:
    void addFolder();
    void removeFolder();

    QListWidget* list_;
};

}  // namespace isoscope
