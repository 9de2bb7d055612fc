// SPDX-License-Identifier: Apache-2.0
// A connection for one command: options, open, identity check, heartbeat.
#pragma once

#include "app/cli/failure.h"
#include "modbus/line/rtu_client.h"

#include <QCommandLineOption>

#include <memory>
#include <optional>
#include <vector>

namespace campanel::cli {

class Invocation;

[[nodiscard]] QList<QCommandLineOption> linkOptions();
// The option of commands that move the machine, and its bits; without it none.
[[nodiscard]] QCommandLineOption permitOption();
[[nodiscard]] tl::expected<std::uint16_t, Failure> permitOf(const Invocation& call);

// Return the settings of the options. Invalid options are usage errors; for linkSettings() also a missing
// port.
[[nodiscard]] tl::expected<modbus::LinkSettings, Failure> lineSettings(const Invocation& call);
[[nodiscard]] tl::expected<modbus::LinkSettings, Failure> linkSettings(const Invocation& call);

struct ActiveProgram {
    program::Recipe recipe;
    std::vector<std::uint16_t> header; // of its bank
};

class LinkSession {
public:
    [[nodiscard]] static tl::expected<LinkSession, Failure> open(const Invocation& call);

    [[nodiscard]] modbus::RtuClient& client() { return *m_client; }
    [[nodiscard]] const modbus::Identity& identity() const { return m_identity; }
    // Sets what the exchanges permit (PermitBit); nothing unless set.
    void setPermit(std::uint16_t bits) { m_permit = bits; }
    // Performs one exchange without repetition.
    [[nodiscard]] tl::expected<modbus::StatusBlock, modbus::LinkError> exchangeOnce();
    // Repeats a limited number of times on a bad line; each exchange advances the heartbeat.
    [[nodiscard]] tl::expected<modbus::StatusBlock, Failure> status();
    // Reads the active program; empty: it is none that can be decoded.
    [[nodiscard]] tl::expected<std::optional<ActiveProgram>, Failure> activeProgram();
    // Sends the command once; a refusal by the controller is a failure with its reason.
    [[nodiscard]] Outcome command(modbus::Command code, const modbus::CommandArguments& arguments = {});

private:
    std::unique_ptr<modbus::RtuClient> m_client;
    modbus::Identity m_identity;
    std::uint16_t m_heartbeat = 0;
    std::uint16_t m_permit = 0;
};

} // namespace campanel::cli
