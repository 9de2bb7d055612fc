// SPDX-License-Identifier: Apache-2.0
// The filter of a list of records, as a person sets it: a span of local time, an id and a word. Every change
// applies at once.
#pragma once

#include "app/store/logs/log_filter.h"

#include <QDateTime>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <utility>

namespace campanel::panel {

class LogFilterEditor : public QObject {
    Q_OBJECT
    QML_NAMED_ELEMENT(LogFilter)
    QML_UNCREATABLE("Filters belong to their lists")
    Q_PROPERTY(bool active READ active NOTIFY changed FINAL)
    // The filter in one line; empty without one.
    Q_PROPERTY(QString summary READ summary NOTIFY changed FINAL)
    // The limits as local time; empty: no limit.
    Q_PROPERTY(QString fromText READ fromText NOTIFY changed FINAL)
    Q_PROPERTY(QString toText READ toText NOTIFY changed FINAL)
    Q_PROPERTY(QString id READ id WRITE setId NOTIFY changed FINAL)
    Q_PROPERTY(QString word READ word WRITE setWord NOTIFY changed FINAL)

public:
    enum Limit { From, To };
    Q_ENUM(Limit)

    static constexpr int maxTextLength = 40;

    explicit LogFilterEditor(QObject* parent);

    void setWallClock(std::function<QDateTime()> clock) { m_wallClock = std::move(clock); }

    // Moves a limit; whole days keep the time of day. A missing limit starts at the begin or the end of
    // today. The other limit follows, so that the span is not empty.
    Q_INVOKABLE void move(campanel::panel::LogFilterEditor::Limit limit, int minutes);
    Q_INVOKABLE void removeLimit(campanel::panel::LogFilterEditor::Limit limit);
    // Sets the span to the day of that limit, or to today.
    Q_INVOKABLE void showDay(campanel::panel::LogFilterEditor::Limit limit);
    Q_INVOKABLE void clear();

    // Returns the filter without the keys of its word.
    [[nodiscard]] const store::LogFilter& filter() const { return m_filter; }
    [[nodiscard]] bool active() const { return m_filter.isActive(); }
    [[nodiscard]] QString summary() const;
    [[nodiscard]] QString fromText() const;
    [[nodiscard]] QString toText() const;
    [[nodiscard]] const QString& id() const { return m_filter.id; }
    void setId(const QString& id);
    [[nodiscard]] const QString& word() const { return m_filter.word; }
    void setWord(const QString& word);

signals:
    void changed();

private:
    void apply(const store::LogFilter& filter);
    [[nodiscard]] QDateTime moment(Limit limit) const;

    store::LogFilter m_filter;
    std::function<QDateTime()> m_wallClock;
};

} // namespace campanel::panel
