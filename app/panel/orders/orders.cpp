// SPDX-License-Identifier: Apache-2.0
#include "app/panel/orders/orders.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"
#include "app/store/database/clock_mark.h"
#include "app/store/database/names.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

using modbus::OrderState;
using store::OrderLog;
using store::OrderRow;

namespace {

constexpr auto checkPeriod = 1s;
// While no page shows the order, it is read more rarely: a slow line is needed for other things.
constexpr auto unwatchedPeriod = 5s;
constexpr auto freshFor = 3 * unwatchedPeriod;
// Counts are written so often: the controller has newer ones.
constexpr auto writePeriod = 60s;
constexpr auto retryDelay = 5s; // after a failed write
constexpr double msPerMinute = 60'000;

store::AuditEntry entryOf(const QString& what, const OrderRow& order)
{
    return {.what = what, .object = OrderWords::title(order), .after = QString::number(order.quantity)};
}

} // namespace

Orders::Orders(Controller& controller, DatabaseService& records, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_records(records)
    , m_writer(*this, records, m_book)
    , m_history(records,
                {store::orderTable(),
                 [this](const OrderRow& row) {
                     return OrderListRow{row, QDateTime::fromMSecsSinceEpoch(m_wallClock()).date()};
                 },
                 // Those of the queue have no time.
                 [](store::LogFilter& filter) { filter.fromMs = std::max<qint64>(filter.fromMs, 1); },
                 [] { return tr("orders"); }},
                this)
    , m_offers(records, this)
    , m_wallClock(&QDateTime::currentMSecsSinceEpoch)
{
    connect(&m_timer, &QTimer::timeout, this, &Orders::check);
    m_timer.start(checkPeriod);
    updateEvery(checkPeriod, [this] { read(); });
    connect(&controller, &Controller::connectionChanged, this, &Orders::followConnection);
    connect(&controller, &Controller::freshChanged, this, &Orders::changed);
    connect(&controller, &Controller::stateChanged, this, &Orders::read);
    connect(&controller, &Controller::programChanged, this, &Orders::read);
    connect(controller.packing(), &PackingLine::changed, this, [this, was = false]() mutable {
        if (std::exchange(was, offered()) == offered())
            return;
        read(); // it can be started at once
        emit changed();
    });
    LanguageNotifier::follow(this, [this] {
        m_queue.refresh();
        m_history.rows()->refresh();
        showMessage({});
    });
    begin({});
    followConnection();
}

void Orders::begin(const QString& controller)
{
    write();
    m_controllerId = controller;
    m_isBeginning = true;
    m_records.store().run(
        this, [controller](store::Database& database) { return OrderLog::begin(database, controller); },
        [this, controller](const tl::expected<OrderLog::Start, store::StoreError>& start) {
            if (controller != m_controllerId)
                return; // another one has followed
            m_isBeginning = false;
            if (!start)
                return m_records.reportError(start.error());
            m_newestMs = std::max(m_newestMs, start->newestMs);
            m_book.begin(*start, controller);
            update();
            read();
        });
}

void Orders::followConnection()
{
    m_isAsked = false;
    if (!m_controller.isConnected())
        m_status.reset();
    const auto& identity = m_controller.identity();
    if (m_controller.isConnected() && identity) {
        const QString id = Format::hexDigits(identity->uniqueId, 1);
        if (id != m_controllerId)
            begin(id);
    }
    read();
    emit changed();
}

bool Orders::offered() const
{
    const auto& program = m_controller.program();
    return m_controller.packing()->present() && program && program->recipe.isCutter();
}

QString Orders::tooOldText() const
{
    const auto& identity = m_controller.identity();
    return identity && identity->mapMinor < modbus::orderMapMinor
               ? OrderWords::tooOld(identity->mapMajor, identity->mapMinor)
               : QString();
}

OrderListRow Orders::current() const
{
    return {m_book.last().value_or(OrderRow()), QDateTime::fromMSecsSinceEpoch(m_wallClock()).date()};
}

bool Orders::fresh() const
{
    return m_status && m_controller.fresh() && m_controller.now() - m_readAt < freshFor;
}

QString Orders::endText() const
{
    const double rate = m_controller.live().rateBagsPerMin;
    if (!m_book.isUnderWay() || !fresh() || !(rate > 0) || m_controller.state() != Controller::State::Running)
        return {};
    const OrderRow& order = *m_book.last();
    const double left = static_cast<double>(std::max<qint64>(order.quantity - order.good, 0));
    const auto end = QDateTime::fromMSecsSinceEpoch(m_wallClock() + std::llround(left / rate * msPerMinute));
    return Format::local(end, u"HH:mm"_s);
}

OrderBook::Now Orders::now() const
{
    const qint64 utcMs = m_wallClock();
    return {utcMs, store::isTimeDoubtful(utcMs, m_newestMs, m_records.clockState())};
}

OrderBook::Program Orders::program() const
{
    const auto& program = m_controller.program();
    if (!program)
        return {};
    return {QString::fromStdString(program->name),
            std::isfinite(program->version) ? static_cast<int>(program->version) : 0, program->crc,
            m_controller.active().bagLengthMm};
}

void Orders::read()
{
    if (m_isAsked || m_isBeginning || !m_book.isBegun() || m_controllerId.isEmpty() ||
        !m_controller.isConnected() || !offered() || !tooOldText().isEmpty())
        return;
    m_isAsked = true;
    m_controller.link().readRegisters(
        {0, modbus::orderStatusAddress, modbus::orderStatusRegisters},
        {this, [this](const link::ReadOutcome& outcome) { takeRead(outcome); }});
}

void Orders::takeRead(const link::ReadOutcome& outcome)
{
    m_isAsked = false;
    if (m_isBeginning || outcome.end != link::ReadEnd::Done ||
        outcome.registers.size() != modbus::orderStatusRegisters)
        return;
    m_readAt = m_controller.now();
    m_status = modbus::decodeOrderStatus(outcome.registers);
    const OrderListRow before = current();
    const OrderBook::Now seenAt = now();
    if (!seenAt.isClockDoubtful)
        m_newestMs = std::max(m_newestMs, seenAt.utcMs);
    m_book.note(*m_status, program(), m_controller.packing()->filmTravelMm(), seenAt);
    noteChange(before);
    update();
}

void Orders::noteChange(const OrderListRow& before)
{
    const OrderListRow after = current();
    const OrderRow& order = after.order;
    if (before.underWay() != after.underWay() || before.id() != after.id())
        emit turned();
    if (before.underWay() && before.id() == after.id() && after.complete())
        showNotice(tr("%1 is complete: %2 good bags, %3 rejected, %4 empty.", "%1: an order")
                       .arg(after.title(), OrderWords::count(order.good), OrderWords::count(order.rejected),
                            OrderWords::count(order.empty)));
    const qint64 left = order.quantity - order.good;
    if (after.underWay() && order.action == OrderRow::Action::Message && left <= order.messageBefore &&
        std::exchange(m_announcedEnd, order.id) != order.id)
        showNotice(tr("%1: %2 bags left.", "%1: an order").arg(after.title(), OrderWords::count(left)));
}

// Writes what is urgent and shows the rest.
void Orders::update()
{
    QList<OrderListRow> rows;
    for (qsizetype place = 0; place < m_book.queue().size(); ++place) {
        OrderListRow row{m_book.queue()[place], {}};
        row.order.id = -(place + 1);
        rows << row;
    }
    m_queue.setRows(rows);
    if (m_book.hasNews() && !m_writer.hasFailed())
        write();
    emit changed();
}

void Orders::check()
{
    const auto now = m_controller.now();
    if (!watched() && now - m_readAt >= unwatchedPeriod)
        read();
    const auto sinceWrite = now - m_writtenAt;
    const bool isDue = m_book.hasNews() ? !m_writer.hasFailed() || sinceWrite >= retryDelay
                                        : m_book.hasChanges() && sinceWrite >= writePeriod;
    if (isDue && !m_writer.isWriting())
        write();
}

void Orders::write()
{
    const store::OrderChanges changes = m_writer.write();
    if (changes.isEmpty())
        return;
    m_writtenAt = m_controller.now();
    for (const OrderRow& row : changes.started)
        m_history.add(row);
    m_offers.update();
}

bool Orders::takeEntry(qsizetype place)
{
    if (!m_controller.accessCheck().require(Level::Operator))
        return false;
    return insert(place, m_entry.order(), m_entry.problem());
}

bool Orders::insert(qsizetype place, const OrderRow& order, QString problem, const QString& signer)
{
    if (problem.isEmpty() && m_book.queue().size() >= OrderBook::maxQueued)
        problem = tr("The queue is full: %1 orders wait. Start or remove one first.")
                      .arg(QString::number(OrderBook::maxQueued));
    if (problem.isEmpty() && !m_book.isBegun())
        problem = tr("The panel's database is not open yet. Try again.");
    showMessage(problem);
    if (!problem.isEmpty())
        return false;
    m_book.insert(place, order);
    store::AuditEntry entry = entryOf(u"order.add"_s, order);
    if (!signer.isEmpty())
        entry.after += u", signed by "_s + signer;
    emit noted(entry);
    update();
    return true;
}

void Orders::addOffered(int row)
{
    if (!m_controller.accessCheck().require(Level::Operator))
        return;
    if (const auto offered = m_offers.orderAt(row))
        (void)insert(m_book.queue().size(), offered->order, {}, offered->signer);
}

bool Orders::add()
{
    return takeEntry(m_book.queue().size());
}

bool Orders::addAndStart()
{
    if (!m_controller.accessCheck().require(Level::Operator))
        return false;
    if (!canBegin(m_entry.order()) || !takeEntry(0))
        return false;
    start(0);
    return true;
}

bool Orders::isRowOfQueue(int row) const
{
    return row >= 0 && row < m_book.queue().size();
}

bool Orders::isForOther(const OrderRow& order) const
{
    return !order.recipe.isEmpty() && !store::isSameName(order.recipe, program().recipe);
}

bool Orders::canBegin(const OrderRow& order)
{
    m_wantedRecipe = isForOther(order) ? order.recipe : QString();
    showMessage(startRefusal(order));
    return m_message.isEmpty();
}

QString Orders::startRefusal(const OrderRow& order) const
{
    if (!m_controller.isConnected())
        return tr("There is no connection to the controller.");
    if (!tooOldText().isEmpty())
        return tooOldText();
    if (!offered())
        return tr("The controller has no program for a packing machine. Download a recipe first.");
    if (!m_status)
        return tr("The controller's order is being read. Try again.");
    if (m_status->state == OrderState::Active)
        return tr("An order is under way. End it first.");
    if (isForOther(order))
        return tr("This order is for %1, and the controller has %2. Download %1 first.", "recipes")
            .arg(order.recipe, program().recipe);
    return {};
}

void Orders::start(int row)
{
    if (!m_controller.accessCheck().require(Level::Operator) || !isRowOfQueue(row) || m_isSending)
        return;
    if (!canBegin(m_book.queue()[row]))
        return;
    m_isSending = true;
    // The number tells an order from the one before it.
    const bool isLast = m_status->number == std::numeric_limits<std::uint16_t>::max();
    m_book.announce(row, isLast ? 1 : m_status->number + 1, m_controller.accessCheck().person());
    const OrderRow order = m_book.queue()[row];
    update();
    m_records.store().run(
        this, [](store::Database&) { return true; }, // behind the announcement
        [this, order](bool) { send(order); });
}

void Orders::send(const OrderRow& order)
{
    const auto number = static_cast<std::uint16_t>(order.number);
    m_controller.link().request({0,
                                 modbus::Command::OrderStart,
                                 {number, static_cast<std::uint16_t>(order.action),
                                  static_cast<std::uint32_t>(order.quantity), order.lot.toStdString()}},
                                {this, [this, order](const link::CommandOutcome& outcome) {
                                     using End = link::CommandEnd;
                                     if (outcome.end != End::Done && outcome.end != End::OutcomeUnknown)
                                         m_book.withdraw(order.number);
                                     takeOutcome(entryOf(u"command.order"_s, order), outcome);
                                 }});
}

void Orders::end()
{
    if (!m_controller.accessCheck().require(Level::Operator) || !m_book.isUnderWay() || m_isSending)
        return;
    const OrderRow order = *m_book.last();
    m_isSending = true;
    m_controller.link().request({0, modbus::Command::OrderEnd, {static_cast<std::uint16_t>(order.number)}},
                                {this, [this, order](const link::CommandOutcome& outcome) {
                                     store::AuditEntry entry = entryOf(u"command.order_end"_s, order);
                                     entry.after = OrderWords::progress(order);
                                     takeOutcome(entry, outcome);
                                 }});
}

void Orders::takeOutcome(const store::AuditEntry& entry, const link::CommandOutcome& outcome)
{
    m_isSending = false;
    showMessage(ConnectionSentences::command(outcome));
    store::AuditEntry ended = entry;
    ended.outcome = ConnectionSentences::outcomeKey(outcome);
    emit noted(ended);
    update();
    read();
}

void Orders::remove(int row)
{
    if (!m_controller.accessCheck().require(Level::Operator) || !isRowOfQueue(row) || m_isSending)
        return;
    emit noted(entryOf(u"order.remove"_s, m_book.queue()[row]));
    m_book.remove(row);
    showMessage({});
    update();
}

void Orders::raise(int row)
{
    if (!m_controller.accessCheck().require(Level::Operator) || !isRowOfQueue(row) || row == 0 || m_isSending)
        return;
    m_book.raise(row);
    showMessage({});
    update();
}

void Orders::setCheckedBy(const QString& name)
{
    if (!m_controller.accessCheck().require(Level::Operator) || !m_book.last() || m_isBeginning)
        return;
    showMessage(m_entry.textProblem(name));
    if (!m_message.isEmpty())
        return;
    store::AuditEntry entry = entryOf(u"order.check"_s, *m_book.last());
    entry.before = m_book.last()->checkedBy;
    entry.after = name.trimmed();
    m_book.setCheckedBy(name.trimmed());
    emit noted(entry);
    update();
}

void Orders::clearMessage()
{
    showMessage({});
}

void Orders::dismissNotice()
{
    showNotice({});
}

void Orders::showMessage(const QString& text)
{
    if (std::exchange(m_message, text) != text)
        emit changed();
}

void Orders::showNotice(const QString& text)
{
    if (std::exchange(m_notice, text) != text)
        emit noticeChanged();
}

} // namespace campanel::panel
