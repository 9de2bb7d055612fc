// SPDX-License-Identifier: Apache-2.0
// The row model against a plain list: random sequences of lists, what the views are told, and the fewest
// steps.
#include "app/panel/kit/row_model.h"
#include "tests/support/test_program.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <numeric>
#include <random>

namespace test_row_model {

using namespace campanel::panel;

struct Letter {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(int value MEMBER value)
    Q_PROPERTY(QString text READ text)

public:
    QString name;
    int value = 0;

    [[nodiscard]] QString text() const { return name + QString::number(value); }
    bool operator==(const Letter&) const = default;
};

using Letters = RowModel<Letter, &Letter::name>;

// One row for each letter; its value is the digit behind it.
QList<Letter> lettersOf(const QString& text)
{
    QList<Letter> rows;
    for (const QChar c : text) {
        if (c.isDigit())
            rows.last().value = c.digitValue();
        else
            rows << Letter{c, 0};
    }
    return rows;
}

QString textOf(const QAbstractItemModel& model)
{
    const int role = model.roleNames().key("text");
    QString text;
    for (int i = 0; i < model.rowCount(); ++i)
        text += model.data(model.index(i, 0), role).toString();
    return text.remove(u'0');
}

// A view's copy of the model, which follows the signals alone, and a log of them.
class View : public QObject {
public:
    explicit View(const Letters& model)
        : m_model(model)
        , m_rows(model.rows())
    {
        connect(&model, &Letters::rowsRemoved, this, [this](const QModelIndex&, int first, int last) {
            log += QStringLiteral("-%1 ").arg(last - first + 1);
            m_rows.remove(first, last - first + 1);
        });
        connect(&model, &Letters::rowsInserted, this, [this](const QModelIndex&, int first, int last) {
            log += QStringLiteral("+%1 ").arg(last - first + 1);
            for (int row = first; row <= last; ++row)
                m_rows.insert(row, m_model.row(row));
        });
        connect(&model, &Letters::rowsMoved, this,
                [this](const QModelIndex&, int first, int last, const QModelIndex&, int to) {
                    QCOMPARE(last, first);
                    log += QStringLiteral(">1 ");
                    m_rows.move(first, to > first ? to - 1 : to);
                });
        connect(&model, &Letters::dataChanged, this,
                [this](const QModelIndex& first, const QModelIndex& last) {
                    log += QStringLiteral("=%1 ").arg(last.row() - first.row() + 1);
                    for (int row = first.row(); row <= last.row(); ++row)
                        m_rows[row] = m_model.row(row);
                });
        connect(&model, &Letters::modelReset, this, [this] { ++resets; });
    }

    [[nodiscard]] const QList<Letter>& rows() const { return m_rows; }

    QString log;
    int resets = 0;

private:
    const Letters& m_model;
    QList<Letter> m_rows;
};

class RowModelTest : public QObject {
    Q_OBJECT

private slots:
    void steps_data();
    void steps();
    void rolesAreTheProperties();
    void singleRows();
    void countIsReportedWhenItChanges();
    void persistentIndexesFollowTheirRows();
    void moreRowsAreRequestedWhileThereAreMore();
    void random();
};

void RowModelTest::steps_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    QTest::addColumn<QString>("log");
    QTest::newRow("empty") << ""
                           << ""
                           << "";
    QTest::newRow("the same") << "a1bc"
                              << "a1bc"
                              << "";
    QTest::newRow("from empty") << ""
                                << "abc"
                                << "+3 ";
    QTest::newRow("to empty") << "abc"
                              << ""
                              << "-3 ";
    QTest::newRow("inserted at both ends and between") << "bd"
                                                       << "abcde"
                                                       << "+1 +1 +1 ";
    QTest::newRow("neighbors inserted together") << "ad"
                                                 << "abcd"
                                                 << "+2 ";
    QTest::newRow("removed in two places") << "abcdef"
                                           << "cf"
                                           << "-2 -2 ";
    QTest::newRow("moved to the end") << "abcde"
                                      << "bcdea"
                                      << ">1 ";
    QTest::newRow("moved to the front") << "abcde"
                                        << "eabcd"
                                        << ">1 ";
    QTest::newRow("reversed") << "abcd"
                              << "dcba"
                              << ">1 >1 >1 ";
    QTest::newRow("changed in two places") << "abcde"
                                           << "a1b2cde3"
                                           << "=2 =1 ";
    QTest::newRow("moved and changed") << "abc"
                                       << "c1ab"
                                       << ">1 =1 ";
    QTest::newRow("another list") << "abc"
                                  << "xyz"
                                  << "-3 +3 ";
    QTest::newRow("duplicates stay") << "aab"
                                     << "aab"
                                     << "";
    QTest::newRow("one of the duplicates less") << "a1a2a3"
                                                << "a1a2"
                                                << "-1 ";
    QTest::newRow("one of the duplicates more") << "a1b"
                                                << "a1a2b"
                                                << "+1 ";
    QTest::newRow("everything at once") << "abcd"
                                        << "d1xb"
                                        << "-1 -1 >1 +1 =1 ";
}

