// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_REPORT_STATUS_HPP
#define RUNTIME_MANAGER_REPORT_STATUS_HPP

#include "runtime/manager/assembly.hpp"
#include "runtime/manager/pdos.hpp"
#include "runtime/manager/station.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// One slave as a row of the status table.
struct StatusRow
{
    std::uint8_t node{0U};
    std::string name;
    std::string state;  ///< "unknown" where nobody supervises it and it has been silent for a while.
    std::string result; ///< Letter or code, empty for none.
    std::string step;
    std::string age;       ///< Of the last sign of life; "-": there was none.
    std::string emergency; ///< Last code, empty for none.
    std::string safety;    ///< State of the gate, empty for no safety slave.
    std::string finding;
    bool is_good{false};
};

/// @brief A row for each slave, by node-ID. [SRS_MGR_005, SRS_MGR_133]
[[nodiscard]] std::vector<StatusRow> StatusRows(const ManagerStation& station, std::uint64_t now_us);
/// @brief Nodes that were heard and are not in the network list: a text such as "not in the network list (A): node 55
/// operational"; empty when there is none. [SRS_MGR_130]
[[nodiscard]] std::string UnlistedText(const ManagerStation& station, std::uint64_t now_us);
/// @brief Manager, slaves and process data as a table of text, with a line end.
[[nodiscard]] std::string StatusTable(const ManagerStation& station, std::uint64_t now_us);
/// @brief The same for programs: with `--json` the last line of the output, and the answer to `status`. [SRS_MGR_005]
[[nodiscard]] nlohmann::ordered_json StatusJson(const ManagerStation& station, std::uint64_t now_us);
/// @brief The manager as a line: "manager, node 127: operational, active master, profile cia302, operational".
[[nodiscard]] std::string ManagerLine(const ManagerAssembly& assembly);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_REPORT_STATUS_HPP
