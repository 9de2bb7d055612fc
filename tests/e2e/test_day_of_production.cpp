// SPDX-License-Identifier: Apache-2.0
// A day of production, 48 times as fast as real time: line faults, changes of the program, kills of the panel
// and of the controller, a full disk, a clock set back. The first half has a new panel after each kill; in
// the second half one panel runs on, and its memory is measured. CAMPANEL_DAY_HOURS: another number of
// simulated hours.
#include "app/link/threaded_link.h"
#include "app/panel/controller/controller.h"
#include "app/panel/settings/settings.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/bag_log.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QRandomGenerator>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <csignal>

namespace test_day_of_production {

using namespace campanel;
using test::ControllerProcess;

namespace {

constexpr int speed = 48;
constexpr double defaultHours = 24;
constexpr int timeoutMs = 30'000;
constexpr int shortestLifeMs = 6'000;
constexpr int longestLifeMs = 30'000;
constexpr int eventMs = 4'000;
constexpr double shortestMm = 200;
constexpr double longestMm = 260;
constexpr double largestDeviationMm = 25; // film that is pulled into register
constexpr double allowedGrowth = 0.05;    // of the memory, over the second half's last three quarters

constexpr std::array lineFaults{
    "clear",
    "late times=1.5 probability=0.02; lost-answer probability=0.01; lost-request probability=0.01",
    "corrupt probability=0.02; echo probability=0.01; truncate probability=0.01",
    "duplicate-answer probability=0.02; noise bytes=9 probability=0.02; wrong-unit probability=0.01",
    "silence time=300 every=200",
    "unplug when=answer time=200 every=300",
    "restart time=200 every=400",
};

QByteArrayList wordsOf(const QByteArray& line)
{
    return line.trimmed().split(' ');
}

} // namespace

class TestDayOfProduction : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    ControllerProcess m_controller{{QStringLiteral("--speed"), QString::number(speed),
                                    QStringLiteral("--control"), QStringLiteral("--no-pacing")}};
    QProcess m_panel;
    QRandomGenerator m_random;
    QElapsedTimer m_clock;
    QSet<QByteArray> m_begun; // CRC-32 of every program whose download has begun
    qint64 m_version = 0;
    qint64 m_sequence = 0;
    qint64 m_bags = 0;
    QList<double> m_memoryKb; // of the present panel
    int m_confirmed = 0;
    int m_kills = 0;
    int m_controllerKills = 0;
    int m_fullDisks = 0;
    int m_clockSteps = 0;
    bool m_isFull = false;
    qint64 m_clockOffsetS = 0; // of the present panel
    struct Told {
        qint64 clockOffsetS;
        QElapsedTimer since;
    };
    QList<Told> m_unanswered; // lines told to the present panel
    qint64 m_slowestAnswerMs = 0;

    void startPanel()
    {
        m_memoryKb.clear();
        m_isFull = false;
        m_clockOffsetS = 0;
        m_unanswered.clear();
        m_panel.setProcessChannelMode(QProcess::SeparateChannels);
        m_panel.setStandardErrorFile(QProcess::nullDevice()); // each fault of the line is told
        m_panel.start(QCoreApplication::applicationFilePath(),
                      {QStringLiteral("producing_panel"), m_folder.path(), m_controller.port(),
                       QString::number(m_random.generate())});
        QVERIFY(m_panel.waitForStarted(timeoutMs));
    }

    void take(const QByteArray& line)
    {
        const QByteArrayList words = wordsOf(line);
        if (words[0] == "begun") {
            m_begun << words.value(1);
        } else if (words[0] == "recipe") {
            m_version = std::max(m_version, words.value(1).toLongLong());
        } else if (words[0] == "audit") {
            m_sequence = words.value(1).toLongLong();
        } else if (words[0] == "program") {
            ++m_confirmed;
            QVERIFY2(m_begun.contains(words.value(2)), line);
        } else if (words[0] == "active") {
            QVERIFY2(m_begun.contains(words.value(2)), line);
        } else if (words[0] == "bags") {
            QVERIFY2(words.value(1).toLongLong() >= m_bags, line);
            m_bags = words.value(1).toLongLong();
            m_memoryKb << words.value(2).toDouble();
        } else if (words[0] == "time") { // the panel's, which answers each line with it
            constexpr qint64 toleranceS = 60;
            QVERIFY2(!m_unanswered.isEmpty(), line);
            const Told told = m_unanswered.takeFirst();
            m_slowestAnswerMs = std::max(m_slowestAnswerMs, told.since.elapsed());
            const qint64 expected = QDateTime::currentSecsSinceEpoch() + told.clockOffsetS;
            QVERIFY2(std::abs(words.value(1).toLongLong() - expected) < toleranceS, line);
        }
    }

