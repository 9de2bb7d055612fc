// SPDX-License-Identifier: Apache-2.0
// The choice of Qt Quick's software renderer, by the machine and by earlier choices.
#include "app/shell/renderer.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_renderer {

using namespace campanel::shell;
using namespace Qt::StringLiterals;

class TestRenderer : public QObject {
    Q_OBJECT

private slots:
    // The tests themselves may have a chosen renderer.
    void init()
    {
        for (const char* name : {"QT_QUICK_BACKEND", "QMLSCENE_DEVICE", "QSG_RHI_BACKEND", "QSG_RHI",
                                 "QT_XCB_FORCE_SOFTWARE_OPENGL", "QT_XCB_GL_INTEGRATION"})
            qunsetenv(name);
    }
    void cleanup() { init(); }

    void theChoice_data()
    {
        QTest::addColumn<QString>("platform");
        QTest::addColumn<QString>("device"); // the only one
        QTest::addColumn<QString>("openGl");
        QTest::addColumn<bool>("isSoftware");
        QTest::addColumn<bool>("isAsked"); // asked for the name of the OpenGL renderer
        const QString card = u"dri/renderD128"_s;
        QTest::newRow("no graphics card") << u"xcb"_s << u"null"_s << u"llvmpipe"_s << true << false;
        QTest::newRow("a screen but no processor")
            << u"xcb"_s << u"dri/card0"_s << u"llvmpipe"_s << true << false;
        QTest::newRow("Intel") << u"xcb"_s << card << u"Mesa Intel(R) UHD Graphics 620"_s << false << true;
        QTest::newRow("Nvidia") << u"xcb"_s << u"nvidia0"_s << u"NVIDIA T400/PCIe/SSE2"_s << false << true;
        QTest::newRow("VNC beside a card")
            << u"xcb"_s << card << u"llvmpipe (LLVM 15.0.6, 256 bits)"_s << true << true;
        QTest::newRow("softpipe") << u"xcb"_s << card << u"softpipe"_s << true << true;
        QTest::newRow("an old Mesa") << u"xcb"_s << card << u"Software Rasterizer"_s << true << true;
        QTest::newRow("no OpenGL") << u"xcb"_s << card << QString() << true << true;
        QTest::newRow("Wayland") << u"wayland-egl"_s << u"null"_s << u"llvmpipe"_s << true << false;
        QTest::newRow("a kiosk") << u"eglfs"_s << card << u"llvmpipe"_s << false << false;
        QTest::newRow("captures") << u"offscreen"_s << u"null"_s << u"llvmpipe"_s << false << false;
    }

    void theChoice()
    {
        QFETCH(QString, platform);
        QFETCH(QString, device);
        QFETCH(QString, openGl);
        QFETCH(bool, isSoftware);
        QFETCH(bool, isAsked);
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(u"dri"_s));
        QFile file(folder.filePath(device));
        QVERIFY(file.open(QIODevice::WriteOnly));
        int asked = 0;
        const RendererPlaces places{folder.path(), [&] {
                                        ++asked;
                                        return openGl;
                                    }};
        const QString reason = reasonForSoftwareRenderer(platform, places);
        QVERIFY2(reason.isEmpty() != isSoftware, qPrintable(reason));
        QCOMPARE(asked, isAsked ? 1 : 0);
    }

    void whatWasChosenStays_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<bool>("isSoftware");
        const auto row = [](const char* name, const char* value, bool isSoftware) {
            QTest::addRow("%s=%s", name, value) << QByteArray(name) << QByteArray(value) << isSoftware;
        };
        row("QT_QUICK_BACKEND", "rhi", false);
        row("QSG_RHI_BACKEND", "opengl", false);
        row("QT_XCB_GL_INTEGRATION", "xcb_egl", false);
        row("QT_XCB_FORCE_SOFTWARE_OPENGL", "1", false);
        row("QT_XCB_GL_INTEGRATION", "none", true);
    }

    void whatWasChosenStays()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, value);
        QFETCH(bool, isSoftware);
        const QTemporaryDir withoutDevices;
        qputenv(name.constData(), value);
        QCOMPARE(!reasonForSoftwareRenderer(u"xcb"_s, {withoutDevices.path(), {}}).isEmpty(), isSoftware);
    }
};

CAMPANEL_TEST(TestRenderer)

} // namespace test_renderer

#include "test_renderer.moc"
