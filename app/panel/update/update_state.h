// SPDX-License-Identifier: Apache-2.0
// The files that campanel-update leaves: how the last installation ended, and the version that can be put
// back.
#pragma once

#include <QString>

#include <optional>

namespace campanel::panel {

// The places of an update; the first two are empty outside of the kiosk.
struct UpdatePlaces {
    QString requestFolder{}; // the panel's, emptied by a power cut
    QString stagingFolder{}; // the panel's; package and signature are copied there
    QString stateFolder = QStringLiteral("/var/lib/campanel-update"); // of campanel-update
    QString keyFolder = QStringLiteral("/etc/campanel/package-keys");

    // Returns the places of the service that systemd has started, by its environment.
    [[nodiscard]] static UpdatePlaces ofService();
};

struct UpdateOutcome {
    QString kind;   // "update" or "back"
    QString result; // "done", "refused", "returned" (the version before is installed again) or "failed"
    QString reason; // of anything but "done"; see PackageSentences::failure()
    QString detail;
    QString data; // "restored" when the data of the version before were put back
    QString from; // versions
    QString to;
    QString utc; // when it ended

    bool operator==(const UpdateOutcome&) const = default;
};

struct WayBack {
    QString version; // the version to go back to
    QString over;    // the installed version; the way back ends with another one
    QString schema;  // of the data that the version to go back to can read
    QString utc;     // when its data were put aside

    bool operator==(const WayBack&) const = default;
};

struct UpdateState {
    bool isUnfinished = false;
    std::optional<UpdateOutcome> outcome{}; // only one that the panel has not reported yet
    std::optional<WayBack> back{};
};

// Reads a few small files; not for the GUI thread.
[[nodiscard]] UpdateState readUpdateState(const UpdatePlaces& places);
// Remembers that this outcome was reported.
void noteReported(const UpdatePlaces& places, const UpdateOutcome& outcome);

struct UpdateRequest {
    QString package{};   // path; empty: the way back
    QString installed{}; // path of the installed version's package where the stick has it, for the way back
};

// Copies what the request needs and writes it. The error is the system's reason.
[[nodiscard]] QString writeRequest(const UpdatePlaces& places, const UpdateRequest& request);
void withdrawRequest(const UpdatePlaces& places);

} // namespace campanel::panel
