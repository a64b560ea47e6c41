// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_MANAGER_RIG_HPP
#define TESTS_RUNTIME_MANAGER_RIG_HPP

#include "runtime/manager/report/status.hpp"
#include "runtime/manager/station.hpp"
#include "runtime/network_files/file.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>

namespace counterpoint::tools::test
{
using Lines = std::vector<std::string>;

constexpr std::uint32_t kRequests = 0x67FU;
constexpr std::uint32_t kAnswers = 0x5FFU;

/// Manager 127 on a bus of which the test is the other side.
class ManagerRig : public cia306::test::FolderTest
{
  protected:
    ManagerRig()
    {
        static_cast<void>(File("actuator.dcf", cia306::test::ExampleText("actuator")));
    }
    void Make(const std::string& text)
    {
        net = std::make_unique<network_plan::LoadedNetwork>(runtime::ReadNetworkFile(File("net.yaml", text), 0U));
        station = std::make_unique<runtime::ManagerStation>(
            *net,
            [this](const CanFrame& frame)
            {
                const bool is_taken = room > 0U;
                room -= is_taken ? 1U : 0U;
                if (is_taken)
                {
                    sent.push_back(frame);
                }
                return is_taken;
            },
            [this](const runtime::ManagerEvent& event) { events.push_back(event); });
        station->Begin(now_us);
    }
    void Run(const std::uint64_t ms)
    {
        for (std::uint64_t cycle = 0U; cycle < ms; ++cycle)
        {
            now_us += 1000U;
            station->OnCycle(now_us);
        }
    }
    /// Node 5, which is only supervised, is there: its start-up has ended.
    void EndStartUp()
    {
        Run(2U);
        Hear(0x705U, {0x00U});
        Run(2U);
        Hear(0x705U, {0x7FU});
        Run(2U);
    }
    void Hear(const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        CanFrame frame{};
        frame.identifier = identifier;
        frame.kind = FrameKind::kData;
        frame.length_bytes = static_cast<std::uint8_t>(data.size());
        std::copy(data.begin(), data.end(), &frame.data[0]);
        station->OnFrame(frame, now_us);
    }
    /// The slave answers each question about 1000h as given, for so many ms.
    void Answer(const std::uint8_t node, const std::vector<std::uint8_t>& answer, const int ms)
    {
        for (int i = 0; i < ms; ++i)
        {
            if (Count(0x600U + node) > 0U)
            {
                sent.clear();
                Hear(0x580U + node, answer);
            }
            Run(1U);
        }
    }
    /// The answer of the manager's SDO server to a request.
    std::vector<std::uint8_t> Ask(const std::vector<std::uint8_t>& request)
    {
        sent.clear();
        Hear(kRequests, request);
        Run(1U);
        for (const CanFrame& frame : sent)
        {
            if (frame.identifier == kAnswers)
            {
                return {&frame.data[0], &frame.data[0] + frame.length_bytes};
            }
        }
        return {};
    }
    static std::uint32_t NumberIn(const std::vector<std::uint8_t>& answer)
    {
        return answer.size() < 8U ? 0U
                                  : std::uint32_t{answer[4]} | std::uint32_t{answer[5]} << 8U |
                                        std::uint32_t{answer[6]} << 16U | std::uint32_t{answer[7]} << 24U;
    }
    /// The value; of an abort its code.
    std::uint32_t Read(const std::uint16_t index, const std::uint8_t sub)
    {
        return NumberIn(Ask({0x40U, static_cast<std::uint8_t>(index & 0xFFU), static_cast<std::uint8_t>(index >> 8U),
                             sub, 0U, 0U, 0U, 0U}));
    }
    /// 0, or the abort code.
    std::uint32_t Write(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                        const std::uint8_t bytes)
    {
        const auto command = static_cast<std::uint8_t>(0x23U | ((4U - bytes) << 2U));
        const std::vector<std::uint8_t> answer =
            Ask({command, static_cast<std::uint8_t>(index & 0xFFU), static_cast<std::uint8_t>(index >> 8U), sub,
                 static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
                 static_cast<std::uint8_t>((value >> 16U) & 0xFFU), static_cast<std::uint8_t>(value >> 24U)});
        return (!answer.empty() && answer[0] == 0x60U) ? 0U : NumberIn(answer);
    }
    /// A domain of 12 to 127 bytes, in segments: 0, or the abort code.
    std::uint32_t WriteDomain(const std::uint16_t index, const std::uint8_t sub,
                              const std::vector<std::uint8_t>& domain)
    {
        std::vector<std::uint8_t> answer =
            Ask({0x21U, static_cast<std::uint8_t>(index & 0xFFU), static_cast<std::uint8_t>(index >> 8U), sub,
                 static_cast<std::uint8_t>(domain.size()), 0U, 0U, 0U});
        for (std::size_t place = 0U; place < domain.size() && !answer.empty() && answer[0] != 0x80U; place += 7U)
        {
            const std::size_t bytes = std::min<std::size_t>(domain.size() - place, 7U);
            const std::size_t toggle = (place / 7U % 2U) << 4U;
            const bool is_last = place + bytes == domain.size();
            std::vector<std::uint8_t> segment(8U);
            segment[0] = static_cast<std::uint8_t>(toggle | ((7U - bytes) << 1U) | (is_last ? 1U : 0U));
            std::copy_n(domain.begin() + static_cast<std::ptrdiff_t>(place), bytes, segment.begin() + 1);
            answer = Ask(segment);
        }
        return (!answer.empty() && (answer[0] & 0xE0U) == 0x20U) ? 0U : NumberIn(answer);
    }
    /// A domain, in segments.
    std::vector<std::uint8_t> ReadDomain(const std::uint16_t index, const std::uint8_t sub)
    {
        std::vector<std::uint8_t> domain;
        std::uint8_t toggle = 0U;
        bool is_last = (Read(index, sub) & 0x80000000U) != 0U;
        while (!is_last)
        {
            const std::vector<std::uint8_t> answer =
                Ask({static_cast<std::uint8_t>(0x60U | toggle), 0U, 0U, 0U, 0U, 0U, 0U, 0U});
            if (answer.size() < 8U || (answer[0] & 0xE0U) != 0U)
            {
                return domain;
            }
            const std::size_t unused = (answer[0] >> 1U) & 7U;
            domain.insert(domain.end(), answer.begin() + 1, answer.end() - static_cast<std::ptrdiff_t>(unused));
            is_last = (answer[0] & 1U) != 0U;
            toggle ^= 0x10U;
        }
        return domain;
    }
    [[nodiscard]] runtime::StatusRow Row(const std::uint8_t node)
    {
        for (const runtime::StatusRow& row : runtime::StatusRows(*station, now_us))
        {
            if (row.node == node)
            {
                return row;
            }
        }
        return {};
    }
    [[nodiscard]] std::vector<std::string> Commands() const
    {
        std::vector<std::string> commands;
        for (const CanFrame& frame : sent)
        {
            if (frame.identifier == 0U)
            {
                commands.push_back(std::to_string(frame.data[0]) + " " + std::to_string(frame.data[1]));
            }
        }
        return commands;
    }
    [[nodiscard]] std::size_t Count(const std::uint32_t identifier) const
    {
        return static_cast<std::size_t>(std::count_if(sent.begin(), sent.end(), [identifier](const CanFrame& frame)
                                                      { return frame.identifier == identifier; }));
    }
    std::string Order(const std::string& line)
    {
        return station->Carry(runtime::ParseManagerOrder(line), now_us);
    }

    std::uint64_t now_us{0U};
    std::unique_ptr<network_plan::LoadedNetwork> net;
    std::size_t room{std::numeric_limits<std::size_t>::max()}; ///< Frames that the bus takes.
    std::vector<CanFrame> sent;
    std::vector<runtime::ManagerEvent> events;
    std::unique_ptr<runtime::ManagerStation> station;
};
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_MANAGER_RIG_HPP
