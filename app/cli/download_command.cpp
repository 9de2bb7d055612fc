// SPDX-License-Identifier: Apache-2.0
// campanelctl download: stages a recipe's table, compares, applies it and waits until the controller runs it.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "app/panel/words/cam_sentences.h"
#include "app/panel/words/master_sentences.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/program/cam_advance.h"
#include "modbus/download/download.h"

#include <QDateTime>
#include <QElapsedTimer>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using modbus::Download;

// The number of consecutive link errors after which the download fails.
constexpr int maxErrors = 5;
// The additional time beyond two cycles for a stopping or slow machine to activate an armed table.
constexpr qint64 waitBeyondCyclesMs = 5000;

Failure failureOf(const modbus::DownloadError& error)
{
    return {error.kind == modbus::DownloadErrorKind::Link ? ExitCode::Link : ExitCode::Refused,
            panel::ConnectionSentences::error(error)};
}

Outcome transfer(LinkSession& session, Download& download)
{
    int errors = 0;
    while (!download.ended() && download.phase() != Download::Phase::AwaitActive) {
        const auto phase = download.advance(session.client());
        if (phase) {
            errors = 0;
            continue;
        }
        const bool repeatable =
            phase.error().kind == modbus::DownloadErrorKind::Link && !modbus::portIsLost(phase.error().link);
        if (!repeatable || ++errors >= maxErrors)
            return tl::unexpected(failureOf(phase.error()));
    }
    return {};
}

tl::expected<modbus::StatusBlock, Failure> awaitActive(LinkSession& session, Download& download,
                                                       double cycleTimeS)
{
    QElapsedTimer timer;
    timer.start();
    const auto longest = static_cast<qint64>(2000 * cycleTimeS) + waitBeyondCyclesMs;
    while (true) {
        const auto status = session.status();
        if (!status)
            return status;
        const auto phase = download.noteStatus(*status);
        if (!phase)
            return tl::unexpected(failureOf(phase.error()));
        if (*phase == Download::Phase::Active)
            return status;
        if (timer.elapsed() > longest)
            return fail(
                ExitCode::Refused,
                u"The table is armed, but the machine did not reach the end of its cycle within %1 s. The table becomes active at the end of the cycle."_s
                    .arg(longest / 1000));
    }
}

tl::expected<std::uint16_t, Failure> readRegister(LinkSession& session, std::string_view name)
{
    const modbus::RegisterInfo& info = *modbus::findRegister(name);
    const auto read = session.client().readProven(info.address, info.count);
    if (!read)
        return fail(read.error());
    return read->front();
}

// Compares the master of the recipe with that of the machine; a controller without the setting has a clock.
Outcome checkMaster(LinkSession& session, const program::Recipe& recipe)
{
    program::MachineMaster machine;
    if (session.identity().hasRegister("master.source")) {
        const auto source = readRegister(session, "master.source");
        const auto input = readRegister(session, "master_status.available");
        if (!source || !input)
            return tl::unexpected(source ? input.error() : source.error());
        machine = {*source == static_cast<std::uint16_t>(modbus::MasterSource::Encoder), *input != 0};
    }
    const auto refusal = program::masterRefusal(recipe, machine);
    if (refusal != program::MasterRefusal::None)
        return fail(ExitCode::Refused, panel::MasterSentences::refusal(refusal));
    return {};
}

// Refuses values outside their approved windows without a reason.
Outcome checkWindows(const std::vector<program::Excess>& outside, const Invocation& call)
{
    if (outside.empty() || !call.value(u"reason"_s).trimmed().isEmpty())
        return {};
    QStringList values;
    for (const program::Excess& each : outside)
        values << panel::RefusalSentences::outside(each);
    return fail(ExitCode::Refused,
                u"Outside the approved window: %1. Add --reason TEXT, or give an approved value."_s.arg(
                    values.join(u"; "_s)));
}

// The recipe's trims become those of the machine with the program.
Outcome writeTrims(LinkSession& session, const program::Trims& trims)
{
    for (std::size_t i = 0; i < trims.size(); ++i) {
        const modbus::RegisterInfo& info = *modbus::findRegister(program::trimTable[i].nextName);
        if (!session.identity().hasRegister(info.name))
            return {};
        if (const auto written = session.client().writeParameter(info, trims[i]); !written)
            return fail(written.error());
    }
    return {};
}

} // namespace

Outcome runDownload(const Invocation& call)
{
    auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const double advanceMm = program::advanceMm(recipe->program);
    if (!program::isAdvanceConfirmed(recipe->program))
        return fail(ExitCode::Refused,
                    u"%1 Add --progressive to confirm this, or --close to close the cam."_s.arg(
                        panel::CamSentences::unconfirmed(advanceMm)));
    const std::vector<program::Excess> outside = program::outsideWindows(*recipe);
    if (const Outcome checked = checkWindows(outside, call); !checked)
        return checked;
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    if (const Outcome checked = checkMaster(*session, *recipe); !checked)
        return checked;
    recipe->machine = program::withController(recipe->machine, session->identity());
    const auto image = program::buildProgram(*recipe);
    if (!image)
        return fail(image.error());

    if (const Outcome written = recipe->isCutter() ? writeTrims(*session, recipe->trims) : Outcome();
        !written)
        return written;

    Download::Options options;
    options.mode =
        call.isSet(u"when-stopped"_s) ? modbus::ApplyMode::WhenStopped : modbus::ApplyMode::NextCycle;
    options.verify = call.isSet(u"verify"_s);
    // A different number for every download, never 0.
    options.session = static_cast<std::uint16_t>(1 + QDateTime::currentMSecsSinceEpoch() % 65535);
    Download download(image->registers, session->identity(), options);
    const auto before = session->status();
    if (!before)
        return tl::unexpected(before.error());
    if (const auto noted = download.noteStatus(*before); !noted)
        return tl::unexpected(failureOf(noted.error()));
    QElapsedTimer timer;
    timer.start();
    if (const Outcome transferred = transfer(*session, download); !transferred)
        return transferred;
    const double transferS = static_cast<double>(timer.nsecsElapsed()) / 1e9;
    const auto active = awaitActive(*session, download, image->solved.cycleS());
    if (!active)
        return tl::unexpected(active.error());
    if (call.isSet(u"save"_s)) {
        if (const Outcome saved = session->command(modbus::Command::SaveToFlash, {0, 0, image->crc}); !saved)
            return saved;
    }
    const auto rows =
        std::visit([](const auto& table) { return static_cast<qint64>(table.rows.size()); }, image->table);
    QJsonObject result{{u"name"_s, QString::fromStdString(image->recipe.name)},
                       {u"recipe_version"_s, image->recipe.version},
                       {u"generation"_s, static_cast<qint64>(active->generation)},
                       {u"crc32"_s, crcText(image->crc)},
                       {u"registers"_s, static_cast<qint64>(image->registers.size())},
                       {u"rows"_s, rows},
                       {u"transfer_s"_s, transferS},
                       {u"saved"_s, call.isSet(u"save"_s)}};
    addAdvance(result, recipe->program);
    if (!outside.empty())
        result[u"outside_window_reason"_s] = call.value(u"reason"_s).trimmed();
    return call.deliver(formatted(result, call.format()));
}

} // namespace campanel::cli
