// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_APPLICATION_HPP
#define SAFETY_CORE_KERNEL_APPLICATION_HPP

#include "safety_core/contract/device_fault.hpp"
#include "safety_core/contract/srdo.hpp"
#include "safety_core/kernel/communication_index.hpp"

#include <cstdint>

namespace counterpoint
{

enum class RefreshAnswer : std::uint8_t
{
    kInvalid = 0U,
    kReady = 0x69U, ///< Normal and inverse objects hold a consistent pair.
    kSkip = 1U,     ///< No consistent pair now.
};

/// Events of the logical program flow, delivered once a cycle with their count. [SRS_FLOW_004, SRS_FLOW_340]
enum class FlowEvent : std::uint8_t
{
    kInvalid = 0U,
    kSctChecked = 1U,
    kItIsTx = 2U,
    kItIsInvalid = 3U,
    kNotOperational = 4U,
    kSrdoError = 5U,
    kSrdoReceived = 6U,
    kSrdoTransmitted = 7U,
};

struct FlowCount
{
    FlowEvent event;
    std::uint16_t count;
};

/// What the device's application implements; what most devices leave empty has a body here. Called from within
/// Kernel::Cycle and Kernel::OnConfirm; must return soon (its time counts towards the cycle) and call nothing of the
/// kernel but its Get functions, SetStatus, Send (for the next cycle), SendGfc and DemandSafeState. [SRS_KRN_006]
class Application
{
  public:
    /// @brief A producer of form kProviderCalled is about to be sent: write both objects of its pair. As it stands
    /// here nothing is sent, and the missed refresh is an error of the SRDO. [SRS_KRN_012, SRS_KRN_040]
    [[nodiscard]] virtual RefreshAnswer OnRefresh(CommunicationIndex /*index*/) noexcept
    {
        return RefreshAnswer::kSkip;
    }
    /// @brief Consumer: a new pair was released into the objects. Producer: its pair is on the bus, confirmed.
    virtual void OnSrdoEvent(CommunicationIndex index) noexcept = 0;
    /// @brief A cause was signalled for this SRDO (kWaitingPastSct included, which is no error). Of several in one
    /// cycle the first cause of Kernel::GetState comes first, if it is among them; the others by number, which tells of
    /// no order in time. [SRS_KRN_570]
    virtual void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept = 0;
    /// @brief A GFC was accepted; the consumers are safe already.
    virtual void OnGfc() noexcept
    {
    }
    /// @brief An own GFC was not followed by an SRDO in time. [SRS_KRN_225]
    virtual void OnGfcNotFollowed() noexcept
    {
    }
    /// @brief OPERATIONAL was entered with a configuration that does not hold; SRDOs are off (emergency 6300h).
    /// [SRS_KRN_223]
    virtual void OnConfigurationInvalid(CommunicationIndex index) noexcept = 0;
    /// @brief The device safe state was entered. Called once. [SRS_KRN_342]
    virtual void OnDeviceFault(const DeviceFaultReport& report) noexcept = 0;
    /// @brief Only with the option FlowCallback::kOn. [SRS_FLOW_342]
    virtual void OnFlow(const FlowCount& /*count*/) noexcept
    {
    }

    Application(const Application&) = delete;
    Application(Application&&) = delete;
    Application& operator=(const Application&) = delete;
    Application& operator=(Application&&) = delete;

  protected:
    Application() noexcept = default;
    ~Application() noexcept = default;
};

} // namespace counterpoint

#endif
