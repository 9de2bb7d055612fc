// SPDX-License-Identifier: Apache-2.0
// The configuration file: valid values, errors with their line, and no fatal error.
#include "app/shell/configuration.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <random>
#include <sys/stat.h>

namespace test_configuration {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Settings;
using shell::Configuration;
using shell::configurationFrom;
using shell::ReadConfiguration;

namespace {

const QString name = u"c.toml"_s;

// Returns the installed file with its examples enabled.
QByteArray installedExamples()
{
    QFile file(campanel::test::sourcePath("packaging/kiosk/campanel.toml"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(file.fileName()));
    QString text = QString::fromUtf8(file.readAll());
    static const QRegularExpression example(u"^#([a-z_]+ = )"_s, QRegularExpression::MultilineOption);
    return text.replace(example, u"\\1"_s).toUtf8();
}

} // namespace

class TestConfiguration : public QObject {
    Q_OBJECT

private slots:
    void theInstalledFileShowsEveryKeyWithItsDefault()
    {
        const QByteArray text = installedExamples();
        const ReadConfiguration read = configurationFrom(text, name);
        QCOMPARE(read.complaints, QStringList());
        QString section;
        QStringList shown;
        for (const QByteArray& line : text.split('\n')) {
            if (line.startsWith('['))
                section = QString::fromUtf8(line.mid(1, line.indexOf(']') - 1));
            else if (!line.startsWith('#') && line.contains(" = "))
                shown << section + u'.' + QString::fromUtf8(line.left(line.indexOf(" = ")));
        }
        QCOMPARE(shown, shell::configurationKeys());

        const Configuration fresh;
        QCOMPARE(read.values.standard.connection, fresh.standard.connection);
        QCOMPARE(read.values.standard.language, u"en"_s);
        QCOMPARE(read.values.standard.theme, fresh.standard.theme);
        QCOMPARE(read.values.standard.gloves, fresh.standard.gloves);
        QCOMPARE(read.values.standard.bagToleranceMm, fresh.standard.bagToleranceMm);
        QCOMPARE(read.values.standard.autoLogoutMinutes, fresh.standard.autoLogoutMinutes);
        QCOMPARE(read.values.standard.operatorsLogIn, fresh.standard.operatorsLogIn);
        QCOMPARE(read.values.windowSize, QSize(1024, 600));
        QCOMPARE(read.values.isFullScreen, fresh.isFullScreen);
        QCOMPARE(read.values.logRules, fresh.logRules);
        QCOMPARE(read.values.screen, fresh.screen);
    }

