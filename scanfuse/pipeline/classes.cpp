#include "scanfuse/pipeline/classes.hpp"

#include <map>
#include <set>
#include <vector>

#include "scanfuse/core/assert.hpp"
#include "scanfuse/io/toml.hpp"
#include "scanfuse/pipeline/default_classes.hpp"

namespace scanfuse::pipeline {
namespace {

/// One number of the file: where it stands there, and where here.
struct Slot {
  std::string section;
  std::string key;
  double* value;
  bool positive = false;
};

std::string class_name(int row) { return std::string(to_string(classify::learned_class(row))); }

void add_interval(std::vector<Slot>& slots, const std::string& section, const std::string& name,
                  classify::Interval& interval) {
  slots.push_back({section, name + "_low", &interval.low});
  slots.push_back({section, name + "_high", &interval.high});
}

void add_intervals(std::vector<Slot>& slots, classify::Intervals& intervals) {
  for (std::size_t c = 0; c < intervals.size(); ++c) {
    const std::string section = "intervals." + class_name(static_cast<int>(c));
    add_interval(slots, section, "l_m", intervals[c].l);
    add_interval(slots, section, "var_r_of_one_m2", intervals[c].var_r_of_one);
    add_interval(slots, section, "l1_m", intervals[c].l1);
    add_interval(slots, section, "l2_m", intervals[c].l2);
    add_interval(slots, section, "var_r_of_two_m2", intervals[c].var_r_of_two);
  }
}

template <class Weights>
void add_weights(std::vector<Slot>& slots, const std::string& section,
                 const std::vector<std::string>& names, Weights& weights) {
  for (int c = 0; c < classify::kLearnedClasses; ++c) {
    for (std::size_t k = 0; k < names.size(); ++k) {
      slots.push_back({section + "." + class_name(c), names[k], &weights(c, k)});
    }
  }
}

void add_prior(std::vector<Slot>& slots, const std::string& section, auto& prior) {
  for (int c = 0; c < classify::kLearnedClasses; ++c) {
    slots.push_back({section + ".prior", class_name(c), &prior[c], true});
  }
}

/// Every number of the file, in its order.
std::vector<Slot> slots_of(Classes& classes) {
  auto& softmax = classes.recognizer.softmax;
  if (softmax.weights.size() == 0) {
    softmax.weights.setZero(classify::kLearnedClasses, classify::kTerms);
  }
  std::vector<Slot> slots;
  slots.push_back({"belief", "memory_s", &classes.belief.memory_s, true});
  slots.push_back({"belief", "full_s", &classes.belief.full_s, true});
  add_prior(slots, "belief", classes.belief.prior);
  slots.push_back({"softmax", "temperature", &softmax.temperature, true});
  add_prior(slots, "softmax", softmax.prior);
  add_intervals(slots, classes.recognizer.intervals);
  for (int i = 0; i < classify::kFeatures; ++i) {
    const std::string section = "features." + std::string(classify::feature_names()[i]);
    slots.push_back({section, "mean", &softmax.mean[i]});
    slots.push_back({section, "scale", &softmax.scale[i], true});
  }
  add_weights(slots, "belief", track::belief_term_names(), classes.belief.weights);
  add_weights(slots, "softmax", classify::term_names(), softmax.weights);
  return slots;
}

Result<Classes> from_entries(const std::vector<io::TomlEntry>& entries, const std::string& name) {
  Classes classes;
  const auto slots = slots_of(classes);
  std::map<std::string, const Slot*> by_name;
  for (const Slot& slot : slots) by_name[slot.section + "." + slot.key] = &slot;
  std::set<std::string> given;
  for (const auto& entry : entries) {
    const std::string key = entry.section + "." + entry.key;
    const auto found = by_name.find(key);
    if (found == by_name.end()) {
      return fail(Error::Code::kNotFound, "{}:{}: unknown key '{}' in a file of classes", name,
                  entry.line, key);
    }
    const auto value = detail::parse_double(entry.value);
    if (!value) {
      return fail(Error::Code::kMalformed, "{}:{}: {}: {}", name, entry.line, key,
                  value.error().message);
    }
    if (found->second->positive && *value <= 0) {
      return fail(Error::Code::kOutOfRange, "{}:{}: {} must be above 0", name, entry.line, key);
    }
    *found->second->value = *value;
    given.insert(key);
  }
  for (const Slot& slot : slots) {
    const std::string key = slot.section + "." + slot.key;
    if (!given.contains(key)) {
      return fail(Error::Code::kMalformed,
                  "{}: no key '{}'; a file of classes is written by `scanfuse learn classes`", name,
                  key);
    }
  }
  return classes;
}

bool is_learned(classify::Method method) {
  return method == classify::Method::kSoftmax || method == classify::Method::kGuoIntervals;
}

}  // namespace

Result<Classes> parse_classes(std::string_view text, const std::string& name) {
  const auto entries = io::parse_toml(text, name);
  if (!entries) return tl::unexpected(entries.error());
  return from_entries(*entries, name);
}

Result<Classes> read_classes(const std::filesystem::path& path) {
  const auto entries = io::read_toml(path);
  if (!entries) return tl::unexpected(entries.error());
  return from_entries(*entries, path.string());
}

std::string write_classes(const Classes& classes) {
  Classes copy = classes;
  std::string text =
      "# What scanfuse knows of classes, written by `scanfuse learn classes`; docs/detection.md.\n";
  std::string section;
  for (const Slot& slot : slots_of(copy)) {
    if (slot.section != section) text += fmt::format("\n[{}]\n", section = slot.section);
    text += fmt::format(
        "{} = {:.5g}{}\n", slot.key, *slot.value,
        fmt::format("{:.5g}", *slot.value).find_first_of(".e") == std::string::npos ? ".0" : "");
  }
  return text;
}

std::shared_ptr<const Classes> default_classes() {
  static const std::shared_ptr<const Classes> kShipped = [] {
    auto classes = parse_classes(default_classes_text(), "classes.toml");
    SCANFUSE_ASSERT(classes.has_value());
    return std::make_shared<const Classes>(std::move(*classes));
  }();
  return kShipped;
}

void use_classes(PerceptionOptions& options, const std::shared_ptr<const Classes>& classes) {
  options.classify.model =
      std::shared_ptr<const classify::ClassModel>(classes, &classes->recognizer);
  options.track.belief = nullptr;
  if (options.classify.method == classify::Method::kSoftmax) {
    options.track.belief = std::shared_ptr<const track::BeliefModel>(classes, &classes->belief);
  }
}

Result<void> load_classes(PerceptionOptions& options) {
  if (!is_learned(options.classify.method)) {
    options.track.belief = nullptr;
    return {};
  }
  if (options.classify.classes_file.empty()) {
    use_classes(options, default_classes());
    return {};
  }
  auto classes = read_classes(options.classify.classes_file);
  if (!classes) return tl::unexpected(classes.error());
  use_classes(options, std::make_shared<const Classes>(std::move(*classes)));
  return {};
}

}  // namespace scanfuse::pipeline
