// SPDX-License-Identifier: Apache-2.0
// QR codes as another program reads them.
#include "samples.h"

#include "app/plot/qr_code.h"
#include "tests/support/qr_reader.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <random>

namespace campanel::plot::test_qr_code {

using namespace Qt::StringLiterals;

namespace {

// The most bytes of a recipe's code.
constexpr int longestCode = 64;

QImage painted(const QString& text, QSize size)
{
    QrCode picture;
    picture.setSize(size);
    picture.setText(text);
    return test::paintItem(picture);
}

} // namespace

class TestQrCode : public QObject {
    Q_OBJECT
private slots:
    void anotherProgramReadsThem()
    {
        const auto seed = std::random_device{}();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const auto between = [&random](int low, int high) {
            return std::uniform_int_distribution<int>(low, high)(random);
        };
        QStringList texts{u"Biscuit 250"_s,  u"4006381333931"_s, u"~"_s,       QString(longestCode, u'7'),
                          u"Schoko Ä 120"_s, u"苏打饼干 200"_s,  u"PE 30 µm"_s};
        while (texts.size() < 60) {
            QString text;
            for (int i = between(1, longestCode); i > 0; --i)
                text += QChar(between('!', '~'));
            texts << text;
        }
        const QTemporaryDir folder;
        QStringList pictures;
        for (const QString& text : texts) {
            pictures << folder.filePath(QString::number(pictures.size()) + u".png"_s);
            // The smallest has two pixels per module of the longest code.
            QVERIFY(painted(text, {between(90, 400), between(90, 400)}).save(pictures.last()));
        }
        QCOMPARE(campanel::test::readQrCodes(pictures), texts);
    }

    void theLongestCodeHasFewModules()
    {
        const QrModules modules = qrModules(QString(longestCode, u'a'));
        QCOMPARE(modules.perSide, 37); // version 5
        QCOMPARE(modules.dark.size(), std::size_t{37 * 37});
    }

    void theQuietZoneIsWhite()
    {
        const QImage image = painted(u"Biscuit 250"_s, {100, 66});
        constexpr int pixels = 2; // per module: 25 and two quiet zones of 4
        constexpr int quiet = pixels * qrQuietModules;
        const int left = (100 - 66) / 2; // centered
        QCOMPARE(test::inkIn(image, {0, 0, left + quiet, 66}, Qt::black), 0);
        QCOMPARE(test::inkIn(image, {0, 0, 100, quiet}, Qt::black), 0);
        QCOMPARE(test::inkIn(image, {0, 66 - quiet, 100, quiet}, Qt::black), 0);
        // The finder pattern begins with a bar of seven modules.
        QCOMPARE(test::inkIn(image, {left + quiet, quiet, 7 * pixels, pixels}, Qt::black),
                 7 * pixels * pixels);
    }

    void nothingHasNoCode()
    {
        for (const QString& text : {QString(), QString(2332, u'a')}) {
            QCOMPARE(qrModules(text).perSide, 0);
            QCOMPARE(test::inkIn(painted(text, {100, 100}), {0, 0, 100, 100}, Qt::black), 0);
        }
    }

    void reportsOnlyAChange()
    {
        QrCode picture;
        const QSignalSpy changed(&picture, &QrCode::textChanged);
        picture.setText(u"Soap"_s);
        picture.setText(u"Soap"_s);
        QCOMPARE(changed.count(), 1);
    }
};

CAMPANEL_TEST(TestQrCode)

} // namespace campanel::plot::test_qr_code

#include "test_qr_code.moc"
