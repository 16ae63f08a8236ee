# They run the tool on whole scenarios several times.
set(slow "SameBytes.*")
