// SPDX-License-Identifier: Apache-2.0
// Signed orders, which the plant offers to one machine: how many good bags of which lot.
#pragma once

#include "app/store/files/file_error.h"
#include "app/store/logs/order_log.h"
#include "app/store/recipes/recipe_keys.h"

#include <tl/expected.hpp>

namespace campanel::store {

// The largest quantity: what a controller counts.
inline constexpr qint64 maxOrderedBags = 1'000'000;

struct SignedOrder {
    OrderRow order; // text, lot, recipe, quantity and what happens at it; the rest is as in a new one
    QString machine;
    QString signer;
    qint64 signedMs = 0; // since 1970 UTC, whole seconds
};

// Signs these members of the order for the machine of this name (`gateway.node`).
[[nodiscard]] QByteArray signOrder(const OrderRow& order, const QString& machine, qint64 signedMs,
                                   const SigningKey& key);
// Reads a signed order and checks its signature before its content: every key of the order is there, its text
// and lot are not empty, the quantity is one that a controller counts. `path` is only for the error.
[[nodiscard]] tl::expected<SignedOrder, FileError> verifyOrder(const QByteArray& json, const QString& path,
                                                               const QList<SignerKey>& keys);

} // namespace campanel::store
