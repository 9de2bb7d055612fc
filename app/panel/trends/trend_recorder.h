// SPDX-License-Identifier: Apache-2.0
// Collects the controller's data - bags, mark errors, following errors, rate, answer times - in one bucket
// per second and quantity until take() fetches them.
#pragma once

#include "app/link/link_values.h"
#include "app/store/logs/bag_log.h"
#include "app/store/logs/trend_log.h"

#include <QObject>

#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace campanel::panel {

class Controller;
class DatabaseService;
class Settings;

class TrendRecorder : public QObject {
    Q_OBJECT

public:
    struct Batch {
        QList<store::Bag> bags;
        QList<store::TrendPart> parts;

        [[nodiscard]] bool isEmpty() const { return bags.isEmpty() && parts.isEmpty(); }
    };
    // Milliseconds since 1970 UTC.
    using WallClock = std::function<qint64()>;

    // All arguments must outlive the object.
    TrendRecorder(Controller& controller, Settings& settings, DatabaseService& records);

    void setWallClock(WallClock clock) { m_clock = std::move(clock); }
    void addResidue(double percent);
    // Returns the data since the last call. Data older than ten minutes is dropped.
    [[nodiscard]] Batch take();

private:
    void takeStatus(const link::StatusBatch& batch);
    void takeBag(const modbus::BagRecord& bag);
    // Adds a bag of a controller that does not record its bags.
    void noteBag(const modbus::StatusBlock& status);
    void noteMotion(const modbus::StatusBlock& status, qint64 nowMs);
    void add(store::Bag bag);
    void add(store::TrendQuantity quantity, qint64 nowMs, double value, bool isWithin = true);

    Controller& m_controller;
    Settings& m_settings;
    DatabaseService& m_records;
    WallClock m_clock;
    QList<store::Bag> m_bags;
    std::map<std::pair<qint64, store::TrendQuantity>, store::TrendBucket> m_parts;
    std::optional<double> m_worstFollowingMm; // since the last bag
    std::optional<std::uint32_t> m_bagCount;
    bool m_isNextOfTwoPrograms = false; // begun under another program: its deviation does not count
};

} // namespace campanel::panel
