// SPDX-License-Identifier: Apache-2.0
// The ratios in the editor: they follow the recipe until somebody sets one by hand, and the offer of longer
// ramps.
#include "profile/cutter/ratios.h"
#include "profile/laws/laws.h"
#include "tests/app/panel/access_rig.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_ramps {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Editor;
using panel::RampControl;
using profile::RatioMode;
using test::PanelRig;

namespace {

RatioMode modeOf(const Editor& editor)
{
    return editor.recipe().cutter().ratioMode;
}

std::array<double, 4> ratiosOf(const Editor& editor)
{
    return editor.recipe().cutter().k;
}

QString figure(Editor& editor, int row)
{
    return editor.ramps()->figures()->row(row).value;
}

} // namespace

class TestRamps : public QObject {
    Q_OBJECT

private slots:
    void aNewRecipeStartsGentle()
    {
        PanelRig rig;
        QCOMPARE(modeOf(rig.editor), RatioMode::ByHand); // the paper's
        QCOMPARE(rig.editor.ramps()->stateText(), "Ratios: set by hand");
        rig.editor.newProgram(static_cast<int>(Editor::Kind::RotaryCutter));
        QCOMPARE(modeOf(rig.editor), RatioMode::Gentle);
        QCOMPARE(rig.editor.ramps()->stateText(), "Ratios: gentle");
        QVERIFY(rig.editor.feasible());
        QVERIFY(rig.editor.verdict().contains("388.")); // 303.5 with the ratios of the paper
        rig.editor.undo();
        QCOMPARE(modeOf(rig.editor), RatioMode::ByHand);
    }

    // Each of them lowers its own figure most.
    void thePresetsSayWhatTheyLower()
    {
        PanelRig rig;
        rig.editor.rate()->set(200);
        const QStringList presets = rig.editor.ramps()->presets();
        QCOMPARE(presets.size(), 3);
        rig.editor.ramps()->choose(RampControl::Slow);
        QCOMPARE(figure(rig.editor, 2), presets[0]);
        rig.editor.ramps()->choose(RampControl::Cool);
        QCOMPARE(figure(rig.editor, 1), presets[1]);
        rig.editor.ramps()->choose(RampControl::Gentle);
        QCOMPARE(figure(rig.editor, 0), presets[2]);
        QCOMPARE(rig.editor.ramps()->presets(), presets); // they do not depend on the present choice
        rig.editor.newProgram(static_cast<int>(Editor::Kind::PositionMove));
        QCOMPARE(rig.editor.ramps()->presets(), QStringList({u"--"_s, u"--"_s, u"--"_s}));
    }

    void theLimitIsTheMachinesNumber()
    {
        PanelRig rig;
        QCOMPARE(rig.editor.ramps()->limitField(), u"max_knife_acceleration_mm_per_s2"_s);
        rig.editor.bagLength()->set(320);
        QCOMPARE(rig.editor.ramps()->limitField(), u"max_rate_bags_per_min"_s);
        rig.editor.bagLength()->set(1500); // no motion: the stroke is a number of the recipe
        QCOMPARE(rig.editor.ramps()->limitField(), QString());
        rig.editor.newProgram(static_cast<int>(Editor::Kind::PositionMove));
        QCOMPARE(rig.editor.ramps()->limitField(), QString());
    }

