// SPDX-License-Identifier: Apache-2.0
// Every fault, warning and problem of the link has its alarm; every alarm has its texts in both languages.
#include "app/panel/words/alarm_catalogue.h"

#include "modbus/map/protocol.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QTranslator>

namespace test_alarm_catalogue {

using namespace campanel;
using panel::AlarmCatalogue;
using panel::AlarmKind;

namespace {

std::span<const modbus::EnumValue> valuesOf(std::string_view name)
{
    for (const modbus::EnumInfo& info : modbus::enumerations()) {
        if (info.name == name)
            return info.values;
    }
    return {};
}

} // namespace

class TestAlarmCatalogue : public QObject {
    Q_OBJECT

private slots:
    void everyBitOfTheControllerHasItsOwn()
    {
        QSet<const AlarmKind*> found;
        const auto faults = valuesOf("FaultBit");
        const auto warnings = valuesOf("WarningBit");
        QVERIFY(faults.size() >= 7 && warnings.size() >= 9);
        for (const modbus::EnumValue& value : faults) {
            const AlarmKind& kind = AlarmCatalogue::of(static_cast<modbus::FaultBit>(value.value));
            QVERIFY2(&kind != &AlarmCatalogue::unknownFault(), value.name.data());
            QVERIFY(kind.stopsMachine);
            QCOMPARE(kind.severity, panel::AlarmSeverity::Fault);
            found.insert(&kind);
        }
        for (const modbus::EnumValue& value : warnings) {
            const AlarmKind& kind = AlarmCatalogue::of(static_cast<modbus::WarningBit>(value.value));
            QVERIFY2(&kind != &AlarmCatalogue::unknownWarning(), value.name.data());
            // A run ends by these; the emergency stop ends it outside the controller.
            const bool isEndOfRun = value.value >= static_cast<int>(modbus::WarningBit::MarksLost) &&
                                    value.value != static_cast<int>(modbus::WarningBit::JawsClosed);
            QVERIFY2(kind.stopsMachine == isEndOfRun, value.name.data());
            found.insert(&kind);
        }
        QCOMPARE(found.size(), static_cast<qsizetype>(faults.size() + warnings.size()));
        QCOMPARE(&AlarmCatalogue::of(static_cast<modbus::FaultBit>(15)), &AlarmCatalogue::unknownFault());
        QCOMPARE(&AlarmCatalogue::of(static_cast<modbus::WarningBit>(16)), &AlarmCatalogue::unknownWarning());
    }

    void everyProblemOfTheLinkHasItsOwn()
    {
        using link::LinkState;
        QSet<const AlarmKind*> found{&AlarmCatalogue::simulatorMissing()};
        for (const LinkState state : {LinkState::Searching, LinkState::Connecting, LinkState::Lost,
                                      LinkState::WrongDevice, LinkState::PortProblem}) {
            QVERIFY(AlarmCatalogue::of(state));
            found.insert(AlarmCatalogue::of(state));
        }
        QCOMPARE(found.size(), 6);
        QVERIFY(!AlarmCatalogue::of(LinkState::Connected));
    }

    void idsAreUniqueAndFound()
    {
        static const QRegularExpression form(QStringLiteral("^[CWMLP]-[0-9]{2}$"));
        QSet<QString> ids;
        for (const AlarmKind& kind : AlarmCatalogue::all()) {
            QVERIFY2(form.match(kind.code()).hasMatch(), kind.id);
            QCOMPARE(AlarmCatalogue::find(kind.code()), &kind);
            ids.insert(kind.code());
        }
        QCOMPARE(ids.size(), static_cast<qsizetype>(AlarmCatalogue::all().size()));
        QVERIFY(!AlarmCatalogue::find(QStringLiteral("X-01")));
    }

    void textsAreThereInBothLanguages()
    {
        for (const AlarmKind& kind : AlarmCatalogue::all()) {
            for (const QString& text : {kind.title(), kind.cause(), kind.action()})
                QVERIFY2(!text.isEmpty(), kind.id);
            QVERIFY2(kind.title().size() <= 30, kind.id);
        }
        QTranslator translator;
        QVERIFY(translator.load(campanel::test::languageFile("zh_CN")));
        QVERIFY(QCoreApplication::installTranslator(&translator));
        static const QRegularExpression chinese(QStringLiteral("[\\x{4e00}-\\x{9fff}]"));
        for (const AlarmKind& kind : AlarmCatalogue::all()) {
            for (const QString& text : {kind.title(), kind.cause(), kind.action()})
                QVERIFY2(text.contains(chinese), qPrintable(kind.code() + text));
        }
        QCoreApplication::removeTranslator(&translator);
    }
};

CAMPANEL_TEST(TestAlarmCatalogue)

} // namespace test_alarm_catalogue

#include "test_alarm_catalogue.moc"
