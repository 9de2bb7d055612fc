// SPDX-License-Identifier: Apache-2.0
// The download of one bank as a state machine of small steps: begin, blocks, seal (CRC-32 compared), optional
// comparison of every register read back, apply, wait until the status block reports it as active. Each step
// is one exchange, so that status and Stop go in between. After a broken connection the download continues at
// the missing block; after a restart of the controller it starts again.
#pragma once

#include "modbus/download/bank_reader.h"
#include "modbus/line/rtu_client.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace campanel::modbus {

enum class DownloadErrorKind : std::uint8_t {
    Link,                  // `link`; the download can go on after resume()
    ImageTooLong,          // `actual` registers, more than the `expected` ones of the controller's bank
    KindNotSupported,      // the controller cannot execute this program kind
    IntervalsNotSupported, // its processor is too slow for a table of intervals
    TransferRefused,       // see `transfer`
    ChecksumDiffers,       // the controller sealed other bytes than were sent
    RowsDiffer,            // the register at offset `offset` reads back differently
    CommandRefused,        // see `refusal`
    Withdrawn,             // the armed change was cancelled or discarded before it became active
};

// The running program is untouched in every case.
struct DownloadError {
    DownloadErrorKind kind = DownloadErrorKind::Link;
    LinkError link;
    TransferAnswer transfer;
    Refusal refusal = Refusal::None;
    std::uint32_t offset = 0;
    std::uint32_t expected = 0;
    std::uint32_t actual = 0;
};

class Download {
public:
    enum class Phase : std::uint8_t {
        Begin,
        Resuming, // asking for the missing block
        Blocks,
        Seal,
        Verify, // reading back, only on request
        Apply,
        AwaitActive,
        Active,
        Failed,
        Cancelled,
    };

    struct Options {
        ApplyMode mode = ApplyMode::NextCycle;
        std::uint16_t session = 1; // not 0, and not that of the last download
        bool verify = false;       // read every staged register back before applying
    };

    // Prepares the download of `image`, header and rows of the bank. The announced kind of program is that of
    // the header.
    Download(std::vector<std::uint16_t> image, const Identity& controller, Options options);

    // Performs one exchange, or none in AwaitActive and after the end. A Link error does not change the
    // phase: repeat the step, or call resume() after reopening the port. Any other error ends the download.
    [[nodiscard]] tl::expected<Phase, DownloadError> advance(RtuClient& client);

    // Handles every status block: it contains the generation before, and the proof of being active.
    [[nodiscard]] tl::expected<Phase, DownloadError> noteStatus(const StatusBlock& status);

    // Continues after the connection was lost and restored.
    void resume();

    // Disarms if armed, and clears the shadow bank. The active program does not change. Errors: Link
    // (repeat), or CommandRefused when the program became active meanwhile.
    [[nodiscard]] tl::expected<Phase, DownloadError> cancel(RtuClient& client);

    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] bool ended() const;
    // Returns 0..1 over the frames up to and including apply.
    [[nodiscard]] double progress() const;
    [[nodiscard]] std::uint32_t crc() const { return m_crc; }
    [[nodiscard]] const std::vector<std::uint16_t>& image() const { return m_image; }

private:
    using Step = tl::expected<Phase, DownloadError>;

    [[nodiscard]] Step begin(RtuClient& client);
    [[nodiscard]] Step askMissing(RtuClient& client);
    [[nodiscard]] Step sendBlock(RtuClient& client);
    [[nodiscard]] Step seal(RtuClient& client);
    [[nodiscard]] Step verify(RtuClient& client);
    [[nodiscard]] Step apply(RtuClient& client);
    [[nodiscard]] Step fail(DownloadError error);
    [[nodiscard]] Step refused(const TransferAnswer& answer);
    [[nodiscard]] bool beginAgain();
    [[nodiscard]] bool isStillBusy(const TransferAnswer& answer);
    [[nodiscard]] static Step linkFailed(const LinkError& error);
    [[nodiscard]] std::uint16_t blockCount() const;

    std::vector<std::uint16_t> m_image;
    Options m_options;
    std::uint16_t m_blockRegisters = 0;
    std::uint16_t m_bankRegisters = 0;
    std::uint16_t m_kind = 0;                 // kind of the image
    TableLayout m_layout = TableLayout::None; // of the image
    bool m_kindSupported = false;
    bool m_layoutSupported = false;
    std::uint32_t m_crc = 0;
    Phase m_phase = Phase::Begin;
    std::uint16_t m_nextBlock = 0;
    std::optional<BankReader> m_reader;
    std::optional<std::uint32_t> m_generationBefore;
    bool m_applySent = false;
    int m_beginnings = 0; // number of starts after the controller had lost the session
    bool m_isMismatchKnown = false;
    std::optional<std::chrono::steady_clock::time_point> m_busySince;
};

} // namespace campanel::modbus
