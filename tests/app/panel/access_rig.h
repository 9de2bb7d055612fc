// SPDX-License-Identifier: Apache-2.0
// A PanelRig with users, logins and the audit trail, on a database in its folder and test clocks.
#pragma once

#include "app/panel/access/access.h"
#include "app/panel/audit/audit.h"
#include "app/panel/audit/audit_trail.h"
#include "app/store/users/pin_hash.h"
#include "app/store/users/user_store.h"
#include "panel_rig.h"

#include <QTest>

namespace campanel::test {

struct AccessRig : PanelRig {
    qint64 wallMs = 1'790'000'000'000;
    panel::Access access{records, machine, settings, nullptr};
    panel::AuditTrail trail{records, {machine, editor, settings, maintenance, access}, nullptr};
    panel::Audit audit{records, trail, nullptr};

    AccessRig()
    {
        access.setWallClock([this] { return wallMs; });
        trail.setWallClock([this] { return wallMs; });
        records.open();
        access.open();
        trail.open();
        settle();
    }

    // Waits for all requests to the database and for the hashing.
    void settle()
    {
        int done = 0;
        do {
            const int wanted = ++m_rounds;
            records.store().run(
                &records, [](store::Database&) { return true; }, [&done, wanted](bool) { done = wanted; });
            while (done != wanted)
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        } while (access.busy());
    }

    [[nodiscard]] int idOf(const QString& name) const
    {
        for (const QVariant& user : access.users()) {
            if (user.toMap().value(QStringLiteral("name")).toString() == name)
                return user.toMap().value(QStringLiteral("id")).toInt();
        }
        return 0;
    }
    void add(const QString& name, panel::Access::Level level, const QString& pin)
    {
        access.addUser(name, level, pin);
        settle();
    }
    void logIn(const QString& name, const QString& pin)
    {
        access.choose(idOf(name));
        access.login(pin);
        settle();
    }
    // Adds Anna of the level Service with 258036 and Bo, a technician, with 1470; nobody is logged in.
    void addAnnaAndBo()
    {
        // A hash takes a third of a second, by design: these are made once.
        static const QString anna = store::hashPin(QStringLiteral("258036")).value_or(QString());
        static const QString bo = store::hashPin(QStringLiteral("1470")).value_or(QString());
        bool isDone = false;
        records.store().run(
            &records,
            [](store::Database& database) {
                return store::addUser(database, QStringLiteral("Anna"), store::UserLevel::Service, anna) &&
                       store::addUser(database, QStringLiteral("Bo"), store::UserLevel::Technician, bo);
            },
            [&isDone](bool areAdded) { isDone = areAdded; });
        settle();
        QVERIFY(isDone);
        access.open();
        settle();
    }
    // Returns the whole trail, oldest first.
    [[nodiscard]] QList<store::AuditEntry> entries()
    {
        settle();
        QList<store::AuditEntry> found;
        bool isRead = false;
        records.store().run(
            &records, [](store::Database& database) { return store::auditTable().page(database, 0, 1000); },
            [&](const auto& rows) {
                for (const store::AuditRow& row : *rows)
                    found.prepend(row.entry);
                isRead = true;
            });
        while (!isRead)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        return found;
    }

    [[nodiscard]] QString hashOf(const QString& name)
    {
        QString hash;
        records.store().run(
            &records,
            [name](store::Database& database) {
                auto row = database.execute(QStringLiteral("SELECT pin FROM user WHERE name = ?"), {name});
                return row && row->next() ? row->value(0).toString() : QString();
            },
            [&hash](const QString& found) { hash = found; });
        settle();
        return hash;
    }

private:
    int m_rounds = 0;
};

} // namespace campanel::test
