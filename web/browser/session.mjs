// Starts the tool and a browser that looks at what it serves.
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";

import { chromium } from "playwright-core";

export const CHROMIUM = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find((p) => existsSync(p));

/** Runs `scanfuse view` and gives its address once it listens. */
export function startViewer(tool, args) {
  const child = spawn(tool, ["view", ...args, "--port", "0", "--no-browser"], { stdio: ["ignore", "pipe", "pipe"] });
  let errors = "";
  child.stderr.on("data", (bytes) => (errors += bytes));
  const address = new Promise((resolve, reject) => {
    let text = "";
    child.stdout.on("data", (bytes) => {
      text += bytes;
      if (text.includes("\n")) resolve(text.trim());
    });
    child.on("exit", (code) => reject(new Error(`scanfuse view ended with ${code}: ${errors}`)));
  });
  address.catch(() => {});
  const stop = () => new Promise((resolve) => {
    if (child.exitCode !== null) return resolve(child.exitCode);
    child.on("exit", resolve);
    child.kill("SIGINT");
  });
  return { child, address, stop, errors: () => errors };
}

export function openBrowser() {
  return chromium.launch({
    executablePath: CHROMIUM,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
}

/** A page that fails the test when it logs an error or breaks its own policy. */
export async function openPage(browser, address, viewport = { width: 1280, height: 720 }) {
  const page = await browser.newPage({ viewport });
  const problems = [];
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") problems.push(message.text());
  });
  await page.goto(address);
  return { page, problems };
}

/** Asks again and again: the page's policy forbids Playwright's own way of waiting. */
export async function waitUntil(page, what, says, argument, limitMs = 60000) {
  const end = Date.now() + limitMs;
  while (Date.now() < end) {
    if (await page.evaluate(what, argument)) return;
    await page.waitForTimeout(50);
  }
  throw new Error(`waited in vain until ${says}`);
}

/** Waits until the recording is read and its first frame is drawn. */
export function waitForData(page, frames = 1) {
  return waitUntil(page, (least) => {
    const app = window.scanfuse;
    return Boolean(app && app.player.count >= least && app.stage.panes[0].frame !== null);
  }, `${frames} frames were there`, frames);
}
