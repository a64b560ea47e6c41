// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/device_findings.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "canopen/generate/generate.hpp"
#include "runtime/device/model.hpp"
#include "runtime/node/trial.hpp"
#include "safety_core/kernel/limits.hpp"
#include "simulator/world/trial.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint8_t kAnyNode = 127U;

/// What `generate` refuses, without writing anything.
std::vector<cia306::Finding> TryGenerate(const cia306::Device& device, const std::string& text,
                                         const std::uint8_t node_id)
{
    try
    {
        return generate::Generate(device, text, {"checked", node_id}).warnings;
    }
    catch (const cia306::InputError& error)
    {
        return {{cia306::Severity::kError, error.Where(), "", error.Message()}};
    }
}

/// What the commands that use the file say of it; a file without node-ID is tried with any.
std::vector<cia306::Finding> TryCommands(const cia306::Device& device, const std::string& text,
                                         const std::optional<std::uint8_t> node_id)
{
    std::vector<cia306::Finding> findings = runtime::TryDevice(device, node_id);
    const std::vector<cia306::Finding> generated = TryGenerate(device, text, node_id.value_or(kAnyNode));
    findings.insert(findings.end(), generated.begin(), generated.end());
    const bool has_id = node_id || device.node_id;
    const std::optional<cia306::Finding> simulated =
        simulator::TrySelfTests(device.file, has_id ? node_id : std::optional(kAnyNode));
    if (simulated)
    {
        AddOthers(findings, {*simulated}); // One of a live device stands there already, where it has the same place.
    }
    return findings;
}

/// A device of which nobody can say when it is safe behind a fault. A lost cross link has a time of its own.
/// [SRS_CLI_731]
std::vector<cia306::Finding> TryLimits(const cia306::Device& device, const std::optional<std::uint8_t> node_id)
{
    const runtime::DeviceModel model(device.file, node_id.value_or(device.node_id.value_or(kAnyNode)),
                                     runtime::SafetyNeed::kOptional);
    const DeviceConfig& config = model.Config();
    bool are_all = true;
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        for (const FaultClass fault :
             {FaultClass::kBus, FaultClass::kBusNextNormal, FaultClass::kWrongFrame, FaultClass::kChannel,
              FaultClass::kConfiguration, FaultClass::kSupervisor, FaultClass::kClock, FaultClass::kSharedSource})
        {
            are_all = are_all && ComputeLimit(config, srdo.times, fault).result == Result::kSuccessful;
        }
    }
    if (are_all)
    {
        return {};
    }
    const cia306::Entry* const entry = device.Find(cia306::kDeviceParametersIndex, 6U);
    return {{cia306::Severity::kWarning, entry == nullptr ? cia306::Place{} : entry->ValuePlace(),
             cia306::ObjectName(cia306::kDeviceParametersIndex, 6U),
             "no limit can be computed for some faults with a clock tolerance of " +
                 std::to_string(config.clock_tolerance_us) + " us in " + std::to_string(config.clock_interval_us) +
                 " us (0x5F00:07), expected a smaller one, or shorter intervals in 0x5F00:04 and 0x5F00:05"}};
}

/// A folder for this process alone, which ends with the object.
class TemporaryFolder
{
  public:
    TemporaryFolder() : path_((std::filesystem::temp_directory_path() / "counterpoint_XXXXXX").string())
    {
        if (::mkdtemp(path_.data()) == nullptr)
        {
            throw std::system_error(errno, std::generic_category(), "no folder for the check beside " + path_);
        }
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// Path of a file in it.
    [[nodiscard]] std::string PathOf(const std::string& name) const
    {
        return (std::filesystem::path(path_) / name).string();
    }

  private:
    std::string path_;
};
} // namespace

std::vector<cia306::Finding> FindingsOf(const cia306::Device& device, const std::string& text,
                                        const cia306::CheckOptions& options)
{
    std::vector<cia306::Finding> findings = cia306::CheckDevice(device, options);
    if (ErrorsIn(findings) == 0U)
    {
        AddOthers(findings, TryCommands(device, text, options.node_id));
        if (ErrorsIn(findings) == 0U)
        {
            AddOthers(findings, TryLimits(device, options.node_id));
        }
        const cia306::SafetyConfiguration safety =
            cia306::ExtractSafety(device, options.node_id ? options.node_id : device.node_id);
        const std::optional<cia306::Finding> valid = cia306::ValidInSpiteOfErrors(safety);
        if (ErrorsIn(findings) != 0U && valid) // [SRS_CLI_491]
        {
            AddOthers(findings, {*valid});
        }
    }
    return findings;
}

void AddOthers(std::vector<cia306::Finding>& findings, const std::vector<cia306::Finding>& others)
{
    for (const cia306::Finding& other : others)
    {
        const bool is_told = std::any_of(findings.begin(), findings.end(), [&other](const cia306::Finding& finding)
                                         { return finding.place == other.place && finding.object == other.object; });
        if (!is_told || other.severity == cia306::Severity::kError)
        {
            findings.push_back(other);
        }
    }
    findings = cia306::SortedByLine(std::move(findings));
}

std::optional<cia306::Finding> SignedForAnother(const cia306::Device& device, const std::optional<std::uint8_t> node_id)
{
    if (!device.node_id || !node_id || *device.node_id == *node_id)
    {
        return std::nullopt;
    }
    return cia306::Finding{cia306::Severity::kWarning, device.commissioning_place, "",
                           "NodeID is " + std::to_string(*device.node_id) + ", expected " + std::to_string(*node_id) +
                               ", the node-ID that the file is signed for"};
}

std::size_t ErrorsIn(const std::vector<cia306::Finding>& findings)
{
    return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), [](const cia306::Finding& finding)
                                                  { return finding.severity == cia306::Severity::kError; }));
}

const cia306::Finding* CauseIn(const std::vector<cia306::Finding>& findings)
{
    const std::string valid = cia306::ObjectName(cia306::kConfigurationValidIndex, 0U);
    const cia306::Finding* cause = nullptr;
    for (const cia306::Finding& finding : findings)
    {
        const bool is_first = cause == nullptr || cause->object == valid;
        if (finding.severity == cia306::Severity::kError && is_first)
        {
            cause = &finding;
        }
    }
    return cause;
}

std::vector<cia306::Finding> FindingsBeforeWriting(const std::string& text, const std::optional<std::uint8_t> node_id)
{
    const TemporaryFolder folder;
    const std::string path = folder.PathOf("device.dcf");
    cia306::WriteTextFile(path, text);
    cia306::CheckOptions options;
    const cia306::Device device = cia306::ReadDeviceFile(path);
    options.node_id = node_id ? node_id : device.node_id;
    return FindingsOf(device, text, options);
}
} // namespace counterpoint::tools
