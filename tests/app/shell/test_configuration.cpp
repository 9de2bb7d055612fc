// SPDX-License-Identifier: Apache-2.0
// The configuration file: valid values, errors with their line, and no fatal error.
#include "app/shell/configuration.h"

#include "app/panel/settings/settings.h"
#include "app/shell/kiosk.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <random>
#include <sys/stat.h>

namespace test_configuration {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Settings;
using shell::configurationFrom;
using shell::ReadConfiguration;

namespace {

const QString name = u"c.toml"_s;

// Returns what the generator of the configuration's documents prints.
QByteArray generated(const QString& form)
{
    QProcess generator;
    generator.start(campanel::test::programPath("campanel-generate-configuration"), {form});
    if (!generator.waitForFinished() || generator.exitCode() != 0)
        qFatal("%s", qPrintable(generator.errorString()));
    return generator.readAllStandardOutput();
}

// Returns the installed file with its examples enabled.
QByteArray installedExamples()
{
    QString text = QString::fromUtf8(generated(u"--toml"_s));
    static const QRegularExpression example(u"^#([a-z_]+ = )"_s, QRegularExpression::MultilineOption);
    return text.replace(example, u"\\1"_s).toUtf8();
}

bool isSimulated(const ReadConfiguration& read)
{
    return read.values.isTrue("connection.simulated");
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

        for (const panel::SettingRow& row : panel::settingTable) {
            const QString standard = panel::SettingValues().text(row);
            QCOMPARE(read.values.text(row), row.name == "display.language" ? u"en"_s : standard);
        }
    }

    // Each default, choice and limit of the table is valid, and beyond a limit is not.
    void everyRowOfTheTableIsConsistent()
    {
        QList<std::string_view> names;
        QStringList keys;
        for (const panel::SettingRow& row : panel::settingTable) {
            const QByteArray name(row.name.data(), qsizetype(row.name.size()));
            QVERIFY2(!names.contains(row.name), name);
            names << row.name;
            QVERIFY2(row.key.empty() || !keys.contains(keyOf(row)), name);
            if (!row.key.empty())
                keys << keyOf(row);
            QVERIFY2(row.help || !row.key.empty(), name);
            QVERIFY2(!row.label || !row.key.empty(), name);
            if (!row.standard.empty())
                QVERIFY2(isValid(row, panel::SettingValues().text(row)), name);
            if (!row.choices.empty()) {
                for (const QString& choice : choicesOf(row))
                    QVERIFY2(isValid(row, choice), name);
            }
            if (row.maximum > row.minimum) {
                QVERIFY2(isValid(row, panel::settingText(row.minimum)), name);
                QVERIFY2(isValid(row, panel::settingText(row.maximum)), name);
                QVERIFY2(!isValid(row, panel::settingText(row.minimum - 1)), name);
                QVERIFY2(!isValid(row, panel::settingText(row.maximum + 1)), name);
            }
        }
    }

    void theManPageNamesEveryKey()
    {
        QString section;
        QStringList named;
        for (const QString& line : QString::fromUtf8(generated(u"--man"_s)).split(u'\n')) {
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
[stops]
ask_after_seconds = 90
ideal_rate = 120.5
shift_starts = "05:00 13:00"
working_days = "12345"
reasons = ["material", "material/Film change", "planned:Break"]
[log]
rules = ["campanel.link.debug=true", "campanel.*=false"]
[kiosk]
screen = "linuxfb"
)",
                                                         name);
        QCOMPARE(read.complaints, QStringList());
        const Settings settings(u"/none/settings.ini"_s, nullptr, read.values);
        QCOMPARE(settings.connection(),
                 (panel::ConnectionChoice{false, u"/dev/campanel-serial"_s, 9600, u"E"_s, 2, 247}));
        QCOMPARE(settings.language(), u"zh_CN"_s);
        QCOMPARE(settings.values().text("display.theme"), u"contrast"_s);
        QVERIFY(settings.values().isTrue("display.gloves"));
        QCOMPARE(settings.bagToleranceMm(), 2.0);
        QCOMPARE(settings.values().whole("access.auto_logout_minutes"), 30);
        QVERIFY(settings.values().isTrue("access.operators_log_in"));
        QCOMPARE(settings.values().text("access.hold_to_start"), u"on"_s);
        QCOMPARE(panel::sizeIn(read.values.text("display.size")), QSize(1280, 800));
        QVERIFY(read.values.isTrue("display.fullscreen"));
        QCOMPARE(read.values.whole("stops.ask_after_seconds"), 90);
        QCOMPARE(read.values.number("stops.ideal_rate"), 120.5);
        QCOMPARE(read.values.text("stops.shift_starts"), u"05:00 13:00"_s);
        QCOMPARE(read.values.text("stops.working_days"), u"12345"_s);
        QCOMPARE(read.values.text("stops.reasons"), u"material\nmaterial/Film change\nplanned:Break"_s);
        QCOMPARE(read.values.text("log.rules"), u"campanel.link.debug=true\ncampanel.*=false"_s);
        QCOMPARE(shell::screenAccess(read.values.text("kiosk.screen")), shell::ScreenAccess::LinuxFb);
    }

