#pragma once

#include "engine/base/codec.h"
#include "engine/case/blunder_words.h"
#include "engine/study/sensitivity/sensitivity.h"

/// What the journal, study.json and results.json keep of a sensitivity.
namespace plumb {

template <class Archive>
void members(Archive& a, Found& found) {
  a("value", found.value);
  a("noticed", found.noticed);
}

template <class Archive>
void members(Archive& a, Trial& trial) {
  a("outcome", trial.outcome);
  a("message", trial.message);
  a("found", trial.found);
}

template <class Archive>
void members(Archive& a, NoticedChange& noticed) {
  a("change", noticed.change);
  a("by_failure", noticed.by_failure);
}

template <class Archive>
void members(Archive& a, SearchedSide& side) {
  a("runs", side.runs);
  a("searched", side.searched);
  a("ended", side.ended);
  a("noticed", side.noticed);
}

template <class Archive>
void members(Archive& a, JudgedCriterion& criterion) {
  a("name", criterion.name);
  a("unit", criterion.unit);
  a("limit", criterion.limit);
  a("value", criterion.value);
  a("met", criterion.met);
}

template <class Archive>
void members(Archive& a, NumberSensitivity& number) {
  a("key", number.key);
  a("words", number.words);
  a("up", number.up);
  a("down", number.down);
}

template <class Archive>
void members(Archive& a, BlunderSensitivity& of) {
  a("kind", of.blunder.kind);
  a("name", of.blunder.name);
  a("overrides", of.blunder.overrides);
  a("why_not", of.blunder.why_not);
  members(a, of.trial);
}

template <class Archive>
void members(Archive& a, Sensitivity& all) {
  a("largest", all.largest);
  a("time_limit", all.time_limit);
  a("left_out", all.left_out);
  a("criteria", all.criteria);
  a("numbers", all.numbers);
  a("blunders", all.blunders);
  a("runs", all.runs);
  a("seconds", all.seconds);
}

}  // namespace plumb
