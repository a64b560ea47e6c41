// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_SAFETY_READER_HPP
#define CANOPEN_CIA302_NETWORK_SAFETY_READER_HPP

#include "canopen/cia302/network/start_up.hpp"

namespace counterpoint::cia302
{

/// What a start-up profile remembers of the readings of one slave. Zero-filled at first.
struct SafetyReading
{
    bool is_woken;    ///< STOPPED, and made PRE-OPERATIONAL to be read before its start.
    bool is_asked;    ///< The gate reads, or has read, before the start.
    bool is_checking; ///< Found OPERATIONAL: the gate reads.
    bool was_checked; ///< Found OPERATIONAL and read.
    bool is_unread;   ///< Stopped because it ran and did not answer.
};

/// How far a reading of a safety slave is.
enum class ReadingEnd : std::uint8_t
{
    kWaits = 0U,
    kBegun = 1U,   ///< In this call.
    kOpen = 2U,    ///< As expected: the slave may be started.
    kRefused = 3U, ///< See StartGate::Finding.
};

/// Decides when the gate reads a safety slave on behalf of a start-up profile: before its start, and when it runs
/// without having been read; and what happens to a slave that runs and cannot be read. `node` is 1 to 127, checked by
/// the caller. Nothing here waits.
class SafetyReader
{
  public:
    /// @brief The parts are kept by reference.
    explicit SafetyReader(const StartUpParts& parts) noexcept;

    /// @brief One step of the reading before a start. `is_deaf`: STOPPED, it has no SDO, and is made PRE-OPERATIONAL
    /// first. A gate that closes meanwhile reads once more.
    [[nodiscard]] ReadingEnd BeforeStart(SafetyReading& reading, NodeId node, bool is_deaf, Instant now) noexcept;
    /// @brief One step of the reading of a slave that runs. `is_suspect`: a reading is to begin, unless one is under
    /// way.
    [[nodiscard]] ReadingEnd OfRunning(SafetyReading& reading, NodeId node, bool is_suspect, Instant now) noexcept;
    /// @brief A safety slave that runs and cannot be read is stopped, and made PRE-OPERATIONAL at the next silence, as
    /// is any other with `is_to_wake`. What finds the queue full is tried at the next silence. [SRS_SFS_006]
    void StopUnread(bool& is_unread, NodeId node, bool is_to_wake, Instant now) noexcept;

  private:
    StartUpParts parts_;
};

} // namespace counterpoint::cia302

#endif
