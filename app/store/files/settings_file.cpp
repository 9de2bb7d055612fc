// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/settings_file.h"

#include "app/store/files/files.h"
#include "app/store/files/store_logging.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <optional>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::store {
namespace {

const QByteArray checksumMark("; sha256=");

// "General" is QSettings' name for keys without a section: files of earlier versions have it.
const QString noSection = u"General"_s;

QByteArray checksumLine(const QByteArray& body)
{
    return checksumMark + QCryptographicHash::hash(body, QCryptographicHash::Sha256).toHex() + '\n';
}

// Adds quotation marks when the ini format would change the value otherwise.
QString quoted(QString value)
{
    value.removeIf([](QChar letter) { return letter.category() == QChar::Other_Control; });
    if (value == value.trimmed() &&
        std::none_of(value.begin(), value.end(), [](QChar letter) { return u"\"\\;,="_s.contains(letter); }))
        return value;
    return u'"' + value.replace(u'\\', u"\\\\"_s).replace(u'"', u"\\\""_s) + u'"';
}

QString unquoted(const QString& value)
{
    if (value.size() < 2 || !value.startsWith(u'"') || !value.endsWith(u'"'))
        return value;
    QString text;
    for (qsizetype i = 1; i < value.size() - 1; ++i) {
        i += value[i] == u'\\' ? 1 : 0;
        text += value[i];
    }
    return text;
}

// Returns the values, or why they are invalid.
tl::expected<SettingsFile::Values, QString> parse(const QByteArray& body)
{
    SettingsFile::Values values;
    const QString text = QString::fromUtf8(body);
    if (text.toUtf8() != body)
        return tl::unexpected(u"it is not UTF-8"_s);
    QString section;
    int number = 0;
    for (const QString& raw : text.split(u'\n')) {
        const QString line = raw.trimmed();
        ++number;
        if (line.isEmpty() || line.startsWith(u';'))
            continue;
        const qsizetype sign = line.indexOf(u'=');
        const bool isSection = line.startsWith(u'[') && line.endsWith(u']');
        if (isSection)
            section = line.mid(1, line.size() - 2);
        else if (sign <= 0)
            return tl::unexpected(u"line %1 is no setting"_s.arg(number));
        if (isSection)
            continue;
        const QString name = line.left(sign).trimmed();
        const QString key = section.isEmpty() || section == noSection ? name : section + u'/' + name;
        if (values.contains(key))
            return tl::unexpected(u"line %1 sets %2 again"_s.arg(number).arg(key));
        values.insert(key, unquoted(line.mid(sign + 1).trimmed()));
    }
    return values;
}

tl::expected<SettingsFile::Values, QString> sound(const QByteArray& bytes, const QStringList& knownKeys)
{
    if (bytes.startsWith(';')) {
        const QByteArray body = bytes.mid(bytes.indexOf('\n') + 1);
        if (!bytes.startsWith(checksumLine(body)))
            return tl::unexpected(u"its checksum is wrong"_s);
        return parse(body);
    }
    return parse(bytes).and_then(
        [&knownKeys](const SettingsFile::Values& values) -> tl::expected<SettingsFile::Values, QString> {
            if (values.isEmpty())
                return tl::unexpected(u"it is empty"_s);
            for (auto it = values.begin(); it != values.end(); ++it) {
                if (!knownKeys.contains(it.key()))
                    return tl::unexpected(u"there is no setting %1"_s.arg(it.key()));
            }
            return values;
        });
}

struct Reading {
    bool isThere = false;
    QByteArray bytes;
    tl::expected<SettingsFile::Values, QString> values;
};

Reading readSettings(const QString& path, const QStringList& knownKeys)
{
    const auto bytes = readBytes(path);
    if (bytes)
        return {true, *bytes, sound(*bytes, knownKeys)};
    return {bytes.error().kind != FileError::Kind::NotFound, {}, tl::unexpected(bytes.error().found)};
}

} // namespace

SettingsFile::SettingsFile(QString path, const QStringList& knownKeys)
    : m_path(std::move(path))
{
    const Reading file = readSettings(m_path, knownKeys);
    const Reading copy = readSettings(backupPath(m_path), knownKeys);
    if (file.values) {
        m_values = *file.values;
        m_origin = Origin::File;
        if (file.bytes != contents() || copy.bytes != file.bytes)
            write();
        return;
    }
    if (!file.isThere && !copy.isThere)
        return;
    const QString damaged = m_path + u".damaged"_s;
    if (file.isThere) {
        QFile::remove(damaged);
        QFile::rename(m_path, damaged);
    }
    m_origin = copy.values ? Origin::Copy : Origin::Defaults;
    m_values = copy.values.value_or(Values());
    qCWarning(storeLog).noquote() << oneLine(
        u"the settings file %1 is damaged (%2); %3"_s.arg(m_path, file.values.error(),
                                                          copy.values ? u"its last good copy is used"_s
                                                                      : u"there is no good copy of it"_s),
        maxLineLength);
    if (copy.values)
        write();
}

QString SettingsFile::value(const QString& key, const QString& otherwise) const
{
    return m_values.value(key, otherwise);
}

void SettingsFile::set(const Values& values)
{
    Values changed = m_values;
    changed.insert(values);
    if (changed == m_values && m_isKept)
        return;
    m_values = changed;
    write();
}

QByteArray SettingsFile::contents() const
{
    QMap<QString, QStringList> sections;
    for (auto it = m_values.begin(); it != m_values.end(); ++it) {
        const qsizetype slash = it.key().indexOf(u'/');
        sections[slash < 0 ? QString() : it.key().left(slash)]
            << it.key().mid(slash + 1) + u'=' + quoted(it.value());
    }
    QByteArray body;
    for (auto it = sections.begin(); it != sections.end(); ++it)
        body += (u'[' + (it.key().isEmpty() ? noSection : it.key()) + u"]\n"_s + it->join(u'\n') + u"\n\n"_s)
                    .toUtf8();
    return checksumLine(body) + body;
}

// Writes the file, then the copy: after a power cut in between both are valid.
void SettingsFile::write()
{
    QDir().mkpath(QFileInfo(m_path).absolutePath());
    const QByteArray bytes = contents();
    const auto written =
        replaceBytes(m_path, bytes).and_then([&] { return replaceBytes(backupPath(m_path), bytes); });
    m_isKept = written.has_value();
    if (!written)
        qCWarning(storeLog).noquote() << oneLine(
            u"the settings cannot be written to %1: %2"_s.arg(written.error().path, written.error().found),
            maxLineLength);
}

} // namespace campanel::store
