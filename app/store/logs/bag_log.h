// SPDX-License-Identifier: Apache-2.0
// The log of bags, the ten million that were written last. Call it in the thread of the database.
#pragma once

#include "app/store/database/clock_mark.h"

#include <QList>
#include <QString>

#include <functional>
#include <limits>
#include <optional>

namespace campanel::store {

struct Bag {
    // ClockNotSet: recorded while the clock was not set; see clock_mark.h.
    enum Flag : quint8 { Tracked = 1, MarkMissed = 2, ProductAcross = 4, Empty = 8, ClockNotSet = 16 };

    qint64 timeMs = 0;   // since 1970 UTC
    QString programName; // as stored in the controller
    int programVersion = 0;
    double setLengthMm = 0;                   // one bag length
    int lengths = 1;                          // bag lengths in it: skipped cuts + 1
    double deviationMm = 0;                   // length minus `lengths` set lengths
    std::optional<double> markErrorMm{};      // mark error of its cut; none: it followed no mark
    std::optional<double> followingErrorMm{}; // maximum of the knife since the previous bag, signed
    std::optional<double> rateBagsPerMin{};
    quint8 flags = 0;
    ClockState clock = ClockState::Unproven; // at `timeMs`; only of a bag to be added

    [[nodiscard]] double lengthMm() const { return lengths * setLengthMm + deviationMm; }
    bool operator==(const Bag&) const = default;
};

class Ring;

class BagLog {
public:
    static constexpr qint64 bagsKept = 10'000'000;

    // Keeps at most `kept` bags.
    explicit BagLog(Database& database, qint64 kept = bagsKept)
        : m_database(database)
        , m_kept(kept)
    {
    }

    // Adds bags; call it in a transaction. A bag whose time is taken is stored at the next free millisecond.
    // A bag whose time cannot be right is marked.
    [[nodiscard]] tl::expected<void, StoreError> add(const QList<Bag>& bags);
    [[nodiscard]] tl::expected<qint64, StoreError> count();
    // Counts the bags from `fromMs` to before `toMs`, but not further than `maxRows`.
    [[nodiscard]] tl::expected<qint64, StoreError> countBetween(qint64 fromMs, qint64 toMs, qint64 maxRows);
    // Returns true when a bag from `fromMs` to before `toMs`, or of the minute around, was recorded while the
    // clock was not set.
    [[nodiscard]] tl::expected<bool, StoreError> hasClockNotSet(qint64 fromMs, qint64 toMs);
    // Calls `take` for each bag, oldest first.
    [[nodiscard]] tl::expected<void, StoreError> forEach(qint64 fromMs, qint64 toMs,
                                                         const std::function<void(const Bag&)>& take);

private:
    // Returns the time of the newest bag outside the spans of marked ones; 0: none.
    [[nodiscard]] tl::expected<qint64, StoreError> newestMs();
    // Notes the time of a marked bag in its span.
    [[nodiscard]] tl::expected<void, StoreError> noteUnset(qint64 timeMs);
    // Marks the bags later than `timeMs`: the clock ran ahead.
    [[nodiscard]] tl::expected<void, StoreError> markLater(qint64 timeMs);
    [[nodiscard]] tl::expected<qint64, StoreError> programOf(const Bag& bag);
    // Inserts a bag at `timeMs` or the next free millisecond, which it returns.
    [[nodiscard]] tl::expected<qint64, StoreError> insert(const Bag& bag, qint64 program, qint64 timeMs,
                                                          Ring& ring);
    [[nodiscard]] tl::expected<void, StoreError> forgetProgramsAndSpans();

    Database& m_database;
    qint64 m_kept;
};

} // namespace campanel::store
