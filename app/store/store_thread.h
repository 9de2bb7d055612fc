// SPDX-License-Identifier: Apache-2.0
// The one thread that owns the database. Who wants something of it hands in a function; what that returns is
// given back in the thread of whoever asked. Jobs are done in their order, all of them before the end.
#pragma once

#include "app/store/database/database.h"

#include <QObject>
#include <QPointer>
#include <QThread>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>

namespace campanel::store {

class StoreThread : public QObject {
    Q_OBJECT

public:
    struct Report {
        Database::Opening opening;
        std::optional<StoreError> error; // it could not be opened: what is kept is gone at the end
    };

    // The database is in `folder`.
    explicit StoreThread(const QString& folder, const DatabaseFile& file = mainDatabase(),
                         QObject* parent = nullptr);
    ~StoreThread() override;

    // From now on; opened() tells what came of it. Jobs that were handed in before wait for it.
    void open();
    // A job has found the file damaged: it is moved aside and another one begun; opened() tells of it.
    void beginAnew();

    // `job` is called with the Database in its thread, then `done` with what it returned in the thread of
    // `context`, unless that is gone by then.
    template <typename Job, typename Done> void run(QObject* context, Job job, Done done)
    {
        const QPointer<QObject> receiver(context);
        QMetaObject::invokeMethod(m_worker.get(),
                                  [this, receiver, job = std::move(job), done = std::move(done)] {
                                      using Outcome = std::invoke_result_t<Job, Database&>;
                                      auto outcome = std::make_shared<Outcome>(job(*m_database));
                                      QMetaObject::invokeMethod(this, [receiver, done, outcome] {
                                          if (receiver)
                                              done(*outcome);
                                      });
                                  });
    }

signals:
    void opened(const campanel::store::StoreThread::Report& report);

private:
    void take(tl::expected<std::unique_ptr<Database>, StoreError> database); // in m_thread
    [[nodiscard]] std::unique_ptr<Database> substitute(const StoreError& failure) const;

    QString m_folder;
    DatabaseFile m_file;
    QThread m_thread;
    std::unique_ptr<QObject> m_worker;    // lives in m_thread
    std::unique_ptr<Database> m_database; // made, used and destroyed there
};

} // namespace campanel::store
