// Many searches walk side by side. Newton's method and the tracing of a curve are written as what they are, one pose after the other; each
// stands still where it needs a placement, until the poses that all of them wait for are placed together. A placement with partials costs a
// half to a quarter in such company, because the poses fill the lanes of the vector registers.
#pragma once

#include <core/mechanics/displacement/displacement.hpp>

#include <coroutine>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

// What a search of assembly modes is about: machines that differ in the words of their working mode, and the actuator values that a pose
// must have in any of them. Numbers are without dimension: lengths by the size of the mechanism, angles in radians.
class AssemblyTarget {
 public:
  AssemblyTarget(std::span<const std::unique_ptr<Machine>> words, const Eigen::VectorXd& actuators);

  const Machine& machine(std::size_t word) const { return *words_[word]; }
  std::size_t words() const { return words_.size(); }
  Eigen::Index dof() const { return coordinate_scale_.size(); }
  double size() const { return size_; }  // [m]: how far the joints are apart at home
  bool angle(Eigen::Index coordinate) const { return is_angle_[static_cast<std::size_t>(coordinate)]; }

  SmallVector coordinates(const SmallVector& u) const { return u.cwiseProduct(coordinate_scale_); }
  SmallVector numbers(const SmallVector& coordinates) const { return coordinates.cwiseQuotient(coordinate_scale_); }
  // Target less actuator values, in numbers; of a rotary actuator the smaller turn.
  SmallVector error(const SmallVector& actuators) const;

  double actuator_scale(Eigen::Index i) const { return actuator_scale_(i); }
  double coordinate_scale(Eigen::Index i) const { return coordinate_scale_(i); }

 private:
  std::span<const std::unique_ptr<Machine>> words_;
  double size_ = 1;
  SmallVector actuators_, actuator_scale_, coordinate_scale_;
  std::vector<bool> is_angle_, is_turn_;  // coordinates; actuators
};

// A pose, and what is known there.
struct Site {
  std::size_t word = 0;
  SmallVector u;         // coordinates in numbers
  bool reached = false;  // what follows holds only then
  SmallVector error;     // of the actuators: target less value
  SmallMatrix slope;     // of the actuators by u
};

// Where a walk stands still: the site that it waits for, and what goes on once it is known.
struct Halt {
  Site site;
  std::coroutine_handle<> next;

  auto at(std::size_t word, const SmallVector& u) {
    struct Awaiter {
      Halt& halt;
      bool await_ready() const noexcept { return false; }
      void await_suspend(std::coroutine_handle<> h) const noexcept { halt.next = h; }
      const Site& await_resume() const noexcept { return halt.site; }
    };
    site.word = word;
    site.u = u;
    return Awaiter{*this};
  }
};

// A search that gives a T in the end; awaited by another search, or begun by whoever places the poses.
template <class T>
class Walk {
 public:
  struct promise_type {
    std::optional<T> result;
    std::exception_ptr failure;
    std::coroutine_handle<> caller = std::noop_coroutine();

    struct Return {
      bool await_ready() const noexcept { return false; }
      std::coroutine_handle<> await_suspend(std::coroutine_handle<promise_type> h) const noexcept { return h.promise().caller; }
      void await_resume() const noexcept {}
    };
    Walk get_return_object() { return Walk(std::coroutine_handle<promise_type>::from_promise(*this)); }
    std::suspend_always initial_suspend() const noexcept { return {}; }
    Return final_suspend() const noexcept { return {}; }
    void return_value(T x) { result = std::move(x); }
    void unhandled_exception() { failure = std::current_exception(); }
  };

  Walk(Walk&& o) noexcept : handle_(std::exchange(o.handle_, {})) {}
  Walk& operator=(Walk&& o) noexcept { return std::swap(handle_, o.handle_), *this; }
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;
  ~Walk() {
    if (handle_) handle_.destroy();
  }

  void begin() const { handle_.resume(); }  // up to where it first stands still
  bool done() const { return handle_.done(); }
  T result() const {
    if (handle_.promise().failure) std::rethrow_exception(handle_.promise().failure);
    return std::move(*handle_.promise().result);
  }

  auto operator co_await() const {
    struct Awaiter {
      std::coroutine_handle<promise_type> callee;
      bool await_ready() const noexcept { return false; }
      std::coroutine_handle<> await_suspend(std::coroutine_handle<> caller) const noexcept {
        callee.promise().caller = caller;
        return callee;
      }
      T await_resume() const {
        if (callee.promise().failure) std::rethrow_exception(callee.promise().failure);
        return std::move(*callee.promise().result);
      }
    };
    return Awaiter{handle_};
  }

 private:
  explicit Walk(std::coroutine_handle<promise_type> h) : handle_(h) {}
  std::coroutine_handle<promise_type> handle_;
};

// Places the sites that walks wait for, those of one word together.
class AssemblyPlacer {
 public:
  explicit AssemblyPlacer(const AssemblyTarget& target) : target_(target) {}

  void place(std::span<Site*> sites);
  // Largest error of the actuators at each of some poses, in numbers; infinite where a pose cannot be assembled.
  std::vector<double> misses(std::size_t word, std::span<const SmallVector> poses);

 private:
  void place_together(std::span<Site*> sites);

  const AssemblyTarget& target_;
  std::vector<double> coordinates_, placements_;
};

}  // namespace pmreport::mechanics
