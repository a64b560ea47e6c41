// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_INTEGRATION_CHANGED_DEVICES_HPP
#define TESTS_INTEGRATION_CHANGED_DEVICES_HPP

#include "tests/integration/scenario_run.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/signing.hpp"

#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>

/// The emergency-stop chain whose devices have other values.
namespace counterpoint::simulator
{
using Values = std::map<std::string, std::string>; ///< ParameterValue by section.

inline std::string TextOf(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// The DCF of an example with other values, signed anew.
inline std::string DeviceWith(const std::string& name, const Values& values)
{
    std::istringstream in(TextOf(Examples() + name + ".dcf"));
    std::string section;
    std::string text;
    for (std::string line; std::getline(in, line);)
    {
        section = (line.rfind('[', 0U) == 0U) ? line.substr(1U, line.find(']') - 1U) : section;
        const auto value = values.find(section);
        const bool is_other = line.rfind("ParameterValue=", 0U) == 0U && value != values.end();
        text += (is_other ? "ParameterValue=" + value->second : line) + "\n";
    }
    const cia306::IniDocument document = cia306::IniDocument::Parse(name, text);
    const cia306::Device device = cia306::ReadDevice(document);
    return TextFile(cia306::WithSignatures(document, device, device.node_id).Text(), "." + name + ".dcf");
}

/// The emergency-stop chain with other values in its devices; `text` is what the scenario adds.
inline std::unique_ptr<Run> RunChainOf(const std::map<std::string, Values>& devices, const std::string& text)
{
    std::string chain = TextOf(Examples() + "chain.yaml");
    for (const char* const name : {"sensor", "controller", "actuator"})
    {
        const auto values = devices.find(name);
        const std::string key = "{dcf: " + std::string(name) + ".dcf";
        const std::string file =
            (values == devices.end()) ? Examples() + name + ".dcf" : DeviceWith(name, values->second);
        chain.replace(chain.find(key), key.size(), "{dcf: " + file);
    }
    auto run = std::make_unique<Run>(TextFile("extends: " + TextFile(chain) + "\n" + text, ".extended.yaml"),
                                     std::nullopt, std::nullopt, false);
    run->Simulate(nullptr);
    return run;
}
} // namespace counterpoint::simulator

#endif // TESTS_INTEGRATION_CHANGED_DEVICES_HPP
