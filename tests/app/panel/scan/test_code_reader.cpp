// SPDX-License-Identifier: Apache-2.0
// Codes of a scanner among typed keys: what is read, and what a field gets.
#include "app/panel/scan/code_reader.h"
#include "app/program/recipe.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

namespace test_code_reader {

using namespace campanel;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;
using panel::CodeReader;
using panel::ScannerKeys;

namespace {

// A field behind the reader, and the hand and the scanner before it.
struct Desk {
    CodeReader reader;
    link::SteadyTime now{1h};
    QString field;
    QString held;
    QStringList codes;
    int halves = 0;

    explicit Desk(const ScannerKeys& keys = {u"~~"_s, false, 100ms}) { reader.setKeys(keys); }

    void follow(const CodeReader::Step& step)
    {
        field += held.left(step.released);
        held.remove(0, step.released);
        if (step.isBegun)
            held.clear();
        halves += step.isHalf ? 1 : 0;
        if (step.code)
            codes << *step.code;
    }
    void press(int key, const QString& text, bool isRepeat = false,
               std::optional<Qt::KeyboardModifiers> modifiers = {})
    {
        const CodeReader::Step step = reader.press({key, text, isRepeat, modifiers}, now);
        follow(step);
        if (step.isHeld)
            held += text;
        if (!step.isTaken)
            field += text;
    }
    // Sends "|" as Enter and ">" as Tab.
    void send(const QString& keys, std::chrono::milliseconds gap)
    {
        for (const QChar letter : keys) {
            now += gap;
            if (letter == u'|')
                press(Qt::Key_Return, u"\r"_s);
            else if (letter == u'>')
                press(Qt::Key_Tab, u"\t"_s);
            else
                press(Qt::Key_A, QString(letter));
        }
    }
    void wait(std::chrono::milliseconds time)
    {
        now += time;
        follow(reader.expire(now));
    }
};

} // namespace

class TestCodeReader : public QObject {
    Q_OBJECT

private slots:
    // The second Return would be OK of an open keypad.
    void aSecondReturnIsSwallowed()
    {
        for (const QString& ends : {u"||"_s, u"|>"_s, u"|||"_s}) {
            Desk desk;
            desk.send(u"95"_s, 200ms);
            desk.send(u"~~A1"_s + ends, 20ms);
            QCOMPARE(desk.codes, QStringList{u"A1"_s});
            QCOMPARE(desk.field, u"95"_s);
            desk.send(u"|"_s, 101ms); // of a person
            QCOMPARE(desk.field, u"95\r"_s);
        }
        Desk half;
        half.send(u"~~A\x01||"_s, 20ms);
        QCOMPARE(half.halves, 1);
        QCOMPARE(half.field, QString());
    }

    // FNC1 in a GS1 code, in the ways in which scanners send it.
    void separatorsOfGs1StayInTheCode_data()
    {
        QTest::addColumn<int>("way");
        for (const int way : {0, 1, 2})
            QTest::addRow("way %d", way) << way;
    }
    void separatorsOfGs1StayInTheCode()
    {
        QFETCH(int, way);
        Desk desk;
        const auto separate = [&desk, way] {
            if (way == 0)
                desk.press(Qt::Key_BracketRight, QString(QChar(0x1d)), false, Qt::ControlModifier);
            else if (way == 1)
                desk.press(Qt::Key_F8, {}, false, Qt::NoModifier);
            for (const QChar digit : way == 2 ? u"029"_s : QString())
                desk.press(Qt::Key_0 + digit.digitValue(), QString(digit), false, Qt::AltModifier);
        };
        desk.send(u"~~"_s, 10ms);
        separate(); // some scanners send the first one
        desk.send(u"10ABC"_s, 10ms);
        separate();
        desk.send(u"21X"_s, 10ms);
        desk.send(u"|"_s, 10ms);
        QCOMPARE(desk.codes, QStringList{u"10ABC|21X"_s});
        QCOMPARE(desk.halves, 0);
        QCOMPARE(desk.field, QString());
    }

    void capsLockChangesNoCode_data()
    {
        QTest::addColumn<QString>("prefix");
        QTest::addColumn<QString>("code");
        QTest::addRow("letters") << u"~~"_s << u"Biscuit 250-Xl"_s;
        QTest::addRow("capitals") << u"~~"_s << u"PE 30"_s;
        QTest::addRow("digits") << u"~~"_s << u"4006381"_s;
        QTest::addRow("a prefix of letters") << u"Qz"_s << u"aB7"_s;
    }
    void capsLockChangesNoCode()
    {
        QFETCH(QString, prefix);
        QFETCH(QString, code);
        for (const bool isCapsLockOn : {false, true}) {
            Desk desk({prefix, false, 100ms});
            for (const QChar letter : prefix + code) {
                const bool hasCase = letter.toUpper() != letter.toLower();
                const QString text(hasCase && isCapsLockOn
                                       ? (letter.isUpper() ? letter.toLower() : letter.toUpper())
                                       : letter);
                desk.press(Qt::Key_A, text, false, letter.isUpper() ? Qt::ShiftModifier : Qt::NoModifier);
            }
            desk.press(Qt::Key_Return, u"\r"_s, false, Qt::NoModifier);
            QCOMPARE(desk.codes, QStringList{code});
        }
    }

