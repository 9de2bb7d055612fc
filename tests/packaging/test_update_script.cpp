// SPDX-License-Identifier: Apache-2.0
// packaging/kiosk/campanel-update and campanel-touch in a folder. Whatever the panel's user does meanwhile,
// what is installed is what was checked, nothing outside its own data changes, and the data are whole in the
// end.
#include "script_root.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>

#include <memory>

namespace test_update_script {

using namespace Qt::StringLiterals;
using campanel::test::ScriptRoot;

namespace {

QByteArray package(const QByteArray& version)
{
    return "Package: campanel\nVersion: " + version + "\nArchitecture: amd64\nInstalled-Size: 1\n";
}

} // namespace

class TestUpdateScript : public QObject {
    Q_OBJECT

    std::unique_ptr<ScriptRoot> m_root;

    const QString data = u"var/lib/campanel/"_s;
    const QString home = u"var/lib/campanel-update/"_s;

    void runUpdate()
    {
        const QString script = campanel::test::sourcePath("packaging/kiosk/campanel-update");
        QVERIFY(m_root->run(script, u"CAMPANEL_UPDATE_ROOT"_s));
    }
    // Prepares an update from 2.0 to 3.0 as the panel does.
    void requestUpdate()
    {
        m_root->write(u"run/campanel/update-request"_s, "update\n");
        m_root->write(data + u"update/package.deb"_s, package("3.0"));
        m_root->write(data + u"update/package.deb.sig"_s, "signed");
    }
    // Prepares the way back from 2.0 to 1.0, which reads other data.
    void requestBack()
    {
        m_root->write(u"run/campanel/update-request"_s, "back\n");
        m_root->write(home + u"way-back"_s,
                      "{\n \"version\": \"1.0\",\n \"over\": \"2.0\",\n \"schema\": \"1\"\n}\n");
        m_root->write(home + u"packages/campanel_1.0_amd64.deb"_s, package("1.0"));
        m_root->write(home + u"data-1.0/aaa"_s, "old");
        m_root->write(home + u"data-1.0/data/recipes"_s, "old");
    }
    QByteArray dataVersion()
    {
        const QByteArray all = m_root->read(data + u"aaa"_s) + ' ' + m_root->read(data + u"data/recipes"_s);
        return all == "old old" ? "1.0" : all == "new new" ? "2.0" : "neither: " + all;
    }
    QByteArray outcome(const QByteArray& key)
    {
        const QRegularExpression pair(u"\"%1\": \"(.*)\""_s.arg(QString::fromLatin1(key)));
        return pair.match(QString::fromUtf8(m_root->read(home + u"outcome"_s))).captured(1).toUtf8();
    }
    QByteArray log() { return m_root->read(u"log"_s); }

private slots:
    void init()
    {
        m_root = std::make_unique<ScriptRoot>();
        m_root->write(u"control/preinst"_s, "CAMPANEL_WAY_BACK");
        m_root->write(u"version"_s, "2.0\n");
        m_root->write(u"opens"_s, {});
        m_root->write(u"outside"_s, "root's");
        m_root->write(u"usr/x"_s, {});
        m_root->write(u"dev/tty1"_s, {});
        m_root->write(home + u"packages/campanel_2.0_amd64.deb"_s, package("2.0"));
        m_root->write(data + u"aaa"_s, "new");
        m_root->write(data + u"data/recipes"_s, "new");
    }

    void updatesAndGoesBack()
    {
        requestUpdate();
        runUpdate();
        QVERIFY2(outcome("result") == "done", log());
        QCOMPARE(m_root->read(u"version"_s), "3.0\n"_ba);
        QCOMPARE(dataVersion(), "2.0"_ba);
        // As the new version has changed them; what has come meanwhile goes away again.
        m_root->write(data + u"aaa"_s, "newer");
        m_root->write(data + u"data/recipes"_s, "newer");
        m_root->write(data + u"data/more"_s, "newer");
        QByteArray back = m_root->read(home + u"way-back"_s);
        QCOMPARE(back.count("\"schema\": \"2\""), 1);
        m_root->write(home + u"way-back"_s, back.replace("\"schema\": \"2\"", "\"schema\": \"1\""));
        m_root->write(u"run/campanel/update-request"_s, "back\n");
        runUpdate();
        QVERIFY2(outcome("result") == "done" && outcome("data") == "restored", log());
        QCOMPARE(m_root->read(u"version"_s), "2.0\n"_ba);
        QCOMPARE(dataVersion(), "2.0"_ba);
        QVERIFY(!m_root->exists(data + u"data/more"_s));
        QVERIFY(!m_root->exists(data + u"update/package.deb"_s));
    }

    void aVersionThatDoesNotOpenIsPutBackWithItsData()
    {
        requestUpdate();
        QVERIFY(QFile::remove(m_root->path(u"opens"_s)));
        runUpdate();
        QVERIFY2(outcome("result") == "returned" && outcome("reason") == "not-shown", log());
        QCOMPARE(m_root->read(u"version"_s), "2.0\n"_ba);
        QCOMPARE(dataVersion(), "2.0"_ba);
    }

    // A folder on a partition of its own cannot be renamed; it is emptied and filled by the panel's user.
    void dataOnTheirOwnPartitionArePutBack()
    {
        requestBack();
        m_root->write(u"mounted"_s, {});
        runUpdate();
        QVERIFY2(outcome("result") == "done" && outcome("data") == "restored", log());
        QCOMPARE(dataVersion(), "1.0"_ba);
        QVERIFY(!m_root->read(u"calls"_s).contains("campanel.new"));
    }

