// SPDX-License-Identifier: Apache-2.0
#include "app/panel/reports/backup.h"

#include "app/panel/access/access.h"
#include "app/panel/audit/audit_trail.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/panel/trends/trends.h"
#include "app/store/files/ask_places.h"
#include "app/store/recipes/recipe_json.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr qsizetype maxFound = 500; // in one place
const QString suffix = u"zip"_s;

QString snapshotName()
{
    return u"snapshot-"_s;
}

// Returns number and hash of the newest row, which the restored trail will contain.
QString newestRowOf(store::Database& database)
{
    const auto rows = store::auditTable().page(database, 0, 1);
    if (!rows || rows->isEmpty())
        return {};
    return u"%1 %2"_s.arg(rows->first().sequence).arg(QString::fromLatin1(rows->first().hash.toHex()));
}

} // namespace

Backup::Backup(const Parts& parts, const QString& folder, QObject* parent)
    : FileExchange(QDir(folder).filePath(u"backups"_s), parent)
    , m_parts(parts)
    , m_folder(folder)
    , m_places(ownFolder(), this)
    , m_scanner(&store::exchangePlaces)
    , m_wallClock([] { return QDateTime::currentDateTime(); })
{
    m_places.guardBy(parts.controller.accessCheck());
    connect(&m_places, &ReportFiles::written, this, [this](const QStringList& paths, const QString& problem) {
        m_parts.trail.note({.what = u"backup.make"_s,
                            .object = paths.value(0),
                            .outcome = problem.isEmpty() ? u"done"_s : u"failed"_s});
    });
    // Files left by a panel that was killed.
    QDir home(folder);
    for (const QString& old : home.entryList({snapshotName() + u'*'}, QDir::Dirs))
        QDir(home.filePath(old)).removeRecursively();
    LanguageNotifier::follow(this, [this] { takeFound(m_files); });
}

void Backup::setScanner(Scanner scanner)
{
    m_scanner = scanner;
    m_places.setScanner(std::move(scanner));
}

bool Backup::require()
{
    return m_parts.controller.accessCheck().require(Level::Service) && !busy();
}

void Backup::snapshot(const std::function<void(const Snapshot&)>& then)
{
    Snapshot taken;
    taken.folder = std::make_shared<QTemporaryDir>(QDir(m_folder).filePath(snapshotName() + u"XXXXXX"_s));
    taken.parts = {m_parts.settings.contents(), store::toJson(m_parts.editor.storedRecipe()),
                   store::toJson(m_parts.editor.recipe())};
    begin();
    m_parts.records.store().run(
        this,
        [taken](store::Database& database) -> tl::expected<Snapshot, store::StoreError> {
            const auto manifest = store::takeSnapshot(database, taken.folder->path());
            if (!manifest)
                return tl::unexpected(manifest.error());
            Snapshot whole = taken;
            whole.manifest = *manifest;
            whole.newestRow = newestRowOf(database);
            return whole;
        },
        [this, then](const tl::expected<Snapshot, store::StoreError>& made) {
            if (made)
                addTrends(*made, then);
            else
                showMessage(store::StoreErrorText::describe(made.error()), true);
            end();
        });
}

void Backup::addTrends(const Snapshot& taken, const std::function<void(const Snapshot&)>& then)
{
    begin();
    m_parts.trends.flush();
    m_parts.trends.store().run(
        this,
        [folder = taken.folder](store::Database& database) {
            return store::takeTrendSnapshot(database, folder->path());
        },
        [this, taken, then](const tl::expected<void, store::StoreError>& added) {
            if (added) {
                Snapshot whole = taken;
                whole.manifest.program = QCoreApplication::applicationVersion();
                whole.manifest.made = m_wallClock().toUTC();
                whole.manifest.madeBy = m_parts.access.userName();
                then(whole);
            } else {
                showMessage(store::StoreErrorText::describe(added.error()), true);
            }
            end();
        });
}

void Backup::make()
{
    if (!require())
        return;
    if (m_parts.records.openError())
        return showMessage(
            tr("The database could not be opened: a backup would be empty. Correct this first, then restart "
               "the panel."),
            true);
    showMessage({}, false);
    snapshot([this](const Snapshot& taken) {
        const QString name =
            tr("CamPanel backup %1", "name of a file").arg(m_parts.settings.fileStamp(m_wallClock()));
        m_places.offer({{name, suffix, {}, [taken](const QString& path) {
                             return store::writeBackup(path, taken.manifest, taken.folder->path(),
                                                       taken.parts);
                         }}});
        emit offered();
    });
}

std::function<FileExchange::Apply()> Backup::searcher()
{
    return [this, scan = m_scanner, folder = ownFolder()]() -> Apply {
        constexpr std::chrono::seconds patience{20}; // a slow stick with many backups
        const QList<store::Place> places = scan(folder);
        const auto answers = store::askPlaces<QList<Found>>(places, &Backup::foundIn, patience);
        QList<Found> found;
        for (qsizetype i = 0; i < places.size(); ++i) {
            const auto& answer = answers[static_cast<std::size_t>(i)];
            found += answer ? *answer : QList{missing(places[i], store::silentText(places[i]))};
        }
        return [this, found] { takeFound(found); };
    };
}

