// SPDX-License-Identifier: Apache-2.0
#include "app/panel/display/touch_files.h"

#include "app/store/files/files.h"
#include "app/store/files/private_files.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QStringList>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

QString textOf(const QString& path)
{
    const auto bytes = store::readBytes(path);
    return bytes ? QString::fromLatin1(*bytes) : QString();
}

QString trialPath(const TouchPlaces& places)
{
    return QDir(places.stateFolder).filePath(u"trial"_s);
}

QString requestPath(const TouchPlaces& places)
{
    return QDir(places.requestFolder).filePath(u"touch-request"_s);
}

} // namespace

TouchPlaces TouchPlaces::ofService()
{
    TouchPlaces places;
    const QString state = qEnvironmentVariable("STATE_DIRECTORY");
    const QString runtime = qEnvironmentVariable("RUNTIME_DIRECTORY");
    if (!state.isEmpty() && !runtime.isEmpty()) {
        places.requestFolder = runtime;
        places.stateFolder = QDir(state).filePath(u"touch"_s);
    }
    return places;
}

// Input devices have the major number 13; "E:" begins a property.
std::optional<TouchMatrix> touchscreenMatrix(const TouchPlaces& places)
{
    static const QRegularExpression property(u"^E:LIBINPUT_CALIBRATION_MATRIX=(.*)$"_s,
                                             QRegularExpression::MultilineOption);
    const QDir devices(places.devices);
    for (const QString& name : devices.entryList({u"c13:*"_s}, QDir::Files, QDir::Name)) {
        const QString text = textOf(devices.filePath(name));
        if (text.contains(u"E:ID_INPUT_TOUCHSCREEN=1\n"_s))
            return matrixIn(property.match(text).captured(1)).value_or(plainTouch);
    }
    return std::nullopt;
}

QString setCalibration(const TouchPlaces& places)
{
    static const QRegularExpression matrix(u"ENV\\{LIBINPUT_CALIBRATION_MATRIX\\}=\"([^\"]*)\""_s);
    const auto match = matrix.match(textOf(places.rule));
    return match.hasMatch() ? match.captured(1) : noCalibration;
}

std::optional<TouchTrial> readTrial(const TouchPlaces& places)
{
    const QStringList lines = textOf(trialPath(places)).split(u'\n', Qt::SkipEmptyParts);
    const auto isWanted = [](const QString& text) { return text == noCalibration || matrixIn(text); };
    if (lines.size() != 2 || !isWanted(lines[0]) || !isWanted(lines[1]))
        return std::nullopt;
    return TouchTrial{lines[0], lines[1]};
}

bool writeTrial(const TouchPlaces& places, const TouchTrial& trial)
{
    const QByteArray text = u"%1\n%2\n"_s.arg(trial.before, trial.after).toLatin1();
    return store::makePrivateFolder(places.stateFolder) && store::replaceBytes(trialPath(places), text);
}

bool writeTouchRequest(const TouchPlaces& places, const QString& wanted)
{
    return store::replaceBytes(requestPath(places), wanted.toLatin1() + '\n').has_value();
}

void removeTrial(const TouchPlaces& places)
{
    QFile::remove(trialPath(places));
}

void removeTouchRequest(const TouchPlaces& places)
{
    QFile::remove(requestPath(places));
}

} // namespace campanel::panel
