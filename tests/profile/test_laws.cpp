// SPDX-License-Identifier: Apache-2.0
// The laws against published values, against their own derivatives and integrals, and against dense sampling.
#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace test_laws {

using namespace campanel::profile;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

void addLaws()
{
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < laws().size(); ++i)
        QTest::newRow(std::string(laws()[i].key).c_str()) << static_cast<int>(i);
}

// Returns the joints of a piecewise law in the first half of the motion.
std::vector<double> firstJoints(const Law& law, const LawParameters& p)
{
    switch (law.id) {
    case LawId::ModifiedSine:
        return {0.125};
    case LawId::ModifiedTrapezoid:
        return {0.125, 0.375};
    case LawId::Trapezoid:
        return {p[0]};
    case LawId::SCurve:
        return {p[0] * p[1], p[0] * (1 - p[1]), p[0]};
    default:
        return {0.5};
    }
}

// Returns the places where a derivative may step.
std::vector<double> joints(const Law& law, const LawParameters& p)
{
    if (law.id == LawId::HalfModifiedSine)
        return {0.25};
    std::vector<double> all = firstJoints(law, p);
    for (std::size_t i = all.size(); i-- > 0;)
        all.push_back(1 - all[i]);
    return all;
}

bool isNearJoint(const std::vector<double>& all, double x, double distance)
{
    return std::any_of(all.begin(), all.end(), [&](double joint) { return near(x, joint, distance); });
}

} // namespace

class TestLaws : public QObject {
    Q_OBJECT

private slots:
    void publishedValues_data();
    void publishedValues();
    void publishedPeaks_data();
    void publishedPeaks();
    void endsAndIntegral_data() { addLaws(); }
    void endsAndIntegral();
    void derivativesAgree_data() { addLaws(); }
    void derivativesAgree();
    void peaksAgreeWithDenseSampling_data() { addLaws(); }
    void peaksAgreeWithDenseSampling();
    void symmetryIsAsDeclared_data() { addLaws(); }
    void symmetryIsAsDeclared();
    void integralsBetweenJoints_data() { addLaws(); }
    void integralsBetweenJoints();
    void continuousAtJoints_data() { addLaws(); }
    void continuousAtJoints();
    void piecesAreSmooth_data() { addLaws(); }
    void piecesAreSmooth();
    void strengthsAndWeaknessesAreTrue();
    void keysAndCodesAreUnique();
};

void TestLaws::publishedValues_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QList<double>>("expected"); // g, g', g'', g''' at x = 0.1
    QTest::addColumn<double>("tolerance");
    QTest::newRow("quintic") << "quintic" << QList<double>{0.00856, 0.243, 4.32, 27.6} << 1e-12;
    QTest::newRow("4-5-6-7") << "polynomial_4567" << QList<double>{0.002728, 0.10206, 2.7216, 41.58} << 1e-12;
    QTest::newRow("cycloidal") << "cycloidal" << QList<double>{0.0064511, 0.190983, 3.6931637, 31.9387108}
                               << 6e-7;
    QTest::newRow("modified sine") << "modified_sine"
                                   << QList<double>{0.0106972, 0.303964, 5.2573996, 21.4662849} << 6e-7;
    QTest::newRow("modified trapezoid")
        << "modified_trapezoid" << QList<double>{0.0094591, 0.2687817, 4.648882, 18.9816701} << 6e-7;
}

void TestLaws::publishedValues()
{
    QFETCH(QString, key);
    QFETCH(QList<double>, expected);
    QFETCH(double, tolerance);
    const LawPoint p = findLaw(key.toStdString())->at(0.1, {});
    QVERIFY(near(p.g, expected[0], tolerance));
    QVERIFY(near(p.g1, expected[1], tolerance));
    QVERIFY(near(p.g2, expected[2], tolerance));
    QVERIFY(near(p.g3, expected[3], tolerance));
}