QList<Backup::Found> Backup::foundIn(const store::Place& place)
{
    const store::FolderFiles files = store::filesIn(place, u"*."_s + suffix, maxFound);
    QList<Found> found;
    for (const QFileInfo& file : files.files)
        found << Found{file.filePath(), place.name, store::readManifest(file.filePath()), {}};
    if (!files.notice.isEmpty())
        found << missing(place, files.notice);
    return found;
}

Backup::Found Backup::missing(const store::Place& place, const QString& notice)
{
    return {place.path, place.name, tl::unexpected(store::BackupError{}), notice};
}

void Backup::takeFound(const QList<Found>& found)
{
    m_files = found;
    // The newest backup first, invalid files last.
    std::ranges::stable_sort(m_files, std::greater<>(), [](const Found& each) {
        return each.manifest ? each.manifest->made.toMSecsSinceEpoch() : 0;
    });
    QList<OfferRow> rows;
    for (const Found& each : m_files)
        rows << row(each);
    m_found.setRows(rows);
}

QString Backup::summary(const store::BackupManifest& manifest) const
{
    const QString date = Format::minute(manifest.made);
    const QString maker =
        manifest.madeBy.isEmpty() ? date : tr("%1 by %2", "date, person").arg(date, manifest.madeBy);
    return tr("%1 · recipes: %2 · users: %3 · CamPanel %4", "when, how many, how many, version")
        .arg(maker, QString::number(manifest.recipes), QString::number(manifest.users), manifest.program);
}

OfferRow Backup::row(const Found& found) const
{
    if (!found.notice.isEmpty())
        return noticeRow(found.placeName, found.notice);
    OfferRow row;
    row.title = QFileInfo(found.path).fileName();
    row.usable = found.manifest.has_value();
    row.note = row.usable
                   ? tr("%1 · %2", "what is in it, place").arg(summary(*found.manifest), found.placeName)
                   : tr("cannot be used · %1", "place").arg(found.placeName);
    row.detail = row.usable ? tr("The file is checked first. Nothing is changed before you confirm.")
                            : store::BackupErrorText::describe(found.manifest.error());
    return row;
}

void Backup::check(int row)
{
    if (!require() || row < 0 || row >= m_files.size() || !m_files[row].manifest)
        return;
    m_checked.reset();
    showMessage({}, false);
    if (const QString reason = m_parts.controller.blockedReason(Action::RestoreBackup); !reason.isEmpty())
        return showMessage(reason, true);
    const QString path = m_files[row].path;
    run([path, folder = m_folder] { return store::stageRestore(path, folder); },
        [this, path](const tl::expected<store::BackupManifest, store::BackupError>& staged) {
            if (!staged)
                return showMessage(store::BackupErrorText::describe(staged.error()), true);
            m_checked = Checked{path, *staged};
            QMetaObject::invokeMethod(this, &Backup::checked, Qt::QueuedConnection); // not busy any more
        });
}

QString Backup::question() const
{
    if (!m_checked)
        return {};
    return (m_checked->manifest.hasTrends()
                ? tr("The file is valid: %1.\nIt replaces recipes, machine data, users with their PINs, "
                     "alarms, audit trail, bags, trends and settings of this panel. The present state is "
                     "saved as a backup on this panel, then the panel restarts.")
                : tr("The file is valid: %1.\nIt replaces recipes, machine data, users with their PINs, "
                     "alarms, audit trail and settings of this panel; bags and trends stay. The present "
                     "state is saved as a backup on this panel, then the panel restarts."))
        .arg(summary(m_checked->manifest));
}

void Backup::restore()
{
    if (!require() || !m_checked)
        return;
    if (const QString reason = m_parts.controller.blockedReason(Action::RestoreBackup); !reason.isEmpty())
        return showMessage(reason, true);
    // The old trail gets an entry too, so that it documents its end.
    m_parts.trail.note({.what = u"backup.restore"_s,
                        .object = QFileInfo(m_checked->path).fileName(),
                        .after = m_checked->manifest.made.toString(Qt::ISODate)});
    snapshot([this](const Snapshot& present) { seal(present); });
}

void Backup::seal(const Snapshot& present)
{
    const store::AuditEntry entry{.timeMs = m_wallClock().toMSecsSinceEpoch(),
                                  .who = m_parts.access.userName(),
                                  .level = m_parts.access.level(),
                                  .what = u"backup.restored"_s,
                                  .object = QFileInfo(m_checked->path).fileName(),
                                  .before = present.newestRow,
                                  .after = m_checked->manifest.made.toString(Qt::ISODate)};
    const QString name =
        tr("CamPanel before restore %1", "name of a file").arg(m_parts.settings.fileStamp(m_wallClock()));
    run(
        [present, entry, name, folder = m_folder, own = ownFolder()] {
            QDir().mkpath(own);
            return store::writeNewFile({own, {}}, name, suffix,
                                       [&present](const QString& path) {
                                           return store::writeBackup(path, present.manifest,
                                                                     present.folder->path(), present.parts);
                                       })
                .and_then([&](const QString&) { return store::commitRestore(folder, entry); });
        },
        [this](const auto& ready) {
            m_checked.reset();
            if (ready)
                QMetaObject::invokeMethod(this, &Backup::restartWanted, Qt::QueuedConnection);
            else
                showMessage(tr("The restore was not started: %1. Nothing was changed.").arg(ready.error()),
                            true);
        });
}

} // namespace campanel::panel
