// SPDX-License-Identifier: Apache-2.0
// The versions on the screen: of software, program and recipe, in the audit trail once, and how long the disk
// lasts.
#include "../panel_rig.h"
#include "app/panel/update/versions.h"
#include "app/store/files/files.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

namespace test_panel_versions {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Versions;

namespace {

struct VersionsRig : test::PanelRig {
    qint64 freeBytes = 64'000'000'000;
    QDateTime wallClock{QDate(2026, 1, 15), QTime(14, 7), Qt::UTC};
    QList<store::AuditEntry> noted;
    std::unique_ptr<Versions> versions;

    VersionsRig()
    {
        records.open();
        start();
    }
    void start()
    {
        versions = std::make_unique<Versions>(machine, editor, records, folder.path(), nullptr);
        versions->setFreeBytes([this](const QString&) { return freeBytes; });
        versions->setWallClock([this] { return wallClock; });
        QObject::connect(versions.get(), &Versions::noted, versions.get(),
                         [this](const store::AuditEntry& entry) { noted << entry; });
        versions->open();
        if (!QTest::qWaitFor([this] { return versions->forecast().freeBytes > 0; }))
            qFatal("the disk was not measured");
    }
    [[nodiscard]] QString value(const QString& label) const
    {
        for (const panel::FigureRow& row : versions->rows()->rows()) {
            if (row.label == label)
                return row.value;
        }
        return u"no such row"_s;
    }
};

} // namespace

class TestPanelVersions : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QCoreApplication::setApplicationVersion(u"1.2.3"_s); }

    void whatIsNotKnownIsUnknown()
    {
        const VersionsRig rig;
        QCOMPARE(rig.value(u"Panel"_s), u"CamPanel 1.2.3"_s);
        QCOMPARE(rig.value(u"Gateway"_s), u"unknown: not connected"_s);
        for (const QString& label : {u"Controller"_s, u"Active program"_s, u"Generation"_s})
            QCOMPARE(rig.value(label), u"unknown"_s);
        QCOMPARE(rig.value(u"Disk"_s), u"64.0 GB free"_s);
        QCOMPARE(rig.value(u"Growth"_s), u"not known yet: measured from the second day on"_s);
        QVERIFY(rig.versions->warning().isEmpty());
    }

    void softwareProgramAndRecipeAreThere()
    {
        VersionsRig rig;
        rig.connectRunning();
        rig.versions->setGateway(u"1.2.2"_s);
        const auto& identity = rig.machine.identity();
        QVERIFY(rig.value(u"Controller"_s)
                    .startsWith(u"firmware %1, register map "_s.arg(
                        QString::fromStdString(identity->firmwareVersion()))));
        QCOMPARE(rig.value(u"Gateway"_s), u"1.2.2"_s);
        QCOMPARE(
            rig.value(u"Active program"_s),
            u"Rotary cutter · %1, version %2"_s.arg(rig.editor.recipeName()).arg(rig.editor.recipeVersion()));
        QCOMPARE(rig.value(u"Generation"_s),
                 u"%1, CRC-32 %2"_s.arg(rig.link.status.generation)
                     .arg(QString::number(*rig.link.status.activeCrc, 16).toUpper().rightJustified(8, u'0')));
        QCOMPARE(rig.value(u"Open recipe"_s),
                 u"%1, version %2"_s.arg(rig.editor.recipeName()).arg(rig.editor.recipeVersion()));
        rig.versions->setGateway({});
        QCOMPARE(rig.value(u"Gateway"_s), u"unknown: not connected"_s);
    }

    // Also the first version that ever ran, and not again at the next start.
    void anotherVersionIsARowOfTheTrail()
    {
        VersionsRig rig;
        rig.connectIdle();
        rig.versions->setGateway(u"1.2.2"_s);
        QStringList parts;
        for (const store::AuditEntry& entry : rig.noted) {
            QCOMPARE(entry.what, u"update.version"_s);
            QCOMPARE(entry.before, QString());
            parts << entry.object;
        }
        QCOMPARE(parts, (QStringList{u"panel_software"_s, u"controller_software"_s, u"gateway_software"_s}));
        QCOMPARE(rig.noted.first().after, u"1.2.3"_s);
        QTRY_COMPARE(store::readSystemRecord(rig.folder.path()).software.value(u"gateway"_s), u"1.2.2"_s);
        rig.noted.clear();
        rig.versions.reset();
        rig.start();
        rig.versions->setGateway(u"1.2.2"_s);
        QVERIFY(rig.noted.isEmpty());
        rig.versions->setGateway({});
        rig.versions->setGateway(u"1.3.0"_s);
        QCOMPARE(rig.noted.size(), 1);
        QCOMPARE(rig.noted.first().before, u"1.2.2"_s);
        QCOMPARE(rig.noted.first().after, u"1.3.0"_s);
    }

    void theSystemOfAnImageIsAVersionToo()
    {
        VersionsRig rig;
        QCOMPARE(rig.value(u"System"_s), u"no such row"_s);
        rig.versions->setSystem(u"1.2.3-20260115"_s);
        QCOMPARE(rig.value(u"System"_s), u"1.2.3-20260115"_s);
        QCOMPARE(rig.noted.last().object, u"system_software"_s);
    }

    void aDiskThatIsTooSmallIsSaid()
    {
        VersionsRig rig;
        rig.versions.reset();
        QVERIFY(store::replaceBytes(rig.folder.filePath(u"ballast"_s), QByteArray(80'000'000, 'x')));
        const qint64 day = rig.wallClock.date().toJulianDay() - QDate(1970, 1, 1).toJulianDay();
        store::SystemRecord record;
        store::addSample(record, day - 4, 0);
        QVERIFY(store::writeSystemRecord(rig.folder.path(), record));
        rig.freeBytes = 20'000'000'000; // 20 MB a day: 2.7 years
        rig.start();
        QVERIFY2(rig.value(u"Growth"_s).contains(u" MB a day; the disk lasts 2."_s) &&
                     rig.value(u"Growth"_s).endsWith(u" years"_s),
                 qPrintable(rig.value(u"Growth"_s)));
        QCOMPARE(rig.versions->warning(),
                 u"The disk lasts for less than five years. Free some disk space, or use a larger disk."_s);
        QVERIFY(rig.versions->rows()->rows().last().isNotable);
        rig.freeBytes = 2'000'000'000'000;
        rig.versions.reset();
        rig.start();
        QVERIFY(rig.versions->warning().isEmpty());
        QVERIFY2(rig.value(u"Growth"_s).endsWith(u"more than 100 years"_s),
                 qPrintable(rig.value(u"Growth"_s)));
    }
};

CAMPANEL_TEST(TestPanelVersions)

} // namespace test_panel_versions

#include "test_versions.moc"
