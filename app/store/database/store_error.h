// SPDX-License-Identifier: Apache-2.0
// The reason why a request to the database failed.
#pragma once

#include <QCoreApplication>
#include <QString>

namespace campanel::store {

struct StoreError {
    enum class Kind {
        CannotOpen,  // `detail` is the system's reason
        NewerSchema, // written by a newer version of this program
        Damaged,
        Foreign,     // `detail` is what is in it and not CamPanel's, as "trigger x"
        DiskLost,    // the disk for the data is not there; `detail` is what the boot says
        InUse,       // used by another program
        PinsLost,    // the panel had users, and there are none; `path` is the setup marker
        Full,        // no room on the disk
        ReadOnly,    // the disk or the file is read-only
        TrendsAnew,  // bags and trends were damaged and start empty; `detail` is the path of the damaged file
        LastVersion, // `detail` is the recipe, which has the last number that a version can have
        Refused,     // by a rule of the tables, see `detail`
        Failed       // `detail` is the database's message
    };

    Kind kind = Kind::Failed;
    QString path;
    QString detail;
};

class StoreErrorText {
    Q_DECLARE_TR_FUNCTIONS(StoreErrorText)

public:
    // Returns one or two sentences in the language of the program: what is wrong and what to do. No error
    // loses confirmed data.
    [[nodiscard]] static QString describe(const StoreError& error);
};

} // namespace campanel::store
