// SPDX-License-Identifier: Apache-2.0
// The order in which requests get the line.
#include "app/link/request_queue.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_request_queue {

using namespace campanel;
using modbus::Command;

namespace {

quint32 idOf(const link::Request& request)
{
    return std::visit([](const auto& each) { return each.id; }, request);
}

} // namespace

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
            queue.push(link::CommandRequest{++id, command, {}});
        QList<quint32> served;
        while (const auto request = queue.take())
            served << idOf(*request);
        QCOMPARE(served, (QList<quint32>{4, 6, 2, 5, 1, 3}));
        QVERIFY(queue.isEmpty());
    }

    void aParameterWaitsWithTheWrites()
    {
        link::RequestQueue queue;
        queue.push(link::CommandRequest{1, Command::SaveToFlash, {}});
        queue.push(link::ParameterRequest{2, "parameter.ramp_time", 500.0});
        queue.push(link::CommandRequest{3, Command::SetClock, {}});
        queue.push(link::ParameterRequest{4, "parameter.ramp_time", std::nullopt});
        queue.push(link::CommandRequest{5, Command::Start, {}});
        queue.push(link::CommandRequest{6, Command::StopNow, {}});
        QList<quint32> served;
        while (const auto request = queue.take())
            served << idOf(*request);
        QCOMPARE(served, (QList<quint32>{6, 5, 1, 2, 3, 4}));
    }

    void takeAllLeavesNothing()
    {
        link::RequestQueue queue;
        queue.push(link::CommandRequest{1, Command::Start, {}});
        queue.push(link::CommandRequest{2, Command::StopNow, {}});
        const auto all = queue.takeAll();
        QCOMPARE(all.size(), std::size_t{2});
        QCOMPARE(idOf(all.front()), 2u);
        QVERIFY(!queue.take());
    }
};

CAMPANEL_TEST(TestRequestQueue)

} // namespace test_request_queue

#include "test_request_queue.moc"
