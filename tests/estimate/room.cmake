# Thousands of runs each, so that their bands are narrow.
set(slow "ExtendedKalman.NeesAndNis*:Imm.NeesLies*")
