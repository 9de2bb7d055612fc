// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/names.h"

#include "app/store/files/hidden_character.h"
#include "app/store/files/store_logging.h"

#include <QSet>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

// Characters without a picture that Unicode counts among letters, marks or symbols.
bool isInvisibleLetter(char32_t character)
{
    constexpr std::pair<char32_t, char32_t> ranges[]{
        {0x034F, 0x034F}, {0x115F, 0x1160}, {0x17B4, 0x17B5}, {0x180B, 0x180F}, {0x2800, 0x2800},
        {0x3164, 0x3164}, {0xFE00, 0xFE0F}, {0xFFA0, 0xFFA0}, {0xFFFD, 0xFFFD}, {0xE0100, 0xE01EF}};
    return std::ranges::any_of(ranges, [character](const auto& range) {
        return character >= range.first && character <= range.second;
    });
}

bool isHidden(char32_t character)
{
    return hasHiddenCategory(character) || isInvisibleLetter(character);
}

struct NamedRow {
    qint64 id = 0;
    QString name;
    bool isDeleted = false;
    bool operator<(const NamedRow& other) const
    {
        const auto rank = [](const NamedRow& row) {
            return std::tuple(row.name != keptName(row.name), row.isDeleted, row.id);
        };
        return rank(*this) < rank(other);
    }
};

tl::expected<QList<NamedRow>, StoreError> namedRows(Database& database, const QString& statement)
{
    auto found = database.execute(statement);
    if (!found)
        return tl::unexpected(found.error());
    QList<NamedRow> rows;
    while (found->next())
        rows << NamedRow{found->value(0).toLongLong(), found->value(1).toString(), found->value(2).toBool()};
    return database.stepped(*found).map([&rows] { return rows; });
}

// Returns the name, or with a number when it is taken.
QString unusedName(const QString& name, const QSet<QString>& taken)
{
    constexpr qsizetype maxLetters = 8; // of a number, which may take the end of a long name
    constexpr qsizetype maxBytes = 32;
    const QString base = name.isEmpty() ? u"?"_s : name;
    QString free = base;
    for (int number = 2; taken.contains(nameKey(free)); ++number) {
        QString begin = base;
        while (begin.toUtf8().size() > maxBytes - maxLetters)
            begin.chop(begin.back().isLowSurrogate() ? 2 : 1);
        free = u"%1 (%2)"_s.arg(keptName(begin), QString::number(number));
    }
    return free;
}

tl::expected<void, StoreError> completeTable(Database& database, const QString& table, bool isFreeWhenDeleted,
                                             QList<Renamed>& renamed)
{
    auto rows = namedRows(database, u"SELECT id, name, deleted FROM %1 WHERE name_key IS NULL"_s.arg(table));
    if (!rows || rows->isEmpty())
        return rows.map([](const auto&) {});
    // Names that stay as they are first.
    std::ranges::sort(*rows, std::less<>());
    const auto known =
        namedRows(database, u"SELECT id, name, deleted FROM %1 WHERE name_key NOT NULL"_s.arg(table));
    if (!known)
        return tl::unexpected(known.error());
    QSet<QString> taken;
    for (const NamedRow& row : *known) {
        if (!row.isDeleted || !isFreeWhenDeleted)
            taken.insert(nameKey(row.name));
    }
    for (const NamedRow& row : *rows) {
        const bool isUnique = !row.isDeleted || !isFreeWhenDeleted;
        const QString name = unusedName(keptName(row.name), isUnique ? taken : QSet<QString>());
        if (isUnique)
            taken.insert(nameKey(name));
        const auto done = database.execute(u"UPDATE %1 SET name = ?, name_key = ? WHERE id = ?"_s.arg(table),
                                           {name, nameKey(name), row.id});
        if (!done)
            return tl::unexpected(done.error());
        if (name == row.name)
            continue;
        renamed << Renamed{table, row.name, name};
        qCWarning(storeLog).noquote()
            << u"The %1 %2 is called %3 now: two names were the same, or had hidden "
               u"characters."_s.arg(table, row.name.toHtmlEscaped(), name);
    }
    return {};
}

} // namespace

std::optional<char32_t> hiddenCharacter(const QString& text)
{
    const auto characters = text.toUcs4();
    const auto found = std::ranges::find_if(characters, [](uint character) { return isHidden(character); });
    return found == characters.end() ? std::nullopt : std::optional<char32_t>(*found);
}

QString keptName(const QString& text)
{
    const auto characters = text.normalized(QString::NormalizationForm_C).toUcs4();
    QString kept;
    for (const char32_t character : characters) {
        if (!isHidden(character))
            kept += QString::fromUcs4(&character, 1);
    }
    return kept.trimmed();
}

QString nameKey(const QString& name)
{
    return keptName(name).simplified().toCaseFolded().normalized(QString::NormalizationForm_C);
}

tl::expected<QList<Renamed>, StoreError> completeNames(Database& database)
{
    QList<Renamed> renamed;
    return database
        .transaction([&] {
            return completeTable(database, u"recipe"_s, false, renamed).and_then([&] {
                return completeTable(database, u"user"_s, true, renamed);
            });
        })
        .map([&renamed] { return renamed; });
}

} // namespace campanel::store
