// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/row_model.h"

#include "app/panel/kit/language_notifier.h"

#include <QMetaProperty>

#include <cstddef>

namespace campanel::panel {

namespace {

constexpr int firstRole = Qt::UserRole + 1;

// Returns the values that are not in the longest ascending subsequence, ascending.
std::vector<int> outOfOrder(const std::vector<int>& values)
{
    std::vector<std::size_t>
        ends; // the place of the smallest end of an ascending subsequence, for each length
    std::vector<std::size_t> previous(values.size());
    for (std::size_t at = 0; at < values.size(); ++at) {
        const auto end =
            std::ranges::lower_bound(ends, values[at], {}, [&](std::size_t i) { return values[i]; });
        if (end != ends.begin())
            previous[at] = *(end - 1);
        if (end == ends.end())
            ends.push_back(at);
        else
            *end = at;
    }
    std::vector<int> rest = values;
    for (std::size_t length = ends.size(), at = length > 0 ? ends.back() : 0; length > 0;
         --length, at = previous[at])
        rest[at] = -1;
    std::erase(rest, -1);
    std::ranges::sort(rest);
    return rest;
}

} // namespace

std::vector<RowStep> rowSteps(std::vector<int> targets, int count)
{
    std::vector<RowStep> steps;
    for (auto at = static_cast<int>(targets.size()) - 1; at >= 0; --at) {
        if (targets[static_cast<std::size_t>(at)] >= 0)
            continue;
        if (steps.empty() || steps.back().first != at + 1)
            steps.push_back({RowStep::Kind::Remove, at + 1, 0, 0});
        --steps.back().first;
        ++steps.back().count;
    }
    std::erase(targets, -1);
    for (const int target : outOfOrder(targets)) {
        // All smaller ones are in order: it belongs behind the largest of them.
        auto behind = targets.begin();
        for (auto other = targets.begin(); other != targets.end(); ++other) {
            if (*other < target && (behind == targets.begin() || *other > *(behind - 1)))
                behind = other + 1;
        }
        const auto from = std::ranges::find(targets, target);
        const auto first = static_cast<int>(from - targets.begin());
        if (from < behind)
            std::rotate(from, from + 1, behind);
        else
            std::rotate(behind, from, from + 1);
        const auto to = static_cast<int>(std::ranges::find(targets, target) - targets.begin());
        if (to != first)
            steps.push_back({RowStep::Kind::Move, first, 1, to});
    }
    targets.push_back(count);
    int at = 0;
    for (const int kept : targets) {
        if (kept > at)
            steps.push_back({RowStep::Kind::Insert, at, kept - at, 0});
        at = kept + 1;
    }
    return steps;
}

RowModelBase::RowModelBase(const QMetaObject& gadget, QObject* parent)
    : QAbstractListModel(parent)
    , m_gadget(gadget)
{
    LanguageNotifier::follow(this, &RowModelBase::refresh);
}

void RowModelBase::refresh()
{
    if (count() > 0)
        emit dataChanged(index(0), index(count() - 1));
}

QVariant RowModelBase::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role < firstRole)
        return {};
    return m_gadget.property(role - firstRole).readOnGadget(gadget(index.row()));
}

QHash<int, QByteArray> RowModelBase::roleNames() const
{
    QHash<int, QByteArray> names;
    for (int i = 0; i < m_gadget.propertyCount(); ++i)
        names.insert(firstRole + i, m_gadget.property(i).name());
    return names;
}

bool RowModelBase::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && m_hasMore;
}

void RowModelBase::fetchMore(const QModelIndex& parent)
{
    if (canFetchMore(parent))
        emit moreRequested();
}

} // namespace campanel::panel