    void aNamedPortIsMeant()
    {
        const QByteArray port = "[connection]\nport = \"/dev/ttyS1\"\n";
        QVERIFY(!isSimulated(configurationFrom(port, name)));
        QVERIFY(isSimulated(configurationFrom(port + "simulated = true\n", name)));
        QVERIFY(isSimulated(configurationFrom("[connection]\nbaud = 9600\n", name)));
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
        row("[machine]\nname = \"Line\\t3\"",
            "c.toml:6: machine.name must be up to 64 printable characters; it is ignored.");
        row("[machine]\nname = \"MMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMM\"",
            "c.toml:6: machine.name must be up to 64 printable characters; it is ignored.");
        row("[log]\nrules = [\"campanel.link=on\"]", "c.toml:6: log.rules must be a list of rules such as "
                                                     "[\"campanel.link.debug=true\"]; it is ignored.");
        row("[stops]\nshift_starts = \"06:10\"", "c.toml:6: stops.shift_starts must be from one to six "
                                                 "quarters of an hour in their order, such as "
                                                 "\"06:00 14:00 22:00\"; it is ignored.");
        row("[stops]\nworking_days = 12345",
            "c.toml:6: stops.working_days must be days in their order, such as "
            "\"12345\" for Monday to Friday; it is ignored.");
        row("[stops]\nreasons = [\"a\", \"a\"]",
            "c.toml:6: stops.reasons must be a list such as [\"material\", \"material/Film change\", "
            "\"planned:Break\"]; it is ignored.");
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
        QVERIFY(read.values.isTrue("access.operators_log_in"));
        // Anything that may have named the controller never leads to the simulated one.
        QCOMPARE(isSimulated(read),
                 !complaint.contains(u"connection."_s) && !complaint.contains(u"no section"_s));
        for (const panel::SettingRow& row : panel::settingTable) {
            if (row.name != "connection.simulated" && row.name != "access.operators_log_in")
                QCOMPARE(read.values.text(row), panel::SettingValues().text(row));
        }
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
                                 "unit = 1979-05-27T\x01:32:00Z",
                                 "unit = [1 2]",
                                 "unit = [n}n[a]",
                                 "unit = 7='\xef\xbb\xbb'",
                                 "port = \"/dev/\\u002541\"",
                                 "port = \"/dev/ttyS1\" {",
                                 "port = /dev/ttyS1",
                                 "port = \"\"\"",
                                 "port = '''/dev/ttyS1'''",
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
        QCOMPARE(read.values.whole("connection.unit"), 7);
        QVERIFY(read.values.isTrue("access.operators_log_in"));
    }

    void textsAndCommentsTakeEveryLetter()
    {
        const ReadConfiguration read =
            configurationFrom("[connection] # caf\xc3\xa9's\nport = \"/dev/\xc3\xa9%41\\\"#[}\" # [} "
                              "\xe4\xb8\xb2\xe5\x8f\xa3\n",
                              name);
        QCOMPARE(read.complaints, QStringList());
        QCOMPARE(read.values.text("connection.port"), u"/dev/\u00e9%41\"#[}"_s);
    }

    // Windows' editor writes it before the text.
    void aByteOrderMarkCostsNothing()
    {
        const ReadConfiguration read =
            configurationFrom("\xEF\xBB\xBF[connection]\nport = \"/dev/ttyS1\"\nunit = 7\n", name);
        QCOMPARE(read.complaints, QStringList());
        QCOMPARE(read.values.text("connection.port"), u"/dev/ttyS1"_s);
        QCOMPARE(read.values.whole("connection.unit"), 7);
        QVERIFY(!isSimulated(read));
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
        QCOMPARE(isSimulated(configurationFrom(text, name)), simulated);
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
        QCOMPARE(read.values.text("display.theme"), u"light"_s);
        QVERIFY(!isSimulated(read));
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
        QCOMPARE(read.values.whole("connection.unit"), 7);
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
            const panel::SettingValues values = configurationFrom(text, name).values;
            for (const panel::SettingRow& row : panel::settingTable)
                QVERIFY(values.text(row).isEmpty() || isValid(row, values.text(row)));
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
        const panel::SettingValues standard{
            {"display.language", u"zh_CN"_s},        {"display.theme", u"dark"_s},
            {"display.gloves", u"true"_s},           {"bags.tolerance_mm", u"1.5"_s},
            {"access.auto_logout_minutes", u"10"_s}, {"access.operators_log_in", u"true"_s},
            {"connection.simulated", u"false"_s},    {"connection.port", u"/dev/ttyS1"_s},
            {"connection.baud", u"19200"_s},         {"connection.parity", u"E"_s},
            {"connection.stop_bits", u"2"_s},        {"connection.unit", u"9"_s}};
        {
            Settings settings(storage, nullptr, standard);
            QCOMPARE(settings.language(), u"zh_CN"_s);
            QCOMPARE(settings.values().text("display.theme"), u"dark"_s);
            QVERIFY(settings.values().isTrue("display.gloves"));
            QCOMPARE(settings.bagToleranceMm(), 1.5);
            QCOMPARE(settings.setting(u"bags.tolerance_mm"_s)->defaultValue(), 1.5);
            QCOMPARE(settings.values().whole("access.auto_logout_minutes"), 10);
            QVERIFY(settings.values().isTrue("access.operators_log_in"));
            QCOMPARE(settings.connection(),
                     (panel::ConnectionChoice{false, u"/dev/ttyS1"_s, 19200, u"E"_s, 2, 9}));
            settings.set("display.theme", u"light"_s);
            settings.set("display.gloves", panel::settingText(false));
            settings.edit("connection.unit", panel::settingText(11));
            settings.applyConnection();
        }
        const Settings again(storage, nullptr, standard);
        QCOMPARE(again.values().text("display.theme"), u"light"_s);
        QVERIFY(!again.values().isTrue("display.gloves"));
        QCOMPARE(again.connection().unit, 11);
        QCOMPARE(again.connection().baud, 19200);
        QCOMPARE(again.language(), u"zh_CN"_s); // no other one was set
    }
};

CAMPANEL_TEST(TestConfiguration)

} // namespace test_configuration

#include "test_configuration.moc"
