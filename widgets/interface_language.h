// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

namespace isoscope {

/// A language that the window speaks: its code by ISO 639, such as "es", and its own name for itself.
struct InterfaceLanguage {
    QString code, name;
};

/// English first, then those that resources/translations has.
const QList<InterfaceLanguage>& interfaceLanguages();

/// The code of the language that was chosen; empty for the system's, also where the stored one is unknown.
QString chosenInterfaceLanguage();

/// Stores the choice; texts that are made already stay as they are, so it counts from the next start on.
void chooseInterfaceLanguage(const QString& code);

/// The first of the system's languages that the window speaks, by their order; English if there is none.
/// `wanted` has names such as "es-MX" or "es_MX".
QString bestInterfaceLanguage(const QStringList& wanted);

/// Texts made from now on are in the chosen language, Qt's own, too, where its translations are installed.
/// Belongs to the thread of the window; needs the application.
void applyInterfaceLanguage();

/// The words of a label or menu entry without its access key: "&Save", or "保存(&S)" where letters are none
/// of the keyboard's. "&&" becomes "&".
QString withoutAccessKey(QString text);

}  // namespace isoscope
