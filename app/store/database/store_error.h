// SPDX-License-Identifier: Apache-2.0
// What kept the database from doing what was asked.
#pragma once

#include <QCoreApplication>
#include <QString>

namespace campanel::store {

struct StoreError {
    enum class Kind {
        CannotOpen,  // `detail` is the system's reason
        NewerSchema, // written by a newer version of this program
        Damaged,
        InUse,      // by another program
        PinsLost,   // the panel had users, and there are none; `path` is the setup marker
        Full,       // no room on the disk
        ReadOnly,   // the disk or the file
        TrendsAnew, // bags and trends were damaged and begin anew; `detail` is where the damaged file is
        Refused,    // by a rule of the tables; `detail` says which
        Failed      // `detail` is the database's sentence
    };

    Kind kind = Kind::Failed;
    QString path;
    QString detail;
};

class StoreErrorText {
    Q_DECLARE_TR_FUNCTIONS(StoreErrorText)

public:
    // One or two sentences in the language of the program: what is wrong and what to do. Nothing that was
    // confirmed before is lost by any of them.
    [[nodiscard]] static QString describe(const StoreError& error);
};

} // namespace campanel::store
