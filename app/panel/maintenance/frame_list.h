// SPDX-License-Identifier: Apache-2.0
// The last frames of the line as a list, newest last, filtered by purpose. The size is limited to that of the
// link's own ring; nothing is read while the list is not watched.
#pragma once

#include "app/link/link.h"
#include "app/panel/kit/report_files.h"

#include <QAbstractListModel>
#include <QDateTime>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <deque>
#include <functional>
#include <optional>

namespace campanel::panel {

class FrameList : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The frames belong to Maintenance")
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY changed FINAL)
    // True while the list is paused. Frames that pass meanwhile are read afterwards, as far as the link still
    // has them.
    Q_PROPERTY(bool paused READ paused WRITE setPaused NOTIFY changed FINAL)
    Q_PROPERTY(Filter filter READ filter WRITE setFilter NOTIFY changed FINAL)
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)
    // The selected frame: time and number, then all its values, then its bytes.
    Q_PROPERTY(QString detailTitle READ detailTitle NOTIFY detailChanged FINAL)
    Q_PROPERTY(QStringList detailLines READ detailLines NOTIFY detailChanged FINAL)
    Q_PROPERTY(QString detailBytes READ detailBytes NOTIFY detailChanged FINAL)
    Q_PROPERTY(bool hasPrevious READ hasPrevious NOTIFY detailChanged FINAL)
    Q_PROPERTY(bool hasNext READ hasNext NOTIFY detailChanged FINAL)

public:
    enum class Filter { All, Errors, Commands, Writes };
    Q_ENUM(Filter)
    enum Role { TimeRole = Qt::UserRole + 1, SentRole, WordsRole, ErrorRole };

    static constexpr std::size_t capacity = 2048;

    // Both arguments must outlive the object.
    FrameList(link::Link& link, ReportFiles& files, QObject* parent);

    // Calls `take` with all frames that the link still has, at the latest with its next frame, also when the
    // list is not watched. The call ends with `context`.
    void readOnce(QObject* context, const std::function<void(const QList<modbus::FrameRecord>&)>& take);

    // Sets the time of day of a moment of the link's clock, for tests and captures; the default is now.
    void setTimeOfDay(link::SteadyTime moment, const QDateTime& timeOfDay);

    [[nodiscard]] bool watched() const { return m_isWatched; }
    void setWatched(bool isWatched);
    [[nodiscard]] bool paused() const { return m_isPaused; }
    void setPaused(bool isPaused);
    [[nodiscard]] Filter filter() const { return m_filter; }
    void setFilter(Filter filter);
    [[nodiscard]] int count() const { return static_cast<int>(m_shown.size()); }
    [[nodiscard]] QString detailTitle() const;
    [[nodiscard]] QStringList detailLines() const;
    [[nodiscard]] QString detailBytes() const;
    [[nodiscard]] bool hasPrevious() const;
    [[nodiscard]] bool hasNext() const;

    Q_INVOKABLE void clear();
    Q_INVOKABLE void showDetail(int row);
    Q_INVOKABLE void showPrevious();
    Q_INVOKABLE void showNext();
    // Offers the filtered frames as a text file.
    Q_INVOKABLE void exportText();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void changed();
    void countChanged();
    void detailChanged();

private:
    struct Entry {
        modbus::FrameRecord record;
        bool isCommand = false; // a command or its answer
        bool isWrite = false;
        bool isError = false; // an error or the question that failed
    };

    void watchNow();
    void takeFrames(const QList<modbus::FrameRecord>& frames);
    [[nodiscard]] Entry entryOf(const modbus::FrameRecord& record);
    [[nodiscard]] bool passes(const Entry& entry) const;
    void makeRoom();
    void append(const std::deque<quint64>& numbers);
    void rebuild();
    [[nodiscard]] const Entry* entryWith(quint64 number) const; // null when it was dropped
    // Returns the row of the first visible frame with this number or a higher one.
    [[nodiscard]] int rowFrom(quint64 number) const;
    [[nodiscard]] QString timeText(const modbus::FrameRecord& record) const;

    link::Link& m_link;
    ReportFiles& m_files;
    std::deque<Entry> m_ring;     // ascending numbers
    std::deque<quint64> m_shown;  // those of them that match the filter
    quint64 m_lastNumber = 0;     // last received, also before a clear
    bool m_isCommandOpen = false; // type of the last question
    bool m_isWriteOpen = false;
    std::optional<modbus::FrameRecord> m_detail;
    link::SteadyTime m_moment;
    QDateTime m_timeOfDay; // at that moment
    Filter m_filter = Filter::All;
    bool m_isWatched = false;
    int m_readers = 0; // pending readOnce() calls
    bool m_isPaused = false;
};

} // namespace campanel::panel
