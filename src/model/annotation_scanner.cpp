#include "model/annotation_scanner.h"

#include <optional>

#include "core/text.h"

namespace dimline {

namespace {

class Scanner {
public:
  explicit Scanner(std::string_view text) : text_(text) {}

  Result<std::vector<AnnotationEntry>> scan() {
    skipSpace();
    if (!take('@')) return unexpected("an annotation starts with @Handle(");
    const TextPlace start = place_;
    const std::string_view word = readWord();
    if (!equalIgnoringCase(word, "Handle")) {
      return Error{messageStart(start) + "the annotation must be @Handle(\xE2\x80\xA6), not " +
                   inQuotes("@" + std::string(word)) + "."};
    }
    skipSpace();
    if (!take('(')) return unexpected("after @Handle a ( must follow");

    std::vector<AnnotationEntry> entries;
    for (skipSpace(); !take(')'); skipSpace()) {
      auto entry = scanEntry();
      if (!entry) return entry.error();
      entries.push_back(*entry);
      skipSpace();
      // A comma after the last entry is common where each stands on a line of its own.
      if (!take(',') && peek() != ')') return unexpected("after " + inQuotes(entry->name) + " a , or ) must follow");
    }
    skipSpace();
    if (!atEnd()) return unexpected("nothing may follow the closing )");
    return entries;
  }

private:
  [[nodiscard]] bool atEnd() const { return next_ == text_.size(); }
  [[nodiscard]] char peek() const { return atEnd() ? '\0' : text_[next_]; }

  void advance() {
    const char c = text_[next_++];
    if (c == '\n' || (c == '\r' && peek() != '\n')) {
      ++place_.line;
      place_.column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80) {
      ++place_.column;
    }
  }
  bool take(char c) {
    if (atEnd() || text_[next_] != c) return false;
    advance();
    return true;
  }
  void skipSpace() {
    while (!atEnd() && std::string_view(" \t\n\r\v\f").find(text_[next_]) != std::string_view::npos) advance();
  }
  std::string_view readWord() {
    const std::size_t first = next_;
    while (!atEnd() && std::string_view(" \t\n\r\v\f,=(){}\"@").find(text_[next_]) == std::string_view::npos) advance();
    return text_.substr(first, next_ - first);
  }
  /// Everything before `end`, which is taken too; nothing when the text ends first.
  std::optional<std::string_view> readUntil(char end) {
    const std::size_t first = next_;
    while (!atEnd() && text_[next_] != end) advance();
    if (atEnd()) return std::nullopt;
    const std::string_view content = text_.substr(first, next_ - first);
    advance();
    return content;
  }

  /// "…, but there is X": the character that stands where something else should, or the end of the text.
  [[nodiscard]] Error unexpected(const std::string& wanted) const {
    std::string found = "the annotation ends here";
    if (!atEnd()) {
      std::size_t length = 1;
      while (next_ + length < text_.size() && (static_cast<unsigned char>(text_[next_ + length]) & 0xC0U) == 0x80)
        ++length;
      found = "here is " + inQuotes(text_.substr(next_, length));
    }
    return Error{messageStart(place_) + wanted + ", but " + found + "."};
  }

  Result<AnnotationEntry> scanEntry() {
    AnnotationEntry entry;
    entry.namePlace = place_;
    entry.name = readWord();
    if (entry.name.empty()) return unexpected("a property such as scope=Window is expected");
    skipSpace();
    entry.valuePlace = place_;
    if (!take('=')) return entry;

    skipSpace();
    entry.valuePlace = place_;
    const char open = peek();
    if (open == '{' || open == '"') {
      advance();
      const char close = open == '{' ? '}' : '"';
      const auto content = readUntil(close);
      if (!content) return Error{messageStart(entry.valuePlace) + "this " + open + " has no closing " + close + "."};
      entry.kind = open == '{' ? AnnotationEntry::Kind::kBraces : AnnotationEntry::Kind::kString;
      entry.value = *content;
    } else {
      entry.kind = AnnotationEntry::Kind::kWord;
      entry.value = readWord();
      if (entry.value.empty()) return unexpected("after the = of " + inQuotes(entry.name) + " a value is expected");
    }
    return entry;
  }

  std::string_view text_;
  std::size_t next_ = 0;
  TextPlace place_;
};

}  // namespace

std::string messageStart(const TextPlace& place) {
  return "line " + std::to_string(place.line) + ", column " + std::to_string(place.column) + ": ";
}

Result<std::vector<AnnotationEntry>> scanAnnotation(std::string_view text) {
  return Scanner(text).scan();
}

}  // namespace dimline
