// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/input_error.hpp"
#include "hal/host/live/address.hpp"
#include "hal/host/live/socketcand/server.hpp"
#include "runtime/console/json_text.hpp"
#include "tools/command_line/end_signals.hpp"
#include "tools/command_line/options.hpp"
#include "tools/command_table.hpp"

#include <algorithm>
#include <charconv>
#include <ostream>
#include <vector>

namespace counterpoint::tools
{
namespace
{
constexpr int kLongestSeconds = 1000000;
constexpr int kServeMs = 100;
constexpr std::size_t kLongestName = 15U;
constexpr std::uint64_t kSecondNs = 1'000'000'000U;
constexpr const char* kFormat = "counterpoint-bus-1";
constexpr const char* kListenHere = "127.0.0.1:29536";

struct ListenPlace
{
    std::string host;
    std::uint16_t port;
};

ListenPlace PlaceOf(const std::string& text)
{
    const host::HostAndPort place = host::SplitHostAndPort(text);
    const std::string& digits = place.port;
    std::uint16_t port = 0U;
    const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), port);
    const bool is_port = !digits.empty() && (result.ec == std::errc{}) && (result.ptr == digits.data() + digits.size());
    if (!is_port || place.host.empty())
    {
        throw host::LiveBusError("--listen '" + cia306::Printable(text) +
                                 "', expected HOST:PORT with a port from 0 (a free one) to 65535, and an IPv6 address "
                                 "in brackets");
    }
    return {place.host, port};
}

/// What a client can write in an order, and in an address as it is.
bool IsName(const std::string& name)
{
    const auto is_plain = [](const char letter)
    { return letter > ' ' && letter <= '~' && std::string("<>/:").find(letter) == std::string::npos; };
    return !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), is_plain);
}

/// `can0=udp:...`; without a name the interface's own, or can0.
host::ServedBus ServedOf(const std::string& text)
{
    const std::size_t sign = text.find('=');
    // The = of ?bitrate=N is none behind a name.
    const bool has_name = (sign != std::string::npos) && (sign < text.find_first_of(":?"));
    const std::string address = has_name ? text.substr(sign + 1U) : text;
    if (has_name && !IsName(text.substr(0U, sign)))
    {
        throw host::LiveBusError("name '" + cia306::Printable(text.substr(0U, sign)) +
                                 "', expected 1 to 15 characters without space, <, >, / and :, such as can0");
    }
    const host::LiveAddress parts = host::ParseLiveAddress(address);
    const std::string own = parts.interface.empty() ? "can0" : parts.interface;
    return {has_name ? text.substr(0U, sign) : own, address};
}

class BusCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options
            .Add("BUS", &buses_,
                 "Bus to serve, as [NAME=]ADDRESS: udp:239.74.163.2:43113 (a bus for the programs of this "
                 "machine; ?bitrate=125000 gives it a pace), can0 (an interface of Linux), "
                 "socketcand:HOST:PORT/can0. NAME is what clients open (default: the interface, else can0)")
            .Required()
            .Type("[NAME=]ADDRESS");
        options
            .Add("--listen", &listen_,
                 "Where clients connect (default: 127.0.0.1:29536, this machine only; port 0: a free one)")
            .Type("HOST:PORT");
        options.Add("--seconds", &seconds_, "End after that time (default: at SIGINT or SIGTERM)")
            .Range(1, kLongestSeconds);
        options.Add("--json", &is_json_,
                    "Print where it listens, and at the end the counts, as one JSON object a line");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        try
        {
            Serve(streams);
            return ExitStatus::kHolds;
        }
        catch (const host::LiveBusError& problem)
        {
            streams.err << "counterpoint bus: " << problem.what() << "\n";
        }
        return ExitStatus::kBadInput;
    }

  private:
    void Serve(const Streams& streams) const
    {
        std::vector<host::ServedBus> served;
        for (const std::string& text : buses_)
        {
            served.push_back(ServedOf(text));
            const auto is_same = [&served](const host::ServedBus& bus) { return bus.name == served.back().name; };
            if (std::count_if(served.begin(), served.end(), is_same) != 1)
            {
                throw host::LiveBusError("two buses are named '" + cia306::Printable(served.back().name) +
                                         "', expected NAME=ADDRESS with names that differ");
            }
        }
        const ListenPlace place = PlaceOf(listen_);
        host::SocketcandServer server(place.host, place.port, served);
        const EndSignals signals;
        TellStart(place.host, server.Port(), served, streams.out);
        const std::uint64_t start_ns = host::LiveNow();
        const std::uint64_t limit_ns = static_cast<std::uint64_t>(seconds_) * kSecondNs;
        while (!signals.IsAsked() && ((limit_ns == 0U) || (host::LiveNow() - start_ns < limit_ns)))
        {
            server.Serve(kServeMs);
        }
        TellEnd(server.Counts(), streams.out);
    }

    void TellStart(const std::string& host, const std::uint16_t port, const std::vector<host::ServedBus>& served,
                   std::ostream& out) const
    {
        nlohmann::ordered_json answer{
            {"format", kFormat}, {"host", host}, {"port", port}, {"buses", nlohmann::ordered_json::object()}};
        for (const host::ServedBus& bus : served)
        {
            answer["buses"][bus.name] = bus.address;
            if (!is_json_)
            {
                out << bus.address << " is socketcand:" << host::HostBeforePort(host) << ":" << port << "/" << bus.name
                    << "\n";
            }
        }
        if (is_json_)
        {
            out << answer.dump() << "\n";
        }
        out.flush();
    }

    void TellEnd(const host::ServerCounts& counts, std::ostream& out) const
    {
        if (is_json_)
        {
            const nlohmann::ordered_json answer{
                {"format", kFormat},           {"clients", counts.accepted},    {"to_bus", counts.to_bus},
                {"from_bus", counts.from_bus}, {"malformed", counts.malformed}, {"too_slow", counts.too_slow}};
            out << answer.dump() << "\n";
            return;
        }
        out << counts.accepted << " clients, " << counts.to_bus << " frames to the bus, " << counts.from_bus
            << " told to clients, " << counts.malformed << " malformed orders, " << counts.too_slow
            << " clients too slow and disconnected\n";
    }

    std::vector<std::string> buses_;
    std::string listen_{kListenHere};
    int seconds_{0};
    bool is_json_{false};
};
} // namespace

std::unique_ptr<Command> MakeBusCommand()
{
    return std::make_unique<BusCommand>();
}
} // namespace counterpoint::tools
