// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_GENERATE_GENERATED_NODE_HPP
#define TESTS_CANOPEN_GENERATE_GENERATED_NODE_HPP

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/foreign_objects.hpp"
#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia301/sdo/server.hpp"
#include "tests/canopen/generate/generated_case.hpp"
#include "tests/safety_core/kernel/rig.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace counterpoint::generate::test
{
/// What a client gets: an abort code, or the bytes.
struct Upload
{
    std::uint32_t abort{0U};
    std::vector<std::uint8_t> bytes;
};

/// A node with generated tables: kernel, dictionary, SDO server.
class GeneratedNode
{
  public:
    explicit GeneratedNode(const GeneratedCase& generated)
        : generated_(generated), buffer_(generated.longest_bytes), facade_(kernel_),
          dictionary_(*generated.table, Foreign()),
          server_({dictionary_, {buffer_.data(), generated.longest_bytes}, 2000000U, 127U})
    {
        output_.now_us = &now_us_;
        watchdog_.now_us = &now_us_;
        generated_.reset();
        dictionary_.SetNmtState(NmtState::kPreOperational);
    }

    [[nodiscard]] StartResult Start()
    {
        const StartResult result = kernel_.Start(generated_.device_now(), FlowCallback::kOff);
        kernel_.SetNmtState(NmtState::kPreOperational);
        return result;
    }

    [[nodiscard]] generated::ConfigureReply Configure()
    {
        return generated_.configure(kernel_);
    }

    /// With settings that are not those of the file.
    [[nodiscard]] generated::ConfigureReply ConfigureWith(const generated::Configuration& configuration,
                                                          const std::uint8_t node_id)
    {
        return generated::Configure(kernel_, configuration, node_id);
    }

    /// Reads as a client does: expedited, or segment by segment.
    [[nodiscard]] Upload Read(const std::uint16_t index, const std::uint8_t sub)
    {
        const auto low = static_cast<std::uint8_t>(index & 0xFFU);
        const cia301::SdoFrame first = Ask({{0x40U, low, static_cast<std::uint8_t>(index >> 8U), sub, 0U, 0U, 0U, 0U}});
        const std::uint8_t head = first.bytes[0];
        Upload upload;
        if (head == 0x80U)
        {
            upload.abort = static_cast<std::uint32_t>(cia301::FromLittleEndian(&first.bytes[4], 4U));
            return upload;
        }
        if ((head & 0x02U) != 0U)
        {
            upload.bytes.assign(first.bytes + 4, first.bytes + 8 - ((head >> 2U) & 3U));
            return upload;
        }
        bool is_last = false;
        for (std::uint8_t command = 0x60U; !is_last; command ^= 0x10U)
        {
            const cia301::SdoFrame segment = Ask({{command, 0U, 0U, 0U, 0U, 0U, 0U, 0U}});
            const std::uint8_t unused = (segment.bytes[0] >> 1U) & 7U;
            upload.bytes.insert(upload.bytes.end(), segment.bytes + 1, segment.bytes + 8 - unused);
            is_last = (segment.bytes[0] & 0x01U) != 0U;
        }
        return upload;
    }

    [[nodiscard]] cia301::Dictionary& Objects()
    {
        return dictionary_;
    }
    /// For a bus: SdoServerPort stands before it.
    [[nodiscard]] cia301::SdoServer& Server()
    {
        return server_;
    }

  private:
    /// As docs/generate.md says: without SRDOs there is no kernel behind the table.
    cia301::ForeignObjects& Foreign()
    {
        const bool has_srdos = generated_.device->srdo_count != 0U;
        return has_srdos ? static_cast<cia301::ForeignObjects&>(facade_) : none_;
    }
    cia301::SdoFrame Ask(const cia301::SdoFrame& request)
    {
        return server_.OnFrame(request, 8U, Instant{0U}).frame;
    }

    const GeneratedCase& generated_;
    std::uint32_t now_us_{0U};
    std::unique_ptr<channel_a::StorageFor<64U, 128U>> storage_a_{std::make_unique<channel_a::StorageFor<64U, 128U>>()};
    std::unique_ptr<channel_b::StorageFor<64U, 128U>> storage_b_{std::make_unique<channel_b::StorageFor<64U, 128U>>()};
    channel_a::Channel a_{storage_a_->Handle()};
    channel_b::Channel b_{storage_b_->Handle()};
    RecordingPorts ports_{};
    GateOutput output_{};
    TimerWatchdog watchdog_{};
    RecordingApplication application_{};
    Kernel kernel_{KernelParts{a_, b_, ports_, output_, watchdog_, application_}};
    std::vector<std::uint8_t> buffer_;
    cia301::KernelObjects facade_;
    cia301::NoObjects none_{};
    cia301::Dictionary dictionary_;
    cia301::SdoServer server_;
};
} // namespace counterpoint::generate::test

#endif // TESTS_CANOPEN_GENERATE_GENERATED_NODE_HPP
