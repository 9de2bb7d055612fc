// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/setup_marker.h"

#include "app/store/files/files.h"
#include "app/store/files/private_files.h"

#include <QFileInfo>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr auto withPins = "pins yes\n";
constexpr auto withoutPins = "pins no\n";

} // namespace

QString setupMarkerPath(const QString& databasePath)
{
    return databasePath + u".setup"_s;
}

SetUp readSetupMarker(const QString& databasePath)
{
    const QByteArray line = readBytes(setupMarkerPath(databasePath)).value_or(QByteArray());
    return line == withPins ? SetUp::WithPins : line == withoutPins ? SetUp::WithoutPins : SetUp::Unknown;
}

bool writeSetupMarker(const QString& databasePath, SetUp setUp)
{
    if (readSetupMarker(databasePath) == setUp)
        return true;
    const QString path = setupMarkerPath(databasePath);
    const bool isWritten = replaceBytes(path, setUp == SetUp::WithPins ? withPins : withoutPins).has_value();
    makePrivate(path);
    return isWritten;
}

bool wasSetUp(const QString& databasePath)
{
    for (const auto suffix : {".setup"_L1, ".copy"_L1, ".audit"_L1}) {
        if (QFileInfo(databasePath + suffix).size() > 0)
            return true;
    }
    return false;
}

} // namespace campanel::store
