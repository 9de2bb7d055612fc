// SPDX-License-Identifier: Apache-2.0
// Parsing and help.
#include "app/cli/invocation.h"

#include "app/cli/link_session.h"
#include "app/cli/recipe_options.h"
#include "app/store/files/files.h"

#include <QFile>
#include <QFileInfo>

#include <cstdio>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

const QString exitCodes =
    u"Exit codes: 0 done, 1 refused or not feasible, 2 wrong usage, 3 connection, 4 file."_s;

// Writes to /dev/stdout, a pipe and the like, which cannot be replaced like a file.
Outcome writeDevice(const QString& path, const QByteArray& bytes)
{
    QFile device(path);
    if (!device.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || device.write(bytes) != bytes.size())
        return fail(ExitCode::File,
                    u"%1 cannot be written: %2. Name another file."_s.arg(path, device.errorString()));
    return {};
}

// Writes to standard output.
Outcome writeBytes(const QByteArray& bytes)
{
    const auto size = static_cast<std::size_t>(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        return fail(
            ExitCode::File,
            u"Standard output cannot be written: %1. Free some disk space, or redirect the output to another file."_s
                .arg(qt_error_string()));
    return {};
}

} // namespace

Invocation::Invocation(const CommandInfo& command)
    : m_command(command)
{
    m_parser.addPositionalArgument(command.name, command.summary);
    if (command.takes & CommandInfo::Recipe)
        m_parser.addPositionalArgument(u"RECIPE.json"_s, u"Recipe file (default: the default recipe)."_s,
                                       u"[RECIPE.json]"_s);
    if (command.takes & CommandInfo::Names)
        m_parser.addPositionalArgument(
            u"NAME"_s, u"Registers to read with --read, a parameter and its value, or an output."_s,
            u"[NAME...]"_s);
    if (command.takes & CommandInfo::TrailFile) {
        m_parser.addPositionalArgument(u"verify"_s, u"Check all rows for changes."_s);
        m_parser.addPositionalArgument(u"FILE"_s, u"Database or backup."_s);
    }
    if (command.takes & CommandInfo::Signing) {
        m_parser.addPositionalArgument(u"new-key"_s, u"Create the key of a signer."_s, u"| new-key"_s);
        m_parser.addPositionalArgument(u"sign"_s, u"Sign a recipe file."_s, u"| sign RECIPE.json"_s);
        m_parser.addPositionalArgument(u"verify"_s, u"Check a signed recipe."_s, u"| verify SIGNED.json"_s);
    }
    if (command.takes & CommandInfo::PackageFile) {
        m_parser.addPositionalArgument(u"sign"_s, u"Sign a package."_s, u"sign FILE.deb"_s);
        m_parser.addPositionalArgument(u"verify"_s, u"Check a package with FILE.deb.sig beside it."_s,
                                       u"| verify FILE.deb"_s);
        m_parser.addPositionalArgument(u"schema"_s, u"Print the schemas of the panel's data."_s,
                                       u"| schema"_s);
    }
    m_parser.addOption({{u"h"_s, u"help"_s}, u"Show this help."_s});
    m_parser.addOptions(command.options);
    if (!command.formats.isEmpty()) {
        m_parser.addOption({u"format"_s, u"One of: "_s + command.formats.join(u", "_s) + u'.', u"FORMAT"_s,
                            command.formats.first()});
        m_parser.addOption(
            {{u"o"_s, u"output"_s}, u"Write to FILE instead of standard output."_s, u"FILE"_s});
    }
    if (command.takes & CommandInfo::Link)
        m_parser.addOptions(linkOptions());
    if (command.takes & CommandInfo::Recipe)
        m_parser.addOptions(recipeOptions());
}

Outcome Invocation::parse(const QStringList& arguments)
{
    if (!m_parser.parse(arguments))
        return fail(ExitCode::Usage,
                    m_parser.errorText() + u" See campanelctl "_s + m_command.name + u" --help."_s);
    m_arguments = m_parser.positionalArguments().mid(1);
    const bool many = (m_command.takes & (CommandInfo::Names | CommandInfo::TrailFile)) != 0;
    const bool isSigning = (m_command.takes & (CommandInfo::Signing | CommandInfo::PackageFile)) != 0;
    const qsizetype maxArguments = isSigning ? 2 : (m_command.takes & CommandInfo::Recipe) != 0 ? 1 : 0;
    if (!many && m_arguments.size() > maxArguments)
        return fail(ExitCode::Usage, u"Unexpected argument \"%1\". See campanelctl %2 --help."_s.arg(
                                         m_arguments[maxArguments], m_command.name));
    if (!m_command.formats.isEmpty() && !m_command.formats.contains(format()))
        return fail(ExitCode::Usage, u"\"%1\" is not a format of %2; choose one of: %3."_s.arg(
                                         format(), m_command.name, m_command.formats.join(u", "_s)));
    return {};
}

QString Invocation::helpText() const
{
    QString text = m_parser.helpText();
    text += u'\n' + m_command.summary + u'\n';
    if (!m_command.details.isEmpty())
        text += m_command.details + u'\n';
    return text + exitCodes + u'\n';
}

QString Invocation::format() const
{
    return m_command.formats.isEmpty() ? QString() : m_parser.value(u"format"_s);
}

Outcome Invocation::deliver(const QByteArray& text) const
{
    return deliverBytes(store::printable(QString::fromUtf8(text)).toUtf8());
}

Outcome Invocation::deliverBytes(const QByteArray& bytes) const
{
    if (m_command.formats.isEmpty() || !isSet(u"output"_s))
        return writeBytes(bytes);
    const QString path = value(u"output"_s);
    if (const QFileInfo present(path); present.exists() && !present.isFile() && !present.isDir())
        return writeDevice(path, bytes);
    if (const auto written = store::replaceBytes(path, bytes); !written)
        return fail(
            ExitCode::File,
            u"%1 cannot be written: %2; the file is unchanged. Free some disk space, or name another file."_s
                .arg(path, written.error().found));
    return {};
}

Outcome writeStandardOutput(const QByteArray& text)
{
    return writeBytes(store::printable(QString::fromUtf8(text)).toUtf8());
}

QString overviewText(std::span<const CommandInfo> commands)
{
    QString text =
        u"Usage: campanelctl COMMAND [options]\n"
        "Computes, downloads and watches the programs of an electronic-cam machine.\n\nCommands:\n"_s;
    for (const CommandInfo& command : commands)
        text += u"  %1 %2\n"_s.arg(QString(command.name).leftJustified(10), command.summary);
    return text + u"\ncampanelctl COMMAND --help explains the options of one command.\n"_s + exitCodes +
           u'\n';
}

} // namespace campanel::cli
