import type { Asked, Told } from "./messages";
import { type Binary, decode, PROTOCOL } from "./protocol";
import { Signal } from "./signal";

export type Link = "connecting" | "open" | "lost";

/** The websocket; connects again, with growing pauses, when it is lost. */
export class Connection {
  readonly told = new Signal<Told>();
  readonly binary = new Signal<Binary>();
  readonly link = new Signal<Link>();
  private socket: WebSocket | null = null;
  private pause = 250;

  connect(): void {
    this.link.emit("connecting");
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/ws${location.search}`, PROTOCOL);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.pause = 250;
      this.link.emit("open");
    };
    socket.onmessage = (event: MessageEvent<ArrayBuffer | string>) => this.receive(event.data);
    socket.onclose = () => {
      this.socket = null;
      this.link.emit("lost");
      setTimeout(() => this.connect(), this.pause);
      this.pause = Math.min(2 * this.pause, 5000);
    };
    this.socket = socket;
  }

  ask(request: Asked): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(request));
  }

  private receive(data: ArrayBuffer | string): void {
    if (typeof data === "string") this.told.emit(JSON.parse(data) as Told);
    else this.binary.emit(decode(data));
  }
}
