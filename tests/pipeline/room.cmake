# Images of a whole session by others.
set(slow "RealStripes.*")
