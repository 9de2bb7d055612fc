// SPDX-License-Identifier: Apache-2.0
// The list of users in Access, and their changes by the level Service.
#include "app/panel/access/access.h"

#include "app/panel/controller/controller.h"
#include "app/panel/records/database_service.h"
#include "app/panel/words/access_sentences.h"
#include "app/store/database/names.h"
#include "app/store/users/pin_hash.h"

#include <QVariantMap>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr int longestName = 24; // limited by the top bar

QString levelKey(store::UserLevel level)
{
    switch (level) {
    case store::UserLevel::Operator:
        return u"operator"_s;
    case store::UserLevel::Technician:
        return u"technician"_s;
    case store::UserLevel::Service:
        break;
    }
    return u"service"_s;
}

bool isUserLevel(int level)
{
    return level >= Access::Operator && level <= Access::Service;
}

} // namespace

QString Access::levelText() const
{
    return AccessSentences::level(m_controller.accessCheck().level());
}

QVariantMap Access::entry(const store::User& user) const
{
    const int level = static_cast<int>(user.level);
    return {{u"id"_s, user.id},
            {u"name"_s, user.name},
            {u"level"_s, level},
            {u"levelText"_s, AccessSentences::level(static_cast<panel::Level>(level))},
            {u"current"_s, m_user && m_user->id == user.id}};
}

QVariantList Access::users() const
{
    QVariantList entries;
    for (const store::User& user : m_users)
        entries << entry(user);
    return entries;
}

QVariantList Access::levels() const
{
    QVariantList entries;
    for (const panel::Level level : {panel::Level::Operator, panel::Level::Technician, panel::Level::Service})
        entries << QVariantMap{{u"key"_s, static_cast<int>(level)},
                               {u"text"_s, AccessSentences::level(level)},
                               {u"note"_s, AccessSentences::permission(level)}};
    return entries;
}

QString Access::refusalText(int level) const
{
    return m_lock ? AccessSentences::locked(*m_lock)
                  : AccessSentences::refusal(static_cast<panel::Level>(level));
}

QString Access::permissionText(int level) const
{
    return AccessSentences::permission(static_cast<panel::Level>(level));
}

QString Access::waitText() const
{
    if (!waits())
        return {};
    return m_isFailed ? AccessSentences::wrongPin(waitMs()) : AccessSentences::mustWait(waitMs());
}

QString Access::pinRefusal(const QString& pin, int level) const
{
    return AccessSentences::pinRefusal(pin, static_cast<panel::Level>(level));
}

int Access::minPinDigits(int level) const
{
    return AccessSentences::minPinDigits(static_cast<panel::Level>(level));
}

QString Access::nameRefusal(const QString& name) const
{
    const QString wanted = store::keptName(name);
    if (wanted.isEmpty() || wanted.size() > longestName)
        return tr("A name has 1 to %1 characters.").arg(longestName);
    if (store::hiddenCharacter(name))
        return tr("The name has characters that nobody can see. Enter the name again.");
    const bool isTaken = std::ranges::any_of(
        m_users, [&](const store::User& user) { return store::isSameName(user.name, wanted); });
    return isTaken ? tr("This name is already in use.") : QString();
}

QString Access::freeName(int level) const
{
    const QString base = AccessSentences::level(static_cast<panel::Level>(level));
    QString name = base;
    for (int i = 2; !nameRefusal(name).isEmpty(); ++i)
        name = u"%1 %2"_s.arg(base, QString::number(i));
    return name;
}

void Access::hash(const QString& pin, std::function<void(const QString& hash)> then)
{
    begin();
    m_pool.start([this, pin, then = std::move(then)] {
        const auto made = store::hashPin(pin);
        QMetaObject::invokeMethod(this, [this, made, then] {
            if (made)
                then(*made);
            else
                showMessage(tr("There is not enough memory to store a PIN safely. Restart the panel."), true);
            end();
        });
    });
}

