// SPDX-License-Identifier: Apache-2.0
// The printed report as other programs read it.
#include "app/report/commissioning_pdf.h"
#include "app/shell/fonts.h"
#include "tests/support/qr_reader.h"
#include "tests/support/test_program.h"

#include <QFile>
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
        if (!file.open(QIODevice::WriteOnly) || file.write(commissioningPdf(data)) <= 0)
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
};

CAMPANEL_TEST(TestCommissioningPdf)

} // namespace campanel::report::test_commissioning_pdf

#include "test_commissioning_pdf.moc"
