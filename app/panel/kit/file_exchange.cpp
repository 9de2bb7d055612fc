// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/file_exchange.h"

#include "app/panel/kit/language_notifier.h"

#include <QDir>
#include <QFileInfo>

namespace campanel::panel {

namespace {

constexpr std::chrono::seconds patience{2}; // at the end, for a job that a disk may hold up

} // namespace

FileExchange::FileExchange(QString ownFolder, QObject* parent)
    : QObject(parent)
    , m_ownFolder(std::move(ownFolder))
{
    m_messageTimer.setSingleShot(true);
    m_messageTimer.setInterval(messageTime);
    m_messageTimer.callOnTimeout(this, [this] { showMessage({}, false); });
    m_pool->setMaxThreadCount(1);
    m_pool->setExpiryTimeout(-1); // it knows the places that did not answer
    LanguageNotifier::follow(this, [this] { showMessage({}, false); }); // it is in the previous language
}

FileExchange::~FileExchange()
{
    if (m_pool->waitForDone(std::chrono::milliseconds(patience).count())) {
        delete m_pool;
        delete m_receiver;
    } // else they stay for the thread, which may come back when this object is gone
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
    startJob(searcher(), [this](const Apply& apply) {
        m_isRefreshing = false;
        apply();
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
    m_messageTimer.stop();
    m_message = message;
    m_failed = failed;
    emit changed();
}

void FileExchange::showWritten(const Written& written, const QString& notice)
{
    emit this->written(written.paths, written.problems.value(0));
    const qsizetype count = written.paths.size();
    if (!written.problems.isEmpty()) {
        QStringList names = written.failed.mid(1);
        constexpr qsizetype maxNames = 3;
        if (names.size() > maxNames)
            names = names.first(maxNames) << QStringLiteral("…");
        QString message = written.problems.first();
        if (!names.isEmpty())
            message =
                tr("%1 Also missing: %2.", "%1: whole sentences, %2: files").arg(message, names.join(u", "));
        if (count > 0)
            message =
                tr("Written: %1 of %2 files. %3", "%3: whole sentences")
                    .arg(QString::number(count), QString::number(count + written.failed.size()), message);
        return showMessage(message, true);
    }
    const QString what = count == 1
                             ? written.paths.first()
                             : tr("%1 files in %2", "number, folder")
                                   .arg(QString::number(count),
                                        QDir::toNativeSeparators(QFileInfo(written.paths.value(0)).path()));
    const QString message = written.isOnStick ? tr("Written: %1. You can remove the stick now.").arg(what)
                                              : tr("Written: %1").arg(what);
    showMessage(notice.isEmpty() ? message : notice + u' ' + message, false);
    m_messageTimer.start();
}

OfferRow FileExchange::noticeRow(const QString& placeName, const QString& notice)
{
    return {placeName, tr("Some files are not shown"), notice, false};
}

QList<OfferRow> FileExchange::placeRows(const QList<store::Place>& places,
                                        const std::function<QString(qsizetype place)>& consequence)
{
    QList<OfferRow> rows;
    for (qsizetype i = 0; i < places.size(); ++i) {
        const store::Place& place = places[i];
        if (place.isSilent) {
            rows << OfferRow{place.name, tr("%1 · no answer").arg(place.path), store::silentText(place),
                             false};
            continue;
        }
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
