#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "dem/scene/key_declaration.hpp"
#include "dem/scene/strict_mapping.hpp"

namespace fiberchain::dem {

/// Words of a scene file and the values they stand for.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

/// Words of enumerators that have a name().
template <class Value>
Words<Value> words_of(std::initializer_list<Value> values) {
  Words<Value> words;
  for (const Value value : values) words.emplace_back(std::string(name(value)), value);
  return words;
}

/// One key of mappings that are read into a T.
template <class T>
struct SceneKey {
  KeyDeclaration declared;
  std::function<void(const StrictMapping&, T&)> read;  ///< of the mapping that holds the key
  std::function<bool(const T&)> applies = {};          ///< of the keys declared before; always where empty
  std::string condition = {};                          ///< the same in words

  /// The key must be there (where it applies).
  SceneKey& required() {
    declared.must = true;
    declared.otherwise.clear();
    return *this;
  }

  /// Words for what holds where the key is left out, in place of the value that T is born with.
  SceneKey& otherwise(std::string words) {
    declared.otherwise = std::move(words);
    return *this;
  }

  /// The key names a file beside the scene's: what counts is its content.
  SceneKey& content_counts() {
    declared.file = true;
    return *this;
  }

  /// The key is of use under a condition on keys declared before only, "integrator: cvode".
  SceneKey& only_with(const std::string& words, std::function<bool(const T&)> holds) {
    declared.meaning += "; only with " + words;
    applies = std::move(holds);
    condition = words;
    return *this;
  }
};

/// All keys of one kind of mapping, each declared once, in the order they are read in. A member is a pointer
/// to a member of T or a function from T& to a reference. Reading throws SceneError with file, line, key,
/// value and what is allowed.
template <class T>
class KeyTable {
 public:
  /// `defaults`: the values of keys that are left out.
  explicit KeyTable(T defaults = T{}) : defaults_(std::move(defaults)) {}

  const T& defaults() const { return defaults_; }

  /// A number, alone or with a unit of the dimension of `unit`.
  template <class Member>
  SceneKey<T>& quantity(const std::string& key, const std::string& unit, Member member,
                        const ValueRange& range, const std::string& meaning) {
    const ValueRange sizes = in_unit(range, unit);
    return add(key, unit, describe(sizes), shown(member), meaning, [=](const StrictMapping& from, T& to) {
      std::invoke(member, to) = from.quantity(key, unit, sizes);
    });
  }

  /// A number without dimension.
  template <class Member>
  SceneKey<T>& number(const std::string& key, Member member, const ValueRange& range,
                      const std::string& meaning) {
    return quantity(key, "1", member, range, meaning);
  }

  template <class Member>
  SceneKey<T>& integer(const std::string& key, Member member, const ValueRange& range,
                       const std::string& meaning) {
    return add(key, "1", "whole number " + describe(range), shown(member), meaning,
               [=](const StrictMapping& from, T& to) {
                 auto& value = std::invoke(member, to);
                 value = static_cast<std::remove_reference_t<decltype(value)>>(from.integer(key, range));
               });
  }

  /// true or false.
  template <class Member>
  SceneKey<T>& flag(const std::string& key, Member member, const std::string& meaning) {
    return add(key, "", "`false`, `true`", shown(member), meaning,
               [=](const StrictMapping& from, T& to) { std::invoke(member, to) = from.flag(key); });
  }

  /// A text that is not empty.
  template <class Member>
  SceneKey<T>& word(const std::string& key, Member member, const std::string& allowed,
                    const std::string& meaning) {
    return add(key, "", allowed, shown(member), meaning,
               [=](const StrictMapping& from, T& to) { std::invoke(member, to) = from.word(key); });
  }

  /// Two texts that are not empty.
  template <class Member>
  SceneKey<T>& two_words(const std::string& key, Member member, const std::string& allowed,
                         const std::string& meaning) {
    return add(key, "", allowed, "", meaning, [=](const StrictMapping& from, T& to) {
      const std::vector<std::string> words = from.words(key, 2);
      std::invoke(member, to) = {words[0], words[1]};
    });
  }