    void theManPageNamesEveryKey()
    {
        QFile page(campanel::test::sourcePath("packaging/man/campanel.toml.5"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        QString section;
        QStringList named;
        while (!page.atEnd()) {
            const QString line = QString::fromUtf8(page.readLine()).trimmed();
            if (line.startsWith(u".Ss ["))
                section = line.mid(5).chopped(1);
            else if (line.startsWith(u".It Cm "))
                named << section + u'.' + line.section(u' ', 2, 2);
        }
        QCOMPARE(named, shell::configurationKeys());
    }

    void everyValueIsTaken()
    {
        const ReadConfiguration read = configurationFrom(R"(
[connection]
simulated = false
port = "/dev/campanel-serial"
baud = 9600
parity = "E"
stop_bits = 2
unit = 247
[display]
language = "zh_CN"
theme = "contrast"
gloves = true
size = "1280x800"
fullscreen = true
[bags]
tolerance_mm = 2
[access]
auto_logout_minutes = 30
operators_log_in = true
hold_to_start = "on"
[log]
rules = ["campanel.link.debug=true", "campanel.*=false"]
[kiosk]
screen = "linuxfb"
)",
                                                         name);
        QCOMPARE(read.complaints, QStringList());
        const auto& standard = read.values.standard;
        QCOMPARE(standard.connection,
                 (panel::ConnectionChoice{false, u"/dev/campanel-serial"_s, 9600, u"E"_s, 2, 247}));
        QCOMPARE(standard.language, u"zh_CN"_s);
        QCOMPARE(standard.theme, u"contrast"_s);
        QVERIFY(standard.gloves);
        QCOMPARE(standard.bagToleranceMm, 2.0);
        QCOMPARE(standard.autoLogoutMinutes, 30);
        QVERIFY(standard.operatorsLogIn);
        QCOMPARE(standard.holdToStart, u"on"_s);
        QCOMPARE(read.values.windowSize, QSize(1280, 800));
        QVERIFY(read.values.isFullScreen);
        QCOMPARE(read.values.logRules, (QStringList{u"campanel.link.debug=true"_s, u"campanel.*=false"_s}));
        QCOMPARE(read.values.screen, shell::ScreenAccess::LinuxFb);
    }

    void aNamedPortIsMeant()
    {
        const QByteArray port = "[connection]\nport = \"/dev/ttyS1\"\n";
        QVERIFY(!configurationFrom(port, name).values.standard.connection.simulated);
        QVERIFY(configurationFrom(port + "simulated = true\n", name).values.standard.connection.simulated);
        QVERIFY(configurationFrom("[connection]\nbaud = 9600\n", name).values.standard.connection.simulated);
    }

    void whatIsWrongIsNamedAndIgnored_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("complaint");
        const auto row = [](const char* line, const char* complaint) {
            QTest::addRow("%s", line) << QByteArray(line) << QString::fromUtf8(complaint);
        };
        row("baud = 4800",
            "c.toml:5: connection.baud must be one of 9600, 19200, 38400, 57600, 115200; it is ignored.");
        row("baud = \"9600\"",
            "c.toml:5: connection.baud must be one of 9600, 19200, 38400, 57600, 115200; it is ignored.");
        row("baud = 4294976896", // 9600 in the lower half
            "c.toml:5: connection.baud must be one of 9600, 19200, 38400, 57600, 115200; it is ignored.");
        row("parity = \"n\"",
            "c.toml:5: connection.parity must be one of \"N\", \"E\", \"O\"; it is ignored.");
        row("stop_bits = 1.5",
            "c.toml:5: connection.stop_bits must be a whole number from 1 to 2; it is ignored.");
        row("unit = 0", "c.toml:5: connection.unit must be a whole number from 1 to 247; it is ignored.");
        row("unit = 248", "c.toml:5: connection.unit must be a whole number from 1 to 247; it is ignored.");
        row("simulated = 1", "c.toml:5: connection.simulated must be true or false; it is ignored.");
        row("port = \"ttyUSB0\"", "c.toml:5: connection.port must be the path of a serial port, such as "
                                  "\"/dev/campanel-serial\"; it is ignored.");
        row("bauds = 9600", "c.toml:5: there is no key connection.bauds; it is ignored.");
        row("[[connection.baud]]\n",
            "c.toml:5: connection.baud must be one of 9600, 19200, 38400, 57600, 115200; "
            "it is ignored.");
        row("[bags]\ntolerance_mm = 0.04",
            "c.toml:6: bags.tolerance_mm must be a number from 0.05 to 5; it is ignored.");
        row("[bags]\ntolerance_mm = nan",
            "c.toml:6: bags.tolerance_mm must be a number from 0.05 to 5; it is ignored.");
        row("[bags]\ntolerance_mm = true",
            "c.toml:6: bags.tolerance_mm must be a number from 0.05 to 5; it is ignored.");
        row("[display]\nsize = \"640x480\"",
            "c.toml:6: display.size must be from \"800x480\" to \"9999x9999\"; it is ignored.");
        row("[log]\nrules = [\"campanel.link=on\"]", "c.toml:6: log.rules must be a list of rules such as "
                                                     "[\"campanel.link.debug=true\"]; it is ignored.");
        row("[kiosk]\nscreen = \"x11\"",
            "c.toml:6: kiosk.screen must be one of \"auto\", \"eglfs\", \"linuxfb\"; it is ignored.");
        row("[screens]\nscreen = \"auto\"", "c.toml:5: there is no section [screens]; it is ignored.");
    }
    void whatIsWrongIsNamedAndIgnored()
    {
        QFETCH(QByteArray, line);
        QFETCH(QString, complaint);
        const ReadConfiguration read =
            configurationFrom("[access]\noperators_log_in = true\n[connection]\n\n" + line + '\n', name);
        QCOMPARE(read.complaints, QStringList{complaint});
        QVERIFY(read.values.standard.operatorsLogIn);
        // Anything that may have named the controller never leads to the simulated one.
        panel::ConnectionChoice expected;
        expected.simulated = !complaint.contains(u"connection."_s) && !complaint.contains(u"no section"_s);
        QCOMPARE(read.values.standard.connection, expected);
        QCOMPARE(read.values.standard.bagToleranceMm, 0.5);
        QVERIFY(!read.values.windowSize);
        QCOMPARE(read.values.logRules, QStringList());
        QCOMPARE(read.values.screen, shell::ScreenAccess::Auto);
    }

