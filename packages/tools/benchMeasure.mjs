/**
 * @typedef {import('./benchCounters.mjs').Counters} Counters
 *
 * @typedef {object} MeasureOptions
 * @property {number} frames timed frames of each kind, at most
 * @property {number} budget for each kind (ms)
 * @property {boolean} onlyCounts
 *
 * @typedef {{ ms: number | null, programs: number, lights: number }} LightChange the frame after lights came or went: its
 *   time, programs compiled in it, and how many lights those were
 *
 * @typedef {object} Measurement of one case in one round; times are lists of ms, null where they cannot be taken
 * @property {string} renderer the graphics device
 * @property {string} technique that drew
 * @property {string} reason why it was picked, where one is
 * @property {number} lights
 * @property {number} visible
 * @property {number | null} firstMs
 * @property {number[] | null} gpu timer query round one frame
 * @property {number[] | null} cpu in `render`
 * @property {number[] | null} frame lights moved, drawn, waited for
 * @property {number[] | null} batch the same for each of `batchSize` frames with one wait
 * @property {number} batchSize
 * @property {number} draws
 * @property {number} triangles
 * @property {number} programs
 * @property {number} uploadBytes
 * @property {number} stillUploadBytes
 * @property {number} targetBytes
 * @property {LightChange | null} added
 * @property {LightChange | null} removed
 *
 * @typedef {object} ThreeNode as much of three's objects as is used here
 * @property {boolean} [isPointLight]
 * @property {{ elements: number[] }} matrixWorld
 * @property {{ set(x: number, y: number, z: number): void }} position
 * @property {() => ThreeNode} clone
 * @property {() => void} removeFromParent
 *
 * @typedef {object} BenchViewer `window.viewer` as far as it is used here; see apps/viewer/src/main.ts
 * @property {Promise<void>} ready
 * @property {{ techniques: readonly string[], scenes: Record<string, { parameters: object }> }} known
 * @property {{ render(scene: unknown, camera: unknown): void, info: { technique: string, reason: string,
 *   lights: { total: number, visible: number }, targetBytes: number } }} farol
 * @property {{ getContext(): WebGL2RenderingContext, domElement: HTMLCanvasElement }} three
 * @property {{ traverse(visit: (node: ThreeNode) => void): void, add(node: ThreeNode): void }} scene
 * @property {unknown} camera
 * @property {{ setTime(seconds: number): void }} engineScene
 *
 * @typedef {{ viewer: BenchViewer, farolCounters: Counters, farolBench: { firstMs: number | null,
 *   finish(gl: WebGL2RenderingContext): void } }} BenchWindow
 */

/**
 * Times the first frame of the viewer: to be run in its page before its own scripts. It waits for `window.viewer`, and
 * leaves `window.farolBench` with that time and the wait for the device that the other times are taken with.
 */
export function installFirstFrame() {
  const pixel = new Uint8Array(4);
  const bench = {
    firstMs: /** @type {number | null} */ (null),
    /** gl.finish() does not wait in Chrome; reading a pixel of the canvas does. @param {WebGL2RenderingContext} gl */
    finish(gl) {
      const framebuffer = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
      const pack = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
      if (framebuffer) gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
      if (pack) gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      if (framebuffer) gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
      if (pack) gl.bindBuffer(gl.PIXEL_PACK_BUFFER, pack);
    },
  };
  /** @type {BenchViewer | undefined} */
  let viewer;
  Object.defineProperty(window, 'viewer', {
    configurable: true,
    get: () => viewer,
    set(/** @type {BenchViewer} */ value) {
      viewer = value;
      const { farol, three } = value;
      const { render } = farol;
      farol.render = (scene, camera) => {
        farol.render = render;
        const begin = performance.now();
        farol.render(scene, camera);
        bench.finish(three.getContext());
        bench.firstMs = performance.now() - begin;
      };
    },
  });
  Object.assign(window, { farolBench: bench });
}

/**
 * Measures the viewer that is open; run in its page. Counters and first frame must have been installed. The lights move by
 * a sixtieth of a second from frame to frame. The canvas is hidden, so that nothing is presented and no display is waited
 * for. The scene is not as it was afterwards: lights were added and removed.
 *
 * @param {MeasureOptions} options
 * @returns {Promise<Measurement>}
 * @throws {Error} when the viewer shows a message, the context is lost or WebGL has an error
 */
