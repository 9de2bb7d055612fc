// SPDX-License-Identifier: Apache-2.0
// The configuration file: any bytes give values and complaints, never the end of the program. Each complaint
// names the file.
#include "app/panel/settings/setting_values.h"
#include "app/shell/configuration.h"
#include "tests/fuzz/fuzz_target.h"

namespace campanel::fuzz {

void runTarget(std::span<const std::uint8_t> bytes)
{
    const QByteArray text(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    const QString file = QStringLiteral("campanel.toml");
    const shell::ReadConfiguration read = shell::configurationFrom(text, file);
    require(read.complaints.size() <= 61, "the complaints are bounded");
    for (const QString& complaint : read.complaints)
        require(complaint.startsWith(file), "a complaint names its file");
}

std::vector<Bytes> targetSeeds()
{
    return {bytesOf("[connection]\nsimulated = false\nport = \"/dev/ttyS0\"\nbaud = 115200\nunit = 1\n"
                    "[display]\nlanguage = \"de\"\ntouch_sounds = true\n"),
            bytesOf("# nothing\n[gateway]\nenabled = true\nhost = 'broker'\nport = 8883\n"
                    "[simulation]\nfaults = [\"late times=1.5\", \"echo\"]\n"),
            bytesOf("[a.b]\nx = { y = 1, z = [1, 2.5e3, 0x1F, 1979-05-27T07:32:00Z, inf, nan] }\n[[t]]\n"
                    "s = \"\"\"\nlong \\u00e4\"\"\"\n")};
}

} // namespace campanel::fuzz