    // Takes what the panel prints during this time. Fails when it ends by itself.
    void produce(int ms)
    {
        QElapsedTimer passed;
        passed.start();
        while (passed.elapsed() < ms) {
            (void)m_panel.waitForReadyRead(static_cast<int>(std::max<qint64>(1, ms - passed.elapsed())));
            while (m_panel.canReadLine()) {
                take(m_panel.readLine());
                if (QTest::currentTestFailed())
                    return;
            }
            QVERIFY2(m_panel.state() == QProcess::Running, "the panel has ended");
            QVERIFY2(m_unanswered.isEmpty() || !m_unanswered.first().since.hasExpired(timeoutMs),
                     "the panel does not answer");
        }
    }

    void tell(const QByteArray& line)
    {
        m_unanswered << Told{m_clockOffsetS, {}};
        m_unanswered.last().since.start();
        m_panel.write(line + '\n');
        m_panel.waitForBytesWritten();
    }

    void stepClock(qint64 seconds)
    {
        ++m_clockSteps;
        m_clockOffsetS += seconds;
        tell("clock " + QByteArray::number(seconds));
    }

    void doSomething()
    {
        switch (m_random.bounded(8)) {
        case 0:
            m_isFull = !m_isFull;
            m_fullDisks += m_isFull ? 1 : 0;
            tell(m_isFull ? "full" : "room");
            break;
        case 1:
            stepClock(m_random.bounded(2) == 0 ? -3600 : 3000);
            break;
        case 2:
            ++m_controllerKills;
            m_controller.kill();
            m_controller.start();
            break;
        default:
            m_controller.tell(lineFaults.at(m_random.generate() % lineFaults.size()));
        }
    }

    void killPanel()
    {
        ++m_kills;
        ::kill(static_cast<pid_t>(m_panel.processId()), SIGKILL);
        QVERIFY(m_panel.waitForFinished(timeoutMs));
        while (m_panel.canReadLine()) { // the last line may be incomplete
            const QByteArray line = m_panel.readLine();
            if (line.endsWith('\n'))
                take(line);
        }
        m_panel.readAll();
    }

    void checkController()
    {
        m_controller.tell("clear");
        link::ThreadedLink link(nullptr);
        const QTemporaryDir folder;
        panel::Settings settings(folder.filePath(QStringLiteral("settings.ini")), nullptr);
        panel::Controller machine(link, settings, nullptr);
        link::ConnectionSettings wanted;
        wanted.simulated = false;
        wanted.port = m_controller.port();
        link.connectTo(wanted);
        QTRY_VERIFY_WITH_TIMEOUT(machine.isConnected() && machine.status(), timeoutMs);
        if (const auto crc = machine.status()->activeCrc) {
            const QByteArray active = QByteArray::number(*crc, 16).toUpper().rightJustified(8, '0');
            QVERIFY2(m_begun.contains(active), active);
        }
    }

    void checkDatabase()
    {
        auto opened = store::Database::open(m_folder.path());
        QVERIFY2(opened, opened ? "" : qPrintable(store::StoreErrorText::describe(opened.error())));
        store::Database& database = **opened;
        QVERIFY2(database.opening().damagedKeptAs.isEmpty(), qPrintable(database.opening().damagedKeptAs));
        const auto newest = store::RecipeLibrary(database).newest();
        QVERIFY(newest);
        QVERIFY(m_version == 0 || (!newest->isEmpty() && newest->first().version >= m_version));
        const auto chain = store::verifyChain(database);
        QVERIFY(chain);
        QCOMPARE(chain->fault(), store::ChainCheck::Fault::None);
        QCOMPARE(chain->losses(), 0);
        QVERIFY2(chain->rows() >= m_sequence,
                 qPrintable(QStringLiteral("%1 of %2 rows").arg(chain->rows()).arg(m_sequence)));
    }

