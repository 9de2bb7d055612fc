// SPDX-License-Identifier: Apache-2.0
// The log category of stored data: files that were damaged or could not be written.
#pragma once

#include <QLoggingCategory>

namespace campanel::store {

Q_DECLARE_LOGGING_CATEGORY(storeLog)

} // namespace campanel::store
