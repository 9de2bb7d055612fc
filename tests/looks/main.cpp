// SPDX-License-Identifier: Apache-2.0
// campanel-looks: every page and dialog of the panel in every variant, checked, captured, or compared with
// approved pictures.
#include "app/shell/fonts.h"
#include "app/shell/qml_modules.h"
#include "tests/looks/baselines.h"
#include "tests/looks/capture.h"
#include "tests/looks/variant_checks.h"

#include <QCommandLineParser>
#include <QGuiApplication>

#include <cstdio>
#include <cstdlib>

namespace {

using namespace campanel;

constexpr int usageError = 2;
const QString defaultVariant = QStringLiteral("light-en-1024x600");

[[noreturn]] void refuse(const QString& sentence)
{
    std::fprintf(stderr, "campanel-looks: %s\n", qPrintable(sentence));
    std::exit(usageError);
}

void refuseWithout(const QCommandLineParser& parser, const QString& option, const QString& needed)
{
    if (parser.isSet(option) && !parser.isSet(needed))
        refuse(QStringLiteral("--%1 needs --%2 FOLDER.").arg(option, needed));
}

// Returns what `named` finds for the option's patterns. A pattern that matches nothing would look like a test
// passed.
template <typename Named>
auto selected(const QCommandLineParser& parser, const QString& option, const QString& example, Named named)
{
    const QString patterns = parser.value(option);
    for (const QString& pattern : patterns.split(u',')) {
        if (named(pattern).isEmpty())
            refuse(QStringLiteral("--%1 \"%2\" matches none of the %1. An example is %3.")
                       .arg(option, pattern, example));
    }
    return named(patterns);
}

// Returns false after naming the packages that are missing.
bool hasFonts()
{
    const QStringList missing = shell::missingFonts();
    for (const QString& sentence : missing)
        std::fprintf(stderr, "campanel-looks: %s\n", qPrintable(sentence));
    return missing.isEmpty();
}

} // namespace

int main(int argc, char* argv[])
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    QGuiApplication::setApplicationName(QStringLiteral("campanel"));
    QGuiApplication::setOrganizationName(QStringLiteral("campanel"));
    QGuiApplication::setApplicationVersion(QStringLiteral(CAMPANEL_VERSION));
    const QString capture = QStringLiteral("capture");
    const QString compare = QStringLiteral("compare");
    const QString update = QStringLiteral("update-baselines");
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Opens every page and dialog of the panel on a demonstration link. Without --capture, checks texts, "
        "contrast, touch targets and the way to Stop."));
    parser.addHelpOption();
    parser.addOptions({
        {capture, QStringLiteral("Write a picture of each."), QStringLiteral("folder")},
        {compare, QStringLiteral("Of --capture: only the pictures in that folder; fails when one differs."),
         QStringLiteral("folder")},
        {update, QStringLiteral("Of --compare: replace the pictures in that folder.")},
        {QStringLiteral("variants"),
         QStringLiteral(
             "Theme, language, size and gloves, such as \"dark-*\" or \"light-en-*,*-gloves\" (%1). "
             "\"*\" is each of them; \"usual\" is each language in light, and one each with dark, high "
             "contrast and gloves.")
             .arg(defaultVariant),
         QStringLiteral("patterns"), defaultVariant},
        {QStringLiteral("screens"), QStringLiteral("Only these, such as \"run*,motion\"."),
         QStringLiteral("patterns"), QStringLiteral("*")},
    });
    parser.process(application);
    refuseWithout(parser, compare, capture);
    refuseWithout(parser, update, compare);
    const auto variants = selected(parser, QStringLiteral("variants"), defaultVariant, &looks::variantsNamed);
    const auto screens =
        selected(parser, QStringLiteral("screens"), QStringLiteral("run"), &looks::screensNamed);

    shell::applyFonts();
    if (!hasFonts())
        return EXIT_FAILURE;
    if (!parser.isSet(capture))
        return looks::checkVariants(variants, screens);
    if (!parser.isSet(compare))
        return looks::capture(parser.value(capture), variants, screens);
    return looks::compareWithBaselines(parser.value(capture), parser.value(compare), parser.isSet(update));
}
