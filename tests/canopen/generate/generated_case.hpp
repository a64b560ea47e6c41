// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_GENERATE_GENERATED_CASE_HPP
#define TESTS_CANOPEN_GENERATE_GENERATED_CASE_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia301/nmt/slave.hpp"
#include "canopen/cia301/store/node_defaults.hpp"
#include "canopen/generated/configuration.hpp"

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace counterpoint::generate::test
{
/// A device file and what was generated from it, compiled into this program.
struct GeneratedCase
{
    std::string name;
    std::string file;
    std::uint8_t node_id{0U};
    const cia301::EntryTable* table{nullptr};
    const DeviceConfig* device{nullptr};
    generated::ConfigureReply (*configure)(Kernel&) noexcept {nullptr};
    void (*reset)() noexcept {nullptr};
    void (*reset_communication)() noexcept {nullptr};
    const DeviceConfig& (*device_now)() noexcept {nullptr};
    void (*apply_node_id)(std::uint8_t) noexcept {nullptr};
    std::uint32_t longest_bytes{0U};
    const cia301::NodeId& (*node_now)() noexcept {nullptr};
    const cia301::NodeDefaults& (*defaults_of_node)() noexcept {nullptr};
};

inline std::vector<GeneratedCase>& GeneratedCases()
{
    static std::vector<GeneratedCase> cases;
    return cases;
}

struct Registration
{
    explicit Registration(const GeneratedCase& generated)
    {
        GeneratedCases().push_back(generated);
    }
};

inline std::ostream& operator<<(std::ostream& out, const GeneratedCase& generated)
{
    return out << generated.file;
}
} // namespace counterpoint::generate::test

#endif // TESTS_CANOPEN_GENERATE_GENERATED_CASE_HPP
