import type { TechniqueName } from '@farol/renderer';
import type * as Three from 'three';
import { isWhole } from '@farol/tools/extent';
import { expect, test } from '../support/benchTest';

/**
 * Passes that draw one surface in turns give it one depth: by one vertex shader, one viewport, and a pre-pass some
 * rounding steps behind. Not by invariant positions: stock three's are not, and on a GPU the picture then differs from its own
 * by up to 3.5e-4. The software rasteriser rounds alike whatever the programs: holes are found on a GPU (FAROL_GPU=1).
 */
const POSES = process.env.FAROL_GPU ? 200 : 3;

test('passes that draw one surface share its vertex shader, to the letter', async ({ benchPage: page }) => {
  const pairs = await page.evaluate((isWhole) => {
    const { Bench, materialScene } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera } = materialScene(64, 48, { count: 4 });
    const gl = bench.webgl.getContext() as WebGL2RenderingContext;
    const sourcesOf = (kind: string) =>
      (bench.webgl.info.programs as unknown as { cacheKey: string; program: WebGLProgram }[])
        .filter(({ cacheKey }) => cacheKey.includes(`farol:${kind}:`))
        .flatMap(({ program }) => gl.getAttachedShaders(program) ?? [])
        .filter((shader) => gl.getShaderParameter(shader, gl.SHADER_TYPE) === gl.VERTEX_SHADER)
        .map((shader) => gl.getShaderSource(shader)!);
    const compare = (technique: TechniqueName, first: string, second: string) => {
      bench.byTechnique(technique, scene, camera);
      const [firsts, seconds] = [sourcesOf(first), sourcesOf(second)];
      return {
        name: `${technique}: ${first}, ${second}`,
        programs: firsts.length,
        alone: seconds.filter((source) => !firsts.includes(source)).length,
      };
    };
    const plus = compare('forward-plus', 'depth', 'forward-lightLoopTiled-final');
    return isWhole ? [plus, compare('forward', 'base', 'additive')] : [plus];
  }, isWhole);
  for (const { name, programs, alone } of pairs) {
    expect(programs, name).toBeGreaterThan(5);
    expect(alone, `${name}: vertex shaders of the second that the first has not`).toBe(0);
  }
});

test('a depth pre-pass leaves no holes, in any pose, seen by several cameras', async ({ benchPage: page }) => {
  const holes = await page.evaluate((poses) => {
    const { Bench, three } = window.testPage;
    const width = 320;
    const height = 180;
    const bench = new Bench(width, height);
    let seed = 7;
    const random = () => {
      seed = (seed * 16807) % 2147483647;
      return seed / 2147483647;
    };
    const scene = new three.Scene();
    scene.background = new three.Color(1, 0, 1);
    const material = new three.MeshStandardMaterial({ color: 0x88aa88, roughness: 0.6 });
    const offset = material.clone();
    Object.assign(offset, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 40 });
    const things: Three.Mesh[] = [
      new three.Mesh(new three.SphereGeometry(1, 48, 32), material),
      new three.Mesh(new three.TorusKnotGeometry(0.7, 0.25, 96, 12), material),
      new three.Mesh(new three.BoxGeometry(1.4, 1.4, 1.4), offset),
      new three.InstancedMesh(new three.IcosahedronGeometry(0.4, 3), material, 5),
      new three.Mesh(new three.PlaneGeometry(30, 30), material),
    ];
    const place = new three.Matrix4();
    for (let i = 0; i < 5; i++) (things[3] as Three.InstancedMesh).setMatrixAt(i, place.setPosition(i - 2, i % 2, 0));
    scene.add(...things, new three.AmbientLight(0xffffff, 0.2));
    for (let i = 0; i < 4; i++) {
      const light = new three.PointLight(0xffffff, 40, 30);
      light.position.set(i * 3 - 5, 3, 4);
      scene.add(light);
    }
    const cameras = [0, 1, 2, 3].map((i) => {
      const one = new three.PerspectiveCamera(50, 16 / 9, 0.1, 100) as Three.PerspectiveCamera & {
        viewport: Three.Vector4;
      };
      // not all of whole halves: each begins elsewhere
      one.viewport = new three.Vector4((i % 2) * 161, i < 2 ? 91 : 0, 159 - (i % 2) * 2, 89);
      return one;
    });
    const array = new three.ArrayCamera(cameras);
    const found: { pose: number; pixels: number }[] = [];
    for (let pose = 0; pose < poses; pose++) {
      things.forEach((thing, i) => {
        thing.position.set((random() - 0.5) * 6, (random() - 0.5) * 3, i === 4 ? -6 : (random() - 0.5) * 4);
        if (i < 4) thing.rotation.set(random() * 6, random() * 6, random() * 6);
      });
      for (const camera of cameras) {
        camera.position.set((random() - 0.5) * 4, (random() - 0.5) * 2, 4 + random() * 4);
        camera.lookAt(0, 0, 0);
        camera.updateMatrixWorld();
      }
      const [by, without] = (['forward-plus', 'tiled-forward'] as const).map(
        (technique) => bench.byTechnique(technique, scene, array).data,
      );
      let pixels = 0;
      for (let i = 0; i < by.length; i += 4) {
        const off = Math.max(...[0, 1, 2].map((c) => Math.abs(by[i + c] - without[i + c])));
        if (!(off < 1e-3)) pixels++;
      }
      if (pixels > 0) found.push({ pose, pixels });
    }
    return found;
  }, POSES);
  expect(holes).toEqual([]);
});