void RowModelTest::steps()
{
    QFETCH(const QString, before);
    QFETCH(const QString, after);
    QFETCH(const QString, log);
    Letters model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setRows(lettersOf(before));
    View view(model);
    model.setRows(lettersOf(after));
    QCOMPARE(view.log, log);
    QCOMPARE(textOf(model), after);
    QCOMPARE(view.rows(), lettersOf(after));
    QCOMPARE(view.resets, 0);
}

void RowModelTest::rolesAreTheProperties()
{
    Letters model;
    model.setRows({{QStringLiteral("a"), 7}});
    const auto roles = model.roleNames();
    QCOMPARE(roles.size(), 3);
    const QModelIndex first = model.index(0);
    QCOMPARE(model.data(first, roles.key("name")), QVariant(QStringLiteral("a")));
    QCOMPARE(model.data(first, roles.key("value")), QVariant(7));
    QCOMPARE(model.data(first, roles.key("text")), QVariant(QStringLiteral("a7")));
    QVERIFY(!model.data(first, Qt::DisplayRole).isValid());
}

void RowModelTest::singleRows()
{
    Letters model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    View view(model);
    model.append(lettersOf(QStringLiteral("bc")));
    model.insert(0, lettersOf(QStringLiteral("a")));
    model.append({});
    model.setRow(1, {QStringLiteral("b"), 5});
    model.remove(2, 1);
    model.remove(0, 0);
    QCOMPARE(textOf(model), QStringLiteral("ab5"));
    QCOMPARE(model.row(1).value, 5);
    QCOMPARE(view.log, QStringLiteral("+2 +1 =1 -1 "));
    model.refresh();
    QCOMPARE(view.log, QStringLiteral("+2 +1 =1 -1 =2 "));
    model.clear();
    model.refresh();
    model.clear();
    QCOMPARE(view.log, QStringLiteral("+2 +1 =1 -1 =2 -2 "));
    QVERIFY(view.rows().isEmpty());
}

void RowModelTest::countIsReportedWhenItChanges()
{
    Letters model;
    const QSignalSpy counts(&model, &Letters::countChanged);
    model.setRows(lettersOf(QStringLiteral("abc")));
    QCOMPARE(counts.size(), 1);
    model.setRows(lettersOf(QStringLiteral("xyz")));
    QCOMPARE(counts.size(), 1);
    model.setRows(lettersOf(QStringLiteral("yz")));
    QCOMPARE(counts.size(), 2);
    QCOMPARE(model.property("count").toInt(), 2);
    model.append(lettersOf(QStringLiteral("a")));
    model.clear();
    QCOMPARE(counts.size(), 4);
}

void RowModelTest::persistentIndexesFollowTheirRows()
{
    Letters model;
    model.setRows(lettersOf(QStringLiteral("abcd")));
    const QPersistentModelIndex selected(model.index(2));
    model.setRows(lettersOf(QStringLiteral("xc1ba")));
    QCOMPARE(selected.row(), 1);
    model.setRows(lettersOf(QStringLiteral("ba")));
    QVERIFY(!selected.isValid());
}

void RowModelTest::moreRowsAreRequestedWhileThereAreMore()
{
    Letters model;
    const QSignalSpy requests(&model, &Letters::moreRequested);
    QVERIFY(!model.canFetchMore({}));
    model.fetchMore({});
    QCOMPARE(requests.size(), 0);
    model.setHasMore(true);
    QVERIFY(model.canFetchMore({}));
    model.fetchMore({});
    QCOMPARE(requests.size(), 1);
}

// Returns the length of the longest ascending subsequence by the plain method.
int longestAscending(const std::vector<int>& values)
{
    std::vector<int> lengths;
    for (std::size_t at = 0; at < values.size(); ++at) {
        int length = 1;
        for (std::size_t i = 0; i < at; ++i) {
            if (values[i] < values[at])
                length = std::max(length, lengths[i] + 1);
        }
        lengths.push_back(length);
    }
    return lengths.empty() ? 0 : std::ranges::max(lengths);
}

void RowModelTest::random()
{
    constexpr unsigned seed = 18;
    std::mt19937 random(seed);
    const auto below = [&random](int count) {
        return static_cast<int>(random() % static_cast<unsigned>(count));
    };
    for (int sequence = 0; sequence < 1000; ++sequence) {
        Letters model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        View view(model);
        const int letters = 1 + below(12); // few: many duplicates
        for (int list = 0; list < 8; ++list) {
            QList<Letter> rows;
            for (int count = below(15); count > 0; --count)
                rows << Letter{QChar(u'a' + below(letters)), below(3)};
            model.setRows(rows);
            const auto where = [&] {
                return qPrintable(QStringLiteral("seed %1, sequence %2").arg(seed).arg(sequence));
            };
            QVERIFY2(model.rows() == rows && view.rows() == rows && view.resets == 0, where());
        }
        // The fewest moves: all rows that are not in the longest ascending subsequence.
        std::vector<int> targets(static_cast<std::size_t>(1 + below(20)));
        std::iota(targets.begin(), targets.end(), 0);
        std::ranges::shuffle(targets, random);
        const int count = static_cast<int>(targets.size());
        QCOMPARE(static_cast<int>(rowSteps(targets, count).size()), count - longestAscending(targets));
    }
}

CAMPANEL_TEST(RowModelTest)

} // namespace test_row_model

#include "test_row_model.moc"
