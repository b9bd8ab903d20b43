#pragma once

namespace dimline {

/// base to the power of exponent, for a base of 0 or more; 0 to whatever power but 0 is 0.
///
/// To some 1e-15 of the value for each factor of e in it; below some 1e-304 it is 0, above 1e304 infinity. Nothing in it is rounded differently on another host,
/// so that a model has the same vertices in every build. The library's own would bring 10 kB of tables to a page, which no compression makes smaller.
double power(double base, double exponent);

/// The greatest power of ten that is not above a positive value; 0 and infinity are themselves.
double powerOfTenWithin(double value);

}  // namespace dimline
