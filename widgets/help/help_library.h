// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace isoscope {

/// A page in the list of pages.
struct HelpPage {
    QString address;  ///< "help/window.md"; "function/f_torus" for a built-in
    QString title;
    QString group;  ///< the heading of the index that it stands below
    QString text;   ///< what a search looks at: Markdown, of functions without their scenes
};

/// The pages that are built into the program: those of `docs`, and one for each built-in function, made of
/// the tables that the function list is made of. For addresses see help_markdown.h.
class HelpLibrary {
  public:
    /// Makes the pages readable below ":/docs"; the constructor does, too.
    static void registerPages();
    /// Reads the index, and the pages that it names.
    HelpLibrary();

    /// The address of the index.
    static QString index();
    /// The pages that the index names, in its order, then the built-in functions.
    const std::vector<HelpPage>& contents() const { return contents_; }
    /// The addresses of all pages, those as well that others lead to.
    QStringList all() const;
    /// Whether there is a page at an address without anchor.
    bool isPage(const QString& address) const;
    /// The Markdown of the page at an address; empty when there is none.
    QString text(const QString& address) const;
    /// Where a word of the scene language is explained: the page of a built-in function, the section about a
    /// setting of isosurfaces, or the page that names the word as code. Empty for any other word.
    QString addressOf(const QString& word) const;

  private:
    std::vector<HelpPage> contents_;
};

}  // namespace isoscope
