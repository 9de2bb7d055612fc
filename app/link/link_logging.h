// SPDX-License-Identifier: Apache-2.0
// The log category of this folder. Polls are not logged.
#pragma once

#include <QLoggingCategory>

namespace campanel::link {

Q_DECLARE_LOGGING_CATEGORY(linkLog)

} // namespace campanel::link
