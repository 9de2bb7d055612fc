// SPDX-License-Identifier: Apache-2.0
// The printed report as other programs read it.
#include "app/report/commissioning_pdf.h"
#include "app/shell/fonts.h"
#include "tests/support/qr_reader.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

namespace campanel::report::test_commissioning_pdf {

using namespace Qt::StringLiterals;

class TestCommissioningPdf : public QObject {
    Q_OBJECT

    const QTemporaryDir m_folder;

    [[nodiscard]] QString print(const panel::ReportData& data) const
    {
        const QString path = m_folder.filePath(u"report.pdf"_s);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(commissioningPdf(data, {})) <= 0)
            qFatal("the report was not written");
        return path;
    }

private slots:
    void initTestCase() { shell::applyFonts(); }

    void itsCodesCanBeScanned_data()
    {
        QTest::addColumn<QStringList>("codes");
        QTest::newRow("none") << QStringList();
        QTest::newRow("of the recipe") << QStringList{u"Biscuit 250"_s};
        QTest::newRow("and of the reel") << QStringList{u"4006381333931"_s, u"PE 30"_s};
        QTest::newRow("the longest") << QStringList{QString(64, u'7'), QString(64, u'W')};
    }
    void itsCodesCanBeScanned()
    {
        QFETCH(QStringList, codes);
        panel::ReportData data;
        data.title = u"Commissioning report"_s;
        data.pageText = u"Page %1"_s;
        for (const QString& code : codes)
            data.codes.append({u"Code"_s, code});
        data.sections = {{u"Recipe"_s, {{u"Program"_s, u"Cross cutter"_s}}, {}}};
        const QString pdf = print(data);
        const QString picture = m_folder.filePath(u"page"_s);
        test::outputOf(u"pdftoppm"_s, {u"-r"_s, u"150"_s, u"-png"_s, u"-singlefile"_s, pdf, picture});
        QStringList read = test::readQrCodes({picture + u".png"_s});
        QStringList printed = codes;
        read.sort();
        printed.sort();
        QCOMPARE(read, printed);
        // The code is legible beside its picture, whole and within the page.
        QString words = QString::fromUtf8(test::outputOf(u"pdftotext"_s, {u"-raw"_s, pdf, u"-"_s}));
        words.remove(u'\n');
        for (const QString& code : codes)
            QVERIFY2(words.contains(code), qPrintable(words));
        QVERIFY2(words.contains(u"Cross cutter"_s), qPrintable(words));
    }

    // The stops of a shift stand in their order, one below the other.
    void aListHasOneColumn()
    {
        panel::ReportData data;
        data.title = u"Shift report"_s;
        data.machine = u"Machine with controller 1A2B"_s;
        data.pageText = u"Page %1"_s;
        data.signatures = QStringList{u"Date"_s, u"Name and signature"_s};
        panel::ReportSection stops{u"Stops"_s, {}, {}, true};
        QStringList times;
        for (int i = 0; i < 60; ++i) {
            times << u"06:%1"_s.arg(i, 2, 10, QChar(u'0'));
            stops.rows.append({times.last(), u"Film"_s});
        }
        data.sections = {stops};
        const QString pdf = print(data);
        const QString words = QString::fromUtf8(test::outputOf(u"pdftotext"_s, {u"-layout"_s, pdf, u"-"_s}));
        QStringList printed;
        for (const QString& each : words.split(u'\n')) {
            if (each.contains(u"06:"))
                printed << each.simplified();
        }
        QCOMPARE(printed.size(), times.size());
        for (qsizetype i = 0; i < times.size(); ++i)
            QCOMPARE(printed[i], times[i] + u" Film"_s);
        QVERIFY2(words.contains(u"Machine with controller 1A2B"_s), qPrintable(words));
        QVERIFY2(words.contains(u"Name and signature"_s), qPrintable(words));
    }

    // The colors of the kinds that were not there are in the legend alone.
    void theBarShowsTheStates()
    {
        panel::ReportData data;
        data.title = u"Shift report"_s;
        data.pageText = u"Page %1"_s;
        data.bar.stretches = {{0, 0.5, 0}, {0.5, 0.25, 4}};
        data.bar.hours = {{0, u"06:00"_s}, {0.5, u"10:00"_s}};
        data.bar.kinds = QStringList{u"Running"_s, u"Stopped"_s, u"Waiting"_s, u"Manual"_s, u"Fault"_s};
        const QString pdf = print(data);
        const QString picture = m_folder.filePath(u"bar"_s);
        test::outputOf(u"pdftoppm"_s, {u"-r"_s, u"96"_s, u"-png"_s, u"-singlefile"_s, pdf, picture});
        const QImage page(picture + u".png"_s);
        const QColor running = ReportColors().sync;
        const QColor fault = ReportColors().fault;
        const auto pixels = [&page](const QColor& color) {
            qsizetype count = 0;
            for (int y = 0; y < page.height(); ++y) {
                for (int x = 0; x < page.width(); ++x)
                    count += page.pixelColor(x, y) == color ? 1 : 0;
            }
            return count;
        };
        QVERIFY2(pixels(fault) > 4000, qPrintable(QString::number(pixels(fault))));
        const double ratio = double(pixels(running)) / double(pixels(fault));
        QVERIFY2(ratio > 1.8 && ratio < 2.2, qPrintable(QString::number(ratio)));
        const QString words = QString::fromUtf8(test::outputOf(u"pdftotext"_s, {u"-raw"_s, pdf, u"-"_s}));
        for (const QString& each : data.bar.kinds)
            QVERIFY2(words.contains(each), qPrintable(words));
        QVERIFY2(words.contains(u"10:00"_s), qPrintable(words));
    }
};

CAMPANEL_TEST(TestCommissioningPdf)

} // namespace campanel::report::test_commissioning_pdf

#include "test_commissioning_pdf.moc"
