// SPDX-License-Identifier: Apache-2.0
// Asks a controller who it is and what it is doing: campanel-example-status PORT
#include "modbus/line/rtu_client.h"

#include <iostream>

using namespace campanel::modbus;

int main(int argc, char** argv)
{
    LinkSettings settings;
    settings.port = argc > 1 ? argv[1] : "/dev/campanel-serial";
    RtuClient client(settings);
    const auto identity = client.open().and_then([&client] { return client.identify(); });
    if (!identity) {
        std::cerr << describe(identity.error()) << '\n';
        return 1;
    }
    const auto status = client.exchangeStatus(1, 0);
    if (!status) {
        std::cerr << describe(status.error()) << '\n';
        return 1;
    }
    const auto state = static_cast<std::uint16_t>(status->state.value_or(State::Fault));
    std::cout << "firmware " << identity->firmwareVersion() << ", " << status->cycleCount << " cycles\n"
              << enumText("State", state) << '\n';
    return 0;
}
