import type * as THREE from 'three';
import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

/**
 * Sampling of the image that a spot light throws, by names of three's constants. Checks of one texel, some pixels and less a
 * side, show all that a sampler does, and also how far positions that a G-buffer rebuilds are from three's: the software
 * rasteriser moves vertices to sixteenths of a pixel, GPUs to 256ths.
 */
interface Sampling {
  readonly name: string;
  readonly min: 'Nearest' | 'Linear' | 'NearestMipmapNearest' | 'LinearMipmapNearest' | 'LinearMipmapLinear';
  readonly mag?: 'Nearest' | 'Linear';
  readonly wrap?: 'Repeat' | 'MirroredRepeat';
  readonly anisotropy?: number;
  /** Texels a side. */
  readonly side?: number;
  /** Beside stock three, by forward techniques and by those with a G-buffer (dB). */
  readonly measured: readonly [number, number];
  /** The same on a GPU, where it is less: GPUs choose levels and weigh texels by rules of their own (H100). */
  readonly onGPU?: readonly [number, number];
}

const samplings: readonly Sampling[] = [
  { name: 'mipmaps', min: 'LinearMipmapLinear', measured: [56, 44], onGPU: [51, 44] },
  {
    name: 'mipmaps of an image with odd sides',
    min: 'LinearMipmapLinear',
    side: 75,
    measured: [51, 43],
    onGPU: [48, 43],
  },
  { name: 'mipmaps, anisotropy', min: 'LinearMipmapLinear', anisotropy: 8, measured: [54, 44], onGPU: [35, 35] },
  { name: 'the nearest mipmap', min: 'LinearMipmapNearest', measured: [54, 44], onGPU: [41, 41] },
  {
    name: 'the nearest texel of the nearest mipmap, repeated',
    min: 'NearestMipmapNearest',
    mag: 'Nearest',
    wrap: 'Repeat',
    measured: [40, 22],
    onGPU: [29, 22],
  },
  { name: 'the nearest texel', min: 'Nearest', mag: 'Nearest', measured: [42, 21] },
  {
    name: 'linear, without mipmaps, repeated',
    min: 'Linear',
    wrap: 'Repeat',
    side: 8,
    measured: [90, 59],
    onGPU: [54, 54],
  },
  { name: 'mirrored', min: 'LinearMipmapLinear', wrap: 'MirroredRepeat', side: 8, measured: [66, 58], onGPU: [53, 53] },
];

for (const [turn, { name, measured, onGPU = measured, ...sampling }] of samplings.entries()) {
  const least = process.env.FAROL_GPU ? onGPU : measured;
  test(`a spot light's map is sampled as in stock three: ${name}${turn % 3 > 0 ? ' @verify' : ''}`, async ({
    benchPage: page,
  }) => {
    const { pairs, matters } = await page.evaluate(
      ({ turn, min, mag = 'Linear', wrap, anisotropy = 1, side = 64 }) => {
        const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
        const [width, height] = [96, 72];
        const bench = new Bench(width, height);
        bench.farol.inferredScale = 1;
        const checks = new Uint8Array(side * side * 4).fill(255);
        for (let i = 0; i < side * side; i++)
          if (((i % side) + Math.floor(i / side)) % 2) checks.set([40, 90, 20], i * 4);
        const map = new three.DataTexture(checks, side, side);
        map.colorSpace = three.SRGBColorSpace;
        map.generateMipmaps = min.includes('Mipmap');
        map.minFilter = three[`${min}Filter`];
        map.magFilter = three[`${mag}Filter`];
        if (wrap) map.wrapS = map.wrapT = three[`${wrap}Wrapping`];
        map.anisotropy = anisotropy;
        map.needsUpdate = true;
        const scene = new three.Scene();
        const floor = new three.Mesh(new three.PlaneGeometry(30, 30), new three.MeshLambertMaterial());
        floor.rotation.x = -Math.PI / 2;
        const wall = new three.Mesh(new three.PlaneGeometry(6, 3), new three.MeshStandardMaterial());
        wall.position.set(-1, 1.5, -4);
        wall.rotation.y = 0.6;
        const ball = new three.Mesh(new three.SphereGeometry(0.7, 48, 32), new three.MeshPhongMaterial());
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
      { turn, ...sampling },
    );
    expect(matters, 'the image is to be seen').toBeLessThan(32);
    for (const { technique, psnr } of pairs) {
      const isForward = technique.includes('forward');
      expectAsMeasured(psnr, least[isForward ? 0 : 1], `${name}, ${technique}`);
    }
  });
}
