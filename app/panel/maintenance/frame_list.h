// SPDX-License-Identifier: Apache-2.0
// The last frames of the line as a list, the newest last, filtered by what they are for. A ring: it never
// grows beyond what the link itself keeps, and nothing comes while nobody looks.
#pragma once

#include "app/link/link.h"
#include "app/panel/kit/report_files.h"

#include <QAbstractListModel>
#include <QDateTime>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <deque>
#include <optional>

namespace campanel::machine {

class FrameList : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The frames belong to the Service")
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY changed FINAL)
    // Stands still; what passes meanwhile is fetched afterwards, as far as the link still knows it.
    Q_PROPERTY(bool paused READ paused WRITE setPaused NOTIFY changed FINAL)
    Q_PROPERTY(Filter filter READ filter WRITE setFilter NOTIFY changed FINAL)
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)
    // The frame that was tapped: when and which, then all its values, then its bytes.
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

    // Both must outlive it.
    FrameList(link::Link& link, ReportFiles& files, QObject* parent);

    // Which time of day a moment of the link's clock is, for tests and captures; now is now by default.
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
    // Offers the frames that the filter shows as a text file.
    Q_INVOKABLE void exportText();

    void retranslate();

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
        bool isCommand = false; // or the answer to one
        bool isWrite = false;
        bool isError = false; // or the question that met one
    };

    void watchNow();
    void takeFrames(const QList<modbus::FrameRecord>& frames);
    [[nodiscard]] Entry entryOf(const modbus::FrameRecord& record);
    [[nodiscard]] bool passes(const Entry& entry) const;
    void makeRoom();
    void append(const std::deque<quint64>& numbers);
    void rebuild();
    [[nodiscard]] const Entry* entryWith(quint64 number) const; // null when it is gone
    // Row of the first shown frame with this number or a higher one.
    [[nodiscard]] int rowFrom(quint64 number) const;
    [[nodiscard]] QString timeText(const modbus::FrameRecord& record) const;

    link::Link& m_link;
    ReportFiles& m_files;
    std::deque<Entry> m_ring;     // ascending numbers
    std::deque<quint64> m_shown;  // those of them that pass
    quint64 m_lastNumber = 0;     // seen, also when it was cleared
    bool m_isCommandOpen = false; // what the last question was
    bool m_isWriteOpen = false;
    std::optional<modbus::FrameRecord> m_detail;
    link::SteadyTime m_moment;
    QDateTime m_timeOfDay; // at that moment
    Filter m_filter = Filter::All;
    bool m_isWatched = false;
    bool m_isPaused = false;
};

} // namespace campanel::machine
