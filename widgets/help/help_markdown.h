// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QPalette>
#include <QString>
#include <vector>

class QTextDocument;

namespace isoscope {

/// A scene of a page, as it is opened.
struct HelpScene {
    QString text;
    QString title;          ///< of the comment in its first line
    bool asPovray = false;  ///< it is about what POV-Ray loses
    bool composed = true;   ///< it has a view of its own
};

/// A page whose links lead to pages alone.
struct PreparedPage {
    QString markdown;
    std::vector<HelpScene> scenes;  ///< the link "scene:0" stands before the first one
};

/// Addresses of pages are paths below `docs`, "help/README.md", with the anchor of a heading behind `#` where
/// one is meant.

/// The page that a link of the page `from` leads to.
QString resolvedAddress(const QString& from, const QString& link);

/// The anchor of a heading, as GitHub makes it.
QString headingAnchor(const QString& heading);

/// Makes the text of the page at `address` ready to be shown: links to what is no page, by `isPage`, become
/// text, scenes get a link that opens them, and diagrams are left out.
PreparedPage preparedPage(const QString& text, const QString& address,
                          const std::function<bool(const QString& address)>& isPage);

/// Gives a document read from Markdown the anchors of its headings, and the colours of `palette` for code,
/// tables and links.
void dressDocument(QTextDocument* document, const QPalette& palette);

}  // namespace isoscope
