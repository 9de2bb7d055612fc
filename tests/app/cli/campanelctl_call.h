// SPDX-License-Identifier: Apache-2.0
// Calls campanelctl like a person: the real program, its output, its error line and its exit code.
#pragma once

#include "tests/support/places.h"

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>
#include <QProcess>
#include <QStringList>

namespace campanel::test {

// The exit codes of its manual page.
enum Code { Ok = 0, Refused = 1, Usage = 2, Link = 3, File = 4 };

struct Result {
    int code = -1; // also for a program that crashed or did not end
    QByteArray out;
    QByteArray complaint;

    [[nodiscard]] QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
    [[nodiscard]] QList<QByteArray> lines() const { return out.trimmed().split('\n'); }
};

inline Result call(const QStringList& arguments)
{
    QProcess process;
    process.start(campanel::test::programPath("campanelctl"), arguments);
    constexpr int longestMs = 60'000;
    if (!process.waitForFinished(longestMs))
        return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

// Calls it with arguments without spaces.
inline Result call(const QString& words)
{
    return call(words.split(u' ', Qt::SkipEmptyParts));
}

} // namespace campanel::test
