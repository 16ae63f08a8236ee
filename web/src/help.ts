import { h } from "./dom";
import { type Command, nameOfKey } from "./keys";

const SIGNS: [string, string][] = [
  ["box", "a track; its front is crossed, the line ahead is where it will be in one second"],
  ["pale box", "nothing is seen of it: it coasts, or is new"],
  ["dashed box", "truth"],
  ["arrow of four corners", "the vehicle that carries the sensor"],
  ["triangle on the timeline", "birth: a track is confirmed"],
  ["dash on the timeline", "coast: its object is out of sight"],
  ["cross on the timeline", "loss: it is given up"],
  ["ring on the timeline", "switch: another track follows the same object (needs truth)"],
];

/** The sheet behind the question mark. */
export function helpSheet(commands: Command[]): HTMLDialogElement {
  const keys = h("dl", { class: "facts" });
  for (const command of commands) {
    keys.append(
      h("dt", {}, ...command.keys.flatMap((key, i) => [i > 0 ? " " : "", h("kbd", {}, nameOfKey(key))])),
      h("dd", {}, command.says));
  }
  const signs = h("dl", { class: "facts" });
  for (const [sign, meaning] of SIGNS) signs.append(h("dt", {}, sign), h("dd", {}, meaning));
  const close = h("button", { type: "button", class: "primary", onclick: () => sheet.close() }, "Close");
  const sheet: HTMLDialogElement = h("dialog", { class: "help", "aria-label": "Help" },
    close, h("h2", {}, "What is what"), signs,
    h("h2", {}, "Mouse and touch"),
    h("p", {}, "Drag turns the view, right drag (two fingers) moves it, the wheel zooms. In the top view a drag moves. A click selects a track."),
    h("h2", {}, "Keys"), keys);
  sheet.addEventListener("click", (event) => {
    if (event.target === sheet) sheet.close();
  });
  return sheet;
}
