// Drives the viewer as a person would, on a simulated recording and on those named besides, keeps
// pictures of what is seen, and measures how long drawing takes.
//   node web/browser/drive.mjs TOOL OUT-FOLDER [SHARED-DATA]
import { existsSync, mkdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { execFileSync } from "node:child_process";
import { join } from "node:path";

import { CHROMIUM, openBrowser, openPage, startViewer, waitForData, waitUntil } from "./session.mjs";

const [tool, out, shared = ""] = process.argv.slice(2);
if (!tool || !out) throw new Error("usage: drive.mjs TOOL OUT-FOLDER [SHARED-DATA]");
if (!CHROMIUM) {
  console.log("skipped: chromium is not installed");
  process.exit(0);
}
mkdirSync(out, { recursive: true });
let checks = 0;

function check(condition, says) {
  ++checks;
  if (!condition) throw new Error(`not so: ${says}`);
}

const frameShown = (page) => page.evaluate(() => window.scanfuse.player.frame);
const frameDrawn = (page) => page.evaluate(() => window.scanfuse.stage.panes[0].frame?.frame);
const picture = (page, name) => page.screenshot({ path: join(out, `${name}.png`) });

async function visit(browser, name, args, act, viewport) {
  const viewer = startViewer(tool, args);
  const { page, problems } = await openPage(browser, await viewer.address, viewport);
  try {
    await waitForData(page, 2);
    await waitUntil(page, () => document.querySelector(".note").textContent === "", "all was read");
    await act(page, viewer);
    check(problems.length === 0, `the page says nothing on its console: ${problems.join("; ")}`);
  } catch (error) {
    await picture(page, `${name}-failed`);
    throw error;
  } finally {
    await page.close();
    check((await viewer.stop()) === 0, "the viewer ends well");
  }
  console.log(`ok ${name}`);
}

async function goTo(page, frame) {
  await page.evaluate((f) => window.scanfuse.player.seek(f), frame);
  await waitUntil(page, (f) => window.scanfuse.stage.panes[0].frame?.frame === f, `frame ${frame} is drawn`, frame);
}

async function playAndScrub(page) {
  await page.keyboard.press("Space");
  await waitUntil(page, () => window.scanfuse.player.frame >= 5, "it plays");
  await page.keyboard.press("Space");
  const stopped = await frameShown(page);
  await page.keyboard.press("ArrowRight");
  check((await frameShown(page)) === stopped + 1, "the arrow steps on");
  const bar = await page.locator(".timeline").boundingBox();
  const count = await page.evaluate(() => window.scanfuse.player.count);
  for (const share of [0.9, 0.2, 0.6]) {
    await page.mouse.click(bar.x + 52 + share * (bar.width - 58), bar.y + bar.height / 2);
    const frame = await frameShown(page);
    check(Math.abs(frame / count - share) < 0.1, `a click on the timeline goes there: ${frame} of ${count}`);
    await waitUntil(page, (f) => window.scanfuse.stage.panes[0].frame?.frame === f, "that frame is drawn", frame);
  }
}

/** Clicks on a confirmed track in the scene and gives its number. */
async function selectInScene(page) {
  await page.keyboard.press("v");
  await page.waitForTimeout(200);
  const place = await page.evaluate(() => {
    const { stage } = window.scanfuse;
    const track = stage.panes[0].visibleTracks().find((one) => {
      const at = stage.placeOf(one.id);
      const box = document.querySelector(".stage").getBoundingClientRect();
      return at && at.x > box.left + 20 && at.x < box.right - 20 && at.y > box.top + 20 && at.y < box.bottom - 60;
    });
    return track ? { id: track.id, ...stage.placeOf(track.id) } : null;
  });
  check(place !== null, "a track is in view");
  await page.mouse.click(place.x, place.y);
  await waitUntil(page, (id) => window.scanfuse.settings.selected === id, `track ${place.id} is selected`, place.id);
  await waitUntil(page, () => document.querySelectorAll(".charts .uplot").length === 4, "its curves are there");
  await page.keyboard.press("v");
  return place.id;
}

async function tuneAndCompare(page) {
  await page.keyboard.press("2");
  await page.fill(".options input[type=search]", "coast_s");
  const field = page.locator('[data-key="track.coast_s"] input');
  await field.fill("99999");
  await field.press("Tab");
  check((await field.getAttribute("aria-invalid")) === "true", "a number out of range is refused");
  await field.fill("0.1");
  await field.press("Tab");
  await waitUntil(page, () => /^Done/.test(document.querySelector(".panel:not([hidden]) .state")?.textContent ?? ""), "the trial is done");
  await waitUntil(page, () => window.scanfuse.stage.panes[1].frame !== null, "the trial is drawn");
  await page.waitForTimeout(300);
}

async function exportConfiguration(page) {
  const [file] = await Promise.all([page.waitForEvent("download"), page.click("text=Export configuration")]);
  check(readFileSync(await file.path(), "utf8").includes("coast_s = 0.1"), "the export has the change");
  await page.click("text=End trial");
}

async function label(page, id) {
  await page.keyboard.press("3");
  await page.click("text=Accept track");
  await waitUntil(page, () => document.querySelectorAll("#panel-label .tracks button").length === 1, "an object is listed");
  await page.click("#panel-label .tracks button");
  await page.selectOption('#panel-label select[aria-label="Class"]', "cyclist");
  await waitUntil(page, () => document.querySelector("#panel-label .tracks button").textContent.includes("cyclist"), "the class is changed");
  await page.click("text=Split here");
  await waitUntil(page, () => document.querySelectorAll("#panel-label .tracks button").length === 2, "the object is split");
  await page.click("#panel-label >> text=Undo");
  await waitUntil(page, () => document.querySelectorAll("#panel-label .tracks button").length === 1, "the split is undone");
  await page.click("#panel-label .tracks button");
  await picture(page, "label");
  const [file] = await Promise.all([page.waitForEvent("download"), page.click("text=Save truth CSV")]);
  const rows = readFileSync(await file.path(), "utf8").trim().split("\n");
  check(rows[0].startsWith("frame,time_s,object_id,class,x_m,y_m"), "it is a truth CSV");
  check(rows.length > 10 && rows[1].split(",")[2] === String(id) && rows[1].split(",")[3] === "cyclist", "of that object");
}

async function simulated(browser) {
  const recording = join(out, "simulated.mcap");
  execFileSync(tool, ["simulate", "lu2018-2", "-o", recording, "--seed", "7", "--quiet"]);
  await visit(browser, "simulated", [recording], async (page) => {
    await playAndScrub(page);
    await goTo(page, 70);
    await picture(page, "start");
    const id = await selectInScene(page);
    await picture(page, "selected");
    await goTo(page, 1);
    await page.keyboard.press("]");
    const event = await frameShown(page);
    check(event > 1, "the next event lies ahead");
    await page.keyboard.press("]");
    await page.keyboard.press("[");
    check((await frameShown(page)) === event, "the event before lies behind");
    await goTo(page, 70);
    await tuneAndCompare(page);
    await picture(page, "compare");
    await exportConfiguration(page);
    await page.evaluate((track) => window.scanfuse.select(track), id);
    await label(page, id);
    await page.keyboard.press("h");
    await picture(page, "help");
    await page.keyboard.press("Escape");
    await page.keyboard.press("t");
    await picture(page, "light");
  });
  await visit(browser, "tablet", [recording], async (page) => {
    await goTo(page, 70);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(wide <= 820, "nothing stands out at the side of a tablet");
    await picture(page, "tablet");
  }, { width: 820, height: 1180 });
  rmSync(recording);
}

/** 100 000 returns in each of a few frames: what drawing costs without a graphics card. */
async function manyPoints(browser) {
  const file = join(out, "many.csv");
  execFileSync("/usr/bin/awk", ["-v", `file=${file}`, `BEGIN {
    print "frame,time_s,x_m,y_m,z_m,layer" > file;
    for (f = 0; f < 6; ++f) for (i = 0; i < 100000; ++i) { a = i * 0.0628318; r = 8 + (i % 64) * 0.5 + f * 0.1;
      printf "%d,%.1f,%.3f,%.3f,%.3f,%d\\n", f, f / 10, r * cos(a), r * sin(a), (i % 64) * 0.05 - 1.5, i % 64 > file; } }`]);
  await visit(browser, "100000 returns", [file], async (page) => {
    const times = [];
    for (let round = 0; round < 20; ++round) {
      await goTo(page, round % 6);
      times.push(await page.evaluate(() => {
        const app = window.scanfuse;
        const before = performance.now();
        app.refresh();
        app.stage.draw();
        const gl = document.querySelector(".stage canvas").getContext("webgl2");
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));  // waits for it
        return performance.now() - before;
      }));
    }
    times.sort((a, b) => a - b);
    const memory = await page.evaluate(() => performance.memory?.usedJSHeapSize ?? 0);
    console.log(`   a frame of 100 000 returns: median ${times[10].toFixed(1)} ms, worst ${times[19].toFixed(1)} ms in software; page holds ${(memory / 1e6).toFixed(0)} MB`);
    await picture(page, "many");
  });
  rmSync(file);
}

