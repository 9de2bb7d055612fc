// SPDX-License-Identifier: Apache-2.0
#include "app/panel/update/update_state.h"

#include "app/store/files/files.h"
#include "app/store/files/private_files.h"
#include "app/store/update/signed_package.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

QString inFolder(const QString& folder, const QString& name)
{
    return QDir(folder).filePath(name);
}

std::optional<QJsonObject> objectIn(const QString& path)
{
    const auto bytes = store::readBytes(path);
    const QJsonObject object = bytes ? QJsonDocument::fromJson(*bytes).object() : QJsonObject();
    return object.isEmpty() ? std::nullopt : std::optional(object);
}

QString reportedPath(const UpdatePlaces& places)
{
    return inFolder(places.stagingFolder, u"reported"_s);
}

QString requestPath(const UpdatePlaces& places)
{
    return inFolder(places.requestFolder, u"update-request"_s);
}

// Copies the package with its signature; an older copy is replaced. Returns the system's reason of a failure.
QString copyPackage(const QString& from, const QString& to)
{
    for (const auto& [source, target] :
         {std::pair(from, to), std::pair(store::signaturePath(from), store::signaturePath(to))}) {
        QFile::remove(target);
        QFile file(source);
        if (!file.copy(target))
            return file.errorString();
    }
    return {};
}

} // namespace

UpdatePlaces UpdatePlaces::ofService()
{
    UpdatePlaces places;
    const QString state = qEnvironmentVariable("STATE_DIRECTORY");
    const QString runtime = qEnvironmentVariable("RUNTIME_DIRECTORY");
    if (!state.isEmpty() && !runtime.isEmpty()) {
        places.requestFolder = runtime;
        places.stagingFolder = inFolder(state, u"update"_s);
    }
    return places;
}

UpdateState readUpdateState(const UpdatePlaces& places)
{
    UpdateState state;
    state.isUnfinished = QFileInfo::exists(inFolder(places.stateFolder, u"unfinished"_s));
    const auto text = [](const QJsonObject& object, const char* key) {
        return object.value(QLatin1String(key)).toString();
    };
    if (const auto object = objectIn(inFolder(places.stateFolder, u"outcome"_s));
        object && !state.isUnfinished) {
        const auto reported = store::readBytes(reportedPath(places));
        const UpdateOutcome outcome{text(*object, "kind"),   text(*object, "result"), text(*object, "reason"),
                                    text(*object, "detail"), text(*object, "data"),   text(*object, "from"),
                                    text(*object, "to"),     text(*object, "utc")};
        if (!reported || QString::fromUtf8(*reported) != outcome.utc)
            state.outcome = outcome;
    }
    if (const auto object = objectIn(inFolder(places.stateFolder, u"way-back"_s)))
        state.back = WayBack{text(*object, "version"), text(*object, "over"), text(*object, "schema"),
                             text(*object, "utc")};
    return state;
}

void noteReported(const UpdatePlaces& places, const UpdateOutcome& outcome)
{
    // A failure is harmless: the outcome is reported once more at the next start.
    if (store::makePrivateFolder(places.stagingFolder))
        (void)store::replaceBytes(reportedPath(places), outcome.utc.toUtf8());
}

QString writeRequest(const UpdatePlaces& places, const UpdateRequest& request)
{
    if (!store::makePrivateFolder(places.stagingFolder))
        return places.stagingFolder;
    for (const auto& [source, name] :
         {std::pair(request.package, u"package.deb"_s), std::pair(request.installed, u"installed.deb"_s)}) {
        const QString target = inFolder(places.stagingFolder, name);
        QFile::remove(target);
        QFile::remove(store::signaturePath(target));
        if (source.isEmpty())
            continue;
        if (const QString problem = copyPackage(source, target); !problem.isEmpty())
            return problem;
    }
    const auto written =
        store::replaceBytes(requestPath(places), request.package.isEmpty() ? "back\n" : "update\n");
    return written ? QString() : written.error().found;
}

void withdrawRequest(const UpdatePlaces& places)
{
    QFile::remove(requestPath(places));
}

} // namespace campanel::panel
