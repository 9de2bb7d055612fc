// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/frame_list.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/frame_words.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

FrameList::FrameList(link::Link& link, ReportFiles& files, QObject* parent)
    : QAbstractListModel(parent)
    , m_link(link)
    , m_files(files)
    , m_moment(std::chrono::steady_clock::now())
    , m_timeOfDay(QDateTime::currentDateTime())
{
    connect(&link, &link::Link::framesRecorded, this, &FrameList::takeFrames);
    LanguageNotifier::follow(this, [this] {
        if (count() > 0)
            emit dataChanged(index(0), index(count() - 1));
    });
}

void FrameList::setTimeOfDay(link::SteadyTime moment, const QDateTime& timeOfDay)
{
    m_moment = moment;
    m_timeOfDay = timeOfDay;
}

void FrameList::setWatched(bool isWatched)
{
    if (m_isWatched == isWatched)
        return;
    m_isWatched = isWatched;
    watchNow();
}

void FrameList::setPaused(bool isPaused)
{
    if (m_isPaused == isPaused)
        return;
    m_isPaused = isPaused;
    watchNow();
}

void FrameList::watchNow()
{
    // The first report contains all frames that the link still has, also the missed ones.
    m_link.watchFrames((m_isWatched && !m_isPaused) || m_readers > 0);
    emit changed();
}

void FrameList::readOnce(QObject* context, const std::function<void(const QList<modbus::FrameRecord>&)>& take)
{
    ++m_readers;
    connect(
        &m_link, &link::Link::framesRecorded, context,
        [this, take](const QList<modbus::FrameRecord>& frames) {
            if (--m_readers == 0 && !(m_isWatched && !m_isPaused))
                m_link.watchFrames(false);
            take(frames);
        },
        Qt::SingleShotConnection);
    m_link.watchFrames(true);
}

void FrameList::setFilter(Filter filter)
{
    if (m_filter == filter)
        return;
    m_filter = filter;
    rebuild();
    emit changed();
}

void FrameList::clear()
{
    m_ring.clear();
    rebuild();
}

bool FrameList::passes(const Entry& entry) const
{
    switch (m_filter) {
    case Filter::All:
        return true;
    case Filter::Errors:
        return entry.isError;
    case Filter::Commands:
        return entry.isCommand;
    case Filter::Writes:
        return entry.isWrite;
    }
    return true;
}

FrameList::Entry FrameList::entryOf(const modbus::FrameRecord& record)
{
    static const quint16 commands = modbus::findSpan("command.counter")->address;
    static const quint16 transfers = modbus::findSpan("transfer.session")->address;
    constexpr int writeMultiple = 16;
    if (record.isSent()) {
        const modbus::DecodedFrame frame = modbus::decodeFrame(record);
        m_isCommandOpen = frame.written && frame.written->address == commands;
        m_isWriteOpen =
            frame.written && (frame.written->address == transfers || frame.function == writeMultiple);
    }
    return {record, m_isCommandOpen, m_isWriteOpen,
            !record.isSent() && record.verdict != modbus::FrameVerdict::Answer};
}

void FrameList::takeFrames(const QList<modbus::FrameRecord>& frames)
{
    if (!m_isWatched || m_isPaused)
        return;
    std::deque<quint64> added;
    for (const modbus::FrameRecord& record : frames) {
        if (record.number <= m_lastNumber)
            continue;
        m_lastNumber = record.number;
        Entry entry = entryOf(record);
        // The question before an error belongs to it.
        if (entry.isError && !m_ring.empty() && m_ring.back().record.isSent()) {
            Entry& question = m_ring.back();
            question.isError = true;
            if (m_filter == Filter::Errors)
                added.push_back(question.record.number);
        }
        if (passes(entry))
            added.push_back(record.number);
        m_ring.push_back(std::move(entry));
    }
    append(added);
    makeRoom();
}

