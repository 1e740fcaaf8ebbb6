#!/usr/bin/env -S fish --no-config
# complete.fish SCRIPT WORD...: what fish offers for the last word, one a line, with the completions of SCRIPT.
source $argv[1]
complete -C "$argv[2..]" | string replace -r '\t.*' ''
