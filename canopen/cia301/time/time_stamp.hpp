// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_TIME_TIME_STAMP_HPP
#define CANOPEN_CIA301_TIME_TIME_STAMP_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia301/nmt/bus_service.hpp"

namespace counterpoint::cia301
{

/// A moment as the network tells it.
struct TimeOfDay
{
    std::uint32_t ms;   ///< After midnight, 28 bits.
    std::uint16_t days; ///< Since 1 January 1984.
};

/// Is told of the times that the network sends.
class TimeListener
{
  public:
    /// @brief A time was received at `now` of this device's counter.
    virtual void OnTime(const TimeOfDay& time, Instant now) noexcept = 0;

  protected:
    TimeListener() noexcept = default;
    ~TimeListener() noexcept = default;
    TimeListener(const TimeListener&) = default;
    TimeListener& operator=(const TimeListener&) = default;
};

/// TIME consumer and producer with 1012h and 1013h, whose hook it is. 1013h counts microseconds of the device and may
/// be set; with PDOs that map it devices share one count. Sink and listener are kept by reference. Not reentrant.
/// [SRS_TIM_004]
class TimeStamp final : public NumberHook, public BusService
{
  public:
    TimeStamp(FrameSink& sink, TimeListener& listener) noexcept;

    [[nodiscard]] bool Wants(std::uint32_t identifier) const noexcept override;
    [[nodiscard]] bool Uses(std::uint32_t identifier) const noexcept override;
    /// @brief Reset communication: 1012h is 100h, neither consumed nor produced; 1013h is the time of the device.
    void ResetCommunication(NodeId node) noexcept override;
    [[nodiscard]] NumberHook* Objects() noexcept override
    {
        return this;
    }
    /// @brief A frame from the bus. O(1) [SRS_TIM_001]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept override;
    /// @brief Sets what 1013h reads until the next call. O(1)
    void OnCycle(const Moment& moment) noexcept override;
    /// @brief Sends a time. False: 1012h or the state does not allow it, or the sink has no room; a time is not kept
    /// for later. [SRS_TIM_002]
    [[nodiscard]] bool Send(const TimeOfDay& time, const Moment& moment) noexcept;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;

    FrameSink& sink_;
    TimeListener& listener_;
    std::uint32_t cob_id_;
    std::uint32_t now_us_;
    std::uint32_t ahead_us_; ///< 1013h less the time of the device, modular.
};

} // namespace counterpoint::cia301

#endif