/** A turntable's rig and cloud, position by position. */
async function turntable(browser) {
  const session = join(out, "session");
  rmSync(session, { recursive: true, force: true });
  const rig = join(session, "rig.toml");
  execFileSync(tool, ["simulate", "turntable", "--features-only", "-o", session, "--seed", "3", "--quiet"]);
  execFileSync(tool, ["calibrate", "turntable", session, "-o", rig, "--quiet"]);
  await visit(browser, "turntable", [join(session, "scan"), "--rig", rig], async (page) => {
    await goTo(page, 60);
    const [parts, early] = await page.evaluate(() => {
      const frame = window.scanfuse.stage.panes[0].frame;
      return [new Set(frame.edges.map((edge) => edge.part)).size, frame.clusters.length];
    });
    check(parts === 3, "camera, axis and lidar are drawn");
    await page.keyboard.press("End");
    await page.waitForTimeout(500);
    const late = await page.evaluate(() => window.scanfuse.stage.panes[0].frame.clusters.length);
    check(late > 1.5 * early, "the cloud grows with the positions");
    await picture(page, "turntable");
  });
  rmSync(session, { recursive: true });
}

/** Watched for a while (VIEWER_MINUTES): how evenly it draws, and whether memory stays. */
async function longWatch(browser) {
  const minutes = Number(process.env.VIEWER_MINUTES ?? 0.25);
  const recording = join(out, "long.mcap");
  execFileSync(tool, ["simulate", "crossing", "-o", recording, "--seed", "7", "--quiet"]);
  await visit(browser, `watched for ${minutes} minutes`, [recording, "--preset", "road-users"], async (page) => {
    const client = await page.context().newCDPSession(page);
    const heapMb = async () => {
      await client.send("HeapProfiler.collectGarbage");
      return (await client.send("Runtime.getHeapUsage")).usedSize / 1e6;
    };
    await page.evaluate(() => {
      window.gaps = [];
      let last = performance.now();
      const tick = (now) => {
        window.gaps.push(now - last);
        last = now;
        requestAnimationFrame(tick);
      };
      requestAnimationFrame(tick);
    });
    const end = Date.now() + 60000 * minutes;
    let warm = 0;
    for (let round = 0; Date.now() < end; ++round) {
      const { playing, left } = await page.evaluate(() => {
        const { player } = window.scanfuse;
        return { playing: player.playing, left: player.count - 1 - player.frame };
      });
      if (left <= 0) await page.keyboard.press("Home");
      if (!playing) await page.keyboard.press("Space");
      if (round % 8 === 4) await page.keyboard.press("n");
      if (round % 40 === 20) await page.keyboard.press("v");
      await page.waitForTimeout(500);
      if (warm === 0 && Date.now() > end - 45000 * minutes) {
        warm = await heapMb();
        await page.evaluate(() => void (window.gaps.length = 0));
      }
    }
    const gaps = await page.evaluate(() => window.gaps.sort((a, b) => a - b));
    const heap = await heapMb();
    const at = (share) => gaps[Math.floor(share * (gaps.length - 1))].toFixed(0);
    console.log(`   between two drawings: median ${at(0.5)} ms, 99 % ${at(0.99)} ms, longest ${at(1)} ms in software; page held ${warm.toFixed(1)} MB, holds ${heap.toFixed(1)} MB`);
    check(heap < warm + 10, `memory stays: ${warm.toFixed(1)} MB, then ${heap.toFixed(1)} MB`);
  });
  rmSync(recording);
}

