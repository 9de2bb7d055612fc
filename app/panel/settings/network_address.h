// SPDX-License-Identifier: Apache-2.0
// The IPv4 address of a network port as a person enters it: by DHCP, or fixed with mask, gateway and DNS
// server. The checks end in a sentence that says what to do.
#pragma once

#include <QCoreApplication>
#include <QString>

#include <array>
#include <optional>

namespace campanel::panel {

// Strict: four numbers with points. Qt also reads "10.1" as 10.0.0.1.
[[nodiscard]] std::optional<quint32> ipv4From(const QString& text);
[[nodiscard]] QString ipv4Text(quint32 address);
// Reads a mask, "255.255.255.0", or its length, "24"; 1 to 30.
[[nodiscard]] std::optional<int> prefixFrom(const QString& text);
[[nodiscard]] QString maskText(int prefix);

// Between the addresses of several DNS servers.
inline const QString listSeparator = QStringLiteral(", ");

class NetworkAddress {
    Q_DECLARE_TR_FUNCTIONS(NetworkAddress)

public:
    enum class Method { Dhcp, Fixed, Other }; // other: shared, link-local, switched off
    enum Field { Address, Mask, Gateway, NameServer };
    static constexpr std::array allFields{Address, Mask, Gateway, NameServer};

    Method method = Method::Other;
    std::array<QString, allFields.size()> fields; // empty: none; of DNS servers a list

    bool operator==(const NetworkAddress&) const = default;

    [[nodiscard]] static QString label(Field field);
    [[nodiscard]] static QString hint(Field field);
    // Returns why this text is no entry of the field; empty: it is one.
    [[nodiscard]] static QString refusal(Field field, const QString& text);
    // Returns why the entries do not fit together; empty: they do.
    [[nodiscard]] QString refusal() const;
    // Returns the entries in one line, for the audit trail: "10.0.0.2/24, gateway 10.0.0.1", "DHCP".
    [[nodiscard]] QString text() const;

private:
    [[nodiscard]] QString gatewayRefusal(quint32 address, quint32 mask) const;
};

} // namespace campanel::panel
