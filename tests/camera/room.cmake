# Sessions rendered and searched; under sanitizers three of them will do.
set(slow "Session/Rendered.*/Mosaic*:Session/Rendered.*/Faint*:Session/Rendered.*/Saturated*:Session/Rendered.*/LitUnevenly*:Session/Rendered.*/Bright*")
