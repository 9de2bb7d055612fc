// SPDX-License-Identifier: Apache-2.0
#include "app/panel/display/backlight.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr double whole = 100;
const QString levelFile = u"brightness"_s;

std::optional<int> readNumber(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    bool isNumber = false;
    const int number = file.readAll().trimmed().toInt(&isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
}

} // namespace

std::optional<Backlight> Backlight::find(const QString& folder)
{
    for (const QFileInfo& device :
         QDir(folder).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        const QDir files(device.filePath());
        const auto maximum = readNumber(files.filePath(u"max_brightness"_s));
        if (maximum && *maximum > 0 && QFileInfo(files.filePath(levelFile)).isWritable())
            return Backlight(device.filePath(), *maximum);
    }
    return {};
}

int Backlight::percent() const
{
    const auto level = readNumber(QDir(m_device).filePath(levelFile));
    return static_cast<int>(std::lround(whole * level.value_or(0) / m_maximum));
}

bool Backlight::setPercent(int percent) const
{
    QFile file(QDir(m_device).filePath(levelFile));
    const QByteArray level = QByteArray::number(static_cast<int>(std::lround(percent / whole * m_maximum)));
    return file.open(QIODevice::WriteOnly) && file.write(level) == level.size() && file.flush();
}

} // namespace campanel::panel