    // It presses Caps Lock for its capitals, without Shift.
    void aScannerMayUseCapsLockItself()
    {
        Desk desk;
        desk.send(u"~~"_s, 10ms);
        desk.press(Qt::Key_CapsLock, {});
        for (const char* letter : {"P", "E"})
            desk.press(Qt::Key_A, QString::fromLatin1(letter), false, Qt::NoModifier);
        desk.press(Qt::Key_CapsLock, {});
        desk.press(Qt::Key_Return, u"\r"_s, false, Qt::NoModifier);
        QCOMPARE(desk.codes, QStringList{u"PE"_s});
    }

    void readsACodeAndGivesTheFieldNothing_data()
    {
        QTest::addColumn<QString>("prefix");
        QTest::addColumn<bool>("tab");
        QTest::addColumn<QString>("sent");
        QTest::addColumn<QStringList>("codes");
        QTest::addColumn<int>("halves");
        QTest::addColumn<QString>("field");
        QTest::newRow("a code") << u"~~"_s << false << u"~~Biscuit 250|"_s << QStringList{u"Biscuit 250"_s}
                                << 0 << QString();
        QTest::newRow("one key of prefix")
            << u"~"_s << false << u"~A1|"_s << QStringList{u"A1"_s} << 0 << QString();
        QTest::newRow("tab") << u"~~"_s << true << u"~~A1>"_s << QStringList{u"A1"_s} << 0 << QString();
        QTest::newRow("two codes") << u"~~"_s << false << u"~~A1|~~B2|"_s << QStringList{u"A1"_s, u"B2"_s}
                                   << 0 << QString();
        QTest::newRow("letters of other languages")
            << u"~~"_s << false << u"~~饼干Ä|"_s << QStringList{u"饼干Ä"_s} << 0 << QString();
        QTest::newRow("a code that begins like the prefix")
            << u"~~"_s << false << u"~~~A|"_s << QStringList{u"~A"_s} << 0 << QString();
        QTest::newRow("prefix after typed keys")
            << u"~~"_s << false << u"ab~~A1|c"_s << QStringList{u"A1"_s} << 0 << u"abc"_s;
        QTest::newRow("a part of the prefix")
            << u"~~"_s << false << u"a~b"_s << QStringList() << 0 << u"a~b"_s;
        QTest::newRow("the prefix begins within itself")
            << u"aab"_s << false << u"aaab7|"_s << QStringList{u"7"_s} << 0 << u"a"_s;
        QTest::newRow("nothing between") << u"~~"_s << false << u"~~|"_s << QStringList() << 1 << QString();
        QTest::newRow("spaces between") << u"~~"_s << false << u"~~  |"_s << QStringList() << 1 << QString();
        QTest::newRow("prefix in the middle")
            << u"~~"_s << false << u"~~A1~~B2|c"_s << QStringList() << 1 << u"c"_s;
        QTest::newRow("a tab in a code that ends by Enter")
            << u"~~"_s << false << u"~~A>1|c"_s << QStringList() << 1 << u"c"_s;
        QTest::newRow("a control character")
            << u"~~"_s << false << u"~~A\x01|c"_s << QStringList() << 1 << u"c"_s;
        QTest::newRow("half a surrogate pair")
            << u"~~"_s << false << u"~~A"_s + QChar(0xD83D) + u"|c"_s << QStringList() << 1 << u"c"_s;
        QTest::newRow("no scanner") << QString() << false << u"~~A1"_s << QStringList() << 0 << u"~~A1"_s;
    }
    void readsACodeAndGivesTheFieldNothing()
    {
        QFETCH(QString, prefix);
        QFETCH(bool, tab);
        QFETCH(QString, sent);
        QFETCH(QStringList, codes);
        QFETCH(int, halves);
        QFETCH(QString, field);
        Desk desk({prefix, tab, 100ms});
        desk.send(sent, 5ms);
        desk.wait(2s);
        QCOMPARE(desk.codes, codes);
        QCOMPARE(desk.halves, halves);
        QCOMPARE(desk.field, field);
        QVERIFY(!desk.reader.isWaiting());
    }

