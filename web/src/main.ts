import "uplot/dist/uPlot.min.css";
import "./style.css";

import { App } from "./app";

declare global {
  interface Window {
    /** For the browser test and the console. */
    scanfuse?: App;
  }
}

window.scanfuse = new App(document.getElementById("app") ?? document.body);
window.scanfuse.start();
