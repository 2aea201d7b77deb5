/// Variants assembled from lists of types.
#pragma once

#include <type_traits>
#include <variant>

namespace fccda {

namespace detail {

template <class Set, class T>
struct WithType;
template <class... Types, class T>
struct WithType<std::variant<Types...>, T> {
  using type = std::conditional_t<(std::is_same_v<Types, T> || ...), std::variant<Types...>, std::variant<Types..., T>>;
};

template <class Set, class... More>
struct Joined {
  using type = Set;
};
template <class Set, class T, class... More>
struct Joined<Set, T, More...> : Joined<typename WithType<Set, T>::type, More...> {};
template <class Set, class... Types, class... More>
struct Joined<Set, std::variant<Types...>, More...> : Joined<typename Joined<Set, Types...>::type, More...> {};

}  // namespace detail

/// Variant of all types named, and of the alternatives of all variants named, each once, in the order of their first mention.
template <class... Types>
using JoinedVariant = typename detail::Joined<std::variant<>, Types...>::type;

}  // namespace fccda
