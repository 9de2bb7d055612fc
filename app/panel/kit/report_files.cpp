// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/report_files.h"

namespace campanel::panel {

namespace {

struct Written {
    QStringList paths;
    QString problem; // empty when all were written
    bool isOnStick = false;
};

Written writeAll(const QList<ReportFile>& files, const store::Place& place)
{
    Written written;
    written.isOnStick = place.isRemovable;
    for (const ReportFile& file : files) {
        const auto path = file.write ? store::writeNewFile(place, file.name, file.suffix, file.write)
                                     : store::writeNewFile(place, file.name, file.suffix, file.content());
        if (!path) {
            written.problem = path.error();
            break;
        }
        written.paths << *path;
    }
    return written;
}

} // namespace

ReportFiles::ReportFiles(const QString& ownFolder, QObject* parent)
    : QObject(parent)
    , m_ownFolder(ownFolder)
    , m_looker(&store::exchangePlaces)
{
    m_pool.setMaxThreadCount(1);
}

ReportFiles::~ReportFiles()
{
    m_pool.waitForDone();
}

void ReportFiles::offer(QList<ReportFile> files)
{
    m_files = std::move(files);
    look();
}

void ReportFiles::look()
{
    m_message.clear();
    m_failed = false;
    search();
}

void ReportFiles::refresh()
{
    if (busy() || m_isRefreshing)
        return;
    m_isRefreshing = true;
    m_pool.start([this, look = m_looker, folder = m_ownFolder] {
        const QList<store::Place> found = look(folder);
        QMetaObject::invokeMethod(this, [this, found] {
            m_isRefreshing = false;
            takePlaces(found);
        });
    });
}

void ReportFiles::search()
{
    ++m_jobs;
    emit changed();
    m_pool.start([this, look = m_looker, folder = m_ownFolder] {
        const QList<store::Place> found = look(folder);
        QMetaObject::invokeMethod(this, [this, found] {
            takePlaces(found);
            --m_jobs;
            emit changed();
        });
    });
}

void ReportFiles::takePlaces(const QList<store::Place>& places)
{
    m_found = places;
    QList<OfferRow> rows;
    for (const store::Place& place : places) {
        const QString detail =
            place.isReadOnly
                ? tr("%1 is read-only. Unlock the stick or choose another location.").arg(place.path)
                : tr("New files will be written to %1.").arg(place.path);
        rows << OfferRow{place.name, place.isReadOnly ? tr("%1 · read-only").arg(place.path) : place.path,
                         detail, !place.isReadOnly};
    }
    m_places.setRows(rows);
}

void ReportFiles::write(int place)
{
    if (place < 0 || place >= m_found.size() || m_found[place].isReadOnly || m_files.isEmpty())
        return;
    ++m_jobs;
    emit changed();
    m_pool.start([this, where = m_found[place], files = m_files] {
        const Written written = writeAll(files, where);
        QMetaObject::invokeMethod(this, [this, written] {
            m_failed = !written.problem.isEmpty();
            const QString paths = written.paths.join(QStringLiteral(", "));
            m_message = m_failed            ? written.problem
                        : written.isOnStick ? tr("Written: %1. You can remove the stick now.").arg(paths)
                                            : tr("Written: %1").arg(paths);
            --m_jobs;
            emit this->written(written.paths, written.problem);
            search();
        });
    });
}

} // namespace campanel::panel
