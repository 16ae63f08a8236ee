# Many placements of a disc, many seeds of a session.
set(slow "MeasurePlane.DistanceAnd*:MeasureDisc.TenPlacements*:MeasureDisc.AWideSpot*:CalibrateTurntable.Joint*")
