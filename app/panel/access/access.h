// SPDX-License-Identifier: Apache-2.0
// `Access` in QML: the person at the panel and their permissions. Nothing is restricted until a first PIN is
// set. Viewing and Stop never need a login.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/access_check.h"
#include "app/panel/kit/singleton.h"
#include "app/store/users/user_store.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <optional>

namespace campanel::panel {

class Controller;
class DatabaseService;
class Settings;

class Access : public QObject, public Singleton<Access> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    // The level of the person at the panel.
    Q_PROPERTY(Level level READ level NOTIFY changed FINAL)
    Q_PROPERTY(QString levelText READ levelText NOTIFY changed FINAL)
    Q_PROPERTY(QString userName READ userName NOTIFY changed FINAL) // empty: nobody is logged in
    Q_PROPERTY(bool loggedIn READ loggedIn NOTIFY changed FINAL)
    Q_PROPERTY(bool protectedByPins READ protectedByPins NOTIFY changed FINAL)
    // True when the users cannot be read: nobody can log in, and refusalText() says why.
    Q_PROPERTY(bool locked READ locked NOTIFY changed FINAL)

    // A list of {id, name, level, levelText, current}, sorted by name.
    Q_PROPERTY(QVariantList users READ users NOTIFY changed FINAL)
    // The levels that a user may have: a list of {key, text, note}.
    Q_PROPERTY(QVariantList levels READ levels NOTIFY changed FINAL)

    // True while a PIN is checked or the users are changed.
    Q_PROPERTY(bool busy READ busy NOTIFY busyChanged FINAL)
    // The result of the last login or change; empty when there is none.
    Q_PROPERTY(QString message READ message NOTIFY messageChanged FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY messageChanged FINAL)
    // The user selected for login, 0: none; and the waiting time after wrong PINs.
    Q_PROPERTY(int chosen READ chosen WRITE choose NOTIFY chosenChanged FINAL)
    Q_PROPERTY(bool waits READ waits NOTIFY chosenChanged FINAL)
    Q_PROPERTY(QString waitText READ waitText NOTIFY chosenChanged FINAL)

public:
    enum Level { Viewer, Operator, Technician, Service };
    Q_ENUM(Level)

    // An action on users and logins, for the audit trail; `object` is the user's name.
    struct Event {
        QString what;
        QString object;
        QString before;
        QString after;
        QString outcome = QStringLiteral("done");
    };

    using WallClock = std::function<qint64()>; // ms since 1970 UTC

    // All arguments must outlive the object.
    Access(DatabaseService& records, Controller& controller, Settings& settings, QObject* parent);
    ~Access() override;

    // Reads the users; until then nobody has more rights than an operator. Before open() nothing is
    // restricted.
    void open();
    // Sets a clock for tests. The idle time of the panel uses the Controller's clock.
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }
    // Logs out a user who has been idle for too long; runs once a second.
    void checkClock();

    // Returns true when the person at the panel has that level; otherwise emits loginRequested().
    Q_INVOKABLE bool ask(int level);
    [[nodiscard]] Q_INVOKABLE QString refusalText(int level) const;
    [[nodiscard]] Q_INVOKABLE QString permissionText(int level) const;
    // Returns why a user of that level cannot choose this PIN; empty when they can.
    [[nodiscard]] Q_INVOKABLE QString pinRefusal(const QString& pin, int level) const;
    [[nodiscard]] Q_INVOKABLE int minPinDigits(int level) const;
    // Returns why the name is not valid for another user; empty when it is.
    [[nodiscard]] Q_INVOKABLE QString nameRefusal(const QString& name) const;
    // Returns a free name: "Technician 2".
    [[nodiscard]] Q_INVOKABLE QString freeName(int level) const;

    // Logs in the chosen user. Ends in loggedIn or in a message, busy until then.
    Q_INVOKABLE void login(const QString& pin);
    Q_INVOKABLE void logOut();
    Q_INVOKABLE void clearMessage();

    // Changes the users, for the level Service; all end in a message. The first user gets that level and is
    // logged in.
    Q_INVOKABLE void addUser(const QString& name, int level, const QString& pin);
    Q_INVOKABLE void changePin(int id, const QString& pin);
    Q_INVOKABLE void changeLevel(int id, int level);
    Q_INVOKABLE void removeUser(int id);

    [[nodiscard]] Level level() const;
    [[nodiscard]] QString levelText() const;
    [[nodiscard]] QString userName() const { return m_user ? m_user->name : QString(); }
    [[nodiscard]] bool loggedIn() const { return m_user.has_value(); }
    [[nodiscard]] bool protectedByPins() const { return !m_users.isEmpty() || locked(); }
    [[nodiscard]] bool locked() const { return m_lock.has_value(); }
    [[nodiscard]] QVariantList users() const;
    [[nodiscard]] QVariantList levels() const;
    [[nodiscard]] bool busy() const { return m_jobs > 0; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool failed() const { return m_isFailed; }
    [[nodiscard]] int chosen() const { return static_cast<int>(m_chosen); }
    void choose(int id);
    [[nodiscard]] bool waits() const { return waitMs() > 0; }
    [[nodiscard]] QString waitText() const;

signals:
    void changed();
    void busyChanged();
    void messageChanged();
    void chosenChanged();
    void loginRequested(int level);
    void loginSucceeded();
    // Emitted after loginSucceeded() when the PIN has fewer digits than the user's level requires today.
    void newPinWanted(int id);
    // Emitted when nobody has touched the panel for the idle time.
    void leftAlone();
    void happened(const campanel::panel::Access::Event& event);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Users = tl::expected<QList<store::User>, store::StoreError>;
    using Change = std::function<tl::expected<void, store::StoreError>(store::Database&)>;

    [[nodiscard]] panel::Level currentLevel() const;
    [[nodiscard]] qint64 waitMs() const;
    [[nodiscard]] const store::User* find(qint64 id) const;
    [[nodiscard]] QVariantMap entry(const store::User& user) const;
    [[nodiscard]] bool isLastService(const store::User& user) const;
    void takeUsers(const Users& users);
    void takeAttempt(const tl::expected<store::LoginAttempt, store::StoreError>& attempt, const QString& pin);
    struct Verdict {
        bool isRight = false;
        bool isShort = false;               // for the user's level
        std::optional<QString> renewedHash; // when the stored hash was made with less effort
    };
    void takeVerdict(const store::User& user, const Verdict& verdict);
    void admit(const store::User& user);
    void leave(const QString& what);
    void update();
    // Hashes in a thread of its own and calls `then` in this one.
    void hash(const QString& pin, std::function<void(const QString& hash)> then);
    void apply(Change change, const Event& event, const QString& done);
    void begin();
    void end();
    void showMessage(const QString& message, bool isFailed);

    DatabaseService& m_records;
    Controller& m_controller;
    Settings& m_settings;
    WallClock m_wallClock;
    bool m_isOpened = false;
    bool m_isLoaded = false;
    std::optional<store::StoreError> m_lock; // reason why the users cannot be read
    QList<store::User> m_users;
    std::optional<store::User> m_user; // logged in
    qint64 m_chosen = 0;
    int m_jobs = 0;
    QString m_message;
    bool m_isFailed = false;
    link::SteadyTime m_touchedAt;
    QTimer m_idleTimer;
    QTimer m_waitTimer;
    QThreadPool m_pool; // one thread; the destructor waits for it
};

} // namespace campanel::panel
