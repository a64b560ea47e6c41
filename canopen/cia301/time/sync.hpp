// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_TIME_SYNC_HPP
#define CANOPEN_CIA301_TIME_SYNC_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia301/emergency/communication_errors.hpp"
#include "canopen/cia301/nmt/frame_sink.hpp"

namespace counterpoint::cia301
{

/// A SYNC that was received, or sent by this device.
struct SyncEvent
{
    std::uint8_t counter;    ///< 1 to 1019h; 0: SYNC has no counter.
    std::uint32_t window_us; ///< 1007h; 0: no limit.
    Moment moment;
};

/// Is told of each SYNC, in PRE-OPERATIONAL and OPERATIONAL.
class SyncListener
{
  public:
    /// @brief Called within OnFrame or OnCycle of Sync.
    virtual void OnSync(const SyncEvent& event) noexcept = 0;

  protected:
    SyncListener() noexcept = default;
    ~SyncListener() noexcept = default;
    SyncListener(const SyncListener&) = default;
    SyncListener& operator=(const SyncListener&) = default;
};

/// What SYNC works with; all kept by reference.
struct SyncParts
{
    FrameSink& sink;
    CommunicationErrors& errors;
    SyncListener& listener;
};

/// SYNC consumer and producer with 1005h, 1006h, 1007h and 1019h, whose hook it is. OnCycle at least once in 2^30 us.
/// Not reentrant. [SRS_SYNC_005, SRS_SYNC_006]
class Sync final : public NumberHook
{
  public:
    /// @brief As after Reset.
    explicit Sync(const SyncParts& parts) noexcept;

    /// @brief Reset communication: 1005h is 80h, the others 0.
    void Reset() noexcept;
    /// @brief Whether SYNC has this identifier. O(1)
    [[nodiscard]] bool Uses(std::uint32_t identifier) const noexcept;
    /// @brief A frame from the bus. O(1) + listener [SRS_SYNC_001, SRS_SYNC_002]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept;
    /// @brief Sends the SYNC that is due. O(1) + listener [SRS_SYNC_003, SRS_SYNC_004]
    void OnCycle(const Moment& moment) noexcept;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;
    [[nodiscard]] SdoAbort WriteCobId(std::uint32_t value) noexcept;
    [[nodiscard]] SdoAbort WriteOverflow(std::uint32_t value) noexcept;

    SyncParts parts_;
    std::uint32_t cob_id_;
    std::uint32_t period_us_;
    std::uint32_t window_us_;
    std::uint8_t overflow_; ///< 1019h.
    std::uint8_t counter_;  ///< Last one sent; 0 at first.
    bool is_running_;       ///< One was sent; it was due at `due_`.
    Instant due_;
};

} // namespace counterpoint::cia301

#endif
