// SPDX-License-Identifier: Apache-2.0
// A list for QML whose rows are values of a Q_GADGET; its properties are the roles. A new list is compared
// with the present one by key: rows are removed, moved, inserted and changed, never reset, so that delegates,
// scroll position and selection stay.
#pragma once

#include <QAbstractListModel>
#include <QHash>
#include <QList>
#include <QtQml/qqmlregistration.h>

#include <algorithm>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace campanel::panel {

struct RowStep {
    enum class Kind { Remove, Move, Insert };
    Kind kind;
    int first; // before the step; for Insert also the row of the new list
    int count; // 1 for Move
    int to;    // row after a Move
};

// Returns the fewest steps to the new list of `count` rows. `targets` has the new row of each present row, -1
// if it is removed.
[[nodiscard]] std::vector<RowStep> rowSteps(std::vector<int> targets, int count);

class RowModelBase : public QAbstractListModel {
    Q_OBJECT
    QML_NAMED_ELEMENT(RowModel)
    QML_UNCREATABLE("Rows belong to the object that provides them")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    [[nodiscard]] int count() const { return rowCount(); }
    // Updates the texts that the rows create on demand, as after a change of the language.
    void refresh();
    // Lets the view request more rows at the end of the list.
    void setHasMore(bool hasMore) { m_hasMore = hasMore; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

signals:
    void countChanged();
    void moreRequested();

protected:
    RowModelBase(const QMetaObject& gadget, QObject* parent);

    [[nodiscard]] virtual const void* gadget(int row) const = 0;

private:
    const QMetaObject& m_gadget;
    bool m_hasMore = false;
};

// `key` identifies a row: a member, or a function without arguments. Rows with equal keys are told apart by
// their order.
template <class Row, auto key> class RowModel final : public RowModelBase {
public:
    explicit RowModel(QObject* parent = nullptr)
        : RowModelBase(Row::staticMetaObject, parent)
    {
    }

    [[nodiscard]] const QList<Row>& rows() const { return m_rows; }
    [[nodiscard]] const Row& row(int at) const { return m_rows[at]; }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
    }

    void setRows(const QList<Row>& rows)
    {
        const int before = count();
        for (const RowStep& step : rowSteps(targets(rows), static_cast<int>(rows.size())))
            apply(step, rows);
        for (int first = 0; first < count(); ++first) {
            int end = first;
            for (; end < count() && !(m_rows[end] == rows[end]); ++end)
                m_rows[end] = rows[end];
            if (end > first)
                emit dataChanged(index(first), index(end - 1));
            first = end;
        }
        if (count() != before)
            emit countChanged();
    }

    void setRow(int at, const Row& row)
    {
        m_rows[at] = row;
        emit dataChanged(index(at), index(at));
    }

    void insert(int at, const QList<Row>& rows)
    {
        if (rows.isEmpty())
            return;
        insertFrom(at, rows);
        emit countChanged();
    }
    void append(const QList<Row>& rows) { insert(count(), rows); }

    void remove(int first, int count)
    {
        if (count <= 0)
            return;
        apply({RowStep::Kind::Remove, first, count, 0}, {});
        emit countChanged();
    }
    void clear() { remove(0, count()); }

private:
    [[nodiscard]] const void* gadget(int row) const override { return &m_rows[row]; }

    // Pairs each present row with the first unpaired new one of its key.
    [[nodiscard]] std::vector<int> targets(const QList<Row>& rows) const
    {
        QHash<std::decay_t<std::invoke_result_t<decltype(key), const Row&>>, std::vector<int>> places;
        for (auto at = static_cast<int>(rows.size()) - 1; at >= 0; --at)
            places[std::invoke(key, rows[at])].push_back(at);
        std::vector<int> targets;
        for (const Row& row : m_rows) {
            const auto found = places.find(std::invoke(key, row));
            const bool isKept = found != places.end() && !found->empty();
            targets.push_back(isKept ? found->back() : -1);
            if (isKept)
                found->pop_back();
        }
        return targets;
    }

    void apply(const RowStep& step, const QList<Row>& rows)
    {
        const int last = step.first + step.count - 1;
        switch (step.kind) {
        case RowStep::Kind::Remove:
            beginRemoveRows({}, step.first, last);
            m_rows.remove(step.first, step.count);
            endRemoveRows();
            break;
        case RowStep::Kind::Move:
            beginMoveRows({}, step.first, step.first, {}, step.to > step.first ? step.to + 1 : step.to);
            m_rows.move(step.first, step.to);
            endMoveRows();
            break;
        case RowStep::Kind::Insert:
            insertFrom(step.first, rows.mid(step.first, step.count));
            break;
        }
    }

    void insertFrom(int at, const QList<Row>& rows)
    {
        beginInsertRows({}, at, at + static_cast<int>(rows.size()) - 1);
        m_rows.insert(at, rows.size(), Row());
        std::ranges::copy(rows, m_rows.begin() + at);
        endInsertRows();
    }

    QList<Row> m_rows;
};

} // namespace campanel::panel
