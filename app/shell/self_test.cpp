// SPDX-License-Identifier: Apache-2.0
// Compiles every QML file and opens every page; see self_test.h.
#include "app/shell/self_test.h"

#include "app/link/threaded_link.h"
#include "app/shell/panel.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QImage>
#include <QTemporaryDir>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace campanel::shell {
namespace {

QStringList g_warnings; // written by the message handler, which has no object

void recordWarning(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    if (type != QtDebugMsg && type != QtInfoMsg)
        g_warnings += message;
}

// Returns the number of files. Dialogs are compiled here; they open with values that only their pages have.
int compileAll(QQmlEngine& engine)
{
    int files = 0;
    QDirIterator found(QStringLiteral(":/qt/qml/CamPanel"), {QStringLiteral("*.qml")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (found.hasNext()) {
        const QQmlComponent component(&engine, QUrl(QStringLiteral("qrc") + found.next()));
        if (component.isError())
            g_warnings += component.errorString();
        ++files;
    }
    return files;
}

// Returns the number of pages.
qsizetype openAll(QQuickWindow& window)
{
    auto* frame = window.property("frame").value<QObject*>();
    const auto pages = frame->property("pageNames").toStringList();
    window.show();
    frame->setProperty("showsPages", true); // without waiting for the first frame
    for (const QString& page : pages) {
        frame->setProperty("page", page);
        QCoreApplication::processEvents();
        if (!frame->property("openPageItem").value<QObject*>())
            g_warnings += QStringLiteral("page %1 cannot be opened").arg(page);
        if (window.grabWindow().isNull())
            g_warnings += QStringLiteral("page %1 cannot be drawn").arg(page);
    }
    return pages.size();
}

} // namespace

int selfTest()
{
    const QtMessageHandler before = qInstallMessageHandler(recordWarning);
    const QTemporaryDir folder;
    QStringList languages;
    int files = 0;
    qsizetype opened = 0;
    {
        link::ThreadedLink link(nullptr);
        Panel panel(link, {folder.filePath(QStringLiteral("settings.ini")), folder.path()});
        languages = panel::languageCodes(panel.settings().installedLanguages());
        if (panel.load({1024, 600})) {
            files = compileAll(panel.engine());
            for (const QString& language : std::as_const(languages)) {
                panel.settings().set("display.language", language);
                opened = openAll(panel.window());
            }
        }
    }
    qInstallMessageHandler(before);
    for (const QString& warning : std::as_const(g_warnings))
        std::fprintf(stderr, "campanel: %s\n", qPrintable(warning));
    std::printf("%d QML files, %lld pages in %s: %lld faults\n", files, static_cast<long long>(opened),
                qPrintable(languages.join(QStringLiteral(", "))), static_cast<long long>(g_warnings.size()));
    return opened > 0 && g_warnings.isEmpty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace campanel::shell
