// SPDX-License-Identifier: Apache-2.0
#include "app/store/store_thread.h"

namespace campanel::store {

StoreThread::StoreThread(const QString& folder, QObject* parent)
    : QObject(parent)
    , m_worker(std::make_unique<QObject>())
{
    qRegisterMetaType<Report>();
    m_thread.setObjectName(QStringLiteral("store"));
    m_worker->moveToThread(&m_thread);
    QMetaObject::invokeMethod(m_worker.get(), [this, folder] {
        Report report;
        auto database = Database::open(folder);
        if (!database)
            report.error = database.error();
        m_database = database ? std::move(*database) : Database::inMemory();
        report.opening = m_database->opening();
        QMetaObject::invokeMethod(this, [this, report] { emit opened(report); });
    });
}

void StoreThread::open()
{
    m_thread.start(QThread::LowPriority);
}

StoreThread::~StoreThread()
{
    if (!m_thread.isRunning())
        m_thread.start(); // what was handed in is to be kept
    // After all jobs that were handed in before.
    QMetaObject::invokeMethod(m_worker.get(), [this] {
        m_database.reset();
        m_thread.quit();
    });
    m_thread.wait();
}

} // namespace campanel::store
