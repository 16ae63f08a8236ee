# Whole scenarios for many seeds.
set(slow "Lu2018.*:Simulation.NobodyDrivesThroughAnybody:Simulation.EveryScenarioHasFiniteReturns*")
