// SPDX-License-Identifier: Apache-2.0
// The shapes of small pictures: what they show, and that they stay between 0 and 1.
#include "app/panel/recipe/curve_shape.h"
#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_curve_shape {

using namespace campanel;
using panel::CurveShape;

// Returns y at the point whose x is nearest.
double heightAt(const CurveShape& shape, double x)
{
    return std::ranges::min(shape, {}, [x](const QPointF& point) { return std::abs(point.x() - x); }).y();
}

bool isInside(const CurveShape& shape)
{
    return std::ranges::all_of(shape, [](const QPointF& point) {
        return point.x() >= 0 && point.x() <= 1 && point.y() >= 0 && point.y() <= 1;
    });
}

class TestCurveShape : public QObject {
    Q_OBJECT

private slots:
    void everyKindHasAShape()
    {
        for (const program::KindInfo& kind : program::kinds()) {
            const CurveShape shape = panel::shapeOf(program::defaultRecipe(kind.kind));
            QVERIFY2(shape.size() > 50 && isInside(shape), kind.key.data());
            const auto [low, high] = std::ranges::minmax(shape, {}, &QPointF::y);
            QVERIFY2(low.y() == 0 && high.y() == 1, kind.key.data());
        }
    }

    // A person tells the kinds by their pictures.
    void everyKindHasAShapeOfItsOwn()
    {
        for (const program::KindInfo& one : program::kinds()) {
            for (const program::KindInfo& other : program::kinds()) {
                if (one.kind == other.kind)
                    continue;
                const CurveShape first = panel::shapeOf(program::defaultRecipe(one.kind));
                const CurveShape second = panel::shapeOf(program::defaultRecipe(other.kind));
                double apart = 0;
                for (double x = 0; x <= 1; x += 0.05)
                    apart = std::max(apart, std::abs(heightAt(first, x) - heightAt(second, x)));
                QVERIFY2(apart > 0.25,
                         qPrintable(QStringLiteral("%1 and %2: %3")
                                        .arg(QLatin1String(one.key.data()), QLatin1String(other.key.data()))
                                        .arg(apart)));
            }
        }
    }

    // The cutter is fast at the cut-free ends and slow in the film; the press goes down and returns.
    void shapesShowWhatTheMotionDoes()
    {
        const CurveShape cutter = panel::shapeOf(program::defaultRecipe(profile::ProgramKind::RotaryCutter));
        QCOMPARE(heightAt(cutter, 0), 1.0);
        QCOMPARE(heightAt(cutter, 0.5), 0.0);
        QCOMPARE(heightAt(cutter, 1), 1.0);
        const CurveShape press = panel::shapeOf(program::defaultRecipe(profile::ProgramKind::Press));
        QCOMPARE(heightAt(press, 0), 0.0);
        QVERIFY(heightAt(press, 1) < 1e-6);
    }

    void aRecipeWithoutMotionHasNone()
    {
        program::Recipe recipe;
        recipe.cutter().bagLengthMm = 1e6;
        QVERIFY(panel::shapeOf(recipe).isEmpty());
    }

    void everyLawHasAShapeOfItsOwn()
    {
        QList<CurveShape> shapes;
        for (const profile::Law& law : profile::laws()) {
            const CurveShape shape = panel::shapeOf(law);
            QVERIFY2(isInside(shape) && !shapes.contains(shape), law.key.data());
            QVERIFY2(shape.first().y() == 0 && std::abs(shape.last().y()) < 1e-9, law.key.data());
            if (law.isSymmetric) {
                for (const double x : {0.1, 0.2, 0.3, 0.4})
                    QVERIFY2(std::abs(heightAt(shape, x) - heightAt(shape, 1 - x)) < 1e-9, law.key.data());
            }
            shapes << shape;
        }
        // The slope of the parabolic law is a triangle, that of the cycloidal one 1 - cos(2 pi x).
        QCOMPARE(heightAt(panel::shapeOf(*profile::findLaw("parabolic")), 0.25), 0.5);
        QCOMPARE(heightAt(panel::shapeOf(*profile::findLaw("cycloidal")), 0.25), 0.5);
    }

    void motionsOfSegmentsGoFromTheLowerToTheUpperEnd()
    {
        for (const profile::SegmentMotionInfo& motion : profile::segmentMotions()) {
            const CurveShape shape = panel::shapeOf(motion);
            const bool isDwell = motion.motion == profile::SegmentMotion::Dwell;
            QVERIFY2(isInside(shape), motion.key.data());
            QCOMPARE(heightAt(shape, 0), isDwell ? 0.5 : 0.0);
            QCOMPARE(heightAt(shape, 1), isDwell ? 0.5 : 1.0);
        }
    }
};

CAMPANEL_TEST(TestCurveShape)

} // namespace test_curve_shape

#include "test_curve_shape.moc"