void TestLaws::publishedPeaks_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QList<double>>("parameters");
    QTest::addColumn<QList<double>>("expected"); // Cv, Ca, Cj
    const QList<double> none{0, 0};
    QTest::newRow("cubic") << "cubic" << none << QList<double>{1.5, 6, 12};
    QTest::newRow("quintic") << "quintic" << none << QList<double>{1.875, 5.773503, 60};
    QTest::newRow("4-5-6-7") << "polynomial_4567" << none << QList<double>{2.1875, 7.513188, 52.5};
    QTest::newRow("harmonic") << "harmonic" << none << QList<double>{1.570796, 4.934802, 15.503138};
    QTest::newRow("cycloidal") << "cycloidal" << none << QList<double>{2, 6.283185, 39.478418};
    QTest::newRow("modified sine") << "modified_sine" << none << QList<double>{1.759603, 5.527957, 69.466357};
    QTest::newRow("modified trapezoid")
        << "modified_trapezoid" << none << QList<double>{2, 4.888124, 61.425975};
    QTest::newRow("parabolic") << "parabolic" << none << QList<double>{2, 4, inf};
    QTest::newRow("trapezoid r=1/4") << "trapezoid" << QList<double>{0.25, 0}
                                     << QList<double>{1 / 0.75, 1 / 0.1875, inf};
    QTest::newRow("trapezoid r=1/2 is the parabola")
        << "trapezoid" << QList<double>{0.5, 0} << QList<double>{2, 4, inf};
    QTest::newRow("half modified sine")
        << "half_modified_sine" << none << QList<double>{1.570796, 9.869604, 62.012553};
    QTest::newRow("S r=0.3 q=0.2") << "s_curve" << QList<double>{0.3, 0.2}
                                   << QList<double>{1 / 0.7, 1 / (0.3 * 0.8 * 0.7),
                                                    1 / (0.3 * 0.8 * 0.7) / 0.06};
}

void TestLaws::publishedPeaks()
{
    QFETCH(QString, key);
    QFETCH(QList<double>, parameters);
    QFETCH(QList<double>, expected);
    const LawPeaks peaks = findLaw(key.toStdString())->peaks({parameters[0], parameters[1]});
    QVERIFY(near(peaks.cv, expected[0], 6e-7));
    QVERIFY(near(peaks.ca, expected[1], 6e-7));
    QVERIFY(std::isinf(expected[2]) ? std::isinf(peaks.cj) : near(peaks.cj, expected[2], 6e-7));
}

void TestLaws::endsAndIntegral()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    const LawParameters p = defaultParameters(law);
    QVERIFY(near(law.at(0, p).g, 0, 1e-14));
    QVERIFY(near(law.at(1, p).g, 1, 1e-14));
    QVERIFY(near(law.at(0, p).integral, 0, 1e-14));
    if (law.isSymmetric)
        QVERIFY(near(law.at(1, p).integral, 0.5, 1e-14));
    if (law.id == LawId::HalfModifiedSine) {
        QVERIFY(near(law.at(1, p).integral, 0.568310, 6e-7));
        QVERIFY(near(law.peaks(p).cv, std::acos(-1.0) / 2, 1e-14));
        QVERIFY(near(law.at(0, p).g1, 0, 1e-14));
        QVERIFY(near(law.at(1, p).g1, 0, 1e-14));
    }
    double previous = 0;
    for (int i = 0; i <= 1000; ++i) {
        QVERIFY2(law.at(i / 1000.0, p).g >= previous - 1e-15, "the law must not turn back");
        previous = law.at(i / 1000.0, p).g;
    }
}

void TestLaws::derivativesAgree()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    const LawParameters p = defaultParameters(law);
    const std::vector<double> steps = joints(law, p);
    constexpr double h = 1e-5;
    for (int i = 1; i < 500; ++i) {
        const double x = i / 500.0;
        if (isNearJoint(steps, x, 2 * h))
            continue;
        const LawPoint below = law.at(x - h, p);
        const LawPoint here = law.at(x, p);
        const LawPoint above = law.at(x + h, p);
        QVERIFY(near((above.integral - below.integral) / (2 * h), here.g, 1e-7));
        QVERIFY(near((above.g - below.g) / (2 * h), here.g1, 1e-7));
        QVERIFY(near((above.g1 - below.g1) / (2 * h), here.g2, 1e-6));
        QVERIFY(near((above.g2 - below.g2) / (2 * h), here.g3, 1e-5));
    }
    for (const double x : steps) { // g, g' and G have no step anywhere
        const LawPoint below = law.at(x - 1e-13, p);
        const LawPoint above = law.at(x + 1e-13, p);
        QVERIFY(near(above.integral, below.integral, 1e-12));
        QVERIFY(near(above.g, below.g, 2e-12));
        QVERIFY(near(above.g1, below.g1, 1e-11));
    }
}

