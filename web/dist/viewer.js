const dp="scanfuse.viewer.v1";const pp=["camera","axis","lidar","board"],Da=["birth","coast","loss","switch"];class mp{constructor(t){this.bytes=t,this.view=new DataView(t)}offset=0;view;u32(){return this.offset+=4,this.view.getUint32(this.offset-4,!0)}i32(){return this.offset+=4,this.view.getInt32(this.offset-4,!0)}f32(){return this.offset+=4,this.view.getFloat32(this.offset-4,!0)}f64(){return this.offset+=8,this.view.getFloat64(this.offset-8,!0)}array(t,e){const n=new t(this.bytes,this.offset,e);return this.offset+=e*t.BYTES_PER_ELEMENT,this.offset=this.offset+3&-4,n}run(){return this.u32()===1?1:0}}function di(i,t){const e=[];for(let n=0;n<i;++n)e.push(t());return e}function dh(i){return{x:i.f32(),y:i.f32(),z:i.f32(),heading:i.f32()}}function Sc(i){return{x:i.f32(),y:i.f32(),z:i.f32(),heading:i.f32(),length:i.f32(),width:i.f32(),height:i.f32()}}function gp(i){const t=Sc(i),e=[i.f32(),i.f32(),i.f32()],n=i.f32(),s=i.u32();return{...t,covariance:e,score:n,class:s&255,points:s>>>8}}function Ef(i){const t=i.f64(),e=Sc(i),n={vx:i.f32(),vy:i.f32(),covariance:[i.f32(),i.f32(),i.f32()],speed:i.f32(),accel:i.f32(),yawRate:i.f32(),classProbability:i.f32(),movingProbability:i.f32(),nis:i.f32(),detection:i.i32(),age:i.u32(),missed:i.u32()},s=i.u32();return{id:t,...e,...n,class:s&255,status:s>>>8&255}}function _p(i,t){const e=i.run(),n=i.u32(),[s,r,o,a,l,c,h]=di(7,()=>i.u32());if(s*16>t.byteLength)throw new RangeError("a frame that is cut off");const u={time:i.f64(),number:i.f64(),sensorPose:dh(i),egoPose:dh(i),intensityLow:i.f32(),intensityHigh:i.f32(),sensor:i.u32()},f=i.u32();return{kind:"frame",run:e,frame:n,...u,positions:i.array(Float32Array,3*s),clusters:i.array(Uint16Array,s),layers:i.array(Uint8Array,s),intensities:i.array(Uint8Array,s),detectionOfCluster:i.array(Int32Array,r),lines:di(o,()=>({x0:i.f32(),y0:i.f32(),x1:i.f32(),y1:i.f32(),cluster:i.u32()})),detections:di(a,()=>gp(i)),tracks:di(l,()=>Ef(i)),rays:di(h,()=>({from:[i.f32(),i.f32(),i.f32()],to:[i.f32(),i.f32(),i.f32()],sensor:i.u32(),target:i.i32()})),edges:di(f,()=>({from:[i.f32(),i.f32(),i.f32()],to:[i.f32(),i.f32(),i.f32()],part:i.u32()})),truth:di(c,()=>({id:i.f64(),...Sc(i),class:i.u32()}))}}function vp(i){const t=i.run(),e=i.u32();i.u32();const n=i.f64(),s=di(e,()=>{const r=i.f64(),o=i.u32();return i.u32(),{time:r,frame:o,...Ef(i)}});return{kind:"history",run:t,track:n,samples:s}}function xp(i){const t=new mp(i),e=t.u32();switch(e){case 1:return _p(t,i);case 2:{const n=t.run(),s=t.u32();return{kind:"index",run:n,from:s,times:t.array(Float64Array,t.u32())}}case 3:{const n=t.run(),s=t.u32(),r=di(t.u32(),()=>({track:t.f64(),frame:t.u32(),kind:t.u32()}));return{kind:"events",run:n,from:s,events:r}}case 4:return vp(t);case 5:{const n=t.run(),s=di(t.u32(),()=>({frame:t.u32(),id:t.f64(),x:t.f32(),y:t.f32()}));return{kind:"trails",run:n,points:s}}default:throw new Error(`unknown message kind ${e}`)}}class Ui{listeners=[];on(t){this.listeners.push(t)}emit(t){for(const e of this.listeners)e(t)}}class Mp{told=new Ui;binary=new Ui;link=new Ui;socket=null;pause=250;connect(){this.link.emit("connecting");const t=location.protocol==="https:"?"wss":"ws",e=new WebSocket(`${t}://${location.host}/ws${location.search}`,dp);e.binaryType="arraybuffer",e.onopen=()=>{this.pause=250,this.link.emit("open")},e.onmessage=n=>this.receive(n.data),e.onclose=()=>{this.socket=null,this.link.emit("lost"),setTimeout(()=>this.connect(),this.pause),this.pause=Math.min(2*this.pause,5e3)},this.socket=e}ask(t){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(t))}receive(t){typeof t=="string"?this.told.emit(JSON.parse(t)):this.binary.emit(xp(t))}}function nt(i,t={},...e){const n=document.createElement(i);for(const[s,r]of Object.entries(t))r===void 0||r===!1||(typeof r=="function"?n.addEventListener(s.replace(/^on/,""),r):n.setAttribute(s,r===!0?"":String(r)));return n.append(...e),n}function mi(i,t,e,n={}){return nt("button",{type:"button",title:t,"aria-label":t,onclick:e,...n},i)}function vn(i,...t){i.replaceChildren(...t)}function bf(i,t,e){const n=URL.createObjectURL(new Blob([t],{type:e}));nt("a",{href:n,download:i}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}function Zr(i,t,e,n){const s=nt("select",{"aria-label":e,title:e});for(const r of i)s.append(nt("option",{value:r,selected:r===t},r));return s.addEventListener("change",()=>n(s.value)),s}function Ts(i){const t=Math.max(0,i),e=Math.floor(t/60),n=(t-60*e).toFixed(1).padStart(4,"0");return e<60?`${e}:${n}`:`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")}:${n}`}const $r=["segment","class","intensity","layer","age","height"],Tf=[["points","Returns"],["outlines","Outlines"],["boxes","Tracks"],["ids","Names"],["trails","Trails"],["covariance","95 % ellipses"],["detections","Detections"],["truth","Truth"],["sight","Sensor and lines of sight"],["tentative","Tentative tracks"]];class Sp{constructor(t){this.storage=t,this.load()}changed=new Ui;view="3d";colourBy="segment";theme="dark";follow=!0;scansKept=1;pointSize=3;selected=null;compare=!1;shown={points:!0,outlines:!0,boxes:!0,ids:!0,trails:!0,covariance:!1,detections:!1,truth:!0,sight:!1,tentative:!1};change(t){t(this),this.save(),this.changed.emit()}load(){try{const t=JSON.parse(this.storage?.getItem("scanfuse")??"{}");(t.view==="top"||t.view==="3d")&&(this.view=t.view),t.colourBy&&$r.includes(t.colourBy)&&(this.colourBy=t.colourBy),(t.theme==="dark"||t.theme==="light")&&(this.theme=t.theme);for(const[e]of Tf){const n=t.shown?.[e];typeof n=="boolean"&&(this.shown[e]=n)}}catch{}}save(){const{view:t,colourBy:e,theme:n,shown:s}=this;try{this.storage?.setItem("scanfuse",JSON.stringify({view:t,colourBy:e,theme:n,shown:s}))}catch{}}}const Yo=[.1,.25,.5,1,2,4,8];class yp{constructor(t,e){this.player=t,this.play=mi("▶","Play (space)",()=>t.toggle(),{class:"primary play"}),this.speed=Zr(Yo.map(n=>`${n} x`),"1 x","Speed",n=>t.setSpeed(parseFloat(n))),this.element.append(mi("‹ event","Event before ([)",()=>e(-1)),mi("-1","Frame back (left)",()=>t.step(-1)),this.play,mi("+1","Frame on (right)",()=>t.step(1)),mi("event ›","Event after (])",()=>e(1)),this.speed,this.time),t.changed.on(()=>this.draw()),t.moved.on(()=>this.draw()),this.draw()}element=nt("div",{class:"transport"});play;time=nt("output",{class:"time"});speed;draw(){const{playing:t,time:e,duration:n,frame:s,count:r,speed:o}=this.player;this.play.textContent=t?"❚❚":"▶",this.play.setAttribute("aria-label",t?"Pause (space)":"Play (space)"),this.play.title=t?"Pause (space)":"Play (space)",this.speed.value=`${o} x`,this.time.textContent=`${Ts(e)} / ${Ts(n)}   frame ${Math.min(s+1,r)} of ${r}`}}class Ep{constructor(t,e,n){this.settings=t,this.view=mi("Top view","Top view or in space (v)",()=>t.change(s=>s.view=s.view==="top"?"3d":"top")),this.colour=Zr($r,t.colourBy,"Colour of the returns (c)",s=>t.change(r=>r.colourBy=s)),this.follow=mi("Follow","Move along with the vehicle or the selected track (f)",()=>t.change(s=>s.follow=!s.follow)),this.element.append(this.title,this.note,this.view,nt("label",{class:"inline"},"Colour by",this.colour),this.layers(),this.follow,mi("Fit","Look at everything, or at the selected track (0)",n),mi("◐","Dark or light (t)",()=>t.change(s=>s.theme=s.theme==="dark"?"light":"dark")),mi("?","Help (h)",e)),t.changed.on(()=>this.draw()),this.draw()}element=nt("header",{class:"topbar"});title=nt("strong",{class:"title"});note=nt("span",{class:"note",role:"status"});view;colour;follow;setTitle(t){this.title.textContent=t,document.title=`${t} - scanfuse`}setNote(t,e=!1){this.note.textContent=t,this.note.classList.toggle("warning",e)}layers(){const t=nt("div",{class:"menu"});for(const[s,r]of Tf){const o=nt("input",{type:"checkbox",checked:this.settings.shown[s]});o.addEventListener("change",()=>this.settings.change(a=>a.shown[s]=o.checked)),this.settings.changed.on(()=>o.checked=this.settings.shown[s]),t.append(nt("label",{},o,r))}const e=nt("input",{type:"range",min:"1",max:"30",value:"1","aria-label":"Scans kept"});e.addEventListener("input",()=>this.settings.change(s=>s.scansKept=Number(e.value)));const n=nt("input",{type:"range",min:"1",max:"8",value:String(this.settings.pointSize),"aria-label":"Size of returns"});return n.addEventListener("input",()=>this.settings.change(s=>s.pointSize=Number(n.value))),t.append(nt("label",{},"Scans kept",e),nt("label",{},"Size of returns",n)),nt("details",{class:"layers"},nt("summary",{},"Show"),t)}draw(){const{view:t,colourBy:e,follow:n}=this.settings;this.view.textContent=t==="top"?"In space":"Top view",this.colour.value=e,this.follow.setAttribute("aria-pressed",String(n))}}class bp{constructor(t,e=2e8,n=4){this.ask=t,this.mostBytes=e,this.mostAsked=n}arrived=new Ui;frames=new Map;asked=new Map;bytes=0;get(t,e){const n=`${t}:${e}`,s=this.frames.get(n);return s&&(this.frames.delete(n),this.frames.set(n,s)),s}want(t,e,n=!1,s=Date.now()){const r=`${t}:${e}`;if(this.frames.has(r))return!0;for(const[o,a]of this.asked)s-a>5e3&&this.asked.delete(o);return this.asked.has(r)||this.asked.size>=this.mostAsked+(n?2:0)||(this.asked.set(r,s),this.ask({op:"frame",run:t,frame:e})),!1}add(t){const e=`${t.run}:${t.frame}`;this.asked.delete(e);const n=this.frames.get(e);n&&(this.bytes-=po(n)),this.frames.delete(e),this.frames.set(e,t),this.bytes+=po(t);for(const[s,r]of this.frames){if(this.bytes<=this.mostBytes||s===e)break;this.frames.delete(s),this.bytes-=po(r)}this.arrived.emit(t)}missing(t,e){this.asked.delete(`${t}:${e}`)}forget(t){for(const[e,n]of this.frames)t!==void 0&&n.run!==t||(this.frames.delete(e),this.bytes-=po(n));for(const e of this.asked.keys())(t===void 0||e.startsWith(`${t}:`))&&this.asked.delete(e)}get bytesHeld(){return this.bytes}}function po(i){return i.positions.buffer.byteLength+200*(i.tracks.length+i.lines.length)}function Tp(i){const t=new Map;for(const e of i)for(const n of e.keys)t.set(n,e);window.addEventListener("keydown",e=>{const n=e.target;if(document.querySelector("dialog[open]")||e.ctrlKey||e.metaKey||e.altKey||n&&/^(INPUT|SELECT|TEXTAREA)$/.test(n.tagName)||n?.tagName==="BUTTON"&&(e.key===" "||e.key==="Enter"))return;const s=t.get(e.key.length===1?e.key.toLowerCase():e.key);s&&(e.preventDefault(),s.act())})}const wp={" ":"space",ArrowLeft:"left",ArrowRight:"right",ArrowUp:"up",ArrowDown:"down"};function Ap(i){return wp[i]??i}const Rp=[["box","a track; its front is crossed, the line ahead is where it will be in one second"],["pale box","nothing is seen of it: it coasts, or is new"],["dashed box","truth"],["arrow of four corners","the vehicle that carries the sensor"],["triangle on the timeline","birth: a track is confirmed"],["dash on the timeline","coast: its object is out of sight"],["cross on the timeline","loss: it is given up"],["ring on the timeline","switch: another track follows the same object (needs truth)"]];function Cp(i){const t=nt("dl",{class:"facts"});for(const r of i)t.append(nt("dt",{},...r.keys.flatMap((o,a)=>[a>0?" ":"",nt("kbd",{},Ap(o))])),nt("dd",{},r.says));const e=nt("dl",{class:"facts"});for(const[r,o]of Rp)e.append(nt("dt",{},r),nt("dd",{},o));const n=nt("button",{type:"button",class:"primary",onclick:()=>s.close()},"Close"),s=nt("dialog",{class:"help","aria-label":"Help"},n,nt("h2",{},"What is what"),e,nt("h2",{},"Mouse and touch"),nt("p",{},"Drag turns the view, right drag (two fingers) moves it, the wheel zooms. In the top view a drag moves. A click selects a track."),nt("h2",{},"Keys"),t);return s.addEventListener("click",r=>{r.target===s&&s.close()}),s}const si={dark:{ground:"#10151c",panel:"#18202a",raised:"#232e3b",edge:"#3a4858",text:"#edf2f7",faint:"#a9b7c6",accent:"#56b4e9",onAccent:"#0b1016",warning:"#f0b429",grid:"#2a3543",noise:"#7d8b99",truth:"#f2f2f2",selected:"#f0e442",classes:["#dfe6ee","#56b4e9","#e69f00","#1fa37c","#c86fa3"],events:["#2fc79a","#e69f00","#ff7a52","#d98cb8"]},light:{ground:"#f7f9fb",panel:"#ffffff",raised:"#e9eef3",edge:"#a5b1be",text:"#16202b",faint:"#48596a",accent:"#0064a0",onAccent:"#ffffff",warning:"#8a5300",grid:"#d5dde5",noise:"#7a8794",truth:"#303030",selected:"#7a5f00",classes:["#1f2730","#0064a0","#a35c00","#00704f","#8f2f6b"],events:["#00704f","#9c5700","#b83b00","#96406f"]}},Pp={dark:["#56b4e9","#e69f00","#2fc79a","#f0e442","#d98cb8","#ff7a52","#9fd3f4","#ffd27a","#8fe3c8","#b3a5ff","#f3bfd9","#c9d65b"],light:["#0064a0","#b06000","#007a57","#6b5b00","#96406f","#b83b00","#3f7fae","#8a4b1f","#2f6f5c","#5a48b0","#a85a86","#5f6b00"]};function wf(i,t){const e=Math.max(0,Math.min(1,i)),n=t==="dark"?[[59,111,212],[154,164,173],[246,224,74]]:[[31,63,156],[111,119,128],[160,123,0]],s=e<.5?0:1,r=n[s],o=n[s+1],a=2*e-s;return[0,1,2].map(l=>Math.round((r[l]??0)+a*((o[l]??0)-(r[l]??0))))}function gn(i){const t=parseInt(i.slice(1),16);return[t>>16,t>>8&255,t&255]}class Lp{constructor(t,e){this.settings=t,this.classes=e}element=nt("div",{class:"legend"});draw(t){const e=si[this.settings.theme],n=new Set((t?.tracks??[]).map(r=>r.class)),s=[];this.classes().forEach((r,o)=>{n.has(o)&&s.push(ph(e.classes[o]??"",r))}),(t?.tracks??[]).some(r=>r.status===2)&&s.push(nt("span",{},"pale: not seen now")),(t?.truth.length??0)>0&&s.push(ph(e.truth,"truth (dashed)")),vn(this.element,nt("span",{class:"hint"},this.pointsText(t)),...this.scale(t),...s)}pointsText(t){if(t&&t.rays.length>0)return Dp(t);if(t&&t.edges.length>0&&this.settings.colourBy==="segment")return`${t.clusters.length.toLocaleString("en")} returns shown; coloured: those of this position`;const e=(t?.clusters.length??0).toLocaleString("en"),n=this.settings.colourBy;return n==="segment"?`${e} returns; a colour for each segment, grey in none`:`${e} returns by ${n}`}scale(t){const n={intensity:[(t?.intensityLow??0).toPrecision(3),(t?.intensityHigh??0).toPrecision(3)],layer:["lowest","highest"],height:["2 m below the sensor","2 m above"],age:["oldest","newest"]}[this.settings.colourBy];if(!n)return[];const s=nt("canvas",{width:"96",height:"10"}),r=s.getContext("2d");for(let o=0;r&&o<96;++o)r.fillStyle=`rgb(${wf(o/95,this.settings.theme).join(",")})`,r.fillRect(o,0,1,10);return[nt("span",{class:"ramp"},n[0],s,n[1])]}}function ph(i,t){const e=nt("i",{class:"swatch"});return e.style.backgroundColor=i,nt("span",{},e,t)}function Dp(i){const t=i.rays.filter(n=>n.target>=0).length,e=i.tracks.length===0?"positions found, each with its 95 % ellipse":"targets";return`${i.rays.length} bearings: ${t} blue to ${e}, ${i.rays.length-t} grey to none`}class Up{element=nt("section",{class:"panel","aria-label":"Recording"});facts=nt("dl",{class:"facts"});odd=nt("div");hello=null;constructor(){this.element.append(nt("h2",{},"Recording"),this.facts,this.odd)}greet(t){this.hello=t}show(t,e,n,s){const r=[["name",this.hello?.title??""],["preset",this.hello?.preset??""],["frames",`${t.frames}${t.done?"":", still reading"}`],["duration",Ts(e)],["sensors",t.sensors.join(", ")||"none yet"],["confirmed tracks",String(t.confirmed)],["truth",t.has_truth?"yes":"none given"],["put aside on disk",mh(t.disk_bytes)],["held in this page",mh(n)],["drawing takes",`${s.toFixed(1)} ms`]];vn(this.facts,...r.flatMap(([a,l])=>[nt("dt",{},a),nt("dd",{},l)]));const o=t.diagnostics.map(a=>nt("li",{class:a.damage?"warning":""},`${a.count} x ${a.what}${a.first?`, first at ${a.first}`:""}`));vn(this.odd,...o.length>0?[nt("h3",{},"Odd in the input"),nt("ul",{},...o)]:[])}}function mh(i){return`${(i/1e6).toFixed(1)} MB`}const Ip=[1,1.5,1.7,1.7,1];function Np(i,t,e){return i.height>0?i.height:e*(Ip[t]??1)}function Ur(i){const t=Math.cos(i.heading),e=Math.sin(i.heading),n=i.length/2,s=i.width/2;return[[n,s],[-n,s],[-n,-s],[n,-s]].map(([r,o])=>[i.x+t*r-e*o,i.y+e*r+t*o])}function Af(i,t,e,n){const s=Math.cos(i.heading),r=Math.sin(i.heading),o=t-i.x,a=e-i.y;return Math.abs(s*o+r*a)<=i.length/2+n&&Math.abs(s*a-r*o)<=i.width/2+n}function gh(i,t,[e,n,s],r=36){const o=Math.sqrt(5.991),a=(e+s)/2,l=Math.hypot((e-s)/2,n),c=o*Math.sqrt(Math.max(0,a+l)),h=o*Math.sqrt(Math.max(0,a-l)),u=Math.atan2(2*n,e-s)/2,f=Math.cos(u),m=Math.sin(u);return Array.from({length:r},(_,x)=>{const p=2*Math.PI*x/r,d=c*Math.cos(p),T=h*Math.sin(p);return[i+f*d-m*T,t+m*d+f*T]})}const _h=180/Math.PI,Fp=["vehicle","pedestrian","cyclist","other","unknown"];class Op{constructor(t,e,n,s){this.ask=t,this.frameShown=e,this.settings=n,this.drawBoxes=s;const r=(o,a,l="")=>nt("button",{type:"button",class:l,onclick:a},o);this.element.append(nt("p",{class:"hint"},"Select a track and accept it: over its whole life it becomes an object of the truth. Then correct, name, merge and split."),nt("div",{class:"line"},r("Accept track",()=>this.accept(),"primary"),r("Accept in this frame",()=>this.acceptFrame()),r("Undo",()=>this.change("undo"))),nt("div",{class:"line"},r("Save truth CSV",()=>this.change("save"),"primary")),this.state,this.editor,nt("h3",{},"Objects"),this.list)}element=nt("section",{class:"panel","aria-label":"Label"});list=nt("ul",{class:"tracks"});editor=nt("div");state=nt("p",{class:"state",role:"status"});reply=null;object=null;active=!1;draggedBox=null;grab={dx:0,dy:0};setActive(t){this.active=t,t?this.refresh():this.drawBoxes([])}refresh(){this.active&&this.change("list")}accept(){this.settings.selected===null?this.say("Select a track first."):this.change("accept",{track:this.settings.selected})}show(t){this.reply=t,t.csv!==void 0&&t.file===""&&bf("truth.csv",t.csv,"text/csv");const e=t.file===""?"":` to ${t.file}`;t.csv!==void 0?this.say(`Saved ${t.objects.length} objects${e}.`):this.say(t.saved?"":"Not saved yet."),t.objects.some(n=>n.id===this.object)||(this.object=t.objects.find(n=>n.id===this.settings.selected)?.id??null),this.active&&t.frame===this.frameShown()&&this.drawBoxes(t.boxes),this.drawList(),this.drawEditor()}grabs(t,e){const n=this.chosenBox();return!this.active||!n||!Af(n,t,e,.1)?!1:(this.draggedBox={...n},this.grab={dx:n.x-t,dy:n.y-e},!0)}dragTo(t,e,n){const s=this.draggedBox;!s||!this.reply||(s.x=t+this.grab.dx,s.y=e+this.grab.dy,this.drawBoxes(this.reply.boxes.map(r=>r.id===s.id?s:r)),n&&(this.correct(s),this.draggedBox=null))}say(t){this.state.textContent=t}change(t,e={}){this.ask({op:"label",action:t,frame:this.frameShown(),...e})}acceptFrame(){if(this.settings.selected===null)return this.say("Select a track first.");const t=this.object===null?{}:{object:this.object};this.change("accept_frame",{track:this.settings.selected,...t})}correct(t){this.change("correct",{object:t.id,x_m:t.x,y_m:t.y,heading_rad:t.heading,length_m:t.length,width_m:t.width})}chosenBox(){return this.reply?.boxes.find(t=>t.id===this.object)}drawList(){const t=this.reply?.objects??[];vn(this.list,...t.map(e=>nt("li",{},nt("button",{type:"button",class:e.id===this.object?"row chosen":"row","aria-pressed":e.id===this.object?"true":"false",onclick:()=>{this.object=e.id,this.drawList(),this.drawEditor()}},`${e.id} ${e.class}, frames ${e.first} to ${e.last}`)))),t.length===0&&vn(this.list,nt("li",{class:"hint"},"none yet"))}drawEditor(){const t=this.reply?.objects.find(s=>s.id===this.object);if(!t)return vn(this.editor);const e=(s,r)=>nt("button",{type:"button",onclick:r},s),n=(this.reply?.objects??[]).filter(s=>s.id!==t.id);vn(this.editor,nt("h2",{},`Object ${t.id}`),nt("div",{class:"line"},"is a ",Zr(Fp,t.class,"Class",s=>this.change("class",{object:t.id,class:s}))),...this.mergeLine(t,n),nt("div",{class:"line"},e("Split here",()=>this.change("split",{object:t.id})),e("Remove here",()=>this.change("remove_frame",{object:t.id})),e("Remove object",()=>this.change("remove",{object:t.id}))),...this.boxFields())}mergeLine(t,e){if(e.length===0)return[];const n=["choose",...e.map(s=>String(s.id))];return[nt("div",{class:"line"},"same as object ",Zr(n,"choose","Merge into",s=>{s!=="choose"&&this.change("merge",{object:t.id,other:Number(s)})}))]}boxFields(){const t=this.chosenBox();if(!t)return[nt("p",{class:"hint"},"It has no box in this frame.")];const e=(n,s,r)=>{const o=nt("input",{type:"number",step:"0.05",value:s.toFixed(2),"aria-label":n});return o.addEventListener("change",()=>{const a=Number(o.value);o.value===""||!Number.isFinite(a)||(r(a),this.correct(t))}),nt("label",{class:"number"},n,o)};return[nt("p",{class:"hint"},"Drag the box in the scene, or type:"),nt("div",{class:"grid"},e("x / m",t.x,n=>t.x=n),e("y / m",t.y,n=>t.y=n),e("heading / deg",t.heading*_h,n=>t.heading=n/_h),e("length / m",t.length,n=>t.length=n),e("width / m",t.width,n=>t.width=n))]}}class Bp{constructor(t,e){this.panels=t,this.opened=e;const n=nt("div",{class:"tabs",role:"tablist"});for(const[s,r]of t){const o=`panel-${s.toLowerCase()}`;r.id=o,r.setAttribute("role","tabpanel");const a=nt("button",{type:"button",role:"tab","aria-controls":o,onclick:()=>this.open(s)},s);this.buttons.set(s,a),n.append(a)}this.element.append(n,...t.map(([,s])=>s)),this.mark(t[0]?.[0]??"")}element=nt("aside",{class:"side"});buttons=new Map;open(t){this.mark(t),this.opened(t)}mark(t){for(const[e,n]of this.panels)n.hidden=e!==t;for(const[e,n]of this.buttons)n.setAttribute("aria-selected",String(e===t))}}function kp(i,t,e,n,s){const r=i.clusters.length,o=new Uint8Array(3*r),a=zp(i,t,e,n),l=gn(si[e].selected),c=gn(si[e].ground),h=t==="age"?0:.75*n;for(let u=0;u<r;++u){const f=s>0&&i.clusters[u]===s?l:a(u);for(let m=0;m<3;++m)o[3*u+m]=(f[m]??0)*(1-h)+(c[m]??0)*h}return o}function zp(i,t,e,n){const s=gn(si[e].noise),r=Array.from({length:256},(a,l)=>wf(l/255,e)),o=a=>r[Math.max(0,Math.min(255,a|0))]??s;switch(t){case"segment":{const a=Pp[e].map(gn);return l=>{const c=i.clusters[l]??0;return c===0?s:a[c%a.length]??s}}case"class":{const a=si[e].classes.map(gn),l=Hp(i);return c=>{const h=l[i.clusters[c]??0]??-1;return h<0?s:a[h]??s}}case"intensity":return a=>o(i.intensities[a]??0);case"layer":{const a=Math.max(1,i.layers.reduce((l,c)=>Math.max(l,c),0));return l=>o(255*(i.layers[l]??0)/a)}case"height":{const a=i.sensorPose.z-2;return l=>o(((i.positions[3*l+2]??0)-a)*64)}case"age":return()=>o(255*(1-n))}}function Hp(i){const t=new Map(i.tracks.map(n=>[n.detection,n])),e=new Int8Array(i.detectionOfCluster.length+1).fill(-1);return i.detectionOfCluster.forEach((n,s)=>{n<0||(e[s+1]=t.get(n)?.class??i.detections[n]?.class??-1)}),e}function Rf(i,t){const e=i.tracks.find(n=>n.id===t);return!e||e.detection<0?0:i.detectionOfCluster.indexOf(e.detection)+1}const Vp=!0,Ke="u-",Gp="uplot",Wp=Ke+"hz",Xp=Ke+"vt",Yp=Ke+"title",qp=Ke+"wrap",$p=Ke+"under",jp=Ke+"over",Kp=Ke+"axis",Ms=Ke+"off",Zp=Ke+"select",Jp=Ke+"cursor-x",Qp=Ke+"cursor-y",tm=Ke+"cursor-pt",em=Ke+"legend",nm=Ke+"live",im=Ke+"inline",sm=Ke+"series",rm=Ke+"marker",vh=Ke+"label",om=Ke+"value",Vr="width",Gr="height",Ir="top",xh="bottom",Xs="left",Ua="right",yc="#000",Mh=yc+"0",Ia="mousemove",Sh="mousedown",Na="mouseup",yh="mouseenter",Eh="mouseleave",bh="dblclick",am="resize",lm="scroll",Th="change",ea="dppxchange",Ec="--",yr=typeof window<"u",Ml=yr?document:null,lr=yr?window:null,cm=yr?navigator:null;let _e,mo;function Sl(){let i=devicePixelRatio;_e!=i&&(_e=i,mo&&El(Th,mo,Sl),mo=matchMedia(`(min-resolution: ${_e-.001}dppx) and (max-resolution: ${_e+.001}dppx)`),ws(Th,mo,Sl),lr.dispatchEvent(new CustomEvent(ea)))}function In(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function yl(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function De(i,t,e){i.style[t]=e+"px"}function Jn(i,t,e,n){let s=Ml.createElement(i);return t!=null&&In(s,t),e?.insertBefore(s,n),s}function Hn(i,t){return Jn("div",i,t)}const wh=new WeakMap;function fi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=wh.get(i);r!=o&&(i.style.transform=r,wh.set(i,r),t<0||e<0||t>n||e>s?In(i,Ms):yl(i,Ms))}const Ah=new WeakMap;function Rh(i,t,e){let n=t+e,s=Ah.get(i);n!=s&&(Ah.set(i,n),i.style.background=t,i.style.borderColor=e)}const Ch=new WeakMap;function Ph(i,t,e,n){let s=t+""+e,r=Ch.get(i);s!=r&&(Ch.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}const bc={passive:!0},hm={...bc,capture:!0};function ws(i,t,e,n){t.addEventListener(i,e,n?hm:bc)}function El(i,t,e,n){t.removeEventListener(i,e,bc)}yr&&Sl();function Qn(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:Nn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Cf(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}const Pf=i=>i!=null,Lf=i=>i!=null&&i>0,la=Cf(Pf),um=Cf(Lf);function fm(i,t,e,n=0,s=!1){let r=s?um:la,o=s?Lf:Pf;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??we,l??-we]}function ca(i,t,e,n){let s=Uh(i),r=Uh(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Ii:Df,a=s==1?Nn:Vn,l=r==1?Vn:Nn,c=a(o(qe(i))),h=l(o(qe(t))),u=fr(e,c),f=fr(e,h);return e==10&&(c<0&&(u=Ae(u,-c)),h<0&&(f=Ae(f,-h))),n||e==2?(i=u*s,t=f*r):(i=Ff(i,u),t=ha(t,f)),[i,t]}function Tc(i,t,e,n){let s=ca(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}const wc=.1,Lh={mode:3,pad:wc},jr={pad:0,soft:null,mode:0},dm={min:jr,max:jr};function na(i,t,e,n){return ua(e)?Dh(i,t,e):(jr.pad=e,jr.soft=n?0:null,jr.mode=n?3:0,Dh(i,t,dm))}function pe(i,t){return i??t}function pm(i,t,e){for(t=pe(t,0),e=pe(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Dh(i,t,e){let n=e.min,s=e.max,r=pe(n.pad,0),o=pe(s.pad,0),a=pe(n.hard,-we),l=pe(s.hard,we),c=pe(n.soft,we),h=pe(s.soft,-we),u=pe(n.mode,0),f=pe(s.mode,0),m=t-i,_=Ii(m),x=xn(qe(i),qe(t)),p=Ii(x),d=qe(p-_);(m<1e-24||d>10)&&(m=0,(i==0||t==0)&&(m=1e-24,u==2&&c!=we&&(r=0),f==2&&h!=-we&&(o=0)));let T=m||x||1e3,A=Ii(T),y=fr(10,Nn(A)),z=T*(m==0?i==0?.1:1:r),L=Ae(Ff(i-z,y/10),24),D=i>=c&&(u==1||u==3&&L<=c||u==2&&L>=c)?c:we,I=xn(a,L<D&&i>=D?D:ti(D,L)),b=T*(m==0?t==0?.1:1:o),S=Ae(ha(t+b,y/10),24),C=t<=h&&(f==1||f==3&&S>=h||f==2&&S<=h)?h:-we,$=ti(l,S>C&&t<=C?C:xn(C,S));return I==$&&I==0&&($=100),[I,$]}const mm=new Intl.NumberFormat(yr?cm.language:"en-US"),Ac=i=>mm.format(i),Fn=Math,qo=Fn.PI,qe=Fn.abs,Nn=Fn.floor,Ye=Fn.round,Vn=Fn.ceil,ti=Fn.min,xn=Fn.max,fr=Fn.pow,Uh=Fn.sign,Ii=Fn.log10,Df=Fn.log2,gm=(i,t=1)=>Fn.sinh(i)*t,Fa=(i,t=1)=>Fn.asinh(i/t),we=1/0;function Ih(i){return(Ii((i^i>>31)-(i>>31))|0)+1}function bl(i,t,e){return ti(xn(i,t),e)}function Uf(i){return typeof i=="function"}function re(i){return Uf(i)?i:()=>i}const _m=()=>{},If=i=>i,Nf=(i,t)=>t,vm=i=>null,Nh=i=>!0,Fh=(i,t)=>i==t,xm=/\.\d*?(?=9{6,}|0{6,})/gm,As=i=>{if(Bf(i)||ns.has(i))return i;const t=`${i}`,e=t.match(xm);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${As(s)}e${r}`}return Ae(i,n)};function _s(i,t){return As(Ae(As(i/t))*t)}function ha(i,t){return As(Vn(As(i/t))*t)}function Ff(i,t){return As(Nn(As(i/t))*t)}function Ae(i,t=0){if(Bf(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Ye(n)/e}const ns=new Map;function Of(i){return((""+i).split(".")[1]||"").length}function Jr(i,t,e,n){let s=[],r=n.map(Of);for(let o=t;o<e;o++){let a=qe(o),l=Ae(fr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Ae(h,u);s.push(f),ns.set(f,u)}}return s}const Kr={},Rc=[],dr=[null,null],Zi=Array.isArray,Bf=Number.isInteger,Mm=i=>i===void 0;function Oh(i){return typeof i=="string"}function ua(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Sm(i){return i!=null&&typeof i=="object"}const ym=Object.getPrototypeOf(Uint8Array),kf="__proto__";function pr(i,t=ua){let e;if(Zi(i)){let n=i.find(s=>s!=null);if(Zi(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=pr(i[s],t)}else e=i.slice()}else if(i instanceof ym)e=i.slice();else if(t(i)){e={};for(let n in i)n!=kf&&(e[n]=pr(i[n],t))}else e=i;return e}function Ve(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=kf&&(ua(i[s])?Ve(i[s],pr(n[s])):i[s]=pr(n[s]))}return i}const Em=0,bm=1,Tm=2;function wm(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Am(i,t){if(Pm(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Lm(o[0])||(o=Cm(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:bm,m=[];for(let _=0;_<h.length;_++){let x=h[_],p=r.get(l[_]);x===null?f!=Em&&(u[p]=x,f==Tm&&m.push(p)):u[p]=x}wm(u,m,s),n.push(u)}}return n}const Rm=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Cm(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Pm(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Lm(i,t=100){const e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const r=xn(1,Nn((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){const l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const zf=["January","February","March","April","May","June","July","August","September","October","November","December"],Hf=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Vf(i){return i.slice(0,3)}const Dm=Hf.map(Vf),Um=zf.map(Vf),Im={MMMM:zf,MMM:Um,WWWW:Hf,WWW:Dm};function Nr(i){return(i<10?"0":"")+i}function Nm(i){return(i<10?"00":i<100?"0":"")+i}const Fm={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Nr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Nr(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Nr(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Nr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Nr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Nm(i.getMilliseconds())};function Cc(i,t){t=t||Im;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Fm[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const Om=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Bm(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Om?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}const Gf=i=>i%1==0,ia=[1,2,2.5,5],km=Jr(10,-32,0,ia),Wf=Jr(10,0,32,ia),zm=Wf.filter(Gf),vs=km.concat(Wf),Pc=`
`,Xf="{YYYY}",Bh=Pc+Xf,Yf="{M}/{D}",Wr=Pc+Yf,go=Wr+"/{YY}",qf="{aa}",Hm="{h}:{mm}",or=Hm+qf,kh=Pc+or,zh=":{ss}",xe=null;function $f(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Jr(10,0,3,ia).filter(Gf):Jr(10,-3,0,ia)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Xf,xe,xe,xe,xe,xe,xe,1],[s*28,"{MMM}",Bh,xe,xe,xe,xe,xe,1],[s,Yf,Bh,xe,xe,xe,xe,xe,1],[n,"{h}"+qf,go,xe,Wr,xe,xe,xe,1],[e,or,go,xe,Wr,xe,xe,xe,1],[t,zh,go+" "+or,xe,Wr+" "+or,xe,kh,xe,1],[i,zh+".{fff}",go+" "+or,xe,Wr+" "+or,xe,kh,xe,1]];function h(u){return(f,m,_,x,p,d)=>{let T=[],A=p>=o,y=p>=r&&p<o,z=u(_),L=Ae(z*i,3),D=Oa(z.getFullYear(),A?0:z.getMonth(),y||A?1:z.getDate()),I=Ae(D*i,3);if(y||A){let b=y?p/r:0,S=A?p/o:0,C=L==I?L:Ae(Oa(D.getFullYear()+S,D.getMonth()+b,1)*i,3),$=new Date(Ye(C/i)),O=$.getFullYear(),Z=$.getMonth();for(let q=0;C<=x;q++){let J=Oa(O+S*q,Z+b*q,1),j=J-u(Ae(J*i,3));C=Ae((+J+j)*i,3),C<=x&&T.push(C)}}else{let b=p>=s?s:p,S=Nn(_)-Nn(L),C=I+S+ha(L-I,b);T.push(C);let $=u(C),O=$.getHours()+$.getMinutes()/e+$.getSeconds()/n,Z=p/n,q=f.axes[m]._space,J=d/q;for(;C=Ae(C+p,i==1?0:3),!(C>x);)if(Z>1){let j=Nn(Ae(O+Z,6))%24,ct=u(C).getHours()-j;ct>1&&(ct=-1),C-=ct*n,O=(O+Z)%24;let mt=T[T.length-1];Ae((C-mt)/p,3)*J>=.7&&T.push(C)}else T.push(C)}return T}}return[l,c,h]}const[Vm,Gm,Wm]=$f(1),[Xm,Ym,qm]=$f(.001);Jr(2,-53,53,[1]);function Hh(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Vh(i,t){return(e,n,s,r,o)=>{let a=t.find(_=>o>=_[0])||t[t.length-1],l,c,h,u,f,m;return n.map(_=>{let x=i(_),p=x.getFullYear(),d=x.getMonth(),T=x.getDate(),A=x.getHours(),y=x.getMinutes(),z=x.getSeconds(),L=p!=l&&a[2]||d!=c&&a[3]||T!=h&&a[4]||A!=u&&a[5]||y!=f&&a[6]||z!=m&&a[7]||a[1];return l=p,c=d,h=T,u=A,f=y,m=z,L(x)})}}function $m(i,t){let e=Cc(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Oa(i,t,e){return new Date(i,t,e)}function Gh(i,t){return t(i)}const jm="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Wh(i,t){return(e,n,s,r)=>r==null?Ec:t(i(n))}function Km(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Zm(i,t){return i.series[t].fill(i,t)}const Jm={show:!0,live:!0,isolate:!1,mount:_m,markers:{show:!0,width:2,stroke:Km,fill:Zm,dash:"solid"},idx:null,idxs:null,values:[]};function Qm(i,t){let e=i.cursor.points,n=Hn(),s=e.size(i,t);De(n,Vr,s),De(n,Gr,s);let r=s/-2;De(n,"marginLeft",r),De(n,"marginTop",r);let o=e.width(i,t,s);return o&&De(n,"borderWidth",o),n}function tg(i,t){let e=i.series[t].points;return e._fill||e._stroke}function eg(i,t){let e=i.series[t].points;return e._stroke||e._fill}function ng(i,t){return i.series[t].points.size}const Ba=[0,0];function ig(i,t,e){return Ba[0]=t,Ba[1]=e,Ba}function _o(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function ka(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}const sg={show:!0,x:!0,y:!0,lock:!1,move:ig,points:{one:!1,show:Qm,size:ng,width:0,stroke:eg,fill:tg},bind:{mousedown:_o,mouseup:_o,click:_o,dblclick:_o,mousemove:ka,mouseleave:ka,mouseenter:ka},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},jf={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Lc=Ve({},jf,{filter:Nf}),Kf=Ve({},Lc,{size:10}),Zf=Ve({},jf,{show:!1}),Dc='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Jf="bold "+Dc,Qf=1.5,Xh={show:!0,scale:"x",stroke:yc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jf,side:2,grid:Lc,ticks:Kf,border:Zf,font:Dc,lineGap:Qf,rotate:0},rg="Value",og="Time",Yh={show:!0,scale:"x",auto:!1,sorted:1,min:we,max:-we,idxs:[]};function ag(i,t,e,n,s){return t.map(r=>r==null?"":Ac(r))}function lg(i,t,e,n,s,r,o){let a=[],l=ns.get(s)||0;e=o?e:Ae(ha(e,s),l);for(let c=e;c<=n;c=Ae(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Tl(i,t,e,n,s,r,o){const a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Ii:Df,h=Nn(c(e));s=fr(l,h),l==10&&(s=vs[Qn(s,vs)]);let u=e,f=s*l;l==10&&(f=vs[Qn(f,vs)]);do a.push(u),u=u+s,l==10&&!ns.has(u)&&(u=Ae(u,ns.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=vs[Qn(f,vs)]));while(u<=n);return a}function cg(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Tl(i,t,xn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Tl(i,t,xn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}const td=/./,hg=/[12357]/,ug=/[125]/,qh=/1/,wl=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function fg(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?td:l(7,o)-h>=c?hg:l(5,o)-h>=c?ug:qh;if(u==qh){let f=qe(l(1,o)-h);if(f<c)return wl(t.slice().reverse(),a.distr,u,Vn(c/f)).reverse()}return wl(t,a.distr,u,1)}function dg(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=qe(l(1,o)-l(2,o));return c<a?wl(t.slice().reverse(),3,td,Vn(a/c)).reverse():t}function pg(i,t,e,n){return n==null?Ec:t==null?"":Ac(t)}const $h={show:!0,scale:"y",stroke:yc,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jf,side:3,grid:Lc,ticks:Kf,border:Zf,font:Dc,lineGap:Qf,rotate:0};function mg(i,t){let e=3+(i||1)*2;return Ae(e*t,3)}function gg(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=qe(o-r),l=i.series[t],c=a/(l.points.space*_e);return n[1]-n[0]<=c}const jh={scale:null,auto:!0,sorted:0,min:we,max:-we},ed=(i,t,e,n,s)=>s,Kh={show:!0,auto:!0,sorted:0,gaps:ed,alpha:1,facets:[Ve({},jh,{scale:"x"}),Ve({},jh,{scale:"y"})]},Zh={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:ed,alpha:1,points:{show:gg,filter:null},values:null,min:we,max:-we,idxs:[],path:null,clip:null};function _g(i,t,e,n,s){return e/10}const nd={time:Vp,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},vg=Ve({},nd,{time:!1,ori:1}),Jh={};function id(i,t){let e=Jh[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Jh[i]=e)),e}const mr=1,Al=2;function Ls(i,t,e){const n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox;let l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,m=a.top,_=a.width,x=a.height,p=i.valToPosH,d=i.valToPosV;return h.ori==0?e(s,l,c,h,u,p,d,f,m,_,x,da,Er,ma,rd,ad):e(s,l,c,h,u,d,p,m,f,x,_,pa,br,Nc,od,ld)}function Uc(i,t){let e=0,n=0,s=pe(i.bands,Rc);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function xg(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ni(i,t,e,n,s,r){return Ls(i,t,(o,a,l,c,h,u,f,m,_,x,p)=>{let d=o.pxRound;const T=c.dir*(c.ori==0?1:-1),A=c.ori==0?Er:br;let y,z;T==1?(y=e,z=n):(y=n,z=e);let L=d(u(a[y],c,x,m)),D=d(f(l[y],h,p,_)),I=d(u(a[z],c,x,m)),b=d(f(r==1?h.max:h.min,h,p,_)),S=new Path2D(s);return A(S,I,b),A(S,L,b),A(S,L,D),S})}function fa(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;const a=t==0?ma:Nc;let l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let m=f[0]-l;m>0&&a(o,l,n,m,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Mg(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Ic(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let m=r(i[u]),_=f==u?m:r(i[f]),x=u-s;m=o<=0&&x>=0&&x<l?r(i[x]):m;let d=f+s;_=o>=0&&d>=0&&d<l?r(i[d]):_,_>=m&&a.push([m,_])}return a}function Qh(i){return i==0?If:i==1?Ye:t=>_s(t,i)}function sd(i){let t=i==0?da:pa,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=ti(c,a/2,l/2),h=ti(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}const da=(i,t,e)=>{i.moveTo(t,e)},pa=(i,t,e)=>{i.moveTo(e,t)},Er=(i,t,e)=>{i.lineTo(t,e)},br=(i,t,e)=>{i.lineTo(e,t)},ma=sd(0),Nc=sd(1),rd=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},od=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},ad=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},ld=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function cd(i){return(t,e,n,s,r)=>Ls(t,e,(o,a,l,c,h,u,f,m,_,x,p)=>{let{pxRound:d,points:T}=o,A,y;c.ori==0?(A=da,y=rd):(A=pa,y=od);const z=Ae(T.width*_e,3);let L=(T.size-T.width)/2*_e,D=Ae(L*2,3),I=new Path2D,b=new Path2D,{left:S,top:C,width:$,height:O}=t.bbox;ma(b,S-D,C-D,$+D*2,O+D*2);const Z=q=>{if(l[q]!=null){let J=d(u(a[q],c,x,m)),j=d(f(l[q],h,p,_));A(I,J+L,j),y(I,J,j,L,0,qo*2)}};if(r)r.forEach(Z);else for(let q=n;q<=s;q++)Z(q);return{stroke:z>0?I:null,fill:I,clip:b,flags:mr|Al}})}function hd(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}const Sg=hd(Er),yg=hd(br);function ud(i){const t=pe(i?.alignGaps,0);return(e,n,s,r)=>Ls(e,n,(o,a,l,c,h,u,f,m,_,x,p)=>{[s,r]=la(l,s,r);let d=o.pxRound,T=O=>d(u(O,c,x,m)),A=O=>d(f(O,h,p,_)),y,z;c.ori==0?(y=Er,z=Sg):(y=br,z=yg);const L=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mr},I=D.stroke;let b=!1;if(r-s>=x*4){let O=pt=>e.posToVal(pt,c.key,!0),Z=null,q=null,J,j,Q,ut=T(a[L==1?s:r]),ct=T(a[s]),mt=T(a[r]),Mt=O(L==1?ct+1:mt-1);for(let pt=L==1?s:r;pt>=s&&pt<=r;pt+=L){let it=a[pt],gt=(L==1?it<Mt:it>Mt)?ut:T(it),ot=l[pt];gt==ut?ot!=null?(j=ot,Z==null?(y(I,gt,A(j)),J=Z=q=j):j<Z?Z=j:j>q&&(q=j)):ot===null&&(b=!0):(Z!=null&&z(I,ut,A(Z),A(q),A(J),A(j)),ot!=null?(j=ot,y(I,gt,A(j)),Z=q=J=j):(Z=q=null,ot===null&&(b=!0)),ut=gt,Mt=O(ut+L))}Z!=null&&Z!=q&&Q!=ut&&z(I,ut,A(Z),A(q),A(J),A(j))}else for(let O=L==1?s:r;O>=s&&O<=r;O+=L){let Z=l[O];Z===null?b=!0:Z!=null&&y(I,T(a[O]),A(Z))}let[C,$]=Uc(e,n);if(o.fill!=null||C!=0){let O=D.fill=new Path2D(I),Z=o.fillTo(e,n,o.min,o.max,C),q=A(Z),J=T(a[s]),j=T(a[r]);L==-1&&([j,J]=[J,j]),y(O,j,q),y(O,J,q)}if(!o.spanGaps){let O=[];b&&O.push(...Ic(a,l,s,r,L,T,t)),D.gaps=O=o.gaps(e,n,s,r,O),D.clip=fa(O,c.ori,m,_,x,p)}return $!=0&&(D.band=$==2?[Ni(e,n,s,r,I,-1),Ni(e,n,s,r,I,1)]:Ni(e,n,s,r,I,$)),D})}function Eg(i){const t=pe(i.align,1),e=pe(i.ascDesc,!1),n=pe(i.alignGaps,0),s=pe(i.extend,!1);return(r,o,a,l)=>Ls(r,o,(c,h,u,f,m,_,x,p,d,T,A)=>{[a,l]=la(u,a,l);let y=c.pxRound,{left:z,width:L}=r.bbox,D=ct=>y(_(ct,f,T,p)),I=ct=>y(x(ct,m,A,d)),b=f.ori==0?Er:br;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mr},C=S.stroke,$=f.dir*(f.ori==0?1:-1);let O=I(u[$==1?a:l]),Z=D(h[$==1?a:l]),q=Z,J=Z;s&&t==-1&&(J=z,b(C,J,O)),b(C,Z,O);for(let ct=$==1?a:l;ct>=a&&ct<=l;ct+=$){let mt=u[ct];if(mt==null)continue;let Mt=D(h[ct]),pt=I(mt);t==1?b(C,Mt,O):b(C,q,pt),b(C,Mt,pt),O=pt,q=Mt}let j=q;s&&t==1&&(j=z+L,b(C,j,O));let[Q,ut]=Uc(r,o);if(c.fill!=null||Q!=0){let ct=S.fill=new Path2D(C),mt=c.fillTo(r,o,c.min,c.max,Q),Mt=I(mt);b(ct,j,Mt),b(ct,J,Mt)}if(!c.spanGaps){let ct=[];ct.push(...Ic(h,u,a,l,$,D,n));let mt=c.width*_e/2,Mt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(it=>{it[0]+=Mt,it[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=fa(ct,f.ori,p,d,T,A)}return ut!=0&&(S.band=ut==2?[Ni(r,o,a,l,C,-1),Ni(r,o,a,l,C,1)]:Ni(r,o,a,l,C,ut)),S})}function tu(i,t,e,n,s,r,o=we){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=qe(i[l]-i[a]);h<c&&(c=h,o=qe(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function bg(i){i=i||Kr;const t=pe(i.size,[.6,we,1]),e=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=re(s),o=1-t[0],a=pe(t[1],we),l=pe(t[2],1),c=pe(i.disp,Kr),h=pe(i.each,m=>{}),{fill:u,stroke:f}=c;return(m,_,x,p)=>Ls(m,_,(d,T,A,y,z,L,D,I,b,S,C)=>{let $=d.pxRound,O=e,Z=n*_e,q=a*_e,J=l*_e,j,Q;y.ori==0?[j,Q]=r(m,_):[Q,j]=r(m,_);const ut=y.dir*(y.ori==0?1:-1);let ct=y.ori==0?ma:Nc,mt=y.ori==0?h:(H,tt,St,_t,Tt,$t,ft)=>{h(H,tt,St,Tt,_t,ft,$t)},Mt=pe(m.bands,Rc).find(H=>H.series[0]==_),pt=Mt!=null?Mt.dir:0,it=d.fillTo(m,_,d.min,d.max,pt),at=$(D(it,z,C,b)),gt,ot,kt,Ht=S,It=$(d.width*_e),oe=!1,jt=null,ae=null,B=null,Ge=null;u!=null&&(It==0||f!=null)&&(oe=!0,jt=u.values(m,_,x,p),ae=new Map,new Set(jt).forEach(H=>{H!=null&&ae.set(H,new Path2D)}),It>0&&(B=f.values(m,_,x,p),Ge=new Map,new Set(B).forEach(H=>{H!=null&&Ge.set(H,new Path2D)})));let{x0:Zt,size:Qt}=c;if(Zt!=null&&Qt!=null){O=1,T=Zt.values(m,_,x,p),Zt.unit==2&&(T=T.map(St=>m.posToVal(I+St*S,y.key,!0)));let H=Qt.values(m,_,x,p);Qt.unit==2?ot=H[0]*S:ot=L(H[0],y,S,I)-L(0,y,S,I),Ht=tu(T,A,L,y,S,I,Ht),kt=Ht-ot+Z}else Ht=tu(T,A,L,y,S,I,Ht),kt=Ht*o+Z,ot=Ht-kt;kt<1&&(kt=0),It>=ot/2&&(It=0),kt<5&&($=If);let Vt=kt>0,he=Ht-kt-(Vt?It:0);ot=$(bl(he,J,q)),gt=(O==0?ot/2:O==ut?0:ot)-O*ut*((O==0?Z/2:0)+(Vt?It/2:0));const Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},R=oe?null:new Path2D;let M=null;if(Mt!=null)M=m.data[Mt.series[1]];else{let{y0:H,y1:tt}=c;H!=null&&tt!=null&&(A=tt.values(m,_,x,p),M=H.values(m,_,x,p))}let Y=j*ot,K=Q*ot;for(let H=ut==1?x:p;H>=x&&H<=p;H+=ut){let tt=A[H];if(tt==null)continue;if(M!=null){let Ot=M[H]??0;if(tt-Ot==0)continue;at=D(Ot,z,C,b)}let St=y.distr!=2||c!=null?T[H]:H,_t=L(St,y,S,I),Tt=D(pe(tt,it),z,C,b),$t=$(_t-gt),ft=$(xn(Tt,at)),vt=$(ti(Tt,at)),Nt=ft-vt;if(tt!=null){let Ot=tt<0?K:Y,Et=tt<0?Y:K;oe?(It>0&&B[H]!=null&&ct(Ge.get(B[H]),$t,vt+Nn(It/2),ot,xn(0,Nt-It),Ot,Et),jt[H]!=null&&ct(ae.get(jt[H]),$t,vt+Nn(It/2),ot,xn(0,Nt-It),Ot,Et)):ct(R,$t,vt+Nn(It/2),ot,xn(0,Nt-It),Ot,Et),mt(m,_,H,$t-It/2,vt,ot+It,Nt)}}return It>0?Pt.stroke=oe?Ge:R:oe||(Pt._fill=d.width==0?d._fill:d._stroke??d._fill,Pt.width=0),Pt.fill=oe?ae:R,Pt})}function Tg(i,t){const e=pe(t?.alignGaps,0);return(n,s,r,o)=>Ls(n,s,(a,l,c,h,u,f,m,_,x,p,d)=>{[r,o]=la(c,r,o);let T=a.pxRound,A=j=>T(f(j,h,p,_)),y=j=>T(m(j,u,d,x)),z,L,D;h.ori==0?(z=da,D=Er,L=ad):(z=pa,D=br,L=ld);const I=h.dir*(h.ori==0?1:-1);let b=A(l[I==1?r:o]),S=b,C=[],$=[];for(let j=I==1?r:o;j>=r&&j<=o;j+=I)if(c[j]!=null){let ut=l[j],ct=A(ut);C.push(S=ct),$.push(y(c[j]))}const O={stroke:i(C,$,z,D,L,T),fill:null,clip:null,band:null,gaps:null,flags:mr},Z=O.stroke;let[q,J]=Uc(n,s);if(a.fill!=null||q!=0){let j=O.fill=new Path2D(Z),Q=a.fillTo(n,s,a.min,a.max,q),ut=y(Q);D(j,S,ut),D(j,b,ut)}if(!a.spanGaps){let j=[];j.push(...Ic(l,c,r,o,I,A,e)),O.gaps=j=a.gaps(n,s,r,o,j),O.clip=fa(j,h.ori,_,x,p,d)}return J!=0&&(O.band=J==2?[Ni(n,s,r,o,Z,-1),Ni(n,s,r,o,Z,1)]:Ni(n,s,r,o,Z,J)),O})}function wg(i){return Tg(Ag,i)}function Ag(i,t,e,n,s,r){const o=i.length;if(o<2)return null;const a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}const Rl=new Set;function eu(){for(let i of Rl)i.syncRect(!0)}yr&&(ws(am,lr,eu),ws(lm,lr,eu,!0),ws(ea,lr,()=>{hn.pxRatio=_e}));const Rg=ud(),Cg=cd();function nu(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Cl(r,o,t,e))}function Pg(i,t){return i.map((e,n)=>n==0?{}:Ve({},t,e))}function Cl(i,t,e,n){return Ve({},t==0?e:n,i)}function fd(i,t,e){return t==null?dr:[t,e]}const Lg=fd;function Dg(i,t,e){return t==null?dr:na(t,e,wc,!0)}function dd(i,t,e,n){return t==null?dr:ca(t,e,i.scales[n].log,!1)}const Ug=dd;function pd(i,t,e,n){return t==null?dr:Tc(t,e,i.scales[n].log,!1)}const Ig=pd;function Ng(i,t,e,n,s){let r=xn(Ih(i),Ih(t)),o=t-i,a=Qn(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?ns.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function iu(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Ye((e=+s)*_e))+"px"),[i,t,e]}function Fg(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ae(t[2]*_e,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function hn(i,t,e){const n={mode:pe(i.mode,1)},s=n.mode;function r(g,v,w,P){let U=v.valToPct(g);return P+w*(v.dir==-1?1-U:U)}function o(g,v,w,P){let U=v.valToPct(g);return P+w*(v.dir==-1?U:1-U)}function a(g,v,w,P){return v.ori==0?r(g,v,w,P):o(g,v,w,P)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;const c=n.root=Hn(Gp);if(i.id!=null&&(c.id=i.id),In(c,i.class),i.title){let g=Hn(Yp,c);g.textContent=i.title}const h=Jn("canvas"),u=n.ctx=h.getContext("2d"),f=Hn(qp,c);ws("click",f,g=>{g.target===_&&(Ce!=zs||Ne!=Hs)&&rn.click(n,g)},!0);const m=n.under=Hn($p,f);f.appendChild(h);const _=n.over=Hn(jp,f);i=pr(i);const x=+pe(i.pxAlign,1),p=Qh(x);(i.plugins||[]).forEach(g=>{g.opts&&(i=g.opts(n,i)||i)});const d=i.ms||.001,T=n.series=s==1?nu(i.series||[],Yh,Zh,!1):Pg(i.series||[null],Kh),A=n.axes=nu(i.axes||[],Xh,$h,!0),y=n.scales={},z=n.bands=i.bands||[];z.forEach(g=>{g.fill=re(g.fill||null),g.dir=pe(g.dir,-1)});const L=s==2?T[1].facets[0].scale:T[0].scale,D={axes:Jd,series:On},I=(i.drawOrder||["axes","series"]).map(g=>D[g]);function b(g){const v=g.distr==3?w=>Ii(w>0?w:g.clamp(n,w,g.min,g.max,g.key)):g.distr==4?w=>Fa(w,g.asinh):g.distr==100?w=>g.fwd(w):w=>w;return w=>{let P=v(w),{_min:U,_max:X}=g,st=X-U;return(P-U)/st}}function S(g){let v=y[g];if(v==null){let w=(i.scales||Kr)[g]||Kr;if(w.from!=null){S(w.from);let P=Ve({},y[w.from],w,{key:g});P.valToPct=b(P),y[g]=P}else{v=y[g]=Ve({},g==L?nd:vg,w),v.key=g;let P=v.time,U=v.range,X=Zi(U);if((g!=L||s==2&&!P)&&(X&&(U[0]==null||U[1]==null)&&(U={min:U[0]==null?Lh:{mode:1,hard:U[0],soft:U[0]},max:U[1]==null?Lh:{mode:1,hard:U[1],soft:U[1]}},X=!1),!X&&ua(U))){let st=U;U=(lt,dt,Rt)=>dt==null?dr:na(dt,Rt,st)}v.range=re(U||(P?Lg:g==L?v.distr==3?Ug:v.distr==4?Ig:fd:v.distr==3?dd:v.distr==4?pd:Dg)),v.auto=re(X?!1:v.auto),v.clamp=re(v.clamp||_g),v._min=v._max=null,v.valToPct=b(v)}}}S("x"),S("y"),s==1&&T.forEach(g=>{S(g.scale)}),A.forEach(g=>{S(g.scale)});for(let g in i.scales)S(g);const C=y[L],$=C.distr;let O,Z;C.ori==0?(In(c,Wp),O=r,Z=o):(In(c,Xp),O=o,Z=r);const q={};for(let g in y){let v=y[g];(v.min!=null||v.max!=null)&&(q[g]={min:v.min,max:v.max},v.min=v.max=null)}const J=i.tzDate||(g=>new Date(Ye(g/d))),j=i.fmtDate||Cc,Q=d==1?Wm(J):qm(J),ut=Vh(J,Hh(d==1?Gm:Ym,j)),ct=Wh(J,Gh(jm,j)),mt=[],Mt=n.legend=Ve({},Jm,i.legend),pt=n.cursor=Ve({},sg,{drag:{y:s==2}},i.cursor),it=Mt.show,at=pt.show,gt=Mt.markers;Mt.idxs=mt,gt.width=re(gt.width),gt.dash=re(gt.dash),gt.stroke=re(gt.stroke),gt.fill=re(gt.fill);let ot,kt,Ht,It=[],oe=[],jt,ae=!1,B={};if(Mt.live){const g=T[1]?T[1].values:null;ae=g!=null,jt=ae?g(n,1,0):{_:0};for(let v in jt)B[v]=Ec}if(it)if(ot=Jn("table",em,c),Ht=Jn("tbody",null,ot),Mt.mount(n,ot),ae){kt=Jn("thead",null,ot,Ht);let g=Jn("tr",null,kt);Jn("th",null,g);for(var Ge in jt)Jn("th",vh,g).textContent=Ge}else In(ot,im),Mt.live&&In(ot,nm);const Zt={show:!0},Qt={show:!1};function Vt(g,v){if(v==0&&(ae||!Mt.live||s==2))return dr;let w=[],P=Jn("tr",sm,Ht,Ht.childNodes[v]);In(P,g.class),g.show||In(P,Ms);let U=Jn("th",null,P);if(gt.show){let lt=Hn(rm,U);if(v>0){let dt=gt.width(n,v);dt&&(lt.style.border=dt+"px "+gt.dash(n,v)+" "+gt.stroke(n,v)),lt.style.background=gt.fill(n,v)}}let X=Hn(vh,U);g.label instanceof HTMLElement?X.appendChild(g.label):X.textContent=g.label,v>0&&(gt.show||(X.style.color=g.width>0?gt.stroke(n,v):gt.fill(n,v)),Pt("click",U,lt=>{if(pt._lock)return;We(lt);let dt=T.indexOf(g);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Rt=T.some((Ct,Lt)=>Lt>0&&Lt!=dt&&Ct.show);T.forEach((Ct,Lt)=>{Lt>0&&li(Lt,Rt?Lt==dt?Zt:Qt:Zt,!0,ze.setSeries)})}else li(dt,{show:!g.show},!0,ze.setSeries)},!1),Mi&&Pt(yh,U,lt=>{pt._lock||(We(lt),li(T.indexOf(g),Gs,!0,ze.setSeries))},!1));for(var st in jt){let lt=Jn("td",om,P);lt.textContent="--",w.push(lt)}return[P,w]}const he=new Map;function Pt(g,v,w,P=!0){const U=he.get(v)||{},X=pt.bind[g](n,v,w,P);X&&(ws(g,v,U[g]=X),he.set(v,U))}function R(g,v,w){const P=he.get(v)||{};for(let U in P)(g==null||U==g)&&(El(U,v,P[U]),delete P[U]);g==null&&he.delete(v)}let M=0,Y=0,K=0,H=0,tt=0,St=0,_t=tt,Tt=St,$t=K,ft=H,vt=0,Nt=0,Ot=0,Et=0;n.bbox={};let ne=!1,Yt=!1,ue=!1,F=!1,xt=!1,et=!1;function rt(g,v,w){(w||g!=n.width||v!=n.height)&&wt(g,v),Fs(!1),ue=!0,Yt=!0,Os()}function wt(g,v){n.width=M=K=g,n.height=Y=H=v,tt=St=0,Ze(),me();let w=n.bbox;vt=w.left=_s(tt*_e,.5),Nt=w.top=_s(St*_e,.5),Ot=w.width=_s(K*_e,.5),Et=w.height=_s(H*_e,.5)}const At=3;function Kt(){let g=!1,v=0;for(;!g;){v++;let w=Kd(v),P=Zd(v);g=v==At||w&&P,g||(wt(n.width,n.height),Yt=!0)}}function Ue({width:g,height:v}){rt(g,v)}n.setSize=Ue;function Ze(){let g=!1,v=!1,w=!1,P=!1;A.forEach((U,X)=>{if(U.show&&U._show){let{side:st,_size:lt}=U,dt=st%2,Rt=U.label!=null?U.labelSize:0,Ct=lt+Rt;Ct>0&&(dt?(K-=Ct,st==3?(tt+=Ct,P=!0):w=!0):(H-=Ct,st==0?(St+=Ct,g=!0):v=!0))}}),ri[0]=g,ri[1]=w,ri[2]=v,ri[3]=P,K-=E[1]+E[3],tt+=E[3],H-=E[2]+E[0],St+=E[0]}function me(){let g=tt+K,v=St+H,w=tt,P=St;function U(X,st){switch(X){case 1:return g+=st,g-st;case 2:return v+=st,v-st;case 3:return w-=st,w+st;case 0:return P-=st,P+st}}A.forEach((X,st)=>{if(X.show&&X._show){let lt=X.side;X._pos=U(lt,X._size),X.label!=null&&(X._lpos=U(lt,X.labelSize))}})}if(pt.dataIdx==null){let g=pt.hover,v=g.skip=new Set(g.skip??[]);v.add(void 0);let w=g.prox=re(g.prox),P=g.bias??=0;pt.dataIdx=(U,X,st,lt)=>{if(X==0)return st;let dt=st,Rt=w(U,X,st,lt)??we,Ct=Rt>=0&&Rt<we,Lt=C.ori==0?K:H,qt=pt.left,ge=t[0],de=t[X];if(v.has(de[st])){dt=null;let ie=null,Wt=null,zt;if(P==0||P==-1)for(zt=st;ie==null&&zt-- >0;)v.has(de[zt])||(ie=zt);if(P==0||P==1)for(zt=st;Wt==null&&zt++<de.length;)v.has(de[zt])||(Wt=zt);if(ie!=null||Wt!=null)if(Ct){let Le=ie==null?-1/0:O(ge[ie],C,Lt,0),Oe=Wt==null?1/0:O(ge[Wt],C,Lt,0),nn=qt-Le,ye=Oe-qt;nn<=ye?nn<=Rt&&(dt=ie):ye<=Rt&&(dt=Wt)}else dt=Wt==null?ie:ie==null?Wt:st-ie<=Wt-st?ie:Wt}else Ct&&qe(qt-O(ge[st],C,Lt,0))>Rt&&(dt=null);return dt}}const We=g=>{pt.event=g};pt.idxs=mt,pt._lock=!1;let Re=pt.points;Re.show=re(Re.show),Re.size=re(Re.size),Re.stroke=re(Re.stroke),Re.width=re(Re.width),Re.fill=re(Re.fill);const Rn=n.focus=Ve({},i.focus||{alpha:.3},pt.focus),Mi=Rn.prox>=0,Sn=Mi&&Re.one;let on=[],Si=[],yi=[];function rs(g,v){let w=Re.show(n,v);if(w instanceof HTMLElement)return In(w,tm),In(w,g.class),fi(w,-10,-10,K,H),_.insertBefore(w,on[v]),w}function Ar(g,v){if(s==1||v>0){let w=s==1&&y[g.scale].time,P=g.value;g.value=w?Oh(P)?Wh(J,Gh(P,j)):P||ct:P||pg,g.label=g.label||(w?og:rg)}if(Sn||v>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Rg||vm,g.fillTo=re(g.fillTo||xg),g.pxAlign=+pe(g.pxAlign,x),g.pxRound=Qh(g.pxAlign),g.stroke=re(g.stroke||null),g.fill=re(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let w=mg(xn(1,g.width),1),P=g.points=Ve({},{size:w,width:xn(1,w*.2),stroke:g.stroke,space:w*2,paths:Cg,_stroke:null,_fill:null},g.points);P.show=re(P.show),P.filter=re(P.filter),P.fill=re(P.fill),P.stroke=re(P.stroke),P.paths=re(P.paths),P.pxAlign=g.pxAlign}if(it){let w=Vt(g,v);It.splice(v,0,w[0]),oe.splice(v,0,w[1]),Mt.values.push(null)}if(at){mt.splice(v,0,null);let w=null;Sn?v==0&&(w=rs(g,v)):v>0&&(w=rs(g,v)),on.splice(v,0,w),Si.splice(v,0,0),yi.splice(v,0,0)}en("addSeries",v)}function Is(g,v){v=v??T.length,g=s==1?Cl(g,v,Yh,Zh):Cl(g,v,{},Kh),T.splice(v,0,g),Ar(T[v],v)}n.addSeries=Is;function oo(g){if(T.splice(g,1),it){Mt.values.splice(g,1),oe.splice(g,1);let v=It.splice(g,1)[0];R(null,v.firstChild),v.remove()}at&&(mt.splice(g,1),on.splice(g,1)[0].remove(),Si.splice(g,1),yi.splice(g,1)),en("delSeries",g)}n.delSeries=oo;const ri=[!1,!1,!1,!1];function Ma(g,v){if(g._show=g.show,g.show){let w=g.side%2,P=y[g.scale];P==null&&(g.scale=w?T[1].scale:L,P=y[g.scale]);let U=P.time;g.size=re(g.size),g.space=re(g.space),g.rotate=re(g.rotate),Zi(g.incrs)&&g.incrs.forEach(st=>{!ns.has(st)&&ns.set(st,Of(st))}),g.incrs=re(g.incrs||(P.distr==2?zm:U?d==1?Vm:Xm:vs)),g.splits=re(g.splits||(U&&P.distr==1?Q:P.distr==3?Tl:P.distr==4?cg:lg)),g.stroke=re(g.stroke),g.grid.stroke=re(g.grid.stroke),g.ticks.stroke=re(g.ticks.stroke),g.border.stroke=re(g.border.stroke);let X=g.values;g.values=Zi(X)&&!Zi(X[0])?re(X):U?Zi(X)?Vh(J,Hh(X,j)):Oh(X)?$m(J,X):X||ut:X||ag,g.filter=re(g.filter||(P.distr>=3&&P.log==10?fg:P.distr==3&&P.log==2?dg:Nf)),g.font=iu(g.font),g.labelFont=iu(g.labelFont),g._size=g.size(n,null,v,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(ri[v]=!0,g._el=Hn(Kp,f))}}function os(g,v,w,P){let[U,X,st,lt]=w,dt=v%2,Rt=0;return dt==0&&(lt||X)&&(Rt=v==0&&!U||v==2&&!st?Ye(Xh.size/3):0),dt==1&&(U||st)&&(Rt=v==1&&!X||v==3&&!lt?Ye($h.size/2):0),Rt}const ao=n.padding=(i.padding||[os,os,os,os]).map(g=>re(pe(g,os))),E=n._padding=ao.map((g,v)=>g(n,v,ri,0));let N,G=null,W=null;const k=s==1?T[0].idxs:null;let ht=null,yt=!1;function Ft(g,v){if(t=g??[],n.data=n._data=t,s==2){N=0;for(let w=1;w<T.length;w++)N+=t[w][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ht=t[0],N=ht.length;let w=t;if($==2){w=t.slice();let P=w[0]=Array(N);for(let U=0;U<N;U++)P[U]=U}n._data=t=w}if(Fs(!0),en("setData"),$==2&&(ue=!0),v!==!1){let w=C;w.auto(n,yt)?Dt():Vi(L,w.min,w.max),F=F||pt.left>=0,et=!0,Os()}}n.setData=Ft;function Dt(){yt=!0;let g,v;s==1&&(N>0?(G=k[0]=0,W=k[1]=N-1,g=t[0][G],v=t[0][W],$==2?(g=G,v=W):g==v&&($==3?[g,v]=ca(g,g,C.log,!1):$==4?[g,v]=Tc(g,g,C.log,!1):C.time?v=g+Ye(86400/d):[g,v]=na(g,v,wc,!0))):(G=k[0]=g=null,W=k[1]=v=null)),Vi(L,g,v)}let Gt,Xt,Ut,se,ve,Se,Je,le,Bt,Ie;function fe(g,v,w,P,U,X){g??=Mh,w??=Rc,P??="butt",U??=Mh,X??="round",g!=Gt&&(u.strokeStyle=Gt=g),U!=Xt&&(u.fillStyle=Xt=U),v!=Ut&&(u.lineWidth=Ut=v),X!=ve&&(u.lineJoin=ve=X),P!=Se&&(u.lineCap=Se=P),w!=se&&u.setLineDash(se=w)}function yn(g,v,w,P){v!=Xt&&(u.fillStyle=Xt=v),g!=Je&&(u.font=Je=g),w!=le&&(u.textAlign=le=w),P!=Bt&&(u.textBaseline=Bt=P)}function oi(g,v,w,P,U=0){if(P.length>0&&g.auto(n,yt)&&(v==null||v.min==null)){let X=pe(G,0),st=pe(W,P.length-1),lt=w.min==null?fm(P,X,st,U,g.distr==3):[w.min,w.max];g.min=ti(g.min,w.min=lt[0]),g.max=xn(g.max,w.max=lt[1])}}const an={min:null,max:null};function as(){for(let P in y){let U=y[P];q[P]==null&&(U.min==null||q[L]!=null&&U.auto(n,yt))&&(q[P]=an)}for(let P in y){let U=y[P];q[P]==null&&U.from!=null&&q[U.from]!=null&&(q[P]=an)}q[L]!=null&&Fs(!0);let g={};for(let P in q){let U=q[P];if(U!=null){let X=g[P]=pr(y[P],Sm);if(U.min!=null)Ve(X,U);else if(P!=L||s==2)if(N==0&&X.from==null){let st=X.range(n,null,null,P);X.min=st[0],X.max=st[1]}else X.min=we,X.max=-we}}if(N>0){T.forEach((P,U)=>{if(s==1){let X=P.scale,st=q[X];if(st==null)return;let lt=g[X];if(U==0){let dt=lt.range(n,lt.min,lt.max,X);lt.min=dt[0],lt.max=dt[1],G=Qn(lt.min,t[0]),W=Qn(lt.max,t[0]),W-G>1&&(t[0][G]<lt.min&&G++,t[0][W]>lt.max&&W--),P.min=ht[G],P.max=ht[W]}else P.show&&P.auto&&oi(lt,st,P,t[U],P.sorted);P.idxs[0]=G,P.idxs[1]=W}else if(U>0&&P.show&&P.auto){let[X,st]=P.facets,lt=X.scale,dt=st.scale,[Rt,Ct]=t[U],Lt=g[lt],qt=g[dt];Lt!=null&&oi(Lt,q[lt],X,Rt,X.sorted),qt!=null&&oi(qt,q[dt],st,Ct,st.sorted),P.min=st.min,P.max=st.max}});for(let P in g){let U=g[P],X=q[P];if(U.from==null&&(X==null||X.min==null)){let st=U.range(n,U.min==we?null:U.min,U.max==-we?null:U.max,P);U.min=st[0],U.max=st[1]}}}for(let P in g){let U=g[P];if(U.from!=null){let X=g[U.from];if(X.min==null)U.min=U.max=null;else{let st=U.range(n,X.min,X.max,P);U.min=st[0],U.max=st[1]}}}let v={},w=!1;for(let P in g){let U=g[P],X=y[P];if(X.min!=U.min||X.max!=U.max){X.min=U.min,X.max=U.max;let st=X.distr;X._min=st==3?Ii(X.min):st==4?Fa(X.min,X.asinh):st==100?X.fwd(X.min):X.min,X._max=st==3?Ii(X.max):st==4?Fa(X.max,X.asinh):st==100?X.fwd(X.max):X.max,v[P]=w=!0}}if(w){T.forEach((P,U)=>{s==2?U>0&&v.y&&(P._paths=null):v[P.scale]&&(P._paths=null)});for(let P in v)ue=!0,en("setScale",P);at&&pt.left>=0&&(F=et=!0)}for(let P in q)q[P]=null}function Te(g){let v=bl(G-1,0,N-1),w=bl(W+1,0,N-1);for(;g[v]==null&&v>0;)v--;for(;g[w]==null&&w<N-1;)w++;return[v,w]}function On(){if(N>0){let g=T.some(v=>v._focus)&&Ie!=Rn.alpha;g&&(u.globalAlpha=Ie=Rn.alpha),T.forEach((v,w)=>{if(w>0&&v.show&&(zi(w,!1),zi(w,!0),v._paths==null)){let P=Ie;Ie!=v.alpha&&(u.globalAlpha=Ie=v.alpha);let U=s==2?[0,t[w][0].length-1]:Te(t[w]);v._paths=v.paths(n,w,U[0],U[1]),Ie!=P&&(u.globalAlpha=Ie=P)}}),T.forEach((v,w)=>{if(w>0&&v.show){let P=Ie;Ie!=v.alpha&&(u.globalAlpha=Ie=v.alpha),v._paths!=null&&un(w,!1);{let U=v._paths!=null?v._paths.gaps:null,X=v.points.show(n,w,G,W,U),st=v.points.filter(n,w,X,U);(X||st)&&(v.points._paths=v.points.paths(n,w,G,W,st),un(w,!0))}Ie!=P&&(u.globalAlpha=Ie=P),en("drawSeries",w)}}),g&&(u.globalAlpha=Ie=1)}}function zi(g,v){let w=v?T[g].points:T[g];w._stroke=w.stroke(n,g),w._fill=w.fill(n,g)}function un(g,v){let w=v?T[g].points:T[g],{stroke:P,fill:U,clip:X,flags:st,_stroke:lt=w._stroke,_fill:dt=w._fill,_width:Rt=w.width}=w._paths;Rt=Ae(Rt*_e,3);let Ct=null,Lt=Rt%2/2;v&&dt==null&&(dt=Rt>0?"#fff":lt);let qt=w.pxAlign==1&&Lt>0;if(qt&&u.translate(Lt,Lt),!v){let ge=vt-Rt/2,de=Nt-Rt/2,ie=Ot+Rt,Wt=Et+Rt;Ct=new Path2D,Ct.rect(ge,de,ie,Wt)}v?Ns(lt,Rt,w.dash,w.cap,dt,P,U,st,X):ai(g,lt,Rt,w.dash,w.cap,dt,P,U,st,Ct,X),qt&&u.translate(-Lt,-Lt)}function ai(g,v,w,P,U,X,st,lt,dt,Rt,Ct){let Lt=!1;dt!=0&&z.forEach((qt,ge)=>{if(qt.series[0]==g){let de=T[qt.series[1]],ie=t[qt.series[1]],Wt=(de._paths||Kr).band;Zi(Wt)&&(Wt=qt.dir==1?Wt[0]:Wt[1]);let zt,Le=null;de.show&&Wt&&pm(ie,G,W)?(Le=qt.fill(n,ge)||X,zt=de._paths.clip):Wt=null,Ns(v,w,P,U,Le,st,lt,dt,Rt,Ct,zt,Wt),Lt=!0}}),Lt||Ns(v,w,P,U,X,st,lt,dt,Rt,Ct)}const Yn=mr|Al;function Ns(g,v,w,P,U,X,st,lt,dt,Rt,Ct,Lt){fe(g,v,w,P,U),(dt||Rt||Lt)&&(u.save(),dt&&u.clip(dt),Rt&&u.clip(Rt)),Lt?(lt&Yn)==Yn?(u.clip(Lt),Ct&&u.clip(Ct),co(U,st),lo(g,X,v)):lt&Al?(co(U,st),u.clip(Lt),lo(g,X,v)):lt&mr&&(u.save(),u.clip(Lt),Ct&&u.clip(Ct),co(U,st),u.restore(),lo(g,X,v)):(co(U,st),lo(g,X,v)),(dt||Rt||Lt)&&u.restore()}function lo(g,v,w){w>0&&(v instanceof Map?v.forEach((P,U)=>{u.strokeStyle=Gt=U,u.stroke(P)}):v!=null&&g&&u.stroke(v))}function co(g,v){v instanceof Map?v.forEach((w,P)=>{u.fillStyle=Xt=P,u.fill(w)}):v!=null&&g&&u.fill(v)}function jd(g,v,w,P){let U=A[g],X;if(P<=0)X=[0,0];else{let st=U._space=U.space(n,g,v,w,P),lt=U._incrs=U.incrs(n,g,v,w,P,st);X=Ng(v,w,lt,P,st)}return U._found=X}function Sa(g,v,w,P,U,X,st,lt,dt,Rt){let Ct=st%2/2;x==1&&u.translate(Ct,Ct),fe(lt,st,dt,Rt,lt),u.beginPath();let Lt,qt,ge,de,ie=U+(P==0||P==3?-X:X);w==0?(qt=U,de=ie):(Lt=U,ge=ie);for(let Wt=0;Wt<g.length;Wt++)v[Wt]!=null&&(w==0?Lt=ge=g[Wt]:qt=de=g[Wt],u.moveTo(Lt,qt),u.lineTo(ge,de));u.stroke(),x==1&&u.translate(-Ct,-Ct)}function Kd(g){let v=!0;return A.forEach((w,P)=>{if(!w.show)return;let U=y[w.scale];if(U.min==null){w._show&&(v=!1,w._show=!1,Fs(!1));return}else w._show||(v=!1,w._show=!0,Fs(!1));let X=w.side,st=X%2,{min:lt,max:dt}=U,[Rt,Ct]=jd(P,lt,dt,st==0?K:H);if(Ct==0)return;let Lt=U.distr==2,qt=w._splits=w.splits(n,P,lt,dt,Rt,Ct,Lt),ge=U.distr==2?qt.map(zt=>ht[zt]):qt,de=U.distr==2?ht[qt[1]]-ht[qt[0]]:Rt,ie=w._values=w.values(n,w.filter(n,ge,P,Ct,de),P,Ct,de);w._rotate=X==2?w.rotate(n,ie,P,Ct):0;let Wt=w._size;w._size=Vn(w.size(n,ie,P,g)),Wt!=null&&w._size!=Wt&&(v=!1)}),v}function Zd(g){let v=!0;return ao.forEach((w,P)=>{let U=w(n,P,ri,g);U!=E[P]&&(v=!1),E[P]=U}),v}function Jd(){for(let g=0;g<A.length;g++){let v=A[g];if(!v.show||!v._show)continue;let w=v.side,P=w%2,U,X,st=v.stroke(n,g),lt=w==0||w==3?-1:1,[dt,Rt]=v._found;if(v.label!=null){let dn=v.labelGap*lt,Ln=Ye((v._lpos+dn)*_e);yn(v.labelFont[0],st,"center",w==2?Ir:xh),u.save(),P==1?(U=X=0,u.translate(Ln,Ye(Nt+Et/2)),u.rotate((w==3?-qo:qo)/2)):(U=Ye(vt+Ot/2),X=Ln);let hs=Uf(v.label)?v.label(n,g,dt,Rt):v.label;u.fillText(hs,U,X),u.restore()}if(Rt==0)continue;let Ct=y[v.scale],Lt=P==0?Ot:Et,qt=P==0?vt:Nt,ge=v._splits,de=Ct.distr==2?ge.map(dn=>ht[dn]):ge,ie=Ct.distr==2?ht[ge[1]]-ht[ge[0]]:dt,Wt=v.ticks,zt=v.border,Le=Wt.show?Wt.size:0,Oe=Ye(Le*_e),nn=Ye((v.alignTo==2?v._size-Le-v.gap:v.gap)*_e),ye=v._rotate*-qo/180,Be=p(v._pos*_e),Cn=(Oe+nn)*lt,fn=Be+Cn;X=P==0?fn:0,U=P==1?fn:0;let Bn=v.font[0],qn=v.align==1?Xs:v.align==2?Ua:ye>0?Xs:ye<0?Ua:P==0?"center":w==3?Ua:Xs,hi=ye||P==1?"middle":w==2?Ir:xh;yn(Bn,st,qn,hi);let Pn=v.font[1]*v.lineGap,kn=ge.map(dn=>p(a(dn,Ct,Lt,qt))),$n=v._values;for(let dn=0;dn<$n.length;dn++){let Ln=$n[dn];if(Ln!=null){P==0?U=kn[dn]:X=kn[dn],Ln=""+Ln;let hs=Ln.indexOf(`
`)==-1?[Ln]:Ln.split(/\n/gm);for(let pn=0;pn<hs.length;pn++){let fh=hs[pn];ye?(u.save(),u.translate(U,X+pn*Pn),u.rotate(ye),u.fillText(fh,0,0),u.restore()):u.fillText(fh,U,X+pn*Pn)}}}Wt.show&&Sa(kn,Wt.filter(n,de,g,Rt,ie),P,w,Be,Oe,Ae(Wt.width*_e,3),Wt.stroke(n,g),Wt.dash,Wt.cap);let ui=v.grid;ui.show&&Sa(kn,ui.filter(n,de,g,Rt,ie),P,P==0?2:1,P==0?Nt:vt,P==0?Et:Ot,Ae(ui.width*_e,3),ui.stroke(n,g),ui.dash,ui.cap),zt.show&&Sa([Be],[1],P==0?1:0,P==0?1:2,P==1?Nt:vt,P==1?Et:Ot,Ae(zt.width*_e,3),zt.stroke(n,g),zt.dash,zt.cap)}en("drawAxes")}function Fs(g){T.forEach((v,w)=>{w>0&&(v._paths=null,g&&(s==1?(v.min=null,v.max=null):v.facets.forEach(P=>{P.min=null,P.max=null})))})}let ho=!1,ya=!1,Rr=[];function Qd(){ya=!1;for(let g=0;g<Rr.length;g++)en(...Rr[g]);Rr.length=0}function Os(){ho||(Rm($c),ho=!0)}function tp(g,v=!1){ho=!0,ya=v,g(n),$c(),v&&Rr.length>0&&queueMicrotask(Qd)}n.batch=tp;function $c(){if(ne&&(as(),ne=!1),ue&&(Kt(),ue=!1),Yt){if(De(m,Xs,tt),De(m,Ir,St),De(m,Vr,K),De(m,Gr,H),De(_,Xs,tt),De(_,Ir,St),De(_,Vr,K),De(_,Gr,H),De(f,Vr,M),De(f,Gr,Y),h.width=Ye(M*_e),h.height=Ye(Y*_e),A.forEach(({_el:g,_show:v,_size:w,_pos:P,side:U})=>{if(g!=null)if(v){let X=U===3||U===0?w:0,st=U%2==1;De(g,st?"left":"top",P-X),De(g,st?"width":"height",w),De(g,st?"top":"left",st?St:tt),De(g,st?"height":"width",st?H:K),yl(g,Ms)}else In(g,Ms)}),Gt=Xt=Ut=ve=Se=Je=le=Bt=se=null,Ie=1,Lr(!0),tt!=_t||St!=Tt||K!=$t||H!=ft){Fs(!1);let g=K/$t,v=H/ft;if(at&&!F&&pt.left>=0){pt.left*=g,pt.top*=v,Bs&&fi(Bs,Ye(pt.left),0,K,H),ks&&fi(ks,0,Ye(pt.top),K,H);for(let w=0;w<on.length;w++){let P=on[w];P!=null&&(Si[w]*=g,yi[w]*=v,fi(P,Vn(Si[w]),Vn(yi[w]),K,H))}}if(Pe.show&&!xt&&Pe.left>=0&&Pe.width>0){Pe.left*=g,Pe.width*=g,Pe.top*=v,Pe.height*=v;for(let w in Ra)De(Vs,w,Pe[w])}_t=tt,Tt=St,$t=K,ft=H}en("setSize"),Yt=!1}M>0&&Y>0&&(u.clearRect(0,0,h.width,h.height),en("drawClear"),I.forEach(g=>g()),en("draw")),Pe.show&&xt&&(uo(Pe),xt=!1),at&&F&&(cs(null,!0,!1),F=!1),Mt.show&&Mt.live&&et&&(wa(),et=!1),l||(l=!0,n.status=1,en("ready")),yt=!1,ho=!1}n.redraw=(g,v)=>{ue=v||!1,g!==!1?Vi(L,C.min,C.max):Os()};function Ea(g,v){let w=y[g];if(w.from==null){if(N==0){let P=w.range(n,v.min,v.max,g);v.min=P[0],v.max=P[1]}if(v.min>v.max){let P=v.min;v.min=v.max,v.max=P}if(N>1&&v.min!=null&&v.max!=null&&v.max-v.min<1e-16)return;g==L&&w.distr==2&&N>0&&(v.min=Qn(v.min,t[0]),v.max=Qn(v.max,t[0]),v.min==v.max&&v.max++),q[g]=v,ne=!0,Os()}}n.setScale=Ea;let ba,Ta,Bs,ks,jc,Kc,zs,Hs,Zc,Jc,Ce,Ne,Hi=!1;const rn=pt.drag;let Qe=rn.x,tn=rn.y;at&&(pt.x&&(ba=Hn(Jp,_)),pt.y&&(Ta=Hn(Qp,_)),C.ori==0?(Bs=ba,ks=Ta):(Bs=Ta,ks=ba),Ce=pt.left,Ne=pt.top);const Pe=n.select=Ve({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Vs=Pe.show?Hn(Zp,Pe.over?_:m):null;function uo(g,v){if(Pe.show){for(let w in g)Pe[w]=g[w],w in Ra&&De(Vs,w,g[w]);v!==!1&&en("setSelect")}}n.setSelect=uo;function ep(g){if(T[g].show)it&&yl(It[g],Ms);else if(it&&In(It[g],Ms),at){let w=Sn?on[0]:on[g];w!=null&&fi(w,-10,-10,K,H)}}function Vi(g,v,w){Ea(g,{min:v,max:w})}function li(g,v,w,P){v.focus!=null&&op(g),v.show!=null&&T.forEach((U,X)=>{X>0&&(g==X||g==null)&&(U.show=v.show,ep(X),s==2?(Vi(U.facets[0].scale,null,null),Vi(U.facets[1].scale,null,null)):Vi(U.scale,null,null),Os())}),w!==!1&&en("setSeries",g,v),P&&Dr("setSeries",n,g,v)}n.setSeries=li;function np(g,v){Ve(z[g],v)}function ip(g,v){g.fill=re(g.fill||null),g.dir=pe(g.dir,-1),v=v??z.length,z.splice(v,0,g)}function sp(g){g==null?z.length=0:z.splice(g,1)}n.addBand=ip,n.setBand=np,n.delBand=sp;function rp(g,v){T[g].alpha=v,at&&on[g]!=null&&(on[g].style.opacity=v),it&&It[g]&&(It[g].style.opacity=v)}let Ei,Gi,ls;const Gs={focus:!0};function op(g){if(g!=ls){let v=g==null,w=Rn.alpha!=1;T.forEach((P,U)=>{if(s==1||U>0){let X=v||U==0||U==g;P._focus=v?null:X,w&&rp(U,X?1:Rn.alpha)}}),ls=g,w&&Os()}}it&&Mi&&Pt(Eh,ot,g=>{pt._lock||(We(g),ls!=null&&li(null,Gs,!0,ze.setSeries))});function ci(g,v,w){let P=y[v];w&&(g=g/_e-(P.ori==1?St:tt));let U=K;P.ori==1&&(U=H,g=U-g),P.dir==-1&&(g=U-g);let X=P._min,st=P._max,lt=g/U,dt=X+(st-X)*lt,Rt=P.distr;return Rt==3?fr(10,dt):Rt==4?gm(dt,P.asinh):Rt==100?P.bwd(dt):dt}function ap(g,v){let w=ci(g,L,v);return Qn(w,t[0],G,W)}n.valToIdx=g=>Qn(g,t[0]),n.posToIdx=ap,n.posToVal=ci,n.valToPos=(g,v,w)=>y[v].ori==0?r(g,y[v],w?Ot:K,w?vt:0):o(g,y[v],w?Et:H,w?Nt:0),n.setCursor=(g,v,w)=>{Ce=g.left,Ne=g.top,cs(null,v,w)};function Qc(g,v){De(Vs,Xs,Pe.left=g),De(Vs,Vr,Pe.width=v)}function th(g,v){De(Vs,Ir,Pe.top=g),De(Vs,Gr,Pe.height=v)}let Cr=C.ori==0?Qc:th,Pr=C.ori==1?Qc:th;function lp(){if(it&&Mt.live)for(let g=s==2?1:0;g<T.length;g++){if(g==0&&ae)continue;let v=Mt.values[g],w=0;for(let P in v)oe[g][w++].firstChild.nodeValue=v[P]}}function wa(g,v){if(g!=null&&(g.idxs?g.idxs.forEach((w,P)=>{mt[P]=w}):Mm(g.idx)||mt.fill(g.idx),Mt.idx=mt[0]),it&&Mt.live){for(let w=0;w<T.length;w++)(w>0||s==1&&!ae)&&cp(w,mt[w]);lp()}et=!1,v!==!1&&en("setLegend")}n.setLegend=wa;function cp(g,v){let w=T[g],P=g==0&&$==2?ht:t[g],U;ae?U=w.values(n,g,v)??B:(U=w.value(n,v==null?null:P[v],g,v),U=U==null?B:{_:U}),Mt.values[g]=U}function cs(g,v,w){Zc=Ce,Jc=Ne,[Ce,Ne]=pt.move(n,Ce,Ne),pt.left=Ce,pt.top=Ne,at&&(Bs&&fi(Bs,Ye(Ce),0,K,H),ks&&fi(ks,0,Ye(Ne),K,H));let P,U=G>W;Ei=we,Gi=null;let X=C.ori==0?K:H,st=C.ori==1?K:H;if(Ce<0||N==0||U){P=pt.idx=null;for(let lt=0;lt<T.length;lt++){let dt=on[lt];dt!=null&&fi(dt,-10,-10,K,H)}Mi&&li(null,Gs,!0,g==null&&ze.setSeries),Mt.live&&(mt.fill(P),et=!0)}else{let lt,dt,Rt;s==1&&(lt=C.ori==0?Ce:Ne,dt=ci(lt,L),P=pt.idx=Qn(dt,t[0],G,W),Rt=O(t[0][P],C,X,0));let Ct=-10,Lt=-10,qt=0,ge=0,de=!0,ie="",Wt="";for(let zt=s==2?1:0;zt<T.length;zt++){let Le=T[zt],Oe=mt[zt],nn=Oe==null?null:s==1?t[zt][Oe]:t[zt][1][Oe],ye=pt.dataIdx(n,zt,P,dt),Be=ye==null?null:s==1?t[zt][ye]:t[zt][1][ye];if(et=et||Be!=nn||ye!=Oe,mt[zt]=ye,zt>0&&Le.show){let Cn=ye==null?-10:ye==P?Rt:O(s==1?t[0][ye]:t[zt][0][ye],C,X,0),fn=Be==null?-10:Z(Be,s==1?y[Le.scale]:y[Le.facets[1].scale],st,0);if(Mi&&Be!=null){let Bn=C.ori==1?Ce:Ne,qn=qe(Rn.dist(n,zt,ye,fn,Bn));if(qn<Ei){let hi=Rn.bias;if(hi!=0){let Pn=ci(Bn,Le.scale),kn=Be>=0?1:-1,$n=Pn>=0?1:-1;$n==kn&&($n==1?hi==1?Be>=Pn:Be<=Pn:hi==1?Be<=Pn:Be>=Pn)&&(Ei=qn,Gi=zt)}else Ei=qn,Gi=zt}}if(et||Sn){let Bn,qn;C.ori==0?(Bn=Cn,qn=fn):(Bn=fn,qn=Cn);let hi,Pn,kn,$n,ui,dn,Ln=!0,hs=Re.bbox;if(hs!=null){Ln=!1;let pn=hs(n,zt);kn=pn.left,$n=pn.top,hi=pn.width,Pn=pn.height}else kn=Bn,$n=qn,hi=Pn=Re.size(n,zt);if(dn=Re.fill(n,zt),ui=Re.stroke(n,zt),Sn)zt==Gi&&Ei<=Rn.prox&&(Ct=kn,Lt=$n,qt=hi,ge=Pn,de=Ln,ie=dn,Wt=ui);else{let pn=on[zt];pn!=null&&(Si[zt]=kn,yi[zt]=$n,Ph(pn,hi,Pn,Ln),Rh(pn,dn,ui),fi(pn,Vn(kn),Vn($n),K,H))}}}}if(Sn){let zt=Rn.prox,Le=ls==null?Ei<=zt:Ei>zt||Gi!=ls;if(et||Le){let Oe=on[0];Oe!=null&&(Si[0]=Ct,yi[0]=Lt,Ph(Oe,qt,ge,de),Rh(Oe,ie,Wt),fi(Oe,Vn(Ct),Vn(Lt),K,H))}}}if(Pe.show&&Hi)if(g!=null){let[lt,dt]=ze.scales,[Rt,Ct]=ze.match,[Lt,qt]=g.cursor.sync.scales,ge=g.cursor.drag;if(Qe=ge._x,tn=ge._y,Qe||tn){let{left:de,top:ie,width:Wt,height:zt}=g.select,Le=g.scales[Lt].ori,Oe=g.posToVal,nn,ye,Be,Cn,fn,Bn=lt!=null&&Rt(lt,Lt),qn=dt!=null&&Ct(dt,qt);Bn&&Qe?(Le==0?(nn=de,ye=Wt):(nn=ie,ye=zt),Be=y[lt],Cn=O(Oe(nn,Lt),Be,X,0),fn=O(Oe(nn+ye,Lt),Be,X,0),Cr(ti(Cn,fn),qe(fn-Cn))):Cr(0,X),qn&&tn?(Le==1?(nn=de,ye=Wt):(nn=ie,ye=zt),Be=y[dt],Cn=Z(Oe(nn,qt),Be,st,0),fn=Z(Oe(nn+ye,qt),Be,st,0),Pr(ti(Cn,fn),qe(fn-Cn))):Pr(0,st)}else Ca()}else{let lt=qe(Zc-jc),dt=qe(Jc-Kc);if(C.ori==1){let qt=lt;lt=dt,dt=qt}Qe=rn.x&&lt>=rn.dist,tn=rn.y&&dt>=rn.dist;let Rt=rn.uni;Rt!=null?Qe&&tn&&(Qe=lt>=Rt,tn=dt>=Rt,!Qe&&!tn&&(dt>lt?tn=!0:Qe=!0)):rn.x&&rn.y&&(Qe||tn)&&(Qe=tn=!0);let Ct,Lt;Qe&&(C.ori==0?(Ct=zs,Lt=Ce):(Ct=Hs,Lt=Ne),Cr(ti(Ct,Lt),qe(Lt-Ct)),tn||Pr(0,st)),tn&&(C.ori==1?(Ct=zs,Lt=Ce):(Ct=Hs,Lt=Ne),Pr(ti(Ct,Lt),qe(Lt-Ct)),Qe||Cr(0,X)),!Qe&&!tn&&(Cr(0,0),Pr(0,0))}if(rn._x=Qe,rn._y=tn,g==null){if(w){if(uh!=null){let[lt,dt]=ze.scales;ze.values[0]=lt!=null?ci(C.ori==0?Ce:Ne,lt):null,ze.values[1]=dt!=null?ci(C.ori==1?Ce:Ne,dt):null}Dr(Ia,n,Ce,Ne,K,H,P)}if(Mi){let lt=w&&ze.setSeries,dt=Rn.prox;ls==null?Ei<=dt&&li(Gi,Gs,!0,lt):Ei>dt?li(null,Gs,!0,lt):Gi!=ls&&li(Gi,Gs,!0,lt)}}et&&(Mt.idx=P,wa()),v!==!1&&en("setCursor")}let Wi=null;Object.defineProperty(n,"rect",{get(){return Wi==null&&Lr(!1),Wi}});function Lr(g=!1){g?Wi=null:(Wi=_.getBoundingClientRect(),en("syncRect",Wi))}function eh(g,v,w,P,U,X,st){pt._lock||Hi&&g!=null&&g.movementX==0&&g.movementY==0||(Aa(g,v,w,P,U,X,st,!1,g!=null),g!=null?cs(null,!0,!0):cs(v,!0,!1))}function Aa(g,v,w,P,U,X,st,lt,dt){if(Wi==null&&Lr(!1),We(g),g!=null)w=g.clientX-Wi.left,P=g.clientY-Wi.top;else{if(w<0||P<0){Ce=-10,Ne=-10;return}let[Rt,Ct]=ze.scales,Lt=v.cursor.sync,[qt,ge]=Lt.values,[de,ie]=Lt.scales,[Wt,zt]=ze.match,Le=v.axes[0].side%2==1,Oe=C.ori==0?K:H,nn=C.ori==1?K:H,ye=Le?X:U,Be=Le?U:X,Cn=Le?P:w,fn=Le?w:P;if(de!=null?w=Wt(Rt,de)?a(qt,y[Rt],Oe,0):-10:w=Oe*(Cn/ye),ie!=null?P=zt(Ct,ie)?a(ge,y[Ct],nn,0):-10:P=nn*(fn/Be),C.ori==1){let Bn=w;w=P,P=Bn}}dt&&(v==null||v.cursor.event.type==Ia)&&((w<=1||w>=K-1)&&(w=_s(w,K)),(P<=1||P>=H-1)&&(P=_s(P,H))),lt?(jc=w,Kc=P,[zs,Hs]=pt.move(n,w,P)):(Ce=w,Ne=P)}const Ra={width:0,height:0,left:0,top:0};function Ca(){uo(Ra,!1)}let nh,ih,sh,rh;function oh(g,v,w,P,U,X,st){Hi=!0,Qe=tn=rn._x=rn._y=!1,Aa(g,v,w,P,U,X,st,!0,!1),g!=null&&(Pt(Na,Ml,ah,!1),Dr(Sh,n,zs,Hs,K,H,null));let{left:lt,top:dt,width:Rt,height:Ct}=Pe;nh=lt,ih=dt,sh=Rt,rh=Ct}function ah(g,v,w,P,U,X,st){Hi=rn._x=rn._y=!1,Aa(g,v,w,P,U,X,st,!1,!0);let{left:lt,top:dt,width:Rt,height:Ct}=Pe,Lt=Rt>0||Ct>0,qt=nh!=lt||ih!=dt||sh!=Rt||rh!=Ct;if(Lt&&qt&&uo(Pe),rn.setScale&&Lt&&qt){let ge=lt,de=Rt,ie=dt,Wt=Ct;if(C.ori==1&&(ge=dt,de=Ct,ie=lt,Wt=Rt),Qe&&Vi(L,ci(ge,L),ci(ge+de,L)),tn)for(let zt in y){let Le=y[zt];zt!=L&&Le.from==null&&Le.min!=we&&Vi(zt,ci(ie+Wt,zt),ci(ie,zt))}Ca()}else pt.lock&&(pt._lock=!pt._lock,cs(v,!0,g!=null));g!=null&&(R(Na,Ml),Dr(Na,n,Ce,Ne,K,H,null))}function hp(g,v,w,P,U,X,st){if(pt._lock)return;We(g);let lt=Hi;if(Hi){let dt=!0,Rt=!0,Ct=10,Lt,qt;C.ori==0?(Lt=Qe,qt=tn):(Lt=tn,qt=Qe),Lt&&qt&&(dt=Ce<=Ct||Ce>=K-Ct,Rt=Ne<=Ct||Ne>=H-Ct),Lt&&dt&&(Ce=Ce<zs?0:K),qt&&Rt&&(Ne=Ne<Hs?0:H),cs(null,!0,!0),Hi=!1}Ce=-10,Ne=-10,mt.fill(null),cs(null,!0,!0),lt&&(Hi=lt)}function lh(g,v,w,P,U,X,st){pt._lock||(We(g),Dt(),Ca(),g!=null&&Dr(bh,n,Ce,Ne,K,H,null))}function ch(){A.forEach(Fg),rt(n.width,n.height,!0)}ws(ea,lr,ch);const Ws={};Ws.mousedown=oh,Ws.mousemove=eh,Ws.mouseup=ah,Ws.dblclick=lh,Ws.setSeries=(g,v,w,P)=>{let U=ze.match[2];w=U(n,v,w),w!=-1&&li(w,P,!0,!1)},at&&(Pt(Sh,_,oh),Pt(Ia,_,eh),Pt(yh,_,g=>{We(g),Lr(!1)}),Pt(Eh,_,hp),Pt(bh,_,lh),Rl.add(n),n.syncRect=Lr);const fo=n.hooks=i.hooks||{};function en(g,v,w){ya?Rr.push([g,v,w]):g in fo&&fo[g].forEach(P=>{P.call(null,n,v,w)})}(i.plugins||[]).forEach(g=>{for(let v in g.hooks)fo[v]=(fo[v]||[]).concat(g.hooks[v])});const hh=(g,v,w)=>w,ze=Ve({key:null,setSeries:!1,filters:{pub:Nh,sub:Nh},scales:[L,T[1]?T[1].scale:null],match:[Fh,Fh,hh],values:[null,null]},pt.sync);ze.match.length==2&&ze.match.push(hh),pt.sync=ze;const uh=ze.key,Pa=id(uh);function Dr(g,v,w,P,U,X,st){ze.filters.pub(g,v,w,P,U,X,st)&&Pa.pub(g,v,w,P,U,X,st)}Pa.sub(n);function up(g,v,w,P,U,X,st){ze.filters.sub(g,v,w,P,U,X,st)&&Ws[g](null,v,w,P,U,X,st)}n.pub=up;function fp(){Pa.unsub(n),Rl.delete(n),he.clear(),El(ea,lr,ch),c.remove(),ot?.remove(),en("destroy")}n.destroy=fp;function La(){en("init",i,t),Ft(t||i.data,!1),q[L]?Ea(L,q[L]):Dt(),xt=Pe.show&&(Pe.width>0||Pe.height>0),F=et=!0,rt(i.width,i.height)}return T.forEach(Ar),A.forEach(Ma),e?e instanceof HTMLElement?(e.appendChild(c),La()):e(n,La):La(),n}hn.assign=Ve;hn.fmtNum=Ac;hn.rangeNum=na;hn.rangeLog=ca;hn.rangeAsinh=Tc;hn.orient=Ls;hn.pxRatio=_e;hn.join=Am;hn.fmtDate=Cc,hn.tzDate=Bm;hn.sync=id;{hn.addGap=Mg,hn.clipGaps=fa;let i=hn.paths={points:cd};i.linear=ud,i.stepped=Eg,i.bars=bg,i.spline=wg}const Pl=[.0506,7.378],Og=[{title:"Position / m",curves:[{label:"x",of:i=>i.x},{label:"y",of:i=>i.y}]},{title:"Speed / (m/s)",curves:[{label:"speed",of:i=>i.speed},{label:"vx",of:i=>i.vx},{label:"vy",of:i=>i.vy}]},{title:"Innovation (NIS), 95 % band shaded",curves:[{label:"NIS",of:i=>i.detection>=0?Math.min(i.nis,25):null,band:Pl}]},{title:"Probability",curves:[{label:"of its class",of:i=>i.classProbability},{label:"that it moves",of:i=>i.movingProbability}]}];class Bg{constructor(t){this.goTo=t}element=nt("div",{class:"charts"});plots=[];time=0;show(t,e){this.clear();const n=Math.max(200,this.element.clientWidth||300);for(const s of Og){const r=[t.map(a=>a.time),...s.curves.map(a=>t.map(a.of))],o=new hn(this.options(s,e,n),r,this.element);o.over.addEventListener("click",()=>{const a=o.posToVal(o.cursor.left??0,"x");Number.isFinite(a)&&this.goTo(a)}),this.plots.push(o)}}setTime(t){this.time=t;for(const e of this.plots)e.redraw(!1,!1)}clear(){for(const t of this.plots)t.destroy();this.plots=[],this.element.replaceChildren()}options(t,e,n){const s=si[e],r=[s.accent,s.events[1],s.events[0]],o={stroke:s.faint,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid}};return{title:t.title,width:n,height:130,cursor:{sync:{key:"track"},drag:{x:!1,y:!1}},legend:{live:!0},scales:{x:{time:!1}},axes:[{...o,size:26},{...o,size:46}],series:[{label:"t / s",value:(a,l)=>l===null?"":l.toFixed(2)},...t.curves.map((a,l)=>({label:a.label,stroke:r[l]??s.text,width:1.5,dash:l===0?[]:l===1?[6,3]:[2,2],points:{show:!1},value:(c,h)=>h===null?"":h.toPrecision(4)}))],hooks:{drawAxes:[a=>t.curves.forEach(l=>l.band&&kg(a,l.band,s.raised))],draw:[a=>zg(a,this.time,s.text)]}}}}function kg(i,[t,e],n){const{left:s,width:r}=i.bbox,o=Math.max(i.valToPos(e,"y",!0),i.bbox.top),a=i.valToPos(t,"y",!0);i.ctx.fillStyle=n,i.ctx.fillRect(s,o,r,a-o)}function zg(i,t,e){const n=i.valToPos(t,"x",!0);n>=i.bbox.left&&n<=i.bbox.left+i.bbox.width&&(i.ctx.fillStyle=e,i.ctx.fillRect(n,i.bbox.top,Math.max(1,window.devicePixelRatio),i.bbox.height))}const su=180/Math.PI;class Hg{constructor(t,e,n,s){this.settings=t,this.names=e,this.select=s,this.charts=new Bg(n),this.element.append(this.hint,this.numbers,this.charts.element,nt("h3",{},"In this frame"),this.list)}element=nt("section",{class:"panel","aria-label":"Track"});numbers=nt("div");hint=nt("p",{class:"hint"},"Click a track in the scene, or a name in the list, to see its history.");list=nt("ul",{class:"tracks"});charts;samples=[];showFrame(t){const e=t.tracks.find(n=>n.id===this.settings.selected);this.hint.hidden=this.settings.selected!==null,this.settings.selected===null?vn(this.numbers):vn(this.numbers,...this.describe(e,t)),this.charts.setTime(t.time),this.showList(t)}showHistory(t){t.track===this.settings.selected&&(this.samples=t.samples,this.charts.show(t.samples,this.settings.theme))}restyle(){this.settings.selected===null?this.charts.clear():this.samples.length>0&&this.charts.show(this.samples,this.settings.theme)}clear(){this.samples=[],this.charts.clear()}get life(){const t=this.samples[0],e=this.samples[this.samples.length-1];return t&&e&&this.settings.selected!==null?[t.frame,e.frame]:null}describe(t,e){const n=nt("h2",{},`Track ${this.settings.selected}`,nt("button",{type:"button",class:"small",onclick:()=>this.select(null)},"Deselect"));if(!t)return[n,nt("p",{class:"hint"},"Not in this frame.")];const s=t.nis>=Pl[0]&&t.nis<=Pl[1],r=Rf(e,t.id),o=r===0?0:e.clusters.reduce((c,h)=>c+(h===r?1:0),0),a=[["class",`${this.names.classes[t.class]??"?"}, ${(100*t.classProbability).toFixed(0)} %`],["status",`${this.names.statuses[t.status]??"?"}, ${t.age} frames old`],["speed",`${t.speed.toFixed(2)} m/s, moves: ${(100*t.movingProbability).toFixed(0)} %`],["heading",`${(t.heading*su).toFixed(1)} deg, turns ${(t.yawRate*su).toFixed(1)} deg/s`],["size",`${t.length.toFixed(2)} x ${t.width.toFixed(2)} m`],["position",`${t.x.toFixed(2)}, ${t.y.toFixed(2)} m`],["1 sigma",`${Math.sqrt(t.covariance[0]).toFixed(2)}, ${Math.sqrt(t.covariance[2]).toFixed(2)} m`],["seen by",t.detection<0?"nothing in this scan":`${o} returns (marked)`],["innovation",t.detection<0?"-":`NIS ${t.nis.toFixed(2)}, ${s?"inside":"outside"} its 95 % band`]],l=nt("dl",{class:"facts"});for(const[c,h]of a)l.append(nt("dt",{},c),nt("dd",{},h));return[n,l]}showList(t){const e=t.tracks.filter(n=>this.settings.shown.tentative||n.status!==0);vn(this.list,...e.slice(0,60).map(n=>{const s=`${n.id} ${this.names.classes[n.class]??"?"}, ${n.speed.toFixed(1)} m/s`,r=n.id===this.settings.selected;return nt("li",{},nt("button",{type:"button",class:r?"row chosen":"row","aria-pressed":r?"true":"false",onclick:()=>this.select(n.id)},s))})),e.length===0&&vn(this.list,nt("li",{class:"hint"},`no confirmed tracks at ${Ts(t.time)}`))}}function ru(i){const t=/^(\S+) \.\. (\S+)$/.exec(i);if(!t)return null;const e=Number(t[1]),n=Number(t[2]);return Number.isFinite(e)&&Number.isFinite(n)?[e,n]:null}class Vg{constructor(t){this.changed=t,this.filter.addEventListener("input",()=>this.applyFilter()),this.element.append(this.filter,this.list)}element=nt("div",{class:"options"});filter=nt("input",{type:"search",placeholder:"Find an option","aria-label":"Find an option"});list=nt("div");options=[];values=new Map;show(t){this.options=t,this.values.clear(),this.draw()}get changes(){return[...this.values].map(([t,e])=>`${t}=${e}`)}reset(){this.values.clear(),this.draw()}draw(){const t=new Map;for(const e of this.options)t.set(e.section,[...t.get(e.section)??[],e]);this.list.replaceChildren(...[...t].map(([e,n])=>{const s=nt("details",{"data-section":e},nt("summary",{},e));for(const r of n)s.append(this.row(r));return s})),this.applyFilter()}row(t){const e=`${t.section}.${t.name}`,n=`option-${e}`,s=this.field(t,n),r=nt("div",{class:"option","data-key":e},nt("label",{for:n,title:t.doc},t.name),s,nt("p",{class:"hint"},`${t.doc}. Range: ${t.range||"any text"}; default ${t.fallback}.`));return r.classList.toggle("differs",t.value!==t.fallback),s.addEventListener("change",()=>this.take(t,e,r,s)),r}take(t,e,n,s){const r=s instanceof HTMLInputElement&&s.type==="checkbox"?String(s.checked):s.value.trim(),o=ru(t.range),a=Number(r),l=o!==null&&!(r!==""&&a>=o[0]&&a<=o[1]);s.setAttribute("aria-invalid",String(l)),!l&&(r===t.value?this.values.delete(e):this.values.set(e,r),n.classList.toggle("changed",this.values.has(e)),this.changed())}field(t,e){if(t.range==="true | false")return nt("input",{id:e,type:"checkbox",checked:t.value==="true"});if(t.range.includes(" | ")){const n=nt("select",{id:e});for(const s of t.range.split(" | "))n.append(nt("option",{value:s,selected:s===t.value},s));return n}return nt("input",{id:e,type:"text",inputmode:ru(t.range)?"decimal":"text",value:t.value,autocomplete:"off"})}applyFilter(){const t=this.filter.value.trim().toLowerCase();for(const e of this.list.querySelectorAll("details")){let n=!1;for(const s of e.querySelectorAll(".option")){const r=t===""||(s.textContent??"").toLowerCase().includes(t)||(s.dataset.key??"").includes(t);s.hidden=!r,n||=r}e.hidden=!n,t!==""&&(e.open=n)}}}const Gg=[["MOTA",i=>i.clear.MOTA,3,!0],["HOTA",i=>i.hota.HOTA,3,!0],["IDF1",i=>i.identity.IDF1,3,!0],["identity switches",i=>i.clear.IDSW,0,!1],["position RMSE / m",i=>i.rmse.position_m,3,!1],["velocity RMSE / (m/s)",i=>i.rmse.velocity_m_per_s,3,!1],["GOSPA / m",i=>i.gospa.gospa_m,3,!1],["false tracks a frame",i=>i.ghosts_per_frame,3,!1]];class Wg{constructor(t,e,n){this.ask=t,this.frameShown=e,this.compare=n,this.form=new Vg(()=>this.schedule());const s=(r,o,a="")=>nt("button",{type:"button",class:a,onclick:o},r);this.element.append(nt("p",{class:"hint"},"Change a value: the recording is run again from this frame, and shown at the right."),this.preset,nt("div",{class:"line"},s("Try from here",()=>this.start(),"primary"),s("End trial",()=>this.end()),s("Undo changes",()=>this.form.reset()),s("Export configuration",()=>t({op:"export",run:this.trialExists?1:0}))),this.state,this.table,this.form.element)}element=nt("section",{class:"panel","aria-label":"Tune"});form;state=nt("p",{class:"state",role:"status"});table=nt("div",{class:"metrics"});preset=nt("div",{class:"line"});chosen="";timer=0;scored=-1;hasTruth=!1;trialExists=!1;greet(t){vn(this.preset,"Start from ",Zr(t.presets,t.preset,"Preset",e=>{this.chosen=e,this.ask({op:"options",preset:e}),this.schedule()})),this.ask({op:"options"})}showOptions(t){this.form.show(t.options)}showStatus(t){if(this.hasTruth=t.has_truth,this.trialExists=t.trial_end!==void 0,t.trial_end===void 0||t.trial_from===void 0){this.state.textContent="",vn(this.table),this.scored=-1;return}const e=Math.max(0,t.trial_end-t.trial_from);this.state.textContent=`${t.trial_runs?"Running":"Done"}: ${e} frames from ${t.trial_from} on, ${t.trial_confirmed??0} tracks (all of the main run: ${t.confirmed}).`,(!t.trial_runs||t.trial_end>this.scored+200)&&t.trial_end!==this.scored&&(this.scored=t.trial_end,this.ask({op:"metrics"}))}showMetrics(t){if(!this.hasTruth||!t.main){vn(this.table,nt("p",{class:"hint"},"Without truth there are no metrics: compare by eye, or give --truth."));return}const e=t.main,n=Gg.map(([s,r,o,a])=>{const l=r(e)??null,c=t.trial?r(t.trial)??null:null,h=l===null||c===null||l===c?"":c>l===a?" better":" worse",u=f=>f===null?"-":f.toFixed(o);return nt("tr",{},nt("th",{scope:"row"},s),nt("td",{},u(l)),nt("td",{class:h.trim()},u(c),h===""?"":nt("small",{},h)))});vn(this.table,nt("table",{},nt("caption",{},`Against truth, frames ${t.from} to ${t.end-1}`),nt("thead",{},nt("tr",{},nt("th",{}),nt("th",{scope:"col"},"left"),nt("th",{scope:"col"},"right (trial)"))),nt("tbody",{},...n)))}saveExport(t){bf("scanfuse.toml",t,"application/toml")}schedule(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.start(),400)}start(){this.scored=-1,this.compare(!0);const t=this.chosen===""?{}:{preset:this.chosen};this.ask({op:"tune",from:this.frameShown(),changes:this.form.changes,...t})}end(){clearTimeout(this.timer),this.compare(!1),this.ask({op:"stop_tune"})}}class Xg{moved=new Ui;changed=new Ui;frame=0;playing=!1;speed=1;live=!1;due=0;times=[];clock=0;setTimes(t,e){this.times.length=Math.min(this.times.length,t);for(const n of e)this.times.push(n);this.changed.emit()}get count(){return this.times.length}get time(){return this.times[this.frame]??0}get duration(){return this.times[this.times.length-1]??0}timeOf(t){return this.times[t]??0}frameAt(t){let e=0,n=this.times.length-1;for(;e<n;){const s=e+n+1>>1;(this.times[s]??0)<=t?e=s:n=s-1}return e}seek(t){const e=Math.max(0,Math.min(t,this.count-1));this.clock=this.timeOf(e),e!==this.frame&&(this.frame=e,this.moved.emit(e))}step(t){this.pause(),this.seek(this.frame+t)}toggle(){this.playing?this.pause():this.play()}play(){!this.live&&this.frame>=this.count-1&&this.seek(0),this.clock=this.time,this.playing=!0,this.changed.emit()}pause(){this.playing&&(this.playing=!1,this.changed.emit())}setSpeed(t){this.speed=t,this.changed.emit()}advance(t,e){if(!this.playing)return;if(this.live)return this.catchUp(e);const n=this.clock+Math.min(t,.25)*this.speed,s=this.frameAt(n);s!==this.frame&&!e(s)||(this.clock=n,s!==this.frame&&(this.frame=s,this.moved.emit(s)),s>=this.count-1&&this.pause())}catchUp(t){this.due<=this.frame&&(this.due=this.count-1),this.due>this.frame&&t(this.due)&&this.seek(this.due)}}function ou(i){const t=document.documentElement;t.dataset.theme=i;const e=si[i];for(const[n,s]of Object.entries(e))typeof s=="string"&&t.style.setProperty(`--${n}`,s);e.classes.forEach((n,s)=>t.style.setProperty(`--class-${s}`,n))}const au=11,lu=8,vo=52,Yg=400;class qg{constructor(t,e){this.player=t,this.settings=e,this.element.append(this.canvas,this.tip),this.tip.hidden=!0,new ResizeObserver(()=>this.draw()).observe(this.element),t.changed.on(()=>this.draw()),t.moved.on(()=>this.draw()),this.listen()}element=nt("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0"});events=[];life=null;trial=null;canvas=nt("canvas");tip=nt("div",{class:"tip",role:"status"});draw(){const t=window.devicePixelRatio,e=this.element.clientWidth,n=this.element.clientHeight;this.canvas.width=e*t,this.canvas.height=n*t;const s=this.canvas.getContext("2d");if(!s)return;s.scale(t,t);const r=si[this.settings.theme];s.clearRect(0,0,e,n),this.trial&&this.bar(s,this.trial,n-6,5,r.warning),this.life&&this.bar(s,this.life,lu+4*au+2,4,r.selected),this.drawEvents(s,r.events),this.drawTicks(s,e,n,r.faint),s.fillStyle=r.accent;const o=this.xOf(this.player.frame);s.fillRect(o-1,0,2,n),this.element.setAttribute("aria-valuemax",String(Math.max(0,this.player.count-1))),this.element.setAttribute("aria-valuenow",String(this.player.frame)),this.element.setAttribute("aria-valuetext",Ts(this.player.time))}nextEvent(t){const e=this.events.filter(n=>t*(n.frame-this.player.frame)>0);return e.sort((n,s)=>t*(n.frame-s.frame)),e[0]??null}xOf(t){return this.xAt(this.player.timeOf(t))}xAt(t){const e=this.element.clientWidth-vo-6;return vo+t/Math.max(1e-9,this.player.duration)*e}bar(t,[e,n],s,r,o){t.fillStyle=o;const a=this.xOf(e);t.fillRect(a,s,Math.max(2,this.xOf(n)-a),r)}drawEvents(t,e){const n=Da.map(()=>new Set);for(const s of this.events){const r=n[s.kind];!r||r.size>Yg*4||r.add(Math.round(this.xOf(s.frame)))}n.forEach((s,r)=>{t.fillStyle=e[r]??"#888888";const o=lu+r*au;t.font="11px system-ui, sans-serif",t.fillText(Da[r]??"",6,o+3);for(const a of s)$g(t,r,a,o)})}drawTicks(t,e,n,s){const r=this.player.duration,a=[.5,1,2,5,10,30,60,120,300,600,1800,3600].find(l=>l/Math.max(r,1e-9)*e>70)??7200;t.fillStyle=s,t.font="11px system-ui, sans-serif";for(let l=0;l<=r;l+=a){const c=this.xAt(l);t.fillRect(c,n-16,1,4),c<e-40&&t.fillText(Ts(l).replace(/\.0$/,""),c+3,n-8)}}listen(){let t=!1;const e=n=>{const s=this.element.getBoundingClientRect(),r=(n.clientX-s.left-vo)/Math.max(1,s.width-vo-6);return this.player.frameAt(r*this.player.duration)};this.element.addEventListener("pointerdown",n=>{t=!0,this.element.setPointerCapture(n.pointerId),this.player.seek(e(n))}),this.element.addEventListener("pointermove",n=>{t&&this.player.seek(e(n)),this.showTip(n,e(n))}),this.element.addEventListener("pointerup",()=>t=!1),this.element.addEventListener("pointerleave",()=>this.tip.hidden=!0)}showTip(t,e){const n=this.element.getBoundingClientRect(),s=t.clientX-n.left,o=this.events.filter(l=>Math.abs(this.xOf(l.frame)-s)<4).slice(0,4).map(l=>`${Da[l.kind]??""} of ${l.track}`);this.tip.textContent=[Ts(this.player.timeOf(e)),...o].join(", "),this.tip.hidden=!1;const a=Math.min(s,n.width-this.tip.offsetWidth-4);this.tip.style.transform=`translateX(${a.toFixed(0)}px)`}}function $g(i,t,e,n){i.beginPath(),t===0?(i.moveTo(e,n-3.5),i.lineTo(e+3.5,n+3.5),i.lineTo(e-3.5,n+3.5),i.fill()):t===1?i.fillRect(e-3.5,n-1,2*3.5,2.5):t===2?(i.strokeStyle=i.fillStyle,i.lineWidth=1.6,i.moveTo(e-3.5,n-3.5),i.lineTo(e+3.5,n+3.5),i.moveTo(e+3.5,n-3.5),i.lineTo(e-3.5,n+3.5),i.stroke()):(i.strokeStyle=i.fillStyle,i.lineWidth=2,i.arc(e,n,3.5,0,2*Math.PI),i.stroke())}function jg(i){const{player:t,settings:e,stage:n}=i,s=o=>{const a=Yo.indexOf(t.speed);t.setSpeed(Yo[Math.max(0,Math.min(Yo.length-1,a+o))]??1)},r=o=>e.change(a=>a.shown[o]=!a.shown[o]);return[{keys:[" "],says:"play or pause",act:()=>t.toggle()},{keys:["ArrowLeft",","],says:"a frame back",act:()=>t.step(-1)},{keys:["ArrowRight","."],says:"a frame on",act:()=>t.step(1)},{keys:["PageUp"],says:"fifty frames back",act:()=>t.step(-50)},{keys:["PageDown"],says:"fifty frames on",act:()=>t.step(50)},{keys:["Home"],says:"to the start",act:()=>t.step(-1/0)},{keys:["End"],says:"to the end",act:()=>t.step(1/0)},{keys:["-"],says:"slower",act:()=>s(-1)},{keys:["+","="],says:"faster",act:()=>s(1)},{keys:["["],says:"to the event before, and select its track",act:()=>i.jump(-1)},{keys:["]"],says:"to the event after, and select its track",act:()=>i.jump(1)},{keys:["n"],says:"select the next track",act:()=>i.cycle(1)},{keys:["p"],says:"select the track before",act:()=>i.cycle(-1)},{keys:["Escape"],says:"deselect",act:()=>i.select(null)},{keys:["v"],says:"top view or in space",act:()=>e.change(o=>o.view=o.view==="top"?"3d":"top")},{keys:["0"],says:"fit the view",act:()=>n.fit()},{keys:["f"],says:"follow the vehicle or the track",act:()=>e.change(o=>o.follow=!o.follow)},{keys:["c"],says:"next colouring of the returns",act:()=>e.change(o=>o.colourBy=$r[($r.indexOf(o.colourBy)+1)%$r.length]??"segment")},{keys:["e"],says:"ellipses on or off",act:()=>r("covariance")},{keys:["o"],says:"outlines on or off",act:()=>r("outlines")},{keys:["d"],says:"detections on or off",act:()=>r("detections")},{keys:["g"],says:"truth on or off",act:()=>r("truth")},{keys:["a"],says:"accept the selected track as a label",act:()=>i.label.accept()},{keys:["1"],says:"track",act:()=>i.tabs.open("Track")},{keys:["2"],says:"tune",act:()=>i.tabs.open("Tune")},{keys:["3"],says:"label",act:()=>i.tabs.open("Label")},{keys:["4"],says:"about the recording",act:()=>i.tabs.open("Info")},{keys:["t"],says:"dark or light",act:()=>e.change(o=>o.theme=o.theme==="dark"?"light":"dark")},{keys:["h","?"],says:"this sheet",act:()=>i.help.showModal()}]}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Fc="170",Fi={ROTATE:0,DOLLY:1,PAN:2},Qi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Kg=0,cu=1,Zg=2,md=1,Jg=2,Ci=3,is=0,Tn=1,gi=2,ts=0,cr=1,hu=2,uu=3,fu=4,Qg=5,Ss=100,t_=101,e_=102,n_=103,i_=104,s_=200,r_=201,o_=202,a_=203,Ll=204,Dl=205,l_=206,c_=207,h_=208,u_=209,f_=210,d_=211,p_=212,m_=213,g_=214,Ul=0,Il=1,Nl=2,gr=3,Fl=4,Ol=5,Bl=6,kl=7,gd=0,__=1,v_=2,es=0,x_=1,M_=2,S_=3,y_=4,E_=5,b_=6,T_=7,_d=300,_r=301,vr=302,zl=303,Hl=304,ga=306,Vl=1e3,Es=1001,Gl=1002,ii=1003,w_=1004,xo=1005,_i=1006,za=1007,bs=1008,Bi=1009,vd=1010,xd=1011,Qr=1012,Oc=1013,Rs=1014,Li=1015,to=1016,Bc=1017,kc=1018,xr=1020,Md=35902,Sd=1021,yd=1022,ni=1023,Ed=1024,bd=1025,hr=1026,Mr=1027,Td=1028,zc=1029,wd=1030,Hc=1031,Vc=1033,$o=33776,jo=33777,Ko=33778,Zo=33779,Wl=35840,Xl=35841,Yl=35842,ql=35843,$l=36196,jl=37492,Kl=37496,Zl=37808,Jl=37809,Ql=37810,tc=37811,ec=37812,nc=37813,ic=37814,sc=37815,rc=37816,oc=37817,ac=37818,lc=37819,cc=37820,hc=37821,Jo=36492,uc=36494,fc=36495,Ad=36283,dc=36284,pc=36285,mc=36286,A_=3200,R_=3201,C_=0,P_=1,Ji="",Gn="srgb",Ds="srgb-linear",_a="linear",Ee="srgb",Ys=7680,du=519,L_=512,D_=513,U_=514,Rd=515,I_=516,N_=517,F_=518,O_=519,pu=35044,mu="300 es",Di=2e3,sa=2001;class Us{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const n=this._listeners[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const ln=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Qo=Math.PI/180,gc=180/Math.PI;function eo(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(ln[i&255]+ln[i>>8&255]+ln[i>>16&255]+ln[i>>24&255]+"-"+ln[t&255]+ln[t>>8&255]+"-"+ln[t>>16&15|64]+ln[t>>24&255]+"-"+ln[e&63|128]+ln[e>>8&255]+"-"+ln[e>>16&255]+ln[e>>24&255]+ln[n&255]+ln[n>>8&255]+ln[n>>16&255]+ln[n>>24&255]).toLowerCase()}function _n(i,t,e){return Math.max(t,Math.min(e,i))}function B_(i,t){return(i%t+t)%t}function Ha(i,t,e){return(1-e)*i+e*t}function Fr(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function En(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}const k_={DEG2RAD:Qo};class ee{constructor(t=0,e=0){ee.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(_n(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Jt{constructor(t,e,n,s,r,o,a,l,c){Jt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){const h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],m=n[5],_=n[8],x=s[0],p=s[3],d=s[6],T=s[1],A=s[4],y=s[7],z=s[2],L=s[5],D=s[8];return r[0]=o*x+a*T+l*z,r[3]=o*p+a*A+l*L,r[6]=o*d+a*y+l*D,r[1]=c*x+h*T+u*z,r[4]=c*p+h*A+u*L,r[7]=c*d+h*y+u*D,r[2]=f*x+m*T+_*z,r[5]=f*p+m*A+_*L,r[8]=f*d+m*y+_*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,m=c*r-o*l,_=e*u+n*f+s*m;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const x=1/_;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=f*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=m*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Va.makeScale(t,e)),this}rotate(t){return this.premultiply(Va.makeRotation(-t)),this}translate(t,e){return this.premultiply(Va.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const Va=new Jt;function Cd(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function ra(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function z_(){const i=ra("canvas");return i.style.display="block",i}const gu={};function Xr(i){i in gu||(gu[i]=!0,console.warn(i))}function H_(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}function V_(i){const t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function G_(i){const t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const ce={enabled:!0,workingColorSpace:Ds,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ee&&(i.r=Oi(i.r),i.g=Oi(i.g),i.b=Oi(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ee&&(i.r=ur(i.r),i.g=ur(i.g),i.b=ur(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===Ji?_a:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Oi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ur(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const _u=[.64,.33,.3,.6,.15,.06],vu=[.2126,.7152,.0722],xu=[.3127,.329],Mu=new Jt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Su=new Jt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ce.define({[Ds]:{primaries:_u,whitePoint:xu,transfer:_a,toXYZ:Mu,fromXYZ:Su,luminanceCoefficients:vu,workingColorSpaceConfig:{unpackColorSpace:Gn},outputColorSpaceConfig:{drawingBufferColorSpace:Gn}},[Gn]:{primaries:_u,whitePoint:xu,transfer:Ee,toXYZ:Mu,fromXYZ:Su,luminanceCoefficients:vu,outputColorSpaceConfig:{drawingBufferColorSpace:Gn}}});let qs;class W_{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{qs===void 0&&(qs=ra("canvas")),qs.width=t.width,qs.height=t.height;const n=qs.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=qs}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=ra("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Oi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Oi(e[n]/255)*255):e[n]=Oi(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let X_=0;class Pd{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:X_++}),this.uuid=eo(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ga(s[o].image)):r.push(Ga(s[o]))}else r=Ga(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function Ga(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?W_.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let Y_=0;class wn extends Us{constructor(t=wn.DEFAULT_IMAGE,e=wn.DEFAULT_MAPPING,n=Es,s=Es,r=_i,o=bs,a=ni,l=Bi,c=wn.DEFAULT_ANISOTROPY,h=Ji){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Y_++}),this.uuid=eo(),this.name="",this.source=new Pd(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ee(0,0),this.repeat=new ee(1,1),this.center=new ee(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Jt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==_d)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Vl:t.x=t.x-Math.floor(t.x);break;case Es:t.x=t.x<0?0:1;break;case Gl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Vl:t.y=t.y-Math.floor(t.y);break;case Es:t.y=t.y<0?0:1;break;case Gl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}wn.DEFAULT_IMAGE=null;wn.DEFAULT_MAPPING=_d;wn.DEFAULT_ANISOTROPY=1;class ke{constructor(t=0,e=0,n=0,s=1){ke.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],m=l[5],_=l[9],x=l[2],p=l[6],d=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-x)<.01&&Math.abs(_-p)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+x)<.1&&Math.abs(_+p)<.1&&Math.abs(c+m+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const A=(c+1)/2,y=(m+1)/2,z=(d+1)/2,L=(h+f)/4,D=(u+x)/4,I=(_+p)/4;return A>y&&A>z?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=L/n,r=D/n):y>z?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=L/s,r=I/s):z<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(z),n=D/r,s=I/r),this.set(n,s,r,e),this}let T=Math.sqrt((p-_)*(p-_)+(u-x)*(u-x)+(f-h)*(f-h));return Math.abs(T)<.001&&(T=1),this.x=(p-_)/T,this.y=(u-x)/T,this.z=(f-h)/T,this.w=Math.acos((c+m+d-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class q_ extends Us{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new ke(0,0,t,e),this.scissorTest=!1,this.viewport=new ke(0,0,t,e);const s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:_i,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const r=new wn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];const o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new Pd(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Cs extends q_{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class Ld extends wn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ii,this.minFilter=ii,this.wrapR=Es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class $_ extends wn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ii,this.minFilter=ii,this.wrapR=Es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Ps{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3];const f=r[o+0],m=r[o+1],_=r[o+2],x=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u;return}if(a===1){t[e+0]=f,t[e+1]=m,t[e+2]=_,t[e+3]=x;return}if(u!==x||l!==f||c!==m||h!==_){let p=1-a;const d=l*f+c*m+h*_+u*x,T=d>=0?1:-1,A=1-d*d;if(A>Number.EPSILON){const z=Math.sqrt(A),L=Math.atan2(z,d*T);p=Math.sin(p*L)/z,a=Math.sin(a*L)/z}const y=a*T;if(l=l*p+f*y,c=c*p+m*y,h=h*p+_*y,u=u*p+x*y,p===1-a){const z=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=z,c*=z,h*=z,u*=z}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],m=r[o+2],_=r[o+3];return t[e]=a*_+h*u+l*m-c*f,t[e+1]=l*_+h*f+c*u-a*m,t[e+2]=c*_+h*m+a*f-l*u,t[e+3]=h*_-a*u-l*f-c*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),m=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*m*_,this._y=c*m*u-f*h*_,this._z=c*h*_+f*m*u,this._w=c*h*u-f*m*_;break;case"YXZ":this._x=f*h*u+c*m*_,this._y=c*m*u-f*h*_,this._z=c*h*_-f*m*u,this._w=c*h*u+f*m*_;break;case"ZXY":this._x=f*h*u-c*m*_,this._y=c*m*u+f*h*_,this._z=c*h*_+f*m*u,this._w=c*h*u-f*m*_;break;case"ZYX":this._x=f*h*u-c*m*_,this._y=c*m*u+f*h*_,this._z=c*h*_-f*m*u,this._w=c*h*u+f*m*_;break;case"YZX":this._x=f*h*u+c*m*_,this._y=c*m*u+f*h*_,this._z=c*h*_-f*m*u,this._w=c*h*u-f*m*_;break;case"XZY":this._x=f*h*u-c*m*_,this._y=c*m*u-f*h*_,this._z=c*h*_+f*m*u,this._w=c*h*u+f*m*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){const m=.5/Math.sqrt(f+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(n>a&&n>u){const m=2*Math.sqrt(1+n-a-u);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>u){const m=2*Math.sqrt(1+a-n-u);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{const m=2*Math.sqrt(1+u-n-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(_n(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const n=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const m=1-e;return this._w=m*o+e*this._w,this._x=m*n+e*this._x,this._y=m*s+e*this._y,this._z=m*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-e)*h)/c,f=Math.sin(e*h)/c;return this._w=o*u+this._w*f,this._x=n*u+this._x*f,this._y=s*u+this._y*f,this._z=r*u+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class V{constructor(t=0,e=0,n=0){V.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(yu.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(yu.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Wa.copy(this).projectOnVector(t),this.sub(Wa)}reflect(t){return this.sub(Wa.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(_n(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Wa=new V,yu=new Ps;class no{constructor(t=new V(1/0,1/0,1/0),e=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(jn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(jn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=jn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,jn):jn.fromBufferAttribute(r,o),jn.applyMatrix4(t.matrixWorld),this.expandByPoint(jn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Mo.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Mo.copy(n.boundingBox)),Mo.applyMatrix4(t.matrixWorld),this.union(Mo)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,jn),jn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Or),So.subVectors(this.max,Or),$s.subVectors(t.a,Or),js.subVectors(t.b,Or),Ks.subVectors(t.c,Or),Xi.subVectors(js,$s),Yi.subVectors(Ks,js),us.subVectors($s,Ks);let e=[0,-Xi.z,Xi.y,0,-Yi.z,Yi.y,0,-us.z,us.y,Xi.z,0,-Xi.x,Yi.z,0,-Yi.x,us.z,0,-us.x,-Xi.y,Xi.x,0,-Yi.y,Yi.x,0,-us.y,us.x,0];return!Xa(e,$s,js,Ks,So)||(e=[1,0,0,0,1,0,0,0,1],!Xa(e,$s,js,Ks,So))?!1:(yo.crossVectors(Xi,Yi),e=[yo.x,yo.y,yo.z],Xa(e,$s,js,Ks,So))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,jn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(jn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(bi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),bi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),bi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),bi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),bi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),bi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),bi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),bi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(bi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const bi=[new V,new V,new V,new V,new V,new V,new V,new V],jn=new V,Mo=new no,$s=new V,js=new V,Ks=new V,Xi=new V,Yi=new V,us=new V,Or=new V,So=new V,yo=new V,fs=new V;function Xa(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){fs.fromArray(i,r);const a=s.x*Math.abs(fs.x)+s.y*Math.abs(fs.y)+s.z*Math.abs(fs.z),l=t.dot(fs),c=e.dot(fs),h=n.dot(fs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const j_=new no,Br=new V,Ya=new V;class io{constructor(t=new V,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):j_.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Br.subVectors(t,this.center);const e=Br.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Br,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Ya.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Br.copy(t.center).add(Ya)),this.expandByPoint(Br.copy(t.center).sub(Ya))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Ti=new V,qa=new V,Eo=new V,qi=new V,$a=new V,bo=new V,ja=new V;class so{constructor(t=new V,e=new V(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ti)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Ti.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ti.copy(this.origin).addScaledVector(this.direction,e),Ti.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){qa.copy(t).add(e).multiplyScalar(.5),Eo.copy(e).sub(t).normalize(),qi.copy(this.origin).sub(qa);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Eo),a=qi.dot(this.direction),l=-qi.dot(Eo),c=qi.lengthSq(),h=Math.abs(1-o*o);let u,f,m,_;if(h>0)if(u=o*l-a,f=o*a-l,_=r*h,u>=0)if(f>=-_)if(f<=_){const x=1/h;u*=x,f*=x,m=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;else f<=-_?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),m=-u*u+f*(f+2*l)+c):f<=_?(u=0,f=Math.min(Math.max(-r,-l),r),m=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),m=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(qa).addScaledVector(Eo,f),m}intersectSphere(t,e){Ti.subVectors(t.center,this.origin);const n=Ti.dot(this.direction),s=Ti.dot(Ti)-n*n,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ti)!==null}intersectTriangle(t,e,n,s,r){$a.subVectors(e,t),bo.subVectors(n,t),ja.crossVectors($a,bo);let o=this.direction.dot(ja),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;qi.subVectors(this.origin,t);const l=a*this.direction.dot(bo.crossVectors(qi,bo));if(l<0)return null;const c=a*this.direction.dot($a.cross(qi));if(c<0||l+c>o)return null;const h=-a*qi.dot(ja);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Fe{constructor(t,e,n,s,r,o,a,l,c,h,u,f,m,_,x,p){Fe.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,m,_,x,p)}set(t,e,n,s,r,o,a,l,c,h,u,f,m,_,x,p){const d=this.elements;return d[0]=t,d[4]=e,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=h,d[10]=u,d[14]=f,d[3]=m,d[7]=_,d[11]=x,d[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Fe().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,n=t.elements,s=1/Zs.setFromMatrixColumn(t,0).length(),r=1/Zs.setFromMatrixColumn(t,1).length(),o=1/Zs.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){const f=o*h,m=o*u,_=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=m+_*c,e[5]=f-x*c,e[9]=-a*l,e[2]=x-f*c,e[6]=_+m*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*h,m=l*u,_=c*h,x=c*u;e[0]=f+x*a,e[4]=_*a-m,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=m*a-_,e[6]=x+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*h,m=l*u,_=c*h,x=c*u;e[0]=f-x*a,e[4]=-o*u,e[8]=_+m*a,e[1]=m+_*a,e[5]=o*h,e[9]=x-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*h,m=o*u,_=a*h,x=a*u;e[0]=l*h,e[4]=_*c-m,e[8]=f*c+x,e[1]=l*u,e[5]=x*c+f,e[9]=m*c-_,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,m=o*c,_=a*l,x=a*c;e[0]=l*h,e[4]=x-f*u,e[8]=_*u+m,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=m*u+_,e[10]=f-x*u}else if(t.order==="XZY"){const f=o*l,m=o*c,_=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+x,e[5]=o*h,e[9]=m*u-_,e[2]=_*u-m,e[6]=a*h,e[10]=x*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(K_,t,Z_)}lookAt(t,e,n){const s=this.elements;return Dn.subVectors(t,e),Dn.lengthSq()===0&&(Dn.z=1),Dn.normalize(),$i.crossVectors(n,Dn),$i.lengthSq()===0&&(Math.abs(n.z)===1?Dn.x+=1e-4:Dn.z+=1e-4,Dn.normalize(),$i.crossVectors(n,Dn)),$i.normalize(),To.crossVectors(Dn,$i),s[0]=$i.x,s[4]=To.x,s[8]=Dn.x,s[1]=$i.y,s[5]=To.y,s[9]=Dn.y,s[2]=$i.z,s[6]=To.z,s[10]=Dn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],m=n[13],_=n[2],x=n[6],p=n[10],d=n[14],T=n[3],A=n[7],y=n[11],z=n[15],L=s[0],D=s[4],I=s[8],b=s[12],S=s[1],C=s[5],$=s[9],O=s[13],Z=s[2],q=s[6],J=s[10],j=s[14],Q=s[3],ut=s[7],ct=s[11],mt=s[15];return r[0]=o*L+a*S+l*Z+c*Q,r[4]=o*D+a*C+l*q+c*ut,r[8]=o*I+a*$+l*J+c*ct,r[12]=o*b+a*O+l*j+c*mt,r[1]=h*L+u*S+f*Z+m*Q,r[5]=h*D+u*C+f*q+m*ut,r[9]=h*I+u*$+f*J+m*ct,r[13]=h*b+u*O+f*j+m*mt,r[2]=_*L+x*S+p*Z+d*Q,r[6]=_*D+x*C+p*q+d*ut,r[10]=_*I+x*$+p*J+d*ct,r[14]=_*b+x*O+p*j+d*mt,r[3]=T*L+A*S+y*Z+z*Q,r[7]=T*D+A*C+y*q+z*ut,r[11]=T*I+A*$+y*J+z*ct,r[15]=T*b+A*O+y*j+z*mt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],m=t[14],_=t[3],x=t[7],p=t[11],d=t[15];return _*(+r*l*u-s*c*u-r*a*f+n*c*f+s*a*m-n*l*m)+x*(+e*l*m-e*c*f+r*o*f-s*o*m+s*c*h-r*l*h)+p*(+e*c*u-e*a*m-r*o*u+n*o*m+r*a*h-n*c*h)+d*(-s*a*h-e*l*u+e*a*f+s*o*u-n*o*f+n*l*h)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],m=t[11],_=t[12],x=t[13],p=t[14],d=t[15],T=u*p*c-x*f*c+x*l*m-a*p*m-u*l*d+a*f*d,A=_*f*c-h*p*c-_*l*m+o*p*m+h*l*d-o*f*d,y=h*x*c-_*u*c+_*a*m-o*x*m-h*a*d+o*u*d,z=_*u*l-h*x*l-_*a*f+o*x*f+h*a*p-o*u*p,L=e*T+n*A+s*y+r*z;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/L;return t[0]=T*D,t[1]=(x*f*r-u*p*r-x*s*m+n*p*m+u*s*d-n*f*d)*D,t[2]=(a*p*r-x*l*r+x*s*c-n*p*c-a*s*d+n*l*d)*D,t[3]=(u*l*r-a*f*r-u*s*c+n*f*c+a*s*m-n*l*m)*D,t[4]=A*D,t[5]=(h*p*r-_*f*r+_*s*m-e*p*m-h*s*d+e*f*d)*D,t[6]=(_*l*r-o*p*r-_*s*c+e*p*c+o*s*d-e*l*d)*D,t[7]=(o*f*r-h*l*r+h*s*c-e*f*c-o*s*m+e*l*m)*D,t[8]=y*D,t[9]=(_*u*r-h*x*r-_*n*m+e*x*m+h*n*d-e*u*d)*D,t[10]=(o*x*r-_*a*r+_*n*c-e*x*c-o*n*d+e*a*d)*D,t[11]=(h*a*r-o*u*r-h*n*c+e*u*c+o*n*m-e*a*m)*D,t[12]=z*D,t[13]=(h*x*s-_*u*s+_*n*f-e*x*f-h*n*p+e*u*p)*D,t[14]=(_*a*s-o*x*s-_*n*l+e*x*l+o*n*p-e*a*p)*D,t[15]=(o*u*s-h*a*s+h*n*l-e*u*l-o*n*f+e*a*f)*D,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,m=r*h,_=r*u,x=o*h,p=o*u,d=a*u,T=l*c,A=l*h,y=l*u,z=n.x,L=n.y,D=n.z;return s[0]=(1-(x+d))*z,s[1]=(m+y)*z,s[2]=(_-A)*z,s[3]=0,s[4]=(m-y)*L,s[5]=(1-(f+d))*L,s[6]=(p+T)*L,s[7]=0,s[8]=(_+A)*D,s[9]=(p-T)*D,s[10]=(1-(f+x))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;let r=Zs.set(s[0],s[1],s[2]).length();const o=Zs.set(s[4],s[5],s[6]).length(),a=Zs.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],Kn.copy(this);const c=1/r,h=1/o,u=1/a;return Kn.elements[0]*=c,Kn.elements[1]*=c,Kn.elements[2]*=c,Kn.elements[4]*=h,Kn.elements[5]*=h,Kn.elements[6]*=h,Kn.elements[8]*=u,Kn.elements[9]*=u,Kn.elements[10]*=u,e.setFromRotationMatrix(Kn),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Di){const l=this.elements,c=2*r/(e-t),h=2*r/(n-s),u=(e+t)/(e-t),f=(n+s)/(n-s);let m,_;if(a===Di)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===sa)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=m,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Di){const l=this.elements,c=1/(e-t),h=1/(n-s),u=1/(o-r),f=(e+t)*c,m=(n+s)*h;let _,x;if(a===Di)_=(o+r)*u,x=-2*u;else if(a===sa)_=r*u,x=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-m,l[2]=0,l[6]=0,l[10]=x,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const Zs=new V,Kn=new Fe,K_=new V(0,0,0),Z_=new V(1,1,1),$i=new V,To=new V,Dn=new V,Eu=new Fe,bu=new Ps;class ki{constructor(t=0,e=0,n=0,s=ki.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(_n(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_n(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(_n(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_n(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_n(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-_n(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Eu.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Eu,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return bu.setFromEuler(this),this.setFromQuaternion(bu,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}ki.DEFAULT_ORDER="XYZ";class Gc{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let J_=0;const Tu=new V,Js=new Ps,wi=new Fe,wo=new V,kr=new V,Q_=new V,t0=new Ps,wu=new V(1,0,0),Au=new V(0,1,0),Ru=new V(0,0,1),Cu={type:"added"},e0={type:"removed"},Qs={type:"childadded",child:null},Ka={type:"childremoved",child:null};class Mn extends Us{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:J_++}),this.uuid=eo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Mn.DEFAULT_UP.clone();const t=new V,e=new ki,n=new Ps,s=new V(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Fe},normalMatrix:{value:new Jt}}),this.matrix=new Fe,this.matrixWorld=new Fe,this.matrixAutoUpdate=Mn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Mn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Gc,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Js.setFromAxisAngle(t,e),this.quaternion.multiply(Js),this}rotateOnWorldAxis(t,e){return Js.setFromAxisAngle(t,e),this.quaternion.premultiply(Js),this}rotateX(t){return this.rotateOnAxis(wu,t)}rotateY(t){return this.rotateOnAxis(Au,t)}rotateZ(t){return this.rotateOnAxis(Ru,t)}translateOnAxis(t,e){return Tu.copy(t).applyQuaternion(this.quaternion),this.position.add(Tu.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(wu,t)}translateY(t){return this.translateOnAxis(Au,t)}translateZ(t){return this.translateOnAxis(Ru,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(wi.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?wo.copy(t):wo.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),kr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?wi.lookAt(kr,wo,this.up):wi.lookAt(wo,kr,this.up),this.quaternion.setFromRotationMatrix(wi),s&&(wi.extractRotation(s.matrixWorld),Js.setFromRotationMatrix(wi),this.quaternion.premultiply(Js.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Cu),Qs.child=t,this.dispatchEvent(Qs),Qs.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(e0),Ka.child=t,this.dispatchEvent(Ka),Ka.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),wi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),wi.multiply(t.parent.matrixWorld)),t.applyMatrix4(wi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Cu),Qs.child=t,this.dispatchEvent(Qs),Qs.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(kr,t,Q_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(kr,t0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){const n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),m=o(t.animations),_=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),m.length>0&&(n.animations=m),_.length>0&&(n.nodes=_)}return n.object=s,n;function o(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}}Mn.DEFAULT_UP=new V(0,1,0);Mn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Mn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const Zn=new V,Ai=new V,Za=new V,Ri=new V,tr=new V,er=new V,Pu=new V,Ja=new V,Qa=new V,tl=new V,el=new ke,nl=new ke,il=new ke;class ei{constructor(t=new V,e=new V,n=new V){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Zn.subVectors(t,e),s.cross(Zn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Zn.subVectors(s,e),Ai.subVectors(n,e),Za.subVectors(t,e);const o=Zn.dot(Zn),a=Zn.dot(Ai),l=Zn.dot(Za),c=Ai.dot(Ai),h=Ai.dot(Za),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;const f=1/u,m=(c*l-a*h)*f,_=(o*h-a*l)*f;return r.set(1-m-_,_,m)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ri)===null?!1:Ri.x>=0&&Ri.y>=0&&Ri.x+Ri.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Ri)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ri.x),l.addScaledVector(o,Ri.y),l.addScaledVector(a,Ri.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return el.setScalar(0),nl.setScalar(0),il.setScalar(0),el.fromBufferAttribute(t,e),nl.fromBufferAttribute(t,n),il.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(el,r.x),o.addScaledVector(nl,r.y),o.addScaledVector(il,r.z),o}static isFrontFacing(t,e,n,s){return Zn.subVectors(n,e),Ai.subVectors(t,e),Zn.cross(Ai).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Zn.subVectors(this.c,this.b),Ai.subVectors(this.a,this.b),Zn.cross(Ai).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ei.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ei.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return ei.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return ei.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ei.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let o,a;tr.subVectors(s,n),er.subVectors(r,n),Ja.subVectors(t,n);const l=tr.dot(Ja),c=er.dot(Ja);if(l<=0&&c<=0)return e.copy(n);Qa.subVectors(t,s);const h=tr.dot(Qa),u=er.dot(Qa);if(h>=0&&u<=h)return e.copy(s);const f=l*u-h*c;if(f<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(n).addScaledVector(tr,o);tl.subVectors(t,r);const m=tr.dot(tl),_=er.dot(tl);if(_>=0&&m<=_)return e.copy(r);const x=m*c-l*_;if(x<=0&&c>=0&&_<=0)return a=c/(c-_),e.copy(n).addScaledVector(er,a);const p=h*_-m*u;if(p<=0&&u-h>=0&&m-_>=0)return Pu.subVectors(r,s),a=(u-h)/(u-h+(m-_)),e.copy(s).addScaledVector(Pu,a);const d=1/(p+x+f);return o=x*d,a=f*d,e.copy(n).addScaledVector(tr,o).addScaledVector(er,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const Dd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ji={h:0,s:0,l:0},Ao={h:0,s:0,l:0};function sl(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class Me{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Gn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ce.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=ce.workingColorSpace){return this.r=t,this.g=e,this.b=n,ce.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=ce.workingColorSpace){if(t=B_(t,1),e=_n(e,0,1),n=_n(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=sl(o,r,t+1/3),this.g=sl(o,r,t),this.b=sl(o,r,t-1/3)}return ce.toWorkingColorSpace(this,s),this}setStyle(t,e=Gn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Gn){const n=Dd[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Oi(t.r),this.g=Oi(t.g),this.b=Oi(t.b),this}copyLinearToSRGB(t){return this.r=ur(t.r),this.g=ur(t.g),this.b=ur(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Gn){return ce.fromWorkingColorSpace(cn.copy(this),t),Math.round(_n(cn.r*255,0,255))*65536+Math.round(_n(cn.g*255,0,255))*256+Math.round(_n(cn.b*255,0,255))}getHexString(t=Gn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ce.workingColorSpace){ce.fromWorkingColorSpace(cn.copy(this),e);const n=cn.r,s=cn.g,r=cn.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const h=(a+o)/2;if(a===o)l=0,c=0;else{const u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ce.workingColorSpace){return ce.fromWorkingColorSpace(cn.copy(this),e),t.r=cn.r,t.g=cn.g,t.b=cn.b,t}getStyle(t=Gn){ce.fromWorkingColorSpace(cn.copy(this),t);const e=cn.r,n=cn.g,s=cn.b;return t!==Gn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(ji),this.setHSL(ji.h+t,ji.s+e,ji.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ji),t.getHSL(Ao);const n=Ha(ji.h,Ao.h,e),s=Ha(ji.s,Ao.s,e),r=Ha(ji.l,Ao.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const cn=new Me;Me.NAMES=Dd;let n0=0;class Tr extends Us{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:n0++}),this.uuid=eo(),this.name="",this.blending=cr,this.side=is,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ll,this.blendDst=Dl,this.blendEquation=Ss,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Me(0,0,0),this.blendAlpha=0,this.depthFunc=gr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=du,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ys,this.stencilZFail=Ys,this.stencilZPass=Ys,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==cr&&(n.blending=this.blending),this.side!==is&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Ll&&(n.blendSrc=this.blendSrc),this.blendDst!==Dl&&(n.blendDst=this.blendDst),this.blendEquation!==Ss&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==gr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==du&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Ys&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Ys&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Ys&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class Wc extends Tr{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new Me(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ki,this.combine=gd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const He=new V,Ro=new ee;class An{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=pu,this.updateRanges=[],this.gpuType=Li,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ro.fromBufferAttribute(this,e),Ro.applyMatrix3(t),this.setXY(e,Ro.x,Ro.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)He.fromBufferAttribute(this,e),He.applyMatrix3(t),this.setXYZ(e,He.x,He.y,He.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)He.fromBufferAttribute(this,e),He.applyMatrix4(t),this.setXYZ(e,He.x,He.y,He.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)He.fromBufferAttribute(this,e),He.applyNormalMatrix(t),this.setXYZ(e,He.x,He.y,He.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)He.fromBufferAttribute(this,e),He.transformDirection(t),this.setXYZ(e,He.x,He.y,He.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Fr(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=En(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Fr(e,this.array)),e}setX(t,e){return this.normalized&&(e=En(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Fr(e,this.array)),e}setY(t,e){return this.normalized&&(e=En(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Fr(e,this.array)),e}setZ(t,e){return this.normalized&&(e=En(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Fr(e,this.array)),e}setW(t,e){return this.normalized&&(e=En(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=En(e,this.array),n=En(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=En(e,this.array),n=En(n,this.array),s=En(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=En(e,this.array),n=En(n,this.array),s=En(s,this.array),r=En(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==pu&&(t.usage=this.usage),t}}class Ud extends An{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class Id extends An{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class xi extends An{constructor(t,e,n){super(new Float32Array(t),e,n)}}let i0=0;const zn=new Fe,rl=new Mn,nr=new V,Un=new no,zr=new no,sn=new V;class Xn extends Us{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:i0++}),this.uuid=eo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Cd(t)?Id:Ud)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new Jt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return zn.makeRotationFromQuaternion(t),this.applyMatrix4(zn),this}rotateX(t){return zn.makeRotationX(t),this.applyMatrix4(zn),this}rotateY(t){return zn.makeRotationY(t),this.applyMatrix4(zn),this}rotateZ(t){return zn.makeRotationZ(t),this.applyMatrix4(zn),this}translate(t,e,n){return zn.makeTranslation(t,e,n),this.applyMatrix4(zn),this}scale(t,e,n){return zn.makeScale(t,e,n),this.applyMatrix4(zn),this}lookAt(t){return rl.lookAt(t),rl.updateMatrix(),this.applyMatrix4(rl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(nr).negate(),this.translate(nr.x,nr.y,nr.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new xi(n,3))}else{for(let n=0,s=e.count;n<s;n++){const r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new no);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];Un.setFromBufferAttribute(r),this.morphTargetsRelative?(sn.addVectors(this.boundingBox.min,Un.min),this.boundingBox.expandByPoint(sn),sn.addVectors(this.boundingBox.max,Un.max),this.boundingBox.expandByPoint(sn)):(this.boundingBox.expandByPoint(Un.min),this.boundingBox.expandByPoint(Un.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new io);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(t){const n=this.boundingSphere.center;if(Un.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];zr.setFromBufferAttribute(a),this.morphTargetsRelative?(sn.addVectors(Un.min,zr.min),Un.expandByPoint(sn),sn.addVectors(Un.max,zr.max),Un.expandByPoint(sn)):(Un.expandByPoint(zr.min),Un.expandByPoint(zr.max))}Un.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)sn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(sn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)sn.fromBufferAttribute(a,c),l&&(nr.fromBufferAttribute(t,c),sn.add(nr)),s=Math.max(s,n.distanceToSquared(sn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new An(new Float32Array(4*n.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let I=0;I<n.count;I++)a[I]=new V,l[I]=new V;const c=new V,h=new V,u=new V,f=new ee,m=new ee,_=new ee,x=new V,p=new V;function d(I,b,S){c.fromBufferAttribute(n,I),h.fromBufferAttribute(n,b),u.fromBufferAttribute(n,S),f.fromBufferAttribute(r,I),m.fromBufferAttribute(r,b),_.fromBufferAttribute(r,S),h.sub(c),u.sub(c),m.sub(f),_.sub(f);const C=1/(m.x*_.y-_.x*m.y);isFinite(C)&&(x.copy(h).multiplyScalar(_.y).addScaledVector(u,-m.y).multiplyScalar(C),p.copy(u).multiplyScalar(m.x).addScaledVector(h,-_.x).multiplyScalar(C),a[I].add(x),a[b].add(x),a[S].add(x),l[I].add(p),l[b].add(p),l[S].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let I=0,b=T.length;I<b;++I){const S=T[I],C=S.start,$=S.count;for(let O=C,Z=C+$;O<Z;O+=3)d(t.getX(O+0),t.getX(O+1),t.getX(O+2))}const A=new V,y=new V,z=new V,L=new V;function D(I){z.fromBufferAttribute(s,I),L.copy(z);const b=a[I];A.copy(b),A.sub(z.multiplyScalar(z.dot(b))).normalize(),y.crossVectors(L,b);const C=y.dot(l[I])<0?-1:1;o.setXYZW(I,A.x,A.y,A.z,C)}for(let I=0,b=T.length;I<b;++I){const S=T[I],C=S.start,$=S.count;for(let O=C,Z=C+$;O<Z;O+=3)D(t.getX(O+0)),D(t.getX(O+1)),D(t.getX(O+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new An(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,m=n.count;f<m;f++)n.setXYZ(f,0,0,0);const s=new V,r=new V,o=new V,a=new V,l=new V,c=new V,h=new V,u=new V;if(t)for(let f=0,m=t.count;f<m;f+=3){const _=t.getX(f+0),x=t.getX(f+1),p=t.getX(f+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,m=e.count;f<m;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)sn.fromBufferAttribute(t,e),sn.normalize(),t.setXYZ(e,sn.x,sn.y,sn.z)}toNonIndexed(){function t(a,l){const c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h);let m=0,_=0;for(let x=0,p=l.length;x<p;x++){a.isInterleavedBufferAttribute?m=l[x]*a.data.stride+a.offset:m=l[x]*h;for(let d=0;d<h;d++)f[_++]=c[m++]}return new An(f,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new Xn,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,n);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){const f=c[h],m=t(f,n);l.push(m)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){const m=c[u];h.push(m.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone(e));const s=t.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(e))}const r=t.morphAttributes;for(const c in r){const h=[],u=r[c];for(let f=0,m=u.length;f<m;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,h=o.length;c<h;c++){const u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Lu=new Fe,ds=new so,Co=new io,Du=new V,Po=new V,Lo=new V,Do=new V,ol=new V,Uo=new V,Uu=new V,Io=new V;class vi extends Mn{constructor(t=new Xn,e=new Wc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){Uo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=a[l],u=r[l];h!==0&&(ol.fromBufferAttribute(u,t),o?Uo.addScaledVector(ol,h):Uo.addScaledVector(ol.sub(e),h))}e.add(Uo)}return e}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Co.copy(n.boundingSphere),Co.applyMatrix4(r),ds.copy(t.ray).recast(t.near),!(Co.containsPoint(ds.origin)===!1&&(ds.intersectSphere(Co,Du)===null||ds.origin.distanceToSquared(Du)>(t.far-t.near)**2))&&(Lu.copy(r).invert(),ds.copy(t.ray).applyMatrix4(Lu),!(n.boundingBox!==null&&ds.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ds)))}_computeIntersections(t,e,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,x=f.length;_<x;_++){const p=f[_],d=o[p.materialIndex],T=Math.max(p.start,m.start),A=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let y=T,z=A;y<z;y+=3){const L=a.getX(y),D=a.getX(y+1),I=a.getX(y+2);s=No(this,d,t,n,c,h,u,L,D,I),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{const _=Math.max(0,m.start),x=Math.min(a.count,m.start+m.count);for(let p=_,d=x;p<d;p+=3){const T=a.getX(p),A=a.getX(p+1),y=a.getX(p+2);s=No(this,o,t,n,c,h,u,T,A,y),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,x=f.length;_<x;_++){const p=f[_],d=o[p.materialIndex],T=Math.max(p.start,m.start),A=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let y=T,z=A;y<z;y+=3){const L=y,D=y+1,I=y+2;s=No(this,d,t,n,c,h,u,L,D,I),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{const _=Math.max(0,m.start),x=Math.min(l.count,m.start+m.count);for(let p=_,d=x;p<d;p+=3){const T=p,A=p+1,y=p+2;s=No(this,o,t,n,c,h,u,T,A,y),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}}function s0(i,t,e,n,s,r,o,a){let l;if(t.side===Tn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===is,a),l===null)return null;Io.copy(a),Io.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(Io);return c<e.near||c>e.far?null:{distance:c,point:Io.clone(),object:i}}function No(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Po),i.getVertexPosition(l,Lo),i.getVertexPosition(c,Do);const h=s0(i,t,e,n,Po,Lo,Do,Uu);if(h){const u=new V;ei.getBarycoord(Uu,Po,Lo,Do,u),s&&(h.uv=ei.getInterpolatedAttribute(s,a,l,c,u,new ee)),r&&(h.uv1=ei.getInterpolatedAttribute(r,a,l,c,u,new ee)),o&&(h.normal=ei.getInterpolatedAttribute(o,a,l,c,u,new V),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new V,materialIndex:0};ei.getNormal(Po,Lo,Do,f.normal),h.face=f,h.barycoord=u}return h}class ro extends Xn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],h=[],u=[];let f=0,m=0;_("z","y","x",-1,-1,n,e,t,o,r,0),_("z","y","x",1,-1,n,e,-t,o,r,1),_("x","z","y",1,1,t,n,e,s,o,2),_("x","z","y",1,-1,t,n,-e,s,o,3),_("x","y","z",1,-1,t,e,n,s,r,4),_("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new xi(c,3)),this.setAttribute("normal",new xi(h,3)),this.setAttribute("uv",new xi(u,2));function _(x,p,d,T,A,y,z,L,D,I,b){const S=y/D,C=z/I,$=y/2,O=z/2,Z=L/2,q=D+1,J=I+1;let j=0,Q=0;const ut=new V;for(let ct=0;ct<J;ct++){const mt=ct*C-O;for(let Mt=0;Mt<q;Mt++){const pt=Mt*S-$;ut[x]=pt*T,ut[p]=mt*A,ut[d]=Z,c.push(ut.x,ut.y,ut.z),ut[x]=0,ut[p]=0,ut[d]=L>0?1:-1,h.push(ut.x,ut.y,ut.z),u.push(Mt/D),u.push(1-ct/I),j+=1}}for(let ct=0;ct<I;ct++)for(let mt=0;mt<D;mt++){const Mt=f+mt+q*ct,pt=f+mt+q*(ct+1),it=f+(mt+1)+q*(ct+1),at=f+(mt+1)+q*ct;l.push(Mt,pt,at),l.push(pt,it,at),Q+=6}a.addGroup(m,Q,b),m+=Q,f+=j}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ro(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function Sr(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function mn(i){const t={};for(let e=0;e<i.length;e++){const n=Sr(i[e]);for(const s in n)t[s]=n[s]}return t}function r0(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Nd(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ce.workingColorSpace}const o0={clone:Sr,merge:mn};var a0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,l0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class ss extends Tr{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=a0,this.fragmentShader=l0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Sr(t.uniforms),this.uniformsGroups=r0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}}class Fd extends Mn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Fe,this.projectionMatrix=new Fe,this.projectionMatrixInverse=new Fe,this.coordinateSystem=Di}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const Ki=new V,Iu=new ee,Nu=new ee;class Wn extends Fd{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=gc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(Qo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return gc*2*Math.atan(Math.tan(Qo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ki.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ki.x,Ki.y).multiplyScalar(-t/Ki.z),Ki.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ki.x,Ki.y).multiplyScalar(-t/Ki.z)}getViewSize(t,e){return this.getViewBounds(t,Iu,Nu),e.subVectors(Nu,Iu)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(Qo*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const ir=-90,sr=1;class c0 extends Mn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Wn(ir,sr,t,e);s.layers=this.layers,this.add(s);const r=new Wn(ir,sr,t,e);r.layers=this.layers,this.add(r);const o=new Wn(ir,sr,t,e);o.layers=this.layers,this.add(o);const a=new Wn(ir,sr,t,e);a.layers=this.layers,this.add(a);const l=new Wn(ir,sr,t,e);l.layers=this.layers,this.add(l);const c=new Wn(ir,sr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===Di)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===sa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;const x=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=x,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(u,f,m),t.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class Od extends wn{constructor(t,e,n,s,r,o,a,l,c,h){t=t!==void 0?t:[],e=e!==void 0?e:_r,super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class h0 extends Cs{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Od(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:_i}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ro(5,5,5),r=new ss({name:"CubemapFromEquirect",uniforms:Sr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Tn,blending:ts});r.uniforms.tEquirect.value=e;const o=new vi(s,r),a=e.minFilter;return e.minFilter===bs&&(e.minFilter=_i),new c0(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,n,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}}const al=new V,u0=new V,f0=new Jt;class Pi{constructor(t=new V(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=al.subVectors(n,e).cross(u0.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const n=t.delta(al),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||f0.getNormalMatrix(t),s=this.coplanarPoint(al).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const ps=new io,Fo=new V;class Bd{constructor(t=new Pi,e=new Pi,n=new Pi,s=new Pi,r=new Pi,o=new Pi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Di){const n=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],h=s[5],u=s[6],f=s[7],m=s[8],_=s[9],x=s[10],p=s[11],d=s[12],T=s[13],A=s[14],y=s[15];if(n[0].setComponents(l-r,f-c,p-m,y-d).normalize(),n[1].setComponents(l+r,f+c,p+m,y+d).normalize(),n[2].setComponents(l+o,f+h,p+_,y+T).normalize(),n[3].setComponents(l-o,f-h,p-_,y-T).normalize(),n[4].setComponents(l-a,f-u,p-x,y-A).normalize(),e===Di)n[5].setComponents(l+a,f+u,p+x,y+A).normalize();else if(e===sa)n[5].setComponents(a,u,x,A).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ps.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ps.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ps)}intersectsSprite(t){return ps.center.set(0,0,0),ps.radius=.7071067811865476,ps.applyMatrix4(t.matrixWorld),this.intersectsSphere(ps)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(Fo.x=s.normal.x>0?t.max.x:t.min.x,Fo.y=s.normal.y>0?t.max.y:t.min.y,Fo.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Fo)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function kd(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function d0(i){const t=new WeakMap;function e(a,l){const c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((m,_)=>m.start-_.start);let f=0;for(let m=1;m<u.length;m++){const _=u[f],x=u[m];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++f,u[f]=x)}u.length=f+1;for(let m=0,_=u.length;m<_;m++){const x=u[m];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class va extends Xn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,m=[],_=[],x=[],p=[];for(let d=0;d<h;d++){const T=d*f-o;for(let A=0;A<c;A++){const y=A*u-r;_.push(y,-T,0),x.push(0,0,1),p.push(A/a),p.push(1-d/l)}}for(let d=0;d<l;d++)for(let T=0;T<a;T++){const A=T+c*d,y=T+c*(d+1),z=T+1+c*(d+1),L=T+1+c*d;m.push(A,y,L),m.push(y,z,L)}this.setIndex(m),this.setAttribute("position",new xi(_,3)),this.setAttribute("normal",new xi(x,3)),this.setAttribute("uv",new xi(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new va(t.width,t.height,t.widthSegments,t.heightSegments)}}var p0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,m0=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,g0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,_0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,v0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,x0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,M0=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,S0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,y0=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,E0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,b0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,T0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,w0=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,A0=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,R0=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,C0=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,P0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,L0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,D0=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,U0=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,I0=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,N0=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,F0=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,O0=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,B0=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,k0=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,z0=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,H0=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,V0=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,G0=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,W0="gl_FragColor = linearToOutputTexel( gl_FragColor );",X0=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Y0=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,q0=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,$0=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,j0=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,K0=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Z0=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,J0=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Q0=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,tv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ev=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,nv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,iv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,sv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,rv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,ov=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,av=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,cv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,hv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,uv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,fv=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,dv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,pv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,mv=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,gv=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,_v=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vv=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,xv=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Mv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Sv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,yv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Ev=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,bv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Tv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,wv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Av=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Rv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Cv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Pv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Lv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Dv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Uv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Iv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Nv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Fv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Ov=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Bv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,kv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,zv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Hv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Vv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,Gv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Wv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Xv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Yv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,qv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,$v=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,jv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,Kv=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Zv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Jv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Qv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,tx=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ex=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,nx=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,ix=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,sx=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,rx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ox=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ax=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,lx=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,cx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,hx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,ux=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,fx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const dx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,px=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,gx=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_x=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Mx=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Sx=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,yx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,Ex=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bx=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Tx=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,wx=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ax=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Rx=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Cx=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Px=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Lx=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Dx=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ux=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Ix=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Nx=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Fx=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ox=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Bx=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kx=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zx=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hx=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Vx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Gx=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Wx=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Xx=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Yx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,te={alphahash_fragment:p0,alphahash_pars_fragment:m0,alphamap_fragment:g0,alphamap_pars_fragment:_0,alphatest_fragment:v0,alphatest_pars_fragment:x0,aomap_fragment:M0,aomap_pars_fragment:S0,batching_pars_vertex:y0,batching_vertex:E0,begin_vertex:b0,beginnormal_vertex:T0,bsdfs:w0,iridescence_fragment:A0,bumpmap_pars_fragment:R0,clipping_planes_fragment:C0,clipping_planes_pars_fragment:P0,clipping_planes_pars_vertex:L0,clipping_planes_vertex:D0,color_fragment:U0,color_pars_fragment:I0,color_pars_vertex:N0,color_vertex:F0,common:O0,cube_uv_reflection_fragment:B0,defaultnormal_vertex:k0,displacementmap_pars_vertex:z0,displacementmap_vertex:H0,emissivemap_fragment:V0,emissivemap_pars_fragment:G0,colorspace_fragment:W0,colorspace_pars_fragment:X0,envmap_fragment:Y0,envmap_common_pars_fragment:q0,envmap_pars_fragment:$0,envmap_pars_vertex:j0,envmap_physical_pars_fragment:ov,envmap_vertex:K0,fog_vertex:Z0,fog_pars_vertex:J0,fog_fragment:Q0,fog_pars_fragment:tv,gradientmap_pars_fragment:ev,lightmap_pars_fragment:nv,lights_lambert_fragment:iv,lights_lambert_pars_fragment:sv,lights_pars_begin:rv,lights_toon_fragment:av,lights_toon_pars_fragment:lv,lights_phong_fragment:cv,lights_phong_pars_fragment:hv,lights_physical_fragment:uv,lights_physical_pars_fragment:fv,lights_fragment_begin:dv,lights_fragment_maps:pv,lights_fragment_end:mv,logdepthbuf_fragment:gv,logdepthbuf_pars_fragment:_v,logdepthbuf_pars_vertex:vv,logdepthbuf_vertex:xv,map_fragment:Mv,map_pars_fragment:Sv,map_particle_fragment:yv,map_particle_pars_fragment:Ev,metalnessmap_fragment:bv,metalnessmap_pars_fragment:Tv,morphinstance_vertex:wv,morphcolor_vertex:Av,morphnormal_vertex:Rv,morphtarget_pars_vertex:Cv,morphtarget_vertex:Pv,normal_fragment_begin:Lv,normal_fragment_maps:Dv,normal_pars_fragment:Uv,normal_pars_vertex:Iv,normal_vertex:Nv,normalmap_pars_fragment:Fv,clearcoat_normal_fragment_begin:Ov,clearcoat_normal_fragment_maps:Bv,clearcoat_pars_fragment:kv,iridescence_pars_fragment:zv,opaque_fragment:Hv,packing:Vv,premultiplied_alpha_fragment:Gv,project_vertex:Wv,dithering_fragment:Xv,dithering_pars_fragment:Yv,roughnessmap_fragment:qv,roughnessmap_pars_fragment:$v,shadowmap_pars_fragment:jv,shadowmap_pars_vertex:Kv,shadowmap_vertex:Zv,shadowmask_pars_fragment:Jv,skinbase_vertex:Qv,skinning_pars_vertex:tx,skinning_vertex:ex,skinnormal_vertex:nx,specularmap_fragment:ix,specularmap_pars_fragment:sx,tonemapping_fragment:rx,tonemapping_pars_fragment:ox,transmission_fragment:ax,transmission_pars_fragment:lx,uv_pars_fragment:cx,uv_pars_vertex:hx,uv_vertex:ux,worldpos_vertex:fx,background_vert:dx,background_frag:px,backgroundCube_vert:mx,backgroundCube_frag:gx,cube_vert:_x,cube_frag:vx,depth_vert:xx,depth_frag:Mx,distanceRGBA_vert:Sx,distanceRGBA_frag:yx,equirect_vert:Ex,equirect_frag:bx,linedashed_vert:Tx,linedashed_frag:wx,meshbasic_vert:Ax,meshbasic_frag:Rx,meshlambert_vert:Cx,meshlambert_frag:Px,meshmatcap_vert:Lx,meshmatcap_frag:Dx,meshnormal_vert:Ux,meshnormal_frag:Ix,meshphong_vert:Nx,meshphong_frag:Fx,meshphysical_vert:Ox,meshphysical_frag:Bx,meshtoon_vert:kx,meshtoon_frag:zx,points_vert:Hx,points_frag:Vx,shadow_vert:Gx,shadow_frag:Wx,sprite_vert:Xx,sprite_frag:Yx},bt={common:{diffuse:{value:new Me(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Jt},alphaMap:{value:null},alphaMapTransform:{value:new Jt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Jt}},envmap:{envMap:{value:null},envMapRotation:{value:new Jt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Jt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Jt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Jt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Jt},normalScale:{value:new ee(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Jt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Jt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Jt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Jt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Me(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Me(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Jt},alphaTest:{value:0},uvTransform:{value:new Jt}},sprite:{diffuse:{value:new Me(16777215)},opacity:{value:1},center:{value:new ee(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Jt},alphaMap:{value:null},alphaMapTransform:{value:new Jt},alphaTest:{value:0}}},pi={basic:{uniforms:mn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:te.meshbasic_vert,fragmentShader:te.meshbasic_frag},lambert:{uniforms:mn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new Me(0)}}]),vertexShader:te.meshlambert_vert,fragmentShader:te.meshlambert_frag},phong:{uniforms:mn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new Me(0)},specular:{value:new Me(1118481)},shininess:{value:30}}]),vertexShader:te.meshphong_vert,fragmentShader:te.meshphong_frag},standard:{uniforms:mn([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new Me(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:te.meshphysical_vert,fragmentShader:te.meshphysical_frag},toon:{uniforms:mn([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new Me(0)}}]),vertexShader:te.meshtoon_vert,fragmentShader:te.meshtoon_frag},matcap:{uniforms:mn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:te.meshmatcap_vert,fragmentShader:te.meshmatcap_frag},points:{uniforms:mn([bt.points,bt.fog]),vertexShader:te.points_vert,fragmentShader:te.points_frag},dashed:{uniforms:mn([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:te.linedashed_vert,fragmentShader:te.linedashed_frag},depth:{uniforms:mn([bt.common,bt.displacementmap]),vertexShader:te.depth_vert,fragmentShader:te.depth_frag},normal:{uniforms:mn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:te.meshnormal_vert,fragmentShader:te.meshnormal_frag},sprite:{uniforms:mn([bt.sprite,bt.fog]),vertexShader:te.sprite_vert,fragmentShader:te.sprite_frag},background:{uniforms:{uvTransform:{value:new Jt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:te.background_vert,fragmentShader:te.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Jt}},vertexShader:te.backgroundCube_vert,fragmentShader:te.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:te.cube_vert,fragmentShader:te.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:te.equirect_vert,fragmentShader:te.equirect_frag},distanceRGBA:{uniforms:mn([bt.common,bt.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:te.distanceRGBA_vert,fragmentShader:te.distanceRGBA_frag},shadow:{uniforms:mn([bt.lights,bt.fog,{color:{value:new Me(0)},opacity:{value:1}}]),vertexShader:te.shadow_vert,fragmentShader:te.shadow_frag}};pi.physical={uniforms:mn([pi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Jt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Jt},clearcoatNormalScale:{value:new ee(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Jt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Jt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Jt},sheen:{value:0},sheenColor:{value:new Me(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Jt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Jt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Jt},transmissionSamplerSize:{value:new ee},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Jt},attenuationDistance:{value:0},attenuationColor:{value:new Me(0)},specularColor:{value:new Me(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Jt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Jt},anisotropyVector:{value:new ee},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Jt}}]),vertexShader:te.meshphysical_vert,fragmentShader:te.meshphysical_frag};const Oo={r:0,b:0,g:0},ms=new ki,qx=new Fe;function $x(i,t,e,n,s,r,o){const a=new Me(0);let l=r===!0?0:1,c,h,u=null,f=0,m=null;function _(T){let A=T.isScene===!0?T.background:null;return A&&A.isTexture&&(A=(T.backgroundBlurriness>0?e:t).get(A)),A}function x(T){let A=!1;const y=_(T);y===null?d(a,l):y&&y.isColor&&(d(y,1),A=!0);const z=i.xr.getEnvironmentBlendMode();z==="additive"?n.buffers.color.setClear(0,0,0,1,o):z==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||A)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function p(T,A){const y=_(A);y&&(y.isCubeTexture||y.mapping===ga)?(h===void 0&&(h=new vi(new ro(1,1,1),new ss({name:"BackgroundCubeMaterial",uniforms:Sr(pi.backgroundCube.uniforms),vertexShader:pi.backgroundCube.vertexShader,fragmentShader:pi.backgroundCube.fragmentShader,side:Tn,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(z,L,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),ms.copy(A.backgroundRotation),ms.x*=-1,ms.y*=-1,ms.z*=-1,y.isCubeTexture&&y.isRenderTargetTexture===!1&&(ms.y*=-1,ms.z*=-1),h.material.uniforms.envMap.value=y,h.material.uniforms.flipEnvMap.value=y.isCubeTexture&&y.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(qx.makeRotationFromEuler(ms)),h.material.toneMapped=ce.getTransfer(y.colorSpace)!==Ee,(u!==y||f!==y.version||m!==i.toneMapping)&&(h.material.needsUpdate=!0,u=y,f=y.version,m=i.toneMapping),h.layers.enableAll(),T.unshift(h,h.geometry,h.material,0,0,null)):y&&y.isTexture&&(c===void 0&&(c=new vi(new va(2,2),new ss({name:"BackgroundMaterial",uniforms:Sr(pi.background.uniforms),vertexShader:pi.background.vertexShader,fragmentShader:pi.background.fragmentShader,side:is,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=y,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=ce.getTransfer(y.colorSpace)!==Ee,y.matrixAutoUpdate===!0&&y.updateMatrix(),c.material.uniforms.uvTransform.value.copy(y.matrix),(u!==y||f!==y.version||m!==i.toneMapping)&&(c.material.needsUpdate=!0,u=y,f=y.version,m=i.toneMapping),c.layers.enableAll(),T.unshift(c,c.geometry,c.material,0,0,null))}function d(T,A){T.getRGB(Oo,Nd(i)),n.buffers.color.setClear(Oo.r,Oo.g,Oo.b,A,o)}return{getClearColor:function(){return a},setClearColor:function(T,A=1){a.set(T),l=A,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(T){l=T,d(a,l)},render:x,addToRenderList:p}}function jx(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null);let r=s,o=!1;function a(S,C,$,O,Z){let q=!1;const J=u(O,$,C);r!==J&&(r=J,c(r.object)),q=m(S,O,$,Z),q&&_(S,O,$,Z),Z!==null&&t.update(Z,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,y(S,C,$,O),Z!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(Z).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function h(S){return i.deleteVertexArray(S)}function u(S,C,$){const O=$.wireframe===!0;let Z=n[S.id];Z===void 0&&(Z={},n[S.id]=Z);let q=Z[C.id];q===void 0&&(q={},Z[C.id]=q);let J=q[O];return J===void 0&&(J=f(l()),q[O]=J),J}function f(S){const C=[],$=[],O=[];for(let Z=0;Z<e;Z++)C[Z]=0,$[Z]=0,O[Z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:$,attributeDivisors:O,object:S,attributes:{},index:null}}function m(S,C,$,O){const Z=r.attributes,q=C.attributes;let J=0;const j=$.getAttributes();for(const Q in j)if(j[Q].location>=0){const ct=Z[Q];let mt=q[Q];if(mt===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;J++}return r.attributesNum!==J||r.index!==O}function _(S,C,$,O){const Z={},q=C.attributes;let J=0;const j=$.getAttributes();for(const Q in j)if(j[Q].location>=0){let ct=q[Q];ct===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),Z[Q]=mt,J++}r.attributes=Z,r.attributesNum=J,r.index=O}function x(){const S=r.newAttributes;for(let C=0,$=S.length;C<$;C++)S[C]=0}function p(S){d(S,0)}function d(S,C){const $=r.newAttributes,O=r.enabledAttributes,Z=r.attributeDivisors;$[S]=1,O[S]===0&&(i.enableVertexAttribArray(S),O[S]=1),Z[S]!==C&&(i.vertexAttribDivisor(S,C),Z[S]=C)}function T(){const S=r.newAttributes,C=r.enabledAttributes;for(let $=0,O=C.length;$<O;$++)C[$]!==S[$]&&(i.disableVertexAttribArray($),C[$]=0)}function A(S,C,$,O,Z,q,J){J===!0?i.vertexAttribIPointer(S,C,$,Z,q):i.vertexAttribPointer(S,C,$,O,Z,q)}function y(S,C,$,O){x();const Z=O.attributes,q=$.getAttributes(),J=C.defaultAttributeValues;for(const j in q){const Q=q[j];if(Q.location>=0){let ut=Z[j];if(ut===void 0&&(j==="instanceMatrix"&&S.instanceMatrix&&(ut=S.instanceMatrix),j==="instanceColor"&&S.instanceColor&&(ut=S.instanceColor)),ut!==void 0){const ct=ut.normalized,mt=ut.itemSize,Mt=t.get(ut);if(Mt===void 0)continue;const pt=Mt.buffer,it=Mt.type,at=Mt.bytesPerElement,gt=it===i.INT||it===i.UNSIGNED_INT||ut.gpuType===Oc;if(ut.isInterleavedBufferAttribute){const ot=ut.data,kt=ot.stride,Ht=ut.offset;if(ot.isInstancedInterleavedBuffer){for(let It=0;It<Q.locationSize;It++)d(Q.location+It,ot.meshPerAttribute);S.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let It=0;It<Q.locationSize;It++)p(Q.location+It);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let It=0;It<Q.locationSize;It++)A(Q.location+It,mt/Q.locationSize,it,ct,kt*at,(Ht+mt/Q.locationSize*It)*at,gt)}else{if(ut.isInstancedBufferAttribute){for(let ot=0;ot<Q.locationSize;ot++)d(Q.location+ot,ut.meshPerAttribute);S.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ut.meshPerAttribute*ut.count)}else for(let ot=0;ot<Q.locationSize;ot++)p(Q.location+ot);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let ot=0;ot<Q.locationSize;ot++)A(Q.location+ot,mt/Q.locationSize,it,ct,mt*at,mt/Q.locationSize*ot*at,gt)}}else if(J!==void 0){const ct=J[j];if(ct!==void 0)switch(ct.length){case 2:i.vertexAttrib2fv(Q.location,ct);break;case 3:i.vertexAttrib3fv(Q.location,ct);break;case 4:i.vertexAttrib4fv(Q.location,ct);break;default:i.vertexAttrib1fv(Q.location,ct)}}}}T()}function z(){I();for(const S in n){const C=n[S];for(const $ in C){const O=C[$];for(const Z in O)h(O[Z].object),delete O[Z];delete C[$]}delete n[S]}}function L(S){if(n[S.id]===void 0)return;const C=n[S.id];for(const $ in C){const O=C[$];for(const Z in O)h(O[Z].object),delete O[Z];delete C[$]}delete n[S.id]}function D(S){for(const C in n){const $=n[C];if($[S.id]===void 0)continue;const O=$[S.id];for(const Z in O)h(O[Z].object),delete O[Z];delete $[S.id]}}function I(){b(),o=!0,r!==s&&(r=s,c(r.object))}function b(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:b,dispose:z,releaseStatesOfGeometry:L,releaseStatesOfProgram:D,initAttributes:x,enableAttribute:p,disableUnusedAttributes:T}}function Kx(i,t,e){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),e.update(h,n,1)}function o(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),e.update(h,n,u))}function a(c,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let m=0;for(let _=0;_<u;_++)m+=h[_];e.update(m,n,1)}function l(c,h,u,f){if(u===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let _=0;_<c.length;_++)o(c[_],h[_],f[_]);else{m.multiDrawArraysInstancedWEBGL(n,c,0,h,0,f,0,u);let _=0;for(let x=0;x<u;x++)_+=h[x]*f[x];e.update(_,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Zx(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==ni&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const I=D===to&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Bi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Li&&!I)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),T=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),z=_>0,L=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:f,maxTextures:m,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:p,maxAttributes:d,maxVertexUniforms:T,maxVaryings:A,maxFragmentUniforms:y,vertexTextures:z,maxSamples:L}}function Jx(i){const t=this;let e=null,n=0,s=!1,r=!1;const o=new Pi,a=new Jt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){const m=u.length!==0||f||n!==0||s;return s=f,n=u.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,m){const _=u.clippingPlanes,x=u.clipIntersection,p=u.clipShadows,d=i.get(u);if(!s||_===null||_.length===0||r&&!p)r?h(null):c();else{const T=r?0:n,A=T*4;let y=d.clippingState||null;l.value=y,y=h(_,f,A,m);for(let z=0;z!==A;++z)y[z]=e[z];d.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=T}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,m,_){const x=u!==null?u.length:0;let p=null;if(x!==0){if(p=l.value,_!==!0||p===null){const d=m+x*4,T=f.matrixWorldInverse;a.getNormalMatrix(T),(p===null||p.length<d)&&(p=new Float32Array(d));for(let A=0,y=m;A!==x;++A,y+=4)o.copy(u[A]).applyMatrix4(T,a),o.normal.toArray(p,y),p[y+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,p}}function Qx(i){let t=new WeakMap;function e(o,a){return a===zl?o.mapping=_r:a===Hl&&(o.mapping=vr),o}function n(o){if(o&&o.isTexture){const a=o.mapping;if(a===zl||a===Hl)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new h0(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}class zd extends Fd{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const ar=4,Fu=[.125,.215,.35,.446,.526,.582],ys=20,ll=new zd,Ou=new Me;let cl=null,hl=0,ul=0,fl=!1;const xs=(1+Math.sqrt(5))/2,rr=1/xs,Bu=[new V(-xs,rr,0),new V(xs,rr,0),new V(-rr,0,xs),new V(rr,0,xs),new V(0,xs,-rr),new V(0,xs,rr),new V(-1,1,-1),new V(1,1,-1),new V(-1,1,1),new V(1,1,1)];class ku{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){cl=this._renderer.getRenderTarget(),hl=this._renderer.getActiveCubeFace(),ul=this._renderer.getActiveMipmapLevel(),fl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,n,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Vu(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Hu(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(cl,hl,ul),this._renderer.xr.enabled=fl,t.scissorTest=!1,Bo(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===_r||t.mapping===vr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),cl=this._renderer.getRenderTarget(),hl=this._renderer.getActiveCubeFace(),ul=this._renderer.getActiveMipmapLevel(),fl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:_i,minFilter:_i,generateMipmaps:!1,type:to,format:ni,colorSpace:Ds,depthBuffer:!1},s=zu(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=zu(t,e,n);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=tM(r)),this._blurMaterial=eM(r,t,e)}return s}_compileMaterial(t){const e=new vi(this._lodPlanes[0],t);this._renderer.compile(e,ll)}_sceneToCubeUV(t,e,n,s){const a=new Wn(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,f=h.toneMapping;h.getClearColor(Ou),h.toneMapping=es,h.autoClear=!1;const m=new Wc({name:"PMREM.Background",side:Tn,depthWrite:!1,depthTest:!1}),_=new vi(new ro,m);let x=!1;const p=t.background;p?p.isColor&&(m.color.copy(p),t.background=null,x=!0):(m.color.copy(Ou),x=!0);for(let d=0;d<6;d++){const T=d%3;T===0?(a.up.set(0,l[d],0),a.lookAt(c[d],0,0)):T===1?(a.up.set(0,0,l[d]),a.lookAt(0,c[d],0)):(a.up.set(0,l[d],0),a.lookAt(0,0,c[d]));const A=this._cubeSize;Bo(s,T*A,d>2?A:0,A,A),h.setRenderTarget(s),x&&h.render(_,a),h.render(t,a)}_.geometry.dispose(),_.material.dispose(),h.toneMapping=f,h.autoClear=u,t.background=p}_textureToCubeUV(t,e){const n=this._renderer,s=t.mapping===_r||t.mapping===vr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Vu()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Hu());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new vi(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;Bo(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,ll)}_applyPMREM(t){const e=this._renderer,n=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Bu[(s-r-1)%Bu.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new vi(this._lodPlanes[s],c),f=c.uniforms,m=this._sizeLods[n]-1,_=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*ys-1),x=r/_,p=isFinite(r)?1+Math.floor(h*x):ys;p>ys&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${ys}`);const d=[];let T=0;for(let D=0;D<ys;++D){const I=D/x,b=Math.exp(-I*I/2);d.push(b),D===0?T+=b:D<p&&(T+=2*b)}for(let D=0;D<d.length;D++)d[D]=d[D]/T;f.envMap.value=t.texture,f.samples.value=p,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:A}=this;f.dTheta.value=_,f.mipInt.value=A-n;const y=this._sizeLods[s],z=3*y*(s>A-ar?s-A+ar:0),L=4*(this._cubeSize-y);Bo(e,z,L,3*y,2*y),l.setRenderTarget(e),l.render(u,ll)}}function tM(i){const t=[],e=[],n=[];let s=i;const r=i-ar+1+Fu.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>i-ar?l=Fu[o-i+ar-1]:o===0&&(l=0),n.push(l);const c=1/(a-2),h=-c,u=1+c,f=[h,h,u,h,u,u,h,h,u,u,h,u],m=6,_=6,x=3,p=2,d=1,T=new Float32Array(x*_*m),A=new Float32Array(p*_*m),y=new Float32Array(d*_*m);for(let L=0;L<m;L++){const D=L%3*2/3-1,I=L>2?0:-1,b=[D,I,0,D+2/3,I,0,D+2/3,I+1,0,D,I,0,D+2/3,I+1,0,D,I+1,0];T.set(b,x*_*L),A.set(f,p*_*L);const S=[L,L,L,L,L,L];y.set(S,d*_*L)}const z=new Xn;z.setAttribute("position",new An(T,x)),z.setAttribute("uv",new An(A,p)),z.setAttribute("faceIndex",new An(y,d)),t.push(z),s>ar&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function zu(i,t,e){const n=new Cs(i,t,e);return n.texture.mapping=ga,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Bo(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function eM(i,t,e){const n=new Float32Array(ys),s=new V(0,1,0);return new ss({name:"SphericalGaussianBlur",defines:{n:ys,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Xc(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ts,depthTest:!1,depthWrite:!1})}function Hu(){return new ss({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Xc(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ts,depthTest:!1,depthWrite:!1})}function Vu(){return new ss({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Xc(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ts,depthTest:!1,depthWrite:!1})}function Xc(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function nM(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===zl||l===Hl,h=l===_r||l===vr;if(c||h){let u=t.get(a);const f=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new ku(i)),u=c?e.fromEquirectangular(a,u):e.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),u.texture;if(u!==void 0)return u.texture;{const m=a.image;return c&&m&&m.height>0||h&&m&&s(m)?(e===null&&(e=new ku(i)),u=c?e.fromEquirectangular(a):e.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0;const c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function iM(i){const t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&Xr("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function sM(i,t,e,n){const s={},r=new WeakMap;function o(u){const f=u.target;f.index!==null&&t.remove(f.index);for(const _ in f.attributes)t.remove(f.attributes[_]);for(const _ in f.morphAttributes){const x=f.morphAttributes[_];for(let p=0,d=x.length;p<d;p++)t.remove(x[p])}f.removeEventListener("dispose",o),delete s[f.id];const m=r.get(f);m&&(t.remove(m),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(u,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(u){const f=u.attributes;for(const _ in f)t.update(f[_],i.ARRAY_BUFFER);const m=u.morphAttributes;for(const _ in m){const x=m[_];for(let p=0,d=x.length;p<d;p++)t.update(x[p],i.ARRAY_BUFFER)}}function c(u){const f=[],m=u.index,_=u.attributes.position;let x=0;if(m!==null){const T=m.array;x=m.version;for(let A=0,y=T.length;A<y;A+=3){const z=T[A+0],L=T[A+1],D=T[A+2];f.push(z,L,L,D,D,z)}}else if(_!==void 0){const T=_.array;x=_.version;for(let A=0,y=T.length/3-1;A<y;A+=3){const z=A+0,L=A+1,D=A+2;f.push(z,L,L,D,D,z)}}else return;const p=new(Cd(f)?Id:Ud)(f,1);p.version=x;const d=r.get(u);d&&t.remove(d),r.set(u,p)}function h(u){const f=r.get(u);if(f){const m=u.index;m!==null&&f.version<m.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function rM(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,m){i.drawElements(n,m,r,f*o),e.update(m,n,1)}function c(f,m,_){_!==0&&(i.drawElementsInstanced(n,m,r,f*o,_),e.update(m,n,_))}function h(f,m,_){if(_===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,m,0,r,f,0,_);let p=0;for(let d=0;d<_;d++)p+=m[d];e.update(p,n,1)}function u(f,m,_,x){if(_===0)return;const p=t.get("WEBGL_multi_draw");if(p===null)for(let d=0;d<f.length;d++)c(f[d]/o,m[d],x[d]);else{p.multiDrawElementsInstancedWEBGL(n,m,0,r,f,0,x,0,_);let d=0;for(let T=0;T<_;T++)d+=m[T]*x[T];e.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function oM(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function aM(i,t,e){const n=new WeakMap,s=new ke;function r(o,a,l){const c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0;let f=n.get(a);if(f===void 0||f.count!==u){let S=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",S)};var m=S;f!==void 0&&f.texture.dispose();const _=a.morphAttributes.position!==void 0,x=a.morphAttributes.normal!==void 0,p=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],T=a.morphAttributes.normal||[],A=a.morphAttributes.color||[];let y=0;_===!0&&(y=1),x===!0&&(y=2),p===!0&&(y=3);let z=a.attributes.position.count*y,L=1;z>t.maxTextureSize&&(L=Math.ceil(z/t.maxTextureSize),z=t.maxTextureSize);const D=new Float32Array(z*L*4*u),I=new Ld(D,z,L,u);I.type=Li,I.needsUpdate=!0;const b=y*4;for(let C=0;C<u;C++){const $=d[C],O=T[C],Z=A[C],q=z*L*4*C;for(let J=0;J<$.count;J++){const j=J*b;_===!0&&(s.fromBufferAttribute($,J),D[q+j+0]=s.x,D[q+j+1]=s.y,D[q+j+2]=s.z,D[q+j+3]=0),x===!0&&(s.fromBufferAttribute(O,J),D[q+j+4]=s.x,D[q+j+5]=s.y,D[q+j+6]=s.z,D[q+j+7]=0),p===!0&&(s.fromBufferAttribute(Z,J),D[q+j+8]=s.x,D[q+j+9]=s.y,D[q+j+10]=s.z,D[q+j+11]=Z.itemSize===4?s.w:1)}}f={count:u,texture:I,size:new ee(z,L)},n.set(a,f),a.addEventListener("dispose",S)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let _=0;for(let p=0;p<c.length;p++)_+=c[p];const x=a.morphTargetsRelative?1:1-_;l.getUniforms().setValue(i,"morphTargetBaseInfluence",x),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function lM(i,t,e,n){let s=new WeakMap;function r(l){const c=n.render.frame,h=l.geometry,u=t.get(l,h);if(s.get(u)!==c&&(t.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return u}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class Hd extends wn{constructor(t,e,n,s,r,o,a,l,c,h=hr){if(h!==hr&&h!==Mr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===hr&&(n=Rs),n===void 0&&h===Mr&&(n=xr),super(null,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:ii,this.minFilter=l!==void 0?l:ii,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const Vd=new wn,Gu=new Hd(1,1),Gd=new Ld,Wd=new $_,Xd=new Od,Wu=[],Xu=[],Yu=new Float32Array(16),qu=new Float32Array(9),$u=new Float32Array(4);function wr(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=Wu[s];if(r===void 0&&(r=new Float32Array(s),Wu[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function $e(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function je(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function xa(i,t){let e=Xu[t];e===void 0&&(e=new Int32Array(t),Xu[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function cM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function hM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if($e(e,t))return;i.uniform2fv(this.addr,t),je(e,t)}}function uM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if($e(e,t))return;i.uniform3fv(this.addr,t),je(e,t)}}function fM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if($e(e,t))return;i.uniform4fv(this.addr,t),je(e,t)}}function dM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if($e(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),je(e,t)}else{if($e(e,n))return;$u.set(n),i.uniformMatrix2fv(this.addr,!1,$u),je(e,n)}}function pM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if($e(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),je(e,t)}else{if($e(e,n))return;qu.set(n),i.uniformMatrix3fv(this.addr,!1,qu),je(e,n)}}function mM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if($e(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),je(e,t)}else{if($e(e,n))return;Yu.set(n),i.uniformMatrix4fv(this.addr,!1,Yu),je(e,n)}}function gM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function _M(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if($e(e,t))return;i.uniform2iv(this.addr,t),je(e,t)}}function vM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if($e(e,t))return;i.uniform3iv(this.addr,t),je(e,t)}}function xM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if($e(e,t))return;i.uniform4iv(this.addr,t),je(e,t)}}function MM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function SM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if($e(e,t))return;i.uniform2uiv(this.addr,t),je(e,t)}}function yM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if($e(e,t))return;i.uniform3uiv(this.addr,t),je(e,t)}}function EM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if($e(e,t))return;i.uniform4uiv(this.addr,t),je(e,t)}}function bM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(Gu.compareFunction=Rd,r=Gu):r=Vd,e.setTexture2D(t||r,s)}function TM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Wd,s)}function wM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Xd,s)}function AM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Gd,s)}function RM(i){switch(i){case 5126:return cM;case 35664:return hM;case 35665:return uM;case 35666:return fM;case 35674:return dM;case 35675:return pM;case 35676:return mM;case 5124:case 35670:return gM;case 35667:case 35671:return _M;case 35668:case 35672:return vM;case 35669:case 35673:return xM;case 5125:return MM;case 36294:return SM;case 36295:return yM;case 36296:return EM;case 35678:case 36198:case 36298:case 36306:case 35682:return bM;case 35679:case 36299:case 36307:return TM;case 35680:case 36300:case 36308:case 36293:return wM;case 36289:case 36303:case 36311:case 36292:return AM}}function CM(i,t){i.uniform1fv(this.addr,t)}function PM(i,t){const e=wr(t,this.size,2);i.uniform2fv(this.addr,e)}function LM(i,t){const e=wr(t,this.size,3);i.uniform3fv(this.addr,e)}function DM(i,t){const e=wr(t,this.size,4);i.uniform4fv(this.addr,e)}function UM(i,t){const e=wr(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function IM(i,t){const e=wr(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function NM(i,t){const e=wr(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function FM(i,t){i.uniform1iv(this.addr,t)}function OM(i,t){i.uniform2iv(this.addr,t)}function BM(i,t){i.uniform3iv(this.addr,t)}function kM(i,t){i.uniform4iv(this.addr,t)}function zM(i,t){i.uniform1uiv(this.addr,t)}function HM(i,t){i.uniform2uiv(this.addr,t)}function VM(i,t){i.uniform3uiv(this.addr,t)}function GM(i,t){i.uniform4uiv(this.addr,t)}function WM(i,t,e){const n=this.cache,s=t.length,r=xa(e,s);$e(n,r)||(i.uniform1iv(this.addr,r),je(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Vd,r[o])}function XM(i,t,e){const n=this.cache,s=t.length,r=xa(e,s);$e(n,r)||(i.uniform1iv(this.addr,r),je(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Wd,r[o])}function YM(i,t,e){const n=this.cache,s=t.length,r=xa(e,s);$e(n,r)||(i.uniform1iv(this.addr,r),je(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Xd,r[o])}function qM(i,t,e){const n=this.cache,s=t.length,r=xa(e,s);$e(n,r)||(i.uniform1iv(this.addr,r),je(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Gd,r[o])}function $M(i){switch(i){case 5126:return CM;case 35664:return PM;case 35665:return LM;case 35666:return DM;case 35674:return UM;case 35675:return IM;case 35676:return NM;case 5124:case 35670:return FM;case 35667:case 35671:return OM;case 35668:case 35672:return BM;case 35669:case 35673:return kM;case 5125:return zM;case 36294:return HM;case 36295:return VM;case 36296:return GM;case 35678:case 36198:case 36298:case 36306:case 35682:return WM;case 35679:case 36299:case 36307:return XM;case 35680:case 36300:case 36308:case 36293:return YM;case 36289:case 36303:case 36311:case 36292:return qM}}class jM{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=RM(e.type)}}class KM{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=$M(e.type)}}class ZM{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],n)}}}const dl=/(\w+)(\])?(\[|\.)?/g;function ju(i,t){i.seq.push(t),i.map[t.id]=t}function JM(i,t,e){const n=i.name,s=n.length;for(dl.lastIndex=0;;){const r=dl.exec(n),o=dl.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ju(e,c===void 0?new jM(a,i,t):new KM(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new ZM(a),ju(e,u)),e=u}}}class ta{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);JM(r,o,this)}}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&n.push(o)}return n}}function Ku(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const QM=37297;let tS=0;function eS(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}const Zu=new Jt;function nS(i){ce._getMatrix(Zu,ce.workingColorSpace,i);const t=`mat3( ${Zu.elements.map(e=>e.toFixed(4))} )`;switch(ce.getTransfer(i)){case _a:return[t,"LinearTransferOETF"];case Ee:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Ju(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+eS(i.getShaderSource(t),o)}else return s}function iS(i,t){const e=nS(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function sS(i,t){let e;switch(t){case x_:e="Linear";break;case M_:e="Reinhard";break;case S_:e="Cineon";break;case y_:e="ACESFilmic";break;case b_:e="AgX";break;case T_:e="Neutral";break;case E_:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const ko=new V;function rS(){ce.getLuminanceCoefficients(ko);const i=ko.x.toFixed(4),t=ko.y.toFixed(4),e=ko.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function oS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Yr).join(`
`)}function aS(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function lS(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Yr(i){return i!==""}function Qu(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function tf(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const cS=/^[ \t]*#include +<([\w\d./]+)>/gm;function _c(i){return i.replace(cS,uS)}const hS=new Map;function uS(i,t){let e=te[t];if(e===void 0){const n=hS.get(t);if(n!==void 0)e=te[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return _c(e)}const fS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function ef(i){return i.replace(fS,dS)}function dS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function nf(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function pS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===md?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===Jg?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Ci&&(t="SHADOWMAP_TYPE_VSM"),t}function mS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case _r:case vr:t="ENVMAP_TYPE_CUBE";break;case ga:t="ENVMAP_TYPE_CUBE_UV";break}return t}function gS(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case vr:t="ENVMAP_MODE_REFRACTION";break}return t}function _S(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case gd:t="ENVMAP_BLENDING_MULTIPLY";break;case __:t="ENVMAP_BLENDING_MIX";break;case v_:t="ENVMAP_BLENDING_ADD";break}return t}function vS(i){const t=i.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function xS(i,t,e,n){const s=i.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=pS(e),c=mS(e),h=gS(e),u=_S(e),f=vS(e),m=oS(e),_=aS(r),x=s.createProgram();let p,d,T=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(Yr).join(`
`),p.length>0&&(p+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(Yr).join(`
`),d.length>0&&(d+=`
`)):(p=[nf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Yr).join(`
`),d=[nf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==es?"#define TONE_MAPPING":"",e.toneMapping!==es?te.tonemapping_pars_fragment:"",e.toneMapping!==es?sS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",te.colorspace_pars_fragment,iS("linearToOutputTexel",e.outputColorSpace),rS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Yr).join(`
`)),o=_c(o),o=Qu(o,e),o=tf(o,e),a=_c(a),a=Qu(a,e),a=tf(a,e),o=ef(o),a=ef(a),e.isRawShaderMaterial!==!0&&(T=`#version 300 es
`,p=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,d=["#define varying in",e.glslVersion===mu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===mu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);const A=T+p+o,y=T+d+a,z=Ku(s,s.VERTEX_SHADER,A),L=Ku(s,s.FRAGMENT_SHADER,y);s.attachShader(x,z),s.attachShader(x,L),e.index0AttributeName!==void 0?s.bindAttribLocation(x,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function D(C){if(i.debug.checkShaderErrors){const $=s.getProgramInfoLog(x).trim(),O=s.getShaderInfoLog(z).trim(),Z=s.getShaderInfoLog(L).trim();let q=!0,J=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(q=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,x,z,L);else{const j=Ju(s,z,"vertex"),Q=Ju(s,L,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+$+`
`+j+`
`+Q)}else $!==""?console.warn("THREE.WebGLProgram: Program Info Log:",$):(O===""||Z==="")&&(J=!1);J&&(C.diagnostics={runnable:q,programLog:$,vertexShader:{log:O,prefix:p},fragmentShader:{log:Z,prefix:d}})}s.deleteShader(z),s.deleteShader(L),I=new ta(s,x),b=lS(s,x)}let I;this.getUniforms=function(){return I===void 0&&D(this),I};let b;this.getAttributes=function(){return b===void 0&&D(this),b};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(x,QM)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=tS++,this.cacheKey=t,this.usedTimes=1,this.program=x,this.vertexShader=z,this.fragmentShader=L,this}let MS=0;class SS{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new yS(t),e.set(t,n)),n}}class yS{constructor(t){this.id=MS++,this.code=t,this.usedTimes=0}}function ES(i,t,e,n,s,r,o){const a=new Gc,l=new SS,c=new Set,h=[],u=s.logarithmicDepthBuffer,f=s.vertexTextures;let m=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(b){return c.add(b),b===0?"uv":`uv${b}`}function p(b,S,C,$,O){const Z=$.fog,q=O.geometry,J=b.isMeshStandardMaterial?$.environment:null,j=(b.isMeshStandardMaterial?e:t).get(b.envMap||J),Q=j&&j.mapping===ga?j.image.height:null,ut=_[b.type];b.precision!==null&&(m=s.getMaxPrecision(b.precision),m!==b.precision&&console.warn("THREE.WebGLProgram.getParameters:",b.precision,"not supported, using",m,"instead."));const ct=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,mt=ct!==void 0?ct.length:0;let Mt=0;q.morphAttributes.position!==void 0&&(Mt=1),q.morphAttributes.normal!==void 0&&(Mt=2),q.morphAttributes.color!==void 0&&(Mt=3);let pt,it,at,gt;if(ut){const me=pi[ut];pt=me.vertexShader,it=me.fragmentShader}else pt=b.vertexShader,it=b.fragmentShader,l.update(b),at=l.getVertexShaderID(b),gt=l.getFragmentShaderID(b);const ot=i.getRenderTarget(),kt=i.state.buffers.depth.getReversed(),Ht=O.isInstancedMesh===!0,It=O.isBatchedMesh===!0,oe=!!b.map,jt=!!b.matcap,ae=!!j,B=!!b.aoMap,Ge=!!b.lightMap,Zt=!!b.bumpMap,Qt=!!b.normalMap,Vt=!!b.displacementMap,he=!!b.emissiveMap,Pt=!!b.metalnessMap,R=!!b.roughnessMap,M=b.anisotropy>0,Y=b.clearcoat>0,K=b.dispersion>0,H=b.iridescence>0,tt=b.sheen>0,St=b.transmission>0,_t=M&&!!b.anisotropyMap,Tt=Y&&!!b.clearcoatMap,$t=Y&&!!b.clearcoatNormalMap,ft=Y&&!!b.clearcoatRoughnessMap,vt=H&&!!b.iridescenceMap,Nt=H&&!!b.iridescenceThicknessMap,Ot=tt&&!!b.sheenColorMap,Et=tt&&!!b.sheenRoughnessMap,ne=!!b.specularMap,Yt=!!b.specularColorMap,ue=!!b.specularIntensityMap,F=St&&!!b.transmissionMap,xt=St&&!!b.thicknessMap,et=!!b.gradientMap,rt=!!b.alphaMap,wt=b.alphaTest>0,At=!!b.alphaHash,Kt=!!b.extensions;let Ue=es;b.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Ue=i.toneMapping);const Ze={shaderID:ut,shaderType:b.type,shaderName:b.name,vertexShader:pt,fragmentShader:it,defines:b.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:m,batching:It,batchingColor:It&&O._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&O.instanceColor!==null,instancingMorph:Ht&&O.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ot===null?i.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:Ds,alphaToCoverage:!!b.alphaToCoverage,map:oe,matcap:jt,envMap:ae,envMapMode:ae&&j.mapping,envMapCubeUVHeight:Q,aoMap:B,lightMap:Ge,bumpMap:Zt,normalMap:Qt,displacementMap:f&&Vt,emissiveMap:he,normalMapObjectSpace:Qt&&b.normalMapType===P_,normalMapTangentSpace:Qt&&b.normalMapType===C_,metalnessMap:Pt,roughnessMap:R,anisotropy:M,anisotropyMap:_t,clearcoat:Y,clearcoatMap:Tt,clearcoatNormalMap:$t,clearcoatRoughnessMap:ft,dispersion:K,iridescence:H,iridescenceMap:vt,iridescenceThicknessMap:Nt,sheen:tt,sheenColorMap:Ot,sheenRoughnessMap:Et,specularMap:ne,specularColorMap:Yt,specularIntensityMap:ue,transmission:St,transmissionMap:F,thicknessMap:xt,gradientMap:et,opaque:b.transparent===!1&&b.blending===cr&&b.alphaToCoverage===!1,alphaMap:rt,alphaTest:wt,alphaHash:At,combine:b.combine,mapUv:oe&&x(b.map.channel),aoMapUv:B&&x(b.aoMap.channel),lightMapUv:Ge&&x(b.lightMap.channel),bumpMapUv:Zt&&x(b.bumpMap.channel),normalMapUv:Qt&&x(b.normalMap.channel),displacementMapUv:Vt&&x(b.displacementMap.channel),emissiveMapUv:he&&x(b.emissiveMap.channel),metalnessMapUv:Pt&&x(b.metalnessMap.channel),roughnessMapUv:R&&x(b.roughnessMap.channel),anisotropyMapUv:_t&&x(b.anisotropyMap.channel),clearcoatMapUv:Tt&&x(b.clearcoatMap.channel),clearcoatNormalMapUv:$t&&x(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&x(b.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&x(b.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&x(b.iridescenceThicknessMap.channel),sheenColorMapUv:Ot&&x(b.sheenColorMap.channel),sheenRoughnessMapUv:Et&&x(b.sheenRoughnessMap.channel),specularMapUv:ne&&x(b.specularMap.channel),specularColorMapUv:Yt&&x(b.specularColorMap.channel),specularIntensityMapUv:ue&&x(b.specularIntensityMap.channel),transmissionMapUv:F&&x(b.transmissionMap.channel),thicknessMapUv:xt&&x(b.thicknessMap.channel),alphaMapUv:rt&&x(b.alphaMap.channel),vertexTangents:!!q.attributes.tangent&&(Qt||M),vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!q.attributes.uv&&(oe||rt),fog:!!Z,useFog:b.fog===!0,fogExp2:!!Z&&Z.isFogExp2,flatShading:b.flatShading===!0,sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:kt,skinning:O.isSkinnedMesh===!0,morphTargets:q.morphAttributes.position!==void 0,morphNormals:q.morphAttributes.normal!==void 0,morphColors:q.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:Mt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ue,decodeVideoTexture:oe&&b.map.isVideoTexture===!0&&ce.getTransfer(b.map.colorSpace)===Ee,decodeVideoTextureEmissive:he&&b.emissiveMap.isVideoTexture===!0&&ce.getTransfer(b.emissiveMap.colorSpace)===Ee,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===gi,flipSided:b.side===Tn,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:Kt&&b.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&b.extensions.multiDraw===!0||It)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return Ze.vertexUv1s=c.has(1),Ze.vertexUv2s=c.has(2),Ze.vertexUv3s=c.has(3),c.clear(),Ze}function d(b){const S=[];if(b.shaderID?S.push(b.shaderID):(S.push(b.customVertexShaderID),S.push(b.customFragmentShaderID)),b.defines!==void 0)for(const C in b.defines)S.push(C),S.push(b.defines[C]);return b.isRawShaderMaterial===!1&&(T(S,b),A(S,b),S.push(i.outputColorSpace)),S.push(b.customProgramCacheKey),S.join()}function T(b,S){b.push(S.precision),b.push(S.outputColorSpace),b.push(S.envMapMode),b.push(S.envMapCubeUVHeight),b.push(S.mapUv),b.push(S.alphaMapUv),b.push(S.lightMapUv),b.push(S.aoMapUv),b.push(S.bumpMapUv),b.push(S.normalMapUv),b.push(S.displacementMapUv),b.push(S.emissiveMapUv),b.push(S.metalnessMapUv),b.push(S.roughnessMapUv),b.push(S.anisotropyMapUv),b.push(S.clearcoatMapUv),b.push(S.clearcoatNormalMapUv),b.push(S.clearcoatRoughnessMapUv),b.push(S.iridescenceMapUv),b.push(S.iridescenceThicknessMapUv),b.push(S.sheenColorMapUv),b.push(S.sheenRoughnessMapUv),b.push(S.specularMapUv),b.push(S.specularColorMapUv),b.push(S.specularIntensityMapUv),b.push(S.transmissionMapUv),b.push(S.thicknessMapUv),b.push(S.combine),b.push(S.fogExp2),b.push(S.sizeAttenuation),b.push(S.morphTargetsCount),b.push(S.morphAttributeCount),b.push(S.numDirLights),b.push(S.numPointLights),b.push(S.numSpotLights),b.push(S.numSpotLightMaps),b.push(S.numHemiLights),b.push(S.numRectAreaLights),b.push(S.numDirLightShadows),b.push(S.numPointLightShadows),b.push(S.numSpotLightShadows),b.push(S.numSpotLightShadowsWithMaps),b.push(S.numLightProbes),b.push(S.shadowMapType),b.push(S.toneMapping),b.push(S.numClippingPlanes),b.push(S.numClipIntersection),b.push(S.depthPacking)}function A(b,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),b.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),b.push(a.mask)}function y(b){const S=_[b.type];let C;if(S){const $=pi[S];C=o0.clone($.uniforms)}else C=b.uniforms;return C}function z(b,S){let C;for(let $=0,O=h.length;$<O;$++){const Z=h[$];if(Z.cacheKey===S){C=Z,++C.usedTimes;break}}return C===void 0&&(C=new xS(i,S,b,r),h.push(C)),C}function L(b){if(--b.usedTimes===0){const S=h.indexOf(b);h[S]=h[h.length-1],h.pop(),b.destroy()}}function D(b){l.remove(b)}function I(){l.dispose()}return{getParameters:p,getProgramCacheKey:d,getUniforms:y,acquireProgram:z,releaseProgram:L,releaseShaderCache:D,programs:h,dispose:I}}function bS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function TS(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function sf(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function rf(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u,f,m,_,x,p){let d=i[t];return d===void 0?(d={id:u.id,object:u,geometry:f,material:m,groupOrder:_,renderOrder:u.renderOrder,z:x,group:p},i[t]=d):(d.id=u.id,d.object=u,d.geometry=f,d.material=m,d.groupOrder=_,d.renderOrder=u.renderOrder,d.z=x,d.group=p),t++,d}function a(u,f,m,_,x,p){const d=o(u,f,m,_,x,p);m.transmission>0?n.push(d):m.transparent===!0?s.push(d):e.push(d)}function l(u,f,m,_,x,p){const d=o(u,f,m,_,x,p);m.transmission>0?n.unshift(d):m.transparent===!0?s.unshift(d):e.unshift(d)}function c(u,f){e.length>1&&e.sort(u||TS),n.length>1&&n.sort(f||sf),s.length>1&&s.sort(f||sf)}function h(){for(let u=t,f=i.length;u<f;u++){const m=i[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function wS(){let i=new WeakMap;function t(n,s){const r=i.get(n);let o;return r===void 0?(o=new rf,i.set(n,[o])):s>=r.length?(o=new rf,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function AS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new V,color:new Me};break;case"SpotLight":e={position:new V,direction:new V,color:new Me,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new V,color:new Me,distance:0,decay:0};break;case"HemisphereLight":e={direction:new V,skyColor:new Me,groundColor:new Me};break;case"RectAreaLight":e={color:new Me,position:new V,halfWidth:new V,halfHeight:new V};break}return i[t.id]=e,e}}}function RS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let CS=0;function PS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function LS(i){const t=new AS,e=RS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new V);const s=new V,r=new Fe,o=new Fe;function a(c){let h=0,u=0,f=0;for(let b=0;b<9;b++)n.probe[b].set(0,0,0);let m=0,_=0,x=0,p=0,d=0,T=0,A=0,y=0,z=0,L=0,D=0;c.sort(PS);for(let b=0,S=c.length;b<S;b++){const C=c[b],$=C.color,O=C.intensity,Z=C.distance,q=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=$.r*O,u+=$.g*O,f+=$.b*O;else if(C.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(C.sh.coefficients[J],O);D++}else if(C.isDirectionalLight){const J=t.get(C);if(J.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const j=C.shadow,Q=e.get(C);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,n.directionalShadow[m]=Q,n.directionalShadowMap[m]=q,n.directionalShadowMatrix[m]=C.shadow.matrix,T++}n.directional[m]=J,m++}else if(C.isSpotLight){const J=t.get(C);J.position.setFromMatrixPosition(C.matrixWorld),J.color.copy($).multiplyScalar(O),J.distance=Z,J.coneCos=Math.cos(C.angle),J.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),J.decay=C.decay,n.spot[x]=J;const j=C.shadow;if(C.map&&(n.spotLightMap[z]=C.map,z++,j.updateMatrices(C),C.castShadow&&L++),n.spotLightMatrix[x]=j.matrix,C.castShadow){const Q=e.get(C);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,n.spotShadow[x]=Q,n.spotShadowMap[x]=q,y++}x++}else if(C.isRectAreaLight){const J=t.get(C);J.color.copy($).multiplyScalar(O),J.halfWidth.set(C.width*.5,0,0),J.halfHeight.set(0,C.height*.5,0),n.rectArea[p]=J,p++}else if(C.isPointLight){const J=t.get(C);if(J.color.copy(C.color).multiplyScalar(C.intensity),J.distance=C.distance,J.decay=C.decay,C.castShadow){const j=C.shadow,Q=e.get(C);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,Q.shadowCameraNear=j.camera.near,Q.shadowCameraFar=j.camera.far,n.pointShadow[_]=Q,n.pointShadowMap[_]=q,n.pointShadowMatrix[_]=C.shadow.matrix,A++}n.point[_]=J,_++}else if(C.isHemisphereLight){const J=t.get(C);J.skyColor.copy(C.color).multiplyScalar(O),J.groundColor.copy(C.groundColor).multiplyScalar(O),n.hemi[d]=J,d++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=bt.LTC_FLOAT_1,n.rectAreaLTC2=bt.LTC_FLOAT_2):(n.rectAreaLTC1=bt.LTC_HALF_1,n.rectAreaLTC2=bt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;const I=n.hash;(I.directionalLength!==m||I.pointLength!==_||I.spotLength!==x||I.rectAreaLength!==p||I.hemiLength!==d||I.numDirectionalShadows!==T||I.numPointShadows!==A||I.numSpotShadows!==y||I.numSpotMaps!==z||I.numLightProbes!==D)&&(n.directional.length=m,n.spot.length=x,n.rectArea.length=p,n.point.length=_,n.hemi.length=d,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.pointShadow.length=A,n.pointShadowMap.length=A,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=T,n.pointShadowMatrix.length=A,n.spotLightMatrix.length=y+z-L,n.spotLightMap.length=z,n.numSpotLightShadowsWithMaps=L,n.numLightProbes=D,I.directionalLength=m,I.pointLength=_,I.spotLength=x,I.rectAreaLength=p,I.hemiLength=d,I.numDirectionalShadows=T,I.numPointShadows=A,I.numSpotShadows=y,I.numSpotMaps=z,I.numLightProbes=D,n.version=CS++)}function l(c,h){let u=0,f=0,m=0,_=0,x=0;const p=h.matrixWorldInverse;for(let d=0,T=c.length;d<T;d++){const A=c[d];if(A.isDirectionalLight){const y=n.directional[u];y.direction.setFromMatrixPosition(A.matrixWorld),s.setFromMatrixPosition(A.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(p),u++}else if(A.isSpotLight){const y=n.spot[m];y.position.setFromMatrixPosition(A.matrixWorld),y.position.applyMatrix4(p),y.direction.setFromMatrixPosition(A.matrixWorld),s.setFromMatrixPosition(A.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(p),m++}else if(A.isRectAreaLight){const y=n.rectArea[_];y.position.setFromMatrixPosition(A.matrixWorld),y.position.applyMatrix4(p),o.identity(),r.copy(A.matrixWorld),r.premultiply(p),o.extractRotation(r),y.halfWidth.set(A.width*.5,0,0),y.halfHeight.set(0,A.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),_++}else if(A.isPointLight){const y=n.point[f];y.position.setFromMatrixPosition(A.matrixWorld),y.position.applyMatrix4(p),f++}else if(A.isHemisphereLight){const y=n.hemi[x];y.direction.setFromMatrixPosition(A.matrixWorld),y.direction.transformDirection(p),x++}}}return{setup:a,setupView:l,state:n}}function of(i){const t=new LS(i),e=[],n=[];function s(h){c.camera=h,e.length=0,n.length=0}function r(h){e.push(h)}function o(h){n.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}const c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function DS(i){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new of(i),t.set(s,[a])):r>=o.length?(a=new of(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}class US extends Tr{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=A_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class IS extends Tr{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const NS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,FS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function OS(i,t,e){let n=new Bd;const s=new ee,r=new ee,o=new ke,a=new US({depthPacking:R_}),l=new IS,c={},h=e.maxTextureSize,u={[is]:Tn,[Tn]:is,[gi]:gi},f=new ss({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ee},radius:{value:4}},vertexShader:NS,fragmentShader:FS}),m=f.clone();m.defines.HORIZONTAL_PASS=1;const _=new Xn;_.setAttribute("position",new An(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const x=new vi(_,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=md;let d=this.type;this.render=function(L,D,I){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||L.length===0)return;const b=i.getRenderTarget(),S=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),$=i.state;$.setBlending(ts),$.buffers.color.setClear(1,1,1,1),$.buffers.depth.setTest(!0),$.setScissorTest(!1);const O=d!==Ci&&this.type===Ci,Z=d===Ci&&this.type!==Ci;for(let q=0,J=L.length;q<J;q++){const j=L[q],Q=j.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",j,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);const ut=Q.getFrameExtents();if(s.multiply(ut),r.copy(Q.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ut.x),s.x=r.x*ut.x,Q.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ut.y),s.y=r.y*ut.y,Q.mapSize.y=r.y)),Q.map===null||O===!0||Z===!0){const mt=this.type!==Ci?{minFilter:ii,magFilter:ii}:{};Q.map!==null&&Q.map.dispose(),Q.map=new Cs(s.x,s.y,mt),Q.map.texture.name=j.name+".shadowMap",Q.camera.updateProjectionMatrix()}i.setRenderTarget(Q.map),i.clear();const ct=Q.getViewportCount();for(let mt=0;mt<ct;mt++){const Mt=Q.getViewport(mt);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),$.viewport(o),Q.updateMatrices(j,mt),n=Q.getFrustum(),y(D,I,Q.camera,j,this.type)}Q.isPointLightShadow!==!0&&this.type===Ci&&T(Q,I),Q.needsUpdate=!1}d=this.type,p.needsUpdate=!1,i.setRenderTarget(b,S,C)};function T(L,D){const I=t.update(x);f.defines.VSM_SAMPLES!==L.blurSamples&&(f.defines.VSM_SAMPLES=L.blurSamples,m.defines.VSM_SAMPLES=L.blurSamples,f.needsUpdate=!0,m.needsUpdate=!0),L.mapPass===null&&(L.mapPass=new Cs(s.x,s.y)),f.uniforms.shadow_pass.value=L.map.texture,f.uniforms.resolution.value=L.mapSize,f.uniforms.radius.value=L.radius,i.setRenderTarget(L.mapPass),i.clear(),i.renderBufferDirect(D,null,I,f,x,null),m.uniforms.shadow_pass.value=L.mapPass.texture,m.uniforms.resolution.value=L.mapSize,m.uniforms.radius.value=L.radius,i.setRenderTarget(L.map),i.clear(),i.renderBufferDirect(D,null,I,m,x,null)}function A(L,D,I,b){let S=null;const C=I.isPointLight===!0?L.customDistanceMaterial:L.customDepthMaterial;if(C!==void 0)S=C;else if(S=I.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const $=S.uuid,O=D.uuid;let Z=c[$];Z===void 0&&(Z={},c[$]=Z);let q=Z[O];q===void 0&&(q=S.clone(),Z[O]=q,D.addEventListener("dispose",z)),S=q}if(S.visible=D.visible,S.wireframe=D.wireframe,b===Ci?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:u[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,I.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const $=i.properties.get(S);$.light=I}return S}function y(L,D,I,b,S){if(L.visible===!1)return;if(L.layers.test(D.layers)&&(L.isMesh||L.isLine||L.isPoints)&&(L.castShadow||L.receiveShadow&&S===Ci)&&(!L.frustumCulled||n.intersectsObject(L))){L.modelViewMatrix.multiplyMatrices(I.matrixWorldInverse,L.matrixWorld);const O=t.update(L),Z=L.material;if(Array.isArray(Z)){const q=O.groups;for(let J=0,j=q.length;J<j;J++){const Q=q[J],ut=Z[Q.materialIndex];if(ut&&ut.visible){const ct=A(L,ut,b,S);L.onBeforeShadow(i,L,D,I,O,ct,Q),i.renderBufferDirect(I,null,O,ct,L,Q),L.onAfterShadow(i,L,D,I,O,ct,Q)}}}else if(Z.visible){const q=A(L,Z,b,S);L.onBeforeShadow(i,L,D,I,O,q,null),i.renderBufferDirect(I,null,O,q,L,null),L.onAfterShadow(i,L,D,I,O,q,null)}}const $=L.children;for(let O=0,Z=$.length;O<Z;O++)y($[O],D,I,b,S)}function z(L){L.target.removeEventListener("dispose",z);for(const I in c){const b=c[I],S=L.target.uuid;S in b&&(b[S].dispose(),delete b[S])}}}const BS={[Ul]:Il,[Nl]:Bl,[Fl]:kl,[gr]:Ol,[Il]:Ul,[Bl]:Nl,[kl]:Fl,[Ol]:gr};function kS(i,t){function e(){let F=!1;const xt=new ke;let et=null;const rt=new ke(0,0,0,0);return{setMask:function(wt){et!==wt&&!F&&(i.colorMask(wt,wt,wt,wt),et=wt)},setLocked:function(wt){F=wt},setClear:function(wt,At,Kt,Ue,Ze){Ze===!0&&(wt*=Ue,At*=Ue,Kt*=Ue),xt.set(wt,At,Kt,Ue),rt.equals(xt)===!1&&(i.clearColor(wt,At,Kt,Ue),rt.copy(xt))},reset:function(){F=!1,et=null,rt.set(-1,0,0,0)}}}function n(){let F=!1,xt=!1,et=null,rt=null,wt=null;return{setReversed:function(At){if(xt!==At){const Kt=t.get("EXT_clip_control");xt?Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.ZERO_TO_ONE_EXT):Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.NEGATIVE_ONE_TO_ONE_EXT);const Ue=wt;wt=null,this.setClear(Ue)}xt=At},getReversed:function(){return xt},setTest:function(At){At?ot(i.DEPTH_TEST):kt(i.DEPTH_TEST)},setMask:function(At){et!==At&&!F&&(i.depthMask(At),et=At)},setFunc:function(At){if(xt&&(At=BS[At]),rt!==At){switch(At){case Ul:i.depthFunc(i.NEVER);break;case Il:i.depthFunc(i.ALWAYS);break;case Nl:i.depthFunc(i.LESS);break;case gr:i.depthFunc(i.LEQUAL);break;case Fl:i.depthFunc(i.EQUAL);break;case Ol:i.depthFunc(i.GEQUAL);break;case Bl:i.depthFunc(i.GREATER);break;case kl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}rt=At}},setLocked:function(At){F=At},setClear:function(At){wt!==At&&(xt&&(At=1-At),i.clearDepth(At),wt=At)},reset:function(){F=!1,et=null,rt=null,wt=null,xt=!1}}}function s(){let F=!1,xt=null,et=null,rt=null,wt=null,At=null,Kt=null,Ue=null,Ze=null;return{setTest:function(me){F||(me?ot(i.STENCIL_TEST):kt(i.STENCIL_TEST))},setMask:function(me){xt!==me&&!F&&(i.stencilMask(me),xt=me)},setFunc:function(me,We,Re){(et!==me||rt!==We||wt!==Re)&&(i.stencilFunc(me,We,Re),et=me,rt=We,wt=Re)},setOp:function(me,We,Re){(At!==me||Kt!==We||Ue!==Re)&&(i.stencilOp(me,We,Re),At=me,Kt=We,Ue=Re)},setLocked:function(me){F=me},setClear:function(me){Ze!==me&&(i.clearStencil(me),Ze=me)},reset:function(){F=!1,xt=null,et=null,rt=null,wt=null,At=null,Kt=null,Ue=null,Ze=null}}}const r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap;let h={},u={},f=new WeakMap,m=[],_=null,x=!1,p=null,d=null,T=null,A=null,y=null,z=null,L=null,D=new Me(0,0,0),I=0,b=!1,S=null,C=null,$=null,O=null,Z=null;const q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let J=!1,j=0;const Q=i.getParameter(i.VERSION);Q.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(Q)[1]),J=j>=1):Q.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),J=j>=2);let ut=null,ct={};const mt=i.getParameter(i.SCISSOR_BOX),Mt=i.getParameter(i.VIEWPORT),pt=new ke().fromArray(mt),it=new ke().fromArray(Mt);function at(F,xt,et,rt){const wt=new Uint8Array(4),At=i.createTexture();i.bindTexture(F,At),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Kt=0;Kt<et;Kt++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(xt,0,i.RGBA,1,1,rt,0,i.RGBA,i.UNSIGNED_BYTE,wt):i.texImage2D(xt+Kt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,wt);return At}const gt={};gt[i.TEXTURE_2D]=at(i.TEXTURE_2D,i.TEXTURE_2D,1),gt[i.TEXTURE_CUBE_MAP]=at(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[i.TEXTURE_2D_ARRAY]=at(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),gt[i.TEXTURE_3D]=at(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(i.DEPTH_TEST),o.setFunc(gr),Zt(!1),Qt(cu),ot(i.CULL_FACE),B(ts);function ot(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function kt(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function Ht(F,xt){return u[F]!==xt?(i.bindFramebuffer(F,xt),u[F]=xt,F===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=xt),F===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=xt),!0):!1}function It(F,xt){let et=m,rt=!1;if(F){et=f.get(xt),et===void 0&&(et=[],f.set(xt,et));const wt=F.textures;if(et.length!==wt.length||et[0]!==i.COLOR_ATTACHMENT0){for(let At=0,Kt=wt.length;At<Kt;At++)et[At]=i.COLOR_ATTACHMENT0+At;et.length=wt.length,rt=!0}}else et[0]!==i.BACK&&(et[0]=i.BACK,rt=!0);rt&&i.drawBuffers(et)}function oe(F){return _!==F?(i.useProgram(F),_=F,!0):!1}const jt={[Ss]:i.FUNC_ADD,[t_]:i.FUNC_SUBTRACT,[e_]:i.FUNC_REVERSE_SUBTRACT};jt[n_]=i.MIN,jt[i_]=i.MAX;const ae={[s_]:i.ZERO,[r_]:i.ONE,[o_]:i.SRC_COLOR,[Ll]:i.SRC_ALPHA,[f_]:i.SRC_ALPHA_SATURATE,[h_]:i.DST_COLOR,[l_]:i.DST_ALPHA,[a_]:i.ONE_MINUS_SRC_COLOR,[Dl]:i.ONE_MINUS_SRC_ALPHA,[u_]:i.ONE_MINUS_DST_COLOR,[c_]:i.ONE_MINUS_DST_ALPHA,[d_]:i.CONSTANT_COLOR,[p_]:i.ONE_MINUS_CONSTANT_COLOR,[m_]:i.CONSTANT_ALPHA,[g_]:i.ONE_MINUS_CONSTANT_ALPHA};function B(F,xt,et,rt,wt,At,Kt,Ue,Ze,me){if(F===ts){x===!0&&(kt(i.BLEND),x=!1);return}if(x===!1&&(ot(i.BLEND),x=!0),F!==Qg){if(F!==p||me!==b){if((d!==Ss||y!==Ss)&&(i.blendEquation(i.FUNC_ADD),d=Ss,y=Ss),me)switch(F){case cr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case hu:i.blendFunc(i.ONE,i.ONE);break;case uu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case fu:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}else switch(F){case cr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case hu:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case uu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case fu:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}T=null,A=null,z=null,L=null,D.set(0,0,0),I=0,p=F,b=me}return}wt=wt||xt,At=At||et,Kt=Kt||rt,(xt!==d||wt!==y)&&(i.blendEquationSeparate(jt[xt],jt[wt]),d=xt,y=wt),(et!==T||rt!==A||At!==z||Kt!==L)&&(i.blendFuncSeparate(ae[et],ae[rt],ae[At],ae[Kt]),T=et,A=rt,z=At,L=Kt),(Ue.equals(D)===!1||Ze!==I)&&(i.blendColor(Ue.r,Ue.g,Ue.b,Ze),D.copy(Ue),I=Ze),p=F,b=!1}function Ge(F,xt){F.side===gi?kt(i.CULL_FACE):ot(i.CULL_FACE);let et=F.side===Tn;xt&&(et=!et),Zt(et),F.blending===cr&&F.transparent===!1?B(ts):B(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);const rt=F.stencilWrite;a.setTest(rt),rt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),he(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?ot(i.SAMPLE_ALPHA_TO_COVERAGE):kt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Zt(F){S!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),S=F)}function Qt(F){F!==Kg?(ot(i.CULL_FACE),F!==C&&(F===cu?i.cullFace(i.BACK):F===Zg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):kt(i.CULL_FACE),C=F}function Vt(F){F!==$&&(J&&i.lineWidth(F),$=F)}function he(F,xt,et){F?(ot(i.POLYGON_OFFSET_FILL),(O!==xt||Z!==et)&&(i.polygonOffset(xt,et),O=xt,Z=et)):kt(i.POLYGON_OFFSET_FILL)}function Pt(F){F?ot(i.SCISSOR_TEST):kt(i.SCISSOR_TEST)}function R(F){F===void 0&&(F=i.TEXTURE0+q-1),ut!==F&&(i.activeTexture(F),ut=F)}function M(F,xt,et){et===void 0&&(ut===null?et=i.TEXTURE0+q-1:et=ut);let rt=ct[et];rt===void 0&&(rt={type:void 0,texture:void 0},ct[et]=rt),(rt.type!==F||rt.texture!==xt)&&(ut!==et&&(i.activeTexture(et),ut=et),i.bindTexture(F,xt||gt[F]),rt.type=F,rt.texture=xt)}function Y(){const F=ct[ut];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function K(){try{i.compressedTexImage2D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function H(){try{i.compressedTexImage3D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function tt(){try{i.texSubImage2D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function St(){try{i.texSubImage3D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function _t(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function Tt(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function $t(){try{i.texStorage2D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function ft(){try{i.texStorage3D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function vt(){try{i.texImage2D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function Nt(){try{i.texImage3D.apply(i,arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function Ot(F){pt.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),pt.copy(F))}function Et(F){it.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),it.copy(F))}function ne(F,xt){let et=c.get(xt);et===void 0&&(et=new WeakMap,c.set(xt,et));let rt=et.get(F);rt===void 0&&(rt=i.getUniformBlockIndex(xt,F.name),et.set(F,rt))}function Yt(F,xt){const rt=c.get(xt).get(F);l.get(xt)!==rt&&(i.uniformBlockBinding(xt,rt,F.__bindingPointIndex),l.set(xt,rt))}function ue(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ut=null,ct={},u={},f=new WeakMap,m=[],_=null,x=!1,p=null,d=null,T=null,A=null,y=null,z=null,L=null,D=new Me(0,0,0),I=0,b=!1,S=null,C=null,$=null,O=null,Z=null,pt.set(0,0,i.canvas.width,i.canvas.height),it.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:kt,bindFramebuffer:Ht,drawBuffers:It,useProgram:oe,setBlending:B,setMaterial:Ge,setFlipSided:Zt,setCullFace:Qt,setLineWidth:Vt,setPolygonOffset:he,setScissorTest:Pt,activeTexture:R,bindTexture:M,unbindTexture:Y,compressedTexImage2D:K,compressedTexImage3D:H,texImage2D:vt,texImage3D:Nt,updateUBOMapping:ne,uniformBlockBinding:Yt,texStorage2D:$t,texStorage3D:ft,texSubImage2D:tt,texSubImage3D:St,compressedTexSubImage2D:_t,compressedTexSubImage3D:Tt,scissor:Ot,viewport:Et,reset:ue}}function af(i,t,e,n){const s=zS(n);switch(e){case Sd:return i*t;case Ed:return i*t;case bd:return i*t*2;case Td:return i*t/s.components*s.byteLength;case zc:return i*t/s.components*s.byteLength;case wd:return i*t*2/s.components*s.byteLength;case Hc:return i*t*2/s.components*s.byteLength;case yd:return i*t*3/s.components*s.byteLength;case ni:return i*t*4/s.components*s.byteLength;case Vc:return i*t*4/s.components*s.byteLength;case $o:case jo:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ko:case Zo:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Xl:case ql:return Math.max(i,16)*Math.max(t,8)/4;case Wl:case Yl:return Math.max(i,8)*Math.max(t,8)/2;case $l:case jl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Kl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Zl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Jl:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Ql:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case tc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ec:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case nc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case ic:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case sc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case rc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case oc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case ac:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case lc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case cc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case hc:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Jo:case uc:case fc:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ad:case dc:return Math.ceil(i/4)*Math.ceil(t/4)*8;case pc:case mc:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function zS(i){switch(i){case Bi:case vd:return{byteLength:1,components:1};case Qr:case xd:case to:return{byteLength:2,components:1};case Bc:case kc:return{byteLength:2,components:4};case Rs:case Oc:case Li:return{byteLength:4,components:1};case Md:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function HS(i,t,e,n,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ee,h=new WeakMap;let u;const f=new WeakMap;let m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(R,M){return m?new OffscreenCanvas(R,M):ra("canvas")}function x(R,M,Y){let K=1;const H=Pt(R);if((H.width>Y||H.height>Y)&&(K=Y/Math.max(H.width,H.height)),K<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){const tt=Math.floor(K*H.width),St=Math.floor(K*H.height);u===void 0&&(u=_(tt,St));const _t=M?_(tt,St):u;return _t.width=tt,_t.height=St,_t.getContext("2d").drawImage(R,0,0,tt,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+H.width+"x"+H.height+") to ("+tt+"x"+St+")."),_t}else return"data"in R&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+H.width+"x"+H.height+")."),R;return R}function p(R){return R.generateMipmaps}function d(R){i.generateMipmap(R)}function T(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(R,M,Y,K,H=!1){if(R!==null){if(i[R]!==void 0)return i[R];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let tt=M;if(M===i.RED&&(Y===i.FLOAT&&(tt=i.R32F),Y===i.HALF_FLOAT&&(tt=i.R16F),Y===i.UNSIGNED_BYTE&&(tt=i.R8)),M===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.R8UI),Y===i.UNSIGNED_SHORT&&(tt=i.R16UI),Y===i.UNSIGNED_INT&&(tt=i.R32UI),Y===i.BYTE&&(tt=i.R8I),Y===i.SHORT&&(tt=i.R16I),Y===i.INT&&(tt=i.R32I)),M===i.RG&&(Y===i.FLOAT&&(tt=i.RG32F),Y===i.HALF_FLOAT&&(tt=i.RG16F),Y===i.UNSIGNED_BYTE&&(tt=i.RG8)),M===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.RG8UI),Y===i.UNSIGNED_SHORT&&(tt=i.RG16UI),Y===i.UNSIGNED_INT&&(tt=i.RG32UI),Y===i.BYTE&&(tt=i.RG8I),Y===i.SHORT&&(tt=i.RG16I),Y===i.INT&&(tt=i.RG32I)),M===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(tt=i.RGB16UI),Y===i.UNSIGNED_INT&&(tt=i.RGB32UI),Y===i.BYTE&&(tt=i.RGB8I),Y===i.SHORT&&(tt=i.RGB16I),Y===i.INT&&(tt=i.RGB32I)),M===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(tt=i.RGBA16UI),Y===i.UNSIGNED_INT&&(tt=i.RGBA32UI),Y===i.BYTE&&(tt=i.RGBA8I),Y===i.SHORT&&(tt=i.RGBA16I),Y===i.INT&&(tt=i.RGBA32I)),M===i.RGB&&Y===i.UNSIGNED_INT_5_9_9_9_REV&&(tt=i.RGB9_E5),M===i.RGBA){const St=H?_a:ce.getTransfer(K);Y===i.FLOAT&&(tt=i.RGBA32F),Y===i.HALF_FLOAT&&(tt=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(tt=St===Ee?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT_4_4_4_4&&(tt=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(tt=i.RGB5_A1)}return(tt===i.R16F||tt===i.R32F||tt===i.RG16F||tt===i.RG32F||tt===i.RGBA16F||tt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),tt}function y(R,M){let Y;return R?M===null||M===Rs||M===xr?Y=i.DEPTH24_STENCIL8:M===Li?Y=i.DEPTH32F_STENCIL8:M===Qr&&(Y=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Rs||M===xr?Y=i.DEPTH_COMPONENT24:M===Li?Y=i.DEPTH_COMPONENT32F:M===Qr&&(Y=i.DEPTH_COMPONENT16),Y}function z(R,M){return p(R)===!0||R.isFramebufferTexture&&R.minFilter!==ii&&R.minFilter!==_i?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps!==void 0&&R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function L(R){const M=R.target;M.removeEventListener("dispose",L),I(M),M.isVideoTexture&&h.delete(M)}function D(R){const M=R.target;M.removeEventListener("dispose",D),S(M)}function I(R){const M=n.get(R);if(M.__webglInit===void 0)return;const Y=R.source,K=f.get(Y);if(K){const H=K[M.__cacheKey];H.usedTimes--,H.usedTimes===0&&b(R),Object.keys(K).length===0&&f.delete(Y)}n.remove(R)}function b(R){const M=n.get(R);i.deleteTexture(M.__webglTexture);const Y=R.source,K=f.get(Y);delete K[M.__cacheKey],o.memory.textures--}function S(R){const M=n.get(R);if(R.depthTexture&&(R.depthTexture.dispose(),n.remove(R.depthTexture)),R.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(M.__webglFramebuffer[K]))for(let H=0;H<M.__webglFramebuffer[K].length;H++)i.deleteFramebuffer(M.__webglFramebuffer[K][H]);else i.deleteFramebuffer(M.__webglFramebuffer[K]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[K])}else{if(Array.isArray(M.__webglFramebuffer))for(let K=0;K<M.__webglFramebuffer.length;K++)i.deleteFramebuffer(M.__webglFramebuffer[K]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let K=0;K<M.__webglColorRenderbuffer.length;K++)M.__webglColorRenderbuffer[K]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[K]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}const Y=R.textures;for(let K=0,H=Y.length;K<H;K++){const tt=n.get(Y[K]);tt.__webglTexture&&(i.deleteTexture(tt.__webglTexture),o.memory.textures--),n.remove(Y[K])}n.remove(R)}let C=0;function $(){C=0}function O(){const R=C;return R>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+R+" texture units while this GPU supports only "+s.maxTextures),C+=1,R}function Z(R){const M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function q(R,M){const Y=n.get(R);if(R.isVideoTexture&&Vt(R),R.isRenderTargetTexture===!1&&R.version>0&&Y.__version!==R.version){const K=R.image;if(K===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{it(Y,R,M);return}}e.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+M)}function J(R,M){const Y=n.get(R);if(R.version>0&&Y.__version!==R.version){it(Y,R,M);return}e.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+M)}function j(R,M){const Y=n.get(R);if(R.version>0&&Y.__version!==R.version){it(Y,R,M);return}e.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+M)}function Q(R,M){const Y=n.get(R);if(R.version>0&&Y.__version!==R.version){at(Y,R,M);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+M)}const ut={[Vl]:i.REPEAT,[Es]:i.CLAMP_TO_EDGE,[Gl]:i.MIRRORED_REPEAT},ct={[ii]:i.NEAREST,[w_]:i.NEAREST_MIPMAP_NEAREST,[xo]:i.NEAREST_MIPMAP_LINEAR,[_i]:i.LINEAR,[za]:i.LINEAR_MIPMAP_NEAREST,[bs]:i.LINEAR_MIPMAP_LINEAR},mt={[L_]:i.NEVER,[O_]:i.ALWAYS,[D_]:i.LESS,[Rd]:i.LEQUAL,[U_]:i.EQUAL,[F_]:i.GEQUAL,[I_]:i.GREATER,[N_]:i.NOTEQUAL};function Mt(R,M){if(M.type===Li&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===_i||M.magFilter===za||M.magFilter===xo||M.magFilter===bs||M.minFilter===_i||M.minFilter===za||M.minFilter===xo||M.minFilter===bs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,ut[M.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,ut[M.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,ut[M.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,ct[M.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,ct[M.minFilter]),M.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,mt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===ii||M.minFilter!==xo&&M.minFilter!==bs||M.type===Li&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){const Y=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function pt(R,M){let Y=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L));const K=M.source;let H=f.get(K);H===void 0&&(H={},f.set(K,H));const tt=Z(M);if(tt!==R.__cacheKey){H[tt]===void 0&&(H[tt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),H[tt].usedTimes++;const St=H[R.__cacheKey];St!==void 0&&(H[R.__cacheKey].usedTimes--,St.usedTimes===0&&b(M)),R.__cacheKey=tt,R.__webglTexture=H[tt].texture}return Y}function it(R,M,Y){let K=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(K=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(K=i.TEXTURE_3D);const H=pt(R,M),tt=M.source;e.bindTexture(K,R.__webglTexture,i.TEXTURE0+Y);const St=n.get(tt);if(tt.version!==St.__version||H===!0){e.activeTexture(i.TEXTURE0+Y);const _t=ce.getPrimaries(ce.workingColorSpace),Tt=M.colorSpace===Ji?null:ce.getPrimaries(M.colorSpace),$t=M.colorSpace===Ji||_t===Tt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,$t);let ft=x(M.image,!1,s.maxTextureSize);ft=he(M,ft);const vt=r.convert(M.format,M.colorSpace),Nt=r.convert(M.type);let Ot=A(M.internalFormat,vt,Nt,M.colorSpace,M.isVideoTexture);Mt(K,M);let Et;const ne=M.mipmaps,Yt=M.isVideoTexture!==!0,ue=St.__version===void 0||H===!0,F=tt.dataReady,xt=z(M,ft);if(M.isDepthTexture)Ot=y(M.format===Mr,M.type),ue&&(Yt?e.texStorage2D(i.TEXTURE_2D,1,Ot,ft.width,ft.height):e.texImage2D(i.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,null));else if(M.isDataTexture)if(ne.length>0){Yt&&ue&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ne[0].width,ne[0].height);for(let et=0,rt=ne.length;et<rt;et++)Et=ne[et],Yt?F&&e.texSubImage2D(i.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(i.TEXTURE_2D,et,Ot,Et.width,Et.height,0,vt,Nt,Et.data);M.generateMipmaps=!1}else Yt?(ue&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ft.width,ft.height),F&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ft.width,ft.height,vt,Nt,ft.data)):e.texImage2D(i.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,ft.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){Yt&&ue&&e.texStorage3D(i.TEXTURE_2D_ARRAY,xt,Ot,ne[0].width,ne[0].height,ft.depth);for(let et=0,rt=ne.length;et<rt;et++)if(Et=ne[et],M.format!==ni)if(vt!==null)if(Yt){if(F)if(M.layerUpdates.size>0){const wt=af(Et.width,Et.height,M.format,M.type);for(const At of M.layerUpdates){const Kt=Et.data.subarray(At*wt/Et.data.BYTES_PER_ELEMENT,(At+1)*wt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,et,0,0,At,Et.width,Et.height,1,vt,Kt)}M.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,et,0,0,0,Et.width,Et.height,ft.depth,vt,Et.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,et,Ot,Et.width,Et.height,ft.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?F&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,et,0,0,0,Et.width,Et.height,ft.depth,vt,Nt,Et.data):e.texImage3D(i.TEXTURE_2D_ARRAY,et,Ot,Et.width,Et.height,ft.depth,0,vt,Nt,Et.data)}else{Yt&&ue&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ne[0].width,ne[0].height);for(let et=0,rt=ne.length;et<rt;et++)Et=ne[et],M.format!==ni?vt!==null?Yt?F&&e.compressedTexSubImage2D(i.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Et.data):e.compressedTexImage2D(i.TEXTURE_2D,et,Ot,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?F&&e.texSubImage2D(i.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(i.TEXTURE_2D,et,Ot,Et.width,Et.height,0,vt,Nt,Et.data)}else if(M.isDataArrayTexture)if(Yt){if(ue&&e.texStorage3D(i.TEXTURE_2D_ARRAY,xt,Ot,ft.width,ft.height,ft.depth),F)if(M.layerUpdates.size>0){const et=af(ft.width,ft.height,M.format,M.type);for(const rt of M.layerUpdates){const wt=ft.data.subarray(rt*et/ft.data.BYTES_PER_ELEMENT,(rt+1)*et/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,vt,Nt,wt)}M.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(M.isData3DTexture)Yt?(ue&&e.texStorage3D(i.TEXTURE_3D,xt,Ot,ft.width,ft.height,ft.depth),F&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)):e.texImage3D(i.TEXTURE_3D,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(M.isFramebufferTexture){if(ue)if(Yt)e.texStorage2D(i.TEXTURE_2D,xt,Ot,ft.width,ft.height);else{let et=ft.width,rt=ft.height;for(let wt=0;wt<xt;wt++)e.texImage2D(i.TEXTURE_2D,wt,Ot,et,rt,0,vt,Nt,null),et>>=1,rt>>=1}}else if(ne.length>0){if(Yt&&ue){const et=Pt(ne[0]);e.texStorage2D(i.TEXTURE_2D,xt,Ot,et.width,et.height)}for(let et=0,rt=ne.length;et<rt;et++)Et=ne[et],Yt?F&&e.texSubImage2D(i.TEXTURE_2D,et,0,0,vt,Nt,Et):e.texImage2D(i.TEXTURE_2D,et,Ot,vt,Nt,Et);M.generateMipmaps=!1}else if(Yt){if(ue){const et=Pt(ft);e.texStorage2D(i.TEXTURE_2D,xt,Ot,et.width,et.height)}F&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,vt,Nt,ft)}else e.texImage2D(i.TEXTURE_2D,0,Ot,vt,Nt,ft);p(M)&&d(K),St.__version=tt.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function at(R,M,Y){if(M.image.length!==6)return;const K=pt(R,M),H=M.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+Y);const tt=n.get(H);if(H.version!==tt.__version||K===!0){e.activeTexture(i.TEXTURE0+Y);const St=ce.getPrimaries(ce.workingColorSpace),_t=M.colorSpace===Ji?null:ce.getPrimaries(M.colorSpace),Tt=M.colorSpace===Ji||St===_t?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Tt);const $t=M.isCompressedTexture||M.image[0].isCompressedTexture,ft=M.image[0]&&M.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!$t&&!ft?vt[rt]=x(M.image[rt],!0,s.maxCubemapSize):vt[rt]=ft?M.image[rt].image:M.image[rt],vt[rt]=he(M,vt[rt]);const Nt=vt[0],Ot=r.convert(M.format,M.colorSpace),Et=r.convert(M.type),ne=A(M.internalFormat,Ot,Et,M.colorSpace),Yt=M.isVideoTexture!==!0,ue=tt.__version===void 0||K===!0,F=H.dataReady;let xt=z(M,Nt);Mt(i.TEXTURE_CUBE_MAP,M);let et;if($t){Yt&&ue&&e.texStorage2D(i.TEXTURE_CUBE_MAP,xt,ne,Nt.width,Nt.height);for(let rt=0;rt<6;rt++){et=vt[rt].mipmaps;for(let wt=0;wt<et.length;wt++){const At=et[wt];M.format!==ni?Ot!==null?Yt?F&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,0,0,At.width,At.height,Ot,At.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,ne,At.width,At.height,0,At.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?F&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,0,0,At.width,At.height,Ot,Et,At.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,ne,At.width,At.height,0,Ot,Et,At.data)}}}else{if(et=M.mipmaps,Yt&&ue){et.length>0&&xt++;const rt=Pt(vt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,xt,ne,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){Yt?F&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ot,Et,vt[rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ne,vt[rt].width,vt[rt].height,0,Ot,Et,vt[rt].data);for(let wt=0;wt<et.length;wt++){const Kt=et[wt].image[rt].image;Yt?F&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,0,0,Kt.width,Kt.height,Ot,Et,Kt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,ne,Kt.width,Kt.height,0,Ot,Et,Kt.data)}}else{Yt?F&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ot,Et,vt[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ne,Ot,Et,vt[rt]);for(let wt=0;wt<et.length;wt++){const At=et[wt];Yt?F&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,0,0,Ot,Et,At.image[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,ne,Ot,Et,At.image[rt])}}}p(M)&&d(i.TEXTURE_CUBE_MAP),tt.__version=H.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function gt(R,M,Y,K,H,tt){const St=r.convert(Y.format,Y.colorSpace),_t=r.convert(Y.type),Tt=A(Y.internalFormat,St,_t,Y.colorSpace),$t=n.get(M),ft=n.get(Y);if(ft.__renderTarget=M,!$t.__hasExternalTextures){const vt=Math.max(1,M.width>>tt),Nt=Math.max(1,M.height>>tt);H===i.TEXTURE_3D||H===i.TEXTURE_2D_ARRAY?e.texImage3D(H,tt,Tt,vt,Nt,M.depth,0,St,_t,null):e.texImage2D(H,tt,Tt,vt,Nt,0,St,_t,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),Qt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,K,H,ft.__webglTexture,0,Zt(M)):(H===i.TEXTURE_2D||H>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&H<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,K,H,ft.__webglTexture,tt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ot(R,M,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,R),M.depthBuffer){const K=M.depthTexture,H=K&&K.isDepthTexture?K.type:null,tt=y(M.stencilBuffer,H),St=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=Zt(M);Qt(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_t,tt,M.width,M.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,_t,tt,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,tt,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,R)}else{const K=M.textures;for(let H=0;H<K.length;H++){const tt=K[H],St=r.convert(tt.format,tt.colorSpace),_t=r.convert(tt.type),Tt=A(tt.internalFormat,St,_t,tt.colorSpace),$t=Zt(M);Y&&Qt(M)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,$t,Tt,M.width,M.height):Qt(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,$t,Tt,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,Tt,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function kt(R,M){if(M&&M.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const K=n.get(M.depthTexture);K.__renderTarget=M,(!K.__webglTexture||M.depthTexture.image.width!==M.width||M.depthTexture.image.height!==M.height)&&(M.depthTexture.image.width=M.width,M.depthTexture.image.height=M.height,M.depthTexture.needsUpdate=!0),q(M.depthTexture,0);const H=K.__webglTexture,tt=Zt(M);if(M.depthTexture.format===hr)Qt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,H,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,H,0);else if(M.depthTexture.format===Mr)Qt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,H,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,H,0);else throw new Error("Unknown depthTexture format")}function Ht(R){const M=n.get(R),Y=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){const K=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),K){const H=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,K.removeEventListener("dispose",H)};K.addEventListener("dispose",H),M.__depthDisposeCallback=H}M.__boundDepthTexture=K}if(R.depthTexture&&!M.__autoAllocateDepthBuffer){if(Y)throw new Error("target.depthTexture not supported in Cube render targets");kt(M.__webglFramebuffer,R)}else if(Y){M.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[K]),M.__webglDepthbuffer[K]===void 0)M.__webglDepthbuffer[K]=i.createRenderbuffer(),ot(M.__webglDepthbuffer[K],R,!1);else{const H=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,tt=M.__webglDepthbuffer[K];i.bindRenderbuffer(i.RENDERBUFFER,tt),i.framebufferRenderbuffer(i.FRAMEBUFFER,H,i.RENDERBUFFER,tt)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),ot(M.__webglDepthbuffer,R,!1);else{const K=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,H=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,H),i.framebufferRenderbuffer(i.FRAMEBUFFER,K,i.RENDERBUFFER,H)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function It(R,M,Y){const K=n.get(R);M!==void 0&&gt(K.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&Ht(R)}function oe(R){const M=R.texture,Y=n.get(R),K=n.get(M);R.addEventListener("dispose",D);const H=R.textures,tt=R.isWebGLCubeRenderTarget===!0,St=H.length>1;if(St||(K.__webglTexture===void 0&&(K.__webglTexture=i.createTexture()),K.__version=M.version,o.memory.textures++),tt){Y.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(M.mipmaps&&M.mipmaps.length>0){Y.__webglFramebuffer[_t]=[];for(let Tt=0;Tt<M.mipmaps.length;Tt++)Y.__webglFramebuffer[_t][Tt]=i.createFramebuffer()}else Y.__webglFramebuffer[_t]=i.createFramebuffer()}else{if(M.mipmaps&&M.mipmaps.length>0){Y.__webglFramebuffer=[];for(let _t=0;_t<M.mipmaps.length;_t++)Y.__webglFramebuffer[_t]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(St)for(let _t=0,Tt=H.length;_t<Tt;_t++){const $t=n.get(H[_t]);$t.__webglTexture===void 0&&($t.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Qt(R)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let _t=0;_t<H.length;_t++){const Tt=H[_t];Y.__webglColorRenderbuffer[_t]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[_t]);const $t=r.convert(Tt.format,Tt.colorSpace),ft=r.convert(Tt.type),vt=A(Tt.internalFormat,$t,ft,Tt.colorSpace,R.isXRRenderTarget===!0),Nt=Zt(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,Nt,vt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,Y.__webglColorRenderbuffer[_t])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),ot(Y.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(tt){e.bindTexture(i.TEXTURE_CUBE_MAP,K.__webglTexture),Mt(i.TEXTURE_CUBE_MAP,M);for(let _t=0;_t<6;_t++)if(M.mipmaps&&M.mipmaps.length>0)for(let Tt=0;Tt<M.mipmaps.length;Tt++)gt(Y.__webglFramebuffer[_t][Tt],R,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,Tt);else gt(Y.__webglFramebuffer[_t],R,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);p(M)&&d(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let _t=0,Tt=H.length;_t<Tt;_t++){const $t=H[_t],ft=n.get($t);e.bindTexture(i.TEXTURE_2D,ft.__webglTexture),Mt(i.TEXTURE_2D,$t),gt(Y.__webglFramebuffer,R,$t,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,0),p($t)&&d(i.TEXTURE_2D)}e.unbindTexture()}else{let _t=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(_t=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(_t,K.__webglTexture),Mt(_t,M),M.mipmaps&&M.mipmaps.length>0)for(let Tt=0;Tt<M.mipmaps.length;Tt++)gt(Y.__webglFramebuffer[Tt],R,M,i.COLOR_ATTACHMENT0,_t,Tt);else gt(Y.__webglFramebuffer,R,M,i.COLOR_ATTACHMENT0,_t,0);p(M)&&d(_t),e.unbindTexture()}R.depthBuffer&&Ht(R)}function jt(R){const M=R.textures;for(let Y=0,K=M.length;Y<K;Y++){const H=M[Y];if(p(H)){const tt=T(R),St=n.get(H).__webglTexture;e.bindTexture(tt,St),d(tt),e.unbindTexture()}}}const ae=[],B=[];function Ge(R){if(R.samples>0){if(Qt(R)===!1){const M=R.textures,Y=R.width,K=R.height;let H=i.COLOR_BUFFER_BIT;const tt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(R),_t=M.length>1;if(_t)for(let Tt=0;Tt<M.length;Tt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let Tt=0;Tt<M.length;Tt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(H|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(H|=i.STENCIL_BUFFER_BIT)),_t){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const $t=n.get(M[Tt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,$t,0)}i.blitFramebuffer(0,0,Y,K,0,0,Y,K,H,i.NEAREST),l===!0&&(ae.length=0,B.length=0,ae.push(i.COLOR_ATTACHMENT0+Tt),R.depthBuffer&&R.resolveDepthBuffer===!1&&(ae.push(tt),B.push(tt),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,B)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ae))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),_t)for(let Tt=0;Tt<M.length;Tt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const $t=n.get(M[Tt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.TEXTURE_2D,$t,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.resolveDepthBuffer===!1&&l){const M=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function Zt(R){return Math.min(s.maxSamples,R.samples)}function Qt(R){const M=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Vt(R){const M=o.render.frame;h.get(R)!==M&&(h.set(R,M),R.update())}function he(R,M){const Y=R.colorSpace,K=R.format,H=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||Y!==Ds&&Y!==Ji&&(ce.getTransfer(Y)===Ee?(K!==ni||H!==Bi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Y)),M}function Pt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=O,this.resetTextureUnits=$,this.setTexture2D=q,this.setTexture2DArray=J,this.setTexture3D=j,this.setTextureCube=Q,this.rebindTextures=It,this.setupRenderTarget=oe,this.updateRenderTargetMipmap=jt,this.updateMultisampleRenderTarget=Ge,this.setupDepthRenderbuffer=Ht,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=Qt}function VS(i,t){function e(n,s=Ji){let r;const o=ce.getTransfer(s);if(n===Bi)return i.UNSIGNED_BYTE;if(n===Bc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===kc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Md)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===vd)return i.BYTE;if(n===xd)return i.SHORT;if(n===Qr)return i.UNSIGNED_SHORT;if(n===Oc)return i.INT;if(n===Rs)return i.UNSIGNED_INT;if(n===Li)return i.FLOAT;if(n===to)return i.HALF_FLOAT;if(n===Sd)return i.ALPHA;if(n===yd)return i.RGB;if(n===ni)return i.RGBA;if(n===Ed)return i.LUMINANCE;if(n===bd)return i.LUMINANCE_ALPHA;if(n===hr)return i.DEPTH_COMPONENT;if(n===Mr)return i.DEPTH_STENCIL;if(n===Td)return i.RED;if(n===zc)return i.RED_INTEGER;if(n===wd)return i.RG;if(n===Hc)return i.RG_INTEGER;if(n===Vc)return i.RGBA_INTEGER;if(n===$o||n===jo||n===Ko||n===Zo)if(o===Ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===$o)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===jo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ko)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Zo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===$o)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===jo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ko)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Zo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Wl||n===Xl||n===Yl||n===ql)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Wl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Xl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Yl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ql)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===$l||n===jl||n===Kl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===$l||n===jl)return o===Ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Kl)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Zl||n===Jl||n===Ql||n===tc||n===ec||n===nc||n===ic||n===sc||n===rc||n===oc||n===ac||n===lc||n===cc||n===hc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Zl)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Jl)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ql)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===tc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ec)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===nc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ic)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===sc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===rc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===oc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ac)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===lc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===cc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===hc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Jo||n===uc||n===fc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Jo)return o===Ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===uc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===fc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ad||n===dc||n===pc||n===mc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Jo)return r.COMPRESSED_RED_RGTC1_EXT;if(n===dc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===pc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===mc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===xr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}class GS extends Wn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class qr extends Mn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const WS={type:"move"};class pl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new qr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new qr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new qr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const x of t.hand.values()){const p=e.getJointPose(x,n),d=this._getHandJoint(c,x);p!==null&&(d.matrix.fromArray(p.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=p.radius),d.visible=p!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),m=.02,_=.005;c.inputState.pinching&&f>m+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=m-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(WS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new qr;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const XS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YS=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class qS{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){const s=new wn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new ss({vertexShader:XS,fragmentShader:YS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new vi(new va(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class $S extends Us{constructor(t,e){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,m=null,_=null;const x=new qS,p=e.getContextAttributes();let d=null,T=null;const A=[],y=[],z=new ee;let L=null;const D=new Wn;D.viewport=new ke;const I=new Wn;I.viewport=new ke;const b=[D,I],S=new GS;let C=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let at=A[it];return at===void 0&&(at=new pl,A[it]=at),at.getTargetRaySpace()},this.getControllerGrip=function(it){let at=A[it];return at===void 0&&(at=new pl,A[it]=at),at.getGripSpace()},this.getHand=function(it){let at=A[it];return at===void 0&&(at=new pl,A[it]=at),at.getHandSpace()};function O(it){const at=y.indexOf(it.inputSource);if(at===-1)return;const gt=A[at];gt!==void 0&&(gt.update(it.inputSource,it.frame,c||o),gt.dispatchEvent({type:it.type,data:it.inputSource}))}function Z(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",Z),s.removeEventListener("inputsourceschange",q);for(let it=0;it<A.length;it++){const at=y[it];at!==null&&(y[it]=null,A[it].disconnect(at))}C=null,$=null,x.reset(),t.setRenderTarget(d),m=null,f=null,u=null,s=null,T=null,pt.stop(),n.isPresenting=!1,t.setPixelRatio(L),t.setSize(z.width,z.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return f!==null?f:m},this.getBinding=function(){return u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(d=t.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",Z),s.addEventListener("inputsourceschange",q),p.xrCompatible!==!0&&await e.makeXRCompatible(),L=t.getPixelRatio(),t.getSize(z),s.renderState.layers===void 0){const at={antialias:p.antialias,alpha:!0,depth:p.depth,stencil:p.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),T=new Cs(m.framebufferWidth,m.framebufferHeight,{format:ni,type:Bi,colorSpace:t.outputColorSpace,stencilBuffer:p.stencil})}else{let at=null,gt=null,ot=null;p.depth&&(ot=p.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=p.stencil?Mr:hr,gt=p.stencil?xr:Rs);const kt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};u=new XRWebGLBinding(s,e),f=u.createProjectionLayer(kt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),T=new Cs(f.textureWidth,f.textureHeight,{format:ni,type:Bi,depthTexture:new Hd(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:p.stencil,colorSpace:t.outputColorSpace,samples:p.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}T.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return x.getDepthTexture()};function q(it){for(let at=0;at<it.removed.length;at++){const gt=it.removed[at],ot=y.indexOf(gt);ot>=0&&(y[ot]=null,A[ot].disconnect(gt))}for(let at=0;at<it.added.length;at++){const gt=it.added[at];let ot=y.indexOf(gt);if(ot===-1){for(let Ht=0;Ht<A.length;Ht++)if(Ht>=y.length){y.push(gt),ot=Ht;break}else if(y[Ht]===null){y[Ht]=gt,ot=Ht;break}if(ot===-1)break}const kt=A[ot];kt&&kt.connect(gt)}}const J=new V,j=new V;function Q(it,at,gt){J.setFromMatrixPosition(at.matrixWorld),j.setFromMatrixPosition(gt.matrixWorld);const ot=J.distanceTo(j),kt=at.projectionMatrix.elements,Ht=gt.projectionMatrix.elements,It=kt[14]/(kt[10]-1),oe=kt[14]/(kt[10]+1),jt=(kt[9]+1)/kt[5],ae=(kt[9]-1)/kt[5],B=(kt[8]-1)/kt[0],Ge=(Ht[8]+1)/Ht[0],Zt=It*B,Qt=It*Ge,Vt=ot/(-B+Ge),he=Vt*-B;if(at.matrixWorld.decompose(it.position,it.quaternion,it.scale),it.translateX(he),it.translateZ(Vt),it.matrixWorld.compose(it.position,it.quaternion,it.scale),it.matrixWorldInverse.copy(it.matrixWorld).invert(),kt[10]===-1)it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Pt=It+Vt,R=oe+Vt,M=Zt-he,Y=Qt+(ot-he),K=jt*oe/R*Pt,H=ae*oe/R*Pt;it.projectionMatrix.makePerspective(M,Y,K,H,Pt,R),it.projectionMatrixInverse.copy(it.projectionMatrix).invert()}}function ut(it,at){at===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(at.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let at=it.near,gt=it.far;x.texture!==null&&(x.depthNear>0&&(at=x.depthNear),x.depthFar>0&&(gt=x.depthFar)),S.near=I.near=D.near=at,S.far=I.far=D.far=gt,(C!==S.near||$!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,$=S.far),D.layers.mask=it.layers.mask|2,I.layers.mask=it.layers.mask|4,S.layers.mask=D.layers.mask|I.layers.mask;const ot=it.parent,kt=S.cameras;ut(S,ot);for(let Ht=0;Ht<kt.length;Ht++)ut(kt[Ht],ot);kt.length===2?Q(S,D,I):S.projectionMatrix.copy(D.projectionMatrix),ct(it,S,ot)};function ct(it,at,gt){gt===null?it.matrix.copy(at.matrixWorld):(it.matrix.copy(gt.matrixWorld),it.matrix.invert(),it.matrix.multiply(at.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=gc*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&m===null))return l},this.setFoveation=function(it){l=it,f!==null&&(f.fixedFoveation=it),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=it)},this.hasDepthSensing=function(){return x.texture!==null},this.getDepthSensingMesh=function(){return x.getMesh(S)};let mt=null;function Mt(it,at){if(h=at.getViewerPose(c||o),_=at,h!==null){const gt=h.views;m!==null&&(t.setRenderTargetFramebuffer(T,m.framebuffer),t.setRenderTarget(T));let ot=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Ht=0;Ht<gt.length;Ht++){const It=gt[Ht];let oe=null;if(m!==null)oe=m.getViewport(It);else{const ae=u.getViewSubImage(f,It);oe=ae.viewport,Ht===0&&(t.setRenderTargetTextures(T,ae.colorTexture,f.ignoreDepthValues?void 0:ae.depthStencilTexture),t.setRenderTarget(T))}let jt=b[Ht];jt===void 0&&(jt=new Wn,jt.layers.enable(Ht),jt.viewport=new ke,b[Ht]=jt),jt.matrix.fromArray(It.transform.matrix),jt.matrix.decompose(jt.position,jt.quaternion,jt.scale),jt.projectionMatrix.fromArray(It.projectionMatrix),jt.projectionMatrixInverse.copy(jt.projectionMatrix).invert(),jt.viewport.set(oe.x,oe.y,oe.width,oe.height),Ht===0&&(S.matrix.copy(jt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(jt)}const kt=s.enabledFeatures;if(kt&&kt.includes("depth-sensing")){const Ht=u.getDepthInformation(gt[0]);Ht&&Ht.isValid&&Ht.texture&&x.init(t,Ht,s.renderState)}}for(let gt=0;gt<A.length;gt++){const ot=y[gt],kt=A[gt];ot!==null&&kt!==void 0&&kt.update(ot,at,c||o)}mt&&mt(it,at),at.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:at}),_=null}const pt=new kd;pt.setAnimationLoop(Mt),this.setAnimationLoop=function(it){mt=it},this.dispose=function(){}}}const gs=new ki,jS=new Fe;function KS(i,t){function e(p,d){p.matrixAutoUpdate===!0&&p.updateMatrix(),d.value.copy(p.matrix)}function n(p,d){d.color.getRGB(p.fogColor.value,Nd(i)),d.isFog?(p.fogNear.value=d.near,p.fogFar.value=d.far):d.isFogExp2&&(p.fogDensity.value=d.density)}function s(p,d,T,A,y){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(p,d):d.isMeshToonMaterial?(r(p,d),u(p,d)):d.isMeshPhongMaterial?(r(p,d),h(p,d)):d.isMeshStandardMaterial?(r(p,d),f(p,d),d.isMeshPhysicalMaterial&&m(p,d,y)):d.isMeshMatcapMaterial?(r(p,d),_(p,d)):d.isMeshDepthMaterial?r(p,d):d.isMeshDistanceMaterial?(r(p,d),x(p,d)):d.isMeshNormalMaterial?r(p,d):d.isLineBasicMaterial?(o(p,d),d.isLineDashedMaterial&&a(p,d)):d.isPointsMaterial?l(p,d,T,A):d.isSpriteMaterial?c(p,d):d.isShadowMaterial?(p.color.value.copy(d.color),p.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(p,d){p.opacity.value=d.opacity,d.color&&p.diffuse.value.copy(d.color),d.emissive&&p.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(p.map.value=d.map,e(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,e(d.alphaMap,p.alphaMapTransform)),d.bumpMap&&(p.bumpMap.value=d.bumpMap,e(d.bumpMap,p.bumpMapTransform),p.bumpScale.value=d.bumpScale,d.side===Tn&&(p.bumpScale.value*=-1)),d.normalMap&&(p.normalMap.value=d.normalMap,e(d.normalMap,p.normalMapTransform),p.normalScale.value.copy(d.normalScale),d.side===Tn&&p.normalScale.value.negate()),d.displacementMap&&(p.displacementMap.value=d.displacementMap,e(d.displacementMap,p.displacementMapTransform),p.displacementScale.value=d.displacementScale,p.displacementBias.value=d.displacementBias),d.emissiveMap&&(p.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,p.emissiveMapTransform)),d.specularMap&&(p.specularMap.value=d.specularMap,e(d.specularMap,p.specularMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest);const T=t.get(d),A=T.envMap,y=T.envMapRotation;A&&(p.envMap.value=A,gs.copy(y),gs.x*=-1,gs.y*=-1,gs.z*=-1,A.isCubeTexture&&A.isRenderTargetTexture===!1&&(gs.y*=-1,gs.z*=-1),p.envMapRotation.value.setFromMatrix4(jS.makeRotationFromEuler(gs)),p.flipEnvMap.value=A.isCubeTexture&&A.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=d.reflectivity,p.ior.value=d.ior,p.refractionRatio.value=d.refractionRatio),d.lightMap&&(p.lightMap.value=d.lightMap,p.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,p.lightMapTransform)),d.aoMap&&(p.aoMap.value=d.aoMap,p.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,p.aoMapTransform))}function o(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,d.map&&(p.map.value=d.map,e(d.map,p.mapTransform))}function a(p,d){p.dashSize.value=d.dashSize,p.totalSize.value=d.dashSize+d.gapSize,p.scale.value=d.scale}function l(p,d,T,A){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.size.value=d.size*T,p.scale.value=A*.5,d.map&&(p.map.value=d.map,e(d.map,p.uvTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,e(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function c(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.rotation.value=d.rotation,d.map&&(p.map.value=d.map,e(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,e(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function h(p,d){p.specular.value.copy(d.specular),p.shininess.value=Math.max(d.shininess,1e-4)}function u(p,d){d.gradientMap&&(p.gradientMap.value=d.gradientMap)}function f(p,d){p.metalness.value=d.metalness,d.metalnessMap&&(p.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,p.metalnessMapTransform)),p.roughness.value=d.roughness,d.roughnessMap&&(p.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,p.roughnessMapTransform)),d.envMap&&(p.envMapIntensity.value=d.envMapIntensity)}function m(p,d,T){p.ior.value=d.ior,d.sheen>0&&(p.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),p.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(p.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,p.sheenColorMapTransform)),d.sheenRoughnessMap&&(p.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,p.sheenRoughnessMapTransform))),d.clearcoat>0&&(p.clearcoat.value=d.clearcoat,p.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(p.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,p.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(p.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Tn&&p.clearcoatNormalScale.value.negate())),d.dispersion>0&&(p.dispersion.value=d.dispersion),d.iridescence>0&&(p.iridescence.value=d.iridescence,p.iridescenceIOR.value=d.iridescenceIOR,p.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(p.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,p.iridescenceMapTransform)),d.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),d.transmission>0&&(p.transmission.value=d.transmission,p.transmissionSamplerMap.value=T.texture,p.transmissionSamplerSize.value.set(T.width,T.height),d.transmissionMap&&(p.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,p.transmissionMapTransform)),p.thickness.value=d.thickness,d.thicknessMap&&(p.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=d.attenuationDistance,p.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(p.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(p.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=d.specularIntensity,p.specularColor.value.copy(d.specularColor),d.specularColorMap&&(p.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,p.specularColorMapTransform)),d.specularIntensityMap&&(p.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,p.specularIntensityMapTransform))}function _(p,d){d.matcap&&(p.matcap.value=d.matcap)}function x(p,d){const T=t.get(d).light;p.referencePosition.value.setFromMatrixPosition(T.matrixWorld),p.nearDistance.value=T.shadow.camera.near,p.farDistance.value=T.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function ZS(i,t,e,n){let s={},r={},o=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(T,A){const y=A.program;n.uniformBlockBinding(T,y)}function c(T,A){let y=s[T.id];y===void 0&&(_(T),y=h(T),s[T.id]=y,T.addEventListener("dispose",p));const z=A.program;n.updateUBOMapping(T,z);const L=t.render.frame;r[T.id]!==L&&(f(T),r[T.id]=L)}function h(T){const A=u();T.__bindingPointIndex=A;const y=i.createBuffer(),z=T.__size,L=T.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,z,L),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,A,y),y}function u(){for(let T=0;T<a;T++)if(o.indexOf(T)===-1)return o.push(T),T;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(T){const A=s[T.id],y=T.uniforms,z=T.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let L=0,D=y.length;L<D;L++){const I=Array.isArray(y[L])?y[L]:[y[L]];for(let b=0,S=I.length;b<S;b++){const C=I[b];if(m(C,L,b,z)===!0){const $=C.__offset,O=Array.isArray(C.value)?C.value:[C.value];let Z=0;for(let q=0;q<O.length;q++){const J=O[q],j=x(J);typeof J=="number"||typeof J=="boolean"?(C.__data[0]=J,i.bufferSubData(i.UNIFORM_BUFFER,$+Z,C.__data)):J.isMatrix3?(C.__data[0]=J.elements[0],C.__data[1]=J.elements[1],C.__data[2]=J.elements[2],C.__data[3]=0,C.__data[4]=J.elements[3],C.__data[5]=J.elements[4],C.__data[6]=J.elements[5],C.__data[7]=0,C.__data[8]=J.elements[6],C.__data[9]=J.elements[7],C.__data[10]=J.elements[8],C.__data[11]=0):(J.toArray(C.__data,Z),Z+=j.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,$,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(T,A,y,z){const L=T.value,D=A+"_"+y;if(z[D]===void 0)return typeof L=="number"||typeof L=="boolean"?z[D]=L:z[D]=L.clone(),!0;{const I=z[D];if(typeof L=="number"||typeof L=="boolean"){if(I!==L)return z[D]=L,!0}else if(I.equals(L)===!1)return I.copy(L),!0}return!1}function _(T){const A=T.uniforms;let y=0;const z=16;for(let D=0,I=A.length;D<I;D++){const b=Array.isArray(A[D])?A[D]:[A[D]];for(let S=0,C=b.length;S<C;S++){const $=b[S],O=Array.isArray($.value)?$.value:[$.value];for(let Z=0,q=O.length;Z<q;Z++){const J=O[Z],j=x(J),Q=y%z,ut=Q%j.boundary,ct=Q+ut;y+=ut,ct!==0&&z-ct<j.storage&&(y+=z-ct),$.__data=new Float32Array(j.storage/Float32Array.BYTES_PER_ELEMENT),$.__offset=y,y+=j.storage}}}const L=y%z;return L>0&&(y+=z-L),T.__size=y,T.__cache={},this}function x(T){const A={boundary:0,storage:0};return typeof T=="number"||typeof T=="boolean"?(A.boundary=4,A.storage=4):T.isVector2?(A.boundary=8,A.storage=8):T.isVector3||T.isColor?(A.boundary=16,A.storage=12):T.isVector4?(A.boundary=16,A.storage=16):T.isMatrix3?(A.boundary=48,A.storage=48):T.isMatrix4?(A.boundary=64,A.storage=64):T.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",T),A}function p(T){const A=T.target;A.removeEventListener("dispose",p);const y=o.indexOf(A.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function d(){for(const T in s)i.deleteBuffer(s[T]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}class JS{constructor(t={}){const{canvas:e=z_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;const _=new Uint32Array(4),x=new Int32Array(4);let p=null,d=null;const T=[],A=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=Gn,this.toneMapping=es,this.toneMappingExposure=1;const y=this;let z=!1,L=0,D=0,I=null,b=-1,S=null;const C=new ke,$=new ke;let O=null;const Z=new Me(0);let q=0,J=e.width,j=e.height,Q=1,ut=null,ct=null;const mt=new ke(0,0,J,j),Mt=new ke(0,0,J,j);let pt=!1;const it=new Bd;let at=!1,gt=!1;const ot=new Fe,kt=new Fe,Ht=new V,It=new ke,oe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let jt=!1;function ae(){return I===null?Q:1}let B=n;function Ge(E,N){return e.getContext(E,N)}try{const E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Fc}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",wt,!1),e.addEventListener("webglcontextcreationerror",At,!1),B===null){const N="webgl2";if(B=Ge(N,E),B===null)throw Ge(N)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let Zt,Qt,Vt,he,Pt,R,M,Y,K,H,tt,St,_t,Tt,$t,ft,vt,Nt,Ot,Et,ne,Yt,ue,F;function xt(){Zt=new iM(B),Zt.init(),Yt=new VS(B,Zt),Qt=new Zx(B,Zt,t,Yt),Vt=new kS(B,Zt),Qt.reverseDepthBuffer&&f&&Vt.buffers.depth.setReversed(!0),he=new oM(B),Pt=new bS,R=new HS(B,Zt,Vt,Pt,Qt,Yt,he),M=new Qx(y),Y=new nM(y),K=new d0(B),ue=new jx(B,K),H=new sM(B,K,he,ue),tt=new lM(B,H,K,he),Ot=new aM(B,Qt,R),ft=new Jx(Pt),St=new ES(y,M,Y,Zt,Qt,ue,ft),_t=new KS(y,Pt),Tt=new wS,$t=new DS(Zt),Nt=new $x(y,M,Y,Vt,tt,m,l),vt=new OS(y,tt,Qt),F=new ZS(B,he,Qt,Vt),Et=new Kx(B,Zt,he),ne=new rM(B,Zt,he),he.programs=St.programs,y.capabilities=Qt,y.extensions=Zt,y.properties=Pt,y.renderLists=Tt,y.shadowMap=vt,y.state=Vt,y.info=he}xt();const et=new $S(y,B);this.xr=et,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){const E=Zt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){const E=Zt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(E){E!==void 0&&(Q=E,this.setSize(J,j,!1))},this.getSize=function(E){return E.set(J,j)},this.setSize=function(E,N,G=!0){if(et.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}J=E,j=N,e.width=Math.floor(E*Q),e.height=Math.floor(N*Q),G===!0&&(e.style.width=E+"px",e.style.height=N+"px"),this.setViewport(0,0,E,N)},this.getDrawingBufferSize=function(E){return E.set(J*Q,j*Q).floor()},this.setDrawingBufferSize=function(E,N,G){J=E,j=N,Q=G,e.width=Math.floor(E*G),e.height=Math.floor(N*G),this.setViewport(0,0,E,N)},this.getCurrentViewport=function(E){return E.copy(C)},this.getViewport=function(E){return E.copy(mt)},this.setViewport=function(E,N,G,W){E.isVector4?mt.set(E.x,E.y,E.z,E.w):mt.set(E,N,G,W),Vt.viewport(C.copy(mt).multiplyScalar(Q).round())},this.getScissor=function(E){return E.copy(Mt)},this.setScissor=function(E,N,G,W){E.isVector4?Mt.set(E.x,E.y,E.z,E.w):Mt.set(E,N,G,W),Vt.scissor($.copy(Mt).multiplyScalar(Q).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(E){Vt.setScissorTest(pt=E)},this.setOpaqueSort=function(E){ut=E},this.setTransparentSort=function(E){ct=E},this.getClearColor=function(E){return E.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(E=!0,N=!0,G=!0){let W=0;if(E){let k=!1;if(I!==null){const ht=I.texture.format;k=ht===Vc||ht===Hc||ht===zc}if(k){const ht=I.texture.type,yt=ht===Bi||ht===Rs||ht===Qr||ht===xr||ht===Bc||ht===kc,Ft=Nt.getClearColor(),Dt=Nt.getClearAlpha(),Gt=Ft.r,Xt=Ft.g,Ut=Ft.b;yt?(_[0]=Gt,_[1]=Xt,_[2]=Ut,_[3]=Dt,B.clearBufferuiv(B.COLOR,0,_)):(x[0]=Gt,x[1]=Xt,x[2]=Ut,x[3]=Dt,B.clearBufferiv(B.COLOR,0,x))}else W|=B.COLOR_BUFFER_BIT}N&&(W|=B.DEPTH_BUFFER_BIT),G&&(W|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),B.clear(W)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",wt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),Tt.dispose(),$t.dispose(),Pt.dispose(),M.dispose(),Y.dispose(),tt.dispose(),ue.dispose(),F.dispose(),St.dispose(),et.dispose(),et.removeEventListener("sessionstart",Rn),et.removeEventListener("sessionend",Mi),Sn.stop()};function rt(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),z=!0}function wt(){console.log("THREE.WebGLRenderer: Context Restored."),z=!1;const E=he.autoReset,N=vt.enabled,G=vt.autoUpdate,W=vt.needsUpdate,k=vt.type;xt(),he.autoReset=E,vt.enabled=N,vt.autoUpdate=G,vt.needsUpdate=W,vt.type=k}function At(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function Kt(E){const N=E.target;N.removeEventListener("dispose",Kt),Ue(N)}function Ue(E){Ze(E),Pt.remove(E)}function Ze(E){const N=Pt.get(E).programs;N!==void 0&&(N.forEach(function(G){St.releaseProgram(G)}),E.isShaderMaterial&&St.releaseShaderCache(E))}this.renderBufferDirect=function(E,N,G,W,k,ht){N===null&&(N=oe);const yt=k.isMesh&&k.matrixWorld.determinant()<0,Ft=Ma(E,N,G,W,k);Vt.setMaterial(W,yt);let Dt=G.index,Gt=1;if(W.wireframe===!0){if(Dt=H.getWireframeAttribute(G),Dt===void 0)return;Gt=2}const Xt=G.drawRange,Ut=G.attributes.position;let se=Xt.start*Gt,ve=(Xt.start+Xt.count)*Gt;ht!==null&&(se=Math.max(se,ht.start*Gt),ve=Math.min(ve,(ht.start+ht.count)*Gt)),Dt!==null?(se=Math.max(se,0),ve=Math.min(ve,Dt.count)):Ut!=null&&(se=Math.max(se,0),ve=Math.min(ve,Ut.count));const Se=ve-se;if(Se<0||Se===1/0)return;ue.setup(k,W,Ft,G,Dt);let Je,le=Et;if(Dt!==null&&(Je=K.get(Dt),le=ne,le.setIndex(Je)),k.isMesh)W.wireframe===!0?(Vt.setLineWidth(W.wireframeLinewidth*ae()),le.setMode(B.LINES)):le.setMode(B.TRIANGLES);else if(k.isLine){let Bt=W.linewidth;Bt===void 0&&(Bt=1),Vt.setLineWidth(Bt*ae()),k.isLineSegments?le.setMode(B.LINES):k.isLineLoop?le.setMode(B.LINE_LOOP):le.setMode(B.LINE_STRIP)}else k.isPoints?le.setMode(B.POINTS):k.isSprite&&le.setMode(B.TRIANGLES);if(k.isBatchedMesh)if(k._multiDrawInstances!==null)le.renderMultiDrawInstances(k._multiDrawStarts,k._multiDrawCounts,k._multiDrawCount,k._multiDrawInstances);else if(Zt.get("WEBGL_multi_draw"))le.renderMultiDraw(k._multiDrawStarts,k._multiDrawCounts,k._multiDrawCount);else{const Bt=k._multiDrawStarts,Ie=k._multiDrawCounts,fe=k._multiDrawCount,yn=Dt?K.get(Dt).bytesPerElement:1,oi=Pt.get(W).currentProgram.getUniforms();for(let an=0;an<fe;an++)oi.setValue(B,"_gl_DrawID",an),le.render(Bt[an]/yn,Ie[an])}else if(k.isInstancedMesh)le.renderInstances(se,Se,k.count);else if(G.isInstancedBufferGeometry){const Bt=G._maxInstanceCount!==void 0?G._maxInstanceCount:1/0,Ie=Math.min(G.instanceCount,Bt);le.renderInstances(se,Se,Ie)}else le.render(se,Se)};function me(E,N,G){E.transparent===!0&&E.side===gi&&E.forceSinglePass===!1?(E.side=Tn,E.needsUpdate=!0,Is(E,N,G),E.side=is,E.needsUpdate=!0,Is(E,N,G),E.side=gi):Is(E,N,G)}this.compile=function(E,N,G=null){G===null&&(G=E),d=$t.get(G),d.init(N),A.push(d),G.traverseVisible(function(k){k.isLight&&k.layers.test(N.layers)&&(d.pushLight(k),k.castShadow&&d.pushShadow(k))}),E!==G&&E.traverseVisible(function(k){k.isLight&&k.layers.test(N.layers)&&(d.pushLight(k),k.castShadow&&d.pushShadow(k))}),d.setupLights();const W=new Set;return E.traverse(function(k){if(!(k.isMesh||k.isPoints||k.isLine||k.isSprite))return;const ht=k.material;if(ht)if(Array.isArray(ht))for(let yt=0;yt<ht.length;yt++){const Ft=ht[yt];me(Ft,G,k),W.add(Ft)}else me(ht,G,k),W.add(ht)}),A.pop(),d=null,W},this.compileAsync=function(E,N,G=null){const W=this.compile(E,N,G);return new Promise(k=>{function ht(){if(W.forEach(function(yt){Pt.get(yt).currentProgram.isReady()&&W.delete(yt)}),W.size===0){k(E);return}setTimeout(ht,10)}Zt.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let We=null;function Re(E){We&&We(E)}function Rn(){Sn.stop()}function Mi(){Sn.start()}const Sn=new kd;Sn.setAnimationLoop(Re),typeof self<"u"&&Sn.setContext(self),this.setAnimationLoop=function(E){We=E,et.setAnimationLoop(E),E===null?Sn.stop():Sn.start()},et.addEventListener("sessionstart",Rn),et.addEventListener("sessionend",Mi),this.render=function(E,N){if(N!==void 0&&N.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(z===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),et.enabled===!0&&et.isPresenting===!0&&(et.cameraAutoUpdate===!0&&et.updateCamera(N),N=et.getCamera()),E.isScene===!0&&E.onBeforeRender(y,E,N,I),d=$t.get(E,A.length),d.init(N),A.push(d),kt.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),it.setFromProjectionMatrix(kt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),p=Tt.get(E,T.length),p.init(),T.push(p),et.enabled===!0&&et.isPresenting===!0){const ht=y.xr.getDepthSensingMesh();ht!==null&&on(ht,N,-1/0,y.sortObjects)}on(E,N,0,y.sortObjects),p.finish(),y.sortObjects===!0&&p.sort(ut,ct),jt=et.enabled===!1||et.isPresenting===!1||et.hasDepthSensing()===!1,jt&&Nt.addToRenderList(p,E),this.info.render.frame++,at===!0&&ft.beginShadows();const G=d.state.shadowsArray;vt.render(G,E,N),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const W=p.opaque,k=p.transmissive;if(d.setupLights(),N.isArrayCamera){const ht=N.cameras;if(k.length>0)for(let yt=0,Ft=ht.length;yt<Ft;yt++){const Dt=ht[yt];yi(W,k,E,Dt)}jt&&Nt.render(E);for(let yt=0,Ft=ht.length;yt<Ft;yt++){const Dt=ht[yt];Si(p,E,Dt,Dt.viewport)}}else k.length>0&&yi(W,k,E,N),jt&&Nt.render(E),Si(p,E,N);I!==null&&(R.updateMultisampleRenderTarget(I),R.updateRenderTargetMipmap(I)),E.isScene===!0&&E.onAfterRender(y,E,N),ue.resetDefaultState(),b=-1,S=null,A.pop(),A.length>0?(d=A[A.length-1],at===!0&&ft.setGlobalState(y.clippingPlanes,d.state.camera)):d=null,T.pop(),T.length>0?p=T[T.length-1]:p=null};function on(E,N,G,W){if(E.visible===!1)return;if(E.layers.test(N.layers)){if(E.isGroup)G=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(N);else if(E.isLight)d.pushLight(E),E.castShadow&&d.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||it.intersectsSprite(E)){W&&It.setFromMatrixPosition(E.matrixWorld).applyMatrix4(kt);const yt=tt.update(E),Ft=E.material;Ft.visible&&p.push(E,yt,Ft,G,It.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||it.intersectsObject(E))){const yt=tt.update(E),Ft=E.material;if(W&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),It.copy(E.boundingSphere.center)):(yt.boundingSphere===null&&yt.computeBoundingSphere(),It.copy(yt.boundingSphere.center)),It.applyMatrix4(E.matrixWorld).applyMatrix4(kt)),Array.isArray(Ft)){const Dt=yt.groups;for(let Gt=0,Xt=Dt.length;Gt<Xt;Gt++){const Ut=Dt[Gt],se=Ft[Ut.materialIndex];se&&se.visible&&p.push(E,yt,se,G,It.z,Ut)}}else Ft.visible&&p.push(E,yt,Ft,G,It.z,null)}}const ht=E.children;for(let yt=0,Ft=ht.length;yt<Ft;yt++)on(ht[yt],N,G,W)}function Si(E,N,G,W){const k=E.opaque,ht=E.transmissive,yt=E.transparent;d.setupLightsView(G),at===!0&&ft.setGlobalState(y.clippingPlanes,G),W&&Vt.viewport(C.copy(W)),k.length>0&&rs(k,N,G),ht.length>0&&rs(ht,N,G),yt.length>0&&rs(yt,N,G),Vt.buffers.depth.setTest(!0),Vt.buffers.depth.setMask(!0),Vt.buffers.color.setMask(!0),Vt.setPolygonOffset(!1)}function yi(E,N,G,W){if((G.isScene===!0?G.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[W.id]===void 0&&(d.state.transmissionRenderTarget[W.id]=new Cs(1,1,{generateMipmaps:!0,type:Zt.has("EXT_color_buffer_half_float")||Zt.has("EXT_color_buffer_float")?to:Bi,minFilter:bs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ce.workingColorSpace}));const ht=d.state.transmissionRenderTarget[W.id],yt=W.viewport||C;ht.setSize(yt.z,yt.w);const Ft=y.getRenderTarget();y.setRenderTarget(ht),y.getClearColor(Z),q=y.getClearAlpha(),q<1&&y.setClearColor(16777215,.5),y.clear(),jt&&Nt.render(G);const Dt=y.toneMapping;y.toneMapping=es;const Gt=W.viewport;if(W.viewport!==void 0&&(W.viewport=void 0),d.setupLightsView(W),at===!0&&ft.setGlobalState(y.clippingPlanes,W),rs(E,G,W),R.updateMultisampleRenderTarget(ht),R.updateRenderTargetMipmap(ht),Zt.has("WEBGL_multisampled_render_to_texture")===!1){let Xt=!1;for(let Ut=0,se=N.length;Ut<se;Ut++){const ve=N[Ut],Se=ve.object,Je=ve.geometry,le=ve.material,Bt=ve.group;if(le.side===gi&&Se.layers.test(W.layers)){const Ie=le.side;le.side=Tn,le.needsUpdate=!0,Ar(Se,G,W,Je,le,Bt),le.side=Ie,le.needsUpdate=!0,Xt=!0}}Xt===!0&&(R.updateMultisampleRenderTarget(ht),R.updateRenderTargetMipmap(ht))}y.setRenderTarget(Ft),y.setClearColor(Z,q),Gt!==void 0&&(W.viewport=Gt),y.toneMapping=Dt}function rs(E,N,G){const W=N.isScene===!0?N.overrideMaterial:null;for(let k=0,ht=E.length;k<ht;k++){const yt=E[k],Ft=yt.object,Dt=yt.geometry,Gt=W===null?yt.material:W,Xt=yt.group;Ft.layers.test(G.layers)&&Ar(Ft,N,G,Dt,Gt,Xt)}}function Ar(E,N,G,W,k,ht){E.onBeforeRender(y,N,G,W,k,ht),E.modelViewMatrix.multiplyMatrices(G.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),k.onBeforeRender(y,N,G,W,E,ht),k.transparent===!0&&k.side===gi&&k.forceSinglePass===!1?(k.side=Tn,k.needsUpdate=!0,y.renderBufferDirect(G,N,W,k,E,ht),k.side=is,k.needsUpdate=!0,y.renderBufferDirect(G,N,W,k,E,ht),k.side=gi):y.renderBufferDirect(G,N,W,k,E,ht),E.onAfterRender(y,N,G,W,k,ht)}function Is(E,N,G){N.isScene!==!0&&(N=oe);const W=Pt.get(E),k=d.state.lights,ht=d.state.shadowsArray,yt=k.state.version,Ft=St.getParameters(E,k.state,ht,N,G),Dt=St.getProgramCacheKey(Ft);let Gt=W.programs;W.environment=E.isMeshStandardMaterial?N.environment:null,W.fog=N.fog,W.envMap=(E.isMeshStandardMaterial?Y:M).get(E.envMap||W.environment),W.envMapRotation=W.environment!==null&&E.envMap===null?N.environmentRotation:E.envMapRotation,Gt===void 0&&(E.addEventListener("dispose",Kt),Gt=new Map,W.programs=Gt);let Xt=Gt.get(Dt);if(Xt!==void 0){if(W.currentProgram===Xt&&W.lightsStateVersion===yt)return ri(E,Ft),Xt}else Ft.uniforms=St.getUniforms(E),E.onBeforeCompile(Ft,y),Xt=St.acquireProgram(Ft,Dt),Gt.set(Dt,Xt),W.uniforms=Ft.uniforms;const Ut=W.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ut.clippingPlanes=ft.uniform),ri(E,Ft),W.needsLights=ao(E),W.lightsStateVersion=yt,W.needsLights&&(Ut.ambientLightColor.value=k.state.ambient,Ut.lightProbe.value=k.state.probe,Ut.directionalLights.value=k.state.directional,Ut.directionalLightShadows.value=k.state.directionalShadow,Ut.spotLights.value=k.state.spot,Ut.spotLightShadows.value=k.state.spotShadow,Ut.rectAreaLights.value=k.state.rectArea,Ut.ltc_1.value=k.state.rectAreaLTC1,Ut.ltc_2.value=k.state.rectAreaLTC2,Ut.pointLights.value=k.state.point,Ut.pointLightShadows.value=k.state.pointShadow,Ut.hemisphereLights.value=k.state.hemi,Ut.directionalShadowMap.value=k.state.directionalShadowMap,Ut.directionalShadowMatrix.value=k.state.directionalShadowMatrix,Ut.spotShadowMap.value=k.state.spotShadowMap,Ut.spotLightMatrix.value=k.state.spotLightMatrix,Ut.spotLightMap.value=k.state.spotLightMap,Ut.pointShadowMap.value=k.state.pointShadowMap,Ut.pointShadowMatrix.value=k.state.pointShadowMatrix),W.currentProgram=Xt,W.uniformsList=null,Xt}function oo(E){if(E.uniformsList===null){const N=E.currentProgram.getUniforms();E.uniformsList=ta.seqWithValue(N.seq,E.uniforms)}return E.uniformsList}function ri(E,N){const G=Pt.get(E);G.outputColorSpace=N.outputColorSpace,G.batching=N.batching,G.batchingColor=N.batchingColor,G.instancing=N.instancing,G.instancingColor=N.instancingColor,G.instancingMorph=N.instancingMorph,G.skinning=N.skinning,G.morphTargets=N.morphTargets,G.morphNormals=N.morphNormals,G.morphColors=N.morphColors,G.morphTargetsCount=N.morphTargetsCount,G.numClippingPlanes=N.numClippingPlanes,G.numIntersection=N.numClipIntersection,G.vertexAlphas=N.vertexAlphas,G.vertexTangents=N.vertexTangents,G.toneMapping=N.toneMapping}function Ma(E,N,G,W,k){N.isScene!==!0&&(N=oe),R.resetTextureUnits();const ht=N.fog,yt=W.isMeshStandardMaterial?N.environment:null,Ft=I===null?y.outputColorSpace:I.isXRRenderTarget===!0?I.texture.colorSpace:Ds,Dt=(W.isMeshStandardMaterial?Y:M).get(W.envMap||yt),Gt=W.vertexColors===!0&&!!G.attributes.color&&G.attributes.color.itemSize===4,Xt=!!G.attributes.tangent&&(!!W.normalMap||W.anisotropy>0),Ut=!!G.morphAttributes.position,se=!!G.morphAttributes.normal,ve=!!G.morphAttributes.color;let Se=es;W.toneMapped&&(I===null||I.isXRRenderTarget===!0)&&(Se=y.toneMapping);const Je=G.morphAttributes.position||G.morphAttributes.normal||G.morphAttributes.color,le=Je!==void 0?Je.length:0,Bt=Pt.get(W),Ie=d.state.lights;if(at===!0&&(gt===!0||E!==S)){const un=E===S&&W.id===b;ft.setState(W,E,un)}let fe=!1;W.version===Bt.__version?(Bt.needsLights&&Bt.lightsStateVersion!==Ie.state.version||Bt.outputColorSpace!==Ft||k.isBatchedMesh&&Bt.batching===!1||!k.isBatchedMesh&&Bt.batching===!0||k.isBatchedMesh&&Bt.batchingColor===!0&&k.colorTexture===null||k.isBatchedMesh&&Bt.batchingColor===!1&&k.colorTexture!==null||k.isInstancedMesh&&Bt.instancing===!1||!k.isInstancedMesh&&Bt.instancing===!0||k.isSkinnedMesh&&Bt.skinning===!1||!k.isSkinnedMesh&&Bt.skinning===!0||k.isInstancedMesh&&Bt.instancingColor===!0&&k.instanceColor===null||k.isInstancedMesh&&Bt.instancingColor===!1&&k.instanceColor!==null||k.isInstancedMesh&&Bt.instancingMorph===!0&&k.morphTexture===null||k.isInstancedMesh&&Bt.instancingMorph===!1&&k.morphTexture!==null||Bt.envMap!==Dt||W.fog===!0&&Bt.fog!==ht||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==ft.numPlanes||Bt.numIntersection!==ft.numIntersection)||Bt.vertexAlphas!==Gt||Bt.vertexTangents!==Xt||Bt.morphTargets!==Ut||Bt.morphNormals!==se||Bt.morphColors!==ve||Bt.toneMapping!==Se||Bt.morphTargetsCount!==le)&&(fe=!0):(fe=!0,Bt.__version=W.version);let yn=Bt.currentProgram;fe===!0&&(yn=Is(W,N,k));let oi=!1,an=!1,as=!1;const Te=yn.getUniforms(),On=Bt.uniforms;if(Vt.useProgram(yn.program)&&(oi=!0,an=!0,as=!0),W.id!==b&&(b=W.id,an=!0),oi||S!==E){Vt.buffers.depth.getReversed()?(ot.copy(E.projectionMatrix),V_(ot),G_(ot),Te.setValue(B,"projectionMatrix",ot)):Te.setValue(B,"projectionMatrix",E.projectionMatrix),Te.setValue(B,"viewMatrix",E.matrixWorldInverse);const ai=Te.map.cameraPosition;ai!==void 0&&ai.setValue(B,Ht.setFromMatrixPosition(E.matrixWorld)),Qt.logarithmicDepthBuffer&&Te.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(W.isMeshPhongMaterial||W.isMeshToonMaterial||W.isMeshLambertMaterial||W.isMeshBasicMaterial||W.isMeshStandardMaterial||W.isShaderMaterial)&&Te.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,an=!0,as=!0)}if(k.isSkinnedMesh){Te.setOptional(B,k,"bindMatrix"),Te.setOptional(B,k,"bindMatrixInverse");const un=k.skeleton;un&&(un.boneTexture===null&&un.computeBoneTexture(),Te.setValue(B,"boneTexture",un.boneTexture,R))}k.isBatchedMesh&&(Te.setOptional(B,k,"batchingTexture"),Te.setValue(B,"batchingTexture",k._matricesTexture,R),Te.setOptional(B,k,"batchingIdTexture"),Te.setValue(B,"batchingIdTexture",k._indirectTexture,R),Te.setOptional(B,k,"batchingColorTexture"),k._colorsTexture!==null&&Te.setValue(B,"batchingColorTexture",k._colorsTexture,R));const zi=G.morphAttributes;if((zi.position!==void 0||zi.normal!==void 0||zi.color!==void 0)&&Ot.update(k,G,yn),(an||Bt.receiveShadow!==k.receiveShadow)&&(Bt.receiveShadow=k.receiveShadow,Te.setValue(B,"receiveShadow",k.receiveShadow)),W.isMeshGouraudMaterial&&W.envMap!==null&&(On.envMap.value=Dt,On.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),W.isMeshStandardMaterial&&W.envMap===null&&N.environment!==null&&(On.envMapIntensity.value=N.environmentIntensity),an&&(Te.setValue(B,"toneMappingExposure",y.toneMappingExposure),Bt.needsLights&&os(On,as),ht&&W.fog===!0&&_t.refreshFogUniforms(On,ht),_t.refreshMaterialUniforms(On,W,Q,j,d.state.transmissionRenderTarget[E.id]),ta.upload(B,oo(Bt),On,R)),W.isShaderMaterial&&W.uniformsNeedUpdate===!0&&(ta.upload(B,oo(Bt),On,R),W.uniformsNeedUpdate=!1),W.isSpriteMaterial&&Te.setValue(B,"center",k.center),Te.setValue(B,"modelViewMatrix",k.modelViewMatrix),Te.setValue(B,"normalMatrix",k.normalMatrix),Te.setValue(B,"modelMatrix",k.matrixWorld),W.isShaderMaterial||W.isRawShaderMaterial){const un=W.uniformsGroups;for(let ai=0,Yn=un.length;ai<Yn;ai++){const Ns=un[ai];F.update(Ns,yn),F.bind(Ns,yn)}}return yn}function os(E,N){E.ambientLightColor.needsUpdate=N,E.lightProbe.needsUpdate=N,E.directionalLights.needsUpdate=N,E.directionalLightShadows.needsUpdate=N,E.pointLights.needsUpdate=N,E.pointLightShadows.needsUpdate=N,E.spotLights.needsUpdate=N,E.spotLightShadows.needsUpdate=N,E.rectAreaLights.needsUpdate=N,E.hemisphereLights.needsUpdate=N}function ao(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return I},this.setRenderTargetTextures=function(E,N,G){Pt.get(E.texture).__webglTexture=N,Pt.get(E.depthTexture).__webglTexture=G;const W=Pt.get(E);W.__hasExternalTextures=!0,W.__autoAllocateDepthBuffer=G===void 0,W.__autoAllocateDepthBuffer||Zt.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),W.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(E,N){const G=Pt.get(E);G.__webglFramebuffer=N,G.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(E,N=0,G=0){I=E,L=N,D=G;let W=!0,k=null,ht=!1,yt=!1;if(E){const Dt=Pt.get(E);if(Dt.__useDefaultFramebuffer!==void 0)Vt.bindFramebuffer(B.FRAMEBUFFER,null),W=!1;else if(Dt.__webglFramebuffer===void 0)R.setupRenderTarget(E);else if(Dt.__hasExternalTextures)R.rebindTextures(E,Pt.get(E.texture).__webglTexture,Pt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){const Ut=E.depthTexture;if(Dt.__boundDepthTexture!==Ut){if(Ut!==null&&Pt.has(Ut)&&(E.width!==Ut.image.width||E.height!==Ut.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");R.setupDepthRenderbuffer(E)}}const Gt=E.texture;(Gt.isData3DTexture||Gt.isDataArrayTexture||Gt.isCompressedArrayTexture)&&(yt=!0);const Xt=Pt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Xt[N])?k=Xt[N][G]:k=Xt[N],ht=!0):E.samples>0&&R.useMultisampledRTT(E)===!1?k=Pt.get(E).__webglMultisampledFramebuffer:Array.isArray(Xt)?k=Xt[G]:k=Xt,C.copy(E.viewport),$.copy(E.scissor),O=E.scissorTest}else C.copy(mt).multiplyScalar(Q).floor(),$.copy(Mt).multiplyScalar(Q).floor(),O=pt;if(Vt.bindFramebuffer(B.FRAMEBUFFER,k)&&W&&Vt.drawBuffers(E,k),Vt.viewport(C),Vt.scissor($),Vt.setScissorTest(O),ht){const Dt=Pt.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+N,Dt.__webglTexture,G)}else if(yt){const Dt=Pt.get(E.texture),Gt=N||0;B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,Dt.__webglTexture,G||0,Gt)}b=-1},this.readRenderTargetPixels=function(E,N,G,W,k,ht,yt){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){Vt.bindFramebuffer(B.FRAMEBUFFER,Ft);try{const Dt=E.texture,Gt=Dt.format,Xt=Dt.type;if(!Qt.textureFormatReadable(Gt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Qt.textureTypeReadable(Xt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=E.width-W&&G>=0&&G<=E.height-k&&B.readPixels(N,G,W,k,Yt.convert(Gt),Yt.convert(Xt),ht)}finally{const Dt=I!==null?Pt.get(I).__webglFramebuffer:null;Vt.bindFramebuffer(B.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(E,N,G,W,k,ht,yt){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){const Dt=E.texture,Gt=Dt.format,Xt=Dt.type;if(!Qt.textureFormatReadable(Gt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Qt.textureTypeReadable(Xt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(N>=0&&N<=E.width-W&&G>=0&&G<=E.height-k){Vt.bindFramebuffer(B.FRAMEBUFFER,Ft);const Ut=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.bufferData(B.PIXEL_PACK_BUFFER,ht.byteLength,B.STREAM_READ),B.readPixels(N,G,W,k,Yt.convert(Gt),Yt.convert(Xt),0);const se=I!==null?Pt.get(I).__webglFramebuffer:null;Vt.bindFramebuffer(B.FRAMEBUFFER,se);const ve=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await H_(B,ve,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,ht),B.deleteBuffer(Ut),B.deleteSync(ve),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(E,N=null,G=0){E.isTexture!==!0&&(Xr("WebGLRenderer: copyFramebufferToTexture function signature has changed."),N=arguments[0]||null,E=arguments[1]);const W=Math.pow(2,-G),k=Math.floor(E.image.width*W),ht=Math.floor(E.image.height*W),yt=N!==null?N.x:0,Ft=N!==null?N.y:0;R.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,G,0,0,yt,Ft,k,ht),Vt.unbindTexture()},this.copyTextureToTexture=function(E,N,G=null,W=null,k=0){E.isTexture!==!0&&(Xr("WebGLRenderer: copyTextureToTexture function signature has changed."),W=arguments[0]||null,E=arguments[1],N=arguments[2],k=arguments[3]||0,G=null);let ht,yt,Ft,Dt,Gt,Xt,Ut,se,ve;const Se=E.isCompressedTexture?E.mipmaps[k]:E.image;G!==null?(ht=G.max.x-G.min.x,yt=G.max.y-G.min.y,Ft=G.isBox3?G.max.z-G.min.z:1,Dt=G.min.x,Gt=G.min.y,Xt=G.isBox3?G.min.z:0):(ht=Se.width,yt=Se.height,Ft=Se.depth||1,Dt=0,Gt=0,Xt=0),W!==null?(Ut=W.x,se=W.y,ve=W.z):(Ut=0,se=0,ve=0);const Je=Yt.convert(N.format),le=Yt.convert(N.type);let Bt;N.isData3DTexture?(R.setTexture3D(N,0),Bt=B.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(R.setTexture2DArray(N,0),Bt=B.TEXTURE_2D_ARRAY):(R.setTexture2D(N,0),Bt=B.TEXTURE_2D),B.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,N.flipY),B.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),B.pixelStorei(B.UNPACK_ALIGNMENT,N.unpackAlignment);const Ie=B.getParameter(B.UNPACK_ROW_LENGTH),fe=B.getParameter(B.UNPACK_IMAGE_HEIGHT),yn=B.getParameter(B.UNPACK_SKIP_PIXELS),oi=B.getParameter(B.UNPACK_SKIP_ROWS),an=B.getParameter(B.UNPACK_SKIP_IMAGES);B.pixelStorei(B.UNPACK_ROW_LENGTH,Se.width),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Se.height),B.pixelStorei(B.UNPACK_SKIP_PIXELS,Dt),B.pixelStorei(B.UNPACK_SKIP_ROWS,Gt),B.pixelStorei(B.UNPACK_SKIP_IMAGES,Xt);const as=E.isDataArrayTexture||E.isData3DTexture,Te=N.isDataArrayTexture||N.isData3DTexture;if(E.isRenderTargetTexture||E.isDepthTexture){const On=Pt.get(E),zi=Pt.get(N),un=Pt.get(On.__renderTarget),ai=Pt.get(zi.__renderTarget);Vt.bindFramebuffer(B.READ_FRAMEBUFFER,un.__webglFramebuffer),Vt.bindFramebuffer(B.DRAW_FRAMEBUFFER,ai.__webglFramebuffer);for(let Yn=0;Yn<Ft;Yn++)as&&B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(E).__webglTexture,k,Xt+Yn),E.isDepthTexture?(Te&&B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(N).__webglTexture,k,ve+Yn),B.blitFramebuffer(Dt,Gt,ht,yt,Ut,se,ht,yt,B.DEPTH_BUFFER_BIT,B.NEAREST)):Te?B.copyTexSubImage3D(Bt,k,Ut,se,ve+Yn,Dt,Gt,ht,yt):B.copyTexSubImage2D(Bt,k,Ut,se,ve+Yn,Dt,Gt,ht,yt);Vt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Vt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Te?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Bt,k,Ut,se,ve,ht,yt,Ft,Je,le,Se.data):N.isCompressedArrayTexture?B.compressedTexSubImage3D(Bt,k,Ut,se,ve,ht,yt,Ft,Je,Se.data):B.texSubImage3D(Bt,k,Ut,se,ve,ht,yt,Ft,Je,le,Se):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,k,Ut,se,ht,yt,Je,le,Se.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,k,Ut,se,Se.width,Se.height,Je,Se.data):B.texSubImage2D(B.TEXTURE_2D,k,Ut,se,ht,yt,Je,le,Se);B.pixelStorei(B.UNPACK_ROW_LENGTH,Ie),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,fe),B.pixelStorei(B.UNPACK_SKIP_PIXELS,yn),B.pixelStorei(B.UNPACK_SKIP_ROWS,oi),B.pixelStorei(B.UNPACK_SKIP_IMAGES,an),k===0&&N.generateMipmaps&&B.generateMipmap(Bt),Vt.unbindTexture()},this.copyTextureToTexture3D=function(E,N,G=null,W=null,k=0){return E.isTexture!==!0&&(Xr("WebGLRenderer: copyTextureToTexture3D function signature has changed."),G=arguments[0]||null,W=arguments[1]||null,E=arguments[2],N=arguments[3],k=arguments[4]||0),Xr('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(E,N,G,W,k)},this.initRenderTarget=function(E){Pt.get(E).__webglFramebuffer===void 0&&R.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?R.setTextureCube(E,0):E.isData3DTexture?R.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?R.setTexture2DArray(E,0):R.setTexture2D(E,0),Vt.unbindTexture()},this.resetState=function(){L=0,D=0,I=null,Vt.reset(),ue.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Di}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=ce._getDrawingBufferColorSpace(t),e.unpackColorSpace=ce._getUnpackColorSpace()}}class QS extends Mn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ki,this.environmentIntensity=1,this.environmentRotation=new ki,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}}class Yc extends Tr{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new Me(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const oa=new V,aa=new V,lf=new Fe,Hr=new so,zo=new io,ml=new V,cf=new V;class ty extends Mn{constructor(t=new Xn,e=new Yc){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)oa.fromBufferAttribute(e,s-1),aa.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=oa.distanceTo(aa);t.setAttribute("lineDistance",new xi(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),zo.copy(n.boundingSphere),zo.applyMatrix4(s),zo.radius+=r,t.ray.intersectsSphere(zo)===!1)return;lf.copy(s).invert(),Hr.copy(t.ray).applyMatrix4(lf);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){const m=Math.max(0,o.start),_=Math.min(h.count,o.start+o.count);for(let x=m,p=_-1;x<p;x+=c){const d=h.getX(x),T=h.getX(x+1),A=Ho(this,t,Hr,l,d,T);A&&e.push(A)}if(this.isLineLoop){const x=h.getX(_-1),p=h.getX(m),d=Ho(this,t,Hr,l,x,p);d&&e.push(d)}}else{const m=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let x=m,p=_-1;x<p;x+=c){const d=Ho(this,t,Hr,l,x,x+1);d&&e.push(d)}if(this.isLineLoop){const x=Ho(this,t,Hr,l,_-1,m);x&&e.push(x)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Ho(i,t,e,n,s,r){const o=i.geometry.attributes.position;if(oa.fromBufferAttribute(o,s),aa.fromBufferAttribute(o,r),e.distanceSqToSegment(oa,aa,ml,cf)>n)return;ml.applyMatrix4(i.matrixWorld);const l=t.ray.origin.distanceTo(ml);if(!(l<t.near||l>t.far))return{distance:l,point:cf.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}const hf=new V,uf=new V;class Yd extends ty{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)hf.fromBufferAttribute(e,s),uf.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+hf.distanceTo(uf);t.setAttribute("lineDistance",new xi(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class qd extends Tr{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new Me(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const ff=new Fe,vc=new so,Vo=new io,Go=new V;class ey extends Mn{constructor(t=new Xn,e=new qd){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Vo.copy(n.boundingSphere),Vo.applyMatrix4(s),Vo.radius+=r,t.ray.intersectsSphere(Vo)===!1)return;ff.copy(s).invert(),vc.copy(t.ray).applyMatrix4(ff);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){const f=Math.max(0,o.start),m=Math.min(c.count,o.start+o.count);for(let _=f,x=m;_<x;_++){const p=c.getX(_);Go.fromBufferAttribute(u,p),df(Go,p,l,s,t,e,this)}}else{const f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=f,x=m;_<x;_++)Go.fromBufferAttribute(u,_),df(Go,_,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function df(i,t,e,n,s,r,o){const a=vc.distanceSqToPoint(i);if(a<e){const l=new V;vc.closestPointToPoint(i,l),l.applyMatrix4(n);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}const pf=new Fe;class ny{constructor(t,e,n=0,s=1/0){this.ray=new so(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new Gc,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,(e.near+e.far)/(e.near-e.far)).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):console.error("THREE.Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return pf.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(pf),this}intersectObject(t,e=!0,n=[]){return xc(t,this,n,e),n.sort(mf),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)xc(t[s],this,n,e);return n.sort(mf),n}}function mf(i,t){return i.distance-t.distance}function xc(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){const r=i.children;for(let o=0,a=r.length;o<a;o++)xc(r[o],t,e,!0)}}class gf{constructor(t=1,e=0,n=0){return this.radius=t,this.phi=e,this.theta=n,this}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Math.max(1e-6,Math.min(Math.PI-1e-6,this.phi)),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(_n(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class iy extends Us{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(){}disconnect(){}dispose(){}update(){}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Fc}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Fc);const _f={type:"change"},qc={type:"start"},$d={type:"end"},Wo=new so,vf=new Pi,sy=Math.cos(70*k_.DEG2RAD),Xe=new V,bn=2*Math.PI,be={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},gl=1e-6;class xf extends iy{constructor(t,e=null){super(t,e),this.state=be.NONE,this.enabled=!0,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Fi.ROTATE,MIDDLE:Fi.DOLLY,RIGHT:Fi.PAN},this.touches={ONE:Qi.ROTATE,TWO:Qi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new Ps,this._lastTargetPosition=new V,this._quat=new Ps().setFromUnitVectors(t.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new gf,this._sphericalDelta=new gf,this._scale=1,this._panOffset=new V,this._rotateStart=new ee,this._rotateEnd=new ee,this._rotateDelta=new ee,this._panStart=new ee,this._panEnd=new ee,this._panDelta=new ee,this._dollyStart=new ee,this._dollyEnd=new ee,this._dollyDelta=new ee,this._dollyDirection=new V,this._mouse=new ee,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=oy.bind(this),this._onPointerDown=ry.bind(this),this._onPointerUp=ay.bind(this),this._onContextMenu=py.bind(this),this._onMouseWheel=hy.bind(this),this._onKeyDown=uy.bind(this),this._onTouchStart=fy.bind(this),this._onTouchMove=dy.bind(this),this._onMouseDown=ly.bind(this),this._onMouseMove=cy.bind(this),this._interceptControlDown=my.bind(this),this._interceptControlUp=gy.bind(this),this.domElement!==null&&this.connect(),this.update()}connect(){this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(_f),this.update(),this.state=be.NONE}update(t=null){const e=this.object.position;Xe.copy(e).sub(this.target),Xe.applyQuaternion(this._quat),this._spherical.setFromVector3(Xe),this.autoRotate&&this.state===be.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=bn:n>Math.PI&&(n-=bn),s<-Math.PI?s+=bn:s>Math.PI&&(s-=bn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Xe.setFromSpherical(this._spherical),Xe.applyQuaternion(this._quatInverse),e.copy(this.target).add(Xe),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){const a=Xe.length();o=this._clampDistance(a*this._scale);const l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){const a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);const l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;const c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Xe.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Wo.origin.copy(this.object.position),Wo.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Wo.direction))<sy?this.object.lookAt(this.target):(vf.setFromNormalAndCoplanarPoint(this.object.up,this.target),Wo.intersectPlane(vf,this.target))))}else if(this.object.isOrthographicCamera){const o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>gl||8*(1-this._lastQuaternion.dot(this.object.quaternion))>gl||this._lastTargetPosition.distanceToSquared(this.target)>gl?(this.dispatchEvent(_f),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?bn/60*this.autoRotateSpeed*t:bn/60/60*this.autoRotateSpeed}_getZoomScale(t){const e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Xe.setFromMatrixColumn(e,0),Xe.multiplyScalar(-t),this._panOffset.add(Xe)}_panUp(t,e){this.screenSpacePanning===!0?Xe.setFromMatrixColumn(e,1):(Xe.setFromMatrixColumn(e,0),Xe.crossVectors(this.object.up,Xe)),Xe.multiplyScalar(t),this._panOffset.add(Xe)}_pan(t,e){const n=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;Xe.copy(s).sub(this.target);let r=Xe.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const e=this.domElement;this._rotateLeft(bn*this._rotateDelta.x/e.clientHeight),this._rotateUp(bn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(bn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(-bn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(bn*this.rotateSpeed/this.domElement.clientHeight):this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(-bn*this.rotateSpeed/this.domElement.clientHeight):this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){const e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{const n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const e=this.domElement;this._rotateLeft(bn*this._rotateDelta.x/e.clientHeight),this._rotateUp(bn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){const e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new ee,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){const e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){const e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}}function ry(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function oy(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function ay(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent($d),this.state=be.NONE;break;case 1:const t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function ly(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Fi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=be.DOLLY;break;case Fi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=be.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=be.ROTATE}break;case Fi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=be.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=be.PAN}break;default:this.state=be.NONE}this.state!==be.NONE&&this.dispatchEvent(qc)}function cy(i){switch(this.state){case be.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case be.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case be.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function hy(i){this.enabled===!1||this.enableZoom===!1||this.state!==be.NONE||(i.preventDefault(),this.dispatchEvent(qc),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent($d))}function uy(i){this.enabled===!1||this.enablePan===!1||this._handleKeyDown(i)}function fy(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Qi.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=be.TOUCH_ROTATE;break;case Qi.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=be.TOUCH_PAN;break;default:this.state=be.NONE}break;case 2:switch(this.touches.TWO){case Qi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=be.TOUCH_DOLLY_PAN;break;case Qi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=be.TOUCH_DOLLY_ROTATE;break;default:this.state=be.NONE}break;default:this.state=be.NONE}this.state!==be.NONE&&this.dispatchEvent(qc)}function dy(i){switch(this._trackPointer(i),this.state){case be.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case be.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case be.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case be.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=be.NONE}}function py(i){this.enabled!==!1&&i.preventDefault()}function my(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function gy(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}class _y{constructor(t,e){this.moved=e,this.space.up.set(0,0,1),this.above.up.set(1,0,0),this.spaceControls=new xf(this.space,t),this.spaceControls.maxPolarAngle=Math.PI/2-.02,this.aboveControls=new xf(this.above,t),this.aboveControls.enableRotate=!1,this.aboveControls.screenSpacePanning=!0,this.aboveControls.mouseButtons={LEFT:Fi.PAN,MIDDLE:Fi.DOLLY,RIGHT:Fi.PAN},this.aboveControls.touches={ONE:Qi.PAN,TWO:Qi.DOLLY_PAN};for(const n of[this.spaceControls,this.aboveControls])n.enableDamping=!1,n.zoomToCursor=!0,n.addEventListener("change",()=>this.moved());this.look(0,0,0,40),this.setTop(!1)}space=new Wn(50,1,.1,5e4);above=new zd(-1,1,1,-1,-2e4,2e4);spaceControls;aboveControls;isTop=!1;target=new V;get camera(){return this.isTop?this.above:this.space}get distance(){return this.isTop?1/this.above.zoom:this.space.position.distanceTo(this.spaceControls.target)}set enabled(t){this.spaceControls.enabled=t&&!this.isTop,this.aboveControls.enabled=t&&this.isTop}setTop(t){this.isTop=t,this.enabled=!0}look(t,e,n,s){this.target.set(t,e,n),this.spaceControls.target.set(t,e,n),this.space.position.set(t-.95*s,e,n+.85*s),this.aboveControls.target.set(t,e,n),this.above.position.set(t,e,n+500),this.above.zoom=1/s,this.above.updateProjectionMatrix(),this.spaceControls.update(),this.aboveControls.update()}carry(t,e,n){for(const s of[this.spaceControls,this.aboveControls])s.target.add(new V(t,e,n)),s.object.position.add(new V(t,e,n)),s.update()}resize(t,e){const n=t/Math.max(1,e);this.space.aspect=n,this.space.updateProjectionMatrix(),this.above.left=-Math.max(1,n),this.above.right=Math.max(1,n),this.above.top=Math.max(1,1/n),this.above.bottom=-Math.max(1,1/n),this.above.updateProjectionMatrix()}}const Mf=10,Xo=16;class vy{object;material=new Yc;constructor(){const t=[];for(let n=-Xo;n<=Xo;++n)for(let s=-Xo;s<Xo;++s)t.push(n,s,0,n,s+1,0,s,n,0,s+1,n,0);const e=new Xn;e.setAttribute("position",new xi(t.map(n=>n*Mf),3)),this.object=new Yd(e,this.material),this.object.frustumCulled=!1}colour(t){this.material.color.set(t)}centre(t,e,n,s){const r=s<20?.1:s<300?1:s<3e3?10:100,o=r*Mf;this.object.scale.set(r,r,1),this.object.position.set(o*Math.round(t/o),o*Math.round(e/o),n-.02)}}class _l{object;geometry=new Xn;positions=new Float32Array(3*1024);colours=new Uint8Array(3*1024);count=0;constructor(t,e=1){const n={vertexColors:!0,transparent:e<1,opacity:e,depthWrite:e>=1};this.object=t==="lines"?new Yd(this.geometry,new Yc(n)):new vi(this.geometry,new Wc({...n,side:gi})),this.object.frustumCulled=!1,this.attach()}begin(){this.count=0}point(t,e,n,[s,r,o]){3*(this.count+1)>this.positions.length&&this.grow();const a=3*this.count++;this.positions[a]=t,this.positions[a+1]=e,this.positions[a+2]=n,this.colours[a]=s??0,this.colours[a+1]=r??0,this.colours[a+2]=o??0}line(t,e,n,s,r){this.point(t[0]??0,t[1]??0,n,r),this.point(e[0]??0,e[1]??0,s,r)}loop(t,e,n){t.forEach((s,r)=>this.line(s,t[(r+1)%t.length]??s,e,e,n))}end(){this.geometry.setDrawRange(0,this.count),this.geometry.attributes.position.needsUpdate=!0,this.geometry.attributes.color.needsUpdate=!0}grow(){const t=new Float32Array(2*this.positions.length),e=new Uint8Array(2*this.colours.length);t.set(this.positions),e.set(this.colours),this.positions=t,this.colours=e,this.attach()}attach(){this.geometry.dispose(),this.geometry.setAttribute("position",new An(this.positions,3)),this.geometry.setAttribute("color",new An(this.colours,3,!0))}}class xy{group=new qr;clouds=new Map;material=new qd({vertexColors:!0,sizeAttenuation:!1});show(t,e,n,s,r){this.material.size=s;const o=new Set(t);for(const[a,l]of this.clouds)o.has(a)||(this.group.remove(l.points),l.points.geometry.dispose(),this.clouds.delete(a));t.forEach((a,l)=>{const c=t.length>1?l/(t.length-1):0,h=l===0?r:0;this.showOne(a,`${e} ${n} ${c.toFixed(2)} ${h}`,()=>kp(a,e,n,c,h))})}showOne(t,e,n){let s=this.clouds.get(t);if(!s){const r=new Xn;r.setAttribute("position",new An(t.positions,3));const o=new ey(r,this.material);o.frustumCulled=!1,s={points:o,look:"",age:0},this.clouds.set(t,s),this.group.add(o)}s.look!==e&&(s.look=e,s.points.geometry.setAttribute("color",new An(n(),3,!0)))}}const Mc=0,My=2,Sy=60;class Sf{constructor(t,e){this.settings=t,this.trails=e,this.scene.add(this.points.group,this.faces.object,this.pale.object,this.lines.object)}scene=new QS;tags=[];frame=null;labels=[];points=new xy;lines=new _l("lines");pale=new _l("lines",.45);faces=new _l("faces",.2);show(t){const e=t[0];if(!e)return;this.frame=e;const{shown:n,colourBy:s,theme:r,pointSize:o,selected:a}=this.settings;this.points.group.visible=n.points,this.points.show(t,s,r,o,Rf(e,a)),this.tags=[];for(const l of[this.lines,this.pale,this.faces])l.begin();if(n.outlines&&this.drawOutlines(e),(n.detections||yy(e))&&this.drawDetections(e),n.truth&&this.drawTruth(e),n.boxes)for(const l of this.visibleTracks())this.drawTrack(e,l);n.sight&&this.drawSight(e),e.edges.length>0?this.drawRig(e):e.rays.length>0?this.drawRays(e):this.drawSensor(e),this.drawLabels();for(const l of[this.lines,this.pale,this.faces])l.end()}visibleTracks(){const{shown:t,selected:e}=this.settings;return(this.frame?.tracks??[]).filter(n=>t.tentative||n.status!==Mc||n.id===e)}get palette(){return si[this.settings.theme]}ground(t){return t.egoPose.z}drawTrack(t,e){const n=e.id===this.settings.selected,s=n?this.palette.selected:this.palette.classes[e.class]??this.palette.text,r=gn(s),o=e.status===My||e.status===Mc,a=o?this.pale:this.lines,l=e.length<.01,c=l?e.z:this.ground(t),h=l?c:c+Np(e,e.class,Ty(e));if(l?this.drawMark([e.x,e.y,c],this.markSize(t),a,r):this.drawBox(a,e,c,h,r,n||!o),Math.hypot(e.vx,e.vy)>.3){const f=[e.x+e.vx,e.y+e.vy];a.line([e.x,e.y],f,h,h,r)}(this.settings.shown.covariance||n)&&this.lines.loop(gh(e.x,e.y,e.covariance),c,r),this.settings.shown.trails&&this.drawTrail(t,e,r,c),this.settings.shown.ids&&this.tags.push({text:Ey(e),x:e.x,y:e.y,z:h,colour:s,track:e.id,faint:o&&!n})}drawBox(t,e,n,s,r,o){const a=Ur(e);t.loop(a,n,r),t.loop(a,s,r);for(const f of a)t.line(f,f,n,s,r);const[l=[],c=[],h=[],u=[]]=a;if(t.line(l,u,n,s,r),!!o)for(const f of[l,c,h,l,h,u])this.faces.point(f[0]??0,f[1]??0,n,r)}drawTrail(t,e,n,s){const r=this.trails.of(e.id,t.frame-Sy,t.frame);for(let o=1;o<r.length;++o){const a=r[o-1],l=r[o];a&&l&&this.pale.line([a.x,a.y],[l.x,l.y],s,s,n)}}drawOutlines(t){const e=t.sensorPose.z,n=gn(this.palette.text);for(const s of t.lines)this.pale.line([s.x0,s.y0],[s.x1,s.y1],e,e,n)}drawDetections(t){const e=this.ground(t);for(const n of t.detections){const s=gn(this.palette.classes[n.class]??this.palette.text),r=n.length<.01;r?this.drawMark([n.x,n.y,n.z],this.markSize(t),this.lines,s):this.pale.loop(Ur(n),e,s),(this.settings.shown.covariance||r)&&this.pale.loop(gh(n.x,n.y,n.covariance),e,s)}}drawTruth(t){const e=this.ground(t),n=gn(this.palette.truth);for(const s of t.truth){const r=Ur(s);r.forEach((o,a)=>wy(this.lines,o,r[(a+1)%4]??o,e,n))}}drawSensor(t){const e=gn(this.palette.accent),{x:n,y:s,heading:r}=t.egoPose,o=this.ground(t),a=t.sensorPose,l=(h,u)=>[n+u*Math.cos(r+h),s+u*Math.sin(r+h)],c=Math.max(.1,Math.min(1,by(t)/25));this.lines.loop([l(0,1.5*c),l(2.5,c),l(Math.PI,.5*c),l(-2.5,c)],o,e),this.lines.line([a.x,a.y],[a.x,a.y],o,a.z,e)}drawSight(t){const e=t.sensorPose,n=gn(this.palette.accent);for(const s of this.visibleTracks())this.pale.line([e.x,e.y],[s.x,s.y],e.z,e.z,n)}drawRays(t){const e=this.markSize(t),n=new Set;for(const s of t.rays){const r=gn(s.target<0?this.palette.noise:this.palette.accent);if(this.pale.line(s.from,s.to,s.from[2],s.to[2],r),n.has(s.sensor))continue;n.add(s.sensor),this.drawMark(s.from,1.5*e,this.lines,gn(this.palette.text));const[o,a,l]=s.from;this.tags.push({text:`sensor ${s.sensor+1}`,x:o,y:a,z:l,colour:this.palette.text,track:null,faint:!1})}}drawRig(t){const{text:e,accent:n,warning:s,noise:r}=this.palette,o=[e,n,s,r],a=new Set;for(const{from:l,to:c,part:h}of t.edges){const u=o[h]??e;if(this.lines.line(l,c,l[2],c[2],gn(u)),a.has(h))continue;a.add(h);const[f,m,_]=l;this.tags.push({text:pp[h]??"",x:f,y:m,z:_,colour:u,track:null,faint:!1})}}drawMark([t,e,n],s,r,o){r.loop([[t+s,e],[t,e+s],[t-s,e],[t,e-s]],n,o),r.line([t,e],[t,e],n-s,n+s,o)}markSize(t){return Math.max(10,...t.rays.map(n=>Math.hypot(n.to[0]-n.from[0],n.to[1]-n.from[1])))/80}drawLabels(){const t=this.frame;if(!t)return;const e=this.ground(t),n=gn(this.palette.warning);for(const s of this.labels)this.lines.loop(Ur(s),e+.02,n),this.lines.loop(Ur({...s,length:s.length+.15,width:s.width+.15}),e+.02,n),this.tags.push({text:`object ${s.id}`,x:s.x,y:s.y,z:e,colour:this.palette.warning,track:null,faint:!1})}}function yy(i){return i.rays.length>0&&i.tracks.length===0}function Ey(i){const t=["","car","person","cyclist","other"];return`${i.id} ${t[i.class]??""}${i.status===Mc?" (new)":""}`}function by(i){const t=[],e=3*Math.max(1,Math.floor(i.positions.length/300));for(let n=0;n<i.positions.length;n+=e)t.push(Math.hypot((i.positions[n]??0)-i.egoPose.x,(i.positions[n+1]??0)-i.egoPose.y));return t.sort((n,s)=>n-s)[t.length>>1]??25}function Ty(i){return i.class===1&&i.length<1.5?i.length/4.5:1}function wy(i,t,e,n,s){const r=Math.hypot((e[0]??0)-(t[0]??0),(e[1]??0)-(t[1]??0)),o=Math.max(3,2*Math.round(r/.5)+1);for(let a=0;a<o;a+=2){const l=c=>[(t[0]??0)+c*((e[0]??0)-(t[0]??0)),(t[1]??0)+c*((e[1]??0)-(t[1]??0))];i.line(l(a/o),l((a+1)/o),n,n,s)}}const Ay=60;class Ry{element=nt("div",{class:"tags","aria-hidden":"true"});pool=[];used=0;begin(){this.used=0}place(t,e,n,s,r,o){const a=new V;for(const l of t){if(this.used>=Ay)return;if(a.set(l.x,l.y,l.z).project(e),Math.abs(a.x)>1||Math.abs(a.y)>1||a.z>1||a.z<-1)continue;const c=n+s*(a.x+1)/2,h=r*(1-a.y)/2,u=this.next();u.textContent!==l.text&&(u.textContent=l.text),u.style.transform=`translate(${c.toFixed(0)}px, ${(h-18).toFixed(0)}px)`,u.style.color=l.colour,u.classList.toggle("faint",l.faint),u.classList.toggle("selected",l.track!==null&&l.track===o)}}end(){for(let t=this.used;t<this.pool.length;++t){const e=this.pool[t];e&&(e.hidden=!0)}}next(){let t=this.pool[this.used];return t||(t=nt("span",{class:"tag"}),this.pool.push(t),this.element.append(t)),t.hidden=!1,++this.used,t}}class yf{byTrack=new Map;known=new Set;add(t){if(!this.known.has(t.frame)){this.known.add(t.frame);for(const e of t.tracks)this.insert({id:e.id,frame:t.frame,x:e.x,y:e.y})}}addMany(t){for(const e of t)this.known.has(e.frame)||this.insert(e);for(const e of t)this.known.add(e.frame)}knows(t,e){for(let n=Math.max(0,t);n<=e;++n)if(!this.known.has(n))return!1;return!0}mark(t,e){for(let n=Math.max(0,t);n<=e;++n)this.known.add(n)}of(t,e,n){const s=this.byTrack.get(t)??[];return s.slice(vl(s,e),vl(s,n+1))}forget(){this.byTrack.clear(),this.known.clear()}insert(t){const e=this.byTrack.get(t.id);e?e.splice(vl(e,t.frame),0,t):this.byTrack.set(t.id,[t])}}function vl(i,t){let e=0,n=i.length;for(;e<n;){const s=e+n>>1;(i[s]?.frame??0)<t?e=s+1:n=s}return e}class Cy{constructor(t){this.settings=t,this.panes=[new Sf(t,new yf),new Sf(t,new yf)],ce.enabled=!1,this.renderer=new JS({antialias:!Py()}),this.renderer.outputColorSpace=Ds,this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.renderer.setScissorTest(!0),this.renderer.autoClear=!1,this.element.append(this.renderer.domElement,this.tags.element),this.cameras=new _y(this.renderer.domElement,()=>this.redraw()),new ResizeObserver(()=>this.resize()).observe(this.element),this.listen()}element=nt("div",{class:"stage",tabindex:"0",role:"application","aria-label":"Scene; arrow keys step through the recording"});picked=new Ui;dragged=new Ui;panes;grabs=()=>!1;frameTimes=[];renderer;cameras;tags=new Ry;grid=new vy;dirty=!0;width=1;height=1;followed=null;placed=!1;redraw(){this.dirty=!0}restyle(){this.cameras.setTop(this.settings.view==="top"),this.grid.colour(si[this.settings.theme].grid),this.resize()}show(t,e){const n=e[0];n&&(this.panes[t].show(e),t===0&&this.follow(n),this.redraw())}fit(){const t=this.panes[0].frame;if(!t)return;const e=t.tracks.find(s=>s.id===this.settings.selected),n=Ly(t);e?this.cameras.look(e.x,e.y,t.egoPose.z,12):this.cameras.look(n.x,n.y,t.egoPose.z,n.reach),this.redraw()}draw(){if(!this.dirty)return;this.dirty=!1;const t=performance.now(),e=this.settings.compare,n=e?this.width/2:this.width;this.tags.begin(),this.cameras.resize(n,this.height),this.renderer.setClearColor(si[this.settings.theme].ground);for(const[s,r]of this.panes.entries()){if(s===1&&!e)break;r.scene.add(this.grid.object),this.renderer.setViewport(s*n,0,n,this.height),this.renderer.setScissor(s*n,0,n,this.height),this.renderer.clear(),this.renderer.render(r.scene,this.cameras.camera),this.tags.place(r.tags,this.cameras.camera,s*n,n,this.height,this.settings.selected)}this.tags.end(),this.frameTimes.push(performance.now()-t),this.frameTimes.length>600&&this.frameTimes.shift()}placeOf(t){const e=this.panes[0].frame?.tracks.find(o=>o.id===t);if(!e)return null;const n=new V(e.x,e.y,e.z).project(this.cameras.camera),s=this.renderer.domElement.getBoundingClientRect(),r=this.settings.compare?this.width/2:this.width;return{x:s.left+r*(n.x+1)/2,y:s.top+this.height*(1-n.y)/2}}follow(t){!this.placed&&t.positions.length+t.rays.length>0&&(this.placed=!0,this.fit());const e=t.tracks.find(l=>l.id===this.settings.selected),{x:n,y:s}=e??t.egoPose,r=e?.id??null,{ego:o,...a}=this.followed??{ego:null};if(this.settings.follow&&o){const l="id"in a&&a.id===r?a:o,c=l===o?t.egoPose:{x:n,y:s};this.cameras.carry(c.x-l.x,c.y-l.y,t.egoPose.z-o.z)}this.followed={id:r,x:n,y:s,ego:t.egoPose},this.grid.centre(t.egoPose.x,t.egoPose.y,t.egoPose.z,this.cameras.distance)}resize(){this.width=Math.max(1,this.element.clientWidth),this.height=Math.max(1,this.element.clientHeight),this.renderer.setSize(this.width,this.height),this.redraw()}listen(){const t=this.renderer.domElement;let e=null;t.addEventListener("pointerdown",n=>{const s=this.groundAt(n),r=s!==null&&this.grabs(s.x,s.y);e={x:n.clientX,y:n.clientY,drags:r},this.cameras.enabled=!r},{capture:!0}),t.addEventListener("pointermove",n=>{const s=e?.drags?this.groundAt(n):null;s&&this.dragged.emit({...s,done:!1})}),t.addEventListener("pointerup",n=>{const s=this.groundAt(n);e?.drags&&s?this.dragged.emit({...s,done:!0}):e&&Math.hypot(n.clientX-e.x,n.clientY-e.y)<5&&this.picked.emit(s?this.trackAt(s.x,s.y,s.pane):null),e=null,this.cameras.enabled=!0})}groundAt(t){const e=this.renderer.domElement.getBoundingClientRect(),n=this.settings.compare,s=n?e.width/2:e.width,r=n&&t.clientX-e.left>s?1:0,o=2*(t.clientX-e.left-r*s)/s-1,a=1-2*(t.clientY-e.top)/e.height,l=new ny;l.setFromCamera(new ee(o,a),this.cameras.camera);const c=(this.panes[r].frame?.egoPose.z??0)+(this.settings.view==="top"?0:.5),h=l.ray.intersectPlane(new Pi(new V(0,0,1),-c),new V);return h&&{x:h.x,y:h.y,pane:r}}trackAt(t,e,n){let s=null,r=1/0;const o=Math.max(.6,.02*this.cameras.distance);for(const a of this.panes[n].visibleTracks()){const l=Math.hypot(a.x-t,a.y-e);Af(a,t,e,o)&&l<r&&(s=a,r=l)}return s}}function Py(){const i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=i&&t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(e)}function Ly(i){const t=3*Math.max(1,Math.floor(i.positions.length/9e3)),e=[],n=[];for(let m=0;m<i.positions.length;m+=t)e.push(i.positions[m]??0),n.push(i.positions[m+1]??0);for(const{from:m,to:_}of i.rays)e.push(m[0],_[0]),n.push(m[1],_[1]);e.push(i.egoPose.x),n.push(i.egoPose.y);const s=(m,_)=>m[Math.floor(_*(m.length-1))]??0;for(const m of[e,n])m.sort((_,x)=>_-x);const[r,o,a,l]=[s(e,.03),s(e,.9),s(n,.05),s(n,.95)],c=Math.min(r,i.egoPose.x),h=(c+Math.max(o,i.egoPose.x))/2,u=(a+l)/2,f=Math.max(o-h,h-c,(l-a)/2);return{x:h,y:u,reach:Math.max(3,Math.min(i.rays.length>0?1/0:60,1.15*f))}}const xl=60,Dy=3;class Uy{settings=new Sp(Iy());player=new Xg;connection=new Mp;store=new bp(t=>this.connection.ask(t));stage=new Cy(this.settings);timeline=new qg(this.player,this.settings);label;tabs;help;bar;legend;track;tune;info=new Up;names={classes:[],statuses:[]};status=null;last=0;indexAsked=-1;eventsAsked=-1;trialShown=0;constructor(t){this.track=new Hg(this.settings,this.names,s=>this.player.seek(this.player.frameAt(s)),s=>this.select(s)),this.tune=new Wg(s=>this.connection.ask(s),()=>this.player.frame,s=>this.settings.change(r=>r.compare=s)),this.label=new Op(s=>this.connection.ask(s),()=>this.player.frame,this.settings,s=>this.drawLabels(s)),this.tabs=new Bp([["Track",this.track.element],["Tune",this.tune.element],["Label",this.label.element],["Info",this.info.element]],s=>this.label.setActive(s==="Label")),this.legend=new Lp(this.settings,()=>this.names.classes);const e=jg(this);this.help=Cp(e),Tp(e),this.bar=new Ep(this.settings,()=>this.help.showModal(),()=>this.stage.fit());const n=new yp(this.player,s=>this.jump(s));t.append(this.bar.element,nt("main",{},nt("div",{class:"scene"},this.stage.element,this.legend.element,this.heads()),this.tabs.element),nt("footer",{},n.element,this.timeline.element),this.help),this.connect()}start(){ou(this.settings.theme),this.stage.restyle(),this.connection.connect();const t=e=>{this.player.advance((e-this.last)/1e3,n=>this.ready(n)),this.last=e,this.prefetch(),this.stage.draw(),requestAnimationFrame(t)};requestAnimationFrame(t)}select(t){this.settings.change(e=>e.selected=t),this.track.clear(),this.timeline.life=null,t!==null&&(this.tabs.open("Track"),this.connection.ask({op:"history",run:0,track:t})),this.refresh()}jump(t){const e=this.timeline.nextEvent(t);e&&(this.player.pause(),this.player.seek(e.frame),e.track!==this.settings.selected&&this.select(e.track))}cycle(t){const e=this.stage.panes[0].visibleTracks().map(r=>r.id).sort((r,o)=>r-o);if(e.length===0)return;const n=e.indexOf(this.settings.selected??NaN),s=n<0?t>0?0:e.length-1:(n+t+e.length)%e.length;this.select(e[s]??null)}heads(){const t=nt("div",{class:"heads"},nt("span",{},"left: as configured"),nt("span",{},"right: trial"));return this.settings.changed.on(()=>t.hidden=!this.settings.compare),t.hidden=!0,t}connect(){this.connection.told.on(t=>this.hear(t)),this.connection.binary.on(t=>this.take(t)),this.connection.link.on(t=>{t==="lost"&&this.bar.setNote("connection lost, trying again",!0),t==="open"&&(this.indexAsked=this.eventsAsked=-1)}),this.settings.changed.on(()=>{ou(this.settings.theme),this.stage.restyle(),this.track.restyle(),this.timeline.draw(),this.refresh()}),this.player.moved.on(()=>this.showCurrent()),this.stage.picked.on(t=>this.select(t?.id??null)),this.stage.grabs=(t,e)=>this.label.grabs(t,e),this.stage.dragged.on(({x:t,y:e,done:n})=>this.label.dragTo(t,e,n))}hear(t){switch(t.op){case"hello":return this.greet(t);case"status":return this.update(t);case"options":return this.tune.showOptions(t);case"metrics":return this.tune.showMetrics(t);case"export":return this.tune.saveExport(t.toml);case"labels":return this.label.show(t);case"missing":return this.store.missing(t.run,t.frame);case"problem":return this.bar.setNote(`${t.of}: ${t.what}`,!0)}}greet(t){this.bar.setTitle(t.title),this.names.classes=t.classes,this.names.statuses=t.statuses,this.store.forget(),this.player.live=t.live,t.live&&this.player.play(),this.tune.greet(t),this.info.greet(t)}update(t){this.status=t,t.frames>this.player.count&&this.indexAsked<t.frames&&(this.indexAsked=t.frames,this.connection.ask({op:"index",run:0,from:this.player.count})),t.events>this.timeline.events.length&&this.eventsAsked<t.events&&(this.eventsAsked=t.events,this.connection.ask({op:"events",run:0,from:this.timeline.events.length})),t.trial!==this.trialShown&&(this.trialShown=t.trial,this.store.forget(1),this.stage.panes[1].trails.forget()),this.timeline.trial=t.trial_from!==void 0&&t.trial_end!==void 0?[t.trial_from,t.trial_end-1]:null,this.timeline.draw(),this.tune.showStatus(t);const e=this.player.live?`live: ${t.frames} frames so far`:`reading and tracking: ${t.frames} frames so far`;t.problem!==""?this.bar.setNote(t.problem,!0):this.bar.setNote(t.done?"":e),this.showInfo()}take(t){switch(t.kind){case"frame":return this.takeFrame(t);case"index":return this.player.setTimes(t.from,t.times),this.showCurrent();case"events":return this.timeline.events.length=Math.min(this.timeline.events.length,t.from),this.timeline.events.push(...t.events),this.timeline.draw();case"history":return this.track.showHistory(t),this.timeline.life=this.track.life,this.timeline.draw();case"trails":return this.stage.panes[t.run].trails.addMany(t.points),this.refresh()}}takeFrame(t){this.store.add(t),this.stage.panes[t.run].trails.add(t),t.frame===this.player.frame&&this.refresh()}ready(t){const e=this.store.want(0,t);return this.settings.compare?this.store.want(1,t)&&e:e}prefetch(){const{frame:t,count:e,playing:n}=this.player;if(e!==0){for(const s of this.runs())if(this.store.want(s,t,!0)){for(let r=1;n&&r<=Dy&&t+r<e;++r)this.store.want(s,t+r);for(let r=1;r<this.settings.scansKept&&t-r>=0;++r)this.store.want(s,t-r)}}}runs(){return this.settings.compare?[0,1]:[0]}showCurrent(){this.label.refresh();const{frame:t}=this.player;for(const e of this.runs()){const n=this.stage.panes[e].trails;this.player.playing||n.knows(t-xl,t)||(n.mark(t-xl,t-1),this.connection.ask({op:"trails",run:e,frame:t,length:xl}))}this.refresh()}refresh(){for(const t of this.runs()){const e=this.kept(t);e.length>0&&this.stage.show(t,e),t===0&&e[0]&&(this.track.showFrame(e[0]),this.legend.draw(e[0]))}this.stage.redraw()}kept(t){const e=[];for(let n=0;n<this.settings.scansKept;++n){const s=this.store.get(t,this.player.frame-n);if(s)e.push(s);else if(n===0)return[]}return e}drawLabels(t){this.stage.panes[0].labels=t,this.refresh()}showInfo(){const t=[...this.stage.frameTimes].sort((n,s)=>n-s),e=t[Math.floor(t.length/2)]??0;this.status&&this.info.show(this.status,this.player.duration,this.store.bytesHeld,e)}}function Iy(){try{return window.localStorage}catch{return null}}window.scanfuse=new Uy(document.getElementById("app")??document.body);window.scanfuse.start();