void Access::apply(Change change, const Event& event, const QString& done)
{
    begin();
    m_records.store().run(
        this, std::move(change), [this, event, done](const tl::expected<void, store::StoreError>& outcome) {
            Event noted = event;
            if (!outcome)
                noted.outcome = u"refused"_s;
            showMessage(outcome ? done : store::StoreErrorText::describe(outcome.error()), !outcome);
            if (outcome)
                m_records.makeCopy(); // the copy must not contain an invalid PIN
            emit happened(noted);
            end();
        });
    begin();
    m_records.store().run(this, &store::users, [this](const Users& users) {
        takeUsers(users);
        end();
    });
}

void Access::addUser(const QString& name, int level, const QString& pin)
{
    const QString wanted = store::keptName(name);
    const bool isFirst = !protectedByPins();
    const QString refusal =
        nameRefusal(name).isEmpty() ? pinRefusal(pin, isFirst ? Service : level) : nameRefusal(name);
    if (!ask(Service) || !isUserLevel(level) || busy())
        return;
    if (!refusal.isEmpty()) {
        showMessage(refusal, true);
        return;
    }
    const auto userLevel = isFirst ? store::UserLevel::Service : static_cast<store::UserLevel>(level);
    hash(pin, [this, wanted, userLevel, isFirst](const QString& made) {
        apply(
            [wanted, userLevel, made](store::Database& database) -> tl::expected<void, store::StoreError> {
                const auto user = store::addUser(database, wanted, userLevel, made);
                return user ? tl::expected<void, store::StoreError>() : tl::unexpected(user.error());
            },
            {u"user.add"_s, wanted, {}, levelKey(userLevel)}, tr("%1 can log in now.").arg(wanted));
        if (isFirst) {
            begin();
            m_records.store().run(this, &store::users, [this](const Users& users) {
                if (users && !users->isEmpty())
                    admit(users->first());
                end();
            });
        }
    });
}

bool Access::isLastService(const store::User& user) const
{
    return user.level == store::UserLevel::Service &&
           std::ranges::count(m_users, store::UserLevel::Service, &store::User::level) == 1;
}

void Access::changePin(int id, const QString& pin)
{
    const store::User* user = find(id);
    if (!ask(Service) || !user || busy())
        return;
    if (const QString refusal = pinRefusal(pin, static_cast<int>(user->level)); !refusal.isEmpty()) {
        showMessage(refusal, true);
        return;
    }
    hash(pin, [this, id, name = user->name](const QString& made) {
        apply([id, made](store::Database& database) { return store::setUserPin(database, id, made); },
              {u"user.pin"_s, name, {}, {}}, tr("%1 has a new PIN.").arg(name));
    });
}

void Access::changeLevel(int id, int level)
{
    const store::User* user = find(id);
    if (!ask(Service) || !user || !isUserLevel(level) || busy())
        return;
    const auto wanted = static_cast<store::UserLevel>(level);
    if (wanted != store::UserLevel::Service && isLastService(*user)) {
        showMessage(tr("At least one user of the level Service must remain."), true);
        return;
    }
    apply([id, wanted](store::Database& database) { return store::setUserLevel(database, id, wanted); },
          {u"user.level"_s, user->name, levelKey(user->level), levelKey(wanted)},
          tr("%1 now has the level %2.")
              .arg(user->name, AccessSentences::level(static_cast<panel::Level>(level))));
}

void Access::removeUser(int id)
{
    const store::User* user = find(id);
    if (!ask(Service) || !user || busy())
        return;
    if (isLastService(*user)) {
        showMessage(tr("At least one user of the level Service must remain."), true);
        return;
    }
    apply([id](store::Database& database) { return store::removeUser(database, id); },
          {u"user.remove"_s, user->name, levelKey(user->level), {}},
          tr("%1 can no longer log in.").arg(user->name));
}

} // namespace campanel::panel
