#!/usr/bin/env bash
# complete.bash SCRIPT WORD...: what bash offers for the last word, one a line, with the completions of SCRIPT.
# bash hands words to a completion cut at "=", which it does here for what begins with "--".
set -u
source "$1"
shift
COMP_WORDS=()
for word in "$@"; do
  if [[ $word == --*=* ]]; then
    COMP_WORDS+=("${word%%=*}" =)
    word=${word#*=}
    if [[ -z $word && ${#COMP_WORDS[@]} -gt 0 ]]; then continue; fi
  fi
  COMP_WORDS+=("$word")
done
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
read -r _ _ function _ <<< "$(complete -p "$1")"  # complete -F _marketgen marketgen
"$function" "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
if ((${#COMPREPLY[@]})); then printf '%s\n' "${COMPREPLY[@]}"; fi