  /// One of some words.
  template <class Value, class Member>
  SceneKey<T>& choice(const std::string& key, Member member, const Words<Value>& words,
                      const std::string& meaning) {
    std::vector<std::string> texts;
    std::string fallback;
    const std::optional<Value> usual = std::invoke(member, defaults_);
    for (const auto& [text, value] : words) {
      texts.push_back(text);
      if (usual == value) fallback = text;
    }
    return add(key, "", fmt::format("`{}`", fmt::join(texts, "`, `")), fallback, meaning,
               [=](const StrictMapping& from, T& to) {
                 std::invoke(member, to) = words[from.choice(key, texts)].second;
               });
  }

  /// Three finite numbers, each alone or with a unit.
  template <class Member>
  SceneKey<T>& vector(const std::string& key, const std::string& unit, Member member,
                      const std::string& meaning) {
    const ValueRange sizes = in_unit(kFinite, unit);
    return add(key, unit, fmt::format("three numbers of at most {:g} in size", sizes.high), shown(member),
               meaning, [=](const StrictMapping& from, T& to) {
                 const std::vector<double> v = from.quantities(key, unit, 3, sizes);
                 std::invoke(member, to) = {v[0], v[1], v[2]};
               });
  }

  /// Three numbers that are not all zero: the unit vector along them.
  template <class Member>
  SceneKey<T>& direction(const std::string& key, Member member, const std::string& meaning) {
    return add(key, "1", "three finite numbers, not all 0 (length does not matter)", shown(member), meaning,
               [=](const StrictMapping& from, T& to) {
                 const std::array<double, 3> u = from.direction(key);
                 std::invoke(member, to) = {u[0], u[1], u[2]};
               });
  }

  /// Two numbers, the second larger.
  template <class Member>
  SceneKey<T>& interval(const std::string& key, const std::string& unit, Member member,
                        const std::string& meaning) {
    const ValueRange sizes = in_unit(kFinite, unit);
    const std::string allowed = fmt::format("`[low, high]`, low < high, of at most {:g} in size", sizes.high);
    return add(key, unit, allowed, "", meaning, [=](const StrictMapping& from, T& to) {
      const std::vector<double> ends = from.quantities(key, unit, 2, sizes);
      if (!(ends[0] < ends[1])) from.fail(key, "must rise: [low, high]");
      std::invoke(member, to) = {ends[0], ends[1]};
    });
  }

  /// Three rows of three finite numbers.
  template <class Member>
  SceneKey<T>& matrix(const std::string& key, const std::string& unit, Member member,
                      const std::string& meaning) {
    const ValueRange sizes = in_unit(kFinite, unit);
    return add(key, unit, fmt::format("three rows of three numbers of at most {:g} in size", sizes.high), "",
               meaning,
               [=](const StrictMapping& from, T& to) { std::invoke(member, to) = from.matrix(key, sizes); });
  }

  /// A mapping with keys of its own, handed to `store` as (mapping, value, T&) once read.
  template <class U, class Store>
  SceneKey<T>& mapping(const std::string& key, const KeyTable<U>& table, Store store,
                       const std::string& meaning) {
    SceneKey<T>& added = add(key, "", "mapping", "", meaning, [=](const StrictMapping& from, T& to) {
      const StrictMapping nested = from.mapping(key, table.names());
      U value = table.defaults();
      table.read(nested, value);
      store(nested, value, to);
    });
    added.declared.keys = table.declarations();
    return added;
  }

  /// The same, or a word that stands for the mapping `meant`.
  template <class U, class Store>
  SceneKey<T>& mapping_or_word(const std::string& key, const std::string& word, const U& meant,
                               const KeyTable<U>& table, Store store, const std::string& meaning) {
    SceneKey<T>& added = mapping(key, table, store, meaning);
    added.declared.allowed = fmt::format("mapping, or `{}`", word);
    added.read = [=, read_mapping = added.read](const StrictMapping& from, T& to) {
      from.is_word(key, word) ? store(from, meant, to) : read_mapping(from, to);
    };
    return added;
  }

  /// A mapping whose keys belong to a member of T, or with std::identity to T itself.
  template <class U, class Member>
  SceneKey<T>& mapping_into(const std::string& key, Member member, const KeyTable<U>& table,
                            const std::string& meaning) {
    SceneKey<T>& added = add(key, "", "mapping", "", meaning, [=](const StrictMapping& from, T& to) {
      table.read(from.mapping(key, table.names()), std::invoke(member, to));
    });
    added.declared.keys = table.declarations();
    return added;
  }

