// SPDX-License-Identifier: Apache-2.0
#include "app/shell/data_disk.h"

#include <QFile>

namespace campanel::shell {

QString diskLost(const QString& file)
{
    constexpr qint64 maxLength = 200;
    QFile written(file);
    if (!written.open(QIODevice::ReadOnly))
        return {};
    QString reason = QString::fromUtf8(written.readLine(maxLength)).simplified();
    while (reason.endsWith(u'.'))
        reason.chop(1);
    return reason.isEmpty() ? QStringLiteral("?") : reason;
}

} // namespace campanel::shell
