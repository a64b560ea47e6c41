// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_OUTSIDE_HPP
#define VERIFICATION_INJECTION_OUTSIDE_HPP

#include "verification/injection/digest.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::injection
{

/// A frame that the image has sent.
struct SentFrame
{
    std::uint32_t identifier;
    std::uint32_t length_bytes;
    std::uint32_t first;
    std::uint32_t second;

    bool operator==(const SentFrame& other) const
    {
        return (identifier == other.identifier) && (length_bytes == other.length_bytes) && (first == other.first) &&
               (second == other.second);
    }
};

/// Values of an object and of its inverse one.
struct ObjectPair
{
    std::uint32_t normal;
    std::uint32_t inverse;

    bool operator==(const ObjectPair& other) const
    {
        return (normal == other.normal) && (inverse == other.inverse);
    }
};

enum class StepEnd : std::uint8_t
{
    kDone,
    kException, ///< Access, instruction or call that the processor refuses.
    kRunaway,   ///< Many times as long as without a fault: the watchdog is not answered.
};

/// What a step showed outside.
struct Seen
{
    StepEnd end{StepEnd::kDone};
    std::uint32_t pins{0U}; ///< High at the end of the step.
    std::uint32_t refused{0U};
    std::uint32_t device_fault{0U};
    std::uint32_t answer{0U};
    bool is_answered{false};
    bool is_cut_off{false};
    std::vector<SentFrame> sent{};
    std::vector<std::uint32_t> events{};
    std::array<ObjectPair, 3> objects{};
};

/// What the image has outside of RAM and processor: pins, and frames on their way.
struct World
{
    std::uint32_t direction[2]{};
    std::uint32_t output[2]{};
    bool is_error_pin_low{false};
    std::vector<SentFrame> pending{};

    bool operator==(const World& other) const
    {
        return (direction[0] == other.direction[0]) && (direction[1] == other.direction[1]) &&
               (output[0] == other.output[0]) && (output[1] == other.output[1]) &&
               (is_error_pin_low == other.is_error_pin_low) && (pending == other.pending);
    }
};

constexpr std::uint32_t kPage = 0x1000U;
constexpr std::uint32_t kGio = 0xFFF7BC00U;

/// Registers of the pins and the ports of the mailbox: what the image reads and writes there.
class Outside
{
  public:
    [[nodiscard]] std::uint32_t ReadPort(std::uint32_t address) const;
    void WritePort(std::uint32_t address, std::uint32_t value);
    /// @brief A step begins: nothing is seen of it, and what was sent is on the bus.
    void Begin();
    /// @brief A step has ended.
    [[nodiscard]] const Seen& End(StepEnd end, const std::array<ObjectPair, 3>& objects);
    /// @brief Adds what the next steps depend on.
    void Add(Digest& to) const;
    [[nodiscard]] const World& Now() const
    {
        return world_;
    }

  private:
    void WritePin(std::uint32_t offset, std::uint32_t value);

    World world_{};
    Seen seen_{};
    SentFrame sending_{};
};

} // namespace counterpoint::injection

#endif
