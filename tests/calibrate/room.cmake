# Many placements of a disc, many seeds of a session.
set(slow "MeasureDisc.TenPlacements*:MeasureDisc.AWideSpot*:CalibrateTurntable.Joint*")
