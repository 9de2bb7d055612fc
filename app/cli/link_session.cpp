// SPDX-License-Identifier: Apache-2.0
// The connection, and the questions that every command asks.
#include "app/cli/link_session.h"

#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "modbus/download/bank_reader.h"

#include <QDateTime>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

// The number of attempts for a damaged or lost answer.
constexpr int attempts = 4;

// Returns the names of these permits as in the register map, "Film, Recipe".
QString permitNames(std::uint16_t bits)
{
    QStringList names;
    for (const modbus::EnumInfo& info : modbus::enumerations()) {
        for (const modbus::EnumValue& value : info.values) {
            if (info.name == "PermitBit" && (bits >> value.value & 1U) != 0)
                names << fromView(value.name);
        }
    }
    return names.join(u", "_s);
}

} // namespace

tl::expected<modbus::LinkSettings, Failure> lineSettings(const Invocation& call)
{
    modbus::LinkSettings settings;
    settings.port = call.value(u"port"_s).toStdString();
    settings.line.baud = call.value(u"baud"_s).toUInt(); // 0 without a number
    if (std::ranges::find(modbus::supportedBauds, settings.line.baud) == modbus::supportedBauds.end())
        return fail(ExitCode::Usage, u"--baud takes 9600, 19200, 38400, 57600 or 115200, not \"%1\"."_s.arg(
                                         call.value(u"baud"_s)));
    const unsigned stopBits = call.value(u"stop-bits"_s).toUInt();
    if (stopBits < 1 || stopBits > 2)
        return fail(ExitCode::Usage,
                    u"--stop-bits takes 1 or 2, not \"%1\"."_s.arg(call.value(u"stop-bits"_s)));
    settings.line.stopBits = static_cast<std::uint8_t>(stopBits);
    settings.unit = call.value(u"unit"_s).toInt();
    if (settings.unit < 1 || settings.unit > modbus::lastUnit)
        return fail(ExitCode::Usage, u"--unit takes a whole number from 1 to %1, not \"%2\"."_s.arg(
                                         QString::number(modbus::lastUnit), call.value(u"unit"_s)));
    const QString parity = call.value(u"parity"_s).toUpper();
    if (parity != u"N" && parity != u"E" && parity != u"O")
        return fail(ExitCode::Usage, u"--parity takes N, E or O, not \"%1\"."_s.arg(parity));
    settings.line.parity = static_cast<modbus::Parity>(parity[0].toLatin1());
    return settings;
}

tl::expected<modbus::LinkSettings, Failure> linkSettings(const Invocation& call)
{
    if (!call.isSet(u"port"_s))
        return fail(ExitCode::Usage, u"Name the port with --port, such as --port /dev/ttyUSB0."_s);
    return lineSettings(call);
}

QList<QCommandLineOption> linkOptions()
{
    return {QCommandLineOption(u"port"_s, u"Serial port of the controller."_s, u"DEVICE"_s),
            QCommandLineOption(u"baud"_s, u"9600, 19200, 38400, 57600 or 115200 (default)."_s, u"RATE"_s,
                               u"115200"_s),
            QCommandLineOption(u"parity"_s, u"N (default), E or O."_s, u"PARITY"_s, u"N"_s),
            QCommandLineOption(u"stop-bits"_s, u"1 (default) or 2."_s, u"COUNT"_s, u"1"_s),
            QCommandLineOption(u"unit"_s, u"Modbus unit number, 1 (default) to 247."_s, u"UNIT"_s, u"1"_s)};
}

QCommandLineOption permitOption()
{
    return {
        u"permit"_s,
        u"Permit the start in the panel's place: all, or names such as Warm,Film. See PermitBit in the register map."_s,
        u"NAMES"_s};
}

