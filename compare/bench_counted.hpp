#pragma once

#include <cmath>

// A number that counts what is done to it: the inner loops of dem/ are templates on their number type, so that the
// operations of a bond-step are counted from the very lines that run.
namespace fiberchain::compare {

/// Floating-point operations; changes of sign, selections and comparisons are not among them.
struct OperationCount {
  long additions = 0;  ///< and subtractions
  long multiplications = 0;
  long divisions = 0;
  long square_roots = 0;
  long sines = 0;  ///< and cosines
  long arc_tangents = 0;

  friend bool operator==(const OperationCount&, const OperationCount&) = default;
};

/// A double that reports to the count it was made with, or to the other operand's. Two numbers without a count are
/// constants, and what is done to them alone the compiler does.
class Counted {
 public:
  Counted() = default;
  Counted(double value) : value_(value) {}  // a constant, as in Real(0.5)
  Counted(double value, OperationCount* count) : value_(value), count_(count) {}

  double value() const { return value_; }

  friend Counted operator+(const Counted& a, const Counted& b) { return done(a, b, a.value_ + b.value_, &OperationCount::additions); }
  friend Counted operator-(const Counted& a, const Counted& b) { return done(a, b, a.value_ - b.value_, &OperationCount::additions); }
  friend Counted operator*(const Counted& a, const Counted& b) { return done(a, b, a.value_ * b.value_, &OperationCount::multiplications); }
  friend Counted operator/(const Counted& a, const Counted& b) { return done(a, b, a.value_ / b.value_, &OperationCount::divisions); }
  friend Counted operator-(const Counted& a) { return {-a.value_, a.count_}; }
  friend Counted sqrt(const Counted& a) { return done(a, a, std::sqrt(a.value_), &OperationCount::square_roots); }
  friend Counted sin(const Counted& a) { return done(a, a, std::sin(a.value_), &OperationCount::sines); }
  friend Counted cos(const Counted& a) { return done(a, a, std::cos(a.value_), &OperationCount::sines); }
  friend Counted atan(const Counted& a) { return done(a, a, std::atan(a.value_), &OperationCount::arc_tangents); }
  friend Counted min(const Counted& a, const Counted& b) { return a.value_ < b.value_ ? a : b; }
  friend Counted max(const Counted& a, const Counted& b) { return a.value_ > b.value_ ? a : b; }

 private:
  static Counted done(const Counted& a, const Counted& b, double value, long OperationCount::*kind) {
    OperationCount* count = a.count_ ? a.count_ : b.count_;
    if (count) ++(count->*kind);
    return {value, count};
  }

  double value_ = 0;
  OperationCount* count_ = nullptr;
};

}  // namespace fiberchain::compare