    void keysSetTheRatios_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<double>("position");
        QTest::newRow("gentle") << static_cast<int>(RampControl::Gentle) << 100.0;
        QTest::newRow("cool") << static_cast<int>(RampControl::Cool) << 50.0;
        QTest::newRow("slow") << static_cast<int>(RampControl::Slow) << 0.0;
    }

    void keysSetTheRatios()
    {
        QFETCH(int, mode);
        QFETCH(double, position);
        PanelRig rig;
        rig.editor.rate()->set(200);
        const auto before = ratiosOf(rig.editor);
        rig.editor.ramps()->choose(mode);
        QCOMPARE(static_cast<int>(rig.editor.ramps()->mode()), mode);
        QVERIFY(ratiosOf(rig.editor) != before);
        QVERIFY(rig.editor.feasible());
        QVERIFY2(std::abs(rig.editor.ramps()->position() - position) < 0.1,
                 qPrintable(QString::number(rig.editor.ramps()->position())));
        // The table is that of these ratios.
        QCOMPARE(rig.image().cutter().program.k, ratiosOf(rig.editor));
        rig.editor.undo();
        QCOMPARE(ratiosOf(rig.editor), before);
        QCOMPARE(modeOf(rig.editor), RatioMode::ByHand);
    }

    void ratiosFollowEveryChange()
    {
        PanelRig rig;
        rig.editor.ramps()->choose(RampControl::Slow);
        const auto check = [&rig](const char* what) {
            const program::Recipe recipe = program::quantised(rig.editor.recipe());
            const auto expected = profile::withRatios(recipe.cutter(), recipe.machine).k;
            QVERIFY2(ratiosOf(rig.editor) == expected, what);
        };
        auto last = ratiosOf(rig.editor);
        const auto changes = [&](const char* what, auto change) {
            change();
            check(what);
            QVERIFY2(ratiosOf(rig.editor) != last, what);
            last = ratiosOf(rig.editor);
            QCOMPARE(modeOf(rig.editor), RatioMode::Slow);
        };
        changes("rate", [&] { rig.editor.rate()->set(150); });
        changes("length", [&] { rig.editor.bagLength()->set(150); });
        changes("law", [&] { rig.editor.setLaw("quintic"); });
        changes("machine", [&] { rig.editor.item(profile::Field::MaxKnifeAcceleration)->set(60000); });
        rig.editor.setRecipeName("Another");
        QCOMPARE(ratiosOf(rig.editor), last);
    }

    void aRatioOfOnesOwnStays()
    {
        PanelRig rig;
        rig.editor.ramps()->choose(RampControl::Gentle);
        rig.editor.k1()->set(5);
        QCOMPARE(modeOf(rig.editor), RatioMode::ByHand);
        QCOMPARE(rig.editor.ramps()->stateText(), "Ratios: set by hand");
        rig.editor.rate()->set(90);
        QCOMPARE(rig.editor.k1()->value(), 5.0);
        rig.editor.ramps()->choose(RampControl::Cool);
        QVERIFY(rig.editor.k1()->value() != 5.0);
        rig.editor.dragRatio(0, 0.1);
        rig.editor.commitDrag();
        QCOMPARE(modeOf(rig.editor), RatioMode::ByHand);
        rig.editor.undo();
        QCOMPARE(modeOf(rig.editor), RatioMode::Cool);
    }

    void theSliderIsOneUndoStep()
    {
        PanelRig rig;
        rig.editor.rate()->set(200);
        rig.editor.ramps()->choose(RampControl::Gentle);
        const auto before = ratiosOf(rig.editor);
        QString last = figure(rig.editor, 0);
        for (const double position : {90.0, 70.0, 60.0}) {
            rig.editor.ramps()->drag(position);
            QCOMPARE(modeOf(rig.editor), RatioMode::Between);
            QVERIFY(figure(rig.editor, 0) != last); // live
            last = figure(rig.editor, 0);
        }
        rig.editor.ramps()->endDrag();
        QVERIFY(std::abs(rig.editor.ramps()->position() - 60) < 0.5);
        QCOMPARE(rig.editor.ramps()->stateText(), "Ratios: 60 %");
        rig.editor.undo();
        QCOMPARE(ratiosOf(rig.editor), before);
    }

    void figuresAreThoseOfTheRecipe()
    {
        PanelRig rig;
        rig.editor.bagLength()->set(150);
        rig.editor.rate()->set(200);
        rig.editor.ramps()->choose(RampControl::Gentle);
        QCOMPARE(figure(rig.editor, 0), "23.64 m/s²");
        rig.editor.ramps()->choose(RampControl::Cool);
        QCOMPARE(figure(rig.editor, 1), "14.19 m/s²");
        QVERIFY(figure(rig.editor, 3).contains("290.")); // the ratios follow the rate
    }

    void theWindowGetsWiderAndNarrower()
    {
        PanelRig rig;
        QCOMPARE(rig.editor.ramps()->windowText(), "20.0 %");
        rig.editor.ramps()->choose(RampControl::Gentle);
        rig.editor.ramps()->widenWindow();
        QCOMPARE(rig.editor.ramps()->windowText(), "21.0 %");
        QCOMPARE(modeOf(rig.editor), RatioMode::Gentle);
        rig.editor.ramps()->narrowWindow();
        rig.editor.ramps()->narrowWindow();
        QCOMPARE(rig.editor.ramps()->windowText(), "19.0 %");
        QVERIFY(rig.editor.feasible());
        for (int i = 0; i < 30; ++i)
            rig.editor.ramps()->narrowWindow();
        QVERIFY(rig.editor.solvable());
    }

    void theVerdictOffersLongerRamps()
    {
        PanelRig rig;
        rig.editor.bagLength()->set(150);
        rig.editor.rate()->set(220);
        QVERIFY(rig.editor.feasible());
        QVERIFY(rig.editor.ramps()->offerName().isEmpty());
        rig.editor.rate()->set(250);
        QVERIFY(!rig.editor.feasible());
        QCOMPARE(rig.editor.ramps()->offerName(), "Longer ramps");
        QCOMPARE(rig.editor.ramps()->offerRate(), "250.0 bags/min");
        QVERIFY(rig.editor.suggestionText().startsWith("Rate 227")); // beside it
        rig.editor.ramps()->takeOffer();
        QVERIFY(rig.editor.feasible());
        QCOMPARE(rig.editor.rate()->value(), 250.0);
        QCOMPARE(modeOf(rig.editor), RatioMode::Gentle);
        QVERIFY(rig.editor.ramps()->offerName().isEmpty());
        rig.editor.undo();
        rig.editor.rate()->set(320);
        QVERIFY(rig.editor.ramps()->offerRate().startsWith("290."));
        rig.editor.ramps()->takeOffer();
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
        QVERIFY(std::abs(rig.editor.rate()->value() - 290.8) < 0.2);
        // Shorter ramps let a longer bag pass.
        rig.editor.undo();
        rig.editor.rate()->set(30);
        rig.editor.bagLength()->set(1090);
        QCOMPARE(rig.editor.ramps()->offerName(), "Shorter ramps");
        rig.editor.ramps()->takeOffer();
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
    }

    void theHighestRateCanBeEntered()
    {
        PanelRig rig;
        for (const int mode : {RampControl::Gentle, RampControl::Cool, RampControl::Slow}) {
            for (const double length : {100.0, 150.0, 249.0, 360.0}) {
                rig.editor.rate()->set(60);
                rig.editor.bagLength()->set(length);
                rig.editor.ramps()->choose(mode);
                rig.editor.rate()->set(rig.editor.solution().fastest->rateBagsPerMin);
                QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
            }
        }
    }

    void lawsAreRankedWithTheirOwnRamps()
    {
        PanelRig rig;
        rig.editor.ramps()->choose(RampControl::Gentle);
        rig.editor.item(profile::Field::NaturalFrequency)->set(4);
        rig.editor.watchLaws(true);
        panel::LawModel* laws = rig.editor.laws();
        QCOMPARE(laws->count(), static_cast<int>(profile::laws().size()));
        double before = 0;
        for (int row = 0; row < laws->count(); ++row) {
            const double now = laws->row(row).peakAccelerationText.section(u' ', 0, 0).toDouble();
            QVERIFY(now >= before);
            QVERIFY(!laws->row(row).rmsText.isEmpty());
            QVERIFY2(laws->row(row).vibrationText.section(u' ', 0, 0).toDouble() > 0,
                     qPrintable(laws->row(row).vibrationText));
            before = now;
        }
        // The figures of a row are those of the recipe with its law.
        for (const char* law : {"half_modified_sine", "exponential", "cubic"}) {
            QString text;
            for (int row = 0; row < laws->count(); ++row)
                text =
                    laws->row(row).lawId == QLatin1String(law) ? laws->row(row).peakAccelerationText : text;
            rig.editor.setLaw(QString::fromLatin1(law));
            QCOMPARE(figure(rig.editor, 0), text);
        }
        // By hand, the figures are those of these ratios.
        rig.editor.k1()->set(6);
        for (int row = 0; row < laws->count(); ++row) {
            if (laws->row(row).current)
                QCOMPARE(laws->row(row).peakAccelerationText, figure(rig.editor, 0));
        }
    }

    // Ratios are for technicians; they follow the rate that an operator enters, and its undo.
    void anOperatorChangesTheRateButNotTheRatios()
    {
        test::AccessRig rig;
        rig.addAnnaAndBo();
        rig.add(u"Chen"_s, panel::Access::Operator, u"2580"_s);
        rig.access.logOut();
        rig.logIn(u"Bo"_s, u"1470"_s);
        rig.editor.ramps()->choose(RampControl::Slow);
        QCOMPARE(modeOf(rig.editor), RatioMode::Slow);
        rig.access.logOut();
        rig.logIn(u"Chen"_s, u"2580"_s);
        const auto before = ratiosOf(rig.editor);
        rig.editor.ramps()->choose(RampControl::Gentle);
        rig.editor.ramps()->drag(80);
        rig.editor.ramps()->endDrag();
        rig.editor.ramps()->widenWindow();
        QCOMPARE(ratiosOf(rig.editor), before);
        rig.editor.rate()->set(150);
        QCOMPARE(rig.editor.rate()->value(), 150.0);
        QVERIFY(ratiosOf(rig.editor) != before);
        rig.editor.undo();
        QCOMPARE(rig.editor.rate()->value(), 60.0);
        QCOMPARE(ratiosOf(rig.editor), before);
    }

    void revertRestoresWhatIsStored()
    {
        PanelRig rig;
        rig.editor.ramps()->choose(RampControl::Cool);
        rig.editor.takeStored(rig.editor.recipe());
        const auto stored = ratiosOf(rig.editor);
        rig.editor.ramps()->choose(RampControl::Slow);
        QVERIFY(rig.editor.edited());
        rig.editor.revert();
        QVERIFY(!rig.editor.edited());
        QCOMPARE(ratiosOf(rig.editor), stored);
    }

    void aDownloadDoesNotDependOnTheirOrigin()
    {
        PanelRig rig;
        rig.editor.ramps()->choose(RampControl::Gentle);
        program::Recipe byHand = rig.editor.recipe();
        byHand.cutter().ratioMode = RatioMode::ByHand;
        QCOMPARE(program::buildProgram(byHand)->registers, rig.image().registers);
        rig.connectRunning();
        QCOMPARE(rig.editor.programDownload()->differenceCount(), 0);
        QCOMPARE(rig.machine.program()->recipe.cutter().k, ratiosOf(rig.editor));
        QCOMPARE(rig.machine.program()->recipe.cutter().ratioMode, RatioMode::ByHand);
    }
};

CAMPANEL_TEST(TestRamps)

} // namespace test_ramps

#include "test_ramps.moc"
