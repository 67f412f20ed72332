import { isWhole } from '@farol/tools/extent';
import type { PageImage } from '../pages/Bench';
import { expect, test } from './perfTest';

interface Seen {
  readonly step: string;
  /** Techniques in the order in which they drew. */
  readonly techniques: string[];
  /** Programs linked by the frame after the step, by the one that linked most, and by the first of the new technique. */
  readonly firstLinked: number;
  readonly mostLinked: number;
  readonly linkedAtChange: number;
  /** Frames in which JavaScript waited for a link. */
  readonly waited: number;
  /** Calls of onBeforeRender and onAfterRender in a frame of the technique before the change: one number. */
  readonly calls: number[];
  /** Differences of the picture after a change from the one before it (linear); first, of both from stock three's. */
  readonly differences: readonly { largest: number; psnr: number; share: number }[];
}

test("'auto' changes technique without a wait: programs are linked while the old one draws, and the picture stays", async ({
  page,
}) => {
  const cases = await page.evaluate(async (whole) => {
    const { Bench, compareImages, three } = window.testPage;
    const prototype = WebGL2RenderingContext.prototype;
    const { linkProgram, getProgramInfoLog, getProgramParameter, getExtension } = prototype;
    /** Frames until a program is said to be linked where the device does not tell, as the software rasteriser. */
    const LINKING = 3;
    const PARALLEL = 'KHR_parallel_shader_compile';
    const DONE = 0x91b1;
    const isTold = document.createElement('canvas').getContext('webgl2')!.getExtension(PARALLEL) !== null;
    /** The frame in which each program was linked. */
    const linkedIn = new WeakMap<WebGLProgram, number>();
    let frames = 0;
    if (!isTold) {
      prototype.getExtension = function (this: WebGL2RenderingContext, name: string) {
        if (name === PARALLEL) return { COMPLETION_STATUS_KHR: DONE };
        return getExtension.call(this, name as never) as unknown;
      } as typeof getExtension;
      prototype.getProgramParameter = function (program, name) {
        if (name === DONE) return frames >= linkedIn.get(program)! + LINKING;
        return getProgramParameter.call(this, program, name) as unknown;
      };
    }
    const counts = { linked: 0, waited: 0, called: 0 };
    prototype.linkProgram = function (program) {
      counts.linked++;
      linkedIn.set(program, frames);
      linkProgram.call(this, program);
    };
    // three asks this when it first draws with a program
    prototype.getProgramInfoLog = function (program) {
      if (this.getProgramParameter(program, DONE) === false) counts.waited++;
      return getProgramInfoLog.call(this, program);
    };
    async function run(canvas: boolean): Promise<Seen[]> {
      const bench = new Bench(32, 24, canvas ? { renderer: { antialias: true } } : {});
      const { webgl, farol } = bench;
      const scene = new three.Scene();
      scene.background = new three.Color(0x223344);
      scene.fog = new three.Fog(0x223344, 2, 30);
      const camera = new three.PerspectiveCamera(50, 32 / 24, 0.1, 30);
      camera.position.z = 6;
      const geometry = new three.SphereGeometry(0.7, 12, 8);
      const materials = [
        new three.MeshStandardMaterial({ color: 0xcc8844 }),
        new three.ShaderMaterial({ fragmentShader: 'void main() { gl_FragColor = vec4(0.2, 0.4, 0.6, 1.0); }' }),
        new three.MeshStandardMaterial({ transparent: true, opacity: 0.5, side: three.DoubleSide }),
        new three.MeshPhysicalMaterial({ transmission: 1, roughness: 0.2 }),
      ];
      const meshes = materials.map((material, i) => {
        const mesh = new three.Mesh(geometry, material);
        mesh.position.set(1.6 * (i % 2) - 0.8, 1.6 * Math.floor(i / 2) - 0.8, 0);
        mesh.onBeforeRender = mesh.onAfterRender = () => void counts.called++;
        return mesh;
      });
      const several = new three.InstancedMesh(geometry, materials[0], 2);
      several.setMatrixAt(0, new three.Matrix4().setPosition(-2, 2, -2));
      several.setMatrixAt(1, new three.Matrix4().setPosition(2, 2, -2));
      const floor = new three.Mesh(new three.PlaneGeometry(8, 8), materials[0]);
      floor.position.z = -3;
      scene.add(...meshes, several, floor);
      const add = (count: number, reach: number) => {
        for (let i = 0; i < count; i++) {
          const light = new three.PointLight(0xffffff, 4 / count + 0.02, reach);
          light.position.set(3 * Math.sin(i * 2.4), 2 * Math.cos(i * 1.7), 1.5);
          scene.add(light);
        }
      };
      const draw = () => {
        webgl.setRenderTarget(canvas ? null : bench.target);
        farol.render(scene, camera);
        webgl.setRenderTarget(null);
      };
      const frame = () => new Promise(requestAnimationFrame);
      const result: Seen[] = [];
      async function steps(step: string, wanted: string, change: () => void): Promise<void> {
        change();
        const settled = result.length > 0;
        const pictures: PageImage[] = [];
        // stock three unrolls its loop over the lights: its picture is of one light
        if (!canvas && !settled) pictures.push(bench.stock(scene, camera));
        const seen = { step, techniques: [] as string[], firstLinked: 0, mostLinked: 0 };
        const more = { linkedAtChange: 0, waited: 0, calls: [] as number[] };
        let isFirst = true;
        let isDone = false;
        while (!isDone) {
          Object.assign(counts, { linked: 0, waited: 0, called: 0 });
          frames++;
          draw();
          const { technique } = farol.info;
          if (isFirst) seen.firstLinked = counts.linked;
          if (settled) {
            seen.mostLinked = Math.max(seen.mostLinked, counts.linked);
            more.waited += counts.waited;
          }
          if (seen.techniques.at(-1) !== technique) {
            if (seen.techniques.length > 0) more.linkedAtChange += counts.linked;
            seen.techniques.push(technique);
          }
          if (seen.techniques.length === 1 && !more.calls.includes(counts.called)) more.calls.push(counts.called);
          if (isFirst && !canvas) pictures.push(bench.byTechnique('auto', scene, camera));
          if (isFirst && !settled) void farol.ready.then(() => (isDone = true));
          await frame();
          if (settled) isDone = technique === wanted;
          isFirst = false;
        }
        if (!canvas) pictures.push(bench.byTechnique('auto', scene, camera));
        const differences = pictures.slice(1).map((picture) => compareImages(pictures[0], picture));
        const error = webgl.getContext().getError();
        if (error !== 0) throw new Error(`WebGL error ${error}`);
        result.push({ ...seen, ...more, differences });
      }
      await steps('one light', 'forward-single-pass', () => add(1, 3));
      await steps('10 lights added', 'clustered-forward', () => add(10, 0.9));
      await steps('30 large lights added', 'clustered-deferred', () => add(30, 8));
      if (canvas) return result;
      await steps('900 small lights added', 'tiled-deferred', () => {
        for (const mesh of meshes.slice(2)) mesh.visible = false;
        add(900, 0.6);
      });
      return result;
    }
    return { float: await run(false), ...(whole && { 'multisampled canvas': await run(true) }) };
  }, isWhole);
  const order = ['forward-single-pass', 'clustered-forward', 'clustered-deferred', 'tiled-deferred'];
  for (const [name, steps] of Object.entries(cases)) {
    steps.forEach((seen, i) => {
      const what = `${name}, ${seen.step}`;
      expect.soft(seen.techniques, what).toEqual(i === 0 ? [order[0]] : order.slice(i - 1, i + 1));
      expect.soft(seen.calls, `${what}: calls of onBeforeRender and onAfterRender`).toHaveLength(1);
      for (const { largest, psnr, share } of seen.differences) {
        // the deferred ones round what they keep of a surface
        if (i < 2) expect.soft(largest, `${what}: picture`).toBeLessThanOrEqual(1e-4);
        expect.soft(psnr, `${what}: picture`).toBeGreaterThan(60);
        expect.soft(share, `${what}: pixels off`).toBeLessThanOrEqual(0.001);
      }
      if (i === 0) return;
      expect.soft(seen.firstLinked, `${what}: programs of the frame after`).toBe(0);
      expect.soft(seen.linkedAtChange, `${what}: programs of the frame that changes`).toBe(0);
      // lists of tiles are made by five small ones at once
      expect.soft(seen.mostLinked, `${what}: programs of one frame`).toBeLessThanOrEqual(i === 3 ? 5 : 1);
      expect.soft(seen.waited, `${what}: waits for a program`).toBe(0);
    });
  }
});

