// Files of LOWTRAN 7 and MODTRAN for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "optics/modtran.hpp"

namespace photic::optics {

// Made by hand in the layout of the two programs, with numbers of their own.
inline const std::string lowtran_head =
    "1                    ***** LOWTRAN 7 *****\n"
    "0 CARD 1  *****    6    2    0    0    0    0    0    0    0    0    0    0    0    .000    "
    ".00\n"
    "1\n";
inline const std::string lowtran_molecules =
    "  ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T        N2       CNTMSLF MOL SCAT     N-1     O3 (UV)  O2 (UV)\n"
    "        (KM)    (MB)    (K)            (MOL/CM2 KM)   (-)       (-)  (ATM CM/KM) (ATM CM/KM)\n"
    "\n"
    "   1      .00 1010.000  290.0  7.100E-01 1.500E+20 9.400E-01 2.800E-04 2.500E-03 3.500E+04\n"
    "   2     1.50  850.000  280.0  5.100E-01 6.000E+19 8.200E-01 2.400E-04 2.600E-03 2.900E+04\n"
    "   3    90.00     .000  187.0  1.000E-11 1.000E+01 2.600E-06 8.000E-10 1.800E-07 1.000E-02\n";
inline const std::string lowtran_aerosols =
    "1\n"
    "  ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T      CNTMFRN     HNO3    AEROSOL 1 AEROSOL 2 AEROSOL 3 AEROSOL 4 "
    "AER1*RH   CIRRUS         RH\n"
    "        (KM)    (MB)    (K)   MOL/CM2 KM ATM CM/KM   (-)       (-)       (-)       (-)       "
    "(-)       (-)      (PERCNT)\n"
    "\n"
    "   1      .00 1010.000  290.0  2.000E+22 4.700E-06 1.200E-01 0.000E+00 0.000E+00 0.000E+00 "
    "3.000E+00 0.000E+00 7.550E+01\n"
    "   2     1.50  850.000  280.0  1.000E+22 5.200E-06 0.000E+00 2.100E-02 3.000E-05 0.000E+00 "
    "3.000E+00 0.000E+00 4.400E+01\n"
    "   3    90.00     .000  187.0  1.000E+02 1.000E-09 0.000E+00 0.000E+00 0.000E+00 5.000E-09 "
    "0.000E+00 0.000E+00 1.000E-01\n";
// What follows is no profile.
inline const std::string lowtran_tail =
    "\n\n   J     Z       N2 CONT    MOL SCAT       AER 1       AER 2\n        (KM)\n\n"
    "  1    1.500   6.512E-01   9.031E-01   7.700E-01   0.000E+00\n";
inline const std::string lowtran =
    lowtran_head + lowtran_molecules + lowtran_aerosols + lowtran_tail;

inline const std::string modtran =
    "1    ***** MODTRAN4 VERSION 3 REVISION 1 *****\n"
    "\n"
    "1 ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T        N2       CNTMSLF   CNTMFRN MOL SCAT     N-1      O3 (UV)   "
    "O2 (UV)   WAT DROP  ICE PART  RAIN RATE\n"
    "        (KM)    (MB)    (K)               (  MOL/CM2 KM  )      (-)       (-)     (  ATM "
    "CM/KM "
    " )       (GM/M3)   (GM/M3)   (MM/HR)\n"
    "\n"
    "   1   0.0000 1013.000  299.7  7.100E-01 1.500E+20 1.500E+20 9.100E-01 2.800E-04 2.500E-03 "
    "3.500E+04     0.000     0.000     0.000\n"
    "   2   2.0000  805.000  287.7  5.100E-01 6.000E+19 6.000E+19 7.500E-01 2.400E-04 2.600E-03 "
    "2.900E+04     0.000     0.000     0.000\n"
    "\n\n"
    "1 ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T     AEROSOL 1 AEROSOL 2 AEROSOL 3 AEROSOL 4  AER1*RH     RH (%)    "
    "RH (%)   CIRRUS   WAT DROP  ICE PART\n"
    "        (KM)    (MB)    (K)    (      550nm EXTINCTION [KM-1]      )  (BEFORE H2O SCALING)   "
    "(AFTER)    (-)     (550nm VIS [KM-1])\n"
    "\n"
    "   1   0.0000 1013.000  299.7  1.600E-01 0.000E+00 0.000E+00 0.000E+00 1.000E+00 7.600E+01 "
    "8.000E+01   0.00000   0.00000   0.00000\n"
    "   2   2.0000  805.000  287.7  6.200E-02 0.000E+00 0.000E+00 0.000E+00 1.000E+00 7.000E+01 "
    "8.000E+01   0.00000   0.00000   0.00000\n"
    "\n\n"
    "1 ATMOSPHERIC PROFILES (AFTER COLUMN SCALING)\n"
    "\n"
    "   I      Z       P       H2O      O3       CO2\n"
    "         (KM)    (MB)  (         ATM CM / KM         )\n"
    "   1   0.0000 1013.000  1.00E+03 2.52E-03 3.00E+01\n"
    "   2   2.0000  805.000  4.00E+02 2.52E-03 2.00E+01\n";

/// A text with a part of it replaced, which must be there.
inline std::string with(std::string text, const std::string& part, const std::string& other) {
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

struct BadFile {
  std::string text, says;
};

/// Nothing of a file without rows of numbers, which may be no tape at all, is said again.
inline void expect_no_quotation(const std::string& said) {
  EXPECT_NE(said.find("no table of numbers (expected: rows of numbers below, as many as names)"),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("secret"), std::string::npos) << said;
}

}  // namespace photic::optics
