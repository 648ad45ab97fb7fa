#include "scene/obj_lines.h"

#include <algorithm>

namespace laver::obj {

Lines::Lines(std::string text) : text_(std::move(text)) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.replace(0, 3, "   ");
}

bool Lines::next() {
  words_.clear();
  while (words_.empty() && nextBegin_ < text_.size()) {
    begin_ = nextBegin_;
    line_ = nextLine_;
    const std::size_t joinsBefore = joins_.size();
    const std::size_t end = joinedLineEnd();
    split(end);
    nextBegin_ = end + 1;
    nextLine_ += joins_.size() - joinsBefore + (isCrLf(end) ? 0 : 1);
  }
  return !words_.empty();
}

void Lines::replace(std::string_view word, std::string_view text) {
  const auto place = text_.begin() + static_cast<std::ptrdiff_t>(offsetOf(word));
  std::fill_n(std::copy(text.begin(), text.end(), place), word.size() - text.size(), ' ');
}

std::size_t Lines::lineOf(std::size_t offset) const {
  std::size_t line = 1;
  for (std::size_t i = 0; i < offset && i < text_.size(); ++i) {
    if (text_[i] == '\n' || (text_[i] == '\r' && !isCrLf(i))) ++line;
  }
  const auto before = [&](std::size_t join) { return join < offset; };
  return line + static_cast<std::size_t>(std::count_if(joins_.begin(), joins_.end(), before));
}

bool Lines::isCrLf(std::size_t at) const {
  return at + 1 < text_.size() && text_[at] == '\r' && text_[at + 1] == '\n';
}

std::size_t Lines::lineEnd(std::size_t from) const {
  while (from < text_.size() && text_[from] != '\n' && text_[from] != '\r') ++from;
  return from;
}

std::size_t Lines::joinedLineEnd() {
  std::size_t end = lineEnd(begin_);
  if (end == begin_ || end == text_.size() || text_[end - 1] != '\\') return end;
  // Names in other statements may end in a backslash, and so may comments.
  const std::size_t first = text_.find_first_not_of(" \t", begin_);
  if (text_[first] != 'v' && text_[first] != 'f') return end;
  const auto hasComment = [&] {
    const std::string_view line = std::string_view(text_).substr(begin_, end - begin_);
    return line.find(" #") != std::string::npos || line.find("\t#") != std::string::npos;
  };
  while (end < text_.size() && text_[end - 1] == '\\' && !hasComment()) {
    const bool crLf = isCrLf(end);
    joins_.push_back(end);
    text_[end - 1] = text_[end] = ' ';
    if (crLf) text_[end + 1] = ' ';
    end = lineEnd(end);
  }
  return end;
}

void Lines::split(std::size_t end) {
  for (std::size_t i = begin_; i < end;) {
    if (text_[i] == ' ' || text_[i] == '\t') {
      ++i;
      continue;
    }
    if (text_[i] == '#') {
      std::fill_n(text_.begin() + static_cast<std::ptrdiff_t>(i), end - i, ' ');
      return;
    }
    const std::size_t start = i;
    while (i < end && text_[i] != ' ' && text_[i] != '\t') ++i;
    words_.push_back(std::string_view(text_).substr(start, i - start));
  }
}

}  // namespace laver::obj
