// SPDX-License-Identifier: Apache-2.0
// Log category of this folder. Nothing is logged per poll.
#pragma once

#include <QLoggingCategory>

namespace campanel::link {

Q_DECLARE_LOGGING_CATEGORY(linkLog)

} // namespace campanel::link
