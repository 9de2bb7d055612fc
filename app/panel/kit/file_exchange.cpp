// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/file_exchange.h"

namespace campanel::panel {

FileExchange::FileExchange(QString ownFolder, QObject* parent)
    : QObject(parent)
    , m_ownFolder(std::move(ownFolder))
{
    m_pool.setMaxThreadCount(1);
}

FileExchange::~FileExchange()
{
    m_pool.waitForDone();
}

void FileExchange::scan()
{
    showMessage({}, false);
    search();
}

void FileExchange::search()
{
    run(searcher(), [](const Apply& apply) { apply(); });
}

void FileExchange::refresh()
{
    if (busy() || std::exchange(m_isRefreshing, true))
        return;
    m_pool.start([this, search = searcher()] {
        QMetaObject::invokeMethod(this, [this, apply = search()] {
            m_isRefreshing = false;
            apply();
        });
    });
}

void FileExchange::begin()
{
    ++m_jobs;
    emit changed();
}

void FileExchange::end()
{
    --m_jobs;
    emit changed();
}

void FileExchange::showMessage(const QString& message, bool failed)
{
    m_message = message;
    m_failed = failed;
    emit changed();
}

void FileExchange::showWritten(const QStringList& paths, const QString& problem, bool isOnStick)
{
    const QString all = paths.join(QStringLiteral(", "));
    if (!problem.isEmpty())
        showMessage(problem, true);
    else
        showMessage(isOnStick ? tr("Written: %1. You can remove the stick now.").arg(all)
                              : tr("Written: %1").arg(all),
                    false);
}

QList<OfferRow> FileExchange::placeRows(const QList<store::Place>& places,
                                        const std::function<QString(qsizetype place)>& consequence)
{
    QList<OfferRow> rows;
    for (qsizetype i = 0; i < places.size(); ++i) {
        const store::Place& place = places[i];
        const QString detail =
            place.isReadOnly
                ? tr("%1 is read-only. Unlock the stick or choose another location.").arg(place.path)
                : consequence(i);
        rows << OfferRow{place.name, place.isReadOnly ? tr("%1 · read-only").arg(place.path) : place.path,
                         detail, !place.isReadOnly};
    }
    return rows;
}

} // namespace campanel::panel
