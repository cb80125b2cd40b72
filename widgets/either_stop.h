// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

namespace isoscope {

/// A stop that comes with either of two others: work ends when it is replaced, and when its thread ends.
/// Lives as long as the work.
class EitherStop {
  public:
    EitherStop(const std::stop_token& one, const std::stop_token& other)
        : onOne_(one, Request{&source_}), onOther_(other, Request{&source_}) {}

    /// For the work.
    std::stop_token token() const { return source_.get_token(); }
    /// Whether one of the two has come.
    bool requested() const { return source_.stop_requested(); }

  private:
    struct Request {
        std::stop_source* source;
        void operator()() const { source->request_stop(); }
    };

    std::stop_source source_;  // first: the others use it
    std::stop_callback<Request> onOne_, onOther_;
};

}  // namespace isoscope
