// SPDX-License-Identifier: Apache-2.0
// packaging/kiosk/campanel-touch in a folder, with stand-ins of the programs that change the system.
#include "tests/support/fake_package.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace test_touch_script {

using namespace Qt::StringLiterals;

class TestTouchScript : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const QString& name) { return m_folder->filePath(name); }
    QByteArray read(const QString& name)
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QByteArray rule() { return read(u"etc/udev/rules.d/99-campanel-touch.rules"_s); }
    // Writes a program that adds its name and arguments to the calls, then does `more`.
    void addProgram(const QString& name, const QByteArray& more = {})
    {
        const QString program = path(u"bin/"_s + name);
        const QByteArray text =
            "#!/bin/sh\necho \"${0##*/} $*\" >>" + path(u"calls"_s).toLocal8Bit() + "\n" + more;
        QVERIFY(campanel::test::writeFile(program, text));
        QVERIFY(QFile::setPermissions(program, QFile::ReadOwner | QFile::ExeOwner));
    }
    // Returns the exit code.
    int run(const QByteArray& request)
    {
        if (!campanel::test::writeFile(path(u"run/campanel/touch-request"_s), request))
            return -1;
        QFile::remove(path(u"calls"_s));
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(u"PATH"_s, path(u"bin"_s) + u':' + environment.value(u"PATH"_s));
        environment.insert(u"CAMPANEL_TOUCH_ROOT"_s, m_folder->path());
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(CAMPANEL_TOUCH_SCRIPT), {});
        return process.waitForFinished() ? process.exitCode() : -1;
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        addProgram(u"udevadm"_s);
        QVERIFY(campanel::test::writeFile(path(u"run/udev/control"_s), {}));
        addProgram(u"systemctl"_s);
        addProgram(u"setpriv"_s, "while [ \"${1#--}\" != \"$1\" ]; do shift; done\nexec \"$@\"\n");
    }

    void withoutUdevTheKioskIsRestarted()
    {
        QVERIFY(QFile::remove(path(u"run/udev/control"_s)));
        QCOMPARE(run("0.000000 1.000000 0.000000 -1.000000 0.000000 1.000000\n"), 0);
        QVERIFY(!rule().isEmpty());
        const QByteArray calls = read(u"calls"_s);
        QVERIFY(!calls.contains("udevadm"));
        QVERIFY(calls.contains("systemctl --no-block try-restart campanel-kiosk.service"));
    }

    void sixNumbersBecomeARule()
    {
        QCOMPARE(run("1.026384 0.000005 -0.032403 -0.005010 0.977394 0.021721\n"), 0);
        const QByteArray text = rule();
        QVERIFY(text.contains(
            "ENV{ID_INPUT_TOUCHSCREEN}==\"1\", ENV{LIBINPUT_CALIBRATION_MATRIX}=\"1.026384 0.000005 "
            "-0.032403 -0.005010 0.977394 0.021721\"\n"));
        QCOMPARE(text.count('\n'), 2);
        QCOMPARE(read(u"calls"_s).count("--reuid=campanel"), 2);
        const QByteArray calls = read(u"calls"_s);
        const auto reload = calls.indexOf("udevadm control --reload");
        const auto trigger = calls.indexOf("udevadm trigger --action=change");
        const auto restart = calls.indexOf("systemctl --no-block try-restart campanel-kiosk.service");
        QVERIFY2(reload >= 0 && reload < trigger && trigger < restart, calls.constData());
        QVERIFY(!QFile::exists(path(u"run/campanel/touch-request"_s)));
    }

    void noneRemovesTheRule()
    {
        QCOMPARE(run("0.000000 1.000000 0.000000 -1.000000 0.000000 1.000000\n"), 0);
        QVERIFY(!rule().isEmpty());
        QCOMPARE(run("none\n"), 0);
        QVERIFY(rule().isEmpty());
        QVERIFY(read(u"calls"_s).contains("try-restart"));
    }

    void anythingElseIsRefused_data()
    {
        QTest::addColumn<QByteArray>("request");
        const QByteArray good = "1.000000 0.000000 0.000000 0.000000 1.000000 0.000000";
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("five numbers") << QByteArray("1.000000 0.000000 0.000000 0.000000 1.000000\n");
        QTest::newRow("seven numbers") << good + " 0.000000\n";
        QTest::newRow("too large") << QByteArray("1.000000 0.000000 4.000000 0.000000 1.000000 0.000000\n");
        QTest::newRow("two digits") << QByteArray("11.000000 0.000000 0.000000 0.000000 1.000000 0.000000\n");
        QTest::newRow("exponent") << QByteArray("1e0 0.000000 0.000000 0.000000 1.000000 0.000000\n");
        QTest::newRow("not a number") << QByteArray("nan 0.000000 0.000000 0.000000 1.000000 0.000000\n");
        QTest::newRow("a quote") << good + "\", RUN+=\"/bin/sh\n";
        QTest::newRow("a second line") << good + "\nRUN+=\"/bin/sh\"\n";
        QTest::newRow("a second good line") << good + '\n' + good + '\n';
        QTest::newRow("a line") << QByteArray("1.000000 1.000000 0.000000 1.000000 1.000000 0.000000\n");
        QTest::newRow("a point") << QByteArray("0.100000 0.000000 0.000000 0.000000 0.100000 0.000000\n");
        QTest::newRow("two spaces") << QByteArray("1.000000  0.000000 0.000000 0.000000 1.000000 0.000000\n");
        QTest::newRow("a command") << QByteArray("$(touch /tmp/x)\n");
        QTest::newRow("long") << QByteArray(100000, '1');
    }
    void anythingElseIsRefused()
    {
        QFETCH(QByteArray, request);
        QCOMPARE(run("0.000000 1.000000 0.000000 -1.000000 0.000000 1.000000\n"), 0);
        const QByteArray before = rule();
        QCOMPARE(run(request), 1);
        QCOMPARE(rule(), before);
        QVERIFY(!read(u"calls"_s).contains("udevadm"));
        QVERIFY(!read(u"calls"_s).contains("systemctl"));
        QVERIFY(!QFile::exists(path(u"run/campanel/touch-request"_s)));
    }

    void aRequestThatIsNotThePanelsIsRefused()
    {
        addProgram(u"setpriv"_s, "echo 'Permission denied' >&2\nexit 1\n");
        QCOMPARE(run("1.000000 0.000000 0.000000 0.000000 1.000000 0.000000\n"), 1);
        QVERIFY(rule().isEmpty());
    }
};

CAMPANEL_TEST(TestTouchScript)

} // namespace test_touch_script

#include "test_touch_script.moc"
