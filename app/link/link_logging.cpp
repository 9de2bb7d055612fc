// SPDX-License-Identifier: Apache-2.0
#include "app/link/link_logging.h"

namespace campanel::link {

Q_LOGGING_CATEGORY(linkLog, "campanel.link")

} // namespace campanel::link
