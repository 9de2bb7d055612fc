// SPDX-License-Identifier: Apache-2.0
// Backup and restore by touch: everything is written to a stick, changed, and restored; a damaged file is
// refused; the report is written as a PDF.
#include "panel_test.h"

#include "app/store/logs/audit_log.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QSignalSpy>

namespace test_panel_backup {

using namespace campanel;
using namespace Qt::StringLiterals;

class TestPanelBackup : public test::PanelTest {
    Q_OBJECT

    QTemporaryDir m_stick;

    auto& backup() { return m_window->panel().backup(); }
    bool isOn(const char* name) { return m_window->find(QString::fromLatin1(name)) != nullptr; }
    void waitForBackup()
    {
        m_window->waitUntil(backup(), &panel::Backup::changed,
                            [](const panel::Backup& each) { return !each.busy(); });
    }
    void openSection()
    {
        for (const QString& old : onStick(u"*"_s))
            QFile::remove(m_stick.filePath(old));
        const auto scanner = [this](const QString&) {
            return QList<store::Place>{{m_stick.path(), u"STICK"_s, false, true}};
        };
        backup().setScanner(scanner);
        m_window->panel().maintenance().files()->setScanner(scanner);
        m_window->link().show(looks::DemoLink::Situation::Stopped);
        m_window->checkClock();
        m_window->panel().access().open();
        m_window->panel().trail().open();
        m_window->panel().trends().open();
        tap("nav_maintenance");
        tap("maintenancePanel");
        tap("maintenanceBackup");
    }
    QStringList onStick(const QString& pattern)
    {
        return QDir(m_stick.path()).entryList({pattern}, QDir::Files);
    }
    void makeBackup()
    {
        tap("backupMake");
        waitForBackup();
        m_window->waitFor(*backup().places());
        tap("offer0");
        tap("offerGo");
        m_window->waitFor(*backup().places());
        QCOMPARE(onStick(u"*.zip"_s).size(), 1);
        tap("sheetClose");
    }
    template <typename Job> auto inStore(shell::Panel& panel, Job job)
    {
        std::optional<std::invoke_result_t<Job, store::Database&>> outcome;
        panel.records().store().run(&panel.records(), job, [&](const auto& done) { outcome = done; });
        while (!outcome)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        return *outcome;
    }

private slots:
    void aDatabaseThatCannotBeOpenedIsNotBackedUp()
    {
        openSection();
        auto& records = m_window->panel().records();
        store::StoreThread::Report report;
        report.error = store::StoreError{store::StoreError::Kind::ReadOnly, u"/data"_s, {}};
        emit records.store().opened(report);
        records.dismissNotice();
        tap("backupMake");
        QVERIFY2(textOf("backupMessage").startsWith(u"The database could not be opened"_s),
                 qPrintable(textOf("backupMessage")));
        QVERIFY(!isOn("offer0"));
        emit records.store().opened({});
    }

