// SPDX-License-Identifier: Apache-2.0
// The font families of the panel; see fonts.h.
#include "app/shell/fonts.h"

#include <QFile>
#include <QFont>
#include <QFontDatabase>
#include <QFontMetrics>
#include <QGuiApplication>

#include <array>

namespace campanel::shell {
namespace {

struct Family {
    const char* name;
    const char* package;
};
constexpr Family latinFamily{"Open Sans", "fonts-open-sans"};
constexpr Family chineseFamily{"Noto Sans CJK SC", "fonts-noto-cjk"};
constexpr Family iconFamily{"Material Design Icons", "fonts-materialdesignicons-webfont"};

} // namespace

void applyFonts()
{
    // The path beside the program in the build tree and in the installation.
    const QString list =
        QCoreApplication::applicationDirPath() + QStringLiteral("/../share/campanel/fonts.conf");
    if (qEnvironmentVariableIsEmpty("FONTCONFIG_FILE") && QFile::exists(list))
        qputenv("FONTCONFIG_FILE", QFile::encodeName(list));
    QFont font;
    font.setFamilies({QString::fromLatin1(latinFamily.name), QString::fromLatin1(chineseFamily.name)});
    QGuiApplication::setFont(font);
}

bool hasGlyph(char32_t letter)
{
    return QFontMetrics(QGuiApplication::font()).inFontUcs4(letter);
}

QStringList missingFonts()
{
    const QStringList installed = QFontDatabase::families();
    QStringList sentences;
    for (const Family& family : std::array{latinFamily, chineseFamily, iconFamily}) {
        const QString name = QString::fromLatin1(family.name);
        if (!installed.contains(name))
            sentences += QStringLiteral("The font \"%1\" is not installed; install the package %2.")
                             .arg(name, QString::fromLatin1(family.package));
    }
    return sentences;
}

} // namespace campanel::shell
