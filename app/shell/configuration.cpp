// SPDX-License-Identifier: Apache-2.0
#include "app/shell/configuration.h"

#include "app/store/files/files.h"

#include <QRegularExpression>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>

#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

namespace campanel::shell {
namespace {

using namespace Qt::StringLiterals;
using panel::ConnectionChoice;

// Puts the value into the configuration, or returns the valid values: "one of en, zh_CN".
using Take = std::function<std::optional<QString>(const toml::node&, Configuration&)>;

std::optional<QString> textOf(const toml::node& node)
{
    const auto text = node.value_exact<std::string>();
    return text ? std::optional(QString::fromStdString(*text)) : std::nullopt;
}

template <typename Member> Take truth(Member member)
{
    return [member](const toml::node& node, Configuration& into) -> std::optional<QString> {
        const auto value = node.value_exact<bool>();
        if (!value)
            return u"true or false"_s;
        std::invoke(member, into) = *value;
        return std::nullopt;
    };
}

template <typename Member> Take oneOf(QStringList choices, Member member)
{
    return [choices, member](const toml::node& node, Configuration& into) -> std::optional<QString> {
        const auto value = textOf(node);
        if (!value || !choices.contains(*value))
            return u"one of \"%1\""_s.arg(choices.join(u"\", \""_s));
        std::invoke(member, into) = *value;
        return std::nullopt;
    };
}

template <typename Member> Take oneOf(const QList<int>& choices, Member member)
{
    QStringList names;
    for (const int choice : choices)
        names += QString::number(choice);
    return [choices, names, member](const toml::node& node, Configuration& into) -> std::optional<QString> {
        const auto value = node.value_exact<int64_t>();
        if (!value || !choices.contains(static_cast<int>(*value)) || *value != static_cast<int>(*value))
            return u"one of "_s + names.join(u", "_s);
        std::invoke(member, into) = static_cast<int>(*value);
        return std::nullopt;
    };
}

template <typename Member> Take between(int lowest, int highest, Member member)
{
    return [=](const toml::node& node, Configuration& into) -> std::optional<QString> {
        const auto value = node.value_exact<int64_t>();
        if (!value || *value < lowest || *value > highest)
            return u"a whole number from %1 to %2"_s.arg(lowest).arg(highest);
        std::invoke(member, into) = static_cast<int>(*value);
        return std::nullopt;
    };
}

std::optional<QString> takePort(const toml::node& node, Configuration& into)
{
    const auto value = textOf(node);
    if (!value || (!value->isEmpty() && !value->startsWith(u'/')))
        return u"the path of a serial port, such as \"/dev/campanel-serial\""_s;
    into.standard.connection.portName = *value;
    return std::nullopt;
}

std::optional<QString> takeTolerance(const toml::node& node, Configuration& into)
{
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    const double least = panel::Settings::minToleranceMm;
    const double most = panel::Settings::maxToleranceMm;
    if (!value || !std::isfinite(*value) || *value < least || *value > most)
        return u"a number from %1 to %2"_s.arg(least).arg(most);
    into.standard.bagToleranceMm = *value;
    return std::nullopt;
}

std::optional<QString> takeSize(const toml::node& node, Configuration& into)
{
    static const QRegularExpression form(u"^(\\d{3,4})x(\\d{3,4})$"_s);
    const auto match = form.match(textOf(node).value_or(QString()));
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    if (size.width() < 800 || size.height() < 480)
        return u"from \"800x480\" to \"9999x9999\""_s;
    into.windowSize = size;
    return std::nullopt;
}

std::optional<QString> takeScreen(const toml::node& node, Configuration& into)
{
    constexpr std::array<std::pair<const char*, ScreenAccess>, 3> names{
        {{"auto", ScreenAccess::Auto}, {"eglfs", ScreenAccess::EglFs}, {"linuxfb", ScreenAccess::LinuxFb}}};
    for (const auto& [name, access] : names) {
        if (textOf(node) == QString::fromLatin1(name)) {
            into.screen = access;
            return std::nullopt;
        }
    }
    return u"one of \"auto\", \"eglfs\", \"linuxfb\""_s;
}

std::optional<QString> takeLogRules(const toml::node& node, Configuration& into)
{
    static const QRegularExpression form(u"^[A-Za-z0-9_.*]+=(true|false)$"_s);
    const QString wanted = u"a list of rules such as [\"campanel.link.debug=true\"]"_s;
    QStringList rules;
    if (!node.is_array())
        return wanted;
    for (const toml::node& element : *node.as_array()) {
        const auto rule = textOf(element);
        if (!rule || !form.match(*rule).hasMatch())
            return wanted;
        rules += *rule;
    }
    into.logRules = rules;
    return std::nullopt;
}

struct Key {
    const char* name; // section.key
    Take take;
};

auto connection(auto member)
{
    return [member](Configuration & into) -> auto&
    {
        return into.standard.connection.*member;
    };
}
auto standard(auto member)
{
    return [member](Configuration & into) -> auto&
    {
        return into.standard.*member;
    };
}

const std::vector<Key>& keys()
{
    using panel::Settings;
    using panel::StandardSettings;
    static const std::vector<Key> all{
        {"connection.simulated", truth(connection(&ConnectionChoice::simulated))},
        {"connection.port", takePort},
        {"connection.baud", oneOf(Settings::possibleBauds(), connection(&ConnectionChoice::baud))},
        {"connection.parity", oneOf(Settings::possibleParities(), connection(&ConnectionChoice::parity))},
        {"connection.stop_bits", between(1, 2, connection(&ConnectionChoice::stopBits))},
        {"connection.unit", between(1, 247, connection(&ConnectionChoice::unit))},
        {"display.language", oneOf(Settings::possibleLanguages(), standard(&StandardSettings::language))},
        {"display.theme", oneOf(Settings::possibleThemes(), standard(&StandardSettings::theme))},
        {"display.gloves", truth(standard(&StandardSettings::gloves))},
        {"display.size", takeSize},
        {"display.fullscreen", truth(&Configuration::isFullScreen)},
        {"bags.tolerance_mm", takeTolerance},
        {"access.auto_logout_minutes",
         oneOf(Settings::possibleLogouts(), standard(&StandardSettings::autoLogoutMinutes))},
        {"access.operators_log_in", truth(standard(&StandardSettings::operatorsLogIn))},
        {"access.hold_to_start", oneOf(Settings::possibleHolds(), standard(&StandardSettings::holdToStart))},
        {"log.rules", takeLogRules},
        {"kiosk.screen", takeScreen},
    };
    return all;
}

const Key* keyNamed(const std::string& name)
{
    for (const Key& key : keys()) {
        if (name == key.name)
            return &key;
    }
    return nullptr;
}

bool isSection(std::string_view name)
{
    return std::any_of(keys().begin(), keys().end(), [name](const Key& key) {
        const std::string_view whole = key.name;
        return whole.substr(0, whole.find('.')) == name;
    });
}

// Returns why a line is not given to toml++ 3.3; empty when it is safe. The parser assumes that a section's
// bracket is followed by a name, that no brace ends a list, and that some letters are not where a space could
// be. Otherwise a debug build aborts, and the behavior of a release build is undefined.
QString whyUnreadable(const QByteArray& line)
{
    // A text is reduced to its first quote, a comment to nothing.
    static const QRegularExpression textOrComment(uR"((")(?:\\.?|[^"\\])*+"?|(')[^']*+'?|#.*)"_s);
    static const QRegularExpression namelessSection(uR"(^[ \t]*\[[ \t]*+\[?+[ \t]*+(?![A-Za-z0-9_"'-]))"_s);
    static const QRegularExpression misplacedBrace(uR"((?:^|[\[,])[ \t]*\})"_s);
    QString rest = QString::fromUtf8(line);
    if (rest.toUtf8() != line)
        return u"not UTF-8"_s;
    rest.replace(textOrComment, u"\\1\\2"_s);
    if (namelessSection.match(rest).hasMatch())
        return u"a section without a name"_s;
    if (std::any_of(rest.begin(), rest.end(), [](QChar letter) { return letter.unicode() >= 0x80; }))
        return u"letters other than a to z are for texts in quotes and for comments"_s;
    if (misplacedBrace.match(rest).hasMatch())
        return u"a brace that ends nothing"_s;
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
        for (qsizetype i = 0; i < m_lines.size(); ++i) {
            if (const QString why = whyUnreadable(m_lines[i]); !why.isEmpty())
                dropLine(static_cast<toml::source_index>(i + 1), why);
        }
        // The maximum number of invalid lines. Each invalid line is removed and the rest is read again; a
        // file with many of them is not a configuration.
        constexpr int maxBrokenLines = 50;
        for (int broken = 0; broken < maxBrokenLines; ++broken) {
            const QByteArray text = m_lines.join('\n');
            const toml::parse_result parsed =
                toml::parse(std::string_view(text.constData(), size_t(text.size())));
            if (parsed) {
                takeSections(parsed.table());
                return result();
            }
            const toml::parse_error& error = parsed.error();
            const std::string_view why = error.description();
            dropLine(error.source().begin.line, QString::fromUtf8(why.data(), qsizetype(why.size())));
        }
        m_result.complaints +=
            u"%1: more than %2 lines are not understood; the whole file is ignored."_s.arg(m_file).arg(
                maxBrokenLines);
        return result();
    }

private:
    void reportError(toml::source_index line, const QString& what)
    {
        m_result.complaints += u"%1:%2: %3"_s.arg(m_file).arg(line).arg(store::printable(what));
    }

    // Returns the result with a limited number of errors. Without a valid controller setting the simulated
    // one is the default only if no error may concern the controller.
    ReadConfiguration result()
    {
        constexpr qsizetype maxComplaints = 60;
        auto& connection = m_result.values.standard.connection;
        if (m_isConnectionUnsure && connection.portName.isEmpty())
            connection.simulated = false;
        if (const qsizetype more = m_result.complaints.size() - maxComplaints; more > 0) {
            m_result.complaints.remove(maxComplaints - 1, more); // the last one stays
            m_result.complaints.insert(maxComplaints - 1, u"%1: and %2 more."_s.arg(m_file).arg(more));
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
            const QString shown = QString::fromStdString(section);
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
        if (!m_result.values.standard.connection.portName.isEmpty() && !isSaid)
            m_result.values.standard.connection.simulated = false;
    }

    void takeKeys(const std::string& section, const toml::table& table)
    {
        for (const auto& [name, node] : table) {
            const std::string whole = section + '.' + std::string(name.str());
            const Key* key = keyNamed(whole);
            const QString shown = QString::fromStdString(whole);
            const auto wanted = key ? key->take(node, m_result.values) : std::nullopt;
            if (!key)
                reportError(node.source().begin.line, u"there is no key %1; it is ignored."_s.arg(shown));
            else if (wanted)
                reportError(node.source().begin.line, u"%1 must be %2; it is ignored."_s.arg(shown, *wanted));
            if ((!key || wanted) && section == "connection")
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
    unread.values.standard.connection.simulated = false; // it may name the controller
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
    for (const Key& key : keys())
        names += QString::fromLatin1(key.name);
    return names;
}

} // namespace campanel::shell
