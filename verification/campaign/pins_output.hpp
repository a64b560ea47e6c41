// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_PINS_OUTPUT_HPP
#define VERIFICATION_CAMPAIGN_PINS_OUTPUT_HPP

#include "hal/api/clocks.hpp"
#include "hal/tms570/output/safety_pins.hpp"
#include "verification/campaign/device.hpp"

#include <vector>

namespace counterpoint::campaign
{
/// @brief The output of a port to the TMS570: its shipped safety pins over two ports of pins, pin n for slot n. Adds
/// the members that are hit. Throws std::runtime_error for a device that has more consumers than a port has pins.
/// [SRS_CMG_042]
[[nodiscard]] FlatOutput& MakePinsOutput(Region& region, const DeviceConfig& config, std::vector<Place>& places);

/// Registers of both ports of pins, as far as a safety output reaches them.
struct FlatPort
{
    std::uint32_t direction;
    std::uint32_t output;
};

/// @brief The ports that the drivers reach from now on; port A is first.
void UsePorts(FlatPort* ports) noexcept;

/// Counter A of the board is the time of the bus.
class FlatClocks final : public hal::Clocks
{
  public:
    explicit FlatClocks(const Instant& now) noexcept : now_(now)
    {
    }
    [[nodiscard]] InstantPair Now() noexcept override
    {
        return {now_, now_};
    }

  private:
    const Instant& now_;
};

/// Safety pins of whatever make as the output of the device under test.
template <typename Pins> class PinsOutput final : public FlatOutput
{
  public:
    explicit PinsOutput(FlatPort& port) noexcept : port_(port)
    {
    }

    [[nodiscard]] std::uint32_t Challenge() noexcept override
    {
        return pins.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        pins.Drive(permits);
    }
    [[nodiscard]] SrdoMask Open() noexcept override
    {
        return port_.direction & port_.output;
    }
    void Examine() noexcept override
    {
        is_live = pins.Examine() == tms570::Outcome::kDone;
    }

    FlatClocks clocks{now};
    Pins pins{clocks};

  private:
    FlatPort& port_;
};

/// A member of the pins.
struct PinsMember
{
    const char* name;
    std::size_t offset;
    std::size_t size;
};

/// @brief The pin of each slot that has one.
[[nodiscard]] tms570::SafetyPinsSetup PinsOf(const DeviceConfig& config);
/// @brief Throws std::runtime_error unless the pins have started.
void RequireStarted(tms570::Outcome outcome);

/// @brief Makes it in the region; `members` are what is hit.
template <typename Pins, std::size_t kCount>
FlatOutput& MakePins(Region& region, const DeviceConfig& config, const PinsMember (&members)[kCount],
                     std::vector<Place>& places)
{
    FlatPort* const ports = region.MakeArray<FlatPort>(2U);
    UsePorts(ports);
    auto& output = region.Make<PinsOutput<Pins>>(ports[0]);
    RequireStarted(output.pins.Start(PinsOf(config)));
    for (const PinsMember& member : members)
    {
        places.push_back({Part::kPins, member.name, region.OffsetOf(&output.pins) + member.offset, member.size});
    }
    return output;
}
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_PINS_OUTPUT_HPP
