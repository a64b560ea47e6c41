// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_IMAGE_MAILBOX_HPP
#define VERIFICATION_INJECTION_IMAGE_MAILBOX_HPP

#include <cstdint>

/// What image and injector share: one page that only the injector writes, and ports that only it reads. A fault in the
/// image can change neither what the world does nor what was seen of it.
namespace counterpoint::injection
{

constexpr std::uint32_t kMailboxAddress = 0x30000000U;
constexpr std::uint32_t kPortAddress = 0x40000000U;

constexpr std::uint32_t kMostFrames = 8U;
constexpr std::uint32_t kMostWrites = 8U;

/// A frame of the bus: received, or one of this device that was sent.
struct MailFrame
{
    std::uint32_t is_confirmation;
    std::uint32_t identifier;
    std::uint32_t length_bytes;
    std::uint32_t first;  ///< Bytes 0 to 3, byte 0 in the highest bits.
    std::uint32_t second; ///< Bytes 4 to 7.
    std::uint32_t stamp_us;
};

/// A write of an object by SDO.
struct MailWrite
{
    std::uint32_t index;
    std::uint32_t sub;
    std::uint32_t value;
    std::uint32_t size_bytes;
};

/// One step: what happens on the bus, then one cycle. Words in the order of the processor.
struct Mailbox
{
    std::uint32_t now_us;
    std::uint32_t acknowledge_a;
    std::uint32_t acknowledge_b;
    std::uint32_t nmt; ///< 0: stays.
    std::uint32_t question;
    std::uint32_t send_index; ///< 0: nothing is sent.
    std::uint32_t sent_value;
    std::uint32_t is_demanded; ///< Device safe state.
    std::uint32_t is_gfc_sent;
    std::uint32_t is_checked; ///< CheckConfiguration.
    std::uint32_t is_signed;  ///< All SRDOs are signed and declared valid after the writes.
    std::uint32_t frame_count;
    std::uint32_t write_count;
    MailFrame frames[kMostFrames];
    MailWrite writes[kMostWrites];
};

/// Ports, as offsets from kPortAddress.
constexpr std::uint32_t kPortIdentifier = 0x00U;
constexpr std::uint32_t kPortLength = 0x04U;
constexpr std::uint32_t kPortFirst = 0x08U;
constexpr std::uint32_t kPortSecond = 0x0CU; ///< The frame is sent.
constexpr std::uint32_t kPortAnswer = 0x10U;
constexpr std::uint32_t kPortEvent = 0x14U;
constexpr std::uint32_t kPortDeviceFault = 0x18U;
constexpr std::uint32_t kPortRefused = 0x1CU; ///< The image could not do what it was told.

} // namespace counterpoint::injection

#endif