void TestLaws::peaksAgreeWithDenseSampling()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    const LawParameters p = defaultParameters(law);
    const LawPeaks peaks = law.peaks(p);
    LawPeaks seen;
    constexpr int samples = 200000;
    for (int i = 0; i <= samples; ++i) {
        const LawPoint point = law.at(static_cast<double>(i) / samples, p);
        seen.cv = std::max(seen.cv, std::abs(point.g1));
        seen.ca = std::max(seen.ca, std::abs(point.g2));
        seen.cj = std::max(seen.cj, std::abs(point.g3));
    }
    QVERIFY(near(seen.cv, peaks.cv, 1e-6 * peaks.cv));
    QVERIFY(near(seen.ca, peaks.ca, 1e-6 * peaks.ca));
    if (std::isfinite(peaks.cj))
        QVERIFY(near(seen.cj, peaks.cj, 1e-6 * peaks.cj));
    QVERIFY(near(law.at(peaks.cvAt, p).g1, peaks.cv, 1e-12));
    QVERIFY(near(std::abs(law.at(peaks.caAt, p).g2), peaks.ca, 1e-12 * peaks.ca));
    for (int i = 1; i < 1000; ++i) // the first such place
        QVERIFY(std::abs(law.at(peaks.caAt * i / 1000, p).g2) <= peaks.ca * (1 + 1e-12));
}

void TestLaws::symmetryIsAsDeclared()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    const LawParameters p = defaultParameters(law);
    double asymmetry = 0;
    for (int i = 0; i <= 100; ++i)
        asymmetry = std::max(asymmetry, std::abs(law.at(i / 100.0, p).g + law.at(1 - i / 100.0, p).g - 1));
    QCOMPARE(asymmetry < 1e-12, law.isSymmetric);
    if (law.isDisplacementLaw) {
        QVERIFY(near(law.at(0, p).g1, 0, 1e-12));
        QVERIFY(near(law.at(1, p).g1, 0, 1e-12));
    }
}

void TestLaws::integralsBetweenJoints()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    const LawParameters p = defaultParameters(law);
    std::vector<double> ends = joints(law, p);
    ends.insert(ends.end(), {0, 1});
    std::sort(ends.begin(), ends.end());
    LawPoint sum; // of g in `integral`, of g' in g, of g'' in g1
    for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
        constexpr int parts = 500;
        const double width = (ends[piece + 1] - ends[piece]) / parts;
        for (int i = 0; i < parts; ++i) { // Gauss, three points
            const double middle = ends[piece] + (i + 0.5) * width;
            const double offset = width / 2 * std::sqrt(0.6);
            for (const auto& [x, weight] :
                 {std::pair(middle - offset, 5.0), std::pair(middle, 8.0), std::pair(middle + offset, 5.0)}) {
                const LawPoint point = law.at(x, p);
                sum.integral += point.g * weight * width / 18;
                sum.g += point.g1 * weight * width / 18;
                sum.g1 += point.g2 * weight * width / 18;
            }
        }
    }
    QVERIFY(near(sum.integral, law.at(1, p).integral, 1e-12));
    QVERIFY(near(sum.g, 1, 1e-12));
    QVERIFY(near(sum.g1, law.at(1, p).g1 - law.at(0, p).g1, 1e-11));
}

void TestLaws::continuousAtJoints()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    const LawParameters p = defaultParameters(law);
    const bool hasAccelerationSteps = law.id == LawId::Parabolic || law.id == LawId::Trapezoid;
    const bool hasJerkSteps =
        hasAccelerationSteps || law.id == LawId::SCurve || law.id == LawId::HalfModifiedSine;
    double accelerationStep = 0;
    double jerkStep = 0;
    for (const double x : joints(law, p)) {
        const LawPoint below = law.at(std::nextafter(x, 0.0), p);
        const LawPoint above = law.at(std::nextafter(x, 1.0), p);
        QVERIFY(near(above.integral, below.integral, 1e-12));
        QVERIFY(near(above.g, below.g, 1e-12));
        QVERIFY(near(above.g1, below.g1, 1e-12));
        accelerationStep = std::max(accelerationStep, std::abs(above.g2 - below.g2));
        jerkStep = std::max(jerkStep, std::abs(above.g3 - below.g3));
    }
    QCOMPARE(accelerationStep > 1e-12, hasAccelerationSteps);
    QCOMPARE(jerkStep > 1e-11, hasJerkSteps && law.id != LawId::Parabolic && law.id != LawId::Trapezoid);
}

