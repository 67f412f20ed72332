import type * as THREE from 'three';
import type { CheckedSampling } from '../pages/checkedMap';
import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

/**
 * Sampling of the image that a spot light throws. Checks of one texel, some pixels and less a side, also show how far
 * positions that a G-buffer rebuilds are from three's: the software rasteriser moves vertices to sixteenths of a pixel, GPUs
 * to 256ths. It also takes the gradients of the first of four pixels for all of them, which it has not at the edges of the
 * triangles of light volumes.
 */
interface Sampling extends CheckedSampling {
  readonly name: string;
  /** Other lights throw textures of their own before, so that no sampler is left and the image is copied. */
  readonly isCopied?: boolean;
  /** Whether the slice has it: one copied image; `filters` has the strictest limits, cubeCookies.spec.ts the nearest mipmap. */
  readonly inSlice?: boolean;
  /** Beside stock three, by forward techniques, by lists over a G-buffer, by light volumes (dB). */
  readonly measured: readonly [number, number, number];
  /** Limits on a GPU (H100), which chooses levels and weighs texels by rules of its own. */
  readonly onGPU?: readonly [number, number, number];
}

const samplings: readonly Sampling[] = [
  { name: 'mipmaps', min: 'LinearMipmapLinear', measured: [60, 44, 44] },
  { name: 'mipmaps of an image with odd sides', min: 'LinearMipmapLinear', side: 75, measured: [58, 44, 44] },
  { name: 'mipmaps, anisotropy', min: 'LinearMipmapLinear', anisotropy: 8, measured: [61, 44, 44] },
  {
    name: 'mipmaps, copied',
    min: 'LinearMipmapLinear',
    isCopied: true,
    inSlice: true,
    measured: [56, 44, 44],
    onGPU: [51, 44, 44],
  },
  { name: 'the nearest mipmap', min: 'LinearMipmapNearest', measured: [56, 44, 44] },
  {
    name: 'the nearest texel of the nearest mipmap, repeated',
    min: 'NearestMipmapNearest',
    mag: 'Nearest',
    wrap: 'Repeat',
    measured: [41, 22, 22],
  },
  { name: 'the nearest texel', min: 'Nearest', mag: 'Nearest', measured: [42, 21, 21] },
  {
    name: 'linear, without mipmaps, repeated',
    min: 'Linear',
    wrap: 'Repeat',
    side: 8,
    measured: [131, 59, 59],
  },
  { name: 'mirrored', min: 'LinearMipmapLinear', wrap: 'MirroredRepeat', side: 8, measured: [108, 59, 59] },
  {
    name: 'mipmaps, anisotropy, copied',
    min: 'LinearMipmapLinear',
    anisotropy: 8,
    isCopied: true,
    measured: [54, 44, 44],
    onGPU: [35, 35, 35],
  },
  {
    name: 'the nearest texel of the nearest mipmap, repeated, copied',
    min: 'NearestMipmapNearest',
    mag: 'Nearest',
    wrap: 'Repeat',
    isCopied: true,
    measured: [40, 22, 22],
    onGPU: [29, 22, 22],
  },
  {
    name: 'mirrored, copied',
    min: 'LinearMipmapLinear',
    wrap: 'MirroredRepeat',
    side: 8,
    isCopied: true,
    measured: [66, 58, 58],
    onGPU: [53, 53, 53],
  },
];

for (const [
  turn,
  { name, measured, onGPU = measured, isCopied = false, inSlice, ...sampling },
] of samplings.entries()) {
  const least = process.env.FAROL_GPU ? onGPU : measured;
  test(`a spot light's map is sampled as in stock three: ${name}${inSlice ? '' : ' @verify'}`, async ({
    benchPage: page,
  }) => {
    const { pairs, matters } = await page.evaluate(
      ({ turn, isCopied, sampling }) => {
        const { Bench, checkedMap, compareImages, isSlice, techniquesInTurn, three } = window.testPage;
        const [width, height] = [96, 72];
        const bench = new Bench(width, height);
        bench.farol.inferredScale = 1;
        const map = checkedMap(sampling);
        const scene = new three.Scene();
        if (isCopied) {
          for (let i = 0; i < 4; i++) {
            const dim = new three.SpotLight(0xffffff, 1e-4);
            dim.position.set(i, 4, 0);
            dim.map = checkedMap({ min: 'Linear', side: 2 });
            scene.add(dim, dim.target);
          }
        }
        const floor = new three.Mesh(new three.PlaneGeometry(30, 30), new three.MeshLambertMaterial());
        floor.rotation.x = -Math.PI / 2;
        // in the slice one kind: fewer programs
        const material = isSlice ? floor.material : null;
        const wall = new three.Mesh(new three.PlaneGeometry(6, 3), material ?? new three.MeshStandardMaterial());
        wall.position.set(-1, 1.5, -4);
        wall.rotation.y = 0.6;
        const ball = new three.Mesh(new three.SphereGeometry(0.7, 48, 32), material ?? new three.MeshPhongMaterial());
        ball.position.set(1.2, 0.7, -1);
        const spots = [0, 1].map((i) => {
          const spot = new three.SpotLight(i ? 0xffddaa : 0xaaccff, 150, i * 20, 0.7, 0.3);
          spot.position.set(i ? 3 : -3, 5, 1);
          spot.target.position.set(0, 0, -2);
          spot.map = map;
          spot.castShadow = i === 1;
          scene.add(spot, spot.target);
          return spot as THREE.SpotLight;
        });
        scene.add(floor, wall, ball);
        const camera = new three.PerspectiveCamera(50, width / height, 1, 30);
        camera.position.set(0, 1.6, 4);
        camera.lookAt(0, 0.6, 0);
        const stock = bench.stock(scene, camera);
        const pairs = techniquesInTurn(turn).map((technique) => ({
          technique,
          ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
        }));
        for (const spot of spots) spot.map = null;
        return { pairs, matters: compareImages(stock, bench.stock(scene, camera)).psnr };
      },
      { turn, isCopied, sampling },
    );
    expect(matters, 'the image is to be seen').toBeLessThan(32);
    for (const { technique, psnr } of pairs) {
      const family = technique.includes('forward') ? 0 : /tiled|clustered/.test(technique) ? 1 : 2;
      expectAsMeasured(psnr, least[family], `${name}, ${technique}`);
    }
  });
}

