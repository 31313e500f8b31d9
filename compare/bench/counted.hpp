#pragma once

#include <cmath>

// A number that counts what is done to it: the inner loops of dem/ are templates on their number type, so
// that the operations of a bond-step are counted from the very lines that run.
namespace fiberchain::compare {

/// Floating-point operations; changes of sign, selections and comparisons are not among them.
struct OperationCount {
  double additions = 0;  ///< and subtractions
  double multiplications = 0;
  double fusable = 0;  ///< additions of a product: one instruction takes both where there are fused ones
  double divisions = 0;
  double square_roots = 0;
  double sines = 0;  ///< and cosines
  double arc_tangents = 0;

  friend bool operator==(const OperationCount&, const OperationCount&) = default;
};

/// All of them over a number: a mean.
OperationCount operator/(const OperationCount& count, double number);

/// A double that reports to the count it was made with, or to the other operand's. Two numbers without a
/// count are constants, and what is done to them alone the compiler does.
class Counted {
 public:
  Counted() = default;
  Counted(double value) : value_(value) {}  // a constant, as in Real(0.5)
  Counted(double value, OperationCount* count) : value_(value), count_(count) {}

  double value() const { return value_; }

  friend Counted operator+(const Counted& a, const Counted& b) { return sum(a, b, a.value_ + b.value_); }
  friend Counted operator-(const Counted& a, const Counted& b) { return sum(a, b, a.value_ - b.value_); }
  friend Counted operator*(const Counted& a, const Counted& b) {
    Counted product = done(a, b, a.value_ * b.value_, &OperationCount::multiplications);
    product.is_product_ = product.count_ != nullptr;
    return product;
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return done(a, b, a.value_ / b.value_, &OperationCount::divisions);
  }
  friend Counted operator-(Counted a) {
    a.value_ = -a.value_;
    return a;
  }
  friend Counted sqrt(const Counted& a) {
    return done(a, a, std::sqrt(a.value_), &OperationCount::square_roots);
  }
  friend Counted sin(const Counted& a) { return done(a, a, std::sin(a.value_), &OperationCount::sines); }
  friend Counted cos(const Counted& a) { return done(a, a, std::cos(a.value_), &OperationCount::sines); }
  friend Counted atan(const Counted& a) {
    return done(a, a, std::atan(a.value_), &OperationCount::arc_tangents);
  }
  friend Counted abs(const Counted& a) { return {std::abs(a.value_), a.count_}; }
  friend Counted min(const Counted& a, const Counted& b) { return a < b ? a : b; }
  friend Counted max(const Counted& a, const Counted& b) { return a > b ? a : b; }
  friend Counted select(bool condition, const Counted& yes, const Counted& no) {
    return condition ? yes : no;
  }
  friend bool operator<(const Counted& a, const Counted& b) { return a.value_ < b.value_; }
  friend bool operator>(const Counted& a, const Counted& b) { return a.value_ > b.value_; }

 private:
  static Counted done(const Counted& a, const Counted& b, double value, double OperationCount::*kind) {
    OperationCount* count = a.count_ ? a.count_ : b.count_;
    if (count) ++(count->*kind);
    return {value, count};
  }

  static Counted sum(const Counted& a, const Counted& b, double value) {
    const Counted result = done(a, b, value, &OperationCount::additions);
    if (a.is_product_ || b.is_product_) ++result.count_->fusable;
    return result;
  }

  double value_ = 0;
  OperationCount* count_ = nullptr;
  bool is_product_ = false;
};

}  // namespace fiberchain::compare
