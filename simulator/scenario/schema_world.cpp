// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"
#include "simulator/scenario/schema.hpp"

// What is on the bus, and what happens to it. [SRS_SIM_047]
namespace counterpoint::simulator
{
namespace
{
constexpr Range kAny{0U, 0xFFFFFFFFFFFFFFFFU};
constexpr Range kNone{0U, 0U};
constexpr Range kWords32{0U, 0xFFFFFFFFU};
constexpr Range kControllers{1U, 2U};
constexpr Range kBitRates{10000U, 1000000U};

const KeySpec kAt{"at", ValueType::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when"};
const KeySpec kNode{"node", ValueType::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "which node"};
const KeySpec kSrdo{"srdo", ValueType::kNumber, {1U, 64U}, nullptr, nullptr, kNeeded, "1", "number of the SRDO"};
} // namespace

namespace
{
using T = ValueType;
const std::vector<SectionSpec> kWorldSections{
    {"scenario",
     "a scenario",
     {},
     {
         {"extends", T::kText, kNone, nullptr, nullptr, nullptr, "chain.yaml",
          "another scenario, relative to this file: its single values are defaults, its lists come first; one step "
          "only"},
         {"title", T::kText, kNone, nullptr, nullptr, nullptr, "Loss of one frame", "shown to people"},
         {"description", T::kParagraph, kNone, nullptr, nullptr, nullptr, "A frame is lost.", "shown to people"},
         {"nodes", T::kNamedMaps, kNone, nullptr, "node", nullptr, "{sensor: {dcf: sensor.dcf}}",
          "the devices by their names, 1 to 127; needed here or in what is extended, unless there are managers"},
         {"managers", T::kMaps, kNone, nullptr, "manager", nullptr, "[{network: chain.yaml}]",
          "network managers; the devices are then whole ones with their services, and start when a manager says so"},
         {"profiles", T::kWordOrList, kNone, &WordsOf<kProfileWords>, nullptr, nullptr, "[cia302, el6751]",
          "start-up profiles of its managers that it is written for, whatever their network files say: the first one, "
          "or "
          "that of --profile"},
         {"bitrate", T::kNumber, kBitRates, nullptr, nullptr, nullptr, "500000",
          "bit/s: 10000, 20000, 50000, 100000, 125000, 250000, 500000 (default), 800000, 1000000"},
         {"duration", T::kDuration, kNone, nullptr, nullptr, nullptr, "1000 ms",
          "simulated time; needed here or in what is extended"},
         {"seed", T::kNumber, kAny, nullptr, nullptr, nullptr, "7", "for everything that is left to chance; default 1"},
         {"inputs", T::kMaps, kNone, nullptr, "input", nullptr,
          "[{at: 20 ms, node: sensor, object: 0x2000:01, value: 1}]", "inputs of producers change"},
         {"logic", T::kMaps, kNone, nullptr, "logic", nullptr,
          "[{node: controller, set: 0x2000:01, op: and, from: [0x2200:01]}]",
          "objects of producers that are computed from objects of consumers"},
         {"acknowledge", T::kMaps, kNone, nullptr, "acknowledge", nullptr, "[{at: 150 ms, node: actuator, srdo: 1}]",
          "acknowledge inputs"},
         {"nmt", T::kMaps, kNone, nullptr, "nmt", nullptr, "[{at: 600 ms, node: all, command: stop}]",
          "NMT states and commands"},
         {"power", T::kMaps, kNone, nullptr, "power", nullptr, "[{at: 600 ms, node: sensor, off: 20 ms}]",
          "nodes that lose their supply for a while"},
         {"gfc", T::kMaps, kNone, nullptr, "gfc", nullptr, "[{at: 600 ms, node: sensor}]",
          "nodes that send the global fail-safe command"},
         {"events", T::kMaps, kNone, nullptr, "events", nullptr, "[{at: 3 s, do: pull, node: relay}]",
          "what happens to devices and managers, and frames of somebody else"},
         {"faults", T::kMaps, kNone, nullptr, "fault", nullptr, "[{fault: loss, frames: {identifier: 0x104}}]",
          "what goes wrong"},
         {"expect", T::kMaps, kNone, nullptr, "expect", nullptr, "[{that: no_fault}]", "what has to come out"},
     },
     "The whole file."},
    {"nodes",
     "nodes",
     {},
     {},
     "The devices: a map of names to nodes; 'all' and 'bus' are no names, a number from 1 to 127 is the node-ID, too."},
    {"node",
     "a node",
     {},
     {
         {"dcf", T::kText, kNone, nullptr, nullptr, kNeeded, "sensor.dcf",
          "the device, relative to this file: SRDOs, mapping, signatures and the objects from 0x5F00 on are taken "
          "from it"},
         {"node_id", T::kNumber, {1U, 127U}, nullptr, nullptr, nullptr, "1", "instead of the one in the DCF"},
         {"serial", T::kNumber, kWords32, nullptr, nullptr, nullptr, "77",
          "1018h:04 instead of the DCF's; with managers"},
         {"controllers", T::kNumber, kControllers, nullptr, nullptr, "1", "2",
          "CAN controllers; 2, or a DCF that names two: the first has the normal frames (and everything else), the "
          "second the inverse frames"},
         {"structure", T::kWord, kNone, &WordsOf<kStructureWords>, nullptr, "one_cpu", "two_cpu",
          "two_cpu: NAME.a and NAME.b, a kernel with one channel each, joined by the cross link; cpu_a, cpu_b and link "
          "instead of controllers, phase and counters"},
         {"cpu_a", T::kMap, kNone, nullptr, "cpu", nullptr, "{phase: 130 us, counter: {ppm: 20}}",
          "of two_cpu: what is its own"},
         {"cpu_b", T::kMap, kNone, nullptr, "cpu", nullptr, "{phase: 640 us, counter: {ppm: -20}}",
          "of two_cpu: what is its own"},
         {"link", T::kMap, kNone, nullptr, "link", nullptr, "{timeout: 10 ms, delay: 200 us}",
          "of two_cpu: the link between them"},
         {"self_tests", T::kWord, kNone, &WordsOf<kYesWords>, nullptr, "true", "false",
          "the device runs the self tests of safety_core/selftest; they have to fit into its diagnostic interval"},
         {"phase", T::kDuration, kNone, nullptr, nullptr, "0 ms", "130 us",
          "instant of power-on; cycles follow from then on"},
         {"start_at", T::kDuration, kNone, nullptr, nullptr, nullptr, "10 ms",
          "enters OPERATIONAL; default 10 ms, with managers when one says so"},
         {"counter_a", T::kMap, kNone, nullptr, "counter", nullptr, "{ppm: 20, start_us: 1000}",
          "the first counter; the node's cycle runs on its oscillator"},
         {"counter_b", T::kMap, kNone, nullptr, "counter", nullptr, "{ppm: -15}", "the second counter"},
     },
     "A node is the shipped kernel with both shipped channels, configured through the kernel's object access."},
    {"cpu",
     "a CPU",
     {},
     {
         {"phase", T::kDuration, kNone, nullptr, nullptr, "0 ms", "640 us",
          "instant of power-on; cycles follow from then on"},
         {"counter", T::kMap, kNone, nullptr, "counter", nullptr, "{ppm: -20, start_us: 5000}",
          "its clock; its cycle runs on the same oscillator"},
     },
     "One CPU of two: it has one counter, the other CPU's is the second one."},
    {"link",
     "a link",
     {},
     {
         {"timeout", T::kLasting, kNone, nullptr, nullptr, "10 ms", "20 ms",
          "greatest age of what the other CPU said; 3 cycles or more"},
         {"delay", T::kDuration, kNone, nullptr, nullptr, "0.1 ms", "200 us", "how long a message takes"},
         {"jitter", T::kDuration, kNone, nullptr, nullptr, "0 ms", "50 us",
          "each message takes up to so much longer, drawn from the seed"},
         {"clock_tolerance", T::kLasting, kNone, nullptr, nullptr, "2 ms", "1 ms",
          "greatest difference of the clocks' progress; at most half the time-out"},
         {"clock_interval", T::kLasting, kNone, nullptr, nullptr, "500 ms", "1 s",
          "after it the clocks are compared from a new reference; above the time-out"},
         {"stamp_tolerance", T::kDuration, kNone, nullptr, nullptr, "0.05 ms", "100 us",
          "by how much the stamps of one frame may differ on the two CPUs; below the time-out"},
     },
     "The link between the two CPUs of a device; what it must hold is in decision 0005."},
    {"counter",
     "a counter",
     {},
     {
         {"ppm", T::kPpm, kNone, nullptr, nullptr, "0", "-15", "drift; positive is fast"},
         {"start_us", T::kNumber, kWords32, nullptr, nullptr, "0", "4294900000", "first reading in microseconds"},
     },
     "One of the two counters of a node."},
    {"input",
     "an input",
     {},
     {
         kAt,
         kNode,
         {"object", T::kObject, kNone, nullptr, nullptr, kNeeded, "0x2000:01", "the normal object of a producer"},
         {"value", T::kNumber, kAny, nullptr, nullptr, kNeeded, "1", "its input from then on; fits its bits"},
     },
     "The input behind the normal object of a producer changes."},
    {"logic",
     "a logic rule",
     {},
     {
         kNode,
         {"set", T::kObject, kNone, nullptr, nullptr, kNeeded, "0x2000:01", "the normal object of a producer"},
         {"op", T::kWord, kNone, &WordsOf<runtime::kOperationWords>, nullptr, kNeeded, "and",
          "copy and not take one object"},
         {"from", T::kObjects, kNone, nullptr, nullptr, kNeeded, "[0x2200:01, 0x2200:02]",
          "normal objects of consumers"},
     },
     "Normal is computed from normal, inverse from inverse objects."},
    {"acknowledge",
     "an acknowledge",
     {},
     {
         kAt,
         kNode,
         kSrdo,
         {"pulse", T::kDuration, kNone, nullptr, nullptr, "50 ms", "50 ms", "how long the input is 1"},
     },
     "The acknowledge input of both channels is 1 for a while."},
    {"nmt",
     "an NMT event",
     {},
     {
         kAt,
         {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "all", "which node, or all"},
         {"state", T::kWord, kNone, &WordsOf<runtime::kNmtWords>, nullptr, nullptr, "stopped",
          "the node is in this state"},
         {"command", T::kWord, kNone, &WordsOf<kCommandWords>, nullptr, nullptr, "reset_node",
          "instead of state: reset_node starts the kernel anew, reset_communication passes initialising"},
         {"start_after", T::kDuration, kNone, nullptr, nullptr, nullptr, "10 ms",
          "after a reset: enters OPERATIONAL so much later; else it stays pre-operational until told"},
     },
     "The state of a node is set, or an NMT command is followed."},
    {"power",
     "a power cycle",
     {},
     {
         kAt,
         kNode,
         {"off", T::kLasting, kNone, nullptr, nullptr, kNeeded, "20 ms", "how long the supply is away"},
         {"start_after", T::kDuration, kNone, nullptr, nullptr, nullptr, "10 ms",
          "enters OPERATIONAL so long after power-on; else it stays pre-operational until told"},
     },
     "A node loses its supply: outputs close, frames are forgotten, counters begin again."},
    {"gfc", "a GFC event", {}, {kAt, kNode}, "The node sends the global fail-safe command."},
};
} // namespace

std::vector<SectionSpec> WorldSections()
{
    return kWorldSections;
}

namespace
{
using T = ValueType;
const KeySpec fault{"fault", T::kText, kNone,  nullptr,
                    nullptr, nullptr,  "loss", "name of one of the faults; may be left out when there is only one"};
const std::vector<SectionSpec> kExpectationSections{
    {"expect",
     "an expectation",
     {},
     {
         {"that", T::kWord, kNone, &WordsOf<kExpectationWords>, nullptr, kNeeded, "safe_within", "what is expected"},
         {"profile", T::kWordOrList, kNone, &WordsOf<kProfileWords>, nullptr, nullptr, "el6751",
          "only under these of the scenario's 'profiles'"},
     },
     "An expectation; its other keys follow from 'that'. One that holds, or does not, whatever happens is refused."},
    {"released", "an expectation", {"expect"}, {kNode, kSrdo, kAt}, "The output of the SRDO is open at that time."},
    {"safe", "an expectation", {"expect"}, {kNode, kSrdo, kAt}, "The output of the SRDO is not open at that time."},
    {"value",
     "an expectation",
     {"expect"},
     {
         kNode,
         {"object", T::kObject, kNone, nullptr, nullptr, kNeeded, "0x2200:01", "the normal object of a consumer"},
         {"is", T::kNumber, kAny, nullptr, nullptr, kNeeded, "1", "the value"},
         kAt,
     },
     "The application uses this value at that time."},
    {"cause",
     "an expectation",
     {"expect"},
     {
         kNode,
         kSrdo,
         {"is", T::kWord, kNone, &WordsOf<runtime::kCauseWords>, nullptr, kNeeded, "sct",
          "the cause; none: no cause at all"},
     },
     "The application was told of this cause."},
    {"device_fault",
     "an expectation",
     {"expect"},
     {
         kNode,
         {"is", T::kWord, kNone, &WordsOf<runtime::kDeviceFaultWords>, nullptr, kNeeded, "clock",
          "the reason; none: not entered"},
     },
     "The device safe state was entered for this reason."},
    {"detected_by",
     "an expectation",
     {"expect"},
     {
         fault,
         kNode,
         {"by", T::kWordOrList, kNone, &WordsOf<kPartyWords>, nullptr, kNeeded, "[comparator, guard]",
          "the party, or a list: any of them; channels: both in one cycle; kernel: by the comparator's echo and "
          "test; self_test: also one that says nothing"},
     },
     "The first to notice the fault at this node was this party."},
    {"safe_within",
     "an expectation",
     {"expect"},
     {
         fault,
         kNode,
         kSrdo,
         {"limit", T::kWord, kNone, &WordsOf<kFaultClassWords>, nullptr, nullptr, "bus",
          "row of the table of limits; without it the row follows from the fault"},
     },
     "The output was open when the fault came, and was safe within the computed limit."},
    {"no_fault",
     "an expectation",
     {"expect"},
     {
         {"node", T::kNode, kNone, nullptr, nullptr, nullptr, "actuator", "at which node; without: nowhere"},
     },
     "No cause, no device fault, no watchdog."},
};
} // namespace

std::vector<SectionSpec> ExpectationSections()
{
    return kExpectationSections;
}
} // namespace counterpoint::simulator
