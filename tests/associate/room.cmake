# CBC is the oracle of the packing solvers, where it is installed.
include(${PROJECT_SOURCE_DIR}/cmake/scanfuse_cbc.cmake)
scanfuse_link_cbc(associate_test)
# Thousands of instances, against an oracle or counted out.
set(slow "PackingOracle.*:PackingPosterior.MeansWhat*:PriceAndBranch.AnyNumber*")
