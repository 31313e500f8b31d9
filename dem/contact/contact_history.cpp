#include "dem/contact/contact_history.hpp"

#include <algorithm>

namespace fiberchain::dem {
namespace {

LaneArray grown(const LaneArray& from, std::size_t size) {
  LaneArray larger(size);
  std::copy_n(from.data(), from.size(), larger.data());
  return larger;
}

}  // namespace

void ContactHistories::reset() {
  free_count = 0;
  for (auto number = static_cast<std::int32_t>(free.size()) - 1; number > 0; --number) give_back(number);
}

void ContactHistories::reserve(std::size_t numbers) {
  const auto there = static_cast<std::size_t>(free_count);
  if (there >= numbers && !free.empty()) return;
  const std::size_t before = std::max<std::size_t>(free.size(), 1),
                    after = before + (numbers - there) + numbers / 4 + 16;
  rows = grown(rows, after * contact_history_size);
  if (accounted) work = grown(work, after * contact_account_size);
  free.resize(after);
  for (std::size_t number = after - 1; number >= before; --number)
    give_back(static_cast<std::int32_t>(number));
}

SavedContact ContactHistories::at(std::int32_t number, const ContactKey& key) const {
  const auto row = static_cast<std::ptrdiff_t>(number);
  SavedContact contact{key};
  std::copy_n(rows.data() + row * contact_history_size, contact_history_size, contact.history);
  if (accounted) std::copy_n(work.data() + row * contact_account_size, contact_account_size, contact.work);
  return contact;
}

void ContactHistories::put(std::int32_t number, const SavedContact& contact) {
  const auto row = static_cast<std::ptrdiff_t>(number);
  std::copy_n(contact.history, contact_history_size, rows.data() + row * contact_history_size);
  if (accounted) std::copy_n(contact.work, contact_account_size, work.data() + row * contact_account_size);
}

}  // namespace fiberchain::dem
