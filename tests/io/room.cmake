# The builders of test files compress by themselves.
target_link_libraries(io_test PRIVATE bz2 lz4 zstd z sqlite3 lzma)