// Checks that a law is smooth between the joints known here, and that g''' changes no faster than g4.
void TestLaws::piecesAreSmooth()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    LawParameters p = defaultParameters(law);
    p[0] *= 1.3;
    const LawPieces pieces = law.pieces(p);
    QVERIFY(std::is_sorted(pieces.joints.begin(), pieces.joints.end()));
    const std::vector<double> all = joints(law, p);
    for (const double joint : pieces.joints)
        QVERIFY(joint == 1 || isNearJoint(all, joint, 1e-12));
    double from = 0;
    double g3 = 0;
    double g4 = 0;
    constexpr int steps = 2000;
    for (std::size_t i = 0; i <= pieces.joints.size(); ++i) {
        const double to = i < pieces.joints.size() ? pieces.joints[i] : 1;
        const double width = (to - from) / (steps + 2);
        for (int step = 1; width > 0 && step <= steps; ++step) { // inside, beside the joints
            const LawPoint a = law.at(from + width * step, p);
            const LawPoint b = law.at(from + width * (step + 1), p);
            g3 = std::max({g3, std::abs(a.g3), std::abs(b.g2 - a.g2) / width});
            g4 = std::max(g4, std::abs(b.g3 - a.g3) / width);
        }
        from = to;
    }
    QVERIFY2(g3 <= pieces.g3 * (1 + 1e-6) + 1e-6 && g3 >= 0.99 * pieces.g3, std::to_string(g3).c_str());
    QVERIFY2(g4 <= pieces.g4 * (1 + 1e-6) + 1e-6 && g4 >= 0.99 * pieces.g4, std::to_string(g4).c_str());
}

void TestLaws::strengthsAndWeaknessesAreTrue()
{
    std::set<std::string_view> sentences;
    const auto peaks = [](LawId id) { return findLaw(id)->peaks(defaultParameters(*findLaw(id))); };
    const auto jumps = [](const Law& law) { return std::abs(law.at(0, {}).g2) > 1e-9; };
    for (const Law& law : laws()) {
        for (const std::string_view sentence : {law.strength, law.weakness}) {
            QVERIFY(sentences.insert(sentence).second);
            QVERIFY(sentence.size() > 20 && sentence.back() == '.');
            QVERIFY(sentence.find(". ") == std::string_view::npos); // one sentence
        }
        if (!law.isDisplacementLaw)
            continue;
        QVERIFY(law.isSymmetric); // the peaks of a motion count on it
        QVERIFY(law.peaks(defaultParameters(law)).ca >= peaks(LawId::Parabolic).ca);
        if (!law.parameters.empty())
            continue;
        const LawPeaks own = law.peaks({});
        QVERIFY(own.cv <= peaks(LawId::Polynomial4567).cv && own.ca <= peaks(LawId::Polynomial4567).ca);
        QVERIFY(std::isinf(own.cj) || own.cj <= peaks(LawId::ModifiedSine).cj);
        QVERIFY(jumps(law) || own.ca >= peaks(LawId::ModifiedTrapezoid).ca);
    }
    QVERIFY(peaks(LawId::HalfModifiedSine).cj <= peaks(LawId::ModifiedSine).cj);
    for (const LawId id : {LawId::Cubic, LawId::Harmonic, LawId::Parabolic})
        QVERIFY(jumps(*findLaw(id)));
    for (const LawId id : {LawId::Quintic, LawId::Cycloidal, LawId::ModifiedSine, LawId::ModifiedTrapezoid}) {
        QVERIFY(!jumps(*findLaw(id)));
        QVERIFY(findLaw(id)->at(0, {}).g3 > 1); // a step of the jerk, from rest
    }
    QCOMPARE(findLaw(LawId::Polynomial4567)->at(0, {}).g3, 0.0);
    QVERIFY(std::abs(findLaw(LawId::HalfModifiedSine)->at(1, {}).g2) > 1);
    // For the same time and peak acceleration a trapezoid has the lowest peak speed.
    for (const Law& law : laws()) {
        if (!law.isDisplacementLaw)
            continue;
        const LawPeaks own = law.peaks(defaultParameters(law));
        const double ramp = (1 - std::sqrt(1 - 4 / std::max(own.ca, 4.0))) / 2; // r (1 - r) Ca = 1
        QVERIFY(findLaw(LawId::Trapezoid)->peaks({ramp, 0}).cv <= own.cv * (1 + 1e-12));
    }
    // 22.29 % of the move.
    QVERIFY(near(1 / (0.2229 * (1 - 0.2229)), peaks(LawId::Quintic).ca, 2e-3));
}

void TestLaws::keysAndCodesAreUnique()
{
    std::set<std::string_view> keys;
    std::set<LawId> ids;
    for (const Law& law : laws()) {
        QVERIFY(keys.insert(law.key).second);
        QVERIFY(ids.insert(law.id).second);
        QCOMPARE(findLaw(law.key), &law);
        QCOMPARE(findLaw(law.id), &law);
        QVERIFY(law.parameters.size() <= maxLawParameters);
        for (const LawParameterInfo& parameter : law.parameters)
            QVERIFY(parameter.min < parameter.defaultValue && parameter.defaultValue < parameter.max);
    }
    QVERIFY(findLaw("no such law") == nullptr);
}

CAMPANEL_TEST(TestLaws)

} // namespace test_laws

#include "test_laws.moc"
