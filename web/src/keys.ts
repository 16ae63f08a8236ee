/** Every key, once: the help sheet and docs/viewer.md list what stands here. */
export interface Command {
  keys: string[];
  says: string;
  act: () => void;
}

export function listenForKeys(commands: Command[]): void {
  const byKey = new Map<string, Command>();
  for (const command of commands) for (const key of command.keys) byKey.set(key, command);
  window.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement | null;
    if (document.querySelector("dialog[open]")) return; // the sheet has its own keys
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (target && /^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName)) return;
    // A button takes the space bar and the return key for itself.
    if (target?.tagName === "BUTTON" && (event.key === " " || event.key === "Enter")) return;
    const command = byKey.get(event.key.length === 1 ? event.key.toLowerCase() : event.key);
    if (!command) return;
    event.preventDefault();
    command.act();
  });
}

const NAMES: Record<string, string> = {
  " ": "space", ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down",
};

export function nameOfKey(key: string): string {
  return NAMES[key] ?? key;
}
