// SPDX-License-Identifier: Apache-2.0
// A folder in which a script of packaging/kiosk runs as on a panel PC, with stand-ins of the programs that
// change the system. The stand-in of setpriv changes no user: it records what the panel's user would hold
// open.
#pragma once

#include "tests/support/places.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <unistd.h>

namespace campanel::test {

class ScriptRoot {
    QTemporaryDir m_folder;

public:
    ScriptRoot()
    {
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("bin")));
        for (const char* name :
             {"apt-get", "blockdev", "busctl",     "campanelctl", "chown", "cp",         "dd",
              "dpkg",    "dpkg-deb", "dpkg-query", "loginctl",    "mkdir", "mountpoint", "mv",
              "pgrep",   "pkill",    "setpriv",    "sleep",       "sync",  "systemctl",  "tar"}) {
            QVERIFY(QFile::link(sourcePath("tests/packaging/stand_in"),
                                path(QStringLiteral("bin/") + QLatin1String(name))));
        }
    }

    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QDir().mkpath(QFileInfo(path(name)).path());
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    [[nodiscard]] QByteArray read(const QString& name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] bool exists(const QString& name) const { return QFileInfo::exists(path(name)); }

    // Runs a script of packaging/kiosk until all its processes have ended. Its process group is in the file
    // `group`.
    [[nodiscard]] bool run(const QString& script, const QString& rootVariable) const
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("PATH"),
                           path(QStringLiteral("bin")) + u':' + environment.value(QStringLiteral("PATH")));
        environment.insert(rootVariable, m_folder.path());
        environment.insert(QStringLiteral("T"), m_folder.path());
        process.setProcessEnvironment(environment);
        process.setStandardOutputFile(path(QStringLiteral("log")));
        // A test runner may lend its own files, such as its log.
        process.setChildProcessModifier([] { close_range(3, ~0u, CLOSE_RANGE_CLOEXEC); });
        // cat ends when the last process that can write into the pipe has ended.
        process.start(QStringLiteral("sh"),
                      {QStringLiteral("-c"),
                       QStringLiteral(
                           "setsid sh -c 'echo $$ >\"$1\"; exec \"$0\"' \"$0\" \"$1\" </dev/null 2>&1 | cat"),
                       script, path(QStringLiteral("group"))});
        return process.waitForFinished(60'000);
    }

    // Returns the descriptors that the panel's user could write into and that are neither pipes nor
    // /dev/null.
    [[nodiscard]] QByteArrayList writableFiles() const
    {
        QByteArrayList lines = read(QStringLiteral("descriptors")).split('\n');
        lines.removeIf([](const QByteArray& line) {
            return line.isEmpty() || line.contains(" pipe:[") || line.endsWith(" /dev/null");
        });
        return lines;
    }
};

} // namespace campanel::test
