# For the scripts about simulators: drives that leave the store, and come back.

# go_out_and_in STORE SCENARIO [OPTION...]: every failing test of the store is exported as OpenSCENARIO and as a table, and the table
# is judged as the store's test is. The options are those of commands that run tests again.
go_out_and_in() {
  local store=$1 scenario=$2 rules=scenarios/assertions/crossing.yaml drives tables id stored
  shift 2
  command -v sqlite3 >/dev/null || return 0
  local failing=($(sqlite3 "$store" "SELECT id FROM tests WHERE met_precondition ORDER BY id"))
  [[ ${#failing[@]} -gt 2 ]] || fail "only ${#failing[@]} failing tests in $store"
  expect 0 jaywalk export "$store" --format openscenario --out "$store.drives" "$@"
  drives=($(grep -o '[^ ]*/[^ ]*-test-[0-9]*\.xosc' <<<"$output"))
  expect 0 jaywalk export "$store" --format trace --out "$store.tables" "$@"
  tables=($(grep -o '[^ ]*\.csv' <<<"$output"))
  [[ ${#drives[@]} == "${#failing[@]}" && ${#tables[@]} == "${#failing[@]}" ]] ||
    fail "${#drives[@]} drives and ${#tables[@]} tables of ${#failing[@]} failing tests"
  for id in "${!failing[@]}"; do
    expect 0 jaywalk judge "$store" --test "${failing[id]}" --metrics --assertions $rules "$@"
    stored=$output
    expect 0 jaywalk judge --trace "${tables[id]}" --metrics --assertions $rules --scenario "$scenario"
    [[ $output == "$stored" ]] || fail "the table is judged"$'\n'"$output"$'\n'"in the store"$'\n'"$stored"
  done
}
