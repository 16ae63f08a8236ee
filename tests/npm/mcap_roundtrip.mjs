// Foxglove's own packages against our MCAP files.
//
//   node mcap_roundtrip.mjs read FILE.mcap           prints what they find in a file of ours
//   node mcap_roundtrip.mjs write FILE.mcap none|zstd   writes a file for us to read
import { readFile, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { McapIndexedReader, McapStreamReader, McapWriter } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";

const require = createRequire(import.meta.url);
const zstd = require("@foxglove/wasm-zstd");
const decompressLz4 = require("@foxglove/wasm-lz4");
await zstd.isLoaded;
await decompressLz4.isLoaded;

const decompressHandlers = {
  zstd: (data, size) => zstd.decompress(data, Number(size)),
  lz4: (data, size) => decompressLz4(data, Number(size)),
};

class BufferReadable {
  constructor(bytes) {
    this.bytes = bytes;
  }
  async size() {
    return BigInt(this.bytes.byteLength);
  }
  async read(offset, length) {
    return this.bytes.subarray(Number(offset), Number(offset + length));
  }
}

class BufferWritable {
  parts = [];
  length = 0;
  async write(bytes) {
    this.parts.push(bytes.slice());
    this.length += bytes.byteLength;
  }
  position() {
    return BigInt(this.length);
  }
}

/** Messages found front to back, every checksum verified. */
function countStreamed(bytes) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(bytes);
  let messages = 0;
  for (let record; (record = reader.nextRecord()) != undefined; ) {
    messages += record.type === "Message" ? 1 : 0;
  }
  if (!reader.done()) throw new Error("the file has no proper end");
  return messages;
}

function decoderOf(schema, channel) {
  const text = new TextDecoder().decode(schema.data);
  if (channel.messageEncoding === "cdr") {
    const reader = new MessageReader(parse(text, { ros2: true }));
    return (data) => reader.readMessage(data);
  }
  JSON.parse(text);
  return (data) => JSON.parse(new TextDecoder().decode(data));
}

/** One decoded message in a form that JSON can hold. */
function plain(message) {
  return JSON.parse(
    JSON.stringify(message, (_, value) => {
      if (typeof value === "bigint") return value.toString();
      return ArrayBuffer.isView(value) ? Array.from(value) : value;
    }),
  );
}

async function read(path) {
  const bytes = new Uint8Array(await readFile(path));
  const reader = await McapIndexedReader.Initialize({
    readable: new BufferReadable(bytes),
    decompressHandlers,
  });
  const decoders = new Map();
  const topics = {};
  let messages = 0;
  let last = -1n;
  for await (const message of reader.readMessages()) {
    if (message.logTime < last) throw new Error("log time goes back");
    last = message.logTime;
    ++messages;
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    if (!decoders.has(channel.id)) decoders.set(channel.id, decoderOf(schema, channel));
    const decoded = decoders.get(channel.id)(message.data);
    topics[channel.topic] ??= { type: schema.name, messages: 0, first: plain(decoded) };
    ++topics[channel.topic].messages;
  }
  const counted = Number(reader.statistics?.messageCount ?? -1);
  console.log(JSON.stringify({ messages, streamed: countStreamed(bytes), counted, topics }));
}

const laserScanText = `std_msgs/Header header
float32 angle_min
float32 angle_max
float32 angle_increment
float32 time_increment
float32 scan_time
float32 range_min
float32 range_max
float32[] ranges
float32[] intensities
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
`;

function laserScan(i) {
  return {
    header: { stamp: { sec: 1000 + i, nanosec: 500 }, frame_id: "laser" },
    angle_min: -0.5,
    angle_max: 0.5,
    angle_increment: 0.25,
    time_increment: 0,
    scan_time: 0.1,
    range_min: 0.1,
    range_max: 30,
    ranges: [1 + i, 2, Infinity, NaN, 3],
    intensities: [],
  };
}

async function write(path, compression) {
  const writable = new BufferWritable();
  const writer = new McapWriter({
    writable,
    chunkSize: 1000,
    compressChunk:
      compression === "zstd"
        ? (data) => ({ compression: "zstd", compressedData: zstd.compress(data) })
        : undefined,
  });
  await writer.start({ profile: "ros2", library: "mcap_roundtrip.mjs" });
  const encoder = new MessageWriter(parse(laserScanText, { ros2: true }));
  const schemaId = await writer.registerSchema({
    name: "sensor_msgs/msg/LaserScan",
    encoding: "ros2msg",
    data: new TextEncoder().encode(laserScanText),
  });
  const channelId = await writer.registerChannel({
    schemaId,
    topic: "/scan",
    messageEncoding: "cdr",
    metadata: new Map(),
  });
  for (let i = 0; i < 25; ++i) {
    const time = BigInt(1000 + i) * 1_000_000_000n;
    const data = encoder.writeMessage(laserScan(i));
    await writer.addMessage({ channelId, sequence: i, logTime: time, publishTime: time, data });
  }
  await writer.end();
  await writeFile(path, Buffer.concat(writable.parts));
}

const [command, path, compression] = process.argv.slice(2);
if (command === "read") await read(path);
else if (command === "write") await write(path, compression);
else throw new Error("usage: node mcap_roundtrip.mjs read|write FILE [none|zstd]");
