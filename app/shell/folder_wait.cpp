// SPDX-License-Identifier: Apache-2.0
#include "app/shell/folder_wait.h"

#include <QGuiApplication>
#include <QLocale>
#include <QQmlApplicationEngine>
#include <QTimer>
#include <QTranslator>
#include <QVariantMap>

#include <chrono>
#include <cstdio>

using namespace Qt::StringLiterals;

namespace campanel::shell {
namespace {

constexpr std::chrono::milliseconds lockPeriod{500};
constexpr int windowWidth = 800;
constexpr int windowHeight = 480;

} // namespace

std::unique_ptr<store::FolderLock> waitForFolder(const QString& folder, const QString& language)
{
    auto lock = std::make_unique<store::FolderLock>(folder);
    if (!lock->isHeldByAnother())
        return lock;
    std::fprintf(stderr, "campanel: another CamPanel uses the data in %s. Close that one first.\n",
                 qPrintable(folder));
    QTranslator translator;
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    if (translator.load(locale, u"campanel_qml"_s, u"_"_s, u":/i18n"_s))
        QCoreApplication::installTranslator(&translator);
    QQmlApplicationEngine engine;
    engine.addImportPath(u"qrc:/qt/qml"_s);
    engine.setInitialProperties({{u"folder"_s, folder},
                                 {u"width"_s, windowWidth},
                                 {u"height"_s, windowHeight},
                                 {u"visible"_s, true}});
    engine.load(QUrl(u"qrc:/qt/qml/CamPanel/Frame/FolderInUse.qml"_s));
    if (engine.rootObjects().isEmpty())
        return nullptr;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
        lock = std::make_unique<store::FolderLock>(folder);
        if (lock->isHeldByAnother())
            return;
        QGuiApplication::setQuitOnLastWindowClosed(false); // the panel's window is about to open
        QGuiApplication::exit();
    });
    timer.start(lockPeriod);
    QGuiApplication::exec();
    return lock->isHeldByAnother() ? nullptr : std::move(lock);
}

} // namespace campanel::shell