    void halfACodeIsDroppedAfterTheTime()
    {
        Desk desk;
        desk.send(u"~~Bisc"_s, 5ms);
        desk.wait(100ms);
        QCOMPARE(desk.halves, 0);
        desk.wait(1ms);
        QCOMPARE(desk.halves, 1);
        QCOMPARE(desk.field, QString());
        desk.send(u"uit|"_s, 5ms); // the scanner has paused
        QCOMPARE(desk.codes, QStringList());
        QCOMPARE(desk.field, QString());
        desk.send(u"typed"_s, 5ms);
        QCOMPARE(desk.field, u"typed"_s);
        desk.send(u"~~Biscuit|"_s, 5ms);
        QCOMPARE(desk.codes, QStringList{u"Biscuit"_s});
        QCOMPARE(desk.halves, 1);
    }

    // A code whose end was lost keeps nobody from typing.
    void typingGoesOnSomeTimeAfterHalfACode()
    {
        Desk desk;
        desk.send(u"~~Bisc"_s, 5ms);
        desk.wait(1001ms);
        desk.send(u"typed"_s, 150ms);
        QCOMPARE(desk.field, u"typed"_s);
        QCOMPARE(desk.halves, 1);
    }

    void aSlowPrefixIsTyping()
    {
        Desk desk;
        desk.send(u"~~A1|"_s, 101ms);
        QVERIFY(desk.codes.isEmpty());
        QCOMPARE(desk.halves, 0);
        QCOMPARE(desk.field, u"~~A1\r"_s);
    }

    void aHeldKeyIsDeliveredAfterTheTime()
    {
        Desk desk;
        desk.send(u"a~"_s, 5ms);
        QCOMPARE(desk.field, u"a"_s);
        QVERIFY(desk.reader.isWaiting());
        desk.wait(101ms);
        QCOMPARE(desk.field, u"a~"_s);
        QVERIFY(!desk.reader.isWaiting());
    }

    void capitalsNeedTheShiftKey()
    {
        Desk desk;
        desk.send(u"~~"_s, 5ms);
        desk.press(Qt::Key_Shift, {});
        desk.send(u"A|"_s, 5ms);
        QCOMPARE(desk.codes, QStringList{u"A"_s});
    }

    void aKeyThatRepeatsIsNoScanner()
    {
        Desk desk;
        desk.send(u"~~A"_s, 5ms);
        desk.press(Qt::Key_A, u"A"_s, true);
        QCOMPARE(desk.halves, 1);
    }

    void aFloodIsBoundedAndNeverTyped()
    {
        Desk desk;
        desk.send(u"~~"_s, 5ms);
        desk.send(QString(100'000, u'7'), 1ms);
        QCOMPARE(desk.halves, 1);
        QCOMPARE(desk.field, QString());
        desk.send(u"|ok"_s, 1ms);
        QCOMPARE(desk.field, u"ok"_s);

        const auto longest = static_cast<qsizetype>(program::maxCodeBytes);
        desk.send(u"~~"_s + QString(longest, u'7') + u'|', 1ms);
        QCOMPARE(desk.codes, QStringList{QString(longest, u'7')});
        desk.send(u"~~"_s + QString(longest + 1, u'7') + u'|', 1ms);
        QCOMPARE(desk.codes.size(), 1);
        QCOMPARE(desk.halves, 2);
    }

    // Typed keys arrive all and in order; a code arrives whole or not, and nothing of it in the field.
    void randomTypingAndScanning()
    {
        const auto seed = std::random_device{}();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const auto upTo = [&random](int count) {
            return static_cast<int>(random() % static_cast<unsigned>(count));
        };
        Desk desk;
        QString typed;
        QStringList scanned;
        int halves = 0;
        for (int round = 0; round < 20'000; ++round) {
            const int what = upTo(3);
            if (what == 0) {
                QString text;
                for (int i = upTo(6); i >= 0; --i)
                    text += u"abc~"_s.at(upTo(4));
                if (text.contains(u"~~"_s) || (typed.endsWith(u'~') && text.startsWith(u'~')))
                    text = u"a"_s;
                typed += text;
                desk.send(text, std::chrono::milliseconds(1 + upTo(300)));
                if (text.endsWith(u'~'))
                    desk.wait(101ms);
            } else {
                QString code;
                for (int i = upTo(20); i >= 0; --i)
                    code += QChar(u'0' + upTo(10));
                const bool isWhole = what == 1;
                desk.send(u"~~"_s + code + (isWhole ? u"|"_s : QString()),
                          std::chrono::milliseconds(1 + upTo(100)));
                if (isWhole) {
                    scanned << code;
                } else {
                    ++halves;
                    desk.wait(1001ms);
                }
            }
        }
        QCOMPARE(desk.field, typed);
        QCOMPARE(desk.codes, scanned);
        QCOMPARE(desk.halves, halves);
    }
};

CAMPANEL_TEST(TestCodeReader)

} // namespace test_code_reader

#include "test_code_reader.moc"
