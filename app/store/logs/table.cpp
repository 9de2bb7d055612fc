// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/table.h"

namespace campanel::store {

void csvPlain(CsvWriter& csv, const QVariant& value)
{
    switch (value.typeId()) {
    case QMetaType::QString:
        csv.text(value.toString());
        break;
    case QMetaType::QByteArray:
        csv.text(QString::fromLatin1(value.toByteArray().toHex()));
        break;
    case QMetaType::Bool:
        csv.yesOrNo(value.toBool());
        break;
    case QMetaType::Double:
        csv.significant(value.toDouble());
        break;
    default:
        csv.whole(value.toLongLong());
    }
}

void csvValue(CsvWriter& csv, const QVariant& value)
{
    csv.value(value.toString());
}

void csvUtc(CsvWriter& csv, const QVariant& value)
{
    csv.utc(value.toLongLong());
}

void csvClock(CsvWriter& csv, const QVariant& value)
{
    csv.clock(value.toBool());
}

} // namespace campanel::store
