// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/report_files.h"

namespace campanel::panel {

namespace {

// One file that cannot be written does not end the others.
ReportFiles::Written writeAll(const QList<ReportFile>& files, const store::Place& place)
{
    ReportFiles::Written written;
    written.isOnStick = place.isRemovable;
    for (const ReportFile& file : files) {
        const auto path = file.write ? store::writeNewFile(place, file.name, file.suffix, file.write)
                                     : store::writeNewFile(place, file.name, file.suffix, file.content());
        if (path) {
            written.paths << *path;
        } else {
            written.failed << file.name;
            written.problems << path.error();
        }
    }
    return written;
}

} // namespace

ReportFile csvFile(const QString& name, const QByteArray& content)
{
    return {name, QStringLiteral("csv"), [packed = qCompress(content)] { return qUncompress(packed); }};
}

ReportFiles::ReportFiles(const QString& ownFolder, QObject* parent)
    : FileExchange(ownFolder, parent)
    , m_scanner(&store::exchangePlaces)
{
}

void ReportFiles::offer(QList<ReportFile> files, const QString& notice)
{
    m_files = std::move(files);
    m_notice = notice;
    scan();
}

std::function<FileExchange::Apply()> ReportFiles::searcher()
{
    return [this, scan = m_scanner, folder = ownFolder()]() -> Apply {
        return [this, found = scan(folder)] {
            m_found = found;
            m_places.setRows(placeRows(found, [this](qsizetype place) {
                const QString consequence = tr("New files will be written to %1.").arg(m_found[place].path);
                return m_notice.isEmpty() ? consequence : consequence + u' ' + m_notice;
            }));
        };
    };
}

void ReportFiles::write(int place)
{
    if (!isAllowed(Level::Operator) || place < 0 || place >= m_found.size() || m_found[place].isReadOnly ||
        m_found[place].isSilent || m_files.isEmpty())
        return;
    run([where = m_found[place], files = m_files] { return writeAll(files, where); },
        [this](const Written& written) {
            showWritten(written, m_notice);
            search();
        });
}

} // namespace campanel::panel
