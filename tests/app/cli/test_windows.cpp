// SPDX-License-Identifier: Apache-2.0
// campanelctl and the approved windows of a recipe: set, kept, removed, and a reason for a value outside.
#include "campanelctl_call.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QFile>
#include <QTemporaryDir>

namespace test_windows {

using namespace Qt::StringLiterals;
using namespace campanel::test;

class CliWindowsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_directory;

    QString put(const QByteArray& bytes) const
    {
        QFile file(m_directory.filePath(u"recipe.json"_s));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("%s", qPrintable(file.errorString()));
        return file.fileName();
    }

private slots:
    void aRecipeKeepsThem()
    {
        const Result made = call(u"recipe --windows rate_bags_per_min=55..70,k1=2..4.5"_s);
        QVERIFY2(made.code == Ok, made.complaint.constData());
        const QJsonObject windows = made.json()[u"windows"_s].toObject();
        QCOMPARE(windows.size(), 2);
        QCOMPARE(windows[u"rate_bags_per_min"_s][u"max"_s].toDouble(), 70.0);
        QCOMPARE(made.json()[u"format_version"_s].toInt(), 6);
        const Result removed = call(u"recipe --windows k1=none "_s + put(made.out));
        QCOMPARE(removed.json()[u"windows"_s].toObject().keys(), QStringList{u"rate_bags_per_min"_s});
    }

    void badOnesAreRefused()
    {
        for (const QString& windows :
             {u"rate_bags_per_min=70..55"_s, u"rate_bags_per_min=55..1e9"_s, u"rate_bags_per_min=55"_s,
              u"rate_bags_per_min=nan..nan"_s, u"rate=55..70"_s, u"slices_per_ramp=1..2"_s,
              u"knife_radius_mm=50..60"_s, u"="_s}) {
            const Result refused = call(u"recipe --windows "_s + windows);
            QVERIFY2(refused.code == Usage, qPrintable(windows));
            QVERIFY2(refused.complaint.startsWith("campanelctl: --windows"), refused.complaint.constData());
        }
    }

    void aValueOutsideNeedsAReason()
    {
        ControllerProcess controller;
        const QString download = u"download --format json --port %1 --rate 80 "_s.arg(controller.port());
        const QString recipe = put(call(u"recipe --windows rate_bags_per_min=55..70"_s).out);
        const Result refused = call(download + recipe);
        QCOMPARE(refused.code, int{Refused});
        QCOMPARE(refused.complaint,
                 QByteArray("campanelctl: Outside the approved window: Rate 80.0 bags/min, approved 55.0 to "
                            "70.0 bags/min. Add --reason TEXT, or give an approved value.\n"));
        QVERIFY(call(u"status --format json --port "_s + controller.port()).json()[u"program"_s].isNull());
        QStringList words = (download + recipe).split(u' ', Qt::SkipEmptyParts);
        QCOMPARE(call(words + QStringList{u"--reason"_s, u"  "_s}).code, int{Refused});
        const Result sent = call(words + QStringList{u"--reason"_s, u"late order"_s});
        QVERIFY2(sent.code == Ok, sent.complaint.constData());
        QCOMPARE(sent.json()[u"outside_window_reason"_s].toString(), u"late order"_s);
        const QString within = u"download --port %1 --rate 70 "_s.arg(controller.port());
        QCOMPARE(call(within + recipe).code, int{Ok});
    }
};

CAMPANEL_TEST(CliWindowsTest)

} // namespace test_windows

#include "test_windows.moc"
