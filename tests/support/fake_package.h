// SPDX-License-Identifier: Apache-2.0
// Packages of CamPanel without content, with a signature beside them, on a stick that is a folder.
#pragma once

#include "app/store/files/files.h"
#include "app/store/update/signed_package.h"

#include <QDir>
#include <QFile>
#include <QProcess>

namespace campanel::test {

inline bool writeFile(const QString& path, const QByteArray& bytes)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

// Returns the path of a new package below `folder`; empty on failure.
inline QString makePackage(const QString& folder, const QString& version,
                           const QString& architecture = QStringLiteral("amd64"),
                           const QString& name = QStringLiteral("campanel"))
{
    const QString tree = folder + QStringLiteral("/tree");
    const QString path = QStringLiteral("%1/%2_%3_%4.deb").arg(folder, name, version, architecture);
    const QString control =
        QStringLiteral("Package: %1\nVersion: %2\nArchitecture: %3\nMaintainer: test <t@t>\n"
                       "Description: test\n")
            .arg(name, version, architecture);
    if (!writeFile(tree + QStringLiteral("/DEBIAN/control"), control.toUtf8()))
        return {};
    QProcess process;
    process.setStandardOutputFile(QProcess::nullDevice());
    process.start(QStringLiteral("dpkg-deb"),
                  {QStringLiteral("--build"), QStringLiteral("--root-owner-group"), QStringLiteral("-Znone"),
                   tree, path});
    const bool isDone = process.waitForFinished() && process.exitCode() == 0;
    QDir(tree).removeRecursively();
    return isDone ? path : QString();
}

constexpr qint64 packageSignedMs = 1'768'300'000'000; // 13 January 2026

// Writes the signature of a package beside it.
inline bool signPackage(const QString& path, const store::SigningKey& key)
{
    const auto signature = store::signPackage(path, packageSignedMs, key);
    return signature && writeFile(store::signaturePath(path), *signature);
}

} // namespace campanel::test