    void thereAndBack()
    {
        openSection();
        m_window->panel().settings().set("display.theme", u"dark"_s);
        const QString recipe = editor().recipeName();
        panel::Access& access = m_window->panel().access();
        access.addUser(u"Anna"_s, panel::Access::Service, u"258036"_s);
        QTRY_VERIFY(access.loggedIn());
        m_window->settle();
        makeBackup();
        // Everything changes: recipe, a user, a setting.
        m_window->panel().settings().set("display.theme", u"light"_s);
        editor().setRecipeName(u"Another"_s);
        access.addUser(u"Bert"_s, panel::Access::Operator, u"741852"_s);
        QTRY_COMPARE(access.users().size(), 2);
        m_window->settle();
        tap("backupRestore");
        waitForBackup();
        tap("offer0");
        tap("offerGo");
        waitForBackup();
        QVERIFY2(m_window->complaints().isEmpty(), qPrintable(m_window->complaints().join(u'\n')));
        QVERIFY2(textOf("question").contains(u"bags, trends and settings"), qPrintable(textOf("question")));
        QSignalSpy restart(&m_window->panel(), &shell::Panel::restartWanted);
        tap("confirm_restore");
        QTRY_COMPARE(restart.count(), 1);
        const QString folder = QFileInfo(backup().ownFolder()).path();
        QCOMPARE(QDir(backup().ownFolder()).entryList({u"*.zip"_s}).size(), 1); // the present state

        QVERIFY(QFile::exists(folder + u"/restore-ready/trends.sqlite"_s));

        // The next panel, as after an end at any later moment.
        QTemporaryDir copy;
        QVERIFY(copyAll(folder, copy.path()));
        looks::DemoLink link(nullptr);
        shell::Panel next(link, {copy.filePath(u"settings.ini"_s), copy.path()});
        next.records().open();
        next.access().open();
        QCOMPARE(next.settings().values().text("display.theme"), u"dark"_s);
        QCOMPARE(next.editor().recipeName(), recipe);
        QVERIFY2(next.records().notice().startsWith(u"The backup has been restored."),
                 qPrintable(next.records().notice()));
        QTRY_COMPARE(next.access().users().size(), 1);
        const auto rows =
            inStore(next, [](store::Database& database) { return store::auditTable().page(database, 0, 1); });
        QCOMPARE(rows->first().entry.what, u"backup.restored"_s);
        QCOMPARE(rows->first().entry.who, u"Anna"_s);
        QVERIFY(!rows->first().entry.before.isEmpty());
        const auto chain =
            inStore(next, [](store::Database& database) { return store::verifyChain(database); });
        QVERIFY(chain->fault() == store::ChainCheck::Fault::None);
    }

    // By finger; what the reports and the names of their files have.
    void theMachineHasAName()
    {
        const QString name = u"Line 3 / Nord"_s;
        shell::Panel& panel = m_window->panel();
        const auto machineName = [&panel] { return panel.settings().values().text("machine.name"); };
        tap("nav_settings");
        tap("section2");
        QCOMPARE(propertyOf("machineName", "note"), u"--"_s);
        tap("machineName");
        m_window->type(name);
        tap("textAccept");
        QCOMPARE(machineName(), name);
        QCOMPARE(propertyOf("machineName", "note"), name);
        QCOMPARE(propertyOf("section2", "note"), name);
        for (const panel::ReportData& data : {panel.commissioning().data(), panel.shiftReport().data()})
            QVERIFY2(data.machine.startsWith(name + u" · Machine with "_s), qPrintable(data.machine));
        const panel::Settings next(panel.settings().file().path(), nullptr); // after a restart
        QCOMPARE(next.machineName(), name);

        const QStringList bad{QString(200, u'M'), u"a\u0007b"_s, u"a\u200bb"_s};
        for (const QString& text : bad) {
            tap("machineName");
            m_window->find(u"textInput"_s)->setProperty("text", text);
            m_window->settle();
            QVERIFY(!textOf("textProblem").isEmpty());
            QVERIFY(!m_window->find(u"textAccept"_s)->isEnabled());
            tap("sheetClose"); // asks
            tap("sheetClose");
            QCOMPARE(machineName(), name);
        }
        panel.settings().setting(u"machine.name"_s)->enter(bad.first());
        QCOMPARE(machineName(), name);

        openSection();
        makeBackup();
        QVERIFY2(onStick(u"CamPanel backup Line 3 *"_s).size() == 1, qPrintable(onStick(u"*"_s).join(u' ')));
        tap("nav_settings");
        tap("machineName");
        m_window->find(u"textInput"_s)->setProperty("text", u"  "_s); // none again
        tap("textAccept");
        QCOMPARE(machineName(), QString());
        QVERIFY(panel.commissioning().data().machine.startsWith(u"Machine with "_s));
    }

