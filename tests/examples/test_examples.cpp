// SPDX-License-Identifier: Apache-2.0
// Runs the examples: a bag that works and one that does not, a controller that answers and a port without
// one.
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QTest>

namespace test_examples {

using namespace campanel;
using namespace Qt::StringLiterals;

namespace {

struct Ended {
    int code = -1;
    QByteArray out;
    QByteArray complaint;
};

Ended runExample(const char* name, const QStringList& arguments)
{
    QProcess process;
    process.start(test::programPath(name), arguments);
    if (!process.waitForFinished(10'000))
        return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

class TestExamples : public QObject {
    Q_OBJECT

private slots:
    void bag()
    {
        const Ended solved = runExample("campanel-example-bag", {u"250"_s, u"60"_s});
        QVERIFY2(solved.code == 0, solved.complaint.constData());
        QVERIFY2(solved.out.startsWith("v_a 445.37"),
                 solved.out.constData()); // the check value of the cutter
        QVERIFY2(solved.out.contains("10000 pulses per bag"), solved.out.constData());
    }

    void bagThatAsksTooMuch()
    {
        const Ended refused = runExample("campanel-example-bag", {u"250"_s, u"400"_s});
        QCOMPARE(refused.code, 1);
        QVERIFY2(!refused.complaint.isEmpty() && refused.out.isEmpty(), refused.out.constData());
    }

    void status()
    {
        const test::ControllerProcess controller;
        const Ended asked = runExample("campanel-example-status", {controller.port()});
        QVERIFY2(asked.code == 0, asked.complaint.constData());
        QVERIFY2(asked.out.contains("No program."), asked.out.constData());
    }

    void statusWithoutController()
    {
        const Ended asked = runExample("campanel-example-status", {u"/nowhere"_s});
        QCOMPARE(asked.code, 1);
        QVERIFY(!asked.complaint.isEmpty());
    }
};

CAMPANEL_TEST(TestExamples)

} // namespace test_examples

#include "test_examples.moc"
