import type { Light, Object3D, Scene } from 'three';
import { expect, test } from './perfTest';

/** Counts that stand for the CPU's time in `render`: of a frame in which the lights move, unless said otherwise. */
interface CPUCounts {
  technique: string;
  draws: number;
  /** Calls of WebGL, of every kind. */
  calls: number;
  /** Programs linked since the scene is there. */
  programs: number;
  /** Objects of the scene of which anything is read. */
  visited: number;
  /** Properties read of an object that is no light, on average. */
  objectReads: number;
  /** Properties read of a light, on average. */
  lightReads: number;
  /** Bytes sent in a frame in which nothing moves, and in one in which all lights do. */
  stillBytes: number;
  movingBytes: number;
}

/** Most of each count that `auto` may take: a limit only falls. Whoever lowers a count lowers its limit. */
const limits: Record<string, CPUCounts> = {
  'planes 1 × 1, 1 light': {
    ...{ technique: 'forward-single-pass', draws: 1, calls: 4, programs: 1, visited: 2 },
    ...{ objectReads: 77, lightReads: 26, stillBytes: 0, movingBytes: 0 },
  },
  'planes 15 × 15, 1 light': {
    ...{ technique: 'forward-single-pass', draws: 217, calls: 438, programs: 1, visited: 226 },
    ...{ objectReads: 74.4, lightReads: 38, stillBytes: 0, movingBytes: 0 },
  },
  'atrium, 100 lights': {
    ...{ technique: 'tiled-deferred', draws: 105, calls: 281, programs: 7, visited: 202 },
    ...{ objectReads: 79.1, lightReads: 37.4, stillBytes: 0, movingBytes: 6416 },
  },
  'atrium, 1,000 lights': {
    ...{ technique: 'tiled-deferred', draws: 106, calls: 288, programs: 7, visited: 1102 },
    ...{ objectReads: 79.1, lightReads: 37, stillBytes: 0, movingBytes: 65_536 },
  },
  'model, 3 lights': {
    ...{ technique: 'forward-single-pass', draws: 12, calls: 52, programs: 1, visited: 22 },
    ...{ objectReads: 57.1, lightReads: 43.7, stillBytes: 0, movingBytes: 0 },
  },
};

