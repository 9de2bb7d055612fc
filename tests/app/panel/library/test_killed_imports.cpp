// SPDX-License-Identifier: Apache-2.0
// A panel killed at random moments while a signed recipe is imported: the library has the old version or the
// whole new one, and each confirmed import has its row with the signer's name in the audit trail.
#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace test_killed_imports {

using namespace campanel;

class TestKilledImports : public QObject {
    Q_OBJECT

    static constexpr int kills = 24;
    static constexpr int timeoutMs = 20'000;
    static constexpr int longestMs = 30;     // an import takes some milliseconds
    static constexpr int exampleVersion = 1; // of the recipe in each new library

    QTemporaryDir m_folder;
    int m_imported = exampleVersion; // confirmed
    int m_offered = 0;
    int m_unconfirmed = 0; // in the library, imported when the panel was killed

    void take(const QByteArray& line)
    {
        const int version = line.mid(line.indexOf(' ') + 1).toInt();
        if (line.startsWith("offered"))
            m_offered = version;
        else
            m_imported = version;
    }

    // Kills the panel some time after an offer, or after some imports.
    void runAndKill(int lifeMs, int imports)
    {
        QProcess panel;
        panel.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        panel.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("importing_panel"), m_folder.path()});
        int offers = 0;
        while (offers <= imports) {
            QVERIFY(panel.canReadLine() || panel.waitForReadyRead(timeoutMs));
            while (panel.canReadLine()) {
                const QByteArray line = panel.readLine();
                offers += line.startsWith("offered") ? 1 : 0;
                take(line);
            }
        }
        (void)panel.waitForFinished(lifeMs); // it does not end: time passes
        QCOMPARE(panel.state(), QProcess::Running);
        ::kill(static_cast<pid_t>(panel.processId()), SIGKILL);
        QVERIFY(panel.waitForFinished(timeoutMs));
        while (panel.canReadLine())
            take(panel.readLine());
    }

    void check(int& news)
    {
        auto opened = store::Database::open(m_folder.path());
        QVERIFY2(opened, opened ? "" : qPrintable(store::StoreErrorText::describe(opened.error())));
        store::Database& database = **opened;
        const auto newest = store::RecipeLibrary(database).newest();
        QVERIFY(newest && newest->size() == 1);
        const store::RecipeVersion& version = newest->first();
        QVERIFY2(version.version == std::max(m_imported, m_unconfirmed) || version.version == m_offered,
                 qPrintable(QStringLiteral("%1, offered %2").arg(version.version).arg(m_offered)));
        QCOMPARE(version.recipe.cutter().bagLengthMm, 249.0 + version.version % 16);
        if (version.version > std::max(m_imported, m_unconfirmed)) {
            m_unconfirmed = version.version;
            ++news;
        }

        const auto chain = store::verifyChain(database);
        QVERIFY(chain);
        QCOMPARE(chain->fault(), store::ChainCheck::Fault::None);
        const auto rows = store::auditTable().page(database, 0, 100);
        QVERIFY(rows);
        const QString confirmed = QStringLiteral("version %1, signed by Plant").arg(m_imported);
        QVERIFY(m_imported == exampleVersion ||
                std::ranges::any_of(*rows, [&confirmed](const store::AuditRow& row) {
                    return row.entry.readBack == confirmed;
                }));
    }

private slots:
    // A killed panel does not remove its temporary folder.
    void initTestCase() { qputenv("TMPDIR", m_folder.path().toLocal8Bit()); }

    void theLibraryIsOldOrNew()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        int news = 0;
        for (int i = 0; i < kills; ++i) {
            const int lifeMs = random.bounded(longestMs);
            runAndKill(lifeMs, random.bounded(2));
            if (!QTest::currentTestFailed())
                check(news);
            if (QTest::currentTestFailed()) {
                qWarning("kill %d of seed %u, after %d ms", i, seed, lifeMs);
                return;
            }
        }
        qInfo("%d kills, %d versions, %d of them saved and not yet confirmed", kills, m_imported, news);
    }
};

CAMPANEL_TEST(TestKilledImports)

} // namespace test_killed_imports

#include "test_killed_imports.moc"
