// SPDX-License-Identifier: Apache-2.0
// The files that a machine builder puts into the folder `campanel` of the image's first partition; see
// docs/installing.md. The boot takes what this check finds good, see packaging/card.
#pragma once

#include <QList>
#include <QString>

namespace campanel::shell {

struct CardFile {
    QString name;  // below the folder: "recipes/biscuit.json"
    QString error; // one sentence; empty: it is good
};

// Checks every file of the folder, in the order of the names. A file that nothing takes is an error too.
[[nodiscard]] QList<CardFile> checkCard(const QString& folder);

// Prints a line per file, its name, a tab, and "ok" or the error. Returns the exit code: 0 when all are good.
[[nodiscard]] int printCard(const QString& folder);

} // namespace campanel::shell
