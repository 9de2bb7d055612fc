// SPDX-License-Identifier: Apache-2.0
// Compares what is in a database with what the steps of its schema make. Nothing else may be in it: a trigger
// or a view from elsewhere would change what the panel reads and writes.
#include "app/store/database/database.h"

#include <QMap>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

// The statement of each object, such as "trigger x"; empty for the index of a constraint.
using Objects = QMap<QString, QString>;

tl::expected<Objects, StoreError> objectsIn(Database& database)
{
    auto found = database.execute(u"SELECT type, name, tbl_name, sql FROM sqlite_master"_s);
    if (!found)
        return tl::unexpected(found.error());
    Objects objects;
    while (found->next()) {
        const QString name = found->value(0).toString() + u' ' + found->value(1).toString();
        // Another version of SQLite may write other spaces.
        objects.insert(name, (found->value(2).toString() + u' ' + found->value(3).toString()).simplified());
    }
    if (const auto read = database.stepped(*found); !read)
        return tl::unexpected(read.error());
    for (const auto statistics : {"table sqlite_stat1"_L1, "table sqlite_stat4"_L1})
        objects.remove(statistics); // of a person who analyzed the file
    return objects;
}

// Returns what is in `present` and not in `wanted`; empty: nothing.
QString foreignIn(const Objects& present, const Objects& wanted)
{
    for (auto object = present.begin(); object != present.end(); ++object) {
        if (wanted.value(object.key()) != object.value())
            return object.key();
    }
    return {};
}

} // namespace

tl::expected<void, StoreError> Database::checkSchema()
{
    const auto found = version();
    const auto present = found ? objectsIn(*this) : tl::unexpected(found.error());
    if (!present)
        return tl::unexpected(present.error());
    QString foreign;
    // The version itself first: a file with the tables of another one has a damaged number.
    for (int i = 0; i <= static_cast<int>(m_file.steps().size()); ++i) {
        const int version = i == 0 ? *found : i;
        Database made(u":memory:"_s, m_file);
        const auto wanted = made.connect().and_then([&] { return made.makeSteps(0, version); }).and_then([&] {
            return objectsIn(made);
        });
        if (!wanted)
            return tl::unexpected(wanted.error());
        if (*wanted == *present)
            return i == 0 ? tl::expected<void, StoreError>()
                          : tl::unexpected(StoreError{StoreError::Kind::Damaged, m_path, {}});
        if (i == 0)
            foreign = foreignIn(*present, *wanted);
    }
    const auto kind = foreign.isEmpty() ? StoreError::Kind::Damaged : StoreError::Kind::Foreign;
    return tl::unexpected(StoreError{kind, m_path, foreign});
}

} // namespace campanel::store