test("a frame's calls, reads and uploads stay within what was reached", async ({ page }) => {
  const measured = await page.evaluate(async () => {
    const { farolCounters, testPage } = window;
    const { farol: package_, three } = testPage;
    const webgl = new three.WebGLRenderer({ antialias: false });
    webgl.setSize(64, 48, false);
    const prototype = WebGL2RenderingContext.prototype;
    const standard = (color: number, map: boolean) => {
      const texture = map ? new three.DataTexture(new Uint8Array(16).fill(200), 2, 2) : null;
      if (texture) texture.needsUpdate = true;
      return new three.MeshStandardMaterial({ color, map: texture, roughness: 0.6 });
    };
    const points = (count: number, range: number, [x, y, z]: readonly number[]): Light[] =>
      Array.from({ length: count }, (_, i) => {
        const light = new three.PointLight(0xffffff, 1, range);
        const share = (step: number) => ((i * step) % 1) - 0.5;
        light.position.set(x * share(0.618), y * share(0.755) + y / 2, z * share(0.57));
        return light;
      });
    const planes = (side: number) => {
      const scene = new three.Scene();
      const geometry = new three.PlaneGeometry(30 / side, 30 / side).rotateX(-Math.PI / 2);
      const material = standard(0xcccccc, false);
      for (let i = 0; i < side * side; i++) {
        const mesh = new three.Mesh(geometry, material);
        mesh.position.set(((i % side) + 0.5 - side / 2) * (30 / side), 0, (Math.floor(i / side) + 0.5 - side / 2) * 2);
        scene.add(mesh);
      }
      scene.add(...points(1, 5, [0, 2, 0]));
      return scene;
    };
    /** A hall of 100 meshes of eight materials, as the benchmark's atrium. */
    const atrium = (lights: number) => {
      const scene = new three.Scene();
      const materials = Array.from({ length: 8 }, (_, i) => standard(0x888888 + i, true));
      const box = new three.BoxGeometry(2, 6, 1);
      for (let i = 0; i < 100; i++) {
        const mesh = new three.Mesh(box, materials[i % 8]);
        mesh.position.set(4 * (i % 10) - 18, 3 * Math.floor(i / 50), 2 * (Math.floor(i / 10) % 5) - 4);
        scene.add(mesh);
      }
      scene.add(new three.DirectionalLight(0xffffff, 0.5), new three.AmbientLight(0xffffff, 0.1));
      scene.add(...points(lights, 5, [38, 10, 10]));
      return scene;
    };
    /** Nodes in nodes with meshes of textures, as a loader gives them, under three lights. */
    const model = () => {
      const scene = new three.Scene();
      const root = new three.Group();
      for (let i = 0; i < 6; i++) {
        const node = new three.Group();
        node.position.x = 2 * i - 5;
        for (let k = 0; k < 2; k++) {
          const mesh = new three.Mesh(new three.SphereGeometry(1, 8, 6), standard(0xffffff, true));
          mesh.position.y = 2 * k;
          node.add(mesh);
        }
        root.add(node);
      }
      scene.add(root, new three.DirectionalLight(), new three.HemisphereLight(), ...points(1, 8, [2, 2, 2]));
      return scene;
    };

    /** Reads of each object of the scene since it was emptied. */
    const reads = new Map<Object3D, number>();
    /** Puts stand-ins that count reads in place of all objects below one. */
    const watch = (object: Object3D): void => {
      object.children = object.children.map((child) => {
        watch(child);
        return new Proxy(child, {
          get(target, key) {
            reads.set(target, (reads.get(target) ?? 0) + 1);
            return Reflect.get(target, key, target) as unknown;
          },
          set: (target, key, value) => Reflect.set(target, key, value, target),
        });
      });
    };
    const isLight = (object: Object3D): object is Light => 'isLight' in object;
    const readsOf = (scene: Scene, which: (object: Object3D) => boolean): number => {
      const all: Object3D[] = [];
      const seen = new Map(reads);
      scene.traverse((object) => all.push(object));
      let sum = 0;
      for (const [object, count] of seen) if (which(object)) sum += count;
      return Math.round((10 * sum) / all.filter((object) => object !== scene && which(object)).length) / 10;
    };
    /** Calls of WebGL while `work` runs. */
    const callsOf = (work: () => void): number => {
      let calls = 0;
      const all = Object.entries(Object.getOwnPropertyDescriptors(prototype)).filter(
        ([name, { value }]) => typeof value === 'function' && name !== 'constructor',
      );
      for (const [name, { value }] of all) {
        Reflect.set(prototype, name, function (this: unknown, ...args: unknown[]) {
          calls++;
          return Reflect.apply(value as () => unknown, this, args);
        });
      }
      work();
      for (const [name, descriptor] of all) Object.defineProperty(prototype, name, descriptor);
      return calls;
    };

    const scenes: Record<string, () => Scene> = {
      'planes 1 × 1, 1 light': () => planes(1),
      'planes 15 × 15, 1 light': () => planes(15),
      'atrium, 100 lights': () => atrium(100),
      'atrium, 1,000 lights': () => atrium(1000),
      'model, 3 lights': model,
    };
    const found: Record<string, CPUCounts> = {};
    for (const [name, make] of Object.entries(scenes)) {
      const scene = make();
      const lights = scene.children.filter(isLight);
      const camera = new three.PerspectiveCamera(50, 64 / 48, 0.5, 100);
      camera.position.set(0, 12, 26);
      camera.lookAt(0, 2, 0);
      watch(scene);
      const programs = farolCounters.programs;
      const farol = new package_.FarolRenderer(webgl, { technique: 'auto' });
      const draw = () => farol.render(scene, camera);
      await farol.compileAsync(scene, camera);
      draw();
      await farol.ready;
      const move = () => {
        for (const light of lights) light.position.x += 0.001;
        draw();
      };
      // light data may take turns between textures, so that each change is sent again in the frames after it
      for (let i = 0; i < 4; i++) draw();
      const still = farolCounters.count(draw);
      for (let i = 0; i < 4; i++) move();
      const moving = farolCounters.count(move);
      const calls = callsOf(move);
      reads.clear();
      move();
      found[name] = {
        technique: farol.info.technique,
        ...{ draws: moving.draws, calls, programs: farolCounters.programs - programs },
        visited: reads.size,
        objectReads: readsOf(scene, (object) => !isLight(object)),
        lightReads: readsOf(scene, isLight),
        ...{ stillBytes: still.uploadBytes, movingBytes: moving.uploadBytes },
      };
      farol.dispose();
    }
    webgl.dispose();
    return found;
  });
  for (const [name, { technique, ...most }] of Object.entries(limits)) {
    const { technique: drawn, ...counts } = measured[name];
    expect.soft(drawn, name).toBe(technique);
    const more = Object.entries(counts).filter(([key, count]) => count > most[key as keyof typeof most]);
    expect.soft(more, `${name}: above the limit`).toEqual([]);
    expect.soft(Math.min(counts.draws, counts.calls, counts.visited), `${name}: is counted`).toBeGreaterThan(0);
  }
});
