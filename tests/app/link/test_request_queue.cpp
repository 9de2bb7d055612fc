// SPDX-License-Identifier: Apache-2.0
// The order in which requests get the line.
#include "app/link/request_queue.h"

#include <QTest>

using namespace campanel;
using modbus::Command;

class TestRequestQueue : public QObject {
    Q_OBJECT

private slots:
    void stopOvertakesEverythingAndEqualsKeepTheirOrder()
    {
        link::RequestQueue queue;
        const QList<Command> asked{Command::SaveToFlash, Command::Start, Command::SetClock,
                                   Command::StopNow,     Command::Home,  Command::StopAtCycleEnd};
        quint32 id = 0;
        for (const Command command : asked)
            queue.push({++id, command, {}});
        QList<quint32> served;
        while (const auto request = queue.take())
            served << request->id;
        QCOMPARE(served, (QList<quint32>{4, 6, 2, 5, 1, 3}));
        QVERIFY(queue.isEmpty());
    }

    void takeAllLeavesNothing()
    {
        link::RequestQueue queue;
        queue.push({1, Command::Start, {}});
        queue.push({2, Command::StopNow, {}});
        const auto all = queue.takeAll();
        QCOMPARE(all.size(), std::size_t{2});
        QCOMPARE(all.front().id, 2u);
        QVERIFY(!queue.take());
    }
};

QTEST_APPLESS_MAIN(TestRequestQueue)
#include "test_request_queue.moc"
