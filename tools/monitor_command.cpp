// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/safety/digest.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "canopen/monitor/contradictions.hpp"
#include "canopen/monitor/decoder.hpp"
#include "canopen/monitor/recording.hpp"
#include "canopen/monitor/report.hpp"
#include "canopen/monitor/texts.hpp"
#include "runtime/console/json_text.hpp"
#include "tools/command_table.hpp"
#include "tools/device_findings.hpp"
#include "tools/device_options.hpp"
#include "tools/file_warnings.hpp"
#include "tools/live_watch.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using cia306::InputError;
using monitor::LogFrame;
using monitor::Time;

/// What stands behind the file for a node-ID: up to three digits, or two hexadecimal ones behind 0x.
bool IsNodeNumber(const std::string& text)
{
    const bool is_hexadecimal = text.size() > 2U && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    const std::string digits = is_hexadecimal ? text.substr(2U) : text;
    const std::size_t most = is_hexadecimal ? 2U : 3U;
    const char* const known = is_hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
    return !digits.empty() && digits.size() <= most && digits.find_first_not_of(known) == std::string::npos;
}

/// "sensor.dcf=5": a file and the node-ID that it has on this bus. [SRS_MON_730]
monitor::NodeFile NodeFileOf(const std::string& text)
{
    const std::size_t mark = text.find_last_of('=');
    const std::string number = mark == std::string::npos ? "" : text.substr(mark + 1U);
    if (!IsNodeNumber(number))
    {
        return {text, std::nullopt};
    }
    const std::uint64_t id = cia306::ParseTyped(number, 127U).value_or(0U);
    if (id == 0U)
    {
        throw InputError(text.substr(0U, mark), {},
                         {"node-ID " + number + " in --dcf", "1 to 127, decimal or hexadecimal after 0x"});
    }
    return {text.substr(0U, mark), static_cast<std::uint8_t>(id)};
}

std::string ProblemOfInterface(const std::string& text)
{
    return text.empty() ? "an empty name, expected an interface of the recording" : std::string();
}

/// What `check` finds by its rules in a file of which something is watched: a device may not be as it is described
/// there. No device is tried, as `check` itself does behind its rules: that is no work of a monitor. A device with
/// another node-ID than the file's expects no digest. [SRS_MON_490]
void TellErrors(const monitor::NodeModel& node, std::ostream& err)
{
    const std::string& file = node.device.file;
    std::vector<cia306::Finding> findings = cia306::CheckDevice(node.device, {node.id, {}});
    if (node.device.node_id && *node.device.node_id != node.id)
    {
        findings.erase(std::remove_if(findings.begin(), findings.end(), [](const cia306::Finding& finding)
                                      { return finding.object == cia306::DigestName(); }),
                       findings.end());
    }
    const std::size_t errors = ErrorsIn(findings);
    const cia306::Finding* const first = CauseIn(findings);
    const std::string valid = cia306::ObjectName(cia306::kConfigurationValidIndex, 0U);
    if (first != nullptr && first->object != valid)
    {
        const std::string count = errors == 1U ? "1 error" : std::to_string(errors) + " errors";
        err << cia306::FormatFinding(file,
                                     {cia306::Severity::kWarning, first->place, first->object,
                                      "'counterpoint check' finds " + count + " in this file, of which a device " +
                                          "may make something else; the first: " + first->text})
            << "\n";
    }
}

class MonitorCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options.Add("FILE", &file_, "Recording: candump -l, pcap or pcapng (SocketCAN)").Type("");
        options.Add("--can", &address_, "Instead of FILE a live bus: can0, socketcand:HOST:PORT/can0, udp:GROUP:PORT")
            .Type("ADDRESS")
            .Excludes("FILE");
        options.Add("--dcf", &dcfs_, "DCF of a device on the bus, as often as there are devices; FILE=N for node-ID N")
            .Type("FILE");
        options.Add("--interface", &interface_, "Take the frames of this interface (default: the first in FILE)")
            .Type("NAME")
            .Needs("FILE")
            .Check(ProblemOfInterface);
        options.Add("--sct", &sct_ms_, "SCT of SRDOs that no DCF consumes, in ms (default: twice the refresh time)")
            .Range(1, 65535);
        options
            .Add("--for", &seconds_, "End the watching of a live bus after so many seconds (default: Ctrl-C, SIGTERM)")
            .Needs("--can")
            .Range(1, 1000000);
        options.Add("--frames", &shows_frames_, "Show each frame in words");
        options.Add("--json", &is_json_, "Answer as one JSON document");
        options.Add("--html", &html_, "Write a page with histograms").Type("PAGE").Check(ProblemOfFileName);
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        DeviceOptions options;
        options.file = file_;
        options.is_json = is_json_;
        return RunOnDevice(options, streams, [&] { return Watch(streams); });
    }

  private:
    /// Whether there is something to read, and something to do with it; says what is missing.
    [[nodiscard]] bool HasEnough(const Streams& streams) const
    {
        if (file_.empty() == address_.empty())
        {
            streams.err << "counterpoint monitor: no recording and no bus; expected FILE before --dcf, or --can "
                           "ADDRESS, in a command line "
                           "as told by 'counterpoint monitor --help'\n";
            return false;
        }
        if (dcfs_.empty() && !shows_frames_)
        {
            streams.err
                << "counterpoint monitor: no DCF, so that no SRDO is watched; expected --dcf FILE, or --frames, in a "
                   "command line as told by 'counterpoint monitor --help'\n";
            return false;
        }
        return true;
    }

    [[nodiscard]] ExitStatus Watch(const Streams& streams) const
    {
        if (!HasEnough(streams))
        {
            return ExitStatus::kBadInput;
        }
        RequirePage();
        const monitor::Network network = ReadNetwork();
        TellStrange(network, streams);
        RequireWatch(network);
        std::vector<monitor::Violation> kept;
        monitor::Analysis analysis(network,
                                   [&](const monitor::Violation& violation)
                                   {
                                       if (kept.size() < monitor::kMostKept)
                                       {
                                           kept.push_back(violation);
                                       }
                                       if (!is_json_)
                                       {
                                           streams.out << ViolationText(network, violation) << "\n";
                                       }
                                   });
        monitor::Decoder decoder(network, analysis);
        std::vector<monitor::FrameText> frames;
        const auto take = [&](const monitor::LogFrame& frame)
        {
            if (shows_frames_ && !is_json_)
            {
                streams.out << monitor::SecondsText(frame.time) << " " << decoder.Decode(frame) << "\n";
            }
            else if (shows_frames_ && frames.size() < monitor::kMostKept)
            {
                frames.push_back({frame.time, decoder.Decode(frame)});
            }
            else
            {
                // Nobody asked for it, or there is no more room.
            }
            analysis.Take(frame);
        };
        monitor::Report report{network, analysis, kept, address_.empty() ? file_ : address_};
        report.frames = shows_frames_ ? &frames : nullptr;
        if (address_.empty())
        {
            report.origin = ReadFrames(take);
        }
        else
        {
            LiveWatch watch(address_, streams,
                            {take, [&](const Time now) { analysis.Advance(now); }, [&] { analysis.Interrupt(); }});
            report.missed = watch.Run(seconds_);
        }
        analysis.End();
        return Conclude(report, streams);
    }

    /// Hands over every frame of the recording that is of the interface.
    [[nodiscard]] monitor::Origin ReadFrames(const std::function<void(const LogFrame&)>& take) const
    {
        const std::string bytes = monitor::ReadRecording(file_);
        const auto source = monitor::OpenRecording(file_, bytes, {interface_});
        LogFrame frame;
        bool is_any = false;
        while (source->Next(frame))
        {
            take(frame);
            is_any = true;
        }
        if (!is_any)
        {
            throw InputError(file_, {},
                             interface_.empty() ? cia306::Problem{"no CAN frame in it", "a recording with at least one"}
                                                : cia306::Problem{"no frame of interface " + cia306::Quoted(interface_),
                                                                  "--interface with one of the recording"});
        }
        return source->Seen();
    }

    /// In the files, and between them; with --json the second are in the document.
    void TellStrange(const monitor::Network& network, const Streams& streams) const
    {
        TellFileWarnings(Files(), streams.err);
        for (const monitor::NodeModel& node : network.Nodes())
        {
            if (!node.active.empty())
            {
                TellErrors(node, streams.err);
            }
        }
        if (is_json_)
        {
            return;
        }
        for (const monitor::Contradiction& contradiction : monitor::ContradictionsOf(network))
        {
            streams.err << cia306::FormatFinding(contradiction.file, contradiction.finding) << "\n";
        }
    }

    /// A page that could not be written is told before the work, and none takes the place of what is read.
    void RequirePage() const
    {
        if (html_.empty())
        {
            return;
        }
        std::vector<std::string> inputs = Files();
        inputs.push_back(file_);
        for (const std::string& input : inputs)
        {
            std::error_code error; // Of a file that is not there, which is another than the page.
            if (std::filesystem::equivalent(input, html_, error))
            {
                throw InputError(html_, {}, {"--html is a file that is read", "another one"});
            }
        }
        cia306::RequireWritable(html_);
    }

    /// The DCFs, without the node-IDs behind their names.
    [[nodiscard]] std::vector<std::string> Files() const
    {
        std::vector<std::string> files;
        for (const std::string& dcf : dcfs_)
        {
            files.push_back(NodeFileOf(dcf).path);
        }
        return files;
    }

    [[nodiscard]] monitor::Network ReadNetwork() const
    {
        std::vector<monitor::NodeFile> files;
        for (const std::string& dcf : dcfs_)
        {
            files.push_back(NodeFileOf(dcf));
        }
        const auto sct = sct_ms_ == 0 ? std::nullopt : std::optional<Time>(sct_ms_ * monitor::kMillisecond);
        return {files, sct};
    }

    void RequireWatch(const monitor::Network& network) const
    {
        if (network.Watches().empty() && !shows_frames_)
        {
            throw InputError(NodeFileOf(dcfs_.front()).path, {},
                             {"no SRDO that is active in any of the files",
                              "at least one to watch, which is on and has 0xA5 in 13FEh, or --frames"});
        }
    }

    [[nodiscard]] ExitStatus Conclude(const monitor::Report& report, const Streams& streams) const
    {
        if (!html_.empty())
        {
            cia306::WriteTextFile(html_, monitor::HtmlReport(report));
        }
        if (!report.origin.doubt.empty() && !is_json_)
        {
            streams.err << cia306::FormatFinding(report.source,
                                                 {cia306::Severity::kWarning, {}, "", report.origin.doubt})
                        << "\n";
        }
        if (is_json_)
        {
            streams.out << monitor::JsonReport(report);
        }
        else
        {
            monitor::WriteSummary(report, streams.out);
        }
        if (monitor::HasMissed(report))
        {
            return ExitStatus::kBadInput; // As a recording with a line that cannot be read.
        }
        return monitor::Holds(report) ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
    }

    std::string file_;
    std::string address_;
    std::string interface_;
    std::string html_;
    std::vector<std::string> dcfs_;
    int sct_ms_{0};  ///< 0: not given.
    int seconds_{0}; ///< 0: until interrupted.
    bool shows_frames_{false};
    bool is_json_{false};
};
} // namespace

std::unique_ptr<Command> MakeMonitorCommand()
{
    return std::make_unique<MonitorCommand>();
}
} // namespace counterpoint::tools
