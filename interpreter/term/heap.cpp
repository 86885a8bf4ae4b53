// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/heap.h"

#include <algorithm>
#include <array>

namespace jaywalk {
namespace {

// The upper 16 bits of a cell's first word mark a moved cell: no Value and no header has them.
constexpr std::uint64_t kMoved = std::uint64_t{0x7FF4} << 48U;
constexpr std::uint64_t kMovedMask = std::uint64_t{0xFFFF} << 48U;
constexpr std::uint64_t kAddressMask = 0x0000FFFFFFFFFFF8U;
constexpr std::uint16_t kTextInfo = 0x2000;
constexpr std::uint64_t kObjectInfo = std::uint64_t{0x3000} << 48U;

constexpr std::size_t kFirstChunkWords = 64;
constexpr std::size_t kLargestChunkWords = std::size_t{1} << 15U;
constexpr std::size_t kLeastCollection = 64 * 1024;

std::size_t text_words(std::size_t length) { return 1 + (length + 7) / 8; }

// A constant list [source(Agent)] in static storage.
struct SourceConstant {
  explicit SourceConstant(Predicate agent)
      : structure{static_cast<std::uint32_t>(predicates::source), 1, 0},
        agent_value(Value::atom(agent)) {
    list.head =
        Value::reference(Value::Kind::structure, &structure, Value::kClosed | Value::kStatic);
    list.tail = Value::empty_list();
  }
  [[nodiscard]] Value value() const {
    return Value::reference(Value::Kind::pair, &list, Value::kClosed | Value::kStatic);
  }
  alignas(8) Structure structure;
  Value agent_value;  // directly behind the header, as in a heap
  alignas(8) Pair list;
};

}  // namespace

Value source_self() {
  static const SourceConstant constant(predicates::self);
  return constant.value();
}

Value source_percept() {
  static const SourceConstant constant(predicates::percept);
  return constant.value();
}

Heap::Heap(Owner owner) : static_flag_(owner == Owner::program ? Value::kStatic : 0) {}

void Heap::grow(std::size_t words) {
  full_bytes_ += used_in_current();
  const std::size_t last =
      std::max(kFirstChunkWords / 2, chunks_.empty() ? 0 : chunks_.back().size);
  const std::size_t most = most_bytes();
  const std::size_t room = (most - std::min(most, full_bytes_)) / sizeof(std::uint64_t);
  if (words > room) {
    // Nothing has been added: the count is as before.
    full_bytes_ -= used_in_current();
    give_up();
  }
  // Chunks double, up to a bound and to what the limit leaves, but never hold less than is asked
  // for.
  const std::size_t size = std::max(words, std::min({last * 2, kLargestChunkWords, room}));
  chunks_.push_back({std::make_unique_for_overwrite<std::uint64_t[]>(size), size});
  start_ = top_ = chunks_.back().words.get();
  end_ = top_ + size;
}

// The bytes that terms may take.
std::size_t Heap::most_bytes() const {
  // Half of it: a collection copies what is alive, and needs as much room again for a moment.
  return (limit_bytes_ - std::min(limit_bytes_, other_bytes_)) / 2;
}

void Heap::require_bytes(std::size_t bytes) {
  const std::size_t all = all_bytes();
  if (all > limit_bytes_ || bytes > limit_bytes_ - all) give_up();
}

// Some of what there is may be garbage by now, or soon. But where next to nothing is, that is not
// looked at for every step that fails.
void Heap::give_up() {
  if (full_at_ == 0) full_at_ = std::max<std::size_t>(1, all_bytes());
  if (++failures_ >= patience_) look_again();
  throw HeapExhausted{limit_is_of_all_};
}

// Makes sure that memory is counted before the limit is reached.
void Heap::look_sooner(std::size_t limit) {
  const std::size_t all = all_bytes();
  count_at_ = std::min(count_at_, other_bytes_ + (limit - std::min(limit, all)));
  ask_at_ = std::min(ask_at_, count_at_);
}

void Heap::set_other_bytes(std::size_t bytes) {
  constexpr std::size_t kLeast = 256 * 1024;
  constexpr std::uint32_t kMostPatience = 1024;
  other_bytes_ = bytes;
  const std::size_t all = all_bytes();
  if (full_at_ != 0) {
    const bool was_worth_it = all + full_at_ / 16 < full_at_;
    patience_ = was_worth_it ? 1 : std::min(2 * patience_, kMostPatience);
    failures_ = 0;
    full_at_ = 0;
  }
  // Counting and collecting cost little compared with the allocations since the last time, and
  // happen before the limit is reached.
  const std::size_t room = limit_bytes_ - std::min(limit_bytes_, all);
  count_at_ = bytes + std::min(std::max(all, kLeast), std::max(room / 2, all / 16 + 256));
  // Without room the next count may be far away, but no request succeeds.
  ask_at_ = room == 0 ? 0 : std::min(count_at_, bytes + room);
  // Terms have less room than there was when they were collected.
  const std::size_t before_limit = live_bytes_ / 2 + most_bytes() / 2;
  collect_at_ = std::min(
      collect_at_, std::max({kLeastCollection, live_bytes_ + live_bytes_ / 16, before_limit}));
}

Heap::Remains Heap::leave_remains() {
  Remains remains;
  if (!chunks_.empty() && chunks_.front().size == kFirstChunkWords) {
    remains.words_ = std::move(chunks_.front().words);
    remains.size_ = kFirstChunkWords;
  }
  chunks_.clear();
  objects_.clear();
  start_ = top_ = end_ = nullptr;
  return remains;
}

void Heap::clear() {
  objects_.clear();
  const bool is_usual = !chunks_.empty() && chunks_.front().size == kFirstChunkWords;
  release_chunks(is_usual ? 1 : 0);
  top_ = start_;
  floor_ = {};
}

void Heap::use(Remains remains) {
  if (remains.words_ == nullptr) return;
  chunks_.push_back({std::move(remains.words_), remains.size_});
  start_ = top_ = chunks_.back().words.get();
  end_ = top_ + remains.size_;
}

Heap::Remains Heap::chunk_of(std::size_t words) {
  Remains made;
  if (words == 0) return made;
  made.words_ = std::make_unique_for_overwrite<std::uint64_t[]>(words);
  made.size_ = words;
  return made;
}

void Heap::enter(Remains& nursery) {
  if (nursery.words_ == nullptr) nursery = chunk_of(kNurseryWords);
  use(std::move(nursery));
}

// The chunk that was current at a mark was full up to where it was left.
void Heap::release_chunks(std::size_t kept) {
  chunks_.resize(kept);
  full_bytes_ = 0;
  if (chunks_.empty()) {
    start_ = top_ = end_ = nullptr;
    return;
  }
  for (std::size_t i = 0; i + 1 < chunks_.size(); ++i) {
    full_bytes_ += chunks_[i].size * sizeof(std::uint64_t);
  }
  start_ = chunks_.back().words.get();
  end_ = start_ + chunks_.back().size;
}

Value Heap::structure(Predicate predicate, std::span<const Value> args, Value annots, Form form) {
  const bool annotated = !annots.is_empty_list();
  if (args.empty() && !annotated && form == Form::literal) return Value::atom(predicate);
  if (args.size() > kMostParts) throw TermTooWide{};
  const std::size_t extra = annotated ? 1 : 0;
  std::uint64_t* const cell = allocate(1 + extra + args.size());
  auto* const made = reinterpret_cast<Structure*>(cell);
  made->predicate_id = static_cast<std::uint32_t>(predicate);
  made->arity = static_cast<std::uint16_t>(args.size());
  made->info = static_cast<std::uint16_t>(static_cast<unsigned>(form) |
                                          (annotated ? Structure::kAnnotated : 0U));
  // Expressions and functions are still to be computed, decorated literals to be resolved: never
  // closed.
  bool closed = form != Form::expression && form != Form::function && form != Form::decorated;
  Value* const cells = made->cells();
  if (annotated) {
    cells[0] = annots;
    closed = closed && annots.is_closed();
  }
  for (std::size_t i = 0; i < args.size(); ++i) {
    cells[extra + i] = args[i];
    closed = closed && args[i].is_closed();
  }
  return Value::reference(Value::Kind::structure, cell,
                          (closed ? Value::kClosed : 0) | static_flag_);
}

Value Heap::list(std::span<const Value> elements, Value tail) {
  for (std::size_t i = elements.size(); i > 0; --i) tail = pair(elements[i - 1], tail);
  return tail;
}

Value Heap::text(std::string_view bytes) {
  std::uint64_t* const cell = allocate(text_words(bytes.size()));
  auto* const made = reinterpret_cast<Text*>(cell);
  made->length = static_cast<std::uint32_t>(bytes.size());
  made->unused = 0;
  made->info = kTextInfo;
  if (!bytes.empty()) std::memcpy(made + 1, bytes.data(), bytes.size());
  return Value::reference(Value::Kind::text, cell, static_flag_);
}

Value Heap::object(std::unique_ptr<Object> object) {
  const std::size_t bytes = object->bytes();
  // Before anything is made, so that a heap at its limit is left as it was.
  require_bytes(bytes);
  std::uint64_t* const cell = allocate(2);
  note_other_bytes(bytes);
  auto* const made = reinterpret_cast<ObjectCell*>(cell);
  made->info = kObjectInfo;
  object->serial = next_object_++;
  made->object = object.get();
  objects_.push_back(std::move(object));
  return Value::reference(Value::Kind::object, cell, 0);
}

std::vector<Heap::Chunk> Heap::start_collection() {
  std::vector<Chunk> old = std::move(chunks_);
  chunks_.clear();
  start_ = top_ = end_ = nullptr;
  full_bytes_ = 0;
  // Marks refer to chunks that are given up now.
  floor_ = {};
  for (const auto& object : objects_) object->reached = false;
  return old;
}

void Heap::finish_collection() {
  erase_if(objects_, [](const auto& object) { return !object->reached; });
  // Before the limit is reached, however much is alive.
  live_bytes_ = bytes();
  collect_at_ = std::max({kLeastCollection, bytes() + bytes() / 16,
                          std::min(2 * bytes(), bytes() / 2 + most_bytes() / 2)});
}

std::size_t Heap::object_bytes() const {
  std::size_t bytes = 0;
  for (const auto& object : objects_) bytes += object->bytes();
  return bytes;
}

// Moves reachable terms before there are very many roots, so that few are pending.
void Heap::Relocator::operator()(Value& value) {
  constexpr std::size_t kMostPending = 4096;
  move(value);
  if (pending_.size() > kMostPending) drain();
}

void Heap::Relocator::move(Value& value) {
  const Value::Kind kind = value.kind();
  if (kind == Value::Kind::number || kind == Value::Kind::atom || kind == Value::Kind::special ||
      value.is_static()) {
    return;
  }
  // All cells begin with a word that says whether, and where to, the cell has moved.
  auto* const cell = reinterpret_cast<std::uint64_t*>(value.bits() & kAddressMask);
  if ((cell[0] & kMovedMask) == kMoved) {
    value = Value::reference(kind, reinterpret_cast<void*>(cell[0] & kAddressMask), value.flags());
    return;
  }
  std::size_t words = 2;
  std::size_t first_value = 0;
  std::size_t value_count = 0;
  switch (kind) {
    case Value::Kind::structure: {
      const auto* const structure = reinterpret_cast<const Structure*>(cell);
      first_value = 1;
      value_count = structure->arity + (structure->is_annotated() ? 1U : 0U);
      words = 1 + value_count;
      break;
    }
    case Value::Kind::pair:
      value_count = 2;
      break;
    case Value::Kind::text:
      words = text_words(reinterpret_cast<const Text*>(cell)->length);
      break;
    case Value::Kind::variable:
      value_count = 1;
      break;
    case Value::Kind::object: {
      Object* const object = reinterpret_cast<ObjectCell*>(cell)->object;
      if (!object->reached) {
        object->reached = true;
        pending_objects_.push_back(object);
      }
      break;
    }
    default:
      break;
  }
  std::uint64_t* const moved = heap_.allocate(words);
  // First copied, then marked: the first word of the old cell becomes the new address.
  std::memcpy(moved, cell, words * sizeof(std::uint64_t));
  cell[0] = kMoved | reinterpret_cast<std::uintptr_t>(moved);
  value = Value::reference(kind, moved, value.flags());
  if (value_count > 0) {
    pending_.emplace_back(reinterpret_cast<Value*>(moved + first_value), value_count);
  }
}

void Heap::Relocator::drain() {
  while (!pending_.empty() || !pending_objects_.empty()) {
    if (pending_.empty()) {
      Object* const object = pending_objects_.back();
      pending_objects_.pop_back();
      object->visit([this](Value& value) { move(value); });
      continue;
    }
    const auto [first, count] = pending_.back();
    pending_.pop_back();
    // A list's tail is pushed first: it waits below the head, which is soon finished.
    for (std::size_t i = count; i > 0; --i) move(first[i - 1]);
  }
}

}  // namespace jaywalk