test("'auto' draws depth first once it has seen that layers hide one another, without a wait, and the picture stays @verify", async ({
  page,
}) => {
  const seen = await page.evaluate(async () => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { farol, webgl } = bench;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 64 / 48, 0.1, 30);
    const layer = new three.PlaneGeometry(20, 20);
    const material = new three.MeshStandardMaterial({ color: 0xcc8844 });
    // a small picture has to be covered very often for depth to pay
    for (let i = 0; i < 130; i++) {
      const mesh = new three.Mesh(layer, material);
      mesh.position.set(0, 0, i / 20 - 12);
      mesh.rotation.z = i;
      mesh.renderOrder = i;
      scene.add(mesh);
    }
    for (let i = 0; i < 12; i++) {
      const light = new three.PointLight(0xffffff, 1, 8);
      light.position.set(3 * Math.sin(i * 2.4), 2 * Math.cos(i * 1.7), -4.5);
      scene.add(light);
    }
    const stock = bench.stock(scene, camera);
    const before = bench.byTechnique('auto', scene, camera);
    const first = farol.info.technique as string;
    let compiled = 0;
    for (let last = first; last === first; last = farol.info.technique) {
      await new Promise(requestAnimationFrame);
      const programs = new Set(webgl.info.programs);
      bench.draw(() => farol.render(scene, camera));
      if (farol.info.technique !== first)
        compiled = webgl.info.programs!.filter((program) => !programs.has(program)).length;
    }
    const { technique, reason } = farol.info;
    const after = bench.byTechnique('auto', scene, camera);
    return { first, technique, reason, compiled, ...compareImages(stock, after), change: compareImages(before, after) };
  });
  expect([seen.first, seen.technique]).toEqual(['clustered-deferred', 'forward-plus']);
  expect(seen.reason).toContain('depth is drawn first');
  expect(seen.compiled, 'programs of the frame that changes').toBe(0);
  expect(seen.largest, "difference from stock three's picture").toBeLessThanOrEqual(1e-4);
  expect(seen.change.psnr).toBeGreaterThan(60);
});
