// SPDX-License-Identifier: Apache-2.0
// The filter of a list of records: limits that are moved, days, and the summary of one line.
#include "app/panel/kit/log_filter_editor.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

namespace test_log_filter_editor {

using namespace Qt::StringLiterals;
using campanel::panel::LogFilterEditor;

namespace {

constexpr int day = 24 * 60;

} // namespace

class TestLogFilterEditor : public QObject {
    Q_OBJECT

    std::unique_ptr<LogFilterEditor> m_filter;

private slots:
    void init()
    {
        m_filter = std::make_unique<LogFilterEditor>(nullptr);
        m_filter->setWallClock([] { return QDateTime(QDate(2026, 1, 15), QTime(14, 7)); });
    }

    void startsWithToday()
    {
        QVERIFY(!m_filter->active());
        QCOMPARE(m_filter->summary(), QString());
        m_filter->move(LogFilterEditor::From, -60);
        QCOMPARE(m_filter->fromText(), u"2026-01-14 23:00"_s);
        QCOMPARE(m_filter->summary(), u"from 2026-01-14 23:00"_s);
        m_filter->removeLimit(LogFilterEditor::From);
        QVERIFY(!m_filter->active());
        m_filter->move(LogFilterEditor::To, -10);
        QCOMPARE(m_filter->summary(), u"until 2026-01-15 23:50"_s);
    }

    void otherLimitFollows()
    {
        m_filter->showDay(LogFilterEditor::From);
        QCOMPARE(m_filter->summary(), u"2026-01-15 00:00 to 2026-01-16 00:00"_s);
        m_filter->move(LogFilterEditor::To, -7 * day);
        QCOMPARE(m_filter->summary(), u"2026-01-08 00:00 to 2026-01-09 00:00"_s);
        m_filter->move(LogFilterEditor::From, 7 * day);
        QCOMPARE(m_filter->summary(), u"2026-01-15 00:00 to 2026-01-16 00:00"_s);
        m_filter->showDay(LogFilterEditor::To);
        QCOMPARE(m_filter->summary(), u"2026-01-15 00:00 to 2026-01-16 00:00"_s);
    }

    void idAndWordAreTrimmed()
    {
        const QSignalSpy changed(m_filter.get(), &LogFilterEditor::changed);
        m_filter->setId(u" C-01 "_s);
        m_filter->setWord(u"  film jam "_s);
        QCOMPARE(m_filter->summary(), u"C-01 · “film jam”"_s);
        m_filter->setWord(u"film jam"_s);
        QCOMPARE(changed.size(), 2);
        m_filter->setWord(QString(100, u'x'));
        QCOMPARE(m_filter->word().size(), LogFilterEditor::maxTextLength);
        m_filter->clear();
        QVERIFY(!m_filter->active());
    }
};

CAMPANEL_TEST(TestLogFilterEditor)

} // namespace test_log_filter_editor

#include "test_log_filter_editor.moc"
