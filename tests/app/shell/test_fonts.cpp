// SPDX-License-Identifier: Apache-2.0
// The letters that the panel's fonts have.
#include "app/shell/fonts.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_fonts {

using namespace campanel;

class TestFonts : public QObject {
    Q_OBJECT

private slots:
    void lettersWithoutAGlyphAreKnown_data()
    {
        QTest::addColumn<char32_t>("letter");
        QTest::addColumn<bool>("isShown");
        QTest::addRow("Latin") << U'ü' << true;
        QTest::addRow("Cyrillic") << U'Ж' << true;
        QTest::addRow("Chinese") << U'饼' << true;
        QTest::addRow("Arabic") << U'\u0628' << false;
        QTest::addRow("Thai") << U'\u0e01' << false;
        QTest::addRow("emoji") << U'\U0001F60A' << false;
    }

    void lettersWithoutAGlyphAreKnown()
    {
        QFETCH(char32_t, letter);
        shell::applyFonts();
        QTEST(shell::hasGlyph(letter), "isShown");
    }
};

CAMPANEL_TEST(TestFonts)

} // namespace test_fonts

#include "test_fonts.moc"
