import type { App } from "./app";
import { SPEEDS } from "./controls";
import type { Command } from "./keys";
import { COLOUR_BY, type Shown } from "./settings";

/** What the keys do. */
export function commandsOf(app: App): Command[] {
  const { player, settings, stage } = app;
  const faster = (by: 1 | -1) => {
    const at = SPEEDS.indexOf(player.speed);
    player.setSpeed(SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, at + by))] ?? 1);
  };
  const flip = (name: Shown) => settings.change((s) => (s.shown[name] = !s.shown[name]));
  return [
    { keys: [" "], says: "play or pause", act: () => player.toggle() },
    { keys: ["ArrowLeft", ","], says: "a frame back", act: () => player.step(-1) },
    { keys: ["ArrowRight", "."], says: "a frame on", act: () => player.step(1) },
    { keys: ["PageUp"], says: "fifty frames back", act: () => player.step(-50) },
    { keys: ["PageDown"], says: "fifty frames on", act: () => player.step(50) },
    { keys: ["Home"], says: "to the start", act: () => player.step(-Infinity) },
    { keys: ["End"], says: "to the end", act: () => player.step(Infinity) },
    { keys: ["-"], says: "slower", act: () => faster(-1) },
    { keys: ["+", "="], says: "faster", act: () => faster(1) },
    { keys: ["["], says: "to the event before, and select its track", act: () => app.jump(-1) },
    { keys: ["]"], says: "to the event after, and select its track", act: () => app.jump(1) },
    { keys: ["n"], says: "select the next track", act: () => app.cycle(1) },
    { keys: ["p"], says: "select the track before", act: () => app.cycle(-1) },
    { keys: ["Escape"], says: "deselect", act: () => app.select(null) },
    { keys: ["v"], says: "top view or in space", act: () => settings.change((s) => (s.view = s.view === "top" ? "3d" : "top")) },
    { keys: ["0"], says: "fit the view", act: () => stage.fit() },
    { keys: ["f"], says: "follow the vehicle or the track", act: () => settings.change((s) => (s.follow = !s.follow)) },
    {
      keys: ["c"],
      says: "next colouring of the returns",
      act: () =>
        settings.change((s) => (s.colourBy = COLOUR_BY[(COLOUR_BY.indexOf(s.colourBy) + 1) % COLOUR_BY.length] ?? "segment")),
    },
    { keys: ["e"], says: "ellipses on or off", act: () => flip("covariance") },
    { keys: ["o"], says: "outlines on or off", act: () => flip("outlines") },
    { keys: ["d"], says: "detections on or off", act: () => flip("detections") },
    { keys: ["g"], says: "truth on or off", act: () => flip("truth") },
    { keys: ["a"], says: "accept the selected track as a label", act: () => app.label.accept() },
    { keys: ["1"], says: "track", act: () => app.tabs.open("Track") },
    { keys: ["2"], says: "tune", act: () => app.tabs.open("Tune") },
    { keys: ["3"], says: "label", act: () => app.tabs.open("Label") },
    { keys: ["4"], says: "about the recording", act: () => app.tabs.open("Info") },
    { keys: ["t"], says: "dark or light", act: () => settings.change((s) => (s.theme = s.theme === "dark" ? "light" : "dark")) },
    { keys: ["h", "?"], says: "this sheet", act: () => app.help.showModal() },
  ];
}
