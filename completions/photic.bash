# bash completion of photic. The program itself lists what may come next: words, or "*.toml" for files of that name.
_photic() {
  local line word part words=()
  # bash takes words apart at '=' and ':'; the program gets them whole.
  for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    if [[ ${#words[@]} -gt 0 && ($word == [=:] || ${words[-1]} == *[=:]) ]]; then
      words[-1]+=$word
    else
      words+=("$word")
    fi
  done
  word=${words[-1]}
  part=${word##*[=:]}
  COMPREPLY=()
  while IFS= read -r line; do
    if [[ $line == \** ]]; then
      compopt -o filenames
      while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen -f -X "!$line" -- "$part"; compgen -d -- "$part")
    else
      line=${line%%$'\t'*}
      [[ $line != *= ]] || compopt -o nospace
      COMPREPLY+=("${line#"${word%"$part"}"}")
    fi
  done < <("${COMP_WORDS[0]}" complete -- "${words[@]}" 2>/dev/null)
}
complete -F _photic photic
