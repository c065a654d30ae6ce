// The G and M codes: which are known, and which exclude each other on a line.
#pragma once

#include <cstdint>

namespace evenload {

// Codes of one group exclude each other on a line [NIST RS274NGC, table 4, with Haas' groups].
enum class GGroup : std::uint8_t {
  kUnknown,          // not known, or not simulated
  kNonModal,         // G4, G10, G28, G30, G52, G53, G92
  kMotion,           // G0 to G3 and the cycles; G80 is a group of its own, as Haas has it
  kCycleEnd,         // G80
  kPlane,            // G17 to G19
  kDistance,         // G90, G91
  kArcDistance,      // G90.1, G91.1
  kFeedMode,         // G93 to G95
  kUnits,            // G20, G21
  kCompensation,     // G40 to G42
  kToolLength,       // G43, G44, G49
  kRetract,          // G98, G99
  kWorkCoordinates,  // G54 to G59.3, G54.1 P, G154 P
  kPathControl,      // G61, G61.1, G64
  kSpindleMode,      // G96, G97
  kScaling,          // G50; G51 is not simulated
  kRotation,         // G69; G68 is not simulated
  kPolar,            // G15; G16 is not simulated
};

// `tenths` is ten times the number of the code: 901 is G90.1.
GGroup group_of_g(int tenths);

enum class MGroup : std::uint8_t {
  kUnknown,
  kStop,  // M0, M1, M2, M30, M60
  kToolChange,
  kSpindle,   // M3, M4, M5
  kAccepted,  // coolant and overrides: nothing to simulate
};
MGroup group_of_m(int tenths);

// Whether the axis words on a line of an unknown or non-modal G code say where something is, and
// the tool does not move.
bool only_names_a_place(int tenths);

// Motions that hold for the lines after them too, but are not simulated: splines, threads, probing.
bool is_unread_motion(int tenths);

}  // namespace evenload
