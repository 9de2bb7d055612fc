// SPDX-License-Identifier: Apache-2.0
#include "app/shell/configuration.h"

#include "app/store/files/files.h"

#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

namespace campanel::shell {
namespace {

using namespace Qt::StringLiterals;
using panel::SettingForm;
using panel::SettingRow;
using panel::settingText;

// Returns the text in ASCII, other letters and % as %XX: for most letters beyond ASCII where a value could
// end, the behavior of toml++ 3.3 is undefined.
QByteArray inAscii(const QByteArray& text)
{
    static const QByteArray kept = [] {
        QByteArray ascii;
        for (int each = 0; each < 0x80; ++each)
            ascii += static_cast<char>(each);
        return ascii.replace('%', "");
    }();
    return text.toPercentEncoding(kept);
}

QString fromAscii(std::string_view text)
{
    return QString::fromUtf8(
        QByteArray::fromPercentEncoding(QByteArray(text.data(), static_cast<qsizetype>(text.size()))));
}

std::optional<QString> textIn(const toml::node& node)
{
    const auto text = node.value_exact<std::string>();
    return text ? std::optional(fromAscii(*text)) : std::nullopt;
}

// Returns the texts of a list, one per line.
std::optional<QString> rulesIn(const toml::node& node)
{
    QStringList rules;
    if (!node.is_array())
        return {};
    for (const toml::node& element : *node.as_array())
        rules += textIn(element).value_or(u"?"_s);
    return rules.join(u'\n');
}

// Returns the value as a settings file has it; empty for a value of another type.
std::optional<QString> valueIn(const toml::node& node, SettingForm form)
{
    switch (form) {
    case SettingForm::Truth:
        if (const auto truth = node.value_exact<bool>())
            return settingText(*truth);
        return {};
    case SettingForm::Choice:
    case SettingForm::Whole:
        if (const auto number = node.value_exact<int64_t>())
            return QString::number(*number);
        return {};
    case SettingForm::Decimal:
        if (const auto number = node.is_number() ? node.value<double>() : std::nullopt)
            return settingText(*number);
        return {};
    case SettingForm::Rules:
    case SettingForm::Reasons:
        return rulesIn(node);
    case SettingForm::Word:
    case SettingForm::Language:
    case SettingForm::Port:
    case SettingForm::File:
    case SettingForm::Title:
    case SettingForm::Name:
    case SettingForm::Host:
    case SettingForm::User:
    case SettingForm::Prefix:
    case SettingForm::Size:
    case SettingForm::Times:
    case SettingForm::Days:
        break;
    }
    return textIn(node);
}

const SettingRow* rowNamed(std::string_view name)
{
    const auto row = std::ranges::find(panel::settingTable, name, &SettingRow::name);
    return row != panel::settingTable.end() && row->help ? &*row : nullptr;
}

bool isSection(std::string_view name)
{
    return std::ranges::any_of(panel::settingTable, [name](const SettingRow& row) {
        return row.help && row.name.substr(0, row.name.find('.')) == name;
    });
}

// Returns why a line is not given to toml++ 3.3; empty when it is safe. The parser assumes much of what
// follows a value or a bracket: otherwise a debug build aborts, and the behavior of a release build is
// undefined. So a line has keys, texts, numbers, lists and sections, each where it can be, and nothing else
// of TOML.
QString whyUnreadable(const QByteArray& line)
{
    // A text is reduced to its first quote, a comment to nothing.
    static const QRegularExpression textOrComment(uR"((")(?:\\.?|[^"\\])*+"?|(')[^']*+'?|#.*)"_s);
    static const QRegularExpression namelessSection(uR"(^[ \t]*\[[ \t]*+\[?+[ \t]*+(?![A-Za-z0-9_"'-]))"_s);
    static const QRegularExpression misplacedBrace(uR"((?:^|[\[,])[ \t]*\})"_s);
    static const QRegularExpression noMark(uR"([^\w.+\-=\[\]{},"' \t\r])"_s);
    static const QRegularExpression date(uR"(\d-\d)"_s);
    static const QRegularExpression twoValues(
        uR"([\w.+-][ \t]+[\w.+-]|["'\]}][ \t]*[\w.+-]|[\w.+\-"'\]}][ \t]*[\[{"'])"_s);
    QString rest = QString::fromUtf8(line);
    if (rest.toUtf8() != line)
        return u"not UTF-8"_s;
    // In a single line the inside of such a text looks like keys and values.
    if (rest.contains(u"\"\"\""_s) || rest.contains(u"'''"_s))
        return u"a text of several lines"_s;
    if (rest.contains(u"\\u0025"_s) || rest.contains(u"\\U00000025"_s))
        return u"% is written as it is"_s; // inAscii() would read it with what follows
    rest.replace(textOrComment, u"\\1\\2"_s);
    if (std::any_of(rest.begin(), rest.end(), [](QChar letter) { return letter.unicode() >= 0x80; }))
        return u"letters other than a to z are for texts in quotes and for comments"_s;
    if (namelessSection.match(rest).hasMatch())
        return u"a section without a name"_s;
    if (misplacedBrace.match(rest).hasMatch())
        return u"a brace that ends nothing"_s;
    if (const auto mark = noMark.match(rest); mark.hasMatch())
        return u"%1 is for texts in quotes"_s.arg(store::oneLine(mark.captured()));
    if (date.match(rest).hasMatch())
        return u"no setting is a date"_s;
    if (twoValues.match(rest).hasMatch())
        return u"a comma or = is missing"_s;
    return {};
}

// Reads one text; see configurationFrom().
class Reader {
public:
    Reader(const QByteArray& text, QString file)
        : m_lines(text.split('\n'))
        , m_file(std::move(file))
    {
    }

    ReadConfiguration read()
    {
        int broken = 0;
        for (qsizetype i = 0; i < m_lines.size(); ++i) {
            if (const QString why = whyUnreadable(m_lines[i]); !why.isEmpty()) {
                dropLine(static_cast<toml::source_index>(i + 1), why);
                ++broken;
            }
        }
        // The maximum number of invalid lines. Each invalid line is removed and the rest is read again; a
        // file with many of them is not a configuration.
        constexpr int maxBrokenLines = 50;
        for (; broken < maxBrokenLines; ++broken) {
            const QByteArray text = inAscii(m_lines.join('\n'));
            const toml::parse_result parsed =
                toml::parse(std::string_view(text.constData(), size_t(text.size())));
            if (parsed) {
                takeSections(parsed.table());
                return result();
            }
            const toml::parse_error& error = parsed.error();
            dropLine(error.source().begin.line, fromAscii(error.description()));
        }
        m_result.complaints += u"%1: more than %2 lines are not understood; the whole file is ignored."_s.arg(
            m_file, QString::number(maxBrokenLines));
        return result();
    }

private:
    void reportError(toml::source_index line, const QString& what)
    {
        m_result.complaints +=
            u"%1:%2: %3"_s.arg(m_file, QString::number(line), store::oneLine(what, store::maxLineLength));
    }

    // Returns the result with a limited number of errors. Without a valid controller setting the simulated
    // one is the default only if no error may concern the controller.
    ReadConfiguration result()
    {
        constexpr qsizetype maxComplaints = 60;
        if (m_isConnectionUnsure && m_result.values.text("connection.port").isEmpty())
            m_result.values.set("connection.simulated", settingText(false));
        if (const qsizetype more = m_result.complaints.size() - maxComplaints; more > 0) {
            m_result.complaints.remove(maxComplaints - 1, more); // the last one stays
            m_result.complaints.insert(maxComplaints - 1,
                                       u"%1: and %2 more."_s.arg(m_file, QString::number(more)));
        }
        return m_result;
    }

    // Removes the wrong line, or the last line with content before it.
    void dropLine(toml::source_index line, const QString& why)
    {
        qsizetype index = std::clamp<qsizetype>(qsizetype(line) - 1, 0, m_lines.size() - 1);
        while (index > 0 && m_lines[index].trimmed().isEmpty())
            --index;
        constexpr qsizetype maxShown = 80;
        const QString said = QString::fromUtf8(m_lines[index].left(maxShown)).simplified();
        m_isConnectionUnsure = true; // its content is unknown
        reportError(static_cast<toml::source_index>(index + 1),
                    u"\"%1\" is not understood (%2); the line is ignored."_s.arg(said, why));
        m_lines[index].clear();
    }

    void takeSections(const toml::table& root)
    {
        for (const auto& [name, node] : root) {
            const std::string section(name.str());
            const QString shown = fromAscii(section);
            if (const toml::table* table = node.as_table(); table && isSection(section))
                takeKeys(section, *table);
            else if (table)
                reportError(node.source().begin.line,
                            u"there is no section [%1]; it is ignored."_s.arg(shown));
            else
                reportError(node.source().begin.line,
                            u"there is no key \"%1\" outside a section; it is ignored."_s.arg(shown));
            m_isConnectionUnsure = m_isConnectionUnsure || !node.is_table() || !isSection(section);
        }
        const bool isSaid = root.at_path("connection.simulated").is_boolean();
        m_isConnectionUnsure = m_isConnectionUnsure && !isSaid;
        // A port implies a real connection.
        if (!m_result.values.text("connection.port").isEmpty() && !isSaid)
            m_result.values.set("connection.simulated", settingText(false));
    }

    void takeKeys(const std::string& section, const toml::table& table)
    {
        for (const auto& [name, node] : table) {
            const std::string whole = section + '.' + std::string(name.str());
            const SettingRow* row = rowNamed(whole);
            const QString shown = fromAscii(whole);
            const auto value = row ? valueIn(node, row->form) : std::nullopt;
            const bool isTaken = value && isValid(*row, *value);
            if (isTaken)
                m_result.values.set(*row, *value);
            else if (row)
                reportError(node.source().begin.line,
                            u"%1 must be %2; it is ignored."_s.arg(shown, validValues(*row)));
            else
                reportError(node.source().begin.line, u"there is no key %1; it is ignored."_s.arg(shown));
            if (!isTaken && section == "connection")
                m_isConnectionUnsure = true;
        }
    }

    QList<QByteArray> m_lines;
    QString m_file;
    ReadConfiguration m_result;
    bool m_isConnectionUnsure = false; // an unreadable line may have named the controller
};

} // namespace

QString configurationFile()
{
    return QStringLiteral(CAMPANEL_CONFIGURATION);
}

ReadConfiguration readConfiguration(const QString& file)
{
    const auto text = store::readBytes(file);
    if (text)
        return configurationFrom(*text, file);
    if (text.error().kind == store::FileError::Kind::NotFound)
        return {};
    ReadConfiguration unread{{},
                             {u"%1: cannot be read (%2); it is ignored."_s.arg(file, text.error().found)}};
    unread.values.set("connection.simulated", settingText(false)); // it may name the controller
    return unread;
}

ReadConfiguration configurationFrom(const QByteArray& text, const QString& file)
{
    const QByteArray mark("\xEF\xBB\xBF"); // byte order mark of Windows' editor
    return Reader(text.startsWith(mark) ? text.mid(mark.size()) : text, file).read();
}

QStringList configurationKeys()
{
    QStringList names;
    for (const SettingRow& row : panel::settingTable) {
        if (row.help)
            names += QString::fromLatin1(row.name.data(), qsizetype(row.name.size()));
    }
    return names;
}

} // namespace campanel::shell
