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
    : FileExchange(ownFolder, parent)
    , m_scanner(&store::exchangePlaces)
{
}

void ReportFiles::offer(QList<ReportFile> files)
{
    m_files = std::move(files);
    scan();
}

std::function<FileExchange::Apply()> ReportFiles::searcher()
{
    return [this, scan = m_scanner, folder = ownFolder()]() -> Apply {
        return [this, found = scan(folder)] {
            m_found = found;
            m_places.setRows(placeRows(found, [this](qsizetype place) {
                return tr("New files will be written to %1.").arg(m_found[place].path);
            }));
        };
    };
}

void ReportFiles::write(int place)
{
    if (place < 0 || place >= m_found.size() || m_found[place].isReadOnly || m_files.isEmpty())
        return;
    run([where = m_found[place], files = m_files] { return writeAll(files, where); },
        [this](const Written& written) {
            showWritten(written.paths, written.problem, written.isOnStick);
            emit this->written(written.paths, written.problem);
            search();
        });
}

} // namespace campanel::panel