async function real(browser) {
  const data = (name) => join(shared, name);
  const sets = [
    ["datmo", data("datmo/overtake_ego.bag"), ["--preset", "vehicle-model", "--ego-topic", "/ego_pose", "--mount=-0.12,0,0", "--truth", data("datmo/overtake_ego.truth.csv")], 150],
    ["kitti", data("road/kitti_seq0000/scans_4layer.points.csv.xz"), ["--preset", "road-users", "--ego", data("road/kitti_seq0000/ego.csv"), "--truth", data("road/kitti_seq0000/truth_lidar_frame.csv"), "--truth-frame", "ego"], 60],
    ["people", data("people/positive_1.bag"), ["--preset", "road-users"], 200],
  ];
  for (const [name, file, args, frame] of sets) {
    if (shared === "" || !existsSync(file)) {
      console.log(`skipped ${name}: no shared data`);
      continue;
    }
    await visit(browser, name, [file, ...args], async (page) => {
      const last = await page.evaluate(() => window.scanfuse.player.count - 1);
      await goTo(page, Math.min(frame, last));
      await page.waitForTimeout(300);
      await picture(page, name);
      await page.keyboard.press("v");
      await page.keyboard.press("n");
      await page.waitForTimeout(500);
      await picture(page, `${name}-top`);
      check((await frameDrawn(page)) === Math.min(frame, last), "that frame is drawn");
    });
  }
}

const browser = await openBrowser();
try {
  await simulated(browser);
  await manyPoints(browser);
  await turntable(browser);
  await longWatch(browser);
  await real(browser);
} finally {
  await browser.close();
}
check(statSync(join(out, "start.png")).size > 10000, "pictures are kept");
console.log(`${checks} checks passed`);
