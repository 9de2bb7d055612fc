// SPDX-License-Identifier: Apache-2.0
// Knife by knife, as a technician meets it: a machine with two knives, one of them off its place, cuts bags;
// the field offers what was learned, and taken it is in the controller and the bags are even.
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/packing/packing_setup.h"
#include "app/panel/settings/settings.h"
#include "tests/support/core_link.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_knives {

using namespace campanel;
using panel::PackingFields;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr double offMm = 0.1;

controller::MachineOptions machineOf(double knifeOffMm)
{
    controller::MachineOptions options;
    options.knifeOffMm = knifeOffMm;
    return options;
}

struct Machine {
    QTemporaryDir folder;
    test::CoreLink link;
    panel::Settings settings{folder.filePath(QStringLiteral("settings.ini")), nullptr};
    panel::Controller machine{link, settings, nullptr};
    panel::Editor editor{machine, folder.path(), nullptr};
    panel::PackingSetup setup{machine, nullptr};
    std::vector<double> deviationsMm;

    Machine(double knifeOffMm, int knives)
        : link(std::make_unique<test::Rig>(machineOf(knifeOffMm)))
    {
        machine.setClock([this] { return link.now(); });
        link.setFilmTimer(machine.packing()->findChild<QTimer*>());
        QObject::connect(machine.packing(), &panel::PackingLine::bagRecorded, &setup,
                         [this](const modbus::BagRecord& bag) { deviationsMm.push_back(bag.deviationMm); });
        link.setConnected(true);
        pass(1);
        editor.field(QStringLiteral("knives"))->set(knives);
        editor.bagLength()->set(150);
        editor.rate()->set(120);
        editor.download();
        pass(3);
        setup.open();
        pass(1);
    }

    PackingFields& fields() { return *setup.fields(); }
    void pass(double seconds)
    {
        for (std::uint64_t us = 0; us < static_cast<std::uint64_t>(seconds * second);
             us += test::CoreLink::stepUs) {
            link.step();
            QCoreApplication::processEvents();
        }
    }
    // Returns false when so many bags were not cut in time.
    bool cutBags(std::size_t bags)
    {
        deviationsMm.clear();
        for (int i = 0; i < 2000 && deviationsMm.size() < bags; ++i)
            pass(0.2);
        return deviationsMm.size() >= bags;
    }
    int row(const QString& label)
    {
        for (int row = 0; row < fields().rowCount(); ++row) {
            if (at(row, PackingFields::NameRole) == label)
                return row;
        }
        return -1;
    }
    QString at(int row, int role) { return fields().data(fields().index(row), role).toString(); }
    double scatterMm() const
    {
        double squares = 0.0;
        for (const double each : deviationsMm)
            squares += each * each;
        return std::sqrt(squares / static_cast<double>(deviationsMm.size()));
    }
};

} // namespace

class TestKnives : public QObject {
    Q_OBJECT

private slots:
    void offersThePlaceOfAKnife()
    {
        Machine machine(offMm, 2);
        const int row = machine.row(QStringLiteral("Knife 2 cuts behind its place by"));
        QVERIFY(row >= 0);
        machine.machine.start();
        QVERIFY(machine.cutBags(20));
        QVERIFY(machine.at(row, PackingFields::SuggestionRole).isEmpty());
        QVERIFY(machine.cutBags(200));
        const double before = machine.scatterMm();
        QVERIFY2(before > 0.09, qPrintable(QString::number(before)));
        const QString offered = machine.at(row, PackingFields::SuggestionRole);
        QVERIFY2(std::abs(offered.toDouble() - offMm) < 0.02, qPrintable(offered));
        QCOMPARE(ctl_parameter16(&machine.link.rig().core().board, CTL_REG_PARAMETER_KNIFE_2),
                 std::uint16_t{0}); // nobody has taken it

        machine.fields().takeSuggestion(row);
        machine.pass(1);
        QCOMPARE(ctl_parameter16(&machine.link.rig().core().board, CTL_REG_PARAMETER_KNIFE_2),
                 static_cast<std::uint16_t>(std::lround(offered.toDouble() * 1000.0)));
        QVERIFY(machine.cutBags(4));
        QVERIFY(machine.cutBags(200));
        QVERIFY2(machine.scatterMm() < 0.05, qPrintable(QString::number(machine.scatterMm())));
        QVERIFY(machine.at(row, PackingFields::SuggestionRole).isEmpty());
    }

    void oneKnifeHasNoPlace()
    {
        Machine machine(offMm, 1);
        QCOMPARE(machine.row(QStringLiteral("Knife 2 cuts behind its place by")), -1);
        QCOMPARE(PackingFields::words(QStringLiteral("parameter.knife_3")),
                 QStringLiteral("Knife 3 cuts behind its place by"));
        QCOMPARE(PackingFields::words(QStringLiteral("parameter.knife_step")),
                 QStringLiteral("Knife: max. speed step at a change"));
    }
};

CAMPANEL_TEST(TestKnives)

} // namespace test_knives

#include "test_knives.moc"
