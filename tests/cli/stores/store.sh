# For the scripts about stores: what is compared, and how.

# results CSV: its columns but for the times.
results() {
  cut -d, -f1-19,22 "$1"
}

# content STORE: every row in the order of its id, but for the times that tests took; needs sqlite3.
content() {
  local table
  for table in experiment options behaviours parameters agent_numbers vehicles inputs versions actors observations \
    events drops assessments gpkg_spatial_ref_sys gpkg_geometry_columns; do
    echo "$table"
    sqlite3 "file:$1?mode=ro" "SELECT * FROM $table ORDER BY 1" | od -c | sha256sum
  done
  echo tests
  sqlite3 "file:$1?mode=ro" "SELECT id, behaviour, agents, vehicle, number, seed, met_precondition, ticks, score,
    scenes FROM tests ORDER BY id"
  sqlite3 "file:$1?mode=ro" "SELECT hex(geom) FROM observations ORDER BY id" | sha256sum
  sqlite3 "file:$1?mode=ro" "SELECT table_name, data_type, min_x, min_y, max_x, max_y FROM gpkg_contents
    ORDER BY 1"
  sqlite3 "file:$1?mode=ro" "SELECT type, name, sql FROM sqlite_master ORDER BY name"
}

# same_content A B: two stores hold the same, if sqlite3 is there to see it.
same_content() {
  command -v sqlite3 >/dev/null || return 0
  diff <(content "$1") <(content "$2") >/dev/null ||
    fail "$1 and $2 differ: $(diff <(content "$1") <(content "$2") | head -5)"
}
