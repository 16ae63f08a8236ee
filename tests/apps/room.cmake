# They run the tool on whole scenarios several times, or on a session of rendered images.
set(slow "RealRecordings.BagsOfPeople*:RealRecordings.CarmenLogs*:RealRoad.*:LearnClasses.WhatItWrites*:SameBytes.*:Turntable.FeaturesGive*:Turntable.RenderedImages*:Turntable.SameSeed*")