tl::expected<std::uint16_t, Failure> permitOf(const Invocation& call)
{
    if (call.value(u"permit"_s) == u"all")
        return modbus::allPermits;
    unsigned bits = 0;
    for (const QString& name : call.value(u"permit"_s).split(u',', Qt::SkipEmptyParts)) {
        unsigned bit = 0;
        while (bit < modbus::permitCount &&
               permitNames(static_cast<std::uint16_t>(1U << bit)).compare(name, Qt::CaseInsensitive) != 0)
            ++bit;
        if (bit == modbus::permitCount)
            return fail(ExitCode::Usage, u"--permit takes all or some of %1, not \"%2\"."_s.arg(
                                             permitNames(modbus::allPermits), name));
        bits |= 1U << bit;
    }
    return static_cast<std::uint16_t>(bits);
}

tl::expected<LinkSession, Failure> LinkSession::open(const Invocation& call)
{
    const auto settings = linkSettings(call);
    if (!settings)
        return tl::unexpected(settings.error());
    LinkSession session;
    session.m_client = std::make_unique<modbus::RtuClient>(*settings);
    session.m_heartbeat = static_cast<std::uint16_t>(QDateTime::currentMSecsSinceEpoch());
    if (const auto opened = session.m_client->open(); !opened)
        return fail(opened.error());
    auto identity = session.m_client->identify();
    for (int i = 1;
         i < attempts && !identity && identity.error().kind != modbus::LinkErrorKind::NotCamPanel &&
         identity.error().kind != modbus::LinkErrorKind::WrongMapMajor &&
         identity.error().kind != modbus::LinkErrorKind::WrongIdentity;
         ++i)
        identity = session.m_client->identify();
    if (!identity)
        return fail(identity.error());
    session.m_identity = *identity;
    return session;
}

tl::expected<modbus::StatusBlock, modbus::LinkError> LinkSession::exchangeOnce()
{
    return m_client->exchangeStatus(++m_heartbeat, 0, m_permit);
}

tl::expected<modbus::StatusBlock, Failure> LinkSession::status()
{
    auto status = exchangeOnce();
    for (int i = 1; i < attempts && !status && !modbus::portIsLost(status.error()); ++i)
        status = exchangeOnce();
    if (!status)
        return fail(status.error());
    return *status;
}

tl::expected<std::optional<ActiveProgram>, Failure> LinkSession::activeProgram()
{
    const auto header = m_client->readProven(modbus::activeBankBase, modbus::bankHeaderRegisters);
    if (!header)
        return fail(header.error());
    const modbus::ListSpan span = modbus::listSpan(*header);
    modbus::BankReader knots(static_cast<std::uint16_t>(modbus::activeBankBase + span.offset), span.count);
    while (!knots.complete()) {
        if (const auto step = knots.advance(*m_client); !step)
            return fail(step.error());
    }
    const auto recipe = program::decodeProgram(*header, knots.registers(),
                                               program::withController(profile::Machine{}, m_identity));
    if (!recipe)
        return std::nullopt;
    return ActiveProgram{*recipe, *header};
}

Outcome LinkSession::command(modbus::Command code, const modbus::CommandArguments& arguments)
{
    // The heartbeat must have advanced before the controller accepts motion commands.
    if (const auto alive = status(); !alive)
        return tl::unexpected(alive.error());
    const auto result = m_client->command(code, arguments);
    if (!result)
        return fail(result.error());
    if (result->done())
        return {};
    const bool isPermitMissing =
        result->reason >= modbus::Refusal::NotWarm && result->reason <= modbus::Refusal::PanelDisagrees;
    if (!isPermitMissing)
        return fail(ExitCode::Refused, panel::ConnectionSentences::refused(code, result->reason));
    const unsigned needed = code == modbus::Command::Start
                                ? modbus::allPermits
                                : modbus::RegisterInfo::bitOf(modbus::PermitBit::Clean);
    return fail(
        ExitCode::Refused,
        u"The controller needs a panel's permit, which lacks %1. Use the panel, or permit "
        u"it yourself with --permit all."_s.arg(permitNames(static_cast<std::uint16_t>(needed & ~m_permit))));
}

} // namespace campanel::cli
