// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Feeds arbitrary bytes to the readers of recordings, and what they give to decoder and analysis. A refusal
// (InputError) is a right answer; everything else that goes wrong ends the process. [SRS_MON_014]
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/monitor/decoder.hpp"
#include "canopen/monitor/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace
{
using namespace counterpoint;

void Require(const bool holds)
{
    if (!holds)
    {
        std::abort();
    }
}

const monitor::Network& Chain()
{
    const std::string folder = std::string(COUNTERPOINT_SOURCE_FOLDER) + "/examples/emergency_stop/";
    static const monitor::Network network(
        {{folder + "sensor.dcf", {}}, {folder + "controller.dcf", {}}, {folder + "actuator.dcf", {}}}, std::nullopt);
    return network;
}

void Run(const std::string_view bytes)
{
    std::size_t violations = 0U;
    // A violation is of a pair, or of a GFC.
    monitor::Analysis analysis(Chain(),
                               [&violations](const monitor::Violation& violation)
                               {
                                   const bool is_gfc = violation.breach.cause == monitor::Cause::kGfc;
                                   violations += violation.watches.empty() == is_gfc ? 1U : 0U;
                               });
    monitor::Decoder decoder(Chain(), analysis);
    const auto source = monitor::OpenRecording("fuzz.log", bytes, {});
    monitor::LogFrame frame;
    monitor::Time last = 0;
    while (source->Next(frame))
    {
        const bool has_length = frame.length <= (frame.is_fd ? monitor::kMostDataBytes : monitor::kClassicalBytes);
        Require(has_length && frame.identifier < 0x20000000U && frame.time >= last);
        last = frame.time;
        Require(decoder.Decode(frame).find('\n') == std::string::npos);
        analysis.Take(frame);
    }
    Require(violations == analysis.ViolationCount());
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size)
{
    try
    {
        Run(std::string_view(reinterpret_cast<const char*>(data), size));
    }
    catch (const cia306::InputError& error)
    {
        Require(std::string_view(error.what()).find('\n') == std::string_view::npos);
    }
    return 0;
}
