#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_MUTATIONS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_MUTATIONS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <string>

// Damages files: the same seed gives the same damage on all machines.
class Mutator
{
public:
  explicit Mutator(std::uint64_t seed) : m_random(seed) {}

  // Returns the bytes after a few changes.
  std::string operator()(std::string bytes) {
    for (std::size_t n = 1 + below(4); n > 0 && !bytes.empty(); --n)
      change(bytes);
    return bytes;
  }

private:
  struct Range
  {
    std::size_t begin, size;
  };

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(m_random() % n); }

  Range any_range(const std::string& bytes) {
    const std::size_t begin = below(bytes.size());
    const std::size_t longest = below(8) == 0 ? bytes.size() : 32;
    return {begin, 1 + below((std::min)(longest, bytes.size() - begin))};
  }

  Range any_line(const std::string& bytes) {
    const std::size_t place = below(bytes.size()), before = bytes.rfind('\n', place),
                      begin = before == bytes.npos || before == place ? 0 : before + 1;
    return {begin, (std::min)(bytes.find('\n', begin), bytes.size() - 1) + 1 - begin};
  }

  // Returns the range of a sequence of digits, or any range if there are no digits.
  Range any_number(const std::string& bytes) {
    constexpr char digits[] = "0123456789";
    const std::size_t begin = bytes.find_first_of(digits, below(bytes.size()));
    if (begin == bytes.npos)
      return any_range(bytes);
    return {begin, (std::min)(bytes.find_first_not_of(digits, begin), bytes.size()) - begin};
  }

  std::string interesting_text() {
    static const char* const texts[] = {
        "0",          "1",          "-1",         "255",     "256",
        "65536",      "2147483647", "2147483648", "1000000", "4294967295",
        "4294967296", "999999999",  "1e999",      "1e-400",  "-1e308",
        "nan",        "inf",        "0.5",        "1e308",   "18446744073709551615",
        "x",          "",           "#",          "<a>",     "99999999999999999999"};
    return texts[below(std::size(texts))];
  }

  std::string interesting_bytes() {
    static const std::uint64_t numbers[] = {0,
                                            1,
                                            0x7f,
                                            0x80,
                                            0xff,
                                            0x7fff,
                                            0xffff,
                                            0x7fffffff,
                                            0x80000000,
                                            0xffffffff,
                                            0x7f800000,         // infinity in single precision
                                            0x7fc00000,         // NaN in single precision
                                            0x7ff0000000000000, // the same in double precision
                                            0x7ff8000000000000,
                                            0x7fffffffffffffff,
                                            0xffffffffffffffff};
    const std::uint64_t number = numbers[below(std::size(numbers))];
    std::string bytes;
    for (std::size_t i = 0, n = std::size_t{1} << below(4); i < n; ++i)
      bytes += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
    if (below(2) == 0)
      std::reverse(bytes.begin(), bytes.end());
    return bytes;
  }

  // Precondition: the sequence is not empty.
  void change(std::string& bytes) {
    const std::size_t place = below(bytes.size());
    const Range range = any_range(bytes), line = any_line(bytes), number = any_number(bytes);
    const std::string part = bytes.substr(range.begin, range.size),
                      text_of_line = bytes.substr(line.begin, line.size);
    switch (below(13)) {
    case 0:
      bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
      break;
    case 1:
      bytes[place] = static_cast<char>(static_cast<unsigned char>(below(256)));
      break;
    case 2: {
      const std::string other = interesting_bytes();
      bytes.replace(place, other.size(), other);
      break;
    }
    case 3:
      bytes.resize(place);
      break;
    case 4:
      bytes.erase(range.begin, range.size);
      break;
    case 5:
      bytes.insert(place, part);
      break;
    case 6:
      bytes.replace(place, part.size(), part);
      break;
    case 7:
      bytes.erase(line.begin, line.size);
      break;
    case 8:
      bytes.insert(any_line(bytes).begin, text_of_line);
      break;
    case 9: // to another position
      bytes.erase(line.begin, line.size);
      bytes.insert(bytes.empty() ? 0 : any_line(bytes).begin, text_of_line);
      break;
    case 10:
      bytes.replace(number.begin, number.size, interesting_text());
      break;
    case 11:
      bytes[number.begin] = static_cast<char>('0' + below(10));
      break;
    case 12: // often
      for (std::size_t n = below(1000); n > 0 && bytes.size() < longest_file; --n)
        bytes.insert(place, part);
      break;
    }
  }

  static constexpr std::size_t longest_file = 1 << 16; // bytes

  std::mt19937_64 m_random;
};

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_MUTATIONS_H
