// SPDX-License-Identifier: Apache-2.0
#include "app/panel/access/access.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/access_sentences.h"
#include "app/store/users/pin_hash.h"

#include <QCoreApplication>
#include <QEvent>

#include <algorithm>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto idlePeriod = 1s;
constexpr auto waitPeriod = 250ms; // a countdown in seconds

} // namespace

Access::Access(DatabaseService& records, Controller& controller, Settings& settings, QObject* parent)
    : QObject(parent)
    , m_records(records)
    , m_controller(controller)
    , m_settings(settings)
    , m_wallClock(&QDateTime::currentMSecsSinceEpoch)
{
    m_pool.setMaxThreadCount(1);
    connect(&controller.accessCheck(), &AccessCheck::refused, this,
            [this](panel::Level needed) { emit loginRequested(static_cast<int>(needed)); });
    connect(&settings, &Settings::changed, this, &Access::update);
    connect(&m_idleTimer, &QTimer::timeout, this, &Access::checkClock);
    m_idleTimer.setInterval(idlePeriod);
    connect(&m_waitTimer, &QTimer::timeout, this, [this] {
        if (!waits())
            m_waitTimer.stop();
        emit chosenChanged();
    });
    m_waitTimer.setInterval(waitPeriod);
    QCoreApplication::instance()->installEventFilter(this);
    LanguageNotifier::follow(this, &Access::clearMessage);
}

Access::~Access()
{
    m_pool.waitForDone();
}

void Access::open()
{
    m_isOpened = true;
    update();
    m_records.store().run(this, &store::users, [this](const Users& users) { takeUsers(users); });
}

void Access::takeUsers(const Users& users)
{
    if (!users) {
        // Nobody is more than an operator then. The unopened database was already reported.
        if (m_isLoaded || users.error().kind == store::StoreError::Kind::PinsLost)
            m_records.reportError(users.error());
        if (!m_isLoaded)
            m_lock = users.error();
        update();
        return;
    }
    m_isLoaded = true;
    m_lock.reset();
    m_users = *users;
    if (m_user) {
        const store::User* kept = find(m_user->id);
        m_user = kept ? std::optional(*kept) : std::nullopt;
    }
    update();
    emit chosenChanged();
}

panel::Level Access::currentLevel() const
{
    const bool isOpenToAll = !m_isOpened || (m_isLoaded && m_users.isEmpty());
    if (isOpenToAll)
        return panel::Level::Service;
    if (m_user)
        return static_cast<panel::Level>(m_user->level);
    return m_settings.values().isTrue("access.operators_log_in") ? panel::Level::Viewer
                                                                 : panel::Level::Operator;
}

void Access::update()
{
    m_controller.accessCheck().setLevel(currentLevel(), userName());
    if (m_user && !m_idleTimer.isActive()) {
        m_touchedAt = m_controller.now();
        m_idleTimer.start();
    } else if (!m_user) {
        m_idleTimer.stop();
    }
    emit changed();
}

Access::Level Access::level() const
{
    return static_cast<Level>(m_controller.accessCheck().level());
}

bool Access::ask(int level)
{
    return m_controller.accessCheck().require(static_cast<panel::Level>(level));
}

void Access::choose(int id)
{
    m_chosen = id;
    if (waits())
        m_waitTimer.start();
    emit chosenChanged();
}

qint64 Access::waitMs() const
{
    const store::User* user = find(m_chosen);
    return user ? store::waitMs(*user, m_wallClock()) : 0;
}

const store::User* Access::find(qint64 id) const
{
    const auto found = std::ranges::find(m_users, id, &store::User::id);
    return found == m_users.end() ? nullptr : &*found;
}

void Access::login(const QString& pin)
{
    if (busy() || !find(m_chosen))
        return;
    begin();
    m_records.store().run(
        this,
        [id = m_chosen, now = m_wallClock()](store::Database& database) {
            return store::beginLogin(database, id, now);
        },
        [this, pin](const tl::expected<store::LoginAttempt, store::StoreError>& attempt) {
            takeAttempt(attempt, pin);
        });
}

void Access::takeAttempt(const tl::expected<store::LoginAttempt, store::StoreError>& attempt,
                         const QString& pin)
{
    if (!attempt) {
        m_records.reportError(attempt.error());
        showMessage(store::StoreErrorText::describe(attempt.error()), true);
        end();
        return;
    }
    const store::User& user = attempt->user;
    if (attempt->pinHash.isEmpty()) {
        emit happened({u"user.login"_s, user.name, {}, {}, u"must_wait"_s});
        choose(chosen());
        end();
        return;
    }
    m_pool.start([this, user, kept = attempt->pinHash, pin] {
        Verdict verdict;
        verdict.isRight = store::isPin(kept, pin);
        if (verdict.isRight && store::isOutdated(kept))
            verdict.renewedHash = store::hashPin(pin);
        verdict.isShort = pin.size() < AccessSentences::minPinDigits(static_cast<panel::Level>(user.level));
        QMetaObject::invokeMethod(this, [this, user, verdict] { takeVerdict(user, verdict); });
    });
}

void Access::takeVerdict(const store::User& user, const Verdict& verdict)
{
    const auto known = std::ranges::find(m_users, user.id, &store::User::id);
    if (!verdict.isRight) {
        if (known != m_users.end())
            *known = user;
        emit happened({u"user.login"_s, user.name, {}, {}, u"wrong_pin"_s});
        showMessage(AccessSentences::wrongPin(0), true);
        choose(chosen());
        end();
        return;
    }
    m_records.store().run(
        this,
        [id = user.id, hash = verdict.renewedHash](store::Database& database) {
            const auto ended = store::endLogin(database, id);
            return ended && hash ? store::renewPinHash(database, id, *hash) : ended;
        },
        [this, user, verdict](const tl::expected<void, store::StoreError>& done) {
            if (!done)
                m_records.reportError(done.error());
            store::User admitted = user;
            admitted.failedAttempts = 0;
            admitted.lockedUntilMs = 0;
            admit(admitted);
            end();
            if (verdict.isShort && m_user && m_user->id == user.id)
                emit newPinWanted(static_cast<int>(user.id));
        });
}

void Access::admit(const store::User& user)
{
    if (m_user && m_user->id != user.id)
        leave(u"user.logout"_s);
    const auto known = std::ranges::find(m_users, user.id, &store::User::id);
    if (known == m_users.end())
        return; // removed in the meantime
    *known = user;
    m_user = user;
    m_touchedAt = m_controller.now();
    update();
    emit happened({u"user.login"_s, user.name, {}, {}});
    showMessage({}, false);
    emit loginSucceeded();
}

void Access::leave(const QString& what)
{
    if (!m_user)
        return;
    emit happened({what, m_user->name, {}, {}});
    m_user.reset();
    update();
}

void Access::logOut()
{
    leave(u"user.logout"_s);
}

void Access::checkClock()
{
    if (!m_user || m_controller.now() - m_touchedAt <
                       std::chrono::minutes(m_settings.values().whole("access.auto_logout_minutes")))
        return;
    leave(u"user.auto_logout"_s);
    emit leftAlone();
}

void Access::begin()
{
    ++m_jobs;
    emit busyChanged();
}

void Access::end()
{
    --m_jobs;
    emit busyChanged();
}

void Access::showMessage(const QString& message, bool isFailed)
{
    m_message = message;
    m_isFailed = isFailed;
    emit messageChanged();
}

void Access::clearMessage()
{
    showMessage({}, false);
}

bool Access::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
    case QEvent::KeyPress:
        m_touchedAt = m_controller.now();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace campanel::panel
