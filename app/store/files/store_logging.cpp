// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/store_logging.h"

namespace campanel::store {

Q_LOGGING_CATEGORY(storeLog, "campanel.store")

} // namespace campanel::store
