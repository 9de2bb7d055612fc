// SPDX-License-Identifier: Apache-2.0
// Every bag as it was cut, the newest ten million of them. In the thread of the database.
#pragma once

#include "app/store/database/database.h"

#include <QList>
#include <QString>

#include <functional>
#include <limits>
#include <optional>

namespace campanel::store {

struct Bag {
    enum Flag : quint8 { Tracked = 1, MarkMissed = 2, ProductAcross = 4, Empty = 8 };

    qint64 timeMs = 0;   // since 1970 UTC
    QString programName; // as the controller has it
    int programVersion = 0;
    double setLengthMm = 0;                   // of one length
    int lengths = 1;                          // bag lengths in it: cuts left out + 1
    double deviationMm = 0;                   // of its length from so many set lengths
    std::optional<double> markErrorMm{};      // of its cut; none: it followed no mark
    std::optional<double> followingErrorMm{}; // largest of the knife since the bag before, signed
    std::optional<double> rateBagsPerMin{};
    quint8 flags = 0;

    [[nodiscard]] double lengthMm() const { return lengths * setLengthMm + deviationMm; }
    bool operator==(const Bag&) const = default;
};

class BagLog {
public:
    static constexpr qint64 bagsKept = 10'000'000;

    // `kept` at most are kept.
    explicit BagLog(Database& database, qint64 kept = bagsKept)
        : m_database(database)
        , m_kept(kept)
    {
    }

    // To be called in a transaction. At a time that is taken a bag is kept at the next free millisecond.
    [[nodiscard]] tl::expected<void, StoreError> add(const QList<Bag>& bags);
    [[nodiscard]] tl::expected<qint64, StoreError> count();
    // From `fromMs` to before `toMs`; of more than `most` only that number is said.
    [[nodiscard]] tl::expected<qint64, StoreError> countBetween(qint64 fromMs, qint64 toMs, qint64 most);
    // Oldest first.
    [[nodiscard]] tl::expected<void, StoreError> forEach(qint64 fromMs, qint64 toMs,
                                                         const std::function<void(const Bag&)>& take);

private:
    [[nodiscard]] tl::expected<qint64, StoreError> programOf(const Bag& bag);
    // At `timeMs` or the next free millisecond, which it tells.
    [[nodiscard]] tl::expected<qint64, StoreError> insert(const Bag& bag, qint64 program, qint64 timeMs);
    [[nodiscard]] tl::expected<void, StoreError> forgetPrograms();

    Database& m_database;
    qint64 m_kept;
};

} // namespace campanel::store
