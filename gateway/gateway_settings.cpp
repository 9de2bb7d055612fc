// SPDX-License-Identifier: Apache-2.0
#include "gateway/gateway_settings.h"

#include <QFileInfo>
#include <QRegularExpression>

using namespace Qt::StringLiterals;

namespace campanel::gateway {

namespace {

// Returns true for an error about a key of another section, as configuration.cpp words it.
bool isOfOtherSection(const QString& complaint)
{
    static const QRegularExpression otherKey(
        u":\\d+: (?:there is no key )?(?!gateway\\.)[a-z_]+\\.[a-z_]+\\b"_s);
    return otherKey.match(complaint).hasMatch();
}

} // namespace

ReadGatewaySettings gatewaySettings(const shell::ReadConfiguration& read, const QString& computer)
{
    const panel::SettingValues& values = read.values;
    ReadGatewaySettings result;
    GatewaySettings& settings = result.settings;
    settings = {values.text("gateway.host"), values.whole("gateway.port"),
                values.text("gateway.ca"),   values.text("gateway.certificate"),
                values.text("gateway.key"),  values.text("gateway.group"),
                values.text("gateway.node"), values.text("gateway.primary_host")};
    if (settings.node.isEmpty())
        settings.node = computer;
    for (const QString& complaint : read.complaints)
        (isOfOtherSection(complaint) ? result.warnings : result.errors) << complaint;
    if (settings.group.isEmpty())
        result.errors << u"gateway.group is empty. Name the group."_s;
    if (settings.node.isEmpty())
        result.errors << u"gateway.node is empty and the computer has no name. Name the node."_s;
    if (settings.certificate.isEmpty() != settings.key.isEmpty())
        result.errors << u"gateway.certificate and gateway.key belong together. Set both, or neither."_s;
    if (!settings.certificate.isEmpty() && settings.ca.isEmpty())
        result.errors << u"gateway.certificate needs gateway.ca: without it the connection has no TLS."_s;
    for (const auto& [key, path] :
         {std::pair(u"ca"_s, settings.ca), std::pair(u"certificate"_s, settings.certificate),
          std::pair(u"key"_s, settings.key)}) {
        if (!path.isEmpty() && !(QFileInfo(path).isFile() && QFileInfo(path).isReadable()))
            result.errors << u"gateway.%1: %2 cannot be read."_s.arg(key, path);
    }
    if (!settings.host.isEmpty() && !settings.isEncrypted())
        result.warnings << u"The connection to %1 is not encrypted: gateway.ca is not set."_s.arg(
            settings.host);
    return result;
}

} // namespace campanel::gateway
