// Stands for orlp/pdqsort, which is not on PyPI: the same calls by std::sort.
#pragma once
#include <algorithm>

template <class Iterator, class... Less>
void pdqsort(Iterator first, Iterator last, Less... less) {
  std::sort(first, last, less...);
}
template <class Iterator, class... Less>
void pdqsort_branchless(Iterator first, Iterator last, Less... less) {
  std::sort(first, last, less...);
}
