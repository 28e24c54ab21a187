#include "report/program/share_option.h"

#include <fmt/format.h>

#include <charconv>

#include "engine/base/errors.h"

namespace plumb {
namespace {

constexpr std::size_t most_shares = 1'000'000;

}  // namespace

Share asked_share(const Options& options) {
  Share share;
  if (options.share.empty()) return share;
  const char* at = options.share.data();
  const char* end = at + options.share.size();
  const auto read = [&](std::size_t& number) {
    const auto [next, error] = std::from_chars(at, end, number);
    at = next;
    return error == std::errc() && number >= 1 && number <= most_shares;
  };
  if (!read(share.number) || at == end || *at++ != '/' || !read(share.of) || at != end ||
      share.number > share.of)
    throw UsageError(fmt::format("--share {}: a share is K/N with K from 1 to N and N at most {}, as 3/16",
                                 options.share, most_shares));
  return share;
}

std::string suffix_of(const Share& share) {
  return share.is_all() ? "" : fmt::format(".share-{}-of-{}", share.number, share.of);
}

}  // namespace plumb
