// SPDX-License-Identifier: Apache-2.0
// Invariants of the metric table; docs/metrics.md must match it. The dead band.
#include "app/plant/metric_document.h"
#include "app/plant/metric_value.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QSet>
#include <QTest>

namespace test_metric_table {

using namespace campanel::plant;

class TestMetricTable : public QObject {
    Q_OBJECT

private slots:
    void committedDocumentIsCurrent()
    {
        QFile file(campanel::test::sourcePath("docs/metrics.md"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(file.readAll() == QByteArray::fromStdString(metricsMarkdown()),
                 "docs/metrics.md is out of date: build/ci/bin/campanel-generate-metrics >docs/metrics.md");
    }

    void namesAreUniqueAndEveryRowIsExplained()
    {
        QSet<QByteArray> seen;
        for (const MetricRow& row : metricTable) {
            const QByteArray name(row.name.data(), static_cast<qsizetype>(row.name.size()));
            QVERIFY2(!seen.contains(name), name);
            seen << name;
            QVERIFY2(!row.source.empty() && !row.text.empty() && row.text.ends_with('.'), name);
            const bool isNumber = row.type != MetricType::Boolean && row.type != MetricType::String;
            QVERIFY2(row.deadBand == 0 || isNumber, name);
        }
    }

    void deadBand()
    {
        const MetricRow& rate = metricRow(Metric::CurMachSpeed); // 0.5
        QVERIFY(!isChange(rate, 60.0, 60.4));
        QVERIFY(isChange(rate, 60.0, 60.5));
        QVERIFY(isChange(rate, 60.0, 59.5));
        QVERIFY(isChange(rate, 60.0, {}));
        QVERIFY(isChange(rate, {}, 60.0));
        QVERIFY(!isChange(rate, {}, {}));
        const MetricRow& count = metricRow(Metric::ProdProcessedCount);
        QVERIFY(isChange(count, std::int64_t(1), std::int64_t(2)));
        QVERIFY(!isChange(count, std::int64_t(2), std::int64_t(2)));
    }

    void typesAreChecked()
    {
        QVERIFY(isOfType({}, MetricType::Double));
        QVERIFY(isOfType(std::int64_t(-1), MetricType::Int32));
        QVERIFY(isOfType(std::int64_t(4294967295), MetricType::Int64));
        QVERIFY(!isOfType(std::int64_t(2147483648), MetricType::Int32));
        QVERIFY(!isOfType(std::nan(""), MetricType::Double));
        QVERIFY(!isOfType(1.5, MetricType::Int32));
        QVERIFY(isOfType(QString(), MetricType::String));
        QVERIFY(!isOfType(true, MetricType::String));
    }
};

CAMPANEL_TEST(TestMetricTable)

} // namespace test_metric_table

#include "test_metric_table.moc"
