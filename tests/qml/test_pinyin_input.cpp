// SPDX-License-Identifier: Apache-2.0
// Pinyin letters become Chinese text by the installed dictionary.
#include "qml/Controls/pinyin_input.h"
#include "tests/support/test_program.h"

#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTest>

namespace test_pinyin_input {

using campanel::controls::PinyinInput;

namespace {

void type(PinyinInput& input, const char* letters)
{
    for (const char* letter = letters; *letter; ++letter)
        input.add(QString(QLatin1Char(*letter)));
}

} // namespace

class TestPinyinInput : public QObject {
    Q_OBJECT

private slots:
    void wordsAreFound_data()
    {
        QTest::addColumn<QByteArray>("letters");
        QTest::addColumn<QString>("spelling");
        QTest::addColumn<QString>("word");
        QTest::newRow("biscuit") << QByteArray("binggan") << QStringLiteral("bing'gan")
                                 << QStringLiteral("饼干");
        QTest::newRow("soap") << QByteArray("feizao") << QStringLiteral("fei'zao") << QStringLiteral("肥皂");
        QTest::newRow("noodles") << QByteArray("miantiao") << QStringLiteral("mian'tiao")
                                 << QStringLiteral("面条");
    }

    void wordsAreFound()
    {
        QFETCH(QByteArray, letters);
        QFETCH(QString, spelling);
        QFETCH(QString, word);
        PinyinInput input;
        QVERIFY(input.available());
        QSignalSpy committed(&input, &PinyinInput::committed);
        type(input, letters.constData());
        QCOMPARE(input.spelling(), spelling);
        const qsizetype at = input.candidates().indexOf(word);
        QVERIFY2(at >= 0 && at < 5, qPrintable(input.candidates().join(u' ')));
        input.choose(static_cast<int>(at));
        QCOMPARE(committed.count(), 1);
        QCOMPARE(committed.first().first().toString(), word);
        QVERIFY(input.spelling().isEmpty());
        QVERIFY(input.candidates().isEmpty());
    }

    void aWordIsPutTogetherFromCharacters()
    {
        PinyinInput input;
        QSignalSpy committed(&input, &PinyinInput::committed);
        type(input, "binggan");
        const qsizetype ice = input.candidates().indexOf(QStringLiteral("冰"));
        QVERIFY(ice > 0);
        input.choose(static_cast<int>(ice));
        QCOMPARE(committed.takeFirst().first().toString(), QStringLiteral("冰"));
        QCOMPARE(input.spelling(), QStringLiteral("gan"));
        const qsizetype sweet = input.candidates().indexOf(QStringLiteral("甘"));
        QVERIFY(sweet >= 0);
        input.choose(static_cast<int>(sweet));
        QCOMPARE(committed.takeFirst().first().toString(), QStringLiteral("甘"));
        QVERIFY(input.spelling().isEmpty());
    }

    void eraseTakesLettersBack()
    {
        PinyinInput input;
        type(input, "binggan");
        for (int letters = 7; letters > 0; --letters) {
            QVERIFY(!input.spelling().isEmpty());
            input.erase();
        }
        QVERIFY(input.spelling().isEmpty());
        QVERIFY(input.candidates().isEmpty());
        input.erase();
    }

    // The library ends the program by assertions for excessive input.
    void anyLettersAndChoicesAreSurvived()
    {
        QRandomGenerator random(1);
        PinyinInput input;
        for (const char* alphabet : {"a", "aeoin", "bangixo", "abcdefghijklmnopqrstuvwxyz"}) {
            const QByteArray letters(alphabet);
            for (int i = 0; i < 4000; ++i) {
                const int what = random.bounded(12);
                if (what == 0)
                    input.choose(random.bounded(PinyinInput::maxCandidates));
                else if (what == 1)
                    input.erase();
                else if (what == 2 && random.bounded(10) == 0)
                    input.clear();
                else
                    input.add(
                        QString(QLatin1Char(letters[random.bounded(static_cast<int>(letters.size()))])));
                QVERIFY(input.spelling().remove(u'\'').size() <= PinyinInput::maxLetters);
                QVERIFY(input.candidates().size() <= PinyinInput::maxCandidates);
            }
        }
    }

    void whatIsNoPinyinDoesNoHarm()
    {
        PinyinInput input;
        type(input, "V1-vvvv");
        QCOMPARE(input.spelling(), QStringLiteral("vvvv"));
        input.choose(0);
        input.choose(-1);
        input.clear();
        QVERIFY(input.spelling().isEmpty());
        type(input, QByteArray(200, 'a').constData());
        QVERIFY(input.spelling().remove(u'\'').size() <= PinyinInput::maxLetters);
        QVERIFY(input.candidates().size() <= PinyinInput::maxCandidates);
    }
};

CAMPANEL_TEST(TestPinyinInput)

} // namespace test_pinyin_input

#include "test_pinyin_input.moc"