export async function measureViewer({ frames, budget, onlyCounts }) {
  const BATCH = 20;
  const ADDED = 10;
  const REMOVED = 1000;
  const { viewer, farolCounters, farolBench } = /** @type {BenchWindow} */ (/** @type {unknown} */ (window));
  const { farol, three, scene, camera, engineScene } = viewer;
  const gl = three.getContext();
  const message = document.querySelector('.message span')?.textContent;
  if (message) throw new Error(`the viewer says: ${message}`);
  three.domElement.style.display = 'none';

  const now = () => performance.now();
  const macrotask = () => new Promise((resolve) => setTimeout(resolve));
  let drawn = 0;
  const move = () => engineScene.setTime(++drawn / 60);
  const render = () => farol.render(scene, camera);
  const wholeFrame = () => {
    move();
    render();
  };
  /** Calls `step` until the frames or the time are used up, but 3 times at least. @param {() => unknown} step @param {number} most */
  const repeat = async (step, most) => {
    const begin = now();
    for (let i = 0, rest = begin; i < most && (i < 3 || now() - begin < budget); i++) {
      await step();
      if (gl.isContextLost()) throw new Error('the WebGL context was lost');
      if (now() - rest > 300) {
        await macrotask(); // let the page breathe
        rest = now();
      }
    }
  };
  const timed = (/** @type {() => void} */ work) => {
    const begin = now();
    work();
    farolBench.finish(gl);
    return now() - begin;
  };
  const waited = () => timed(wholeFrame);

  await repeat(waited, onlyCounts ? 3 : 10); // caches filled, code compiled

  /** @type {number[]} */
  const cpu = [];
  /** @type {number[]} */
  const frame = [];
  /** @type {number[]} */
  const batch = [];
  /** @type {number[]} */
  const gpu = [];
  let batchSize = 1;
  if (!onlyCounts) {
    await repeat(() => {
      const begin = now();
      move();
      const moved = now();
      render();
      cpu.push(now() - moved);
      farolBench.finish(gl);
      frame.push(now() - begin);
    }, frames);

    const ordinary = [...frame].sort((a, b) => a - b)[frame.length >> 1];
    batchSize = Math.max(1, Math.min(BATCH, Math.floor(budget / 3 / ordinary)));
    const many = () => {
      for (let i = 0; i < batchSize; i++) wholeFrame();
    };
    await repeat(() => batch.push(timed(many) / batchSize), Math.max(3, Math.ceil(frames / batchSize)));

    /** @type {{ TIME_ELAPSED_EXT: number, GPU_DISJOINT_EXT: number } | null} */
    const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2');
    if (timer) {
      await repeat(async () => {
        const query = gl.createQuery();
        gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
        wholeFrame();
        gl.endQuery(timer.TIME_ELAPSED_EXT);
        gl.flush();
        const there = () => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE);
        for (const limit = now() + 5000; !there() && now() < limit;) await macrotask();
        if (there() && !gl.getParameter(timer.GPU_DISJOINT_EXT)) {
          gpu.push(gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6);
        }
        gl.deleteQuery(query);
      }, frames);
    }
  }

  const programs = farolCounters.programs;
  const { draws, triangles, uploadBytes } = farolCounters.count(wholeFrame);
  const still = farolCounters.count(render);
  const { technique, reason, lights, targetBytes } = farol.info;
  const { total, visible } = lights;

  /** @type {ThreeNode[]} */
  const points = [];
  scene.traverse((node) => node.isPointLight && points.push(node));
  /** @param {() => void} change @param {number} count @returns {LightChange} */
  const afterChange = (change, count) => {
    const before = farolCounters.programs;
    farolBench.finish(gl);
    const ms = timed(() => {
      change();
      wholeFrame();
    });
    return { ms: onlyCounts ? null : ms, programs: farolCounters.programs - before, lights: count };
  };
  let added = null;
  let removed = null;
  if (points.length > 0) {
    // beside lights that are there, so that they are as likely to be seen
    const more = Array.from({ length: ADDED }, (_, i) => {
      const source = points[Math.floor((i * points.length) / ADDED)];
      const [x, y, z] = source.matrixWorld.elements.slice(12, 15);
      const light = source.clone();
      light.position.set(x + 0.3, y, z + 0.3);
      return light;
    });
    added = afterChange(() => more.forEach((light) => scene.add(light)), ADDED);
    await repeat(waited, 3);
    const fewer = [...more, ...points].slice(0, Math.max(0, Math.min(REMOVED, points.length)));
    removed = afterChange(() => fewer.forEach((light) => light.removeFromParent()), fewer.length);
  }

  const error = gl.getError();
  if (gl.isContextLost()) throw new Error('the WebGL context was lost');
  if (error !== 0) throw new Error(`WebGL error 0x${error.toString(16)}`);
  const debug = gl.getExtension('WEBGL_debug_renderer_info');
  return {
    ...{ renderer: String(gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER)), technique, reason },
    ...{ lights: total, visible, firstMs: onlyCounts ? null : farolBench.firstMs },
    gpu: gpu.length > 0 ? gpu : null,
    cpu: onlyCounts ? null : cpu,
    frame: onlyCounts ? null : frame,
    batch: onlyCounts ? null : batch,
    ...{ batchSize, draws, triangles: Math.round(triangles), programs },
    ...{ uploadBytes, stillUploadBytes: still.uploadBytes, targetBytes, added, removed },
  };
}
