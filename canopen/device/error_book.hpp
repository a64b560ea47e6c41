// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_ERROR_BOOK_HPP
#define CANOPEN_DEVICE_ERROR_BOOK_HPP

#include "canopen/cia301/emergency_producer.hpp"

#include <cstdint>

namespace counterpoint::device
{

/// What an error is about; each is an emergency error code of its own.
enum class Concern : std::uint8_t
{
    kHardware = 0U,      ///< 5000h
    kSoftware = 1U,      ///< 6100h
    kApplication = 2U,   ///< 6200h
    kConfiguration = 3U, ///< 6300h
    kModule = 4U,        ///< 7500h
    kCommunication = 5U, ///< 8100h
    kLostFrames = 6U,    ///< 8110h
    kBusPassive = 7U,    ///< 8120h
    kLostPartner = 8U,   ///< 8130h
    kBusOff = 9U,        ///< 8140h
    kFrameLength = 10U,  ///< 8210h
    kSrdo = 11U,         ///< 8250h
};
constexpr std::uint32_t kConcerns = 12U;

/// Who has the error: the device or the master (0), an SRDO by its number, a node by its node-ID.
struct ErrorSource
{
    std::uint8_t number; ///< 0 to 127.
};

/// One error: its source and what there is to tell beside it.
struct ErrorEvent
{
    ErrorSource source;
    std::uint8_t detail; ///< Cause of an SRDO, fault of the device.
};

/// Errors of a device by what they are about and who has them: an emergency starts with the first source and ends with
/// the last. [SRS-DEV-012..016]
class ErrorBook
{
  public:
    explicit ErrorBook(cia301::EmergencyProducer& emergency) noexcept;

    void Set(Concern concern, const ErrorEvent& event) noexcept;
    void End(Concern concern, ErrorSource source) noexcept;
    void EndAll(Concern concern) noexcept;
    [[nodiscard]] bool IsSet(Concern concern) const noexcept;

  private:
    static constexpr std::uint32_t kWordBits = 32U;
    static constexpr std::uint32_t kWords = 4U;

    cia301::EmergencyProducer& emergency_;
    std::uint32_t sources_[kConcerns][kWords];
};

} // namespace counterpoint::device

#endif
