// SPDX-License-Identifier: Apache-2.0
#include "app/store/store_thread.h"

#include "app/store/database/setup_marker.h"
#include "app/store/users/user_store.h"

#include <QDir>

namespace campanel::store {

StoreThread::StoreThread(const QString& folder, const DatabaseFile& file, QObject* parent)
    : QObject(parent)
    , m_folder(folder)
    , m_file(file)
    , m_worker(std::make_unique<QObject>())
{
    qRegisterMetaType<Report>();
    m_thread.setObjectName(QStringLiteral("store"));
    m_worker->moveToThread(&m_thread);
    QMetaObject::invokeMethod(m_worker.get(), [this] {
        if (m_withheld)
            take(tl::unexpected(*m_withheld));
        else
            take(Database::open(m_folder, m_file));
    });
}

void StoreThread::beginAnew()
{
    QMetaObject::invokeMethod(m_worker.get(), [this] {
        if (m_database->isInMemory())
            return;
        m_database.reset();
        take(Database::openAnew(m_folder, m_file));
    });
}

void StoreThread::take(tl::expected<std::unique_ptr<Database>, StoreError> database)
{
    Report report;
    if (!database)
        report.error = database.error();
    m_database = database ? std::move(*database) : substitute(database.error());
    report.opening = m_database->opening();
    QMetaObject::invokeMethod(this, [this, report] { emit opened(report); });
}

// Returns a database for the rest of the run, with the users of the copy, so that PINs can be checked.
std::unique_ptr<Database> StoreThread::substitute(const StoreError& failure) const
{
    const QString path = QDir(m_folder).filePath(m_file.name);
    if (!m_file.isPrecious || readSetupMarker(path) == SetUp::WithoutPins)
        return Database::inMemory(m_file);
    auto database = Database::inMemory(m_file, failure);
    borrowUsers(*database, m_folder);
    return database;
}

void StoreThread::open()
{
    m_thread.start(QThread::LowPriority);
}

StoreThread::~StoreThread()
{
    if (!m_thread.isRunning())
        m_thread.start(); // the pending jobs must be stored
    // Queued after all earlier jobs.
    QMetaObject::invokeMethod(m_worker.get(), [this] {
        m_database.reset();
        m_thread.quit();
    });
    m_thread.wait();
}

} // namespace campanel::store
