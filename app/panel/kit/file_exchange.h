// SPDX-License-Identifier: Apache-2.0
// Files on a stick or in the panel's own folder: searching, reading and writing. A stick may be slow or
// broken: everything that accesses a disk runs in a thread of its own. Base of the classes for each type of
// file.
#pragma once

#include "app/panel/kit/access_check.h"
#include "app/panel/kit/offer_model.h"
#include "app/store/files/exchange_places.h"

#include <QObject>
#include <QPointer>
#include <QThreadPool>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <chrono>
#include <functional>
#include <utility>

namespace campanel::panel {

// The time after which a message about what was done ends.
inline constexpr std::chrono::seconds messageTime{8};

class FileExchange : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("File exchanges belong to the object that has the data")
    // The folder of this panel, which is always available.
    Q_PROPERTY(QString ownFolder READ ownFolder CONSTANT FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // The result of the last request; empty: none.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)

public:
    // Searches for places; called in another thread.
    using Scanner = std::function<QList<store::Place>(const QString& ownFolder)>;

    [[nodiscard]] QString ownFolder() const { return m_ownFolder; }
    [[nodiscard]] bool busy() const { return m_jobs > 0; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool failed() const { return m_failed; }

    // Sets how long a message about what was written stays.
    void setMessageTime(std::chrono::milliseconds time) { m_messageTimer.setInterval(time); }
    // Sets the permissions that writing a file asks for; without them everything is permitted.
    void guardBy(AccessCheck& access) { m_access = &access; }

    // Searches and clears the message.
    Q_INVOKABLE void scan();
    // Searches again without clearing the message, for a sheet that waits for a stick.
    Q_INVOKABLE void refresh();

signals:
    void changed();
    // Emitted with the files written; `problem` is empty when all were written.
    void written(const QStringList& paths, const QString& problem);

protected:
    using Apply = std::function<void()>;

    FileExchange(QString ownFolder, QObject* parent);
    ~FileExchange() override;

    // Returns the search, to be called in another thread. It returns what shows its result, to be called in
    // the thread of this object.
    [[nodiscard]] virtual std::function<Apply()> searcher() = 0;

    // Calls `job` in another thread, then `done` with its result in the thread of this object.
    // Once the object is gone `done` is not called: `job` must own what it uses.
    template <class Job, class Done> void run(Job job, Done done)
    {
        begin();
        startJob(std::move(job), [this, done = std::move(done)](const auto& result) {
            done(result);
            end();
        });
    }
    // Searches as scan(), without clearing the message.
    void search();
    void begin();
    void end();
    void showMessage(const QString& message, bool failed);
    // Returns true when the person has the level. Otherwise requests a login.
    [[nodiscard]] bool isAllowed(Level needed) const { return !m_access || m_access->require(needed); }
    struct Written {
        QStringList paths;
        QStringList failed;   // the names of the files that are missing
        QStringList problems; // why, a whole sentence for each of them
        bool isOnStick = false;
    };
    // Tells the result of a write; `notice` tells what the files lack. A success ends, an error stays.
    void showWritten(const Written& written, const QString& notice = {});
    // Returns the row that tells which files of a place are not in the list.
    [[nodiscard]] static OfferRow noticeRow(const QString& placeName, const QString& notice);
    // Returns the rows of places, with the consequence of choosing one that can be written.
    [[nodiscard]] static QList<OfferRow>
    placeRows(const QList<store::Place>& places, const std::function<QString(qsizetype place)>& consequence);

private:
    template <class Job, class Done> void startJob(Job job, Done done)
    {
        m_pool->start(
            [receiver = m_receiver, self = QPointer(this), job = std::move(job), done = std::move(done)] {
                QMetaObject::invokeMethod(receiver, [self, done, result = job()] {
                    if (self)
                        done(result);
                });
            });
    }

    AccessCheck* m_access = nullptr;
    QString m_ownFolder;
    QString m_message;
    bool m_failed = false;
    QTimer m_messageTimer;
    bool m_isRefreshing = false;
    int m_jobs = 0;
    // One thread. Both outlive the object when a disk holds up a job.
    QThreadPool* m_pool = new QThreadPool;
    QObject* m_receiver = new QObject;
};

} // namespace campanel::panel
