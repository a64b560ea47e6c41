// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// generated_node: a program built from generated code, on a live bus. Clients of other origin read its dictionary.
//     generated_node --list             cases: name, node-ID, device file from the root of the tree
//     generated_node CASE ADDRESS       serves the dictionary of one case until SIGTERM
#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "hal/host/live/bus.hpp"
#include "tests/canopen/generate/generated_node.hpp"

#include <poll.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>

namespace
{
using namespace counterpoint;
using generate::test::GeneratedCase;
using generate::test::GeneratedCases;

volatile std::sig_atomic_t is_asked_to_end = 0;

void AskToEnd(int /*signal*/)
{
    is_asked_to_end = 1;
}

class LiveSink final : public cia301::FrameSink
{
  public:
    explicit LiveSink(host::LiveBus& bus) : bus_(bus)
    {
    }
    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override
    {
        return bus_.Send(host::FromCanFrame(frame)) == host::SendResult::kSent;
    }

  private:
    host::LiveBus& bus_;
};

cia301::Moment Now()
{
    return {cia301::NodeState::kPreOperational, Instant{static_cast<std::uint32_t>(host::LiveNow() / 1000U)}};
}

/// Kernel started and configured as the file says, where it has SRDOs.
bool Start(const GeneratedCase& generated, generate::test::GeneratedNode& node)
{
    if (generated.device->srdo_count == 0U)
    {
        return true;
    }
    const StartResult started = node.Start();
    const generated::ConfigureReply reply = node.Configure();
    if (started != StartResult::kStarted || reply.abort != AbortCode::kNone)
    {
        static_cast<void>(std::fprintf(stderr, "generated_node: %s: start %u, refused object %04Xh:%02X\n",
                                       generated.name.c_str(), static_cast<unsigned>(started),
                                       static_cast<unsigned>(reply.object.index),
                                       static_cast<unsigned>(reply.object.sub)));
        return false;
    }
    return true;
}

int Serve(const GeneratedCase& generated, const std::string& address)
{
    const auto bus = host::OpenLiveBus(address);
    const auto node = std::make_unique<generate::test::GeneratedNode>(generated);
    if (!Start(generated, *node))
    {
        return 1;
    }
    LiveSink sink(*bus);
    cia301::SdoServerPort port(node->Server(), sink, cia301::NodeId{generated.node_id});
    static_cast<void>(std::printf("%s is node %u on %s\n", generated.name.c_str(),
                                  static_cast<unsigned>(generated.node_id), address.c_str()));
    static_cast<void>(std::fflush(stdout));
    while (is_asked_to_end == 0)
    {
        pollfd waiting{bus->Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&waiting, 1U, 5));
        host::LiveFrame frame;
        while (bus->Receive(frame))
        {
            if (!frame.own && !frame.error)
            {
                port.OnFrame(host::ToCanFrame(frame, CanPortId::kFirst), Now());
            }
        }
        port.OnCycle(Now());
    }
    return 0;
}

/// As it stands from the root of the tree, where other machines have it, too.
std::string FileOf(const GeneratedCase& generated)
{
    return std::filesystem::path(generated.file).lexically_relative(COUNTERPOINT_SOURCE).string();
}
} // namespace

int main(const int count, const char* const* const arguments)
{
    const bool is_list = count == 2 && std::strcmp(arguments[1], "--list") == 0;
    if (!is_list && count != 3)
    {
        static_cast<void>(std::fputs("usage: generated_node --list | CASE ADDRESS\n", stderr));
        return 2;
    }
    for (const GeneratedCase& generated : GeneratedCases())
    {
        if (is_list)
        {
            static_cast<void>(std::printf("%s %u %s\n", generated.name.c_str(),
                                          static_cast<unsigned>(generated.node_id), FileOf(generated).c_str()));
        }
        else if (generated.name == arguments[1])
        {
            static_cast<void>(std::signal(SIGTERM, &AskToEnd));
            try
            {
                return Serve(generated, arguments[2]);
            }
            catch (const std::exception& problem)
            {
                static_cast<void>(std::fprintf(stderr, "generated_node: %s\n", problem.what()));
                return 2;
            }
        }
    }
    if (!is_list)
    {
        static_cast<void>(std::fprintf(stderr, "generated_node: no case '%s', expected one of --list\n", arguments[1]));
    }
    return is_list ? 0 : 2;
}
