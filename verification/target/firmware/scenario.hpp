// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_FIRMWARE_SCENARIO_HPP
#define VERIFICATION_TARGET_FIRMWARE_SCENARIO_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

/// Scenarios for the firmware examples: text that the emulator reads by semihosting and the host from a file. One event
/// a line, `#` begins a comment, times ascend:
///     <us> frame <identifier> <bytes>     a frame of another node is on the bus (hexadecimal)
///     <us> nmt operational|preoperational|stopped|resetnode|resetcommunication    the command to all nodes
///     <us> input <bits>                   the input pins from now on (hexadecimal)
///     <us> overflow                       frames were lost
///     <us> busoff on|off                  the controller takes no frame
///     <us> late <us>                      the next cycle comes so much later
///     <us> counterb stop|go               the second counter stands still
///     <us> expect outputs|gate <bits>     after the last cycle
///     <us> expect state <srdo> off|waiting|faulted|released|producer
///     <us> expect fault <number>          device fault, 90 is none
///     <us> expect sent <count>            frames since the start
///     <us> expect last <identifier> <bytes>
///     <us> end
namespace counterpoint::target
{

enum class Verb : std::uint8_t
{
    kInvalid = 0U,
    kFrame = 1U,
    kNmt = 2U,
    kInput = 3U,
    kOverflow = 4U,
    kBusOff = 5U,
    kLate = 6U,
    kCounterB = 7U,
    kExpectOutputs = 8U,
    kExpectGate = 9U,
    kExpectState = 10U,
    kExpectFault = 11U,
    kExpectSent = 12U,
    kExpectLast = 13U,
    kEnd = 14U,
};

/// One line. `value` is what the verb has as its argument: a number, or the numeric value of its word.
struct Event
{
    std::uint32_t at_us;
    std::uint32_t line;
    std::uint32_t value;
    std::uint32_t srdo; ///< kExpectState only.
    CanFrame frame;     ///< kFrame and kExpectLast only.
    Verb verb;          ///< kInvalid: the line cannot be read.
};

/// Reads a text line by line.
class Scenario
{
  public:
    explicit Scenario(const char* text) noexcept;

    /// @brief The next event. After the text, or after a line that cannot be read: kEnd or kInvalid, for ever.
    [[nodiscard]] Event Next() noexcept;

  private:
    void SkipToEvent() noexcept;
    void SkipBlanks() noexcept;
    [[nodiscard]] bool IsAtEnd() const noexcept;
    [[nodiscard]] bool Takes(const char* word) noexcept;
    [[nodiscard]] std::uint32_t Number(std::uint32_t base) noexcept;
    void ReadVerb(Event& event) noexcept;
    void ReadExpectation(Event& event) noexcept;
    void ReadFrame(Event& event) noexcept;
    void ReadChoice(Event& event, const char* const* words, std::uint32_t count) noexcept;

    const char* place_;
    std::uint32_t line_{1U};
    bool is_good_{true};
};

} // namespace counterpoint::target

#endif
