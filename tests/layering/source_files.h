// SPDX-License-Identifier: Apache-2.0
// The source files of the project, for tests that read them.
#pragma once

#include "tests/support/places.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QStringList>

namespace campanel::test {

// Returns the files below these folders, sorted, relative to the top folder.
inline QStringList filesBelow(const QStringList& folders, const QStringList& patterns)
{
    const QDir root(campanel::test::sourcePath("."));
    QStringList result;
    for (const QString& folder : folders) {
        QDirIterator it(root.filePath(folder), patterns, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext())
            result << root.relativeFilePath(it.next());
    }
    result.sort();
    return result;
}

inline QString textOf(const QString& relativePath)
{
    QFile file(QDir(campanel::test::sourcePath(".")).filePath(relativePath));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace campanel::test