  /// A list of such mappings, at least one.
  template <class U, class Store>
  SceneKey<T>& list(const std::string& key, const KeyTable<U>& table, Store store,
                    const std::string& meaning) {
    SceneKey<T>& added = add(key, "", "list of mappings", "", meaning, [=](const StrictMapping& from, T& to) {
      for (const StrictMapping& nested : from.mappings(key, table.names())) {
        U value = table.defaults();
        table.read(nested, value);
        store(nested, value, to);
      }
    });
    added.declared.keys = table.declarations();
    added.declared.list = true;
    return added;
  }

  /// A key that is read before the table: `scene`, which says what the table is.
  SceneKey<T>& known(const std::string& key, const std::string& value, const std::string& meaning) {
    return add(key, "", "`" + value + "`", "", meaning, [](const StrictMapping&, T&) {}).required();
  }

  /// Exactly one of these keys must be there; `or_none`: at most one, and what holds without.
  void one_of(const std::vector<std::string>& keys, const std::string& or_none = "") {
    for (SceneKey<T>& key : keys_) {
      if (!std::ranges::count(keys, key.declared.name)) continue;
      std::vector<std::string> others = keys;
      std::erase(others, key.declared.name);
      key.declared.otherwise = fmt::format("with `{}`{}", fmt::join(others, "`, `"),
                                           or_none.empty() ? "" : "; without both " + or_none);
    }
    alternatives_.push_back({keys, !or_none.empty()});
  }

  /// At least one of these keys must be there.
  void one_or_more_of(const std::vector<std::string>& keys) {
    one_of(keys);
    alternatives_.back().several = true;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const SceneKey<T>& key : keys_) names.push_back(key.declared.name);
    return names;
  }

  std::vector<KeyDeclaration> declarations() const {
    std::vector<KeyDeclaration> all;
    for (const SceneKey<T>& key : keys_) all.push_back(key.declared);
    return all;
  }

  /// Reads all keys into a value that holds the defaults; the mapping's keys are known to be allowed.
  void read(const StrictMapping& from, T& to) const {
    for (const SceneKey<T>& key : keys_) {
      check_alternatives(from, key.declared.name);
      read(key, from, to);
    }
  }

  /// The whole of a mapping that may hold these keys only.
  T read_strictly(const StrictMapping& from) const {
    from.allow(names());
    T value = defaults_;
    read(from, value);
    return value;
  }

 private:
  struct Alternatives {
    std::vector<std::string> keys;
    bool or_none, several = false;
  };

  SceneKey<T>& add(const std::string& key, const std::string& unit, const std::string& allowed,
                   const std::string& otherwise, const std::string& meaning,
                   std::function<void(const StrictMapping&, T&)> read) {
    return keys_.emplace_back(SceneKey<T>{{key, unit, allowed, otherwise, meaning}, std::move(read)});
  }

  template <class Member>
  std::string shown(Member member) {
    return scene_text(std::invoke(member, defaults_));
  }

  /// Before the first key of some alternatives is read.
  void check_alternatives(const StrictMapping& from, const std::string& key) const {
    for (const Alternatives& alternatives : alternatives_) {
      const auto is_there = [&](const std::string& one) { return from.has(one); };
      if (alternatives.keys.front() != key) continue;
      if (alternatives.or_none && std::ranges::none_of(alternatives.keys, is_there)) continue;
      if (alternatives.several) {
        if (std::ranges::any_of(alternatives.keys, is_there)) continue;
        from.fail("", fmt::format("needs {}", fmt::join(alternatives.keys, " or ")));
      }
      from.one_of(alternatives.keys);
    }
  }

  static void read(const SceneKey<T>& key, const StrictMapping& from, T& to) {
    const std::string& name = key.declared.name;
    const bool applies = !key.applies || key.applies(to);
    if (!from.has(name)) {
      if (key.declared.must && applies) from.fail_missing(name);
      return;
    }
    if (!applies) from.fail(name, "is of use only with " + key.condition);
    key.read(from, to);
  }

  T defaults_;
  std::vector<SceneKey<T>> keys_;
  std::vector<Alternatives> alternatives_;
};

}  // namespace fiberchain::dem
