#!/usr/bin/env -S zsh -f
# complete.zsh SCRIPT WORD...: what zsh offers for the last word, one a line, with the completions of SCRIPT.
# Completion runs in the line editor alone: a second zsh has a terminal of its own, in which the words are typed and a tab, and
# what its completion adds is printed between two marks.
zmodload zsh/zpty
script=$1
shift
inner=$(mktemp)
trap 'rm -f $inner' EXIT
cat > $inner <<'INNER'
PROMPT=
autoload -Uz compinit
compinit -u -C -d $dump
bindkey '^I' complete-word
zstyle ':completion:*' insert-tab false
zstyle ':completion:*' verbose false
compprefuncs=( begin-mark )
comppostfuncs=( end-mark )
begin-mark() { print -r -- '<<<'; }
end-mark() { print -r -- '>>>'; exit; }
compadd() {
  local -a hits
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then builtin compadd "$@"; return; fi  # asks, and adds nothing
  builtin compadd -A hits "$@"
  if (( $#hits )); then print -rl -- $IPREFIX$^hits; fi
  builtin compadd "$@"
}
INNER
zpty terminal zsh -f -i
zpty -w terminal "dump=${(q)script}.dump; source $inner; source ${(q)script}; print ready"
while zpty -r terminal line; do [[ $line == ready* ]] && break; done
zpty -n -w terminal "${(j: :)@}"$'\t'
inside=
while zpty -r terminal line; do
  line=${line%$'\r\n'}
  case $line in
    *'<<<') inside=1 ;;
    *'>>>') break ;;
    *) [[ -n $inside ]] && print -r -- $line ;;
  esac
done
zpty -d terminal