    void checkBags()
    {
        auto opened = store::Database::open(m_folder.path(), store::trendDatabase());
        QVERIFY2(opened, opened ? "" : qPrintable(store::StoreErrorText::describe(opened.error())));
        store::Database& database = **opened;
        QVERIFY2(database.opening().damagedKeptAs.isEmpty(), qPrintable(database.opening().damagedKeptAs));
        store::BagLog bags(database);
        const auto count = bags.count();
        QVERIFY(count);
        QVERIFY2(*count >= m_bags, qPrintable(QStringLiteral("%1 of %2 bags").arg(*count).arg(m_bags)));
        m_bags = *count;
        qint64 seen = 0;
        QStringList wrong;
        const auto read = bags.forEach(0, std::numeric_limits<qint64>::max(), [&](const store::Bag& bag) {
            ++seen;
            if (bag.setLengthMm < shortestMm || bag.setLengthMm > longestMm || bag.lengths < 1 ||
                std::abs(bag.deviationMm) > largestDeviationMm)
                wrong << QStringLiteral("%1: %2 mm %3 lengths %4 mm")
                             .arg(bag.timeMs)
                             .arg(bag.setLengthMm)
                             .arg(bag.lengths)
                             .arg(bag.deviationMm);
        });
        QVERIFY(read);
        QCOMPARE(seen, *count);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.mid(0, 5).join(u'\n')));
    }

    void checkAll()
    {
        for (void (TestDayOfProduction::*check)() :
             {&TestDayOfProduction::checkController, &TestDayOfProduction::checkDatabase,
              &TestDayOfProduction::checkBags}) {
            if (!QTest::currentTestFailed())
                (this->*check)();
        }
    }

    [[nodiscard]] double simulatedHours() const
    {
        return static_cast<double>(m_clock.elapsed()) / 3.6e6 * speed;
    }

    void oneLife(int ms)
    {
        startPanel();
        for (int left = ms; left > 0 && !QTest::currentTestFailed(); left -= eventMs) {
            produce(std::min(left, eventMs));
            if (!QTest::currentTestFailed())
                doSomething();
        }
        if (m_isFull && !QTest::currentTestFailed())
            tell("room");
    }

    // Returns the largest value in a part of the list: peaks are what has to be there.
    [[nodiscard]] double memoryKb(double from, double to) const
    {
        const auto at = [this](double share) {
            const auto index = static_cast<qsizetype>(share * static_cast<double>(m_memoryKb.size()));
            return m_memoryKb.begin() + index;
        };
        return *std::max_element(at(from), at(to));
    }

private slots:
    void nothingConfirmedIsLostAndNoValueIsWrong()
    {
        bool isGiven = false;
        const double given = qEnvironmentVariable("CAMPANEL_DAY_HOURS").toDouble(&isGiven);
        const double hours = isGiven ? given : defaultHours;
        const quint32 seed = QRandomGenerator::global()->generate();
        m_random.seed(seed);
        const auto report = qScopeGuard([this, seed] {
            qInfo("seed %u: %.1f simulated hours, %lld bags, %d downloads confirmed, version %lld, "
                  "%lld audit rows; %d kills of the panel, %d of the controller, %d full disks, "
                  "%d steps of the clock; slowest answer of the panel %lld ms",
                  seed, simulatedHours(), static_cast<long long>(m_bags), m_confirmed,
                  static_cast<long long>(m_version), static_cast<long long>(m_sequence), m_kills,
                  m_controllerKills, m_fullDisks, m_clockSteps, static_cast<long long>(m_slowestAnswerMs));
        });
        m_clock.start();
        while (simulatedHours() < hours / 2) {
            oneLife(m_random.bounded(shortestLifeMs, longestLifeMs));
            if (!QTest::currentTestFailed())
                killPanel();
            checkAll();
            if (QTest::currentTestFailed())
                return;
        }
        oneLife(static_cast<int>((hours - simulatedHours()) * 3.6e6 / speed));
        if (QTest::currentTestFailed())
            return;
        // Without faults, and with room on the disk again, it goes on. A busy computer may take a while.
        const qint64 before = m_bags;
        m_controller.tell(lineFaults.front());
        for (int ms = 0; ms < 2 * timeoutMs && m_bags == before && !QTest::currentTestFailed(); ms += eventMs)
            produce(eventMs);
        if (QTest::currentTestFailed())
            return;
        killPanel();
        checkAll();
        if (QTest::currentTestFailed())
            return;
        qInfo("memory of the last panel: %.0f KiB in its second quarter, %.0f KiB at the end",
              memoryKb(0.25, 0.5), memoryKb(0.75, 1));
        QVERIFY(memoryKb(0.75, 1) <= (1 + allowedGrowth) * memoryKb(0.25, 0.5));
        QVERIFY(m_bags > before);
        QVERIFY(m_confirmed > 0);
    }
};

CAMPANEL_TEST(TestDayOfProduction)

} // namespace test_day_of_production

#include "test_day_of_production.moc"
