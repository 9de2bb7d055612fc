// SPDX-License-Identifier: Apache-2.0
// campanelctl as a person calls it: the real program, what it prints, its one line of complaint and its exit
// code.
#pragma once

#include "tests/support/places.h"

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>
#include <QProcess>
#include <QStringList>

namespace campanel::test {

// As its manual page has them.
enum Code { Ok = 0, Refused = 1, Usage = 2, Link = 3, File = 4 };

struct Result {
    int code = -1; // also of a program that crashed or did not end
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

// Arguments without spaces.
inline Result call(const QString& words)
{
    return call(words.split(u' ', Qt::SkipEmptyParts));
}

} // namespace campanel::test