    // Invalid TOML costs only its line, not the file.
    void aBrokenLineCostsOnlyItself_data()
    {
        QTest::addColumn<QByteArray>("line");
        for (const char* line : {"baud = fast",
                                 "baud 9600",
                                 "= 9600",
                                 "port = \"/dev/ttyS1",
                                 "baud = 9600 9600",
                                 "\x01\x02",
                                 "parity = 'E",
                                 "baud = 96__00",
                                 "\xff\xfe = 1",
                                 "unit = [1, 2",
                                 "[=]",
                                 "[[ = ]]",
                                 "[",
                                 "[ \xc2\xa0]",
                                 "\xc3\xa9 = 1",
                                 "parity = \"E\" \xc3\xa9",
                                 "it's \xc3\xa9",
                                 "unit = [}",
                                 "unit = [1, }",
                                 "}"})
            QTest::addRow("%s", line) << QByteArray(line);
    }
    void aBrokenLineCostsOnlyItself()
    {
        QFETCH(QByteArray, line);
        const ReadConfiguration read = configurationFrom(
            "[connection]\nunit = 7\n" + line + "\n[ access ]\noperators_log_in = true\n", name);
        QVERIFY(!read.complaints.isEmpty());
        QVERIFY2(read.complaints.first().startsWith(u"c.toml:3: "), qPrintable(read.complaints.first()));
        QCOMPARE(read.values.standard.connection.unit, 7);
        QVERIFY(read.values.standard.operatorsLogIn);
    }

    void textsAndCommentsTakeEveryLetter()
    {
        const ReadConfiguration read = configurationFrom(
            "[connection] # caf\xc3\xa9's\nport = \"/dev/\xc3\xa9\\\"#[}\" # [} \xe4\xb8\xb2\xe5\x8f\xa3\n",
            name);
        QCOMPARE(read.complaints, QStringList());
        QCOMPARE(read.values.standard.connection.portName, u"/dev/\u00e9\"#[}"_s);
    }

    // Windows' editor writes it before the text.
    void aByteOrderMarkCostsNothing()
    {
        const ReadConfiguration read =
            configurationFrom("\xEF\xBB\xBF[connection]\nport = \"/dev/ttyS1\"\nunit = 7\n", name);
        QCOMPARE(read.complaints, QStringList());
        QCOMPARE(read.values.standard.connection.portName, u"/dev/ttyS1"_s);
        QCOMPARE(read.values.standard.connection.unit, 7);
        QVERIFY(!read.values.standard.connection.simulated);
    }

    void damageNeverChoosesTheSimulatedController_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("simulated");
        QTest::newRow("nothing said") << QByteArray("[display]\ntheme = \"dark\"\n") << true;
        QTest::newRow("nothing of it concerned") << QByteArray("[display]\ntheme = \"pink\"\n") << true;
        QTest::newRow("a port that is none") << QByteArray("[connection]\nport = \"ttyS1\"\n") << false;
        QTest::newRow("section misspelled") << QByteArray("[conection]\nport = \"/dev/ttyS1\"\n") << false;
        QTest::newRow("section lost") << QByteArray("connection]\nport = \"/dev/ttyS1\"\n") << false;
        QTest::newRow("key misspelled") << QByteArray("[connection]\nprt = \"/dev/ttyS1\"\n") << false;
        QTest::newRow("text not ended") << QByteArray("[connection]\nport = \"/dev/ttyS1\n") << false;
        QTest::newRow("said") << QByteArray("[connection]\nsimulated = true\nprt = \"/dev/ttyS1\"\n") << true;
    }
    void damageNeverChoosesTheSimulatedController()
    {
        QFETCH(QByteArray, text);
        QFETCH(bool, simulated);
        QCOMPARE(configurationFrom(text, name).values.standard.connection.simulated, simulated);
    }

