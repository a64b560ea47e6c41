// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/two_cpu/board.hpp"

#include "hal/zynqmp/link/shared_link.hpp"

extern "C"
{
    // Symbols of the linker: the number of this processor plus 1, and the two directions of the link in the OCM.
    extern const std::uint8_t image_core[];
    extern counterpoint::zynqmp::LinkMailbox image_link_0[];
    extern counterpoint::zynqmp::LinkMailbox image_link_1[];
}

namespace counterpoint::two_cpu
{
namespace
{

constexpr std::uint32_t kFirstCan = 0xFF060000U;
constexpr std::uint32_t kCanBytes = 0x00010000U;
constexpr std::uint32_t kNanosecondsPerMicrosecond = 1000U;

std::uint32_t Core() noexcept
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(image_core)) - 1U;
}

volatile std::uint32_t& Can(const std::uint32_t offset) noexcept
{
    return *reinterpret_cast<volatile std::uint32_t*>(kFirstCan + (Core() * kCanBytes) + offset);
}

std::uint32_t WordOf(const std::uint8_t* const bytes) noexcept
{
    return (static_cast<std::uint32_t>(bytes[0]) << 24U) | (static_cast<std::uint32_t>(bytes[1]) << 16U) |
           (static_cast<std::uint32_t>(bytes[2]) << 8U) | bytes[3];
}

class OwnPorts final : public hal::CanPorts
{
  public:
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override
    {
        return hal::CanGuarantees{hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
    }
    [[nodiscard]] bool Take(CanFrame& frame) noexcept
    {
        const bool is_there = taken_ != put_;
        if (is_there)
        {
            frame = sent_[taken_ % kRoom];
            ++taken_;
        }
        return is_there;
    }

  private:
    static constexpr std::uint32_t kRoom = 8U;

    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override
    {
        if ((put_ - taken_) == kRoom)
        {
            return hal::TransmitStatus::kQueueFull;
        }
        Can(0x30U) = frame.identifier << 21U;
        Can(0x34U) = static_cast<std::uint32_t>(frame.length_bytes) << 28U;
        Can(0x38U) = WordOf(&frame.data[0]);
        Can(0x3CU) = WordOf(&frame.data[4]);
        sent_[put_ % kRoom] = frame;
        ++put_;
        return hal::TransmitStatus::kAccepted;
    }

    CanFrame sent_[kRoom]{};
    std::uint32_t put_{0U};
    std::uint32_t taken_{0U};
};

OwnPorts ports;
std::uint32_t last_count;
std::uint32_t rest; // Less than a microsecond, in nanoseconds.
std::uint32_t microseconds;

} // namespace

bool StartBoard() noexcept
{
    const std::uint32_t enable = 5U; // Cycle counter on, from zero.
    asm volatile("mcr p15, 0, %0, c9, c12, 0" ::"r"(enable));
    asm volatile("mcr p15, 0, %0, c9, c12, 1" ::"r"(0x80000000U));
    Can(0x00U) = 1U;
    Can(0x08U) = 1U;
    Can(0x0CU) = 0x1C9U;
    Can(0x04U) = 0U;
    Can(0x60U) = 0U;
    Can(0x00U) = 2U;
    return true;
}

Instant Now() noexcept
{
    std::uint32_t count = 0U;
    asm volatile("mrc p15, 0, %0, c9, c13, 0" : "=r"(count));
    const std::uint32_t passed = (count - last_count) + rest; // Looked at many times a second.
    last_count = count;
    microseconds += passed / kNanosecondsPerMicrosecond;
    rest = passed % kNanosecondsPerMicrosecond;
    return Instant{microseconds};
}

bool ReceiveFrame(CanFrame& frame) noexcept
{
    if ((Can(0x1CU) & 0x80U) == 0U)
    {
        return false;
    }
    frame = CanFrame{};
    frame.identifier = Can(0x50U) >> 21U;
    frame.length_bytes = static_cast<std::uint8_t>(Can(0x54U) >> 28U);
    const std::uint32_t words[2] = {Can(0x58U), Can(0x5CU)};
    for (std::uint32_t byte = 0U; byte < 8U; ++byte)
    {
        frame.data[byte] = static_cast<std::uint8_t>(words[byte / 4U] >> (24U - (8U * (byte % 4U))));
    }
    frame.kind = FrameKind::kData;
    frame.port = CanPortId::kFirst;
    Can(0x24U) = 0x80U;
    return true;
}

hal::CanPorts& Ports() noexcept
{
    return ports;
}

bool TakeSent(CanFrame& frame) noexcept
{
    return ports.Take(frame);
}

hal::CrossLink& Link() noexcept
{
    static zynqmp::SharedLink link{(Core() == 0U) ? image_link_0[0] : image_link_1[0],
                                   (Core() == 0U) ? image_link_1[0] : image_link_0[0]};
    return link;
}

void LetOthersRun() noexcept
{
    asm volatile("wfe");
}

} // namespace counterpoint::two_cpu
