// SPDX-License-Identifier: Apache-2.0
// One call of campanelctl: the command, its options, its arguments. Each command declares its syntax; the
// parser, the usage errors and --help follow from it.
#pragma once

#include "app/cli/failure.h"

#include <QCommandLineParser>
#include <QStringList>

#include <span>

namespace campanel::cli {

class Invocation;

struct CommandInfo {
    enum Takes : unsigned {
        Nothing = 0,
        Recipe = 1,
        Link = 2,
        Names = 4,
        TrailFile = 8,
        Signing = 16,
        PackageFile = 32
    };

    QString name;
    QString summary; // one line for the list of commands
    QString details; // further lines of the command's help
    unsigned takes = Nothing;
    QStringList formats; // the first is the default; empty: prints one sentence
    QList<QCommandLineOption> options;
    Outcome (*run)(const Invocation& call) = nullptr;
};

class Invocation {
public:
    // Parses the arguments, which start with the names of the program and the command.
    explicit Invocation(const CommandInfo& command);
    [[nodiscard]] Outcome parse(const QStringList& arguments);

    [[nodiscard]] bool isSet(const QString& option) const { return m_parser.isSet(option); }
    [[nodiscard]] QString value(const QString& option) const { return m_parser.value(option); }
    [[nodiscard]] QStringList values(const QString& option) const { return m_parser.values(option); }
    [[nodiscard]] QStringList arguments() const { return m_arguments; } // without the command's name
    [[nodiscard]] bool wantsHelp() const { return m_parser.isSet(QStringLiteral("help")); }
    [[nodiscard]] QString helpText() const;

    // Returns the requested format, one of the command's.
    [[nodiscard]] QString format() const;
    // Prints the whole text, or writes it to the file of -o; nothing on an error.
    [[nodiscard]] Outcome deliver(const QByteArray& text) const;
    // Does the same with bytes that are not text.
    [[nodiscard]] Outcome deliverBytes(const QByteArray& bytes) const;

private:
    const CommandInfo& m_command;
    QCommandLineParser m_parser;
    QStringList m_arguments;
};

// Prints the text; an incomplete output is an error.
[[nodiscard]] Outcome writeStandardOutput(const QByteArray& text);

[[nodiscard]] QString overviewText(std::span<const CommandInfo> commands);

} // namespace campanel::cli
