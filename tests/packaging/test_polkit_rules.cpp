// SPDX-License-Identifier: Apache-2.0
// packaging/kiosk/60-campanel.rules in a JavaScript engine, as polkit runs it: what is not listed is refused.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QJSEngine>
#include <QRegularExpression>

namespace test_polkit_rules {

using namespace Qt::StringLiterals;

namespace {

const QString manageUnits = u"org.freedesktop.systemd1.manage-units"_s;
const QStringList allowed = {
    u"org.freedesktop.timedate1.set-time"_s,
    u"org.freedesktop.timedate1.set-timezone"_s,
    u"org.freedesktop.timedate1.set-ntp"_s,
    u"org.freedesktop.NetworkManager.settings.modify.system"_s,
    u"org.freedesktop.NetworkManager.network-control"_s,
    u"org.freedesktop.NetworkManager.checkpoint-rollback"_s,
};

// Some of the actions that systemd and other services allow to everybody, or to everybody at the screen, and
// those of the packages on this computer.
QStringList otherActions()
{
    static const QRegularExpression action(u"<action id=\"([^\"]+)\""_s);
    QStringList actions = {
        u"org.freedesktop.login1.set-self-linger"_s,
        u"org.freedesktop.login1.set-user-linger"_s,
        u"org.freedesktop.login1.inhibit-block-shutdown"_s,
        u"org.freedesktop.login1.inhibit-delay-sleep"_s,
        u"org.freedesktop.login1.power-off"_s,
        u"org.freedesktop.login1.reboot"_s,
        u"org.freedesktop.login1.chvt"_s,
        u"org.freedesktop.login1.lock-sessions"_s,
        u"org.freedesktop.machine1.shell"_s,
        u"org.freedesktop.portable1.attach-images"_s,
        u"org.freedesktop.resolve1.register-service"_s,
        u"org.freedesktop.systemd1.manage-unit-files"_s,
        u"org.freedesktop.systemd1.set-environment"_s,
        u"org.freedesktop.systemd1.reload-daemon"_s,
        u"org.freedesktop.systemd1.reply-password"_s,
        u"org.freedesktop.hostname1.set-hostname"_s,
        u"org.freedesktop.timedate1.set-local-rtc"_s,
        u"org.freedesktop.NetworkManager.settings.modify.hostname"_s,
        u"org.freedesktop.NetworkManager.settings.modify.own"_s,
        u"org.freedesktop.NetworkManager.reload"_s,
        u"org.freedesktop.udisks2.filesystem-mount"_s,
        u"org.freedesktop.udisks2.loop-setup"_s,
        u"org.freedesktop.packagekit.package-install"_s,
        u"org.freedesktop.policykit.exec"_s,
        u"an.action.of.tomorrow"_s,
        manageUnits,
    };
    const QDir folder(u"/usr/share/polkit-1/actions"_s);
    for (const QString& name : folder.entryList({u"*.policy"_s}, QDir::Files)) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::ReadOnly))
            continue;
        const QString text = QString::fromUtf8(file.readAll());
        for (const QRegularExpressionMatch& match : action.globalMatch(text)) {
            if (!allowed.contains(match.captured(1)))
                actions << match.captured(1);
        }
    }
    actions.removeDuplicates();
    return actions;
}

} // namespace

class TestPolkitRules : public QObject {
    Q_OBJECT

    QJSEngine m_engine;

    // Returns "YES", "NO", or "NOT_HANDLED", in which case the defaults of the action hold.
    QString answer(const QString& user, const QString& action, const QString& unit = {},
                   const QString& verb = {})
    {
        return m_engine.globalObject().property(u"answer"_s).call({user, action, unit, verb}).toString();
    }

private slots:
    void initTestCase()
    {
        const auto run = [this](const QString& text) {
            const QJSValue result = m_engine.evaluate(text);
            QVERIFY2(!result.isError(), qPrintable(result.toString()));
        };
        // As polkit's own rules work: the first answer counts.
        run(uR"(var rules = [];
            var polkit = { Result: { YES: "YES", NO: "NO", NOT_HANDLED: "NOT_HANDLED" }, addRule: function (rule) { rules.push(rule); } };
            function answer(user, id, unit, verb) {
                var details = { unit: unit || undefined, verb: verb || undefined };
                var action = { id: id, lookup: function (key) { return details[key]; } };
                var subject = { user: user, groups: [user], active: true, local: true, isInGroup: function () { return true; } };
                for (var i = 0; i < rules.length; ++i) {
                    var result = rules[i](action, subject);
                    if (result && result !== "NOT_HANDLED")
                        return result;
                }
                return "NOT_HANDLED";
            })"_s);
        QFile file(campanel::test::sourcePath("packaging/kiosk/60-campanel.rules"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        run(QString::fromUtf8(file.readAll()));
    }

    void whatIsListedIsTheKiosksAlone()
    {
        for (const QString& action : allowed) {
            QCOMPARE(answer(u"campanel"_s, action), u"YES"_s);
            QCOMPARE(answer(u"campanel-gateway"_s, action), u"NO"_s);
            QCOMPARE(answer(u"technician"_s, action), u"NOT_HANDLED"_s);
        }
    }

    void everythingElseIsRefused()
    {
        for (const QString& action : otherActions()) {
            for (const QString& user : {u"campanel"_s, u"campanel-gateway"_s})
                QVERIFY2(answer(user, action) == u"NO"_s, qPrintable(user + u": "_s + action));
            for (const QString& user : {u"technician"_s, u"root"_s, u"campanel2"_s})
                QVERIFY2(answer(user, action) == u"NOT_HANDLED"_s, qPrintable(user + u": "_s + action));
        }
    }

    void twoUnitsAreStarted()
    {
        for (const QString& unit : {u"campanel-update.service"_s, u"campanel-touch.service"_s}) {
            QCOMPARE(answer(u"campanel"_s, manageUnits, unit, u"start"_s), u"YES"_s);
            QCOMPARE(answer(u"campanel-gateway"_s, manageUnits, unit, u"start"_s), u"NO"_s);
            for (const QString& verb : {u"stop"_s, u"restart"_s, u"kill"_s, u"set-property"_s, u""_s})
                QCOMPARE(answer(u"campanel"_s, manageUnits, unit, verb), u"NO"_s);
        }
        for (const QString& unit :
             {u"campanel-kiosk.service"_s, u"user@997.service"_s, u"run-1.service"_s, u""_s})
            QCOMPARE(answer(u"campanel"_s, manageUnits, unit, u"start"_s), u"NO"_s);
    }
};

CAMPANEL_TEST(TestPolkitRules)

} // namespace test_polkit_rules

#include "test_polkit_rules.moc"