/**
 * Surfaces whose corners lie on corners of pixels, so that positions that a G-buffer rebuilds are three's: what is left is
 * how the image is filtered, at the edges of surfaces too (dB, by any technique).
 */
const filters: readonly (CheckedSampling & {
  name: string;
  measured: number;
  isBent?: boolean;
  isOrthographic?: boolean;
})[] = [
  { name: 'mipmaps', min: 'LinearMipmapLinear', measured: 79 },
  // gradients go by the triangle, not by the normals of its corners
  { name: 'mipmaps, on surfaces with bent normals', min: 'LinearMipmapLinear', measured: 80, isBent: true },
  { name: 'mipmaps, orthographic', min: 'LinearMipmapLinear', measured: 80, isOrthographic: true },
  { name: 'mipmaps, anisotropy', min: 'LinearMipmapLinear', anisotropy: 8, measured: process.env.FAROL_GPU ? 67 : 79 },
  // 69 by lists on an H100
  { name: 'the nearest mipmap', min: 'LinearMipmapNearest', measured: process.env.FAROL_GPU ? 69 : 79 },
];

for (const [turn, { name, measured, isBent = false, isOrthographic = false, ...sampling }] of filters.entries()) {
  test(`a spot light's map is filtered as in stock three where positions are exact: ${name}${turn > 0 ? ' @verify' : ''}`, async ({
    benchPage: page,
  }) => {
    const pairs = await page.evaluate(
      ({ turn, isBent, isOrthographic, sampling }) => {
        const { Bench, checkedMap, compareImages, techniquesInTurn, three } = window.testPage;
        const [width, height] = [96, 72];
        const bench = new Bench(width, height);
        bench.farol.inferredScale = 1;
        const map = checkedMap(sampling);
        const scene = new three.Scene();
        const camera = isOrthographic
          ? new three.OrthographicCamera((-4 * width) / height, (4 * width) / height, 4, -4, 1, 30)
          : new three.PerspectiveCamera(50, width / height, 1, 30);
        const tangent = Math.tan((25 * Math.PI) / 180);
        /** Adds a quad over the pixels between two corners; 1 / depth (1/m) at the first, to the right of it, above it. */
        const addQuad = (x0: number, y0: number, x1: number, y1: number, first: number, right: number, up: number) => {
          const corners = [
            [x0, y0, first],
            [x1, y0, right],
            [x1, y1, right + up - first],
            [x0, y1, up],
          ].map(([x, y, inverse]) => {
            const across = ((x / width) * 2 - 1) * (width / height);
            const above = (y / height) * 2 - 1;
            const reach = isOrthographic ? 4 : tangent / inverse;
            return [across * reach, above * reach, -1 / inverse];
          });
          const geometry = new three.BufferGeometry();
          geometry.setAttribute('position', new three.Float32BufferAttribute(corners.flat(), 3));
          geometry.setIndex([0, 1, 2, 0, 2, 3]);
          geometry.computeVertexNormals();
          if (isBent) {
            const normal = geometry.getAttribute('normal');
            const bend = new three.Vector3();
            for (let i = 0; i < 4; i++) {
              bend.fromBufferAttribute(normal, i).add(new three.Vector3(i % 2 ? 0.8 : -0.4, i < 2 ? 0.5 : -0.3, 0));
              normal.setXYZ(i, ...bend.normalize().toArray());
            }
          }
          scene.add(new three.Mesh(geometry, new three.MeshLambertMaterial()));
        };
        addQuad(0, 0, 96, 40, 1 / 3, 1 / 3, 1 / 12);
        addQuad(0, 40, 51, 72, 1 / 12, 1 / 6, 1 / 12);
        addQuad(51, 40, 96, 72, 1 / 6, 1 / 10, 1 / 7);
        addQuad(21, 9, 46, 30, 1 / 3, 1 / 4, 1 / 3.5);
        for (const i of [0, 1]) {
          const spot = new three.SpotLight(i ? 0xffddaa : 0xaaccff, 300, i * 30, 0.7, 0.3);
          spot.position.set(i ? 3 : -3, 4, 1);
          spot.target.position.set(0, -1, -7);
          spot.map = map;
          spot.castShadow = i === 1;
          scene.add(spot, spot.target);
        }
        const stock = bench.stock(scene, camera);
        return techniquesInTurn(turn).map((technique) => ({
          technique,
          ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
        }));
      },
      { turn, isBent, isOrthographic, sampling },
    );
    for (const { technique, psnr } of pairs) expectAsMeasured(psnr, measured, `${name}, ${technique}`);
  });
}
