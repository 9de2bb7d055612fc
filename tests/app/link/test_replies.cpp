// SPDX-License-Identifier: Apache-2.0
// Each request has its own reply: no reader receives the answer to another's request.
#include "tests/support/fake_link.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>

namespace test_replies {

using namespace campanel;
using test::FakeLink;

class TestReplies : public QObject {
    Q_OBJECT

private slots:
    void readersHaveTheirOwnAnswers()
    {
        FakeLink link;
        const QObject first;
        const QObject second;
        QList<quint32> ofFirst;
        QList<quint32> ofSecond;
        const link::Reply<link::ReadOutcome> toFirst{
            &first, [&](const link::ReadOutcome& outcome) { ofFirst << outcome.request.id; }};
        const link::Reply<link::ReadOutcome> toSecond{
            &second, [&](const link::ReadOutcome& outcome) { ofSecond << outcome.request.id; }};
        for (int i = 0; i < 3; ++i) {
            link.readRegisters({}, toFirst);
            link.readRegisters({}, toSecond);
        }
        QCOMPARE(link.reads.size(), 6);
        QList<quint32> asked;
        for (const link::ReadRequest& each : link.reads)
            asked << each.id;
        for (qsizetype i = asked.size(); i-- > 0;) { // in any order
            link::ReadOutcome outcome;
            outcome.request.id = asked[i];
            emit link.registersRead(outcome);
            emit link.registersRead(outcome); // a second answer is nobody's
        }
        QCOMPARE(ofFirst, (QList<quint32>{asked[4], asked[2], asked[0]}));
        QCOMPARE(ofSecond, (QList<quint32>{asked[5], asked[3], asked[1]}));
    }

    void commandsReadsAndParametersShareNoAnswer()
    {
        FakeLink link;
        const QObject reader;
        int commands = 0;
        int parameters = 0;
        int reads = 0;
        link.request({0, modbus::Command::Home, {}},
                     {&reader, [&](const link::CommandOutcome&) { ++commands; }});
        link.exchange({0, "parameter.ramp_time", {}},
                      {&reader, [&](const link::ParameterOutcome&) { ++parameters; }});
        link.readRegisters({}, {&reader, [&](const link::ReadOutcome&) { ++reads; }});
        QVERIFY(link.requests[0].id != link.parameters[0].id && link.parameters[0].id != link.reads[0].id &&
                link.requests[0].id != link.reads[0].id);
        link::ReadOutcome read;
        read.request.id = link.reads[0].id;
        emit link.registersRead(read);
        QCOMPARE(commands + parameters, 0);
        QCOMPARE(reads, 1);
    }

    void aReaderThatIsGoneReceivesNothing()
    {
        FakeLink link;
        auto reader = std::make_unique<QObject>();
        int received = 0;
        link.readRegisters({}, {reader.get(), [&](const link::ReadOutcome&) { ++received; }});
        reader.reset();
        link::ReadOutcome outcome;
        outcome.request.id = link.reads[0].id;
        emit link.registersRead(outcome);
        QCOMPARE(received, 0);
    }
};

CAMPANEL_TEST(TestReplies)

} // namespace test_replies

#include "test_replies.moc"