    void manyBrokenLinesCostTheFileNotTheStart()
    {
        QByteArray text = "[display]\ntheme = \"dark\"\n";
        for (int i = 0; i < 20'000; ++i)
            text += "this is no TOML\n";
        const ReadConfiguration read = configurationFrom(text, name);
        QVERIFY(read.complaints.size() <= 62);
        QVERIFY2(read.complaints.last().contains(u"the whole file is ignored"_s),
                 qPrintable(read.complaints.last()));
        QCOMPARE(read.values.standard.theme, u"light"_s);
        QVERIFY(!read.values.standard.connection.simulated);
    }

    void complaintsAreFitForATerminal()
    {
        const QStringList complaints = configurationFrom("\x1b[2J\n", name).complaints;
        QVERIFY(!complaints.isEmpty());
        QVERIFY2(!complaints.first().contains(QChar(0x1b)), qPrintable(complaints.first()));
    }

    void aKeySetTwiceHoldsItsFirstValue()
    {
        const ReadConfiguration read = configurationFrom("[connection]\nunit = 7\nunit = 8\n", name);
        QCOMPARE(read.complaints.size(), 1);
        QVERIFY2(read.complaints.first().startsWith(u"c.toml:3: "), qPrintable(read.complaints.first()));
        QCOMPARE(read.values.standard.connection.unit, 7);
    }

    void keysOutsideASectionAreNamed()
    {
        QCOMPARE(configurationFrom("baud = 9600\n", name).complaints,
                 QStringList{u"c.toml:1: there is no key \"baud\" outside a section; it is ignored."_s});
    }

    void noDamageIsFatal()
    {
        const QByteArray whole = installedExamples();
        constexpr unsigned seed = 20261122;
        std::mt19937 random(seed);
        for (int round = 0; round < 5000; ++round) {
            QByteArray text = whole;
            const int changes = 1 + static_cast<int>(random() % 20);
            for (int i = 0; i < changes; ++i)
                text[static_cast<qsizetype>(random() % static_cast<unsigned>(text.size()))] =
                    static_cast<char>(random() % 256);
            const Configuration values = configurationFrom(text, name).values;
            const auto& line = values.standard.connection;
            QVERIFY(Settings::possibleBauds().contains(line.baud));
            QVERIFY(line.unit >= 1 && line.unit <= 247);
            QVERIFY(Settings::possibleThemes().contains(values.standard.theme));
        }
    }

    void aMissingFileChangesNothingAndAnUnreadableOneIsNamed()
    {
        const QTemporaryDir folder;
        const QString missing = folder.filePath(name);
        QCOMPARE(shell::readConfiguration(missing).complaints, QStringList());
        const QStringList complaints =
            shell::readConfiguration(folder.path()).complaints; // a folder is not a file
        QCOMPARE(complaints.size(), 1);
        QVERIFY2(complaints.first().contains(u"cannot be read"), qPrintable(complaints.first()));
    }

    // Settings on the panel have priority.
    void thePanelsOwnSettingsGoFirst()
    {
        const QTemporaryDir folder;
        const QString storage = folder.filePath(u"settings.ini"_s);
        panel::StandardSettings standard;
        standard.language = u"zh_CN"_s;
        standard.theme = u"dark"_s;
        standard.gloves = true;
        standard.bagToleranceMm = 1.5;
        standard.autoLogoutMinutes = 10;
        standard.operatorsLogIn = true;
        standard.connection = {false, u"/dev/ttyS1"_s, 19200, u"E"_s, 2, 9};
        {
            Settings settings(storage, nullptr, standard);
            QCOMPARE(settings.language(), u"zh_CN"_s);
            QCOMPARE(settings.theme(), u"dark"_s);
            QVERIFY(settings.gloves());
            QCOMPARE(settings.bagToleranceMm(), 1.5);
            QCOMPARE(settings.bagTolerance()->defaultValue(), 1.5);
            QCOMPARE(settings.autoLogoutMinutes(), 10);
            QVERIFY(settings.operatorsLogIn());
            QCOMPARE(settings.connection(), standard.connection);
            settings.setTheme(u"light"_s);
            settings.setGloves(false);
            settings.setUnit(11);
            settings.applyConnection();
        }
        const Settings again(storage, nullptr, standard);
        QCOMPARE(again.theme(), u"light"_s);
        QVERIFY(!again.gloves());
        QCOMPARE(again.connection().unit, 11);
        QCOMPARE(again.connection().baud, 19200);
        QCOMPARE(again.language(), u"zh_CN"_s); // no other one was set
    }
};

CAMPANEL_TEST(TestConfiguration)

} // namespace test_configuration

#include "test_configuration.moc"
