import { type Bake, bakeLightmaps, type BakeOptions } from '@farol/bake';
import type { Scene } from '@farol/engine';
import { writeBake } from '@farol/engine/bake';
import { scenes } from '@farol/scenes';
import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import * as THREE from 'three';
import { type BakeDifference, compareBakes } from './compareBakes';
import { coveredTexels } from './coveredTexels';

export interface BakeFigures {
  /** Seconds of each phase, in the order in which they begin; `all` from the call to the result, `encode` after it. */
  readonly seconds: Readonly<Record<string, number>>;
  readonly lightmaps: number;
  readonly texelsPerMetre: number;
  /** Share of the lightmaps' texels that charts cover. */
  readonly covered: number;
  /** Approximate number of rays of indirect light. */
  readonly rays: number;
  /** Size of the file. */
  readonly bytes: number;
  readonly warnings: readonly string[];
}

export interface FrameFigures {
  /** Medians over rounds of the time of a frame (ms). */
  readonly baked: number;
  readonly unlit: number;
  /** Median over rounds of `baked / unlit`, both of the same round. */
  readonly ratio: number;
  /** Median time of a frame (ms) in which the lights are drawn, for comparison. */
  readonly lit: number;
}

/** Angle that the sun covers (rad). */
const SUN = 0.0093;
const PREFIX = 'farol-bake ';

/** Bakes the atrium, compares the bake with a better one, and times frames that show it. */
export class BakeBench {
  private readonly webgl = new THREE.WebGLRenderer({ antialias: false, powerPreference: 'high-performance' });
  /** Bakes, oldest first; {@link frames} draws the last. */
  private readonly bakes: Bake[] = [];

  private constructor(private readonly scene: Scene) {
    this.scene.three.traverse((object) => {
      if ('isDirectionalLight' in object) object.userData.farol = { ...object.userData.farol, angle: SUN };
    });
  }

  /** @param lights - point lights that stand still, beside sun and sky */
  static async make(lights: number): Promise<BakeBench> {
    return new BakeBench(await scenes.sponza.build({ lights, still: true }));
  }

