// SPDX-License-Identifier: Apache-2.0
// An AccessRig with orders, and a controller that counts one as the real one does.
#pragma once

#include "app/panel/orders/orders.h"
#include "tests/app/panel/access_rig.h"
#include "tests/app/panel/kind_steps.h"
#include "tests/support/order_image.h"

#include <memory>

namespace campanel::test {

struct OrderRig : AccessRig {
    modbus::OrderStatus counted{
        .state = modbus::OrderState::None, .action = modbus::OrderAction::None, .lot = {}};
    std::unique_ptr<panel::Orders> orders;
    std::uint64_t uniqueId = 42;
    std::uint16_t mapMinor = modbus::mapMinor;
    modbus::Refusal refusal = modbus::Refusal::None; // of the next commands
    bool isAnswering = true;

    OrderRig() { restartPanel(); }

    // Creates the orders anew, as a restart does, on the same database.
    void restartPanel()
    {
        orders.reset();
        orders = std::make_unique<panel::Orders>(machine, records, nullptr);
        orders->setWallClock([this] { return wallMs; });
        settle();
        answer();
    }
    void connectRunning(modbus::State state = modbus::State::Running)
    {
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.identity = FakeLink::identity();
        report.identity->uniqueId = uniqueId;
        report.identity->mapMinor = mapMinor;
        emit link.reported(report);
        link.status.state = state;
        link.status.masterSpeedPercent = 100;
        link.activate(image(), now);
        link.sendStatus(now);
        settle();
        answer();
    }
    // Lets the controller answer what was sent since, and the panel read the order again.
    void answer()
    {
        settle();
        for (; m_requests < link.requests.size(); ++m_requests)
            answerCommand(link.requests[m_requests]);
        for (; m_reads < link.reads.size(); ++m_reads) {
            const link::ReadRequest request = link.reads[m_reads];
            if (request.address == modbus::orderStatusAddress && isAnswering)
                emit link.registersRead({request, link::ReadEnd::Done, orderRegisters(counted), now, {}});
        }
        settle();
    }
    // Lets time pass until the order has been read again.
    void pass(std::chrono::seconds time = std::chrono::seconds(6))
    {
        now += time;
        wallMs += std::chrono::milliseconds(time).count();
        link.sendStatus(now);
        orders->check();
        answer();
    }
    void count(std::uint32_t good, std::uint32_t rejected = 0, std::uint32_t empty = 0)
    {
        counted.good = good;
        counted.rejected = rejected;
        counted.empty = empty;
        counted.cut = good + rejected + empty;
        if (counted.good >= counted.quantity)
            counted.state = modbus::OrderState::Complete;
    }
    void enter(double quantity, const QString& lot, const QString& text = {})
    {
        orders->entry()->begin({});
        orders->entry()->quantity()->set(quantity);
        orders->entry()->setLot(lot);
        orders->entry()->setText(text);
    }
    [[nodiscard]] QStringList waiting() const
    {
        QStringList lots;
        for (const panel::OrderListRow& row : orders->queue().rows())
            lots << row.order.lot;
        return lots;
    }
    [[nodiscard]] store::OrderRow current() const { return orders->current().order; }
    // Returns the orders of the log, oldest first.
    [[nodiscard]] QList<store::OrderRow> logged()
    {
        settle();
        QList<store::OrderRow> rows;
        records.store().run(
            &records,
            [](store::Database& database) {
                return *store::orderTable().read(database, QStringLiteral("WHERE id > 0 ORDER BY id"));
            },
            [&rows](const QList<store::OrderRow>& found) { rows = found; });
        settle();
        return rows;
    }

private:
    void answerCommand(const link::CommandRequest& request)
    {
        using modbus::Command;
        if (request.command != Command::OrderStart && request.command != Command::OrderEnd)
            return;
        link::CommandOutcome outcome{request.id, request.command, link::CommandEnd::Done, refusal, {}};
        if (refusal != modbus::Refusal::None) {
            outcome.end = link::CommandEnd::Refused;
        } else if (request.command == Command::OrderEnd) {
            counted.state = modbus::OrderState::Ended;
        } else {
            counted = {.state = modbus::OrderState::Active,
                       .number = request.arguments.argument0,
                       .action = static_cast<modbus::OrderAction>(request.arguments.argument1),
                       .isKept = true,
                       .quantity = request.arguments.argument2,
                       .lot = request.arguments.lot};
        }
        if (isAnswering)
            emit link.commandEnded(outcome);
    }

    qsizetype m_requests = 0;
    qsizetype m_reads = 0;
};

} // namespace campanel::test
