// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA302_FLYING_MASTER_RIG_HPP
#define TESTS_CANOPEN_CIA302_FLYING_MASTER_RIG_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace counterpoint::cia302
{

/// One flying master with a cycle of 1 ms; what it sends and tells is written down as "<ms> <what>":
/// "500 073", "600 000 82 00", "600 power-on reset", "600 initialising", "2720 master 1/2".
class FlyingRig final : public cia301::FrameSink, public FlyingMasterListener
{
  public:
    FlyingRig(const std::uint8_t node, const std::uint8_t level, const FlyingMasterOptions& how)
        : times(DefaultTimes(NodeId{node})), options(how), setup{NodeId{node}, 0x21U, 0U, 0U, 0U, slaves.data()},
          master(FlyingMasterParts{setup, times, options, *this, *this})
    {
        times.priority = level;
    }

    /// @brief The application lets it begin, and again after each reset.
    void Start()
    {
        restarts_itself = true;
        static_cast<void>(master.Start(Now()));
    }
    /// @brief Cycles up to and including `ms`.
    void RunTo(const std::uint32_t ms)
    {
        while (now_ms < ms)
        {
            ++now_ms;
            master.OnCycle(Now());
        }
    }
    void Hear(const std::uint32_t identifier, const std::vector<std::uint8_t>& data = {})
    {
        CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(data.size()), {}};
        std::copy(data.begin(), data.end(), frame.data);
        master.OnFrame(frame, Now());
    }
    /// @brief What was written down since the last call.
    std::vector<std::string> Log()
    {
        std::vector<std::string> log{};
        log.swap(log_);
        return log;
    }
    /// @brief A slave of `claim` at 500 ms, with nothing written down.
    void MakeSlave(const std::vector<std::uint8_t>& claim)
    {
        Start();
        RunTo(500U);
        Hear(0x71U, claim);
        static_cast<void>(Log());
    }
    /// @brief The active master by its own slot, with nothing written down; returns when.
    std::uint32_t MakeMaster()
    {
        Start();
        while (!master.IsActiveMaster() && (now_ms < 10'000U))
        {
            RunTo(now_ms + 1U);
        }
        static_cast<void>(Log());
        return now_ms;
    }

    bool Send(const CanFrame& frame) noexcept override
    {
        const bool is_taken = refuses == 0U;
        refuses -= is_taken ? 0U : 1U;
        if (is_taken)
        {
            std::array<char, 16> text{};
            std::snprintf(text.data(), text.size(), "%03X", static_cast<unsigned>(frame.identifier));
            std::string line = text.data();
            for (std::uint8_t i = 0U; i < frame.length_bytes; ++i)
            {
                std::snprintf(text.data(), text.size(), " %02X", static_cast<unsigned>(frame.data[i]));
                line += text.data();
            }
            Write(line);
        }
        return is_taken;
    }
    void OnFlyingMaster(const FlyingEvent event, const MasterClaim& claim, const Instant /*now*/) noexcept override
    {
        static const char* const kNames[6] = {"?",      "slave of",           "force", "power-on reset",
                                              "master", "configuration error"};
        const bool has_claim = (claim.level != 0U) || (claim.node.value != 0U);
        const std::string tail = std::to_string(claim.level) + "/" + std::to_string(claim.node.value);
        Write(std::string(kNames[static_cast<std::uint8_t>(event)]) + (has_claim ? (" " + tail) : ""));
    }
    void OnInitialising(const Instant now) noexcept override
    {
        Write("initialising");
        if (restarts_itself)
        {
            static_cast<void>(master.Start(now));
        }
    }

    [[nodiscard]] Instant Now() const
    {
        return Instant{begin_us + (now_ms * 1000U)};
    }

    std::array<SlaveSetup, kNodeRoom> slaves{};
    FlyingMasterTimes times;
    FlyingMasterOptions options;
    NetworkSetup setup;
    FlyingMaster master;
    std::uint32_t now_ms{0U};
    std::uint32_t begin_us{0xFFF0'0000U}; ///< The counter of time turns over after 1048 ms.
    std::uint32_t refuses{0U};            ///< So many frames are not taken.
    bool restarts_itself{false};

  private:
    void Write(const std::string& what)
    {
        log_.push_back(std::to_string(now_ms) + " " + what);
    }

    std::vector<std::string> log_{};
};

using Lines = std::vector<std::string>;

} // namespace counterpoint::cia302

#endif
