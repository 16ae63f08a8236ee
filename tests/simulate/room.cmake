# Whole scenarios for many seeds.
set(slow "SimulateDiscSweeps.EverySweep*:Lu2018.*:Simulation.NobodyDrivesThroughAnybody:Simulation.EveryScenarioHasFiniteReturns*")