    // Like main(): the end of one panel's window does not end the next one's event loop.
    void anotherPanelTakesItsPlace()
    {
        m_window.reset();
        const QTemporaryDir folder;
        for (int round = 0; round < 3; ++round) {
            constexpr int restartCode = 1000;
            looks::DemoLink link(nullptr);
            shell::Panel next(link, {folder.filePath(u"settings.ini"_s), folder.path()});
            QVERIFY(next.load(QSize(800, 480)));
            next.window().show();
            QGuiApplication::setQuitOnLastWindowClosed(true);
            connect(&next, &shell::Panel::restartWanted, [] {
                QGuiApplication::setQuitOnLastWindowClosed(false);
                QGuiApplication::exit(restartCode);
            });
            connect(
                &next.window(), &QQuickWindow::frameSwapped, &next,
                [&next] { emit next.backup().restartWanted(); }, Qt::SingleShotConnection);
            QCOMPARE(QGuiApplication::exec(), restartCode);
        }
        m_window = std::make_unique<looks::TestWindow>(looks::Variant{u"en"_s, u"light"_s, QSize(1024, 600)});
    }

    void aDamagedFileIsRefused()
    {
        openSection();
        makeBackup();
        QFile file(m_stick.filePath(onStick(u"*.zip"_s).first()));
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QByteArray bytes = file.readAll();
        const qsizetype at = bytes.size() / 2; // in the database
        QVERIFY(file.seek(at));
        QVERIFY(file.putChar(static_cast<char>(bytes[at] ^ 0x10)));
        file.close();
        tap("backupRestore");
        waitForBackup();
        tap("offer0");
        tap("offerGo");
        waitForBackup();
        QVERIFY2(textOf("offerDetail").contains(u"is damaged"), qPrintable(textOf("offerDetail")));
        QVERIFY(!isOn("confirm_restore"));
    }

    void aRunningMachineIsNotRestored()
    {
        openSection();
        makeBackup();
        m_window->link().show(looks::DemoLink::Situation::Running);
        m_window->checkClock();
        tap("backupRestore");
        waitForBackup();
        tap("offer0");
        tap("offerGo");
        waitForBackup();
        QVERIFY2(textOf("offerDetail").startsWith(u"The machine is moving."),
                 qPrintable(textOf("offerDetail")));
    }

    void theReportIsAPdf_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << u"en"_s;
        QTest::newRow("Chinese") << u"zh_CN"_s;
    }

    void theReportIsAPdf()
    {
        QFETCH(QString, language);
        m_window->panel().settings().overrideValue("display.language", language);
        m_window->settle();
        openSection();
        m_window->link().show(looks::DemoLink::Situation::Running);
        tap("reportMake");
        m_window->waitFor(*m_window->panel().maintenance().files());
        tap("offer0");
        tap("offerGo");
        m_window->waitFor(*m_window->panel().maintenance().files());
        QVERIFY2(m_window->complaints().isEmpty(), qPrintable(m_window->complaints().join(u'\n')));
        QCOMPARE(onStick(u"*.pdf"_s).size(), 1);
        QFile file(m_stick.filePath(onStick(u"*.pdf"_s).first()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray pdf = file.readAll();
        QVERIFY(pdf.startsWith("%PDF-1."));
        QVERIFY(pdf.trimmed().endsWith("%%EOF"));
        QCOMPARE(pdf.count("/Type /Page\n"), 2);
        QVERIFY(pdf.contains("/FontFile2"));       // embedded
        QVERIFY(!pdf.contains("/Subtype /Image")); // curves are lines
        QVERIFY2(pdf.size() > 20'000 && pdf.size() < 1'000'000, qPrintable(QString::number(pdf.size())));
    }

private:
    static bool copyAll(const QString& from, const QString& to)
    {
        bool isDone = true;
        const QDir source(from);
        for (const QFileInfo& each : source.entryInfoList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot)) {
            const QString target = to + u'/' + each.fileName();
            isDone = isDone && (each.isDir() ? QDir().mkpath(target) && copyAll(each.filePath(), target)
                                             : QFile::copy(each.filePath(), target));
        }
        return isDone;
    }
};

CAMPANEL_TEST(TestPanelBackup)

} // namespace test_panel_backup

#include "test_panel_backup.moc"