    void thePanelsUserHoldsNoFileOfRoot()
    {
        requestUpdate();
        runUpdate();
        QVERIFY2(outcome("result") == "done", log());
        QVERIFY(m_root->read(u"descriptors"_s).contains("package.deb"));
        QCOMPARE(m_root->writableFiles(), QByteArrayList());
        QCOMPARE(m_root->read(u"modes"_s), "700\n600\n"_ba);
        // The file with the copied data has hashes of PINs.
        const auto permissions = QFile::permissions(m_root->path(home + u"data-2.0"_s));
        QVERIFY(!(permissions & (QFile::ReadGroup | QFile::ReadOther)));
    }

    void campanelTouchLendsNoFileOfRoot()
    {
        m_root->write(u"run/campanel/touch-request"_s, "none\n");
        QVERIFY(m_root->run(campanel::test::sourcePath("packaging/kiosk/campanel-touch"),
                            u"CAMPANEL_TOUCH_ROOT"_s));
        QVERIFY2(log().contains("calibration: none"), log());
        QVERIFY(m_root->read(u"calls"_s)
                    .contains("setpriv --reuid=campanel --regid=campanel --clear-groups --no-new-privs"));
        QCOMPARE(m_root->writableFiles(), QByteArrayList());
    }

    void whatIsInstalledIsWhatWasChecked()
    {
        requestUpdate();
        m_root->write(u"attack"_s, {});
        runUpdate();
        QVERIFY2(!m_root->read(u"verified"_s).isEmpty(), log());
        if (outcome("result") == "done")
            QCOMPARE(m_root->read(u"installed"_s), m_root->read(u"verified"_s));
        else
            QCOMPARE(outcome("result") + ' ' + outcome("reason"), "refused package"_ba);
    }

    void aLinkAmongTheDataChangesNothingElse_data()
    {
        QTest::addColumn<bool>("isBack");
        QTest::newRow("way back") << true;
        QTest::newRow("version that does not open") << false;
    }
    void aLinkAmongTheDataChangesNothingElse()
    {
        QFETCH(bool, isBack);
        if (isBack) {
            requestBack();
        } else {
            requestUpdate();
            QVERIFY(QFile::remove(m_root->path(u"opens"_s)));
        }
        const auto before = QFile::permissions(m_root->path(u"outside"_s));
        m_root->write(u"plant"_s, {});
        runUpdate();
        QVERIFY2(!outcome("result").isEmpty(), log());
        QCOMPARE(m_root->read(u"outside"_s), "root's"_ba);
        QCOMPARE(QFile::permissions(m_root->path(u"outside"_s)), before);
    }

    void everyProcessOfThePanelsUserEndsFirst()
    {
        requestBack();
        QProcess left;
        left.start(u"sh"_s, {u"-c"_s, u"trap '' TERM HUP; exec sleep 600"_s});
        QVERIFY(left.waitForStarted());
        m_root->write(u"process"_s, QByteArray::number(left.processId()));
        runUpdate();
        QVERIFY2(outcome("result") == "done", log());
        QVERIFY(left.waitForFinished());
        const QByteArray calls = m_root->read(u"calls"_s);
        const auto stop = calls.indexOf("systemctl stop campanel-kiosk.service");
        const auto linger = calls.indexOf("loginctl disable-linger campanel");
        const auto terminate = calls.indexOf("loginctl terminate-user campanel");
        const auto kill = calls.indexOf("pkill -KILL -U campanel");
        const auto copy = calls.indexOf("tar -C");
        QVERIFY2(stop >= 0 && stop < linger && linger < terminate && terminate < kill && kill < copy, calls);
    }

    void aProcessThatDoesNotEndIsAReasonToRefuse()
    {
        requestBack();
        m_root->write(u"stays"_s, {});
        runUpdate();
        QVERIFY2(outcome("result") + ' ' + outcome("reason") == "refused processes", log());
        QCOMPARE(m_root->read(u"version"_s), "2.0\n"_ba);
        QCOMPARE(dataVersion(), "2.0"_ba);
        QVERIFY(
            m_root->read(u"calls"_s).trimmed().contains("systemctl --no-block start campanel-kiosk.service"));
        QVERIFY(!m_root->exists(home + u"installing"_s));
    }

    // The script is killed at each of its steps and started again, as at the next boot.
    void aPowerCutAtAnyStepEndsInWholeData()
    {
        for (int killAt = 1;; ++killAt) {
            init();
            requestBack();
            m_root->write(u"kill-at"_s, QByteArray::number(killAt));
            runUpdate();
            const QByteArray steps = m_root->read(u"steps"_s).trimmed();
            const QByteArray tag =
                "killed at step " + QByteArray::number(killAt) + ", data " + dataVersion() + "\n";
            // The kiosk opens only without this file.
            if (!m_root->exists(home + u"installing"_s))
                QVERIFY2(!dataVersion().startsWith("neither"), tag + log());
            if (steps.toInt() < killAt) {
                QVERIFY2(outcome("result") == "done", log());
                QVERIFY(killAt > 15);
                return;
            }
            const QByteArray first = log();
            QVERIFY(QFile::remove(m_root->path(u"kill-at"_s)));
            runUpdate();
            QVERIFY2(dataVersion() == m_root->read(u"version"_s).trimmed(), tag + first + log());
            QVERIFY2(!m_root->exists(home + u"unfinished"_s) && !m_root->exists(home + u"installing"_s),
                     tag + log());
            QCOMPARE(QDir(m_root->path(u"var/lib"_s)).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                     (QStringList{u"campanel"_s, u"campanel-update"_s}));
        }
    }
};

CAMPANEL_TEST(TestUpdateScript)

} // namespace test_update_script

#include "test_update_script.moc"
