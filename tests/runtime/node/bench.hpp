// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_NODE_BENCH_HPP
#define TESTS_RUNTIME_NODE_BENCH_HPP

#include "runtime/node/device.hpp"
#include "runtime/node/orders.hpp"
#include "tests/tools/echo_bus.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace counterpoint::tools::test
{
/// An example of the emergency stop with other ParameterValues.
inline std::string FileWith(const std::string& example, const std::map<std::string, std::string>& values)
{
    std::ifstream file(std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/" + example + ".dcf");
    std::string section;
    std::ostringstream text;
    for (std::string line; std::getline(file, line);)
    {
        section = (line.rfind('[', 0U) == 0U) ? line.substr(1U, line.find(']') - 1U) : section;
        const auto value = values.find(section);
        const bool is_other = line.rfind("ParameterValue=", 0U) == 0U && value != values.end();
        text << (is_other ? "ParameterValue=" + value->second : line) << "\n";
    }
    const std::string name = ::testing::TempDir() + example + "_other_values.dcf";
    std::ofstream(name) << text.str();
    return name;
}

/// An example of the emergency stop whose objects of these sections are INTEGER8.
inline std::string FileOfSigned(const std::string& example, const std::set<std::string>& sections)
{
    std::ifstream file(FileWith(example, {{"5F04", "0"}}));
    std::string section;
    std::ostringstream text;
    for (std::string line; std::getline(file, line);)
    {
        section = (line.rfind('[', 0U) == 0U) ? line.substr(1U, line.find(']') - 1U) : section;
        const bool is_other = line.rfind("DataType=", 0U) == 0U && sections.count(section) != 0U;
        text << (is_other ? "DataType=0x0002" : line) << "\n";
    }
    const std::string name = ::testing::TempDir() + example + "_signed.dcf";
    std::ofstream(name) << text.str();
    return name;
}

/// A device of a file, in a time that the test makes: cycle 5 ms.
class Bench
{
  public:
    explicit Bench(const std::string& file, const std::string& store = "",
                   const runtime::ReportForm form = runtime::ReportForm::kText,
                   const std::optional<std::uint8_t> node_id = std::nullopt)
        : report_(out_, form, 0U)
    {
        runtime::NodeSettings settings;
        settings.dcf = file;
        settings.store = store;
        settings.node_id = node_id;
        settings.cycle_us = 5000U;
        settings.has_self_tests = false;
        auto safety = std::make_unique<EchoBus>(false, 0U);
        auto services = std::make_unique<EchoBus>(false, 0U);
        safety_ = safety.get();
        services_ = services.get();
        ports_ = std::make_unique<runtime::NodePorts>(std::move(safety), std::move(services));
        device_ = std::make_unique<runtime::NodeDevice>(settings, *ports_, report_);
        device_->TellStart("udp:1", now_ns_);
        EXPECT_TRUE(device_->PowerOn(Now(), now_ns_));
        static_cast<void>(device_->TakeRestart(now_ns_));
    }
    /// The abort code of an expedited download; 0: none.
    std::uint32_t Download(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                           const std::uint8_t size)
    {
        const auto byte = [](const std::uint32_t number, const unsigned place)
        { return static_cast<std::uint8_t>((number >> (8U * place)) & 0xFFU); };
        const auto command = static_cast<std::uint8_t>(0x23U | ((4U - size) << 2U));
        Receive(0x600U + device_->Assembly().NodeId(), {command, byte(index, 0U), byte(index, 1U), sub, byte(value, 0U),
                                                        byte(value, 1U), byte(value, 2U), byte(value, 3U)});
        Cycle();
        std::uint32_t code = 0xFFFFFFFFU; // No answer.
        for (const host::LiveFrame& frame : services_->Sent())
        {
            if (frame.identifier == 0x580U + device_->Assembly().NodeId())
            {
                code = frame.data[4] | (std::uint32_t{frame.data[5]} << 8U) | (std::uint32_t{frame.data[6]} << 16U) |
                       (std::uint32_t{frame.data[7]} << 24U);
            }
        }
        return code;
    }
    /// All of SRDO 1 in the order of the procedure, direction behind its identifiers.
    void Configure(const std::uint8_t direction, const std::uint16_t sct_ms, const std::uint32_t cob_id_1,
                   const std::vector<std::uint32_t>& entries, const std::uint16_t signature)
    {
        EXPECT_EQ(Download(0x1301U, 2U, sct_ms, 2U), 0U);
        EXPECT_EQ(Download(0x1301U, 3U, 20U, 1U), 0U);
        EXPECT_EQ(Download(0x1301U, 5U, cob_id_1, 4U), 0U);
        EXPECT_EQ(Download(0x1301U, 6U, cob_id_1 + 1U, 4U), 0U);
        for (std::size_t number = 0U; number < entries.size(); ++number)
        {
            EXPECT_EQ(Download(0x1381U, static_cast<std::uint8_t>(number + 1U), entries[number], 4U), 0U);
        }
        EXPECT_EQ(Download(0x1381U, 0U, static_cast<std::uint32_t>(entries.size()), 1U), 0U);
        EXPECT_EQ(Download(0x1301U, 1U, direction, 1U), 0U);
        EXPECT_EQ(Download(0x13FFU, 1U, signature, 2U), 0U);
        EXPECT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0U);
    }
    void Start()
    {
        Command(1U);
        EXPECT_EQ(device_->Assembly().Device().State(), cia301::NodeState::kOperational);
    }
    /// An NMT command to this node, and a cycle.
    void Command(const std::uint8_t command)
    {
        Receive(0x000U, {command, device_->Assembly().NodeId()});
        Cycle();
    }
    /// One object of SRDO 1 as a commissioner changes it in PRE-OPERATIONAL; false: without 13FEh = A5h behind it.
    void Change(const std::uint8_t sub, const std::uint32_t value, const std::uint8_t size,
                const bool is_declared = true)
    {
        Command(128U);
        EXPECT_EQ(Download(0x1301U, sub, value, size), 0U);
        if (is_declared)
        {
            EXPECT_EQ(Download(0x13FFU, 1U, device_->Assembly().Core().Sign({0x1301U}).signature, 2U), 0U);
            EXPECT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0U);
        }
    }
    /// What a person types.
    void Order(const std::string& line)
    {
        EXPECT_TRUE(runtime::NodeOrders(*ports_, report_).Carry(runtime::ParseOrder(line), *device_, {Now(), now_ns_}));
    }
    /// Saves or restores, and waits for its end.
    void Store(const std::uint16_t index, const std::uint32_t word)
    {
        static_cast<void>(Download(index, 1U, word, 4U)); // Answered at its end.
        AwaitStore();
    }
    /// Cycles until the store is at rest, and one for its answer.
    void AwaitStore()
    {
        for (int wait = 0; wait < 60000 && device_->IsSaving(); ++wait)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // A thread writes the file.
            Cycle();
        }
        EXPECT_FALSE(device_->IsSaving());
        Cycle();
    }
    void Receive(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> bytes)
    {
        now_ns_ += kNsPerMs / 4U;
        device_->OnFrame(FrameOf(identifier, bytes, now_ns_), CanPortId::kFirst, Now());
    }
    /// What was sent comes back, then the cycle 5 ms after the one before.
    void Cycle()
    {
        for (EchoBus* const bus : {safety_, services_})
        {
            host::LiveFrame own;
            while (bus->Receive(own))
            {
                device_->OnFrame(own, CanPortId::kFirst, Now());
            }
        }
        now_ns_ += 5U * kNsPerMs - (now_ns_ % (5U * kNsPerMs));
        device_->Cycle(Now(), now_ns_);
        static_cast<void>(device_->TakeRestart(now_ns_));
        device_->LookAtOutput(now_ns_);
    }
    runtime::NodeDevice& Device()
    {
        return *device_;
    }
    /// Data of the frames that were sent with this identifier.
    std::vector<unsigned> SentWith(const std::uint32_t identifier) const
    {
        std::vector<unsigned> data;
        for (const host::LiveFrame& frame : safety_->Sent())
        {
            if (frame.identifier == identifier)
            {
                data.push_back(frame.data[0] | (unsigned{frame.data[1]} << 8U));
            }
        }
        return data;
    }
    /// All that the default SDO server has sent.
    std::vector<host::LiveFrame> SdoAnswers() const
    {
        std::vector<host::LiveFrame> answers;
        for (const host::LiveFrame& frame : services_->Sent())
        {
            if (frame.identifier == 0x580U + device_->Assembly().NodeId())
            {
                answers.push_back(frame);
            }
        }
        return answers;
    }
    std::uint64_t NowNs() const
    {
        return now_ns_;
    }
    std::string Told()
    {
        static_cast<void>(report_.Finish());
        return out_.str();
    }

  private:
    static constexpr std::uint64_t kNsPerUs = 1000U;
    static constexpr std::uint64_t kNsPerMs = 1000000U;

    InstantPair Now() const
    {
        const Instant now{static_cast<std::uint32_t>(now_ns_ / kNsPerUs)};
        return {now, now};
    }

    std::ostringstream out_{};
    runtime::NodeReport report_;
    std::uint64_t now_ns_{1000U * kNsPerMs};
    EchoBus* safety_{nullptr};
    EchoBus* services_{nullptr};
    std::unique_ptr<runtime::NodePorts> ports_{};
    std::unique_ptr<runtime::NodeDevice> device_{};
};
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_NODE_BENCH_HPP
