import type { FarolRenderer, TechniqueName } from '@farol/renderer';
import type { Light, Scene } from 'three';

export interface AreaLightCostOptions {
  techniques: readonly TechniqueName[];
  /** Lights of each kind. */
  lights: number;
  /** Size of the picture (pixels). */
  width: number;
  height: number;
  /** Turns; in each, the kinds take turns. */
  rounds: number;
  /** Frames of a turn that are timed together. */
  frames: number;
  /** Takes the GPU's time of a turn's last frame in place of the mean time of its frames, where the device tells it. */
  gpuTimes?: boolean;
}

/** Times of one technique (ms a frame): medians of the GPU's; the least of the page's, to which other processes only add. */
export interface AreaLightCost {
  technique: TechniqueName;
  /** Without a light. */
  dark: number;
  points: number;
  rectangles: number;
  discs: number;
  tubes: number;
  /** Whether the times are the GPU's alone. */
  isGpuTime: boolean;
}

/**
 * Times a floor with boxes under many lights: point lights, and area lights of the same reach. To be run in the tests'
 * own page, in one piece.
 */
export async function areaLightCost(options: AreaLightCostOptions): Promise<AreaLightCost[]> {
  const { techniques, lights, width, height, rounds, frames, gpuTimes = false } = options;
  const { farol: package_, setLightOptions, three: THREE } = window.testPage;
  const kinds = ['dark', 'points', 'rectangles', 'discs', 'tubes'] as const;
  const reach = 1.5;
  const webgl = new THREE.WebGLRenderer({ antialias: false });
  webgl.setSize(width, height, false);
  const gl = webgl.getContext();
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 60);
  camera.position.set(0, 9, 13);
  camera.lookAt(0, 0, 1);
  const material = new THREE.MeshStandardMaterial({ roughness: 0.5, metalness: 0.2 });
  let seed = 7;
  const random = (): number => (seed = (seed * 16807) % 2147483647) / 2147483647;
  const places = Array.from(
    { length: lights },
    () => [20 * random() - 10, 0.2 + random(), 20 * random() - 10] as const,
  );
  const tilts = places.map(() => [random() - 0.5, random() - 0.5]);
  const boxes = Array.from({ length: 60 }, () => [20 * random() - 10, 20 * random() - 10, 0.3 + random()] as const);

  function made(kind: (typeof kinds)[number], i: number): Light {
    if (kind === 'points') return new THREE.PointLight(0xffffff, 0.3, reach);
    const light = new THREE.RectAreaLight(0xffffff, 1, 0.4, kind === 'tubes' ? 0.03 : 0.25);
    const shape = kind === 'discs' ? 'disc' : kind === 'tubes' ? 'tube' : 'rectangle';
    setLightOptions(light, { shape, range: reach });
    light.rotation.set(-Math.PI / 2 + tilts[i][0], tilts[i][1], 0);
    return light;
  }

  // each kind by a renderer of its own: shaders know what their own scenes need, and no more
  const worlds = kinds.map((kind): { kind: typeof kind; scene: Scene; farol: FarolRenderer } => {
    const scene = new THREE.Scene();
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(24, 24), material);
    floor.rotation.x = -Math.PI / 2;
    scene.add(floor);
    for (const [x, z, size] of boxes) {
      const box = new THREE.Mesh(new THREE.BoxGeometry(size, size, size), material);
      box.position.set(x, size / 2, z);
      scene.add(box);
    }
    for (let i = 0; i < (kind === 'dark' ? 0 : lights); i++) {
      const light = made(kind, i);
      light.position.set(...places[i]);
      scene.add(light);
    }
    return { kind, scene, farol: new package_.FarolRenderer(webgl, { timing: gpuTimes }) };
  });
  const pixel = new Uint8Array(4);
  const wait = (): void => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  const median = (values: number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1];
  const typical = gpuTimes ? median : (values: number[]): number => Math.min(...values);
  const results: AreaLightCost[] = [];
  for (const technique of techniques) {
    const times = Object.fromEntries(kinds.map((kind) => [kind, [] as number[]]));
    let isGpuTime = gpuTimes;
    // one turn more, which compiles
    for (let round = -1; round < rounds; round++) {
      for (const { kind, scene, farol } of worlds) {
        farol.technique = technique;
        wait();
        const start = performance.now();
        for (let frame = 0; frame < frames; frame++) farol.render(scene, camera);
        wait();
        let time = (performance.now() - start) / frames;
        if (gpuTimes) {
          // the device tells its times once the page has let go
          await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 20)));
          farol.updateTimes();
          isGpuTime &&= farol.info.gpuMs !== null || round < 0;
          time = farol.info.passes.reduce((sum, { gpuMs }) => sum + (gpuMs ?? 0), 0) || time;
        }
        if (round >= 0) times[kind].push(time);
      }
    }
    const [dark, points, rectangles, discs, tubes] = kinds.map((kind) => typical(times[kind]));
    results.push({ technique, dark, points, rectangles, discs, tubes, isGpuTime });
  }
  for (const { farol } of worlds) farol.dispose();
  webgl.dispose();
  webgl.forceContextLoss();
  return results;
}
