// SPDX-License-Identifier: Apache-2.0
// The thread that owns the database. A caller passes a function; its result is returned in the caller's
// thread. Jobs run in order, and the destructor waits for all.
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
        std::optional<StoreError> error; // it could not be opened: data is lost at the end
    };

    // `folder` contains the database.
    explicit StoreThread(const QString& folder, const DatabaseFile& file = mainDatabase(),
                         QObject* parent = nullptr);
    ~StoreThread() override;

    // Keeps the database closed for this reason; open() then reports it. Call it before open().
    void withhold(const StoreError& reason) { m_withheld = reason; }
    // Opens the database; opened() reports the result. Earlier jobs wait for it.
    void open();
    // Moves a file aside that a job found damaged and creates another one; opened() reports it.
    void beginAnew();

    // Calls `job` with the Database in its thread, then `done` with the result in the thread of `context`,
    // unless that was destroyed.
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
    std::optional<StoreError> m_withheld;
    QThread m_thread;
    std::unique_ptr<QObject> m_worker;    // lives in m_thread
    std::unique_ptr<Database> m_database; // created, used and destroyed in m_thread
};

} // namespace campanel::store