  /** The graphics device. */
  get device(): string {
    const gl = this.webgl.getContext();
    const extension = gl.getExtension('WEBGL_debug_renderer_info');
    return String(gl.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  }

  /** Bakes, and keeps the result. */
  async bake(options: BakeOptions): Promise<BakeFigures> {
    const warnings: string[] = [];
    performance.clearMeasures();
    const begin = performance.now();
    const bake = await bakeLightmaps(this.webgl, this.scene.three, {
      ...{ showProgress: false, ...options },
      // without the bulbs, since each would keep in the light inside it
      isStatic: (object) => !('isInstancedMesh' in object),
      onWarning: (sentence) => warnings.push(sentence),
      onProgress: ({ stage, share, samples, secondsLeft }) =>
        (this.progress = `${stage} ${Math.floor(100 * share)}%, ${samples} samples, ${secondsLeft?.toFixed(0) ?? '?'} s left`),
    });
    const seconds: Record<string, number> = {};
    for (const { name, duration } of performance.getEntriesByType('measure')) {
      if (!name.startsWith(PREFIX)) continue;
      const phase = name.slice(PREFIX.length);
      seconds[phase] = (seconds[phase] ?? 0) + duration / 1000;
    }
    let indirectSamples = 0;
    for (const { name, detail } of performance.getEntriesByType('measure') as PerformanceMeasure[]) {
      if (name === `${PREFIX}trace`) indirectSamples += (detail as { indirectSamples: number }).indirectSamples;
    }
    const known = Object.values(seconds).reduce((sum, each) => sum + each, 0);
    const all = (performance.now() - begin) / 1000;
    const encoding = performance.now();
    const file = await writeBake(dataOf(bake));
    const encode = (performance.now() - encoding) / 1000;
    this.bakes.push(bake);
    let [covered, texels] = [0, 0];
    bake.lightmaps.forEach((_, lightmap) => {
      const each = coveredTexels(bake, lightmap);
      covered += each.reduce((sum, value) => sum + value, 0);
      texels += each.length;
    });
    return {
      seconds: { ...seconds, other: all - known, all, encode },
      lightmaps: bake.lightmaps.length,
      texelsPerMetre: Math.sqrt(covered / areaOf(bake)),
      rays: (indirectSamples * covered) / texels,
      ...{ covered: covered / texels, bytes: file.length, warnings },
    };
  }

  /** How far the bake is, in a few words. */
  progress = '';

  /** Bakes once more, and compares each bake that was made before with that. */
  async compare(options: BakeOptions): Promise<BakeDifference[]> {
    await this.bake(options);
    const reference = this.bakes.pop()!;
    const differences = this.bakes.map((bake) => compareBakes(bake, reference));
    reference.dispose();
    return differences;
  }

  /**
   * Times frames of a technique with the bake, without any light, and with the lights drawn, in turns.
   *
   * @param rounds - turns of each
   * @param milliseconds - of each turn, at least
   */
  async frames(
    technique: TechniqueName | 'stock',
    size: { width: number; height: number },
    rounds: number,
    milliseconds: number,
  ): Promise<FrameFigures> {
    const { webgl } = this;
    const baked = this.bakes.at(-1);
    const { three, activeCamera } = this.scene;
    if (!baked || !activeCamera) throw new Error('There is no bake to draw: call bake() first.');
    webgl.setSize(size.width, size.height, false);
    const farol = new FarolRenderer(webgl, technique === 'stock' ? {} : { technique });
    const camera = activeCamera.three;
    const draw = (): void => (technique === 'stock' ? webgl.render(three, camera) : farol.render(three, camera));
    const lights: THREE.Object3D[] = [];
    three.traverse((object) => void ('isLight' in object && lights.push(object)));
    const setVisible = (isVisible: boolean): void => lights.forEach((light) => (light.visible = isVisible));
    const turns = {
      baked: () => baked.apply(),
      unlit: () => (baked.remove(), setVisible(false)),
      lit: () => (baked.remove(), setVisible(true)),
    };
    const times: Record<keyof typeof turns, number[]> = { baked: [], unlit: [], lit: [] };
    for (let round = -1; round < rounds; round++) {
      for (const name of ['baked', 'unlit', 'lit'] as const) {
        turns[name]();
        // programs are compiled and textures uploaded in frames that are not timed
        for (let i = 0; i < 2; i++) draw();
        this.finish();
        const begin = performance.now();
        let frames = 0;
        for (; performance.now() - begin < milliseconds; frames += 4) {
          for (let i = 0; i < 4; i++) draw();
          this.finish();
        }
        if (round >= 0) times[name].push((performance.now() - begin) / frames);
        setVisible(true);
        await new Promise((resolve) => setTimeout(resolve));
      }
    }
    farol.dispose();
    const ratio = median(times.baked.map((time, round) => time / times.unlit[round]));
    return { baked: median(times.baked), unlit: median(times.unlit), ratio, lit: median(times.lit) };
  }

  /** Waits for the GPU. */
  private finish(): void {
    const gl = this.webgl.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

const median = (values: readonly number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1];

/** Data that the editor would write to a file. */
function dataOf({ lightmaps, meshes, channel }: Bake): Parameters<typeof writeBake>[0] {
  return {
    ...{ signature: '', lights: [], hasSky: false, channel, probes: null },
    lightmaps: lightmaps.map(({ width, height, data }) => ({ width, height, data: new Uint16Array(data) })),
    meshes: meshes.map(({ mesh, lightmap, uv1, index, sourceVertex }) => ({
      ...{ component: mesh.uuid, part: 0, lightmap },
      sourceVertices: mesh.geometry.getAttribute('position').count,
      uv1: new Float32Array(uv1),
      index: new Uint32Array(index),
      sourceVertex: new Uint32Array(sourceVertex),
    })),
  };
}

/** Area of the meshes in the world (m²). */
function areaOf({ meshes }: Bake): number {
  const [a, b, c] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  const triangle = new THREE.Triangle(a, b, c);
  let area = 0;
  for (const { mesh, index, sourceVertex } of meshes) {
    const position = mesh.geometry.getAttribute('position');
    for (let i = 0; i < index.length; i += 3) {
      [a, b, c].forEach((corner, k) =>
        corner.fromBufferAttribute(position, sourceVertex[index[i + k]]).applyMatrix4(mesh.matrixWorld),
      );
      area += triangle.getArea();
    }
  }
  return area;
}
