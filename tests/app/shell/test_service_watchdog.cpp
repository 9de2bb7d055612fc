// SPDX-License-Identifier: Apache-2.0
// The panel's notifications to a service manager: ready with the first frame, and working only while GUI
// thread, link thread and painting run. The service manager is a socket of the test.
#include "app/link/threaded_link.h"
#include "app/shell/service_manager.h"
#include "app/shell/service_watchdog.h"
#include "tests/support/fake_link.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cstddef>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace test_service_watchdog {

using namespace campanel;
using shell::ServiceManager;
using shell::ServiceWatchdog;

namespace {

constexpr int periodMs = 800;
constexpr int turnMs = periodMs / 4;

// The socket that a service manager gives to its processes.
class NotifySocket {
public:
    explicit NotifySocket(const QByteArray& address)
        : m_descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0))
    {
        sockaddr_un name{};
        name.sun_family = AF_UNIX;
        std::memcpy(name.sun_path, address.constData(), static_cast<std::size_t>(address.size()));
        if (address.startsWith('@'))
            name.sun_path[0] = '\0';
        const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) +
                                                   static_cast<std::size_t>(address.size()));
        if (::bind(m_descriptor, reinterpret_cast<const sockaddr*>(&name), length) != 0)
            qFatal("no notify socket");
        qputenv("NOTIFY_SOCKET", address);
        qputenv("WATCHDOG_USEC", QByteArray::number(periodMs * 1000));
        qputenv("WATCHDOG_PID", QByteArray::number(::getpid()));
    }
    ~NotifySocket() { ::close(m_descriptor); }
    NotifySocket(const NotifySocket&) = delete;
    NotifySocket& operator=(const NotifySocket&) = delete;

    // Returns the messages since the last call.
    QStringList heard()
    {
        QStringList messages;
        std::array<char, 256> buffer{};
        for (;;) {
            const auto size = ::recv(m_descriptor, buffer.data(), buffer.size(), 0);
            if (size < 0)
                return messages;
            messages += QString::fromUtf8(buffer.data(), static_cast<qsizetype>(size));
        }
    }

private:
    int m_descriptor;
};

// Answers pings while it works; earlier ones are answered when it works again.
class StoppableLink : public test::FakeLink {
    Q_OBJECT

public:
    using FakeLink::FakeLink;

    void ping(quint32 number) override
    {
        ++pings;
        m_open << number;
        answer();
    }
    void setWorking(bool isWorking)
    {
        m_isWorking = isWorking;
        answer();
    }
    int pings = 0;

private:
    void answer()
    {
        while (m_isWorking && !m_open.isEmpty())
            emit pingAnswered(m_open.takeFirst());
    }
    QList<quint32> m_open;
    bool m_isWorking = true;
};

const QString ready = QStringLiteral("READY=1");
const QString fed = QStringLiteral("WATCHDOG=1");

bool isFed(NotifySocket& socket)
{
    return QTest::qWaitFor([&socket] { return socket.heard().contains(fed); }, 10 * periodMs);
}

} // namespace

class TestServiceWatchdog : public QObject {
    Q_OBJECT

private slots:
    void cleanup()
    {
        for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"})
            qunsetenv(name);
    }

    void withoutAServiceManagerNothingHappens()
    {
        const ServiceManager manager;
        QVERIFY(!manager.isThere());
        QVERIFY(!manager.watchdogPeriod());
        manager.notify("READY=1");
        StoppableLink link(nullptr);
        QQuickWindow window;
        const ServiceWatchdog watchdog(manager, link, window);
        window.show();
        QTest::qWait(2 * turnMs);
        QCOMPARE(link.pings, 0);
    }

    void theEnvironmentIsTakenAndNotHandedOn()
    {
        NotifySocket socket("@campanel-test-" + QByteArray::number(::getpid()));
        const ServiceManager manager;
        QVERIFY(manager.isThere());
        QCOMPARE(manager.watchdogPeriod(), std::chrono::milliseconds(periodMs));
        QVERIFY(qEnvironmentVariableIsEmpty("NOTIFY_SOCKET"));
        QVERIFY(qEnvironmentVariableIsEmpty("WATCHDOG_USEC"));
        manager.notify("STOPPING=1");
        QCOMPARE(socket.heard(), QStringList{QStringLiteral("STOPPING=1")});
    }
    void theWatchdogOfAnotherProcessIsNotFed()
    {
        NotifySocket socket("@campanel-test-" + QByteArray::number(::getpid()));
        qputenv("WATCHDOG_PID", "1");
        QVERIFY(!ServiceManager().watchdogPeriod());
    }

    void itIsReadyWithTheFirstPictureAndThenFed()
    {
        const QTemporaryDir folder;
        NotifySocket socket(QFile::encodeName(folder.filePath(QStringLiteral("notify"))));
        const ServiceManager manager;
        StoppableLink link(nullptr);
        QQuickWindow window;
        const ServiceWatchdog watchdog(manager, link, window);
        QTest::qWait(2 * turnMs);
        QCOMPARE(socket.heard(), QStringList());
        window.show();
        QStringList heard;
        QVERIFY(QTest::qWaitFor([&] { return (heard += socket.heard()).count(fed) >= 3; }, 10 * periodMs));
        QCOMPARE(heard.first(), ready);
        QCOMPARE(heard.count(ready), 1);
    }

    void whatStandsStillIsNotFed_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("link thread") << 0;
        QTest::newRow("painting") << 1;
        QTest::newRow("GUI thread") << 2;
    }
    void whatStandsStillIsNotFed()
    {
        QFETCH(int, what);
        const QTemporaryDir folder;
        NotifySocket socket(QFile::encodeName(folder.filePath(QStringLiteral("notify"))));
        const ServiceManager manager;
        StoppableLink link(nullptr);
        QQuickWindow window;
        const ServiceWatchdog watchdog(manager, link, window);
        window.show();
        QVERIFY(isFed(socket));

        if (what == 0)
            link.setWorking(false);
        if (what == 1)
            window.blockSignals(true); // no frame is reported any more
        if (what < 2)
            QTest::qWait(turnMs); // an open round may still end
        (void)socket.heard();
        if (what < 2)
            QTest::qWait(2 * periodMs);
        else
            QTest::qSleep(2 * periodMs); // no event is handled
        QCOMPARE(socket.heard(), QStringList());

        link.setWorking(true);
        window.blockSignals(false);
        window.update();
        QVERIFY(isFed(socket));
    }

    // Nothing is painted then, and painting cannot fail.
    void aWindowThatNobodySeesNeedsNoPainting()
    {
        const QTemporaryDir folder;
        NotifySocket socket(QFile::encodeName(folder.filePath(QStringLiteral("notify"))));
        const ServiceManager manager;
        StoppableLink link(nullptr);
        QQuickWindow window;
        const ServiceWatchdog watchdog(manager, link, window);
        window.show();
        QVERIFY(isFed(socket));
        window.hide();
        QTest::qWait(turnMs);
        (void)socket.heard();
        QVERIFY(isFed(socket));
    }

    void theRealLinkAnswersFromItsThread()
    {
        link::ThreadedLink link(nullptr);
        QSignalSpy answered(&link, &link::Link::pingAnswered);
        link.ping(7);
        QVERIFY(answered.isEmpty()); // not from this thread
        QTRY_COMPARE(answered.size(), 1);
        QCOMPARE(answered.first().first().value<quint32>(), 7U);
    }
};

CAMPANEL_TEST(TestServiceWatchdog)

} // namespace test_service_watchdog

#include "test_service_watchdog.moc"
