// SPDX-License-Identifier: Apache-2.0
#include "app/panel/records/database_service.h"

#include "app/store/files/files.h"
#include "app/store/files/store_logging.h"

#include "app/panel/kit/language_notifier.h"

#include <QDateTime>
#include <QDir>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using store::storeLog;

namespace {

constexpr qint64 clockAskedMs = 1000; // between two questions; bags and states come more often

} // namespace

DatabaseService::DatabaseService(const QString& folder, QObject* parent)
    : QObject(parent)
    , m_store(folder)
{
    connect(&m_store, &store::StoreThread::opened, this, &DatabaseService::takeOpening);
    LanguageNotifier::follow(this);
}

DatabaseService::~DatabaseService() = default;

void DatabaseService::noteDiskLost(const QString& reason)
{
    m_store.withhold({store::StoreError::Kind::DiskLost, {}, reason});
}

bool DatabaseService::isDiskLost() const
{
    const auto& shown = m_error ? m_error : m_openError;
    return shown && shown->kind == store::StoreError::Kind::DiskLost;
}

void DatabaseService::takeOpening(const store::StoreThread::Report& report)
{
    m_openError = report.error;
    if (!report.error && !report.opening.isReplaced()) {
        noteRenamed(report.opening);
        makeCopy(); // the readable data is worth a copy; if that fails, the file itself still exists
        return;
    }
    m_opening = report;
    if (report.error)
        qCWarning(
            storeLog, "%s",
            qPrintable(store::oneLine(store::StoreErrorText::describe(*report.error), store::maxLineLength)));
    else
        noteReplacement(report.opening);
    emit noticeChanged();
}

void DatabaseService::makeCopy()
{
    m_store.run(
        this, [](store::Database& database) { return database.makeCopy(); },
        [this](const tl::expected<void, store::StoreError>& copied) {
            if (!copied)
                reportError(copied.error());
        });
}

void DatabaseService::setClockState(const std::function<store::ClockState()>& state)
{
    m_askClock = state;
    m_clockAsked.invalidate();
}

store::ClockState DatabaseService::clockState()
{
    if (m_askClock && m_clock != store::ClockState::Proven &&
        (!m_clockAsked.isValid() || m_clockAsked.hasExpired(clockAskedMs))) {
        m_clock = m_askClock();
        m_clockAsked.start();
        if (m_clock == store::ClockState::Proven)
            noteClockProven();
    }
    return m_clock;
}

void DatabaseService::noteClockProven()
{
    m_clock = store::ClockState::Proven;
    m_store.run(
        this,
        [nowMs = QDateTime::currentMSecsSinceEpoch()](store::Database& database) {
            return store::noteClockProven(database, nowMs);
        },
        [this](const tl::expected<void, store::StoreError>& kept) {
            if (!kept)
                reportError(kept.error());
        });
}

// Writes the replacement into the system's log and the audit trail, because the notice on the screen can be
// dismissed.
void DatabaseService::noteReplacement(const store::Database::Opening& opening)
{
    qCWarning(storeLog, "%s", qPrintable(store::oneLine(replacementText(opening), store::maxLineLength)));
    append({.what = opening.fromCopy ? u"memory.from_copy"_s : u"memory.lost"_s,
            .object = opening.damagedKeptAs});
}

// Writes the names that the database had to change; see Opening::renamed.
void DatabaseService::noteRenamed(const store::Database::Opening& opening)
{
    for (const store::Renamed& renamed : opening.renamed)
        append({.what = renamed.table + u".rename"_s,
                .object = renamed.before,
                .before = renamed.before,
                .after = renamed.after});
}

void DatabaseService::append(store::AuditEntry entry)
{
    entry.timeMs = QDateTime::currentMSecsSinceEpoch();
    m_store.run(
        this, [entry](store::Database& database) { return store::appendAudit(database, entry); },
        [this](const tl::expected<store::AuditRow, store::StoreError>& row) {
            if (!row)
                reportError(row.error());
        });
}

void DatabaseService::noteRestore(const store::FinishedRestore& restore)
{
    m_restore = restore;
    emit noticeChanged();
}

void DatabaseService::reportError(const store::StoreError& error)
{
    m_error = error;
    qCWarning(storeLog, "%s",
              qPrintable(store::oneLine(store::StoreErrorText::describe(error), store::maxLineLength)));
    emit errorReported(error);
    emit noticeChanged();
}

QString DatabaseService::notice() const
{
    if (m_error)
        return store::StoreErrorText::describe(*m_error);
    if (m_restore.isDone && !m_opening)
        return m_restore.problem.isEmpty()
                   ? tr("The backup has been restored. The previous data are kept in %1.")
                         .arg(QDir::toNativeSeparators(m_restore.keptIn))
                   : tr("The restore could not be completed: %1. The panel tries again at the next start.")
                         .arg(m_restore.problem);
    if (!m_opening)
        return {};
    if (m_opening->error)
        return tr("%1 Until then, new data are lost at a restart.", "%1: whole sentences")
            .arg(store::StoreErrorText::describe(*m_opening->error));
    return replacementText(m_opening->opening);
}

QString DatabaseService::replacementText(const store::Database::Opening& opening)
{
    if (opening.wasMissing)
        return opening.fromCopy ? tr("The panel's database was missing or empty and was replaced by the last "
                                     "good copy. Data saved after the last start are lost.")
                                : tr("The panel's database was missing or empty, and there was no good copy. "
                                     "A new, empty database was created; restore a backup.");
    const QString kept = QDir::toNativeSeparators(opening.damagedKeptAs);
    return opening.fromCopy ? tr("The panel's database was damaged. The last good copy is used; the damaged "
                                 "file is kept as %1.")
                                  .arg(kept)
                            : tr("The panel's database was damaged and there was no copy. A new, empty "
                                 "database was created; the damaged file is kept as %1.")
                                  .arg(kept);
}

void DatabaseService::dismissNotice()
{
    m_error.reset();
    m_opening.reset();
    m_restore = {};
    emit noticeChanged();
}

} // namespace campanel::panel
