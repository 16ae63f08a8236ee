type Child = Node | string;
type Props = Record<string, string | boolean | number | ((event: Event) => void) | undefined>;

/** An element: `h("button", { class: "primary", onclick: ... }, "Play")`. */
export function h<K extends keyof HTMLElementTagNameMap>(
  name: K,
  props: Props = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(props)) {
    if (value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(key.replace(/^on/, ""), value);
    else element.setAttribute(key, value === true ? "" : String(value));
  }
  element.append(...children);
  return element;
}

/** A button that shows a sign and says in words what it does. */
export function button(sign: string, says: string, act: () => void, more: Props = {}): HTMLButtonElement {
  return h("button", { type: "button", title: says, "aria-label": says, onclick: act, ...more }, sign);
}

/** Replaces what an element holds. */
export function fill(element: HTMLElement, ...children: Child[]): void {
  element.replaceChildren(...children);
}

/** Gives the user a file. */
export function download(name: string, text: string, type: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  h("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** The name of the key of an option among <option>s. */
export function choice(
  values: readonly string[],
  selected: string,
  says: string,
  act: (value: string) => void,
): HTMLSelectElement {
  const select = h("select", { "aria-label": says, title: says });
  for (const value of values) {
    select.append(h("option", { value, selected: value === selected }, value));
  }
  select.addEventListener("change", () => act(select.value));
  return select;
}

export function clock(seconds: number): string {
  const s = Math.max(0, seconds);
  const whole = Math.floor(s / 60);
  const rest = (s - 60 * whole).toFixed(1).padStart(4, "0");
  return whole < 60
    ? `${whole}:${rest}`
    : `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}:${rest}`;
}