void FrameList::append(const std::deque<quint64>& numbers)
{
    if (numbers.empty())
        return;
    const int first = count();
    beginInsertRows({}, first, first + static_cast<int>(numbers.size()) - 1);
    m_shown.insert(m_shown.end(), numbers.begin(), numbers.end());
    endInsertRows();
    emit countChanged();
}

void FrameList::makeRoom()
{
    if (m_ring.size() <= capacity)
        return;
    m_ring.erase(m_ring.begin(), m_ring.end() - static_cast<std::ptrdiff_t>(capacity));
    const int gone = rowFrom(m_ring.front().record.number);
    if (gone == 0)
        return;
    beginRemoveRows({}, 0, gone - 1);
    m_shown.erase(m_shown.begin(), m_shown.begin() + gone);
    endRemoveRows();
    emit countChanged();
}

void FrameList::rebuild()
{
    beginResetModel();
    m_shown.clear();
    for (const Entry& entry : m_ring) {
        if (passes(entry))
            m_shown.push_back(entry.record.number);
    }
    endResetModel();
    emit countChanged();
}

const FrameList::Entry* FrameList::entryWith(quint64 number) const
{
    const auto numberOf = [](const Entry& entry) { return entry.record.number; };
    const auto found = std::ranges::lower_bound(m_ring, number, {}, numberOf);
    return found != m_ring.end() && found->record.number == number ? &*found : nullptr;
}

int FrameList::rowFrom(quint64 number) const
{
    return static_cast<int>(std::ranges::lower_bound(m_shown, number) - m_shown.begin());
}

void FrameList::showDetail(int row)
{
    if (row < 0 || row >= count())
        return;
    m_detail = entryWith(m_shown[static_cast<std::size_t>(row)])->record;
    emit detailChanged();
}

bool FrameList::hasPrevious() const
{
    return m_detail && rowFrom(m_detail->number) > 0;
}

bool FrameList::hasNext() const
{
    return m_detail && rowFrom(m_detail->number + 1) < count();
}

void FrameList::showPrevious()
{
    if (hasPrevious())
        showDetail(rowFrom(m_detail->number) - 1);
}

void FrameList::showNext()
{
    if (hasNext())
        showDetail(rowFrom(m_detail->number + 1));
}

QString FrameList::timeText(const modbus::FrameRecord& record) const
{
    const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(record.at - m_moment);
    return m_timeOfDay.addMSecs(since.count()).toString(u"HH:mm:ss.zzz"_s);
}

QString FrameList::detailTitle() const
{
    if (!m_detail)
        return {};
    return m_detail->isSent() ? tr("Sent at %1").arg(timeText(*m_detail))
                              : tr("Received at %1").arg(timeText(*m_detail));
}

QStringList FrameList::detailLines() const
{
    return m_detail ? FrameWords::details(*m_detail) : QStringList();
}

QString FrameList::detailBytes() const
{
    return m_detail ? FrameWords::bytes(*m_detail) : QString();
}

void FrameList::exportText()
{
    std::vector<modbus::FrameRecord> records;
    for (const quint64 number : m_shown)
        records.push_back(entryWith(number)->record);
    m_files.offer({{tr("link frames"), u"txt"_s, [records = std::move(records)] {
                        return QByteArray::fromStdString(modbus::framesText(records));
                    }}});
}

int FrameList::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant FrameList::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Entry* entry = entryWith(m_shown[static_cast<std::size_t>(index.row())]);
    if (!entry)
        return {};
    switch (role) {
    case TimeRole:
        return timeText(entry->record);
    case SentRole:
        return entry->record.isSent();
    case WordsRole:
        return FrameWords::line(entry->record);
    case ErrorRole:
        return entry->isError && !entry->record.isSent();
    default:
        return {};
    }
}

QHash<int, QByteArray> FrameList::roleNames() const
{
    return {{TimeRole, "time"}, {SentRole, "sent"}, {WordsRole, "words"}, {ErrorRole, "error"}};
}

} // namespace campanel::panel
