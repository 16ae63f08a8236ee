// Connects as Foxglove does, subscribes to every channel, decodes what comes by the schemas that
// were advertised, and prints what was found: node foxglove_socket.mjs ws://localhost:PORT
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import protocol from "@foxglove/ws-protocol";  // CommonJS
import { WebSocket } from "ws";

const { FoxgloveClient } = protocol;
const [address, subprotocol = FoxgloveClient.SUPPORTED_SUBPROTOCOL] = process.argv.slice(2);
const client = new FoxgloveClient({ ws: new WebSocket(address, [subprotocol]) });
const readers = new Map();
const found = { messages: {}, times: 0 };
const end = (problem) => {
  if (problem) found.problem = String(problem);
  console.log(JSON.stringify(found));
  process.exit(problem ? 1 : 0);
};
setTimeout(() => end("nothing more came within 20 s"), 20000).unref();

client.on("error", end);
client.on("serverInfo", (info) => (found.server = info.name));
client.on("status", (status) => (found.status = status.message));
client.on("time", () => ++found.times);
client.on("advertise", (channels) => {
  for (const channel of channels) {
    const id = client.subscribe(channel.id);
    const reader = channel.encoding === "cdr"
      ? new MessageReader(parse(channel.schema, { ros2: true }))
      : { readMessage: (data) => JSON.parse(new TextDecoder().decode(data)) };
    readers.set(id, { channel, reader });
  }
});
client.on("message", ({ subscriptionId, timestamp, data }) => {
  try {
    const { channel, reader } = readers.get(subscriptionId);
    const message = reader.readMessage(data);
    const seen = (found.messages[channel.topic] ??= { type: channel.schemaName, count: 0 });
    ++seen.count;
    seen.stamped = timestamp > 0n;
    if (message.width !== undefined) seen.points = message.width;
    if (message.transforms) seen.frames = message.transforms.map((t) => t.child_frame_id);
    if (message.markers) seen.most = Math.max(seen.most ?? 0, message.markers.length);
    if (message.markers?.[1]) seen.box = message.markers[1].scale;
    if (message.status) seen.statuses = message.status.map((s) => s.name);
    const topics = Object.values(found.messages);
    if (topics.length === readers.size && topics.every((t) => t.count >= 5) && (seen.most ?? 2) > 1) end();
  } catch (error) {
    end(error);
  }
});
