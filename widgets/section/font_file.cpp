// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/font_file.h"

#include <fontconfig/fontconfig.h>
#include <memory>
#include <QFileInfo>

namespace isoscope {

QString fontFile(const QString& family) {
    const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> wanted(FcPatternCreate(),
                                                                         &FcPatternDestroy);
    if (!wanted) return {};
    const QByteArray name = family.toUtf8();
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(name.constData()));
    FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> found(
        FcFontMatch(nullptr, wanted.get(), &result), &FcPatternDestroy);
    FcChar8* file = nullptr;  // belongs to the pattern
    int index = 0;
    if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
    if (FcPatternGetInteger(found.get(), FC_INDEX, 0, &index) == FcResultMatch && index != 0) return {};
    const QString path = QString::fromUtf8(reinterpret_cast<const char*>(file));
    return QFileInfo(path).isReadable() ? path : QString();
}

bool hasFonts() {
    for (const FcSetName set : {FcSetSystem, FcSetApplication})
        if (const FcFontSet* fonts = FcConfigGetFonts(nullptr, set); fonts && fonts->nfont > 0) return true;
    return false;
}

}  // namespace isoscope
