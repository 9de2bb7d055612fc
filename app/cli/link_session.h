// SPDX-License-Identifier: Apache-2.0
// A connection for the length of one command: options, open, identity check, heartbeat.
#pragma once

#include "app/cli/failure.h"
#include "modbus/line/rtu_client.h"

#include <QCommandLineOption>

#include <memory>

namespace campanel::cli {

class Invocation;

[[nodiscard]] QList<QCommandLineOption> linkOptions();

// Everything that the options say; usage errors when they cannot be understood or, for linkSettings(), no
// port is named.
[[nodiscard]] tl::expected<modbus::LinkSettings, Failure> lineSettings(const Invocation& call);
[[nodiscard]] tl::expected<modbus::LinkSettings, Failure> linkSettings(const Invocation& call);

class LinkSession {
public:
    [[nodiscard]] static tl::expected<LinkSession, Failure> open(const Invocation& call);

    [[nodiscard]] modbus::RtuClient& client() { return *m_client; }
    [[nodiscard]] const modbus::Identity& identity() const { return m_identity; }
    // One exchange, not repeated.
    [[nodiscard]] tl::expected<modbus::StatusBlock, modbus::LinkError> exchangeOnce();
    // Repeats a few times over a bad line; each exchange advances the heartbeat.
    [[nodiscard]] tl::expected<modbus::StatusBlock, Failure> status();
    // Sends the command once; a refusal by the controller is a failure with its reason.
    [[nodiscard]] Outcome command(modbus::Command code, modbus::CommandArguments arguments = {});

private:
    std::unique_ptr<modbus::RtuClient> m_client;
    modbus::Identity m_identity;
    std::uint16_t m_heartbeat = 0;
};

} // namespace campanel::cli
