// SPDX-License-Identifier: Apache-2.0
// The failure of a command: an exit code and one line for stderr.
#pragma once

#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/program/program_image.h"
#include "app/store/files/file_error.h"
#include "modbus/line/link_error.h"

#include <QString>

#include <tl/expected.hpp>

namespace campanel::cli {

enum class ExitCode : int {
    Success = 0,
    Refused = 1, // by the controller, or the recipe is infeasible
    Usage = 2,
    Link = 3,
    File = 4,
};

struct Failure {
    ExitCode code = ExitCode::Usage;
    QString sentence;
};

using Outcome = tl::expected<void, Failure>;

[[nodiscard]] inline tl::unexpected<Failure> fail(ExitCode code, const QString& sentence)
{
    return tl::unexpected(Failure{code, sentence});
}

[[nodiscard]] inline tl::unexpected<Failure> fail(ExitCode code, const std::string& sentence)
{
    return fail(code, QString::fromStdString(sentence));
}

[[nodiscard]] inline tl::unexpected<Failure> fail(const modbus::LinkError& error)
{
    // An invalid option or value is a usage error, everything else an error of the line.
    using Kind = modbus::LinkErrorKind;
    const bool isUsage = error.kind == Kind::PortSettings || error.kind == Kind::ValueRefused;
    return fail(isUsage ? ExitCode::Usage : ExitCode::Link, panel::ConnectionSentences::error(error));
}

[[nodiscard]] inline tl::unexpected<Failure> fail(const profile::Refusal& refusal)
{
    return fail(ExitCode::Refused, panel::RefusalSentences::withSuggestions(refusal));
}

[[nodiscard]] inline tl::unexpected<Failure> fail(const program::ProgramRefusal& refusal)
{
    return fail(ExitCode::Refused, panel::RefusalSentences::program(refusal));
}

[[nodiscard]] inline tl::unexpected<Failure> fail(const store::FileError& error)
{
    return fail(ExitCode::File, store::FileErrorText::describe(error));
}

} // namespace campanel::cli
